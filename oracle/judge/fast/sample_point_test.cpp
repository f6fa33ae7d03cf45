// Conditions 3 and 4w of docs/theory/points.md: the sample point, and points that are not
// vertices.
#include "oracle/judge/fast/sample_point.hpp"

#include <cmath>
#include <numeric>
#include <random>

#include <doctest/doctest.h>

#include "kernel/predicates/orientation.hpp"
#include "oracle/judge/fast/grid_mesh_test.hpp"
#include "oracle/judge/fast/judge.hpp"
#include "oracle/judge/fast/submerged_points.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::fast {

// If no simplex contains a double in its interior, the sample point is an exact barycentre.

namespace {

constexpr double kFar = 0x1p52;  // doubles are 1 apart here

template <std::size_t kDimension>
Point exact(const Site<kDimension>& site) {
  Point point;
  for (const double x : site.at) point.push_back(exact_value(x));
  return point;
}

template <std::size_t kDimension>
Point exact_barycentre(const SiteRow<kDimension>& row) {
  std::vector<Point> points;
  for (const auto& site : row) points.push_back(exact<kDimension>(site));
  return barycentre(points);
}

// The sign according to kernel/predicates.
template <std::size_t kDimension>
int sign_with(const SiteRow<kDimension>& row, std::size_t place, const Point& point) {
  std::vector<Point> points;
  for (const auto& site : row) points.push_back(exact<kDimension>(site));
  points[place] = point;
  std::vector<std::size_t> axes(kDimension);
  std::vector<Vertex> simplex(kDimension + 1);
  std::iota(axes.begin(), axes.end(), std::size_t{0});
  std::iota(simplex.begin(), simplex.end(), Vertex{0});
  return circumspect::orientation(Configuration(points), axes, simplex);
}

// Coordinates within some units of `origin`; now and then with other exponents.
template <std::size_t kDimension>
SiteRow<kDimension> any_row(double origin, int units, std::mt19937_64& random) {
  SiteRow<kDimension> row{};
  for (auto& site : row) {
    for (double& x : site.at) {
      x = origin + static_cast<double>(random() % static_cast<std::uint64_t>(units));
      if (origin == 0 && random() % 4 == 0)
        x = std::ldexp(-x, static_cast<int>(random() % 2000) - 1000);
    }
  }
  return row;
}

template <std::size_t kDimension>
void check_barycentres(double origin, int units) {
  std::mt19937_64 random(7);
  Stages stages;
  for (int i = 0; i < 300 / properties::kOneInputIn; ++i) {
    const auto corners = any_row<kDimension>(origin, units, random);
    const auto row = any_row<kDimension>(origin, units, random);
    if (orientation<kDimension>(corners, stages) == 0) continue;
    const Point centre = exact_barycentre<kDimension>(corners);
    const auto point = barycentre_of<kDimension>(corners, 0);
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      CHECK(exact_value(point.low.at[axis]) <= centre[axis]);
      CHECK(exact_value(point.high.at[axis]) >= centre[axis]);
      if (origin == kFar) CHECK(point.high.at[axis] - point.low.at[axis] <= 1);
    }
    const int own = orientation<kDimension>(row, stages);
    bool inside = true;
    for (std::size_t place = 0; place <= kDimension; ++place) {
      const int expected = sign_with<kDimension>(row, place, centre);
      CHECK(orientation_with<kDimension>(row, place, point, stages) == expected);
      CHECK(orientation_with<kDimension>(corners, place, point, stages) ==
            orientation<kDimension>(corners, stages));
      inside &= expected * own >= 0;
    }
    if (own != 0) CHECK(covers<kDimension>(row, own, point, stages) == inside);
  }
  CHECK(stages.unbounded > 0);
}

TEST_CASE("a barycentre is where exact arithmetic says, whatever the size of the numbers") {
  for (const int units : {3, 6}) {
    check_barycentres<2>(kFar, units);
    check_barycentres<3>(kFar, units);
    check_barycentres<2>(0, units);
    check_barycentres<3>(0, units);
  }
}

// A grid whose neighbouring points are adjacent doubles.
template <std::size_t kDimension>
MeshInArrays<kDimension> far_grid(std::size_t side, bool mirrored) {
  auto mesh = grid_mesh<kDimension>(side, mirrored);
  for (double& x : mesh.coordinates) x += kFar;
  return mesh;
}

template <std::size_t kDimension>
void check_far_grid(bool mirrored) {
  auto mesh = far_grid<kDimension>(properties::points_a_side(kDimension == 2 ? 20 : 8), mirrored);
  Stages stages;
  const auto point = sample_point(mesh.view(), stages);
  REQUIRE(point.has_value());
  CHECK(point->corners.has_value());
  for (const unsigned threads : {1U, 3U}) {
    const auto facts = judge(mesh.view(), Question::kDelaunay, threads);
    REQUIRE(facts.has_value());
    CHECK(facts->holds());
    CHECK(facts->stages.unbounded > 0);
  }
  // Without one of its simplices, and with one twice; then with a point moved to its neighbour's
  // far side.
  const auto good = mesh.simplices;
  std::mt19937_64 random(8);
  for (int i = 0; i < 10; ++i) {
    const std::size_t row = random() % mesh.size() * (kDimension + 1);
    const auto begin = good.begin() + static_cast<std::ptrdiff_t>(row);
    mesh.simplices = good;
    mesh.simplices.erase(mesh.simplices.begin() + (begin - good.begin()),
                         mesh.simplices.begin() + (begin - good.begin()) + kDimension + 1);
    CHECK_FALSE(judge(mesh.view(), Question::kTriangulation, 1).has_value());
    mesh.simplices = good;
    mesh.simplices.insert(mesh.simplices.end(), begin, begin + kDimension + 1);
    CHECK_FALSE(judge(mesh.view(), Question::kTriangulation, 1).has_value());
    mesh.simplices = good;
    double& moved = mesh.coordinates[random() % mesh.coordinates.size()];
    moved += 2;
    CHECK_FALSE(judge(mesh.view(), Question::kTriangulation, 1).has_value());
    moved -= 2;
  }
}

TEST_CASE("grids as fine as the doubles there are judged, and what breaks them is seen") {
  for (const bool mirrored : {false, true}) {
    check_far_grid<2>(mirrored);
    check_far_grid<3>(mirrored);
  }
}

// Only the sample point finds that it is not a triangulation.
TEST_CASE("a fan of tiny triangles that winds twice is left undecided") {
  const std::vector<double> ring = {1, 0, 0, 1, -1, 0, 0, -1, 2, 0, 0, 2, -2, 0, 0, -2};
  std::size_t covered_twice = 0;
  for (std::int32_t first = 0; first < 8; ++first) {
    MeshInArrays<2> fan{.coordinates = {kFar + 9, kFar + 9}};
    for (const double x : ring) fan.coordinates.push_back(kFar + 9 + x);
    for (std::int32_t i = 0; i < 8; ++i) {
      fan.simplices.insert(fan.simplices.end(), {0, (first + i) % 8 + 1, (first + i + 1) % 8 + 1});
    }
    Stages stages;
    CHECK(sample_point(fan.view(), stages)->corners.has_value());
    const auto facts = judge(fan.view(), Question::kTriangulation, 1);
    REQUIRE_FALSE(facts.has_value());
    covered_twice += facts.error() == Undecided::kCoveredTwice ? 1 : 0;
  }
  CHECK(covered_twice > 0);  // or beyond a boundary facet
}

// Points that are not vertices: the cost of judging many of them. properties/arrays_property.cpp
// compares the answers with those of oracle/judge/points.

// A fan of n triangles with their bases on a line, and n light points anywhere inside.
MeshInArrays<2> fan(std::int32_t n) {
  MeshInArrays<2> mesh;
  const auto add = [&](double x, double y, double weight) {
    mesh.coordinates.insert(mesh.coordinates.end(), {x, y});
    mesh.weights.push_back(weight);
  };
  for (std::int32_t i = 0; i <= n; ++i) add(i, 0, 0);
  add(n / 2, n, 0);
  for (std::int32_t i = 0; i < n; ++i) {
    mesh.simplices.insert(mesh.simplices.end(), {i, i + 1, n + 1});
  }
  std::mt19937_64 random(3);
  const auto next = [&] { return static_cast<double>(random() >> 11) / 9007199254740992.0; };
  for (std::int32_t i = 0; i < n; ++i) {
    const double y = next() * n * 0.999;
    const double half_width = (n - y) / 2;
    add(n / 2 + (2 * next() - 1) * half_width * 0.999, y, -4e10);
  }
  return mesh;
}

std::uint64_t signs(std::int32_t n) {
  const auto facts = judge(fan(n).view(), Question::kWeightedDelaunay, 1);
  REQUIRE(facts.has_value());
  CHECK(facts->holds());
  return facts->stages.filtered + facts->stages.exact();
}

TEST_CASE("as many submerged points as triangles, in a fan, take near-linear many signs") {
  constexpr std::int32_t n = 20000 / properties::kOneInputIn;
  CHECK(signs(n) < n * 150);
  CHECK(signs(2 * n) < 5 * signs(n / 2));
}

}  // namespace

}  // namespace circumspect::fast
