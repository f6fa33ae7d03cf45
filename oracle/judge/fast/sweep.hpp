// One pass over the simplices that looks at every simplex and every facet once: conditions 0 and 1 of
// docs/theory/points.md, what condition 3 says of simplices, the links, and Lemma 4.1.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "oracle/judge/fast/block.hpp"
#include "oracle/judge/fast/boundary_simplices.hpp"
#include "oracle/judge/fast/facet_id.hpp"
#include "oracle/judge/fast/lattice.hpp"
#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/judge/fast/orientations.hpp"
#include "oracle/judge/fast/sample_point.hpp"
#include "oracle/judge/fast/site.hpp"
#include "oracle/judge/fast/undecided.hpp"
#include "oracle/judge/fast/used_points.hpp"

namespace circumspect::fast {

template <std::size_t kDimension, typename Index, typename Link>
struct SweepTask {
  const MeshView<kDimension, Index>& mesh;
  Links<Link> links;
  const Orientations& orientations;       // if equal for all: that of one simplex
  const SamplePoint<kDimension>* sample;  // none: simplices may cover what they like
  bool balls;                             // are facets to be locally Delaunay?
  bool weighted;                          // in the weighted sense? Requires weights.
  bool ties;                              // are those to be listed whose apex is on the sphere?
  Lattice lattice;  // one that all points lie on, and their weights if those count
  UsedPoints& used;
  BoundarySimplices& boundary;
  const BlockKernels<kDimension>* kernels = nullptr;  // none: the widest of this machine
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
  // Facets of two simplices, in ascending order.
  std::vector<FacetId> not_local = {};      // the other apex is strictly inside the ball
  std::vector<FacetId> ties = {};           // it is on the sphere; listed if asked for
  std::vector<FacetId> not_canonical = {};  // those of them that the perturbation makes not local
  Stages stages = {};

  bool goes_on() const { return !undecided && !mixed; }
  // What was found in the simplices that follow.
  void append(const Swept& later);
};

// Sweeps simplices `first` to `last` − 1, where `first` is a multiple of kBlock; ends at the first
// thing that is wrong. Facets of two of them are tested from the side of the one that comes first.
template <std::size_t kDimension, typename Index, typename Link>
Swept sweep(const SweepTask<kDimension, Index, Link>& task, std::size_t first, std::size_t last);

}  // namespace circumspect::fast
