// Meshes of doubles are compared as exact ones are.
#include "oracle/judge/mesh_difference.hpp"

#include <algorithm>
#include <numeric>
#include <random>

#include <doctest/doctest.h>

#include "kernel/exact/interruption.hpp"
#include "oracle/judge/counted_sets.hpp"
#include "oracle/judge/unlike_rows.hpp"

namespace circumspect::check {
namespace {

void are_compared_alike(const ExactMesh& a, const ExactMesh& b) {
  const auto found = difference(in_rows(a), in_rows(b));
  REQUIRE(found);
  const Difference expected = difference(a, b);
  CHECK(found->points_only_in_a == expected.points_only_in_a);
  CHECK(found->points_only_in_b == expected.points_only_in_b);
  CHECK(found->simplices_only_in_a == expected.simplices_only_in_a);
  CHECK(found->simplices_only_in_b == expected.simplices_only_in_b);
  CHECK(found->b_has_too == expected.b_has_too);
  CHECK(found->a_has_too == expected.a_has_too);
}

TEST_CASE("random meshes: points in any order, weighted or not, of either dimension, with faces") {
  std::mt19937 random(11);
  const auto below = [&random](unsigned n) { return random() % n; };
  for (int round = 0; round < 2000; ++round) {
    const auto mesh = [&] {
      std::vector<Point> all;
      const std::size_t dimension = below(12) == 0 ? 3 : 2;
      for (int x = -1; x < 2; ++x) {
        for (int y = -1; y < 2; ++y) {
          all.push_back({Rational(x) / 8, Rational(y)});
          if (dimension == 3) all.back().emplace_back(x + y);
        }
      }
      std::shuffle(all.begin(), all.end(), random);
      all.resize(1 + below(9));
      std::vector<Rational> weights;
      if (below(2) == 0) {
        for (std::size_t i = 0; i < all.size(); ++i)
          weights.emplace_back(static_cast<int>(below(2)));
      }
      const auto n = static_cast<unsigned>(all.size());
      const auto lists = [&](unsigned size) {
        std::vector<Simplex> some(below(6));
        for (Simplex& one : some) {
          for (unsigned i = 0; i < size; ++i) one.push_back(below(20) == 0 ? 12 : below(n));
        }
        return some;
      };
      return ExactMesh{PointSet(std::move(all), std::move(weights)), lists(3), {}, 0, {}, lists(2)};
    };
    are_compared_alike(mesh(), mesh());
  }
}

// Cells that both meshes list equally often are left out before.
TEST_CASE("random meshes of cells: some listed again, some missing, in any order, with faces") {
  std::mt19937 random(12);
  const auto below = [&random](std::size_t n) { return random() % n; };
  std::size_t same = 0;
  for (int round = 0; round < 2000; ++round) {
    const std::size_t size = 3 + below(2), points = size + below(5);
    std::vector<Point> all;
    for (std::size_t i = 0; i < points; ++i) {
      const int t = static_cast<int>(i);
      all.push_back({Rational(t) / 4, Rational(t * t), Rational(t % 3)});
    }
    std::vector<Simplex> cells(below(8));
    for (Simplex& cell : cells) {
      for (std::size_t i = 0; i < size; ++i) cell.push_back(static_cast<Vertex>(below(points)));
      if (below(30) == 0) cell.front() = below(2) == 0 ? -1 : 40;
    }
    std::vector<std::size_t> place(points);
    std::iota(place.begin(), place.end(), std::size_t{0});
    std::shuffle(place.begin(), place.end(), random);
    std::vector<Point> others(points);
    for (std::size_t i = 0; i < points; ++i) others[place[i]] = all[i];
    std::vector<Simplex> moved = cells;
    for (Simplex& cell : moved) {
      for (Vertex& v : cell) {
        if (v >= 0 && v < static_cast<Vertex>(points)) {
          v = static_cast<Vertex>(place[static_cast<std::size_t>(v)]);
        }
      }
      std::shuffle(cell.begin(), cell.end(), random);
    }
    if (below(2) == 0) std::shuffle(moved.begin(), moved.end(), random);
    if (!moved.empty() && below(3) == 0) moved.pop_back();
    if (!moved.empty() && below(3) == 0) moved.push_back(moved[below(moved.size())]);
    if (below(6) == 0) others.back()[0] += 1;
    ExactMesh a{PointSet(all), cells}, b{PointSet(others), moved};
    if (round % 2 == 0) {
      // Of any size: those of simplices, others, and some that are simplices of the other mesh.
      const auto faces = [&](const std::vector<Simplex>& theirs) {
        std::vector<Simplex> some(below(5));
        for (Simplex& face : some) {
          for (std::size_t i = 2 + below(size - 1); i > 0; --i) {
            face.push_back(static_cast<Vertex>(below(points)));
          }
        }
        if (!theirs.empty() && below(2) == 0) some.push_back(theirs[below(theirs.size())]);
        return some;
      };
      a.faces = faces(moved);
      b.faces = faces(cells);
    }
    are_compared_alike(a, b);
    are_compared_alike(b, a);
    same += difference(in_rows(a), in_rows(b))->empty() ? 1u : 0u;
  }
  CHECK(same > 200);
  CHECK(same < 1800);
}

// Cells whose search in a table for `count` of them begins at its last place.
std::vector<Simplex> colliding_cells(std::size_t count, Vertex points) {
  const CountedSets<3> table(count);
  const std::size_t last = count + count / 3;
  std::vector<Simplex> cells;
  for (Vertex i = 0; i < points && cells.size() < count; ++i) {
    for (Vertex j = i + 1; j < points && cells.size() < count; ++j) {
      for (Vertex k = j + 1; k < points && cells.size() < count; ++k) {
        const CountedSets<3>::Set set{static_cast<std::int32_t>(i), static_cast<std::int32_t>(j),
                                      static_cast<std::int32_t>(k)};
        if (table.home(set) == last) cells.push_back({i, j, k});
      }
    }
  }
  REQUIRE(cells.size() == count);
  return cells;
}

TEST_CASE("cells whose hashes collide are compared in another way, if they are many") {
  std::vector<Point> points;
  std::vector<Vertex> places;
  for (int i = 0; i < 80; ++i) {
    points.push_back({Rational(i), Rational(i * i)});
    places.push_back(i);
  }
  // With 30 cells it is the search for those that differ which takes too long.
  for (const std::size_t count : {std::size_t{20}, std::size_t{30}, std::size_t{200}}) {
    const ExactMesh a{PointSet(points), colliding_cells(count, 80)};
    ExactMesh b{PointSet(points), {a.simplices.rbegin(), a.simplices.rend()}};
    const auto is_looked_up = [&] {
      are_compared_alike(a, b);
      are_compared_alike(b, a);
      const Mesh of_a = in_rows(a), of_b = in_rows(b);
      return unlike_rows(of_a.simplices, of_b.simplices, places, points.size()).has_value();
    };
    CHECK(is_looked_up() == (count < 200));
    std::swap(b.simplices[0][0], b.simplices[0][1]);
    b.simplices[1] = b.simplices[2];
    CHECK(is_looked_up() == (count < 30));
  }
  // All cells of b are looked up before too many collide, but the last of a are not.
  const ExactMesh b{PointSet(points), colliding_cells(60, 80)};
  ExactMesh a{PointSet(points), {b.simplices.rbegin(), b.simplices.rend()}};
  a.simplices.insert(a.simplices.end(), 10, Simplex{77, 78, 79});
  are_compared_alike(a, b);
}

TEST_CASE("numbers that are not doubles are compared exactly") {
  const Rational third = Rational(1) / 3;
  const ExactMesh thirds{PointSet({{0, 0}, {third, 0}, {0, 1}}, {0, third, 0}), {{0, 1, 2}}};
  const ExactMesh doubles{PointSet({{0, 0}, {1, 0}, {0, 1}}), {{0, 1, 2}}};
  are_compared_alike(thirds, thirds);
  are_compared_alike(thirds, doubles);
  are_compared_alike(doubles, thirds);
}

TEST_CASE("points that are equal, as doubles and as other numbers, are not compared") {
  const auto mesh_of = [](const std::vector<Point>& points) {
    Mesh mesh;
    mesh.coordinates = numbers_of(points, 2);
    return mesh;
  };
  const Rational third = Rational(1) / 3;
  const Mesh one = mesh_of({{0, 0}});
  for (const Rational& x : {Rational(0), third}) {
    const Mesh twice = mesh_of({{x, 0}, {x, 0}});
    CHECK(!difference(twice, one));
    CHECK(!difference(one, twice));
  }
  CHECK(difference(one, one)->empty());
  CHECK(difference(mesh_of({}), one)->points_only_in_b == std::vector<Vertex>{0});
}

TEST_CASE("large meshes that are compared ask often whether anybody waits for them") {
  std::vector<Point> points;
  for (int i = 0; i < 100; ++i) points.push_back({Rational(i), Rational(i * i)});
  const ExactMesh many_points{PointSet(points), {}};
  std::vector<Point> in_thirds = points;
  in_thirds[0][0] = Rational(1) / 3;
  const ExactMesh no_doubles{PointSet(in_thirds), {}};
  points.resize(3);
  const ExactMesh many_cells{PointSet(points), std::vector<Simplex>(100, Simplex{0, 1, 2})};
  const ExactMesh few{PointSet(points), {{0, 1, 2}}};
  const Interruption past{nullptr, std::chrono::steady_clock::now() - std::chrono::hours(1)};
  const auto is_ended = [&past](const ExactMesh& a, const ExactMesh& b) {
    const Mesh rows_of_a = in_rows(a), rows_of_b = in_rows(b);
    const Interruptible interruptible(&past);
    CHECK_THROWS_AS(difference(rows_of_a, rows_of_b), Interrupted);
    CHECK_THROWS_AS(difference(a, b), Interrupted);
  };
  is_ended(many_points, many_points);
  is_ended(no_doubles, no_doubles);
  is_ended(many_cells, few);
  is_ended(few, many_cells);
  const Mesh doubles = in_rows(many_points), others = in_rows(no_doubles);
  const Interruptible interruptible(&past);
  CHECK_THROWS_AS(equal_points(doubles), Interrupted);
  CHECK_THROWS_AS(equal_points(others), Interrupted);
  CHECK_THROWS_AS(doubles.exact_points(), Interrupted);
}

}  // namespace
}  // namespace circumspect::check
