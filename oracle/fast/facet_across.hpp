// A facet as two simplices list it.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace circumspect::fast {

// How the rows of two simplices that share the facet opposite a vertex of the first fit together.
struct Across {
  bool matches = false;   // the second has all vertices of the facet, and not the first's own apex
  std::size_t place = 0;  // of the second's apex in its row
  bool odd = false;       // the permutation from the first row, apex for apex, to the second
};

// For each vertex the places of the others, so that it and they are an even permutation of the row.
template <std::size_t kVertices>
inline constexpr std::array<std::array<std::size_t, kVertices - 1>, kVertices> kFacetPlaces{};
template <>
inline constexpr std::array<std::array<std::size_t, 2>, 3> kFacetPlaces<3> = {
    {{1, 2}, {2, 0}, {0, 1}}};
template <>
inline constexpr std::array<std::array<std::size_t, 3>, 4> kFacetPlaces<4> = {
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

// 1 if both rows are equal, else 0; without a branch.
template <typename Index, std::size_t kCount>
unsigned is_same(const std::array<Index, kCount>& f, const std::array<Index, kCount>& g) {
  unsigned same = 1;
  for (std::size_t i = 0; i < kCount; ++i) same &= static_cast<unsigned>(f[i] == g[i]);
  return same;
}

template <typename Index>
bool is_even(const std::array<Index, 2>& f, const std::array<Index, 2>& g) {
  return is_same(f, g) != 0;
}
template <typename Index>
bool is_odd(const std::array<Index, 2>& f, const std::array<Index, 2>& g) {
  return is_same(f, {g[1], g[0]}) != 0;
}
template <typename Index>
bool is_even(const std::array<Index, 3>& f, const std::array<Index, 3>& g) {
  return (is_same(f, g) | is_same(f, {g[1], g[2], g[0]}) | is_same(f, {g[2], g[0], g[1]})) != 0;
}
template <typename Index>
bool is_odd(const std::array<Index, 3>& f, const std::array<Index, 3>& g) {
  return is_even(f, {g[0], g[2], g[1]});
}

// Both simplices lie on opposite sides of the facet iff the product of their orientations is −1 times
// the sign of the permutation: putting the one apex in the other's place changes the orientation.
// Requires for the answer to have that meaning: neither row has a vertex twice (their orientations are
// not zero).
template <std::size_t kVertices, typename Index>
inline Across across(std::span<const Index, kVertices> first, std::size_t apex,
                     std::span<const Index, kVertices> second) {
  // What is in one row only: if the facet is shared, the two apexes.
  Index other = first[apex];
  for (std::size_t i = 0; i < kVertices; ++i) other ^= first[i] ^ second[i];
  std::size_t place = 0;
  for (std::size_t i = 1; i < kVertices; ++i) place = second[i] == other ? i : place;
  if (second[place] == first[apex]) return {};
  std::array<Index, kVertices - 1> facet, again;
  for (std::size_t i = 0; i + 1 < kVertices; ++i) {
    facet[i] = first[kFacetPlaces<kVertices>[apex][i]];
    again[i] = second[kFacetPlaces<kVertices>[place][i]];
  }
  // Mostly odd: all simplices oriented alike.
  if (is_odd(facet, again)) return {true, place, true};
  return {is_even(facet, again), place, false};
}

}  // namespace circumspect::fast
