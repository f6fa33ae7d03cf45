// C9: a vertex is inserted into a CDT, or it is said why not and nothing has changed; deletion
// undoes insertion, of vertices and of polygons. Book: Sections 5.6 and 5.7.
#include <algorithm>
#include <map>

#include <doctest/doctest.h>

#include "inputs/triangulated/protected_complexes.hpp"
#include "kernel/predicates/intersection.hpp"
#include "properties/arguments/complexes.hpp"
#include "properties/arguments/generated.hpp"
#include "properties/arguments/run.hpp"
#include "reference/constrained/cavity.hpp"
#include "reference/constrained/cdt_by_polygon_insertion.hpp"
#include "reference/constrained/evolving_cdt.hpp"
#include "reference/constrained/flip_insert_polygon.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/constrained/plc_triangulation.hpp"
#include "reference/constrained/vertex_in_cdt.hpp"

namespace circumspect::properties {
namespace {

using constrained::EvolvingCdt;
using constrained::WhyNoChange;
using generators::ComplexCase;

// A complex of Delaunay edges, for more to be added to.
rc::Gen<ComplexCase> scaffolds() {
  return generators::generated([](generators::Dice& dice) {
    return protected_polygons(dice, generators::any_points(dice, 3, {12}));
  });
}

// The mean of two to four of the points: on edges and polygons often, and never an extreme point;
// again if it is one of the points.
Point new_point(const std::vector<Point>& points) {
  for (;;) {
    std::vector<Point> some;
    for (long count = 2 + *generators::below(3); count > 0; --count) {
      const long v = *generators::below(static_cast<long>(points.size()));
      some.push_back(points[static_cast<std::size_t>(v)]);
    }
    const Point mean = barycentre(some);
    if (std::find(points.begin(), points.end(), mean) == points.end()) return mean;
  }
}

// The input with one point more, which parts the segments it lies in.
PiecewiseLinearInput with_point(PiecewiseLinearInput input, const Point& point) {
  const auto v = static_cast<Vertex>(input.points.size());
  const auto holds_point = [&](Vertex a, Vertex b) {
    const auto at = [&](Vertex u) { return input.points[static_cast<std::size_t>(u)]; };
    return a != b && !intersection({at(a), at(b)}, {point}).empty();
  };
  std::vector<std::vector<Vertex>> segments;
  for (const auto& segment : input.segments) {
    if (holds_point(segment[0], segment[1])) {
      segments.push_back({segment[0], v});
      segments.push_back({v, segment[1]});
    } else {
      segments.push_back(segment);
    }
  }
  for (PolygonLines& polygon : input.polygons) {
    for (auto& line : polygon.lines) {
      std::vector<Vertex> longer;
      for (std::size_t i = 0; i < line.size(); ++i) {
        longer.push_back(line[i]);
        if (holds_point(line[i], line[(i + 1) % line.size()])) longer.push_back(v);
      }
      line = longer;
    }
  }
  input.segments = segments;
  input.points.push_back(point);
  return input;
}

TEST_CASE("C9 a vertex is inserted iff that leaves a CDT, and deletion undoes it (Section 5.7)") {
  std::map<WhyNoChange, std::size_t> refused;
  std::size_t inserted = 0, in_polygon = 0, in_segment = 0;
  CHECK(holds("vertex insertion", 400, [&] {
    ComplexCase base = *scaffolds();
    const PiecewiseLinearComplex complex = base.complex();
    if (complex.points.dimension() < 3) return;
    ComplexCase more = base;
    more.input = with_point(base.input, new_point(base.input.points));
    const PiecewiseLinearComplex larger = more.complex();
    const Vertex v = static_cast<Vertex>(complex.points.size());

    const EvolvingCdt before = constrained::hull_cdt_by_polygon_insertion(complex).value();
    EvolvingCdt cdt = before;
    const auto wrong = constrained::insert_vertex(larger.points, cdt, v);
    const auto wrapped = constrained::gift_wrapping_cdt(larger);
    RC_ASSERT(!wrong == wrapped.has_value());
    if (wrong) {
      RC_ASSERT(cdt == before);
      ++refused[wrong->why];
      return;
    }
    RC_ASSERT(constrained::carve(larger, cdt) == *wrapped);
    ++inserted;
    in_segment += larger.segments.size() > complex.segments.size() ? 1u : 0u;
    in_polygon += std::any_of(larger.polygons.begin(), larger.polygons.end(),
                              [&](const Polygon& polygon) { return contains(polygon.vertices, v); })
                      ? 1u
                      : 0u;
    RC_ASSERT(!constrained::delete_vertex(larger.points, cdt, v));
    RC_ASSERT(cdt == before);
  }));
  CHECK(occurs(inserted, 31));
  CHECK(occurs(in_polygon));
  CHECK(occurs(in_segment));
  // The two signs of the book, one of them for segments and for polygons; and a third: the cavity
  // is star-shaped and empty, but not all of its new facets are locally Delaunay.
  CHECK(occurs(refused[WhyNoChange::kNotStarShaped]));
  CHECK(occurs(refused[WhyNoChange::kSegmentInCavity]));
  CHECK(occurs(refused[WhyNoChange::kPolygonInCavity]));
}

TEST_CASE("C9 deleting the polygons one by one ends in the Delaunay triangulation (Section 5.6)") {
  std::size_t changed = 0;
  CHECK(holds("polygon deletion", 200, [&] {
    const ComplexCase base = *scaffolds();
    const PiecewiseLinearComplex complex = base.complex();
    if (complex.points.dimension() < 3) return;
    EvolvingCdt cdt = constrained::hull_cdt_by_polygon_insertion(complex).value();
    std::vector<Polygon> left = complex.polygons;
    while (!left.empty()) {
      const auto place = left.begin() + *generators::below(static_cast<long>(left.size()));
      const EvolvingCdt before = cdt;
      RC_ASSERT(!constrained::delete_polygon(complex.points, cdt, *place));
      changed += cdt.tetrahedra.simplices() != before.tetrahedra.simplices() ? 1u : 0u;
      EvolvingCdt again = cdt;
      RC_ASSERT(constrained::flip_insert_polygon(complex.points, again, *place).has_value());
      RC_ASSERT(again == before);
      left.erase(place);
    }
    EvolvingCdt delaunay = constrained::evolving_delaunay(complex.points);
    delaunay.segments = cdt.segments;
    RC_ASSERT(cdt == delaunay);
  }));
  CHECK(occurs(changed, 21));
}

}  // namespace
}  // namespace circumspect::properties
