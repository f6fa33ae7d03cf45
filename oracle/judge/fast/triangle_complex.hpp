// Triangles in space that meet properly. Most domains consist of them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace circumspect::fast {

// Is it certain that the triangles are a simplicial complex? That is, none has its corners on one
// line, no two are the same, and two that have a point in common meet in a common vertex or a
// common edge. True only if they are. Also false if it would take long to find out, because there
// are more than some hundred pairs of nearby triangles for each triangle of the list, as at a
// vertex of many triangles. Requires: finite coordinates, three a point; the corners of each
// triangle are three different points of the list, and no two points are equal.
bool are_surely_a_complex(std::span<const double> coordinates,
                          std::span<const std::array<std::int32_t, 3>> triangles);

// The triangles that do not meet another as those of a complex do, by their places, ascending: none
// if they are one. Nothing if it would take long to find out, or if one has its corners on a line.
// Requires: as above.
std::optional<std::vector<std::size_t>> improper_triangles(
    std::span<const double> coordinates, std::span<const std::array<std::int32_t, 3>> triangles);

// The first of the axis pairs xy, xz and yz on which a triangle is not flat; nothing if its corners
// are on one line. Requires: as above.
struct PlaneAxes {
  std::size_t x = 0, y = 0;  // equal: none
  bool none() const { return x == y; }
};
PlaneAxes axes_of_triangle(std::span<const double> coordinates,
                           const std::array<std::int32_t, 3>& triangle);

}  // namespace circumspect::fast
