// A facet as two simplices list it.
#pragma once

#include <array>
#include <cstddef>

namespace circumspect::fast {

// For each vertex the places of the others, so that it and they are an even permutation of the row.
template <std::size_t kVertices>
inline constexpr std::array<std::array<std::size_t, kVertices - 1>, kVertices> kFacetPlaces{};
template <>
inline constexpr std::array<std::array<std::size_t, 2>, 3> kFacetPlaces<3> = {
    {{1, 2}, {2, 0}, {0, 1}}};
template <>
inline constexpr std::array<std::array<std::size_t, 3>, 4> kFacetPlaces<4> = {
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

// All ones if they are equal, else 0. Masks instead of conditions, of which compilers make
// branches.
template <typename Index>
[[gnu::always_inline]] inline Index mask_if_equal(Index a, Index b) {
  return static_cast<Index>(-static_cast<Index>(a == b));
}
template <typename Index>
[[gnu::always_inline]] inline Index select(Index mask, Index a, Index b) {
  return static_cast<Index>(b ^ (mask & (a ^ b)));
}

// Does g list the same as f, in an order that is an even, an odd permutation? As masks.
template <typename Index>
struct SameVertices {
  Index even, odd;
};
template <typename Index>
[[gnu::always_inline]] inline SameVertices<Index> same_vertices(const std::array<Index, 2>& f,
                                                                const std::array<Index, 2>& g) {
  const Index even = mask_if_equal(f[0], g[0]) & mask_if_equal(f[1], g[1]);
  const Index odd = mask_if_equal(f[0], g[1]) & mask_if_equal(f[1], g[0]);
  return {even, odd};
}
template <typename Index>
[[gnu::always_inline]] inline SameVertices<Index> same_vertices(const std::array<Index, 3>& f,
                                                                const std::array<Index, 3>& g) {
  std::array<std::array<Index, 3>, 3> same;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) same[i][k] = mask_if_equal(f[i], g[k]);
  }
  const Index even = (same[0][0] & same[1][1] & same[2][2]) |
                     (same[0][1] & same[1][2] & same[2][0]) |
                     (same[0][2] & same[1][0] & same[2][1]);
  const Index odd = (same[0][0] & same[1][2] & same[2][1]) |
                    (same[0][1] & same[1][0] & same[2][2]) | (same[0][2] & same[1][1] & same[2][0]);
  return {even, odd};
}

// How the rows of two simplices that share the facet opposite a vertex of the first fit together.
// Yes is a mask of ones, no is 0.
template <typename Index>
struct Fit {
  Index matches;  // the second has all vertices of the facet, and not the first's own apex
  Index odd;      // the permutation from the first row, apex for apex, to the second
  Index place;    // of the second's apex in its row …
  Index apex;     // … and that
};

// `first` lists the apex, then the facet as in kFacetPlaces; `second` is the other simplex's row.
// Inlined into loops over many facets (block.cpp). Both simplices lie on opposite sides of the
// facet iff the product of their orientations is −1 times the sign of the permutation: putting the
// one apex in the other's place changes the orientation. Requires for the answer to have that
// meaning: neither row has a vertex twice (their orientations are not zero).
template <std::size_t kVertices, typename Index>
[[gnu::always_inline]] inline Fit<Index> fit_of(const std::array<Index, kVertices>& first,
                                                const std::array<Index, kVertices>& second) {
  constexpr std::size_t kOthers = kVertices - 1;
  // What is in one row only: if the facet is shared, the two apexes.
  Index other = 0;
  for (std::size_t i = 0; i < kVertices; ++i) other ^= first[i] ^ second[i];
  other ^= first[0];
  Index place = 0;
  std::array<Index, kOthers> facet, again;
  for (std::size_t k = 0; k < kOthers; ++k) {
    facet[k] = first[k + 1];
    again[k] = second[kFacetPlaces<kVertices>[0][k]];
  }
  for (std::size_t i = 1; i < kVertices; ++i) {
    const Index is_apex = mask_if_equal(second[i], other);
    place = select(is_apex, static_cast<Index>(i), place);
    for (std::size_t k = 0; k < kOthers; ++k) {
      again[k] = select(is_apex, second[kFacetPlaces<kVertices>[i][k]], again[k]);
    }
  }
  // If all vertices of the facet are found again, what is left is `other`.
  const SameVertices<Index> same = same_vertices(facet, again);
  const Index matches = (same.even | same.odd) & ~mask_if_equal(other, first[0]);
  return {matches, same.odd, place, other};
}

}  // namespace circumspect::fast
