#include "oracle/judge/within/hull_walls.hpp"

#include <random>
#include <set>

#include <doctest/doctest.h>

#include "kernel/complex/polytope.hpp"
#include "kernel/piecewise_linear/regions.hpp"
#include "oracle/judge/domain/domain_cases_test.hpp"
#include "oracle/judge/within/hull_faces.hpp"
#include "oracle/judge/within/seen_from_above.hpp"

namespace circumspect::check {

TEST_CASE("a convex hull with a polygon in a face, and one across a face") {
  // The floor has a square in it, from which a segment leads to its boundary; a wall stands on the
  // square.
  PiecewiseLinearInput input = cuboid({0, 0, 0}, {8, 8, 8});
  input.polygons.clear();
  input.kind = DomainKind::kHull;
  for (const Point& point : std::vector<Point>{
           {2, 2, 0}, {4, 2, 0}, {4, 4, 0}, {2, 4, 0}, {2, 0, 0}, {2, 2, 2}, {4, 2, 2}}) {
    input.points.push_back(point);
  }
  input.polygons = {{{{8, 9, 10, 11}}, {}}, {{{8, 9, 14, 13}}, {}}};
  input.segments = {{8, 12}};
  const PiecewiseLinearComplex hull = assemble(input);
  const auto faces = hull_faces(hull.points);
  CHECK(faces == facets_by_definition(hull.points, all_vertices(hull.points)));
  const PiecewiseLinearComplex walled = with_hull_walls(hull, faces);
  // The floor about the square, and five more; the edges, one of them cut.
  CHECK(walled.polygons.size() == 2 + 6);
  CHECK(walled.segments.size() == hull.segments.size() + 13);
  std::size_t with_slit = 0;
  for (std::size_t p = 2; p < walled.polygons.size(); ++p) {
    if (contains(walled.polygons[p].vertices, 8)) ++with_slit;
  }
  CHECK(with_slit == 1);
  CHECK(Regions(walled).size() == 2);
}

TEST_CASE("the faces of a convex hull by going around it and by looking at all planes") {
  std::mt19937_64 random(7);
  for (int round = 0; round < 60; ++round) {
    const std::size_t dimension = round % 3 == 0 ? 2 : 3;
    // Few coordinates: many points of one plane; then many: few.
    const unsigned long most = round % 2 == 0 ? 3 : 1000;
    const bool has_decimals = round % 5 == 0;
    // So far from the origin that doubles are farther from the points than these from each other.
    Rational far = 0;
    if (round % 8 >= 6) far = Rational(30'000'000'000'000'001L, 3L);
    std::set<Point> points;
    for (std::size_t i = 0; i < 5 + random() % 12; ++i) {
      Point point;
      for (std::size_t axis = 0; axis < dimension; ++axis) {
        point.emplace_back(static_cast<long>(random() % most));
        if (has_decimals) point.back() /= 10;
        point.back() += far;
      }
      points.insert(point);
    }
    // All but one nearly, or exactly, in one plane: what doubles do not decide.
    if (round >= 40 && dimension == 3) {
      std::set<Point> flat;
      for (Point p : points) {
        p[2] = 3 * p[0] + 7 * p[1];
        p[2] += Rational(static_cast<long>(random() % 3), 1'000'000'000'000'000'000L);
        p[2] /= 10;
        if (round % 2 == 0) p[2] = exact_value(p[2].get_d());
        flat.insert(p);
      }
      flat.insert({0, 0, 5000});
      points = flat;
    }
    const PointSet set({points.begin(), points.end()});
    if (set.dimension() < static_cast<int>(dimension)) continue;
    CHECK(hull_faces(set) == facets_by_definition(set, all_vertices(set)));
  }
}

// What doubles decide they decide rightly, however near a case is to the other answer.

namespace {

double any_double(std::mt19937_64& random) {
  return static_cast<double>(random() % 2'000'001) / 1'000'003.0 - 1;
}

}  // namespace

TEST_CASE("simplices that are just so far apart are not farther apart") {
  std::mt19937_64 random(1);
  int decided = 0;
  for (int round = 0; round < 400; ++round) {
    // Differences with a rational length; along an axis nothing is given away.
    const std::vector<std::array<long, 4>> lengths = {{3, 4, 0, 5}, {2, 3, 6, 7}, {0, 0, 1, 1}};
    const auto& [x, y, z, length] = lengths[random() % lengths.size()];
    const Rational scale(static_cast<long>(random() % 1000 + 1), round % 2 == 0 ? 1024 : 3);
    const Point a = {exact_value(any_double(random)), exact_value(any_double(random)),
                     exact_value(any_double(random))};
    const Point b = a + scale * Point{x, y, z};
    const std::array<RoundedPoint, 1> one = {rounded(a)};
    const std::array<RoundedPoint, 1> other = {rounded(b)};
    const Rational distance = scale * length;
    CHECK(!certainly_apart(one, other, upper_double(distance)));
    if (certainly_apart(one, other, lower_double(distance) * 0.5)) ++decided;
  }
  CHECK(decided == 400);
}

TEST_CASE("triangles that are nearly seen as lines turn as exact numbers say") {
  std::mt19937_64 random(2);
  int left = 0, right = 0;
  for (int round = 0; round < 300; ++round) {
    PiecewiseLinearInput input;
    for (int i = 0; i < 3; ++i) {
      input.points.push_back({exact_value(any_double(random)), exact_value(any_double(random)),
                              exact_value(any_double(random))});
    }
    input.polygons = {{{{0, 1, 2}}, {}}};
    const PiecewiseLinearComplex complex = assemble(input);
    // Two corners, and a third that is on the line through them but for rounding, or exactly above
    // it.
    const double t = any_double(random);
    Point third;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double from = input.points[0][axis].get_d(), to = input.points[1][axis].get_d();
      third.push_back(exact_value(from + t * (to - from)));
    }
    const Point normal = normal_of(complex, 0);
    if (round % 3 == 0) third = input.points[0] + normal;
    const PointSet points({input.points[0], input.points[1], third});
    const std::vector<RoundedPoint> of_domain = Rounding(input.points).points(input.points);
    const std::vector<RoundedPoint> of_mesh = Rounding(input.points).points(points.points());
    const SeenFromAbove seen(complex, of_domain, 0, points, of_mesh);
    const Point u = points[1] - points[0], v = points[2] - points[0];
    const int turn = sign(inner_product(normal, cross_product(u, v)));
    CHECK(seen.turn({0, 1, 2}) == turn);
    CHECK(seen.turn({1, 0, 2}) == -turn);
    if (round % 3 == 0) CHECK(turn == 0);
    left += turn > 0 ? 1 : 0;
    right += turn < 0 ? 1 : 0;
  }
  CHECK(left > 20);
  CHECK(right > 20);
}

}  // namespace circumspect::check
