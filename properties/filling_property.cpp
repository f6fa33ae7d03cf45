// Which regions are filled, by each of the rules for it, against numbers of the cells of a
// triangulation whose facets the walls are. Book: Section 4.5.1.
#include <algorithm>
#include <map>
#include <set>

#include <doctest/doctest.h>

#include "kernel/complex/by_facet.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "oracle/domain/filling.hpp"
#include "oracle/domain/uncovered.hpp"
#include "properties/arguments/generated.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::properties {
namespace {

using generators::Dice;

struct Triangulated {
  PointSet points;
  std::vector<Simplex> cells;  // positively oriented

  Point middle(std::size_t cell) const { return barycentre(points, cells[cell]); }
};

Triangulated any_triangulated(std::size_t d) {
  const std::vector<Point> points = *generators::any_point_set(d, d == 2 ? 12 : 8);
  RC_PRE(PointSet(points).dimension() == static_cast<int>(d));
  Triangulated found{PointSet(points), {}};
  const Triangulation triangulation = delaunay::bowyer_watson(found.points);
  for (const Simplex& cell : triangulation.simplices()) {
    found.cells.push_back(positively_oriented(found.points, cell));
  }
  return found;
}

Dice any_dice() { return Dice(*rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>())); }

// The order of its vertices in which a facet is listed.
std::vector<Vertex> listed(const OrientedFacet& facet) {
  std::vector<Vertex> order = facet.vertices;
  if (facet.reversed) std::swap(order[0], order[1]);
  return order;
}

void list(PiecewiseLinearInput& input, const OrientedFacet& facet) {
  if (facet.vertices.size() == 2) {
    input.segments.push_back(listed(facet));
  } else {
    input.polygons.push_back({{listed(facet)}, {}});
  }
}

// A wall wherever the number of the cells changes, and 0 is that of the outside: listed as often as
// it changes, with its front to the larger number. Each wall says by how much it changes.
struct Wound {
  PiecewiseLinearInput input;
  std::vector<OrientedFacet> walls;
};
Wound wound_around(const Triangulated& of, const std::vector<int>& numbers) {
  Wound found{{.points = of.points.points()}, {}};
  for (const auto uses : ByFacet(facet_uses(of.cells))) {
    const FacetUse& one = uses.front();
    const int other = uses.size() == 2 ? numbers[uses.back().simplex] : 0;
    const int change = numbers[one.simplex] - other;
    OrientedFacet front = OrientedFacet::opposite(of.cells[one.simplex], one.opposite);
    if (change < 0) front = front.reverse();
    for (int i = 0; i < std::abs(change); ++i) list(found.input, front);
    if (change != 0) found.walls.push_back(front);
  }
  return found;
}

// Are the cells inside that should be, once a seed in each region that is not filled has made it a
// hole?
template <class IsInside>
void assert_inside(const Triangulated& of, PiecewiseLinearComplex complex, std::vector<Point> seeds,
                   const IsInside& is_inside) {
  complex.hole_seeds = std::move(seeds);
  const Regions regions(complex);
  RC_ASSERT(regions.ignored_seeds().empty());
  for (std::size_t i = 0; i < of.cells.size(); ++i) {
    RC_ASSERT((regions.locate(of.middle(i)) == Where::kInside) == is_inside(i));
  }
}

TEST_CASE("walls wind around each cell as often as they were listed around it") {
  for (const std::size_t d : {2u, 3u}) {
    CAPTURE(d);
    CHECK(holds("filled where that is not 0", 100, [d] {
      const Triangulated of = any_triangulated(d);
      Dice dice = any_dice();
      // In space a polygon is listed once, so the number changes by 1 there.
      const int least = d == 2 ? -2 : dice.within(-1, 0), most = d == 2 ? 2 : least + 1;
      std::vector<int> numbers;
      for (std::size_t i = 0; i < of.cells.size(); ++i) numbers.push_back(dice.within(least, most));
      Wound wound = wound_around(of, numbers);
      RC_PRE(!wound.walls.empty());
      const auto complex = validated(wound.input);
      RC_ASSERT(complex.has_value());
      const Regions regions(*complex);
      const auto seeds = seeds_of_unfilled(Fill::kWinding, wound.input, *complex, regions);
      RC_ASSERT(seeds.has_value());
      assert_inside(of, *complex, *seeds, [&](std::size_t i) { return numbers[i] != 0; });
      const auto wound_times =
          winding_numbers(regions, listed_directions(wound.input, *complex, regions));
      for (std::size_t i = 0; i < of.cells.size(); ++i) {
        RC_ASSERT(wound_times->at(*regions.region_at(of.middle(i))) == numbers[i]);
      }
      if (most - least == 1) {
        RC_ASSERT(!nesting_levels(regions).wall_of_no_parity);
        const auto even = seeds_of_unfilled(Fill::kEvenOdd, wound.input, *complex, regions);
        assert_inside(of, *complex, *even, [&](std::size_t i) { return numbers[i] != 0; });
      }
      // One that is turned, or is listed once more the other way, contradicts the others.
      if (d == 2) {
        list(wound.input, wound.walls[dice.below(wound.walls.size())].reverse());
      } else {
        auto& line = wound.input.polygons[dice.below(wound.input.polygons.size())].lines.front();
        std::reverse(line.begin(), line.end());
      }
      RC_ASSERT(!seeds_of_unfilled(Fill::kWinding, wound.input, *complex, regions).has_value());
    }));
  }
}

// Each cell comes with the set of cells that no wall parts it from; the last one is the outside.
TEST_CASE("what has a point of its own is filled, and a point outside is named") {
  for (const std::size_t d : {2u, 3u}) {
    CAPTURE(d);
    CHECK(holds("filled where a point is", 100, [d] {
      const Triangulated of = any_triangulated(d);
      Dice dice = any_dice();
      std::vector<int> numbers;
      for (std::size_t i = 0; i < of.cells.size(); ++i) numbers.push_back(dice.within(0, 1));
      const auto complex = validated(wound_around(of, numbers).input);
      RC_ASSERT(complex.has_value());
      const Regions regions(*complex);
      RC_PRE(regions.size() > 1);
      std::vector<Point> named;
      std::set<std::size_t> has_point;
      std::optional<std::size_t> outside;
      for (std::size_t i = 0; i < of.cells.size(); ++i) {
        if (dice.below(3) != 0) continue;
        const std::size_t region = *regions.region_at(of.middle(i));
        if (region == Regions::kUnbounded && !outside) outside = named.size();
        named.push_back(of.middle(i));
        has_point.insert(region);
      }
      const auto seeds = seeds_of_unnamed(named, regions);
      RC_ASSERT(seeds.has_value() == !outside);
      if (outside) {
        RC_ASSERT(seeds.error() == *outside);
        return;
      }
      assert_inside(of, *complex, *seeds, [&](std::size_t i) {
        return has_point.contains(*regions.region_at(of.middle(i)));
      });
    }));
  }
}

PiecewiseLinearComplex with_edges_as_walls(const Triangulated& of,
                                           const std::vector<PolygonLines>& faces) {
  std::set<Simplex> edges;
  for (const PolygonLines& face : faces) {
    for (const Simplex& edge : edges_of(face)) edges.insert(edge);
  }
  return {of.points, {edges.begin(), edges.end()}, {}, {}};
}

TEST_CASE("a face covers what an odd number of its rings enclose") {
  CHECK(holds("rings about triangles", 150, [] {
    const Triangulated of = any_triangulated(2);
    Dice dice = any_dice();
    std::vector<PolygonLines> faces(1 + dice.below(3));
    std::vector<bool> is_covered(of.cells.size(), false);
    for (PolygonLines& face : faces) {
      for (std::size_t i = 0; i < of.cells.size(); ++i) {
        const std::size_t times = dice.below(3);
        if (times == 1) is_covered[i] = true;
        for (std::size_t k = 0; k < times; ++k) face.lines.push_back(of.cells[i]);
      }
      if (face.lines.empty()) face.lines.push_back({0});
    }
    const PiecewiseLinearComplex complex = with_edges_as_walls(of, faces);
    RC_PRE(!complex.segments.empty());
    assert_inside(of, complex, points_without_rings(faces, Regions(complex)),
                  [&](std::size_t i) { return is_covered[i]; });
  }));
}

// The vertices around an inner vertex, counterclockwise; none if it is not inside.
std::vector<Vertex> ring_about(const Triangulated& of, Vertex v) {
  std::map<Vertex, Vertex> next;
  for (const Simplex& cell : of.cells) {
    const auto at = static_cast<std::size_t>(std::find(cell.begin(), cell.end(), v) - cell.begin());
    if (at < 3) next[cell[(at + 1) % 3]] = cell[(at + 2) % 3];
  }
  if (next.empty()) return {};
  std::vector<Vertex> ring = {next.begin()->first};
  while (next.contains(ring.back()) && ring.size() <= next.size()) {
    ring.push_back(next.at(ring.back()));
  }
  const bool is_closed = ring.size() == next.size() + 1 && ring.front() == ring.back();
  ring.pop_back();
  return is_closed ? ring : std::vector<Vertex>();
}

// A face of one line, whichever way about, or of a line about a vertex less one or more of the
// triangles there; and triangles elsewhere.
TEST_CASE("a face covers what its line encloses, less its holes") {
  std::size_t with_holes = 0, without = 0;
  CHECK(holds("triangles and what is about a vertex", 200, [&] {
    const Triangulated of = any_triangulated(2);
    Dice dice = any_dice();
    const auto v = static_cast<Vertex>(dice.below(of.points.size()));
    const std::vector<Vertex> ring = ring_about(of, v);
    const auto turned = [&](std::vector<Vertex> line) {
      if (dice.below(2) == 0) std::reverse(line.begin(), line.end());
      return line;
    };
    std::vector<PolygonLines> faces;
    std::vector<bool> is_covered(of.cells.size(), false);
    if (!ring.empty()) faces.push_back({{turned(ring)}, {}});
    const bool has_holes = dice.below(2) == 0;
    for (std::size_t i = 0; i < of.cells.size(); ++i) {
      const bool is_about = !ring.empty() && contains(of.cells[i], v);
      is_covered[i] = dice.below(2) == 0 || (is_about && !has_holes);
      if (is_about && !is_covered[i]) {
        faces.front().lines.push_back(turned(of.cells[i]));
        faces.front().hole_seeds.push_back(of.middle(i));
      } else if (!is_about && is_covered[i]) {
        faces.push_back({{turned(of.cells[i])}, {}});
      }
    }
    RC_PRE(!faces.empty());
    const bool holed = !faces.front().hole_seeds.empty();
    ++(holed ? with_holes : without);
    const PiecewiseLinearComplex complex = with_edges_as_walls(of, faces);
    assert_inside(of, complex, points_without_face(faces, Regions(complex), of.points),
                  [&](std::size_t i) { return is_covered[i]; });
  }));
  CHECK(occurs(with_holes, 5));
  CHECK(occurs(without, 5));
}

}  // namespace
}  // namespace circumspect::properties
