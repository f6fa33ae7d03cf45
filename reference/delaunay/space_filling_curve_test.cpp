// Space-filling curves. Book: Section 5.3.
#include "reference/delaunay/space_filling_curve.hpp"

#include <algorithm>
#include <set>

#include <doctest/doctest.h>

#include "properties/generators/laws.hpp"

namespace circumspect::delaunay {
namespace {

// All cells of the grid {0, …, 2^bits − 1}^k.
std::vector<GridCell> all_cells(std::size_t k, int bits) {
  std::vector<GridCell> cells = {{}};
  for (std::size_t axis = 0; axis < k; ++axis) {
    std::vector<GridCell> longer;
    for (const GridCell& cell : cells) {
      for (std::uint64_t x = 0; x < std::uint64_t{1} << bits; ++x) {
        longer.push_back(cell);
        longer.back().push_back(x);
      }
    }
    cells = longer;
  }
  return cells;
}

TEST_CASE("z-order curve: it goes through the corners of each square in the shape of a Z") {
  std::vector<GridCell> cells = {{1, 1}, {1, 0}, {2, 0}, {0, 1}, {0, 0}, {0, 2}};
  std::sort(cells.begin(), cells.end(), precedes_on_z_order_curve);
  CHECK(cells == std::vector<GridCell>{{0, 0}, {0, 1}, {1, 0}, {1, 1}, {0, 2}, {2, 0}});
}

TEST_CASE("Hilbert curve: in the grid of two by two it goes around") {
  std::vector<GridCell> cells = all_cells(2, 1);
  std::sort(cells.begin(), cells.end(), [](const GridCell& a, const GridCell& b) {
    return precedes_on_z_order_curve(from_hilbert_to_z_order(a, 1), from_hilbert_to_z_order(b, 1));
  });
  CHECK(cells == std::vector<GridCell>{{0, 0}, {0, 1}, {1, 1}, {1, 0}});
}

TEST_CASE("Hilbert curve: it visits every cell once, and consecutive cells share a facet") {
  for (const auto& grid : {std::pair(1U, 6), {2U, 1}, {2U, 4}, {3U, 3}, {4U, 2}, {5U, 2}}) {
    const unsigned k = grid.first;
    const int bits = grid.second;
    CAPTURE(k);
    CAPTURE(bits);
    std::vector<std::pair<GridCell, GridCell>> cells;  // place on the z-order curve, cell
    std::set<GridCell> places;
    for (const GridCell& cell : all_cells(k, bits)) {
      cells.emplace_back(from_hilbert_to_z_order(cell, bits), cell);
      places.insert(cells.back().first);
    }
    CHECK(places.size() == cells.size());
    std::sort(cells.begin(), cells.end(), [](const auto& a, const auto& b) {
      return precedes_on_z_order_curve(a.first, b.first);
    });
    std::size_t leaps = 0;
    for (std::size_t i = 1; i < cells.size(); ++i) {
      std::uint64_t distance = 0;
      for (std::size_t axis = 0; axis < k; ++axis) {
        const std::uint64_t a = cells[i - 1].second[axis];
        const std::uint64_t b = cells[i].second[axis];
        distance += a < b ? b - a : a - b;
      }
      if (distance != 1) ++leaps;
    }
    CHECK(leaps == 0);
  }
}

TEST_CASE("space-filling curve: it is followed from point to point, however uneven the axes are") {
  const PointSet points({{Rational(1, 3), 1000}, {-7, 5}, {Rational(1, 3), 5}, {-7, 1000}});
  CHECK(along_curve(points, {0, 1, 2, 3}, SpaceFillingCurve::kHilbert) ==
        std::vector<Vertex>{1, 3, 0, 2});
  CHECK(along_curve(points, {0, 1, 2, 3}, SpaceFillingCurve::kZOrder) ==
        std::vector<Vertex>{1, 3, 2, 0});
  CHECK(along_curve(points, {3, 0}, SpaceFillingCurve::kZOrder) == std::vector<Vertex>{3, 0});
  CHECK(along_curve(points, {}, SpaceFillingCurve::kHilbert).empty());
}

TEST_CASE("space-filling curve: a permutation that does not depend on the order given") {
  for (const std::size_t d : {1U, 2U, 3U, 4U}) {
    CHECK(rc::check("dimension " + std::to_string(d), [d] {
      const PointSet points((*generators::unweighted(generators::any_point_set(d, 20))).points);
      const std::vector<Vertex> all = generators::first_vertices(points.size());
      for (const auto curve : {SpaceFillingCurve::kHilbert, SpaceFillingCurve::kZOrder}) {
        const std::vector<Vertex> sequence = along_curve(points, all, curve);
        RC_ASSERT(sorted(sequence) == all);
        RC_ASSERT(along_curve(points, generators::shuffled(all), curve) == sequence);
      }
    }));
  }
}

}  // namespace
}  // namespace circumspect::delaunay
