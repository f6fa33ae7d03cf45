// C8: segment recovery, Steiner CDTs and conforming Delaunay triangulations.
// Book: Section 4.5.3, Definitions 4.5 and 4.7, Exercise 6 of Chapter 4.
#include <algorithm>
#include <map>
#include <set>

#include <doctest/doctest.h>

#include "construct/edge_protection.hpp"
#include "inputs/in_doubles.hpp"
#include "kernel/complex/circumball.hpp"
#include "kernel/complex/measure.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/predicates/orientation.hpp"
#include "properties/arguments/complexes.hpp"
#include "properties/arguments/run.hpp"
#include "properties/constrained_delaunay.hpp"
#include "reference/constrained/conforming_delaunay.hpp"
#include "reference/constrained/edge_protection.hpp"
#include "reference/constrained/steiner_cdt.hpp"

namespace circumspect::properties {
namespace {

using constrained::canonical_delaunay;
using constrained::CdtAlgorithm;
using constrained::conforming_delaunay;
using constrained::edge_protection;
using constrained::is_edge_protected;
using constrained::is_edge_protected_under_perturbation;
using constrained::PlcTriangulation;
using constrained::PointOnSegment;
using constrained::recover_segments;
using constrained::RecoveredSegments;
using constrained::SegmentProtection;
using constrained::steiner_cdt;
using constrained::SteinerCdt;
using delaunay::Delaunayhood;
using generators::ComplexCase;

// Segments that meet in one vertex at small angles, with vertices beside them.
rc::Gen<ComplexCase> fans(std::size_t dimension) {
  return rc::gen::exec([dimension] {
    const int spread = *rc::gen::element(1, 2, 4);
    const int far = *rc::gen::element(3, 30, 300);
    const auto random_point = [&] {
      Point point = {Rational(*rc::gen::inRange(1, far + 1))};
      while (point.size() < dimension) point.emplace_back(*rc::gen::inRange(-spread, spread + 1));
      return point;
    };
    ComplexCase fan{"fan", {}};
    fan.input.kind = DomainKind::kHull;
    fan.input.points = {Point(dimension, Rational(0))};
    std::set<Point> directions;
    for (int i = *rc::gen::inRange(2, 8); i > 0; --i) {
      const Point end = random_point();
      if (!directions.insert(1 / end[0] * end).second) continue;
      fan.input.segments.push_back({0, static_cast<Vertex>(fan.input.points.size())});
      fan.input.points.push_back(end);
    }
    for (int i = *rc::gen::inRange(0, 8); i > 0; --i) {
      const Point beside = (Rational(*rc::gen::inRange(1, 9)) / 9) * random_point();
      if (!directions.insert(1 / beside[0] * beside).second) continue;
      fan.input.points.push_back(beside);
    }
    return fan;
  });
}

// Coordinates of a few dozen bits. The number of points that are added grows with the logarithm of
// the ratio between the largest and the least distance: 600 or so halvings where doubles of all
// magnitudes meet, which is as right as it is slow. No hole seeds in hulls, which may lie in a
// facet of the hull that is not a polygon.
bool is_moderate(const ComplexCase& one) {
  if (one.input.kind == DomainKind::kHull && !one.input.hole_seeds.empty()) return false;
  return std::all_of(one.input.points.begin(), one.input.points.end(), [](const Point& point) {
    return std::all_of(point.begin(), point.end(), [](const Rational& x) {
      return bit_length(x.get_num()) <= 40 && bit_length(x.get_den()) <= 40;
    });
  });
}

rc::Gen<ComplexCase> small_complexes() {
  return rc::gen::suchThat(
      rc::gen::weightedOneOf<ComplexCase>({{4, generators::any_complex(9)}, {1, fans(3)}}),
      is_moderate);
}

rc::Gen<ComplexCase> small_planar_complexes() {
  return rc::gen::suchThat(
      rc::gen::weightedOneOf<ComplexCase>({{2, generators::planar_complexes(9)}, {1, fans(2)}}),
      is_moderate);
}

// Each segment is the union of the pieces between the vertices that were added to it, in order.
void assert_pieces(const PiecewiseLinearComplex& complex, const PiecewiseLinearComplex& augmented,
                   const std::vector<PointOnSegment>& added) {
  std::vector<std::map<Rational, Vertex>> stops;
  for (const Simplex& segment : complex.segments)
    stops.push_back({{0, segment[0]}, {1, segment[1]}});
  for (const PointOnSegment& point : added) {
    const Simplex& segment = complex.segments[point.segment];
    const Point along = complex.points[segment[1]] - complex.points[segment[0]];
    RC_ASSERT(point.parameter > 0);
    RC_ASSERT(point.parameter < 1);
    RC_ASSERT(augmented.points[point.vertex] ==
              complex.points[segment[0]] + point.parameter * along);
    RC_ASSERT(stops[point.segment].emplace(point.parameter, point.vertex).second);
  }
  std::set<Simplex> pieces;
  for (const auto& along_one : stops) {
    for (auto stop = along_one.begin(); std::next(stop) != along_one.end(); ++stop) {
      pieces.insert(sorted({stop->second, std::next(stop)->second}));
    }
  }
  RC_ASSERT(std::vector<Simplex>(pieces.begin(), pieces.end()) == augmented.segments);
}

// By linear programs over all points.
bool is_protected_by_definition(const PiecewiseLinearComplex& complex) {
  return std::all_of(complex.segments.begin(), complex.segments.end(), [&](const Simplex& segment) {
    return delaunay::is_strongly_delaunay(complex.points, segment);
  });
}

Rational volume(const PointSet& points, const std::vector<Simplex>& simplices) {
  return measure(points, points.configuration().axes(), simplices);
}

// The augmented complex has the old polygons, with all of their vertices.
void assert_same_polygons(const PiecewiseLinearComplex& complex,
                          const PiecewiseLinearComplex& augmented) {
  RC_ASSERT(augmented.polygons.size() == complex.polygons.size());
  for (std::size_t i = 0; i < complex.polygons.size(); ++i) {
    const Polygon& before = complex.polygons[i];
    const Polygon& after = augmented.polygons[i];
    RC_ASSERT(measure(augmented.points, after.axes, after.triangles) ==
              measure(complex.points, before.axes, before.triangles));
    RC_ASSERT(std::includes(after.vertices.begin(), after.vertices.end(), before.vertices.begin(),
                            before.vertices.end()));
    for (const Simplex& segment : after.segments) {
      const bool is_segment =
          std::binary_search(augmented.segments.begin(), augmented.segments.end(), segment);
      RC_ASSERT(is_segment);
    }
  }
}

// A triangulation of the augmented complex: every piece of a segment is an edge of it, every
// polygon as large as the triangles in it, every vertex there. (That it is a complex, the tests of
// the constructions see to.)
void assert_conforms(const PiecewiseLinearComplex& complex, const PlcTriangulation& triangulation) {
  std::set<Simplex> faces;
  for (const Simplex& simplex : triangulation.simplices_and_dangling()) {
    for (const Simplex& face : circumspect::faces(simplex)) faces.insert(face);
  }
  for (Vertex v = 0; complex.points.names(v); ++v) RC_ASSERT(faces.contains({v}));
  for (const Simplex& segment : complex.segments) RC_ASSERT(faces.contains(segment));
  for (const Polygon& polygon : complex.polygons) {
    std::vector<Simplex> included;
    for (const Simplex& face : faces) {
      if (face.size() == 3 && is_included(complex.points, face, polygon)) included.push_back(face);
    }
    RC_ASSERT(measure(complex.points, polygon.axes, included) ==
              measure(complex.points, polygon.axes, polygon.triangles));
  }
}

bool are_all_delaunay(const PointSet& points, const PlcTriangulation& triangulation) {
  const std::vector<Simplex> all = triangulation.simplices_and_dangling();
  return std::all_of(all.begin(), all.end(), [&](const Simplex& simplex) {
    return delaunay::is_delaunay(points, simplex);
  });
}

TEST_CASE("C8 the canonical triangulation tells which segments are (strongly) Delaunay") {
  CHECK(holds("edge protection", 60, [] {
    const bool in_plane = *rc::gen::arbitrary<bool>();
    const ComplexCase one = in_plane ? *small_planar_complexes() : *small_complexes();
    const PointSet points(one.input.points);
    const StarIndex canonical = canonical_delaunay(points);
    const std::vector<Simplex> pairs = faces(all_vertices(points), 2);
    for (const SegmentProtection& found : edge_protection(points, canonical, pairs)) {
      const auto expected = delaunay::delaunayhood(points, found.segment);
      RC_ASSERT(found.status.delaunayhood == expected.delaunayhood);
      if (expected.delaunayhood == Delaunayhood::kStronglyDelaunay) RC_ASSERT(found.is_present);
      if (found.is_present) RC_ASSERT(expected.delaunayhood != Delaunayhood::kNotDelaunay);
      RC_ASSERT(found.status.ball.has_value() == expected.ball.has_value());
      const int least = found.status.obstruction ? 0 : 1;
      for (Vertex q = 0; found.status.ball && points.names(q); ++q) {
        const int where = sign(power(points, *found.status.ball, q));
        const bool is_right = contains(found.segment, q) ? where == 0 : where >= least;
        RC_ASSERT(is_right);
      }
      if (!found.status.obstruction) continue;
      const delaunay::Obstruction& why = *found.status.obstruction;
      Point mean(points.ambient_dimension(), Rational(0));
      Rational sum = 0;
      Rational mean_power = 0;
      const Ball diametral = circumball(points, found.segment);
      for (std::size_t i = 0; i < why.points.size(); ++i) {
        RC_ASSERT(why.coefficients[i] > 0);
        RC_ASSERT_FALSE(contains(found.segment, why.points[i]));
        sum += why.coefficients[i];
        mean = mean + why.coefficients[i] * points[why.points[i]];
        mean_power += why.coefficients[i] * power(points, diametral, why.points[i]);
      }
      RC_ASSERT(sum == 1);
      RC_ASSERT(mean_power == why.power);
      const Point& a = points[found.segment[0]];
      const Point& b = points[found.segment[1]];
      const Rational along = inner_product(mean - a, b - a) / squared_distance(a, b);
      RC_ASSERT(mean == a + along * (b - a));
    }
  }));
}

TEST_CASE("C8 the fast construction tells the same of all segments") {
  std::size_t strong = 0, weak = 0, missing = 0;
  CHECK(holds("edge protection", 150, [&] {
    const bool in_plane = *rc::gen::arbitrary<bool>();
    const ComplexCase one = in_plane ? *small_planar_complexes() : *small_complexes();
    const PointSet points(generators::in_doubles(generators::PointsCase{one.input.points}).points);
    const std::vector<Simplex> pairs = faces(all_vertices(points), 2);
    const PiecewiseLinearComplex complex{points, pairs, {}, {}, DomainKind::kHull};
    const construct::EdgeProtection protection(complex);
    const auto facts = protection.segments();
    const auto expected = edge_protection(complex);
    RC_ASSERT(protection.holds_under_perturbation() ==
              constrained::is_edge_protected_under_perturbation(expected));
    RC_ASSERT(facts.size() == expected.size());
    for (std::size_t i = 0; i < facts.size(); ++i) {
      RC_ASSERT(facts[i].segment == expected[i].segment);
      RC_ASSERT(facts[i].is_present == expected[i].is_present);
      RC_ASSERT(facts[i].delaunayhood == expected[i].status.delaunayhood);
      RC_ASSERT(facts[i].encroaching == constrained::encroaching_vertex(points, expected[i]));
      ++(!facts[i].is_present ? missing : facts[i].is_strong() ? strong : weak);
    }
  }));
  CHECK(occurs(strong, 100));
  CHECK(occurs(weak, 100));
  CHECK(occurs(missing, 100));
}

TEST_CASE("C8 segment recovery makes any complex edge-protected in both readings") {
  std::size_t split = 0;
  CHECK(holds("segment recovery", 100, [&] {
    const bool in_plane = *rc::gen::arbitrary<bool>();
    const ComplexCase one = in_plane ? *small_planar_complexes() : *small_complexes();
    const PiecewiseLinearComplex complex = one.complex();
    const RecoveredSegments recovered = recover_segments(complex);
    const PiecewiseLinearComplex& augmented = recovered.complex;
    RC_ASSERT(is_protected_by_definition(augmented));
    RC_ASSERT(is_edge_protected(augmented));
    RC_ASSERT(is_edge_protected_under_perturbation(augmented));
    RC_ASSERT(recovered.steiner_points.empty() == is_protected_by_definition(complex));
    assert_pieces(complex, augmented, recovered.steiner_points);
    assert_same_polygons(complex, augmented);
    split += recovered.steiner_points.empty() ? 0 : 1;
  }));
  CHECK(occurs(split));
}

TEST_CASE(
    "C8 a Steiner CDT: locally Delaunay except in polygons, Steiner points on segments only") {
  std::size_t split = 0;
  CHECK(holds("steiner CDT", 60, [&] {
    const ComplexCase one = *small_complexes();
    const PiecewiseLinearComplex complex = one.complex();
    const SteinerCdt answer = steiner_cdt(complex);
    const PiecewiseLinearComplex& augmented = answer.complex;
    const auto other =
        *rc::gen::element(CdtAlgorithm::kGiftWrapping, CdtAlgorithm::kPolygonCavities);
    RC_ASSERT(steiner_cdt(complex, other).triangulation == answer.triangulation);
    assert_pieces(complex, augmented, answer.steiner_points);
    RC_ASSERT(augmented.points.size() == complex.points.size() + answer.steiner_points.size());
    assert_conforms(augmented, answer.triangulation);
    if (augmented.points.dimension() == 3) {
      const Regions regions(augmented);
      RC_ASSERT(
          free_facets_are_locally_delaunay(augmented, regions, answer.triangulation.simplices));
    }
    split += answer.steiner_points.empty() ? 0 : 1;
  }));
  CHECK(occurs(split));
}

TEST_CASE("C8 conforming Delaunay triangulations are Delaunay and conform") {
  std::size_t in_polygons = 0;
  CHECK(holds("conforming Delaunay", 60, [&] {
    const ComplexCase one = *small_complexes();
    const PiecewiseLinearComplex complex = one.complex();
    const auto answer = conforming_delaunay(complex, 60);
    if (!answer) return;  // the limit is reached
    const PointSet& points = answer->complex.points;
    assert_pieces(complex, answer->complex, answer->on_segments);
    assert_same_polygons(complex, answer->complex);
    for (const auto& point : answer->in_polygons) {
      const Polygon& polygon = complex.polygons[point.polygon];
      const bool is_in =
          std::any_of(polygon.triangles.begin(), polygon.triangles.end(), [&](const Simplex& part) {
            return !intersection({points[point.vertex]}, coordinates(complex.points, part)).empty();
          });
      RC_ASSERT(is_in);
    }
    RC_ASSERT(points.size() ==
              complex.points.size() + answer->on_segments.size() + answer->in_polygons.size());
    assert_conforms(answer->complex, answer->triangulation);
    RC_ASSERT(are_all_delaunay(points, answer->triangulation));
    const SteinerCdt cdt = steiner_cdt(complex);
    RC_ASSERT(volume(points, answer->triangulation.simplices) ==
              volume(cdt.complex.points, cdt.triangulation.simplices));
    in_polygons += answer->in_polygons.empty() ? 0 : 1;
  }));
  CHECK(occurs(in_polygons));
}

TEST_CASE("C8 in the plane, conforming Delaunay triangulations always exist") {
  CHECK(holds("conforming Delaunay in the plane", 60, [] {
    const ComplexCase one = *small_planar_complexes();
    const PiecewiseLinearComplex complex = one.complex();
    const auto answer = conforming_delaunay(complex, 100000);
    RC_ASSERT(answer.has_value());
    RC_ASSERT(answer->in_polygons.empty());
    assert_pieces(complex, answer->complex, answer->on_segments);
    assert_conforms(answer->complex, answer->triangulation);
    RC_ASSERT(are_all_delaunay(answer->complex.points, answer->triangulation));
    const SteinerCdt cdt = steiner_cdt(complex);
    RC_ASSERT(cdt.steiner_points.empty());
    RC_ASSERT(volume(answer->complex.points, answer->triangulation.simplices) ==
              volume(cdt.complex.points, cdt.triangulation.simplices));
  }));
}

}  // namespace
}  // namespace circumspect::properties
