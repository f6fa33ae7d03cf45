// C3, C7, C9: CDTs that change. Book: Sections 5.6 to 5.8.
#include <algorithm>
#include <map>
#include <optional>

#include <doctest/doctest.h>

#include "inputs/triangulated/protected_complexes.hpp"
#include "kernel/predicates/intersection.hpp"
#include "properties/arguments/complexes.hpp"
#include "properties/arguments/generated.hpp"
#include "properties/arguments/run.hpp"
#include "reference/constrained/cavity.hpp"
#include "reference/constrained/cdt_by_polygon_insertion.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/constrained/plc_triangulation.hpp"
#include "reference/constrained/vertex_in_cdt.hpp"

namespace circumspect::properties {
namespace {

// ---- polygon insertion ----
// C3, C7: polygon insertion, by flips in any order and by cavities, makes one CDT, the one that
// gift-wrapping makes; flips keep within their bounds. Book: Sections 5.6 and 5.8.

using constrained::EvolvingCdt;
using constrained::PlcTriangulation;
using constrained::PolygonFlips;
using constrained::PolygonInsertion;
using generators::ComplexCase;

std::vector<std::size_t> order_of_polygons(std::size_t count) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < count; ++i) {
    const long place = *generators::below(static_cast<long>(i + 1));
    order.insert(order.begin() + place, i);
  }
  return order;
}

std::set<Simplex> difference(const std::set<Simplex>& a, const std::set<Simplex>& b) {
  std::set<Simplex> only_a;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::inserter(only_a, only_a.end()));
  return only_a;
}

// Proposition 5.5, and that no edge ever returns, not even in a later insertion (Proposition 5.6).
class Bounds {
 public:
  void check(const PolygonFlips& run) {
    const bool is_bounded = run.flips.empty() || run.flips.size() < run.vertices * run.vertices;
    RC_ASSERT(is_bounded);
    RC_ASSERT(run.held_back == 0u);
    for (std::size_t i = 0; i < run.flips.size(); ++i) {
      const constrained::TimedFlip& flip = run.flips[i];
      RC_ASSERT(sign(flip.time.standard) >= 0);
      if (i > 0) RC_ASSERT(run.flips[i - 1].time < flip.time);
      const std::set<Simplex> before = constrained::edges_of(flip.flip.deleted);
      const std::set<Simplex> after = constrained::edges_of(flip.flip.created);
      for (const Simplex& edge : difference(after, before)) RC_ASSERT(!gone_.contains(edge));
      gone_.merge(difference(before, after));
    }
    flips_ += run.flips.size();
  }
  std::size_t flips() const { return flips_; }

 private:
  std::set<Simplex> gone_;
  std::size_t flips_ = 0;
};

TEST_CASE("C3 C7 polygon insertion in any order and gift-wrapping make one CDT (Prop. 4.12)") {
  std::size_t flips = 0;
  CHECK(holds("polygon insertion", 250, [&] {
    const ComplexCase generated = *any_protected_complex(12);
    const PiecewiseLinearComplex complex = generated.complex();
    constrained::PolygonInsertionOptions options;
    Bounds bounds;
    std::vector<PolygonFlips> runs;
    const auto as_given = constrained::cdt_by_polygon_insertion(complex, options, &runs);
    RC_ASSERT(as_given.has_value());
    for (const PolygonFlips& run : runs) bounds.check(run);
    flips += bounds.flips();
    options.order = order_of_polygons(complex.polygons.size());
    RC_ASSERT(constrained::cdt_by_polygon_insertion(complex, options).value() == *as_given);
    options.by = PolygonInsertion::kCavities;
    RC_ASSERT(constrained::cdt_by_polygon_insertion(complex, options).value() == *as_given);
    RC_ASSERT(constrained::gift_wrapping_cdt(complex).value() == *as_given);
  }));
  CHECK(occurs(flips, 101));
}

// The input without one of its polygons, whose segments stay.
PiecewiseLinearInput without_polygon(PiecewiseLinearInput input, std::size_t place) {
  const auto polygon = input.polygons.begin() + static_cast<std::ptrdiff_t>(place);
  for (const auto& line : polygon->lines) {
    for (std::size_t i = 0; i < line.size() && line.size() > 1; ++i) {
      input.segments.push_back({line[i], line[(i + 1) % line.size()]});
    }
  }
  input.polygons.erase(polygon);
  return input;
}

// A complex of Delaunay edges, for more to be added to.
rc::Gen<ComplexCase> scaffolds() {
  return generators::generated([](generators::Dice& dice) {
    return protected_polygons(dice, generators::any_points(dice, 3, {12}));
  });
}

// Inserts a polygon into the CDT of all the others, if there is one, both ways. Says whether the
// whole has a CDT; nothing if the others have none.
std::optional<bool> insert_into_others(const PiecewiseLinearInput& whole, std::size_t place) {
  const PiecewiseLinearComplex others = assemble(without_polygon(whole, place));
  const auto before = constrained::gift_wrapping_cdt(others);
  if (!before) return std::nullopt;
  const PiecewiseLinearComplex complex = assemble(whole);
  const Polygon& polygon = complex.polygons[place];
  const auto after = constrained::gift_wrapping_cdt(complex);
  const EvolvingCdt start = constrained::evolving_cdt(others, *before);
  const EvolvingCdt expected = after ? constrained::evolving_cdt(complex, *after) : start;

  EvolvingCdt by_cavity = start;
  const auto wrong = constrained::insert_polygon_by_cavity(complex.points, by_cavity, polygon);
  RC_ASSERT(!wrong == after.has_value());
  RC_ASSERT(by_cavity == expected);
  EvolvingCdt by_flips = start;
  const auto run = constrained::flip_insert_polygon(complex.points, by_flips, polygon);
  RC_ASSERT(run.has_value() == after.has_value());
  RC_ASSERT(by_flips == expected);
  return after.has_value();
}

TEST_CASE(
    "C3 a polygon is inserted iff that leaves a CDT, segments Delaunay or not (Section 5.8)") {
  std::size_t inserted = 0;
  CHECK(holds("any polygon", 300, [&] {
    ComplexCase whole = *generators::any_complex(10);
    whole.input.kind = DomainKind::kHull;
    whole.input.hole_seeds.clear();
    if (PointSet(whole.input.points).dimension() < 3) return;
    for (std::size_t place = 0; place < whole.input.polygons.size(); ++place) {
      if (insert_into_others(whole.input, place)) ++inserted;
    }
  }));
  CHECK(occurs(inserted, 51));
}

// ---- vertex in CDT ----
// C9: a vertex is inserted into a CDT, or it is said why not and nothing has changed; deletion
// undoes insertion, of vertices and of polygons. Book: Sections 5.6 and 5.7.

using constrained::WhyNoChange;

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
