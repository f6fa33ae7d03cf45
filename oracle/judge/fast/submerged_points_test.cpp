// Points that are no vertices: how much it takes to judge many of them. What is said of them is held to
// oracle/judge/points by properties/arrays_property.cpp.
#include "oracle/judge/fast/submerged_points.hpp"

#include <random>

#include <doctest/doctest.h>

#include "oracle/judge/fast/grid_mesh_test.hpp"
#include "oracle/judge/fast/judge.hpp"

namespace circumspect::fast {
namespace {

// A fan of n triangles with their bases on a line, and n light points anywhere in it.
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
  CHECK(signs(20000) < 20000 * 150);
  CHECK(signs(40000) < 5 * signs(10000));
}

}  // namespace
}  // namespace circumspect::fast
