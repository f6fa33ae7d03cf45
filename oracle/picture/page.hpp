// A page that shows verdicts: one HTML file that opens in any browser, without a network.
#pragma once

#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "oracle/judge/points/cells.hpp"
#include "oracle/model/domain.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/verdict.hpp"
#include "oracle/report/json.hpp"

namespace circumspect::picture {

// As many violations have a card, with their pictures: pages stay small enough to be sent.
inline constexpr std::size_t kMostCards = 100;

// What a command finds that is not a verdict.
struct Facts {
  std::string heading;  // what they are about: the name of a file
  std::string line;     // the last line that the command prints of it
  std::string text;     // what it prints above, a fact a line: "points: 5 points of dimension 2"
  bool holds = true;    // false: it is at fault
  std::string noun = "Fact";  // what a card shows
  // Of each card what is shown, by the vertices of a mesh, and how: `meaning`, `caption`, and if
  // need be `rule`, `around`, `ball_words` and `groups` of the simplices, each with its `role`,
  // `words` and `count`, and `closed` if they are the edges of a polygon in their order.
  std::vector<std::pair<report::Json, Witness>> cards = {};
  std::size_t cards_of = 0;  // how many there would be
  report::Json steps = {};   // of a construction: see steps.hpp
  // Of a mesh: each a `measure`, its `bounds` as texts, and `counts`, one more than those.
  report::Json histograms = {};
};

class Page {
 public:
  // Adds a verdict below those that are there; the mesh and the domain are not needed afterwards.
  // `report`: what report::verdict says of it, with whatever a command adds. Cards beyond
  // kMostCards of the page are left out, which the page says.
  void add(const Verdict& verdict, const Mesh& mesh, const std::string& mesh_name,
           report::Json report, const Domain* domain = nullptr,
           const std::vector<std::string>& notes = {});

  // What a campaign found, in a table above all else: what campaign_json (command/campaign) says of
  // it.
  void begin_with_campaign(report::Json campaign, const std::string& line);
  // A finding: `finding` has its signature, count and text, the small input as `minimal`, and
  // `reproduce`, a script. `verdict` was found on the mesh of that input; null where no rule is
  // broken.
  void add_finding(report::Json finding, const Verdict* verdict = nullptr,
                   const Mesh* mesh = nullptr, const std::string& mesh_name = {},
                   const Domain* domain = nullptr);

  // What only one of two meshes has, a card for each place at which they differ.
  // `report`: `a` and `b`, their names, and the notes of the command; `line`: what it says of them.
  // Requires: `found` is their difference.
  void add_difference(const Mesh& a, const Mesh& b, const check::Difference& found,
                      const report::Json& report, const std::string& line);

  // Facts, with a card for each of those that can be seen. `mesh` is what may be drawn around them.
  void add_facts(Facts facts, const Mesh& mesh);

  bool is_empty() const { return results_.empty(); }

  // Texts are escaped, so that no name of a file, whatever it holds, is read as markup.
  void write(std::ostream& out) const;

 private:
  report::Json results_ = report::Json::array();
  report::Json campaign_ = {};
  std::string text_;  // for browsers without JavaScript
  std::string title_;
  std::size_t cards_ = 0;
};

// The page without its data, with {{title}}, {{text}} and {{data}} where these belong, in this
// order: page/page.built.html, which the build puts into the library.

std::string_view page_source();

}  // namespace circumspect::picture
