// Which tetrahedra a polygon crosses. Book: Section 5.8.
#include "reference/constrained/cavity.hpp"

#include <doctest/doctest.h>

namespace circumspect::constrained {
namespace {

const PointSet kPiercedTriangle({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 1}, {1, 1, -1}});
const Polygon kTriangle{{0, 1, 2}, {{0, 1}, {0, 2}, {1, 2}}, {}, {0, 1}, {{0, 1, 2}}};

TEST_CASE("distances along the axis that the polygon leaves out") {
  const PolygonInSpace polygon(kPiercedTriangle, kTriangle);
  CHECK(polygon.distance(0) == 0);
  CHECK(abs(polygon.distance(3)) == 1);
  CHECK(polygon.distance(4) == -polygon.distance(3));
  CHECK(polygon.parts({0, 3, 4}));
  CHECK(!polygon.parts({0, 1, 3}));
  CHECK(polygon.is_coplanar({0, 1, 2}));
}

TEST_CASE("the tetrahedra around an edge that pierces the polygon") {
  const PolygonInSpace polygon(kPiercedTriangle, kTriangle);
  const std::vector<Simplex> around = {{0, 1, 3, 4}, {0, 2, 3, 4}, {1, 2, 3, 4}};
  CHECK(crossed_tetrahedra(StarIndex(around), polygon) ==
        std::set<Simplex>(around.begin(), around.end()));
  CHECK(facets_included_in(StarIndex(around), polygon).empty());

  const StarIndex parted({{0, 1, 2, 3}, {0, 1, 2, 4}});
  CHECK(crossed_tetrahedra(parted, polygon).empty());
  CHECK(facets_included_in(parted, polygon) == std::set<Simplex>{{0, 1, 2}});
}

TEST_CASE("only what the polygon covers counts, not its plane") {
  // Two such places side by side; the polygon covers the first.
  std::vector<Point> points = kPiercedTriangle.points();
  points.push_back({4, 4, 0});
  points.push_back({3, 3, 1});
  points.push_back({3, 3, -1});
  const PointSet set(points);
  const StarIndex tetrahedra(
      {{0, 1, 3, 4}, {0, 2, 3, 4}, {1, 2, 3, 4}, {1, 5, 6, 7}, {2, 5, 6, 7}, {1, 2, 6, 7}});
  const PolygonInSpace polygon(set, kTriangle);
  CHECK(crossed_tetrahedra(tetrahedra, polygon) ==
        std::set<Simplex>{{0, 1, 3, 4}, {0, 2, 3, 4}, {1, 2, 3, 4}});
}

}  // namespace
}  // namespace circumspect::constrained
