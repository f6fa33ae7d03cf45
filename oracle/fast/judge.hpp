// Does a mesh of doubles hold? Quickly, exactly, and only if it does: oracle/check says what is wrong
// with a mesh that does not, in its own words. oracle/fast/README.md proves that this is the same answer.
#pragma once

#include <cstddef>
#include <cstdint>

#include <tl/expected.hpp>

#include "oracle/fast/mesh_view.hpp"
#include "oracle/fast/site.hpp"
#include "oracle/fast/undecided.hpp"

namespace circumspect::fast {

// What is known of a mesh for which the answer is yes.
struct Facts {
  // Of Delaunay triangulations: is there no other one? is it the canonical one? (verdict.hpp)
  bool unique = true;
  bool canonical = true;
  bool oriented = true;  // all simplices alike
  Stages stages = {};    // what decided the signs
};

// Is the mesh a triangulation of its points, a Delaunay one, a weighted one? Book: Definitions 2.1 and
// 4.1, Section 5.2; weights count for the last only, and count as 0 if there are none. Given neighbours
// must be right. If the facts are returned, oracle/check finds that the claim holds, with the same facts,
// and no two points are equal; else nothing is known. The same answer for any number of threads.
// At most 32 bytes a simplex beside the arrays, 16 of them for neighbours if they are not given.
// Instances: dimensions 2 and 3; std::int32_t and std::int64_t. Requires: threads ≥ 1; the lengths of
// the arrays agree (mesh_view.hpp).
template <std::size_t kDimension, typename Index>
tl::expected<Facts, Undecided> judge(const MeshView<kDimension, Index>& mesh, Question question,
                                     unsigned threads = 1);

}  // namespace circumspect::fast
