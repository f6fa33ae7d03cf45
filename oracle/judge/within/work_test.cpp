// What the search for the least reach costs.
#include "oracle/judge/within/work.hpp"

#include <doctest/doctest.h>

#include "oracle/judge/within/moved_meshes_test.hpp"

namespace circumspect::check {
namespace {

using Random = std::mt19937_64;

struct Done {
  std::size_t work;
  std::optional<Rational> squared_reach;
};
Done done(const ExactMesh& mesh, const Domain& domain, const Rational& squared_distance,
          unsigned threads = 1) {
  Work work;
  const auto verdict = judge_within(Claim::kSteinerTriangulation, mesh, domain, squared_distance,
                                    {.threads = threads}, nullptr, nullptr, {}, &work);
  Done result{work.done(), {}};
  if (verdict && verdict->within) result.squared_reach = verdict->within->squared_reach;
  return result;
}

std::vector<Point> times(const Rational& factor, std::vector<Point> points) {
  for (Point& point : points) point = factor * point;
  return points;
}

// A slanted square, listed as triangles between so many vertices a side, each a few bits off it.
MovedMesh sheet(int side, Random& random) {
  PiecewiseLinearInput input;
  input.points = {{0, 0, 0}, {side, 0, 0}, {side, side, 0}, {0, side, 0}};
  input.polygons = {{{{0, 1, 2, 3}}, {}}};
  std::vector<int> lines;
  for (int i = 0; i <= side; ++i) lines.push_back(i);
  const ExactMesh flat = grid(lines, lines, {0}, every_cell);
  std::vector<Point> points;
  for (const Point& p : flat.points.points()) points.push_back({p[0], p[1], 0});
  ExactMesh mesh{PointSet(points), {}};
  mesh.faces = flat.simplices;
  const Domain domain = domain_of(slanted(input));
  return {shaken(slanted(mesh), random, 1'000'000), domain};
}

// A polygon around a slanted rectangle, with so many vertices on two of its sides.
MovedMesh strip(int length, Random& random) {
  std::vector<int> lines;
  for (int i = 0; i <= length; ++i) lines.push_back(i);
  const ExactMesh mesh = slanted(grid(lines, {0, 1}, {0}, every_cell));
  const Domain domain = domain_of(slanted(cuboid({0, 0}, {length, 1})));
  return {shaken(mesh, random, 1'000'000), domain};
}

}  // namespace

TEST_CASE(
    "within: four times as many vertices in a polygon or a segment take four times the work") {
  // Each vertex is at another distance. A search that goes from one distance to the next takes 16
  // times as much.
  Random random(1);
  const Rational squared(1, 10'000);
  for (const auto& make : {&sheet, &strip}) {
    const int few = make == &sheet ? 8 : 100, many = make == &sheet ? 16 : 400;
    const MovedMesh small = make(few, random), large = make(many, random);
    const Done of_small = done(small.mesh, small.domain, squared);
    const Done of_large = done(large.mesh, large.domain, squared);
    REQUIRE(of_small.squared_reach);
    REQUIRE(of_large.squared_reach);
    CHECK(sign(*of_large.squared_reach) > 0);
    CHECK(of_large.work < 6 * of_small.work);
  }
}

TEST_CASE("within: numbers whose squares are not doubles take no more work") {
  Random random(2);
  int moved = 0;
  for (const std::size_t dimension : {2, 3, 3, 3, 2, 2}) {
    MovedMesh mesh = random_mesh(random, dimension);
    mesh.mesh = shaken(mesh.mesh, random);
    const Done plain = done(mesh.mesh, mesh.domain, kSquaredLimit);
    for (const bool is_large : {false, true}) {
      Rational factor = Rational(Integer(1) << 900);
      if (!is_large) factor = 1 / factor;
      PiecewiseLinearComplex complex = mesh.domain.complex;
      complex.points = PointSet(times(factor, complex.points.points()));
      complex.hole_seeds = times(factor, complex.hole_seeds);
      const ExactMesh scaled = with_points(mesh.mesh, times(factor, mesh.mesh.points.points()));
      const Done other = done(scaled, {complex}, factor * factor * kSquaredLimit);
      REQUIRE(other.squared_reach.has_value() == plain.squared_reach.has_value());
      if (plain.squared_reach) {
        CHECK(*other.squared_reach == factor * factor * *plain.squared_reach);
        ++moved;
      }
      CHECK(other.work <= plain.work + plain.work / 10);
      CHECK(plain.work <= other.work + other.work / 10);
    }
  }
  CHECK(moved > 4);
}

TEST_CASE("within: a search that takes more than it may is given up, on any number of threads") {
  Random random(3);
  MovedMesh mesh = strip(600, random);
  const std::size_t needed = done(mesh.mesh, mesh.domain, Rational(1, 10'000)).work;
  CHECK(done(mesh.mesh, mesh.domain, Rational(1, 10'000), 4).work == needed);
  for (const unsigned threads : {1U, 4U}) {
    for (const std::size_t most : {std::size_t{0}, needed / 2, needed - 1, needed}) {
      Work work(most);
      const auto verdict =
          judge_within(Claim::kSteinerTriangulation, mesh.mesh, mesh.domain, Rational(1, 10'000),
                       {.threads = threads}, nullptr, nullptr, {}, &work);
      CHECK(verdict.has_value() == (most == needed));
      CHECK(work.is_too_much() == (most < needed));
      if (!verdict) CHECK(!verdict.error().is_input_fault);
    }
  }
}

}  // namespace circumspect::check
