// The laws of place.hpp, under their numbers.
#include "kernel/predicates/place.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "kernel/predicates/intersection.hpp"
#include "kernel/predicates/orientation.hpp"
#include "properties/arguments/generated.hpp"
#include "properties/arguments/laws.hpp"

namespace circumspect {
namespace {

Point point_of(const Configuration& points, Vertex v) {
  Point point;
  for (std::size_t axis = 0; axis < points.ambient_dimension(); ++axis) {
    point.push_back(Rational(points.numerator(v, axis)) / points.denominator(v));
  }
  return point;
}

std::vector<Point> points_of(const Configuration& points, const std::vector<Vertex>& vertices) {
  std::vector<Point> found;
  for (const Vertex v : vertices) found.push_back(point_of(points, v));
  return found;
}

// Barycentric coordinates of v, seen on the axes, from a system of equations.
std::vector<Rational> barycentric_on(const Configuration& points,
                                     const std::vector<std::size_t>& axes,
                                     const std::vector<Vertex>& simplex, Vertex v) {
  RationalMatrix rows(1, std::vector<Rational>(simplex.size(), 1));
  std::vector<Rational> right = {1};
  for (const std::size_t axis : axes) {
    rows.emplace_back();
    for (const Vertex u : simplex) rows.back().push_back(point_of(points, u)[axis]);
    right.push_back(point_of(points, v)[axis]);
  }
  return *solve(rows, right);
}

// Barycentric coordinates; nothing if v is not in the hull.
std::optional<std::vector<Rational>> barycentric(const Configuration& points,
                                                 const std::vector<std::size_t>& axes,
                                                 const std::vector<Vertex>& simplex, Vertex v) {
  const std::vector<Rational> weights = barycentric_on(points, axes, simplex, v);
  Point sum(points.ambient_dimension(), 0);
  for (std::size_t i = 0; i < simplex.size(); ++i) {
    sum = sum + weights[i] * point_of(points, simplex[i]);
  }
  return sum == point_of(points, v) ? std::optional(weights) : std::nullopt;
}

// All faces of a simplex, itself among them.
std::vector<std::vector<Vertex>> faces(const std::vector<Vertex>& simplex) {
  std::vector<std::vector<Vertex>> found;
  for (std::size_t bits = 1; bits < (std::size_t{1} << simplex.size()); ++bits) {
    found.emplace_back();
    for (std::size_t i = 0; i < simplex.size(); ++i) {
      if ((bits >> i) & 1U) found.back().push_back(simplex[i]);
    }
  }
  return found;
}

TEST_CASE("P1: a vertex lies in a simplex iff its barycentric coordinates say so") {
  CHECK(generators::holds_for_simplices(1, 4, [](const auto& set, const auto scaling) {
    const generators::Scene scene = generators::scene(set, scaling);
    for (Vertex v = 0; v < static_cast<Vertex>(scene.points.size()); ++v) {
      const auto weights = barycentric(scene.points, scene.axes, scene.simplex, v);
      const auto all = [&](const auto& condition) {
        return weights && std::all_of(weights->begin(), weights->end(), condition);
      };
      const bool in = all([](const Rational& weight) { return weight >= 0; });
      const bool inside = all([](const Rational& weight) { return weight > 0; });
      RC_ASSERT(lies_in(scene.points, scene.simplex, v) == in);
      RC_ASSERT(lies_in(scene.points, scene.axes, scene.simplex, v) == in);
      RC_ASSERT(lies_inside(scene.points, scene.simplex, v) == inside);
      RC_ASSERT(lies_inside(scene.points, scene.axes, scene.simplex, v) == inside);
      RC_ASSERT(is_in_hull_of(scene.points, scene.axes, scene.simplex, v) == weights.has_value());
      if (scene.simplex.size() == 2) {
        RC_ASSERT(lies_inside_segment(scene.points, scene.simplex, v) == inside);
      }
    }
  }));
}

TEST_CASE("P1: a vertex beside the plane of a triangle is not in it, along whichever axis") {
  const std::array<Vertex, 3> triangle = {0, 1, 2};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<Point> points = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}, {1, 1, 1}};
    for (Point& point : points) std::swap(point[axis], point[2]);
    CHECK(lies_in(Configuration(points), triangle, 3));
    CHECK_FALSE(lies_in(Configuration(points), triangle, 4));
  }
}

TEST_CASE("P2: a vertex of a closed simplex lies inside exactly one of its faces") {
  CHECK(generators::holds_for_simplices(1, 3, [](const auto& set, const auto scaling) {
    const generators::Scene scene = generators::scene(set, scaling);
    for (Vertex v = 0; v < static_cast<Vertex>(scene.points.size()); ++v) {
      const auto all = faces(scene.simplex);
      const auto count = std::count_if(all.begin(), all.end(), [&](const auto& face) {
        return lies_inside(scene.points, face, v);
      });
      RC_ASSERT(count == (lies_in(scene.points, scene.simplex, v) ? 1 : 0));
    }
  }));
}

TEST_CASE("P3: orders do not matter") {
  CHECK(generators::holds_for_simplices(1, 3, [](const auto& set, const auto scaling) {
    const generators::Scene scene = generators::scene(set, scaling);
    const std::vector<Vertex> other = generators::shuffled(scene.simplex);
    for (Vertex v = 0; v < static_cast<Vertex>(scene.points.size()); ++v) {
      RC_ASSERT(lies_in(scene.points, other, v) == lies_in(scene.points, scene.simplex, v));
      RC_ASSERT(lies_inside(scene.points, other, v) == lies_inside(scene.points, scene.simplex, v));
    }
  }));
}

// A point on a grid so small that incidences are common.
rc::Gen<Point> grid_point(std::size_t d) {
  return rc::gen::map(rc::gen::container<std::vector<int>>(d, rc::gen::inRange(0, 4)),
                      [](const std::vector<int>& xs) { return Point(xs.begin(), xs.end()); });
}

std::vector<Point> distinct_points(std::size_t d, std::size_t count) {
  return *rc::gen::unique<std::vector<Point>>(count, grid_point(d));
}

bool is_inside_of(const std::vector<Point>& simplex, const Point& point) {
  if (std::find(simplex.begin(), simplex.end(), point) != simplex.end()) return false;
  std::vector<Point> all = simplex;
  all.push_back(point);
  const Configuration points(all);
  std::vector<Vertex> vertices;
  for (std::size_t i = 0; i < simplex.size(); ++i) vertices.push_back(static_cast<Vertex>(i));
  return lies_inside(points, vertices, static_cast<Vertex>(simplex.size()));
}

TEST_CASE("P4, P3: segments that cross have one point in common, inside both") {
  for (const std::size_t d : {2U, 3U}) {
    CHECK(properties::holds("dimension " + std::to_string(d), [d] {
      const std::vector<Point> four = distinct_points(d, 4);
      const Configuration points(four);
      const std::array<Vertex, 2> a = {0, 1}, b = {2, 3};
      const bool cross = segments_cross(points, a, b);
      RC_ASSERT(segments_cross(points, b, a) == cross);
      RC_ASSERT(segments_cross(points, std::array<Vertex, 2>{1, 0}, b) == cross);
      const std::vector<Point> s = {four[0], four[1]}, t = {four[2], four[3]};
      const std::vector<Point> common = intersection(s, t);
      RC_ASSERT(cross ==
                (common.size() == 1 && is_inside_of(s, common[0]) && is_inside_of(t, common[0])));
    }));
  }
}

TEST_CASE("P4: a segment that pierces a triangle meets it in one point, inside the segment") {
  CHECK(properties::holds("a segment and a triangle of space", [] {
    const std::vector<Point> five = distinct_points(3, 5);
    const Configuration points(five);
    const std::array<Vertex, 2> segment = {0, 1};
    const std::array<Vertex, 3> triangle = {2, 3, 4};
    RC_PRE(axes_of_plane(points, triangle).size() == 2);
    const std::vector<Point> common = intersection({five[0], five[1]}, {five[2], five[3], five[4]});
    const bool apart =
        side_of_triangle(points, triangle, 0) != 0 && side_of_triangle(points, triangle, 1) != 0;
    RC_ASSERT(segment_pierces_triangle(points, segment, triangle) == (apart && common.size() == 1));
  }));
}

TEST_CASE("P5, P3: triangles of a plane whose interiors meet have an area in common") {
  for (const std::size_t d : {2U, 3U}) {
    CHECK(properties::holds("dimension " + std::to_string(d), [d] {
      std::vector<Point> six = distinct_points(2, 6);
      // In space they lie in an oblique plane.
      for (Point& p : six) {
        if (d == 3) p.push_back(2 * p[0] - p[1] + 1);
      }
      const Configuration points(six);
      const std::array<Vertex, 3> a = {0, 1, 2}, b = {3, 4, 5};
      const auto axes = axes_of_plane(points, a);
      RC_PRE(!axes.empty() && !axes_of_plane(points, b).empty());
      const bool meet = interiors_meet(points, axes, a, b);
      RC_ASSERT(interiors_meet(points, axes, b, a) == meet);
      RC_ASSERT((intersection(points_of(points, {0, 1, 2}), points_of(points, {3, 4, 5})).size() >=
                 3) == meet);
    }));
  }
}

TEST_CASE("P6: barycentric signs are those of the coordinates, seen on the axes") {
  CHECK(generators::holds_for_simplices(1, 4, [](const auto& set, const auto scaling) {
    const generators::Scene scene = generators::scene(set, scaling);
    for (Vertex v = 0; v < static_cast<Vertex>(scene.points.size()); ++v) {
      std::vector<int> signs;
      for (const Rational& weight : barycentric_on(scene.points, scene.axes, scene.simplex, v)) {
        signs.push_back(sign(weight));
      }
      RC_ASSERT(barycentric_signs(scene.points, scene.axes, scene.simplex, v) == signs);
      for (std::size_t place = 0; place < signs.size(); ++place) {
        RC_ASSERT(barycentric_sign(scene.points, scene.axes, scene.simplex, place, v) ==
                  signs[place]);
        if (scene.simplex.size() != scene.points.axes().size() + 1) continue;
        const int own = orientation(scene.points, scene.simplex);
        RC_ASSERT(barycentric_sign(scene.points, scene.simplex, own, place, v) == signs[place]);
      }
    }
  }));
}

TEST_CASE("place: worked examples in dimensions beyond three") {
  const Configuration points(
      {{0, 0, 0, 0}, {2, 2, 2, 2}, {1, 1, 1, 1}, {1, 1, 1, 2}, {3, 3, 3, 3}});
  CHECK(lies_inside_segment(points, std::array<Vertex, 2>{0, 1}, 2));
  CHECK(!lies_inside_segment(points, std::array<Vertex, 2>{0, 1}, 3));
  CHECK(!lies_inside_segment(points, std::array<Vertex, 2>{0, 1}, 4));
  CHECK(lies_in(points, std::array<Vertex, 2>{0, 1}, 1));
  CHECK(!lies_inside(points, std::array<Vertex, 2>{0, 1}, 1));
}

}  // namespace
}  // namespace circumspect
