// Does a mesh of doubles hold? The answer is quick and exact. faults.hpp lists every fault other
// than facets that are not locally Delaunay. docs/theory/fast.md proves that the answers are right.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <tl/expected.hpp>

#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/judge/fast/predicates/site.hpp"
#include "oracle/judge/fast/undecided.hpp"

namespace circumspect::fast {

// Facts about a mesh that is a triangulation of its points; if weights count, of its vertices,
// covering the convex hull of all points.
struct Facts {
  // For Delaunay triangulations: is it the only one? is it the canonical one? (verdict.hpp)
  bool unique = true;
  bool canonical = true;
  bool oriented = true;  // all simplices alike
  // All facets that are not locally Delaunay, if that was asked, ascending. The claim holds iff
  // there are none.
  std::vector<FacetId> not_local = {};
  Stages stages = {};  // what decided the signs

  bool holds() const { return not_local.empty(); }
};

struct SweptMesh;  // faults.hpp

// Is the mesh a triangulation of its points, a Delaunay one, a weighted one? Book: Definitions 2.1
// and 4.1, Section 5.2; weights count for the last only, and count as 0 if there are none. Given
// neighbours must be right. If the returned facts hold, oracle/judge/points finds that the claim
// holds, with the same facts, and no two points are equal. If the returned facts do not hold, it
// finds that the mesh is a triangulation whose listed facets are not locally Delaunay, and nothing
// else wrong. If no facts are returned, nothing is known. The same answer for any number of
// threads. At most 32 bytes a simplex beside the arrays, 16 of them for neighbours if they are not
// given. Instances: dimensions 2 and 3; std::int32_t and std::int64_t. Requires: threads ≥ 1; the
// lengths of the arrays agree (mesh_view.hpp). If nothing is known, and neighbours were found,
// `swept` gets the results that faults() need not compute again.
template <std::size_t kDimension, typename Index>
tl::expected<Facts, Undecided> judge(const MeshView<kDimension, Index>& mesh, Question question,
                                     unsigned threads, std::optional<SweptMesh>* swept = nullptr);

// The same with these neighbours, as MeshView has them, in place of its own: of std::int32_t, where
// indices are std::int64_t.
template <std::size_t kDimension, typename Index, typename Link>
tl::expected<Facts, Undecided> judge(const MeshView<kDimension, Index>& mesh, Links<Link> neighbors,
                                     Question question, unsigned threads);

}  // namespace circumspect::fast
