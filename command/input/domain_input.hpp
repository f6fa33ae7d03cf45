// Reads a file as a domain against which meshes are judged.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tl/expected.hpp>

#include "command/input/enclosure.hpp"
#include "command/input/input.hpp"
#include "command/options/domain_options.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "oracle/formats/domain_file.hpp"
#include "oracle/model/domain.hpp"

namespace circumspect::cli {

// A domain, and the file that it came from: lines and notes.
struct LoadedDomain {
  std::string name;
  Domain domain;
  formats::DomainFile file;
  std::string filled = {};                      // "enclosed, what its polygons enclose"
  std::vector<std::size_t> bound_nothing = {};  // polygons without anything filled on either side
  std::vector<Simplex> listed = {};  // what the file lists as segments: `listed_segments`
  std::size_t listed_holes = 0;      // so many hole seeds; those that follow are of options
  bool is_hull_with_holes = false;   // in the plane; walls enclose it that the file does not list
};

// What is wrong with an input: one line for people, and the breaches of Definition 4.3, if it could
// be read. `file` has the points and lines that breaches are about, and notes of how they were
// read.
struct DomainFault {
  std::string message;
  std::vector<Breach> breaches = {};
  formats::DomainFile file = {};
  bool truncated = false;  // are there more breaches?
};

// Who waits for a domain: is told how far its validation has come, of each breach as soon as it is
// found (then only the first kBreachLimit are in the DomainFault), and that it is valid before its
// kind is chosen.
struct DomainWatch {
  Progress progress = {};
  std::function<void(const Breach&, const formats::DomainFile&)> on_breach = {};
  std::function<void(const PiecewiseLinearComplex&, const formats::DomainFile&)> on_valid = {};
  bool only_validity = false;  // the kind stays as it is, without notes
};

// Errors: a malformed file; duplicates, unless they are merged; any other breach, up to
// `max_breaches` of them (0: all); no kind that `choose_kind` can give it. The notes of the file
// have those about the kind too. Polygons of one plane are joined if the options say so, those that
// are nearly in one plane not yet.
tl::expected<LoadedDomain, DomainFault> load_domain(const std::string& path,
                                                    const InputOptions& options,
                                                    const DomainOptions& said,
                                                    std::size_t max_breaches = kBreachLimit,
                                                    Leak leak = Leak::kRefused,
                                                    const DomainWatch& watch = {});

// The same of a file that has been read; `path` is its name.
tl::expected<LoadedDomain, DomainFault> load_domain(
    formats::DomainFile file, const std::string& path, const InputOptions& options,
    const DomainOptions& said, std::size_t max_breaches = kBreachLimit, Leak leak = Leak::kRefused,
    const DomainWatch& watch = {});

// As what a mesh is read that is held against this domain.
DomainFrame frame_of(const LoadedDomain& domain);

// The domain with its polygons of one plane joined. Polygons are called by the first of those they
// were joined of; a note says how many there are.
LoadedDomain with_coplanar_joined(LoadedDomain loaded);

// The domain with those joined that are nearly in one plane: it is for check::judge_within alone.
struct BentDomain {
  Domain domain;
  std::size_t removed_segments = 0;
  Rational squared_height = 0;  // how far at most vertices are from the plane of a polygon
  std::string note = {};        // what was joined
  std::optional<Rational> squared_limit = {};  // up to which images keep apart what is apart
};
BentDomain with_nearly_coplanar_joined(const LoadedDomain& loaded, const Rational& slope,
                                       const Rational& squared_distance);

std::string_view word(DomainKind kind);

// The numbers that the vertices of a domain have in its file.

// Requires: vertices of the domain.
inline std::string labels(const Domain& domain, const Simplex& simplex) {
  std::vector<Vertex> own;
  for (const Vertex v : simplex) own.push_back(domain.label(v));
  return fmt::format("{}", fmt::join(own, " "));
}

}  // namespace circumspect::cli
