// The name of a facet of a mesh.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>

namespace circumspect::fast {

// A simplex and the place in it of the vertex opposite; in eight bytes, since a mesh may have many. A
// facet of two simplices is named by the one that comes first. In order by simplices, then by places.
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

}  // namespace circumspect::fast
