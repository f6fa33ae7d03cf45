// Cells, and the difference of two meshes.
#include "oracle/judge/points/cells.hpp"

#include <algorithm>
#include <random>
#include <set>

#include <doctest/doctest.h>

namespace circumspect::check {

// The cells that two lists have in common, compared with a search one by one.

namespace {

CellList cells_of_lists(const std::vector<Simplex>& lists) {
  CellList cells;
  for (const Simplex& list : lists) cells.add(list);
  return cells;
}

std::vector<Simplex> lists_of(const CellList& cells) {
  std::vector<Simplex> lists;
  for (std::size_t i = 0; i < cells.size(); ++i)
    lists.emplace_back(cells[i].begin(), cells[i].end());
  return lists;
}

// The plain way: for each cell of a, strikes out the first equal cell of b.
CellDifference by_hand(const std::vector<Simplex>& a, std::vector<Simplex> b,
                       const std::vector<Vertex>& place_in_b) {
  CellDifference result;
  for (const Simplex& cell : a) {
    Simplex image;
    bool is_whole = true;
    for (const Vertex v : cell) {
      const bool names = v >= 0 && v < static_cast<Vertex>(place_in_b.size());
      image.push_back(names ? place_in_b[static_cast<std::size_t>(v)] : -1);
      is_whole = is_whole && image.back() >= 0;
    }
    const auto met = std::find_if(b.begin(), b.end(), [&image](const Simplex& other) {
      return sorted(other) == sorted(image);
    });
    if (!is_whole || met == b.end()) {
      result.only_in_a.push_back(cell);
    } else {
      b.erase(met);
    }
  }
  result.only_in_b = std::move(b);
  return result;
}

TEST_CASE("random lists: vertices that name nothing, cells listed twice, cells of any size") {
  std::mt19937 random(7);
  const auto below = [&random](int n) {
    return static_cast<Vertex>(random() % static_cast<unsigned>(n));
  };
  for (int round = 0; round < 3000; ++round) {
    const int points = 1 + static_cast<int>(below(6));
    std::vector<Vertex> place_in_b(static_cast<std::size_t>(points));
    for (int v = 0; v < points; ++v) place_in_b[static_cast<std::size_t>(v)] = v;
    std::shuffle(place_in_b.begin(), place_in_b.end(), random);
    if (below(3) == 0) place_in_b.front() = -1;
    const auto lists = [&] {
      std::vector<Simplex> all(static_cast<std::size_t>(below(9)));
      for (Simplex& list : all) {
        list.resize(1 + static_cast<std::size_t>(below(3)));
        for (Vertex& v : list) v = below(10) == 0 ? below(20) - 10 : below(points);
      }
      return all;
    };
    const std::vector<Simplex> a = lists(), b = lists();
    const CellDifference found = difference_of_cells(cells_of_lists(a), cells_of_lists(b),
                                                     place_in_b, static_cast<std::size_t>(points));
    const CellDifference expected = by_hand(a, b, place_in_b);
    CHECK(found.only_in_a == expected.only_in_a);
    // Equal cells that are left may be at the place of an earlier one.
    CHECK(std::multiset<Simplex>(found.only_in_b.begin(), found.only_in_b.end()) ==
          std::multiset<Simplex>(expected.only_in_b.begin(), expected.only_in_b.end()));
  }
}

TEST_CASE("faces dangle if no cell and no larger dangling face has them") {
  const auto one_cell = [](const auto& visit) { visit(Simplex{3, 1, 0, 2}); };
  CHECK(lists_of(dangling_faces(
            {{4, 3}, {2, 1}, {3, 2, 1}, {3, 4, 5}, {5, 4}, {5, 4, 3}, {6, 5}, {5, 6}}, one_cell,
            7)) == std::vector<Simplex>{{3, 4, 5}, {6, 5}});
  const auto no_cell = [](const auto&) {};
  CHECK(lists_of(dangling_faces({{9, 1}, {1, 9}, {-3, 1}}, no_cell, 2)) ==
        std::vector<Simplex>{{9, 1}, {-3, 1}});
  // A lone vertex is not a face of a cell, but a cell of one vertex is that vertex.
  CHECK(dangling_faces({{3}}, one_cell, 7).size() == 1);
  CHECK(dangling_faces(
            {{3}}, [](const auto& visit) { visit(Simplex{3}); }, 7)
            .size() == 0);
}

TEST_CASE("faces are stray if no cell has their different vertices, whatever else is listed") {
  const auto one_cell = [](const auto& visit) { visit(Simplex{3, 1, 0, 9}); };
  CHECK(stray_faces({{0, 3}, {1, 9}, {3, 1, 0}, {0, 1, 2}, {3, 3}, {1}, {0, 2}, {2, 0}}, one_cell,
                    4) == std::vector<std::size_t>{1, 3, 4, 5, 6, 7});
  CHECK(stray_faces({{0, 1}, {1, 0}}, one_cell, 4).empty());
  const auto no_cell = [](const auto&) {};
  CHECK(stray_faces({{0, 1}}, no_cell, 4) == std::vector<std::size_t>{0});
}

// Two meshes are the same complex, or the differences are named.

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
  CHECK(difference(a, b).a_has_too == std::vector<bool>{true});
  CHECK(difference(b, a).simplices_only_in_a == std::vector<Simplex>{{2, 1, 0}});
  CHECK(difference(b, a).b_has_too == std::vector<bool>{true});
  const ExactMesh c = square({0, 1, 2, 3}, {{1, 2, 3}});
  CHECK(difference(c, b).a_has_too == std::vector<bool>{false, false});
  CHECK(difference(b, c).b_has_too == std::vector<bool>{false, false});
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
