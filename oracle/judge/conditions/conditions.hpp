// Conditions 1–3 of docs/theory/points.md, each said once. They ask for signs, which every judge
// finds in its own arithmetic and for its own lists: the exact checkers (oracle/judge/points), the
// list of faults of the fast judge, and the judge of meshes in parts. A sign is 1 on the inner
// side, 0 in the hyperplane and −1 beyond.
//
// One place does not ask condition 1 here: the fast judge's sweep. It compares parities of vertex
// orders for several facets at once, in vectors, which a question for one facet cannot do.
// What it doubts is asked here, by the list of faults.
#pragma once

#include <cstddef>

namespace circumspect::conditions {

// 1. Each facet lies in one simplex, or in two on opposite sides of it.
enum class AtFacet { kGood, kOverused, kSameSide };

// `are_on_same_side`: asked of two simplices.
template <class AreOnSameSide>
AtFacet at_facet(std::size_t simplices, const AreOnSameSide& are_on_same_side) {
  if (simplices > 2) return AtFacet::kOverused;
  return simplices == 2 && are_on_same_side() ? AtFacet::kSameSide : AtFacet::kGood;
}

// 2. Each ridge of a boundary facet lies in exactly two boundary facets, and the vertex of either
// off the ridge is not strictly beyond the other. If they are in one hyperplane, they are on
// opposite sides of the ridge.
enum class AtRidge { kGood, kNotClosed, kSecondBeyond, kFirstBeyond, kFolded };

// Of two facets `sign_of_second` is asked, which is the side of the first facet on which the vertex
// of the second is, then `sign_of_first`, and if both are in one hyperplane `are_folded`.
template <class SignOfSecond, class SignOfFirst, class AreFolded>
AtRidge at_ridge(std::size_t facets, const SignOfSecond& sign_of_second,
                 const SignOfFirst& sign_of_first, const AreFolded& are_folded) {
  if (facets != 2) return AtRidge::kNotClosed;
  const int second = sign_of_second();
  if (second < 0) return AtRidge::kSecondBeyond;
  if (sign_of_first() < 0) return AtRidge::kFirstBeyond;
  return second == 0 && are_folded() ? AtRidge::kFolded : AtRidge::kGood;
}

// 3. The sample point lies strictly on the inner side of every boundary facet …
inline bool is_strictly_inside(int sign) { return sign > 0; }

// … and in no closed simplex but its own. `sign_at(i)`: the side of the facet opposite vertex i on
// which the point is.
template <class SignAt>
bool covers(std::size_t vertices, const SignAt& sign_at) {
  for (std::size_t i = 0; i < vertices; ++i) {
    if (sign_at(i) < 0) return false;
  }
  return true;
}

}  // namespace circumspect::conditions
