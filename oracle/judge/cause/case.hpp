// A claim that does not hold of a mesh, and what the rows of causes.cpp ask of it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "oracle/judge/cause/bare_facets.hpp"
#include "oracle/judge/fast/simplex_facts.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// Judges another mesh as this one was judged; nothing if it cannot be.
using JudgeAgain = std::function<std::optional<Verdict>(const Mesh&)>;

class Case {
 public:
  // All are viewed, and must outlive it. `known`: of the simplices, or null.
  Case(const Verdict& verdict, const Mesh& mesh, JudgeAgain judge, const fast::SimplexFacts* known)
      : verdict_(verdict), mesh_(mesh), judge_(std::move(judge)), known_(known) {}

  const Verdict& verdict() const { return verdict_; }
  const Mesh& mesh() const { return mesh_; }
  bool breaks(Rule rule) const { return count(rule) > 0; }
  std::size_t count(Rule rule) const;
  std::size_t violations() const;  // of all rules

  // Of the mesh; found once.
  const std::vector<BareFacet>& bare();

  // What became of the violations once the mesh was mended.
  struct Mended {
    bool holds = false;
    std::size_t explains = 0;  // violations of rules that were broken, and now are less often
    std::size_t left = 0;      // violations, of any rule
  };
  // Only one mended mesh is judged for a case, since that takes as long as judging the mesh;
  // nothing for any other, and if it cannot be judged.
  std::optional<Mended> mended(const Mesh& mesh);

  // What the claim `complex` says of the mesh; null if it has more simplices than are tried.
  const Verdict* as_complex();
  std::optional<Verdict> take_as_complex() { return std::move(as_complex_); }

  // Explains so many of all violations.
  Cause cause(std::string name, std::string words, std::size_t explains) const;

 private:
  const Verdict& verdict_;
  const Mesh& mesh_;
  JudgeAgain judge_;
  const fast::SimplexFacts* known_;
  std::optional<std::vector<BareFacet>> bare_ = {};
  bool has_mended_ = false;
  std::optional<Verdict> as_complex_ = {};
};

// A mesh with the same points and other simplices, which it views, as `simplices` does. Requires:
// the mesh outlives it.
Mesh with_simplices(const Mesh& mesh, IndexLists simplices);

// The first points, ascending, that no simplex has: at most one more than `most`.
std::vector<Vertex> unused_points(const Mesh& mesh, std::size_t most);

}  // namespace circumspect::check
