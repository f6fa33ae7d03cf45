// How much one insertion may change, and what the statistics say. Book: Section 5.2.
#include <doctest/doctest.h>

#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::delaunay {
namespace {

// Two skew lines far apart, with a short row of points on each.
std::vector<Point> points_on_two_lines(int on_each) {
  std::vector<Point> points;
  for (int i = 0; i < on_each; ++i) points.push_back({2 * i - on_each + 1, 0, 20 * on_each});
  for (int i = 0; i < on_each; ++i) points.push_back({0, 2 * i - on_each + 1, -20 * on_each});
  return points;
}

// "The insertion of a single vertex into an n-vertex Delaunay triangulation can delete Θ(n²)
// tetrahedra if the triangulation is the one depicted in Figure 4.2. However, a single vertex
// insertion can only create Θ(n) tetrahedra." The vertex in the middle is in every circumball.
TEST_CASE("Bowyer-Watson: one insertion deletes a quadratic number of tetrahedra") {
  for (const int m : {2, 5, 20}) {
    CAPTURE(m);
    std::vector<Point> set = points_on_two_lines(m);
    set.push_back({0, 0, 0});
    const PointSet points(set);
    const auto last = static_cast<Vertex>(points.size()) - 1;
    BowyerWatson algorithm(points);
    for (Vertex u = 0; u < last; ++u) {
      if (!contains(algorithm.first_simplex(), u)) algorithm.insert(u);
    }
    const auto quadratic = static_cast<std::size_t>((m - 1) * (m - 1));
    CHECK(algorithm.triangulation().simplices().size() == quadratic);
    algorithm.insert(last);
    CHECK(algorithm.last_insertion().deleted.size() == quadratic);
    // All vertices are on the hull: 2n − 4 facets of the cavity, none of them removed from it.
    CHECK(algorithm.last_insertion().created.size() == static_cast<std::size_t>(2 * 2 * m - 4));
  }
}

TEST_CASE("statistics: what a triangle, a point inside and a point outside create and delete") {
  const PointSet points({{0, 0}, {4, 0}, {0, 4}, {1, 1}, {9, 9}});
  Statistics statistics;
  bowyer_watson(points, {.order = InsertionOrder::kAsGiven}, &statistics);
  // Three triangles for one; then a triangle beyond the diagonal, and two ghosts for its one.
  CHECK(statistics.solid_simplices_created == 1 + 3 + 1);
  CHECK(statistics.solid_simplices_deleted == 1);
  CHECK(statistics.ghost_simplices_created == 3 + 2);
  CHECK(statistics.ghost_simplices_deleted == 1);
  CHECK(statistics.conflicts_created == 0);
  CHECK(statistics.walk_steps == 0);
  CHECK(statistics.conflict_tests > 0);
  bowyer_watson(points, {.location = PointLocation::kWalking}, &statistics);
  CHECK(statistics.walk_steps > 0);
  CHECK(statistics.solid_simplices_created == 5);
  bowyer_watson(points, {.location = PointLocation::kConflictGraph}, &statistics);
  CHECK(statistics.conflicts_created == 2);
  CHECK(statistics.walk_steps == 0);
}

}  // namespace
}  // namespace circumspect::delaunay
