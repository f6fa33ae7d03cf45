// Constrained Delaunay triangulations in the plane. Book: Sections 3.10, 3.11, 4.5 and 5.6.
#include <algorithm>
#include <set>

#include <doctest/doctest.h>

#include "kernel/complex/circumball.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/complex/triangulation.hpp"
#include "kernel/piecewise_linear/visibility.hpp"
#include "kernel/predicates/intersection.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/perturbation.hpp"
#include "properties/arguments/complexes.hpp"
#include "properties/arguments/generated.hpp"
#include "properties/arguments/run.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/constrained/planar_cdt.hpp"

namespace circumspect::properties {
namespace {

using constrained::planar_cdt;
using constrained::PlanarAlgorithm;
using constrained::PlcTriangulation;

const std::vector<std::size_t> kPlane = {0, 1};

// Do two segments, as sets of points, meet in nothing but a shared end?
bool is_compatible(const PointSet& points, const Simplex& a, const Simplex& b) {
  const std::vector<Point> common = intersection(coordinates(points, a), coordinates(points, b));
  if (common.size() != 1) return common.empty();
  const auto is_end = [&](Vertex v) { return points[v] == common.front(); };
  return std::any_of(a.begin(), a.end(), is_end) && std::any_of(b.begin(), b.end(), is_end);
}

// Points of a small grid, many of them collinear and cocircular, and segments that keep clear of
// the other vertices and of one another.
rc::Gen<PiecewiseLinearInput> planar_inputs() {
  return rc::gen::exec([] {
    const long width = 2 + *generators::below(7);
    const auto along = generators::below(width);
    const long size = 1 + *generators::below(std::min(18L, width * width - 1));
    std::set<Point> places;
    for (long i = 0; i < size; ++i) places.insert({Rational(*along), Rational(*along)});
    PiecewiseLinearInput input;
    input.points.assign(places.begin(), places.end());
    const PointSet points(input.points);
    const auto vertex = generators::below(static_cast<long>(points.size()));
    const long tries = *generators::below(50);
    for (long i = 0; i < tries; ++i) {
      const Vertex a = *vertex, b = *vertex;
      if (a == b) continue;
      const Simplex segment = sorted({a, b});
      bool is_valid = true;
      for (const Vertex v : all_vertices(points)) {
        is_valid = is_valid && (contains(segment, v) || is_compatible(points, segment, {v}));
      }
      for (const Simplex& other : input.segments) {
        is_valid = is_valid && is_compatible(points, segment, other);
      }
      if (is_valid) input.segments.push_back(segment);
    }
    if (*generators::below(2) == 1) input.kind = DomainKind::kHull;
    return input;
  });
}

bool is_edge(const PlcTriangulation& cdt, const Simplex& edge) {
  const auto has = [&](const Simplex& simplex) {
    return std::includes(simplex.begin(), simplex.end(), edge.begin(), edge.end());
  };
  return std::any_of(cdt.simplices.begin(), cdt.simplices.end(), has) ||
         std::find(cdt.dangling.begin(), cdt.dangling.end(), edge) != cdt.dangling.end();
}

Rational doubled_area(const PointSet& points, const std::vector<Simplex>& triangles) {
  Rational area = 0;
  for (const Simplex& triangle : triangles) {
    const Rational part = orientation_determinant(points.configuration(), kPlane, triangle);
    area += sign(part) * part;
  }
  return area;
}

TEST_CASE(
    "planar CDT: gift-wrapping and segment insertion agree; every vertex and segment is there") {
  CHECK(holds("planar CDT: one answer", 250, [] {
    const bool is_dense = *generators::below(2) == 1;
    const PiecewiseLinearComplex complex =
        is_dense ? assemble(*planar_inputs()) : (*generators::planar_complexes(14)).complex();
    const PlcTriangulation cdt = planar_cdt(complex, PlanarAlgorithm::kGiftWrapping);
    RC_ASSERT(cdt == planar_cdt(complex, PlanarAlgorithm::kSegmentInsertion));
    for (const Simplex& segment : complex.segments) RC_ASSERT(is_edge(cdt, segment));
    for (const Vertex v : all_vertices(complex.points)) {
      const auto has = [&](const Simplex& simplex) { return contains(simplex, v); };
      const bool is_there = std::any_of(cdt.simplices.begin(), cdt.simplices.end(), has) ||
                            std::any_of(cdt.dangling.begin(), cdt.dangling.end(), has);
      RC_ASSERT(is_there);
    }
  }));
}

TEST_CASE("planar CDT: fills the domain, the hull or what the segments enclose") {
  CHECK(holds("planar CDT: the area is that of the domain", 150, [] {
    const PiecewiseLinearComplex complex = assemble(*planar_inputs());
    const PointSet& points = complex.points;
    const std::vector<Simplex> triangles = planar_cdt(complex).simplices;
    Rational area;
    if (complex.kind == DomainKind::kHull) {
      // A fan from one point of the hull to its edges.
      std::vector<Simplex> fan;
      for (const Simplex& edge : constrained::hull_edges(points, kPlane, all_vertices(points))) {
        if (!contains(edge, 0)) fan.push_back({0, edge[0], edge[1]});
      }
      area = doubled_area(points, fan);
    } else {
      area = doubled_area(points, constrained::planar_domain(points, kPlane, all_vertices(points),
                                                             complex.segments, {}, complex.kind)
                                      .triangles);
    }
    RC_ASSERT(doubled_area(points, triangles) == area);
  }));
}

// C1 in the plane (Lemma 4.10): (i) every triangle is constrained Delaunay, from the definition,
// and (iii) every edge that is not a segment is locally Delaunay, under the perturbation.
TEST_CASE("C1: in the plane, every edge that is not a segment is locally Delaunay") {
  CHECK(holds("C1, statement (iii)", 200, [] {
    const PiecewiseLinearComplex complex = assemble(*planar_inputs());
    const Configuration& points = complex.points.configuration();
    const std::vector<Simplex> triangles = planar_cdt(complex).simplices;
    for (const auto& [edge, apexes] : apexes_by_facet(Triangulation(2, triangles))) {
      const auto& segments = complex.segments;
      if (std::find(segments.begin(), segments.end(), edge) != segments.end()) continue;
      // An edge of one triangle only bounds the domain; of the hull kind it may not be a segment.
      const bool is_sound =
          apexes.size() == 2
              ? perturbed_in_ball(points, kPlane, Simplex{edge[0], edge[1], apexes[0]}, apexes[1]) <
                    0
              : complex.kind == DomainKind::kHull;
      RC_ASSERT(is_sound);
    }
  }));
}

// Is the vertex visible from this point of the domain's interior? In a convex domain it is unless a
// segment that it is not an end of, or that leads there from the point, is in between.
bool sees(const PiecewiseLinearComplex& complex, const Point& from, Vertex v) {
  return std::none_of(
      complex.segments.begin(), complex.segments.end(), [&](const Simplex& segment) {
        const auto common =
            intersection({from, complex.points[v]}, coordinates(complex.points, segment));
        return std::any_of(common.begin(), common.end(),
                           [&](const Point& p) { return p != complex.points[v]; });
      });
}

TEST_CASE("C1: in the plane, no ball of a triangle holds a vertex that is visible from inside") {
  CHECK(holds("C1, statement (i)", 150, [] {
    PiecewiseLinearInput input = *planar_inputs();
    input.kind = DomainKind::kHull;
    const PiecewiseLinearComplex complex = assemble(input);
    const PointSet& points = complex.points;
    for (const Simplex& triangle : planar_cdt(complex).simplices) {
      const std::vector<Point> corners = coordinates(points, triangle);
      const Point middle = barycentre(corners);
      const Ball ball = circumball(points, triangle);
      for (const Vertex v : all_vertices(points)) {
        if (contains(triangle, v) || sign(power(points, ball, v)) >= 0) continue;
        // From the middle and from places near the corners and edges.
        RC_ASSERT_FALSE(sees(complex, middle, v));
        for (const Point& corner : corners) {
          RC_ASSERT_FALSE(sees(complex, Rational(1, 9) * middle + Rational(8, 9) * corner, v));
          RC_ASSERT_FALSE(sees(complex, Rational(11, 9) * middle + Rational(-2, 9) * corner, v));
        }
      }
    }
  }));
}

// Proposition 4.11 wants the same triangles of a polygon in whichever plane it lies: its own balls
// count, not those of a projection.
TEST_CASE("planar CDT: in a plane of space that is turned and stretched by rational rotations") {
  CHECK(holds("planar CDT: carried into space", 60, [] {
    PiecewiseLinearInput input = *planar_inputs();
    input.kind = DomainKind::kHull;
    const PiecewiseLinearComplex complex = assemble(input);
    if (complex.points.dimension() < 2) return;
    const std::vector<Simplex> flat = planar_cdt(complex).simplices;
    // x · (1, 2, 2) + y · (2, 1, −2): both of length 3, at right angles. The lexicographic order of
    // the points, and with it the perturbation, is another; so only their areas and radii agree.
    std::vector<Point> carried;
    for (const Point& p : input.points) {
      carried.push_back({p[0] + 2 * p[1], 2 * p[0] + p[1], 2 * p[0] - 2 * p[1]});
    }
    const PointSet points(carried);
    const Polygon polygon =
        constrained::planar_domain(points, flat_through(points, all_vertices(points)).axes,
                                   all_vertices(points), complex.segments, {}, DomainKind::kHull);
    const std::vector<Simplex> turned = planar_cdt(points, polygon);
    RC_ASSERT(turned == planar_cdt(points, polygon, PlanarAlgorithm::kSegmentInsertion));
    const auto radii = [](const PointSet& set, const std::vector<Simplex>& triangles, int scale) {
      std::vector<Rational> squared;
      for (const Simplex& triangle : triangles) {
        squared.push_back(circumball(set, triangle).squared_radius / scale);
      }
      std::sort(squared.begin(), squared.end());
      return squared;
    };
    RC_ASSERT(radii(points, turned, 9) == radii(complex.points, flat, 1));
  }));
}

}  // namespace
}  // namespace circumspect::properties
