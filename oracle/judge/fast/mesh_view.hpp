// A view of a mesh in a user's arrays, which nothing here copies, and the names of its facets.
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>

#include "oracle/judge/fast/predicates/site.hpp"

namespace circumspect::fast {

// The name of a facet of a mesh.

// A simplex and the place in it of the vertex opposite; in eight bytes, since a mesh may have many.
// A facet of two simplices is named by the one that comes first. In order by simplices, then by
// places.
class FacetId {
 public:
  // Requires: place < 4, as in the plane and in space; simplex < 2^62.
  constexpr FacetId(std::size_t simplex, std::size_t place)
      : bits_(std::uint64_t{simplex} << 2 | place) {}

  constexpr std::size_t simplex() const { return bits_ >> 2; }
  constexpr std::size_t place() const { return bits_ & 3; }

  friend constexpr auto operator<=>(FacetId, FacetId) = default;

 private:
  std::uint64_t bits_;
};

// The answer to a question about a mesh is one of these, or none (judge.hpp).
enum class Question { kTriangulation, kDelaunay, kWeightedDelaunay };

// Points one after the other, and simplices one after the other; indices from 0. Nothing is assumed
// about the numbers except the lengths of the arrays.
template <std::size_t kDimension, typename Index>
struct MeshView {
  static constexpr std::size_t kVertices = kDimension + 1;

  std::span<const double> coordinates;  // kDimension a point
  std::span<const double> weights;      // one a point, or none
  std::span<const Index> simplices;     // kVertices a simplex
  std::span<const Index> neighbors =
      {};  // what is across the facet opposite each vertex, −1: nothing;
           // as many as `simplices`, or none

  std::size_t points() const { return coordinates.size() / kDimension; }
  std::size_t size() const { return simplices.size() / kVertices; }

  std::span<const Index, kVertices> row(std::size_t s) const {
    return simplices.subspan(s * kVertices).template first<kVertices>();
  }
  bool names_point(Index v) const {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(v)) < points();
  }

  // Requires: names_point(v); weights, if kWeighted.
  template <bool kWeighted>
  Site<kDimension> site(Index v) const {
    const auto place = static_cast<std::size_t>(v);
    Site<kDimension> site;
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      site.at[axis] = coordinates[place * kDimension + axis];
    }
    if constexpr (kWeighted) site.weight = weights[place];
    return site;
  }
  // Of the vertices of a simplex. Requires: they name points; weights, if kWeighted.
  template <bool kWeighted>
  SiteRow<kDimension> sites(std::size_t s) const {
    SiteRow<kDimension> sites;
    for (std::size_t i = 0; i < kVertices; ++i) sites[i] = site<kWeighted>(row(s)[i]);
    return sites;
  }
};

// The vertices of the facet of a simplex opposite one of them, ascending.
template <std::size_t kVertices, typename Index>
std::array<Index, kVertices - 1> facet_of(std::span<const Index, kVertices> simplex,
                                          std::size_t opposite) {
  std::array<Index, kVertices - 1> facet;
  std::size_t size = 0;
  for (std::size_t i = 0; i < kVertices; ++i) {
    if (i != opposite) facet[size++] = simplex[i];
  }
  std::sort(facet.begin(), facet.end());
  return facet;
}

// For each simplex and vertex, what is across the facet opposite: given, or found by
// facet_matching.hpp.
template <typename Link>
using Links = std::span<const Link>;

}  // namespace circumspect::fast
