// What is hatched where a list of facets of a hull ends.
#include "oracle/picture/gap.hpp"

#include <doctest/doctest.h>

#include "oracle/model/exact_mesh.hpp"
#include "oracle/picture/picture.hpp"

namespace circumspect::picture {
namespace {

using report::Json;

std::vector<std::vector<int>> gaps_of(const ExactMesh& hull) {
  Verdict verdict(Claim::kConvexHull, 0);
  const Mesh rows = in_rows(hull);
  for (const Simplex& ridge : boundary(rows)) {
    for (const Simplex& facet : hull.simplices) {
      if (!has_face(facet, ridge)) continue;
      verdict.add(Rule::kHullUncovered, {.simplices = {facet}, .face = ridge});
    }
  }
  std::vector<std::vector<int>> gaps;
  for (const Json& picture : pictures(verdict, rows, nullptr, 20)) {
    gaps.emplace_back();
    for (const Json& place : picture["gap"]) {
      gaps.back().push_back(
          std::stoi(picture["names"][place.get<std::size_t>()].get<std::string>()));
    }
  }
  return gaps;
}

using Gaps = std::vector<std::vector<int>>;

TEST_CASE("gap: in the plane it leads along the boundary to the next vertex of a facet") {
  const PointSet square({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}});
  CHECK(gaps_of({square, {{0, 1}, {1, 2}, {2, 3}}}) == Gaps{{0, 3}, {3, 0}});
  CHECK(gaps_of({square, {{0, 1}, {2, 3}}}) == Gaps{{0, 3}, {1, 2}, {2, 1}, {3, 0}});
  // A corner of the hull that no facet has, and a point in the middle of a side.
  CHECK(gaps_of({square, {{0, 1}, {1, 2}}}) == Gaps{{0, 3, 2}, {2, 3, 0}});
  const PointSet with_middle({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 2}});
  CHECK(gaps_of({with_middle, {{0, 1}, {1, 2}, {2, 3}}}) == Gaps{{0, 4, 3}, {3, 4, 0}});
  CHECK(gaps_of({with_middle, {{1, 2}, {2, 3}, {3, 4}}}) == Gaps{{1, 0, 4}, {4, 0, 1}});
  // What was passed is in line with the way, and nearer than what comes.
  const PointSet low_middle({{4, 0}, {4, 4}, {0, 4}, {0, 1}, {0, 0}});
  CHECK(gaps_of({low_middle, {{4, 0}, {0, 1}, {1, 2}}}) == Gaps{{2, 3, 4}, {4, 3, 2}});
}

TEST_CASE("gap: in space it is the ridges around it, one after the other") {
  const PointSet octahedron({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
  std::vector<Simplex> facets;
  for (const Vertex apex : {4, 5}) {
    for (Vertex v = 0; v < 4; ++v) facets.push_back({v, (v + 1) % 4, apex});
  }
  CHECK(gaps_of({octahedron, {facets.begin() + 1, facets.end()}}) ==
        Gaps{{0, 1, 4}, {0, 4, 1}, {1, 4, 0}});
  const auto half = gaps_of({octahedron, {facets.begin() + 4, facets.end()}});
  REQUIRE(half.size() == 4);
  CHECK(half.front() == std::vector{0, 1, 2, 3});
}

}  // namespace
}  // namespace circumspect::picture
