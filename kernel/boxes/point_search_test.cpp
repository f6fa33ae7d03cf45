// The search against a look at every simplex, and how much it asks.
#include "kernel/boxes/point_search.hpp"

#include <array>

#include <doctest/doctest.h>

#include "kernel/boxes/box_index.hpp"

namespace circumspect {
namespace {

using Place = std::array<std::int64_t, 2>;

// Triangles in the plane, and what is beyond the edge opposite each vertex.
struct Triangles {
  std::vector<Place> places = {};
  std::vector<std::array<std::size_t, 3>> rows = {};
  std::vector<std::array<std::size_t, 3>> beyond = {};

  std::size_t size() const { return rows.size(); }
  std::size_t row_size() const { return 3; }
  std::size_t points() const { return places.size(); }
  std::size_t vertex(std::size_t s, std::size_t place) const { return rows[s][place]; }
  std::size_t across(std::size_t s, std::size_t place) const { return beyond[s][place]; }
  int side(std::size_t s, std::size_t place, std::size_t point) const {
    std::array<std::size_t, 3> moved = rows[s];
    moved[place] = point;
    const auto [a, b, c] = std::array{places[moved[0]], places[moved[1]], places[moved[2]]};
    const std::int64_t twice_the_area =
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    return twice_the_area > 0 ? 1 : (twice_the_area < 0 ? -1 : 0);
  }
  bool covers(std::size_t s, std::size_t point) const {
    return side(s, 0, point) >= 0 && side(s, 1, point) >= 0 && side(s, 2, point) >= 0;
  }
};

// n triangles with one apex and their bases on a line.
Triangles fan(std::size_t n) {
  Triangles mesh;
  const auto width = static_cast<std::int64_t>(n);
  for (std::int64_t x = 0; x <= width; ++x) mesh.places.push_back({8 * x, 0});
  mesh.places.push_back({4 * width, 8 * width});
  for (std::size_t s = 0; s < n; ++s) {
    mesh.rows.push_back({s, s + 1, n + 1});
    mesh.beyond.push_back({s + 1 < n ? s + 1 : kNoSimplex, s > 0 ? s - 1 : kNoSimplex, kNoSimplex});
  }
  return mesh;
}

// n by n squares, each cut into two triangles.
Triangles grid(std::size_t n) {
  Triangles mesh;
  const auto at = [&](std::size_t x, std::size_t y) { return y * (n + 1) + x; };
  const auto square = [&](std::size_t x, std::size_t y) { return 2 * (y * n + x); };
  for (std::size_t v = 0; v < (n + 1) * (n + 1); ++v) {
    mesh.places.push_back(
        {8 * static_cast<std::int64_t>(v % (n + 1)), 8 * static_cast<std::int64_t>(v / (n + 1))});
  }
  for (std::size_t y = 0; y < n; ++y) {
    for (std::size_t x = 0; x < n; ++x) {
      mesh.rows.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      mesh.beyond.push_back({x + 1 < n ? square(x + 1, y) + 1 : kNoSimplex, square(x, y) + 1,
                             y > 0 ? square(x, y - 1) + 1 : kNoSimplex});
      mesh.rows.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
      mesh.beyond.push_back({y + 1 < n ? square(x, y + 1) : kNoSimplex,
                             x > 0 ? square(x - 1, y) : kNoSimplex, square(x, y)});
    }
  }
  return mesh;
}

// Adds points that are not vertices, in the box of the mesh and a little around it, many on edges.
std::vector<std::size_t> with_points(Triangles& mesh, std::size_t count, std::int64_t width) {
  std::mt19937_64 random(11);
  std::vector<std::size_t> added;
  for (std::size_t i = 0; i < count; ++i) {
    const auto next = [&] {
      return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(8 * width + 4)) - 2;
    };
    added.push_back(mesh.places.size());
    mesh.places.push_back({next(), next()});
  }
  return added;
}

void check_answers(const Triangles& mesh, const std::vector<std::size_t>& points) {
  PointSearch search(mesh);
  const std::vector<std::size_t> found = search.simplices_with(points);
  REQUIRE(found.size() == points.size());
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool is_covered = false;
    for (std::size_t s = 0; s < mesh.size(); ++s) is_covered |= mesh.covers(s, points[i]);
    const bool is_right = found[i] == kNoSimplex ? !is_covered : mesh.covers(found[i], points[i]);
    wrong += is_right ? 0 : 1;
  }
  CHECK(wrong == 0);
}

TEST_CASE("PointSearch: finds a simplex wherever there is one") {
  for (const std::size_t n : {1, 3, 40, 1500}) {
    Triangles mesh = fan(n);
    check_answers(mesh, with_points(mesh, 1500, static_cast<std::int64_t>(n)));
  }
  for (const std::size_t n : {1, 3, 30}) {
    Triangles mesh = grid(n);
    check_answers(mesh, with_points(mesh, 3000, static_cast<std::int64_t>(n)));
  }
  check_answers(Triangles{{{0, 0}}}, {0});
}

TEST_CASE("PointSearch: walks that never arrive are no hindrance") {
  Triangles mesh = fan(300);
  const auto points = with_points(mesh, 900, 300);
  for (std::size_t s = 0; s < mesh.size(); ++s) mesh.beyond[s].fill((s + 1) % 7);
  check_answers(mesh, points);
}

std::uint64_t work(Triangles mesh, std::size_t n) {
  const auto points = with_points(mesh, mesh.size(), static_cast<std::int64_t>(n));
  PointSearch search(mesh);
  search.simplices_with(points);
  return search.work();
}

// A walk from each point to the next takes a third of the simplices in a fan.
TEST_CASE("PointSearch: as many points as simplices take near-linear work") {
  CHECK(work(fan(20000), 20000) < 20000 * 150);
  CHECK(work(fan(40000), 40000) < 5 * work(fan(10000), 10000));
  CHECK(work(grid(100), 100) < 20000 * 150);
  CHECK(work(grid(200), 200) < 7 * work(grid(100), 100));
}

}  // namespace
}  // namespace circumspect
