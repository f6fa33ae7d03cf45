// Cells that may meet apart from their vertices: all of them are found, and little is looked at.
#include "reference/kernel/piecewise_linear/cell_index.hpp"

#include <algorithm>

#include <doctest/doctest.h>

#include "reference/kernel/piecewise_linear/nearby_cells.hpp"

namespace circumspect {
namespace {

std::vector<std::size_t> by_definition(const std::vector<Box>& boxes,
                                       const std::vector<Simplex>& cells, const Box& box,
                                       const Simplex& vertices) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const bool shares = std::any_of(cells[i].begin(), cells[i].end(),
                                    [&](Vertex v) { return contains(vertices, v); });
    if (!shares && may_meet(boxes[i], box)) found.push_back(i);
  }
  return found;
}

// Points of a parabola in a plane of space, and one above it.
PointSet rim_and_apex(Vertex rim) {
  std::vector<Point> points;
  for (Vertex i = 0; i < rim; ++i) points.push_back({Rational(i), Rational(i * i), 0});
  points.push_back({Rational(rim) / 2, Rational(rim), Rational(rim)});
  return PointSet(points);
}

// The segments from the apex to the rim, and those of the rim.
std::vector<Simplex> spokes_and_rim(Vertex rim) {
  std::vector<Simplex> segments;
  for (Vertex i = 0; i < rim; ++i) segments.push_back({i, rim});
  for (Vertex i = 0; i + 1 < rim; ++i) segments.push_back({i, i + 1});
  return segments;
}

TEST_CASE("apart: what looking at all cells finds") {
  unsigned state = 7;
  const auto below = [&state](unsigned n) {
    state = state * 1103515245u + 12345u;
    return static_cast<Vertex>((state >> 16) % n);
  };
  for (int round = 0; round < 20; ++round) {
    std::vector<Point> points;
    for (Vertex i = 0; i < 60; ++i) {
      points.push_back({Rational(below(50)), Rational(below(50)), Rational(i, 7)});
      points.back()[2].canonicalize();
    }
    const PointSet set(points);
    // Half of the cells are at one of two vertices of many.
    std::vector<Simplex> cells;
    for (int i = 0; i < 120; ++i) {
      const Vertex v = i % 2 == 0 ? below(2) : below(60);
      const Vertex w = (v + 1 + below(58)) % 60;
      cells.push_back(sorted({v, w}));
    }
    const CellBoxes boxes(set);
    const CellIndex index(boxes.of(cells), cells);
    for (const Simplex& cell : cells) {
      CHECK(index.apart(boxes.of(cell), cell) ==
            by_definition(boxes.of(cells), cells, boxes.of(cell), cell));
    }
    const Simplex nothing;
    CHECK(index.apart(boxes.of(cells[0]), nothing) ==
          by_definition(boxes.of(cells), cells, boxes.of(cells[0]), nothing));
  }
  const std::vector<Simplex> none;
  CHECK(CellIndex({}, none).apart(box_around(Point{0, 0, 0}), {}).empty());
}

TEST_CASE("apart: of cells at one vertex no pair is looked at") {
  constexpr Vertex kRim = 2000;
  const PointSet points = rim_and_apex(kRim);
  const std::vector<Simplex> segments = spokes_and_rim(kRim);
  const CellBoxes boxes(points);
  const CellIndex index(boxes.of(segments), segments);
  for (const Simplex& segment : segments) index.apart(boxes.of(segment), segment);
  CHECK(index.work() < 100 * segments.size());  // of 4,000 × 4,000
}

}  // namespace
}  // namespace circumspect
