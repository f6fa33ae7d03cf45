// One pass over the simplices that looks at every simplex and every facet once: conditions 0 and 1 of
// oracle/check/README.md, what condition 3 says of simplices, the links, and Lemma 4.1.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "oracle/fast/mesh_view.hpp"
#include "oracle/fast/orientations.hpp"
#include "oracle/fast/sample_point.hpp"
#include "oracle/fast/site.hpp"
#include "oracle/fast/undecided.hpp"
#include "oracle/fast/used_points.hpp"

namespace circumspect::fast {

template <std::size_t kDimension, typename Index, typename Link>
struct SweepTask {
  const MeshView<kDimension, Index>& mesh;
  Links<Link> links;
  const Orientations& orientations;  // if equal for all: that of one simplex
  const SamplePoint<kDimension>& sample;
  bool balls;     // are facets to be locally Delaunay?
  bool weighted;  // in the weighted sense? Requires weights.
  UsedPoints& used;
};

inline Stages sum(const Stages& a, const Stages& b) {
  return {a.filtered + b.filtered, a.narrow + b.narrow, a.fixed + b.fixed, a.wide + b.wide,
          a.unbounded + b.unbounded};
}

// What the pass found in some of the simplices.
struct Swept {
  std::optional<Undecided> undecided = {};
  bool mixed = false;      // not all simplices are oriented alike; nothing else is known
  bool unique = true;      // no apex is on the sphere of the simplex across
  bool canonical = true;   // every facet is locally Delaunay under the canonical perturbation
  std::uint64_t up = 0;    // links to a later simplex, each verified from both ends
  std::uint64_t down = 0;  // links to an earlier one: all verified iff there are as many in all
  std::vector<std::uint64_t> boundary = {};  // simplex · (d + 1) + place of the apex
  Stages stages = {};

  bool goes_on() const { return !undecided && !mixed; }
  // What was found in the simplices that follow; their boundary facets stay where they are.
  void append(const Swept& later);
};

// Sweeps simplices `first` to `last` − 1; ends at the first thing that is wrong. Facets of two of them
// are tested from the side of the one that comes first.
template <std::size_t kDimension, typename Index, typename Link>
Swept sweep(const SweepTask<kDimension, Index, Link>& task, std::size_t first, std::size_t last);

}  // namespace circumspect::fast
