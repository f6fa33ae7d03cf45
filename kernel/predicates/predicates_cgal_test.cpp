// Laws O5 of kernel/predicates/orientation.hpp and B4 of kernel/predicates/in_ball.hpp:
// CGAL's exact kernel as the second opinion.
#include <algorithm>

#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <doctest/doctest.h>

#include "inputs/plain_algebra.hpp"
#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/orientation.hpp"
#include "properties/arguments/laws.hpp"

namespace circumspect {
namespace {

using generators::PointsCase;
using generators::Scaling;
using generators::Scene;

using Kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;

CGAL::Gmpq number(const Rational& x) { return CGAL::Gmpq(x.get_mpq_t()); }

// Calls visit(tuple) for all increasing tuples of `size` of the points.
template <typename Visit>
void for_all_tuples(std::size_t points, std::size_t size, const Visit& visit) {
  if (points < size) return;
  for (const auto& places : generators::subsets(points, size)) {
    visit(std::vector<Vertex>(places.begin(), places.end()));
  }
}

TEST_CASE("O5 the orientation in the plane is CGAL's") {
  const std::vector<std::size_t> axes = {0, 1};
  CHECK(generators::holds_for_sets(2, 2, [&](const PointsCase& set, Scaling scaling) {
    const Configuration points = generators::configuration(set, scaling);
    std::vector<Kernel::Point_2> theirs;
    for (const Point& p : set.points) theirs.emplace_back(number(p[0]), number(p[1]));
    for_all_tuples(set.points.size(), 3, [&](const std::vector<Vertex>& s) {
      const auto at = [&](std::size_t i) { return theirs[static_cast<std::size_t>(s[i])]; };
      RC_ASSERT(orientation(points, axes, s) ==
                static_cast<int>(CGAL::orientation(at(0), at(1), at(2))));
    });
  }));
}

TEST_CASE("O5 the orientation in space is the negative of CGAL's") {
  const std::vector<std::size_t> axes = {0, 1, 2};
  CHECK(generators::holds_for_sets(3, 3, [&](const PointsCase& set, Scaling scaling) {
    const Configuration points = generators::configuration(set, scaling);
    std::vector<Kernel::Point_3> theirs;
    for (const Point& p : set.points) {
      theirs.emplace_back(number(p[0]), number(p[1]), number(p[2]));
    }
    for_all_tuples(set.points.size(), 4, [&](const std::vector<Vertex>& s) {
      const auto at = [&](std::size_t i) { return theirs[static_cast<std::size_t>(s[i])]; };
      RC_ASSERT(orientation(points, axes, s) ==
                -static_cast<int>(CGAL::orientation(at(0), at(1), at(2), at(3))));
    });
  }));
}

Kernel::Weighted_point_2 weighted_2(const PointsCase& set, Vertex v) {
  const auto i = static_cast<std::size_t>(v);
  const Point& p = set.points[i];
  return {Kernel::Point_2(number(p[0]), number(p[1])),
          set.weights.empty() ? CGAL::Gmpq(0) : number(set.weights[i])};
}

Kernel::Weighted_point_3 weighted_3(const PointsCase& set, Vertex v) {
  const auto i = static_cast<std::size_t>(v);
  const Point& p = set.points[i];
  return {Kernel::Point_3(number(p[0]), number(p[1]), number(p[2])),
          set.weights.empty() ? CGAL::Gmpq(0) : number(set.weights[i])};
}

// Calls visit(simplex, q, ours): the leading simplex and each of its neighbours, which have a query
// in one vertex's stead, with every other point.
template <typename Visit>
void for_all_tests(const PointsCase& set, Scaling scaling, const Visit& visit) {
  const Scene scene = generators::scene(set, scaling);
  for (const Vertex in : scene.queries) {
    for (std::size_t place = 0; place <= scene.simplex.size(); ++place) {
      std::vector<Vertex> simplex = scene.simplex;
      if (place < simplex.size()) simplex[place] = in;
      if (orientation(scene.points, scene.axes, simplex) == 0) continue;
      for (Vertex q = 0; q < static_cast<Vertex>(set.points.size()); ++q) {
        if (std::find(simplex.begin(), simplex.end(), q) != simplex.end()) continue;
        visit(simplex, q, in_ball(scene.points, scene.axes, simplex, q));
      }
    }
  }
}

TEST_CASE("B4 in_ball in the plane is CGAL's side of the bounded circle, or its power test") {
  CHECK(generators::holds_for_simplices(2, 2, [](const PointsCase& set, Scaling scaling) {
    for_all_tests(set, scaling, [&](const std::vector<Vertex>& s, Vertex q, int ours) {
      if (s.size() != 3) return;
      const auto a = weighted_2(set, s[0]);
      const auto b = weighted_2(set, s[1]);
      const auto c = weighted_2(set, s[2]);
      const auto d = weighted_2(set, q);
      if (set.weights.empty()) {
        RC_ASSERT(ours == static_cast<int>(CGAL::side_of_bounded_circle(a.point(), b.point(),
                                                                        c.point(), d.point())));
      }
      const auto power = CGAL::power_side_of_oriented_power_circle(a, b, c, d);
      const auto turn = CGAL::orientation(a.point(), b.point(), c.point());
      RC_ASSERT(ours == static_cast<int>(power) * static_cast<int>(turn));
    });
  }));
}

TEST_CASE("B4 in_ball in space is CGAL's side of the bounded sphere, or its power test") {
  CHECK(generators::holds_for_simplices(3, 3, [](const PointsCase& set, Scaling scaling) {
    for_all_tests(set, scaling, [&](const std::vector<Vertex>& s, Vertex q, int ours) {
      if (s.size() != 4) return;
      const auto a = weighted_3(set, s[0]);
      const auto b = weighted_3(set, s[1]);
      const auto c = weighted_3(set, s[2]);
      const auto d = weighted_3(set, s[3]);
      const auto e = weighted_3(set, q);
      if (set.weights.empty()) {
        RC_ASSERT(ours == static_cast<int>(CGAL::side_of_bounded_sphere(
                              a.point(), b.point(), c.point(), d.point(), e.point())));
      }
      const auto power = CGAL::power_side_of_oriented_power_sphere(a, b, c, d, e);
      const auto turn = CGAL::orientation(a.point(), b.point(), c.point(), d.point());
      RC_ASSERT(ours == static_cast<int>(power) * static_cast<int>(turn));
    });
  }));
}

TEST_CASE(
    "B4 in_ball in a plane in space is CGAL's side of the bounded circle of coplanar points") {
  const auto cases = generators::simplex_first(
      generators::unweighted(generators::sets_of(generators::plane_points, 3, 8)));
  const auto law = [](const PointsCase& set, Scaling scaling) {
    for_all_tests(set, scaling, [&](const std::vector<Vertex>& s, Vertex q, int ours) {
      if (s.size() != 3) return;
      RC_ASSERT(ours == static_cast<int>(CGAL::coplanar_side_of_bounded_circle(
                            weighted_3(set, s[0]).point(), weighted_3(set, s[1]).point(),
                            weighted_3(set, s[2]).point(), weighted_3(set, q).point())));
    });
  };
  CHECK(generators::holds("planes in space", cases, law));
}

TEST_CASE("B4 in_ball on a line in the plane is CGAL's order along the line") {
  const auto cases = generators::simplex_first(
      generators::unweighted(generators::sets_of(generators::line_points, 2, 6)));
  const auto law = [](const PointsCase& set, Scaling scaling) {
    for_all_tests(set, scaling, [&](const std::vector<Vertex>& s, Vertex q, int ours) {
      const bool between = CGAL::collinear_are_strictly_ordered_along_line(
          weighted_2(set, s[0]).point(), weighted_2(set, q).point(), weighted_2(set, s[1]).point());
      RC_ASSERT(ours == (between ? 1 : -1));
    });
  };
  CHECK(generators::holds("lines in the plane", cases, law));
}

}  // namespace
}  // namespace circumspect
