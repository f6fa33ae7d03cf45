#include "reference/delaunay/space_filling_curve.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace circumspect::delaunay {
namespace {

// Replaces the coordinates of the vertices on one axis by how many different ones are smaller.
void number_coordinates(const PointSet& points, const std::vector<Vertex>& vertices,
                        std::size_t axis, std::size_t place, std::vector<GridCell>& cells) {
  const auto coordinate = [&](std::size_t i) -> const Rational& {
    return points[vertices[i]][axis];
  };
  std::vector<std::size_t> order(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return coordinate(a) < coordinate(b); });
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && coordinate(order[i - 1]) != coordinate(order[i])) ++number;
    cells[order[i]][place] = number;
  }
}

}  // namespace

bool precedes_on_z_order_curve(const GridCell& a, const GridCell& b) {
  // The most significant bit in which the cells differ decides; among axes that differ in it, the
  // first.
  std::size_t deciding = 0;
  std::uint64_t largest = 0;
  for (std::size_t axis = 0; axis < a.size(); ++axis) {
    const std::uint64_t difference = a[axis] ^ b[axis];
    if (std::bit_width(largest) < std::bit_width(difference)) {
      deciding = axis;
      largest = difference;
    }
  }
  return a[deciding] < b[deciding];
}

GridCell from_hilbert_to_z_order(GridCell cell, int bits) {
  const std::uint64_t top = std::uint64_t{1} << (bits - 1);
  // From the largest subcubes to the smallest, undo the reflection or the exchange of axes with
  // which the curve passes through the subcube.
  for (std::uint64_t bit = top; bit > 1; bit >>= 1) {
    const std::uint64_t lower_bits = bit - 1;
    for (std::uint64_t& x : cell) {
      if ((x & bit) != 0) {
        cell[0] ^= lower_bits;
      } else {
        const std::uint64_t exchanged = (cell[0] ^ x) & lower_bits;
        cell[0] ^= exchanged;
        x ^= exchanged;
      }
    }
  }
  // Within one subcube the curve goes through the corners in the order of the Gray code.
  for (std::size_t axis = 1; axis < cell.size(); ++axis) cell[axis] ^= cell[axis - 1];
  std::uint64_t carried = 0;
  for (std::uint64_t bit = top; bit > 1; bit >>= 1) {
    if ((cell.back() & bit) != 0) carried ^= bit - 1;
  }
  for (std::uint64_t& x : cell) x ^= carried;
  return cell;
}

std::vector<Vertex> along_curve(const PointSet& points, std::vector<Vertex> vertices,
                                SpaceFillingCurve curve) {
  if (points.dimension() < 1) return vertices;
  const std::span<const std::size_t> axes = points.configuration().axes();
  std::vector<GridCell> cells(vertices.size(), GridCell(axes.size()));
  for (std::size_t place = 0; place < axes.size(); ++place) {
    number_coordinates(points, vertices, axes[place], place, cells);
  }
  if (curve == SpaceFillingCurve::kHilbert) {
    const int bits = std::max(1, static_cast<int>(std::bit_width(vertices.size())));
    for (GridCell& cell : cells) cell = from_hilbert_to_z_order(std::move(cell), bits);
  }
  std::vector<std::size_t> order(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return precedes_on_z_order_curve(cells[a], cells[b]);
  });
  std::vector<Vertex> sequence;
  sequence.reserve(order.size());
  for (const std::size_t i : order) sequence.push_back(vertices[i]);
  return sequence;
}

}  // namespace circumspect::delaunay
