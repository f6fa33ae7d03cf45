// Point sets, circumballs of simplices, and simplices that meet properly.
#include "kernel/complex/point_set.hpp"

#include <algorithm>

#include <doctest/doctest.h>

#include "inputs/plain_algebra.hpp"
#include "kernel/complex/circumball.hpp"
#include "kernel/complex/improper_intersection.hpp"
#include "kernel/exact/each_once.hpp"
#include "kernel/predicates/in_ball.hpp"
#include "properties/arguments/generated.hpp"
#include "properties/arguments/laws.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect {

// Point sets, and the duplicates that keep a list of points from being one.

namespace {

using generators::PointsCase;

// Each point that is equal to an earlier one, with the first of those.
std::vector<Duplicate> duplicates_by_definition(const std::vector<Point>& points) {
  std::vector<Duplicate> found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto first = std::find(points.begin(), points.end(), points[i]) - points.begin();
    const auto again = static_cast<Vertex>(i);
    if (first < again) found.push_back({first, again});
  }
  return found;
}

TEST_CASE("duplicates: equal numbers written differently, three of a kind, none at all") {
  const std::vector<Point> points = {{1, 2}, {3, 4}, {Rational(2, 2), 2}, {3, 5}, {1, 2}};
  std::vector<Point> canonical = points;
  for (Point& point : canonical) {
    for (Rational& x : point) x.canonicalize();
  }
  const std::vector<Duplicate> found = duplicates(canonical);
  REQUIRE(found.size() == 2);
  CHECK(found[0].kept == 0);
  CHECK(found[0].again == 2);
  CHECK(found[1].kept == 0);
  CHECK(found[1].again == 4);
  CHECK(duplicates({}).empty());
  CHECK(duplicates({{1, 2}, {2, 1}}).empty());
}

TEST_CASE("duplicates: all of them, each with the first point it repeats, in order") {
  CHECK(properties::holds([] {
    const auto points = *rc::gen::container<std::vector<Point>>(
        rc::gen::container<Point>(2, generators::integer_number(2)));
    const auto expected = duplicates_by_definition(points);
    const auto found = duplicates(points);
    RC_ASSERT(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      RC_ASSERT(found[i].kept == expected[i].kept);
      RC_ASSERT(found[i].again == expected[i].again);
    }
  }));
}

TEST_CASE("point set: it is the points and weights it was given") {
  CHECK(properties::holds([] {
    const auto sets = generators::any_point_set(3, 7);
    const PointsCase set =
        *rc::gen::oneOf(generators::unweighted(sets), generators::weighted(sets));
    const PointSet points(set.points, set.weights);
    RC_ASSERT(points.size() == set.points.size());
    RC_ASSERT(points.empty() == set.points.empty());
    RC_ASSERT(points.is_weighted() == !set.weights.empty());
    RC_ASSERT(points.ambient_dimension() == (set.points.empty() ? 0U : 3U));
    RC_ASSERT(points.dimension() == affine_hull(set.points).dimension);
    RC_ASSERT(!points.names(-1));
    RC_ASSERT(!points.names(static_cast<Vertex>(set.points.size())));
    Simplex all;
    for (std::size_t i = 0; i < set.points.size(); ++i) {
      const auto v = static_cast<Vertex>(i);
      RC_ASSERT(points.names(v));
      RC_ASSERT(points[v] == set.points[i]);
      RC_ASSERT(points.weight(v) == (set.weights.empty() ? Rational(0) : set.weights[i]));
      all.push_back(v);
    }
    RC_ASSERT(coordinates(points, all) == set.points);
  }));
}

const PointSet kPoints({{0, 0, 1}, {2, 0, 1}, {4, 0, 1}, {0, 3, 1}, {0, 0, 5}});

TEST_CASE("flat: a point, a line, a plane, space") {
  CHECK(flat_through(kPoints, {3}).dimension() == 0);
  CHECK(flat_through(kPoints, {3}).basis == Simplex{3});
  const Flat line = flat_through(kPoints, {2, 0, 1});
  CHECK(line.basis == Simplex{2, 0});
  CHECK(line.axes == std::vector<std::size_t>{0});
  const Flat plane = flat_through(kPoints, {0, 1, 2, 3});
  CHECK(plane.basis == Simplex{0, 1, 3});
  CHECK(plane.axes == std::vector<std::size_t>{0, 1});
  CHECK(flat_through(kPoints, all_vertices(kPoints)).basis == Simplex{0, 1, 3, 4});
}

TEST_CASE("flat: of a projection on some axes") {
  const Flat shadow = flat_through(kPoints, {1, 2}, {0, 1, 3, 4});
  CHECK(shadow.basis == Simplex{0, 3, 4});  // 0 and 1 have one shadow
  CHECK(shadow.axes == std::vector<std::size_t>{1, 2});
  CHECK(flat_through(kPoints, {2}, {0, 1, 2, 3}).dimension() == 0);
}

// Circumballs and orthoballs.

using generators::PointsCase;

TEST_CASE("circumball: of a right triangle, an edge, a vertex, a tetrahedron") {
  const PointSet triangle({{0, 0}, {4, 0}, {0, 2}});
  const Ball ball = circumball(triangle, {0, 1, 2});
  CHECK(ball.centre == Point{2, 1});
  CHECK(ball.squared_radius == 5);
  const Ball edge = circumball(triangle, {1, 2});
  CHECK(edge.centre == Point{2, 1});
  const Ball vertex = circumball(triangle, {1});
  CHECK(vertex.centre == Point{4, 0});
  CHECK(vertex.squared_radius == 0);
  const PointSet corner({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const Rational half(1, 2);
  CHECK(circumball(corner, {3, 1, 0, 2}).centre == Point{half, half, half});
  CHECK(circumball(corner, {3, 1, 0, 2}).squared_radius == Rational(3, 4));
}

TEST_CASE("circumball: of a triangle in space, its centre lies in the triangle's plane") {
  const PointSet points({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const Rational third(1, 3);
  CHECK(circumball(points, {0, 1, 2}).centre == Point{third, third, third});
  CHECK(circumball(points, {0, 1, 2}).squared_radius == Rational(2, 3));
}

TEST_CASE("circumball: an orthoball may have a negative squared radius; power") {
  const PointSet points({{0}, {2}, {1}}, {4, 4, -1});
  const Ball ball = circumball(points, {0, 1});
  CHECK(ball.centre == Point{1});
  CHECK(ball.squared_radius == -3);
  CHECK(power(points, ball, 0) == 0);
  CHECK(power(points, ball, 2) == 4);  // 0 + 1 + 3: above the witness plane
}

TEST_CASE("circumball: it agrees with Cramer's rule, and power has the sign of the predicate") {
  for (const std::size_t d : {1U, 2U, 3U, 4U}) {
    CHECK(properties::holds("dimension " + std::to_string(d), [d] {
      const PointsCase set = *generators::simplex_and_queries(d);
      const PointSet points(set.points, set.weights);
      const Simplex simplex =
          generators::first_vertices(static_cast<std::size_t>(points.dimension()) + 1);
      std::vector<Rational> weights;
      for (const Vertex v : simplex) weights.push_back(points.weight(v));
      const auto expected = generators::power_ball(coordinates(points, simplex), weights);
      const Ball ball = circumball(points, simplex);
      RC_ASSERT(ball.centre == expected.centre);
      RC_ASSERT(ball.squared_radius == expected.squared_radius);
      for (Vertex q = 0; points.names(q); ++q) {
        const int side = contains(simplex, q) ? 0 : in_ball(points.configuration(), simplex, q);
        RC_ASSERT(sign(power(points, ball, q)) == -side);
      }
    }));
  }
}

// Do two simplices meet in a common face? The linear program against circuits: two simplices meet
// improperly iff some circuit, a minimal affinely dependent set, has its positive part among the
// vertices of one and its negative part among those of the other (Radon's theorem).

using generators::PointsCase;

// The barycentric coordinates of a point in a simplex, by the normal equations; nothing if the
// point is not in its affine hull or the vertices are dependent.
std::optional<std::vector<Rational>> barycentric(const std::vector<Point>& simplex,
                                                 const Point& point) {
  std::vector<Point> gram;
  Point right;
  for (std::size_t i = 1; i < simplex.size(); ++i) {
    Point row;
    for (std::size_t j = 1; j < simplex.size(); ++j) {
      row.push_back(inner_product(simplex[i] - simplex[0], simplex[j] - simplex[0]));
    }
    gram.push_back(row);
    right.push_back(inner_product(simplex[i] - simplex[0], point - simplex[0]));
  }
  if (sign(generators::leibniz_determinant(gram)) == 0) return std::nullopt;
  const Point t = generators::cramer_solution(gram, right);
  std::vector<Rational> all(1, Rational(1));
  Point image = simplex[0];
  for (std::size_t j = 0; j < t.size(); ++j) {
    all[0] -= t[j];
    all.push_back(t[j]);
    image = image + t[j] * (simplex[j + 1] - simplex[0]);
  }
  if (image != point) return std::nullopt;
  return all;
}

// Is the set a circuit with its positive part in `a` and its negative part in `b`, or conversely?
bool is_circuit_between(const PointSet& points, const Simplex& set, const Simplex& a,
                        const Simplex& b) {
  const Simplex others(set.begin(), set.end() - 1);
  const auto t = barycentric(coordinates(points, others), points[set.back()]);
  if (!t) return false;
  Simplex positive;
  Simplex negative{set.back()};
  for (std::size_t i = 0; i < others.size(); ++i) {
    if (sign((*t)[i]) == 0) return false;  // dependent, but not minimal
    (sign((*t)[i]) > 0 ? positive : negative).push_back(others[i]);
  }
  return (has_face(a, positive) && has_face(b, negative)) ||
         (has_face(b, positive) && has_face(a, negative));
}

bool meet_improperly(const PointSet& points, const Simplex& a, const Simplex& b) {
  Simplex both = a;
  both.insert(both.end(), b.begin(), b.end());
  keep_each_once(both);
  const std::size_t most = std::min(both.size(), points.ambient_dimension() + 2);
  for (std::size_t size = 3; size <= most; ++size) {
    for (const std::vector<std::size_t>& places : generators::subsets(both.size(), size)) {
      Simplex set;
      for (const std::size_t place : places) set.push_back(both[place]);
      if (is_circuit_between(points, set, a, b)) return true;
    }
  }
  return false;
}

// Does the point lie in the simplex, and not in its face on the vertices shared with another?
bool in_simplex_off_common_face(const PointSet& points, const Simplex& simplex,
                                const Simplex& other, const Point& point) {
  const auto lambda = barycentric(coordinates(points, simplex), point);
  if (!lambda) return false;
  bool off = false;
  for (std::size_t i = 0; i < simplex.size(); ++i) {
    if (sign((*lambda)[i]) < 0) return false;
    off |= sign((*lambda)[i]) > 0 && !contains(other, simplex[i]);
  }
  return off;
}

TEST_CASE("proper intersection: triangles that share nothing, a vertex, an edge, everything") {
  const PointSet points({{0, 0}, {2, 0}, {0, 2}, {2, 2}, {4, 4}, {5, 4}, {4, 5}});
  CHECK(!improper_intersection(points, {0, 1, 2}, {4, 5, 6}));
  CHECK(!improper_intersection(points, {1, 2, 3}, {3, 4, 5}));
  CHECK(!improper_intersection(points, {0, 1, 2}, {1, 2, 3}));
  CHECK(!improper_intersection(points, {0, 1, 2}, {2, 0, 1}));
  CHECK(!improper_intersection(points, {0, 1, 2}, {1, 2}));
}

TEST_CASE("proper intersection: simplices that merely touch, where no vertex is shared") {
  const PointSet points({{0, 0}, {4, 0}, {0, 4}, {2, 0}, {1, -2}, {3, -2}});
  CHECK(improper_intersection(points, {0, 1, 2}, {3, 4, 5}) == Point{2, 0});
  // An edge of one lies along half an edge of the other: a T-junction.
  CHECK(improper_intersection(points, {0, 1, 2}, {0, 3, 4}) == Point{2, 0});
  CHECK(improper_intersection(points, {1}, {0, 1, 2}) == std::nullopt);
  CHECK(improper_intersection(points, {3}, {0, 1, 2}) == Point{2, 0});
}

TEST_CASE("proper intersection: crossing diagonals, and a tetrahedron pierced by an edge") {
  const PointSet square({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const Rational half(1, 2);
  CHECK(improper_intersection(square, {0, 2}, {1, 3}) == Point{half, half});
  CHECK(improper_intersection(square, {0, 1, 2}, {1, 2, 3}).has_value());
  const PointSet space({{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {-1, 1, 1}, {2, 1, 1}});
  CHECK(improper_intersection(space, {0, 1, 2, 3}, {4, 5}).has_value());
  CHECK(!improper_intersection(space, {0, 1, 2}, {4, 5}));
}

TEST_CASE("proper intersection: it agrees with circuits, and the point is what it should be") {
  for (const std::size_t d : {1U, 2U, 3U}) {
    std::size_t proper = 0;
    std::size_t improper = 0;
    CHECK(properties::holds("dimension " + std::to_string(d), [&] {
      const std::size_t most = d + 4;
      const auto sets = rc::gen::oneOf(generators::sets_of(generators::grid_points, d, most),
                                       generators::sets_of(generators::integer_points, d, most));
      const PointsCase set = *generators::unweighted(sets);
      RC_PRE(set.points.size() >= 2U);
      const PointSet points(set.points);
      // Mostly large simplices, which are the likelier to meet.
      const auto simplex = [&] {
        Simplex all = generators::shuffled(generators::first_vertices(points.size()));
        const auto size = d + 1 - static_cast<std::size_t>(*rc::gen::element(0, 0, 0, 1, 1));
        all.resize(std::min(all.size(), size));
        return all;
      };
      const Simplex a = simplex();
      const Simplex b = simplex();
      const auto independent = [&](const Simplex& s) {
        return affine_hull(coordinates(points, s)).basis.size() == s.size();
      };
      RC_PRE(independent(a) && independent(b));
      const auto common = improper_intersection(points, a, b);
      RC_ASSERT(common.has_value() == meet_improperly(points, a, b));
      ++(common ? improper : proper);
      if (!common) return;
      RC_ASSERT(in_simplex_off_common_face(points, a, b, *common));
      RC_ASSERT(in_simplex_off_common_face(points, b, a, *common));
    }));
    CHECK(proper > 0);
    CHECK(improper > 0);
  }
}

}  // namespace

}  // namespace circumspect
