// Two meshes are one complex, or what differs is named.
#include "oracle/judge/points/difference.hpp"

#include <doctest/doctest.h>

namespace circumspect::check {
namespace {

// A unit square; `order` says which corner comes where.
ExactMesh square(const std::vector<int>& order, std::vector<Simplex> simplices,
                 std::vector<Simplex> faces = {}) {
  std::vector<Point> corners;
  for (const int corner : order) corners.push_back({corner & 1, corner >> 1});
  return {PointSet(corners), std::move(simplices), {}, 0, {}, std::move(faces)};
}

TEST_CASE("numbering, order of simplices and order of vertices mean nothing") {
  const ExactMesh a = square({0, 1, 2, 3}, {{0, 1, 2}, {1, 2, 3}});
  const ExactMesh b = square({3, 2, 1, 0}, {{2, 1, 0}, {3, 1, 2}});
  CHECK(difference(a, b).empty());
  CHECK(difference(b, a).empty());
}

TEST_CASE("the other diagonal differs in both triangles") {
  const ExactMesh a = square({0, 1, 2, 3}, {{0, 1, 2}, {1, 2, 3}});
  const ExactMesh b = square({0, 1, 2, 3}, {{0, 1, 3}, {0, 2, 3}});
  const Difference found = difference(a, b);
  CHECK(found.points_only_in_a.empty());
  CHECK(found.simplices_only_in_a == a.simplices);
  CHECK(found.simplices_only_in_b == b.simplices);
}

TEST_CASE("a simplex counts as often as it is listed, in any order of its vertices") {
  const ExactMesh a = square({0, 1, 2, 3}, {{0, 1, 2}});
  const ExactMesh b = square({0, 1, 2, 3}, {{0, 1, 2}, {2, 1, 0}});
  CHECK(difference(a, b).simplices_only_in_a.empty());
  CHECK(difference(a, b).simplices_only_in_b == std::vector<Simplex>{{2, 1, 0}});
  CHECK(difference(b, a).simplices_only_in_a == std::vector<Simplex>{{2, 1, 0}});
  CHECK(difference(b, b).empty());
}

TEST_CASE("a point that only one mesh has, and its simplices") {
  const ExactMesh a = square({0, 1, 2, 3}, {{0, 1, 2}, {1, 2, 3}});
  const ExactMesh b = square({0, 1, 2}, {{0, 1, 2}});
  const Difference found = difference(a, b);
  CHECK(found.points_only_in_a == std::vector<Vertex>{3});
  CHECK(found.points_only_in_b.empty());
  CHECK(found.simplices_only_in_a == std::vector<Simplex>{{1, 2, 3}});
  CHECK(found.simplices_only_in_b.empty());
}

TEST_CASE("points a millionth of a millionth apart are two points") {
  const ExactMesh a{PointSet({{0, 0}, {1, 0}, {0, 1}}), {{0, 1, 2}}};
  const ExactMesh b{PointSet({{0, 0}, {1, 0}, {0, 1 + Rational(1) / 1'000'000'000'000}}),
                    {{0, 1, 2}}};
  const Difference found = difference(a, b);
  CHECK(found.points_only_in_a == std::vector<Vertex>{2});
  CHECK(found.points_only_in_b == std::vector<Vertex>{2});
  CHECK(found.simplices_only_in_b.size() == 1);
}

TEST_CASE("a vertex that names no point matches nothing, not even itself") {
  const ExactMesh a = square({0, 1, 2, 3}, {{0, 1, 9}});
  const Difference found = difference(a, a);
  CHECK(found.simplices_only_in_a == a.simplices);
  CHECK(found.simplices_only_in_b == a.simplices);
}

TEST_CASE("faces of simplices say nothing new; dangling ones do, once") {
  const ExactMesh plain = square({0, 1, 2, 3}, {{0, 1, 2}});
  CHECK(difference(plain, square({0, 1, 2, 3}, {{0, 1, 2}}, {{1, 2}, {0, 1}})).empty());
  const ExactMesh dangling = square({0, 1, 2, 3}, {{0, 1, 2}}, {{2, 3}, {3, 2}});
  CHECK(difference(plain, dangling).simplices_only_in_b == std::vector<Simplex>{{2, 3}});
  CHECK(difference(dangling, dangling).empty());
}

TEST_CASE("weights tell points apart") {
  const ExactMesh light{PointSet({{0}, {1}}, {0, 0}), {{0, 1}}};
  const ExactMesh heavy{PointSet({{0}, {1}}, {0, 3}), {{0, 1}}};
  CHECK(difference(light, heavy).points_only_in_a == std::vector<Vertex>{1});
  CHECK(difference(light, light).empty());
}

}  // namespace
}  // namespace circumspect::check
