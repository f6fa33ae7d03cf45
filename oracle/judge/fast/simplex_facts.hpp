// Facts about the simplices of a mesh that do not depend on the region that they cover: for meshes
// of domains, whose walls decide the rest (docs/theory/domains.md).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <tl/expected.hpp>

#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/judge/fast/predicates/site.hpp"
#include "oracle/judge/fast/undecided.hpp"

namespace circumspect::fast {

// If they exist, every simplex has d + 1 different vertices, all of them points, and is not flat;
// no two have the same vertices; no facet is in three of them, and two at a facet are on opposite
// sides of it: conditions 0 and 1 of docs/theory/domains.md, except for listed faces. And all of
// the following is right. Lists are ascending.
struct SimplexFacts {
  std::vector<FacetId> boundary = {};  // all facets of one simplex
  // Facets of two simplices, if balls were asked for: all that are not locally Delaunay; all whose
  // apexes are on a common sphere; and those of the latter that are not locally Delaunay under the
  // canonical perturbation.
  std::vector<FacetId> not_local = {};
  std::vector<FacetId> ties = {};
  std::vector<FacetId> not_canonical = {};
  bool oriented = true;      // all simplices alike
  std::size_t positive = 0;  // how many are positively oriented
  bool uses_all_points = true;
  // Is it known that they are a triangulation of all points, if that was asked for? (Conditions 2
  // and 3 of docs/theory/points.md.)
  bool fills_hull = false;
  // In space, if that was asked for: the simplices with a facet of their own whose balls may have a
  // point strictly inside. It is known that no other of them has one.
  std::optional<std::vector<std::size_t>> doubtful_balls = {};
  Stages stages = {};  // what decided the signs

  bool boundary_balls_are_empty() const { return doubtful_balls && doubtful_balls->empty(); }
};

// Which facts are wanted.
struct Wanted {
  bool balls = false;
  bool hull = false;
  bool boundary_balls = false;
  // May a facet of the boundary, or of a pair of simplices, be in others as well? Such facets are
  // found more quickly, and docs/theory/complex.md shows that they do for complexes.
  bool pairs_suffice = false;
};

// Undecided if the simplices are not as above; then nothing is known. Given neighbours and weights
// are ignored. Instances: dimensions 2 and 3, std::int32_t and std::int64_t. Requires: threads ≥ 1.
template <std::size_t kDimension, typename Index>
tl::expected<SimplexFacts, Undecided> simplex_facts(const MeshView<kDimension, Index>& mesh,
                                                    Wanted wanted, unsigned threads);

}  // namespace circumspect::fast
