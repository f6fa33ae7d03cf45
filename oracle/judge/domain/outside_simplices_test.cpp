// domain.outside counts simplices: as many as the definition finds.
#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"
#include "oracle/judge/domain/domain_cases_test.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"

namespace circumspect::check {
namespace {

std::size_t outside(const ExactMesh& mesh, const Domain& domain, By by) {
  const Verdict verdict =
      judge_exactly(Claim::kSteinerTriangulation, mesh, &domain, {.by = by, .max_violations = 0});
  const auto tally = verdict.tallies().find(Rule::kOutside);
  if (tally == verdict.tallies().end()) return 0;
  std::set<Simplex> named;
  for (const Violation& violation : verdict.violations()) {
    if (violation.rule != Rule::kOutside) continue;
    CHECK(violation.witness.simplices.size() == 1);
    CHECK(named.insert(sorted(violation.witness.simplices.front())).second);
  }
  CHECK(named.size() == tally->second.count);
  return tally->second.count;
}
void check_in_this_order(std::size_t count, const ExactMesh& mesh, const Domain& domain) {
  CHECK(outside(mesh, domain, By::kDefinition) == count);
  CHECK(outside(mesh, domain, By::kLemma) == count);
  // The fast engine knows that such a mesh is sound.
  const auto known = exact_facts(Claim::kSteinerTriangulation, mesh, domain);
  const Verdict verdict =
      judge_domain(Claim::kSteinerTriangulation, mesh, domain, {}, known ? &*known : nullptr);
  CHECK(verdict.tallies().at(Rule::kOutside).count == count);
}
void check_outside(std::size_t count, ExactMesh mesh, const Domain& domain) {
  check_in_this_order(count, mesh, domain);
  // What is in the middle comes first, or last.
  std::rotate(mesh.simplices.begin(), mesh.simplices.begin() + std::ssize(mesh.simplices) / 2,
              mesh.simplices.end());
  check_in_this_order(count, mesh, domain);
  std::reverse(mesh.simplices.begin(), mesh.simplices.end());
  check_in_this_order(count, mesh, domain);
}

// A square with a square hole.
Domain ring_around_hole() {
  const PiecewiseLinearInput outer = cuboid({0, 0}, {12, 12}), inner = cuboid({4, 4}, {8, 8});
  PiecewiseLinearInput ring = outer;
  const auto first = static_cast<Vertex>(ring.points.size());
  ring.points.insert(ring.points.end(), inner.points.begin(), inner.points.end());
  for (const auto& segment : inner.segments) {
    ring.segments.push_back({segment[0] + first, segment[1] + first});
  }
  ring.hole_seeds = {{6, 6}};
  return domain_of(ring);
}

}  // namespace

TEST_CASE("domain.outside: a filled hole counts with all its simplices, not with its walls") {
  // A ring of eight squares, and the ninth in a grid of its own, whose middle touches no wall.
  const std::vector<int> lines = {0, 4, 5, 7, 8, 12};
  check_outside(18, grid(lines, lines, {0}, every_cell), ring_around_hole());
}

TEST_CASE("domain.outside: facets next to nothing, some of them in a hole") {
  const std::vector<int> lines = {0, 1, 2, 4, 5, 7, 8, 12};
  ExactMesh mesh = grid(lines, lines, {0}, every_cell);
  // Two triangles are missing that touch no wall.
  for (const Point& centre : {Point{Rational(3, 2), Rational(3, 2)}, Point{6, 6}}) {
    const auto touches = [&](const Simplex& simplex) {
      const auto corners = coordinates(mesh.points, simplex);
      return std::all_of(corners.begin(), corners.end(), [&](const Point& corner) {
        return abs(corner[0] - centre[0]) <= 1 && abs(corner[1] - centre[1]) <= 1;
      });
    };
    mesh.simplices.erase(std::find_if(mesh.simplices.begin(), mesh.simplices.end(), touches));
  }
  check_outside(17, mesh, ring_around_hole());
  const Domain domain = ring_around_hole();
  const Verdict verdict = judge_exactly(Claim::kSteinerTriangulation, mesh, &domain);
  CHECK(verdict.tallies().at(Rule::kUncovered).count == 3);
}

TEST_CASE("domain.outside: what stands on a wall of a cube, counted once for several facets") {
  const std::vector<int> three = {0, 4, 8};
  check_outside(6, grid({0, 4}, {0, 4}, three, every_cell),
                domain_of(cuboid({0, 0, 0}, {4, 4, 4})));
}

TEST_CASE("domain.outside: all simplices at a point that makes a convex hull larger") {
  PiecewiseLinearInput hull;
  hull.points = {{0, 0}, {3, 0}, {0, 3}, {1, 1}};
  hull.kind = DomainKind::kHull;
  std::vector<Point> points = hull.points;
  points.push_back({2, 2});
  check_outside(2, {PointSet(points), {{0, 1, 3}, {1, 4, 3}, {4, 2, 3}, {2, 0, 3}}},
                domain_of(hull));
}

TEST_CASE("domain.outside: a hull is compared only where the mesh has no notch") {
  PiecewiseLinearInput hull;
  hull.points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}};
  hull.kind = DomainKind::kHull;
  std::vector<Point> points = hull.points;
  points.push_back({5, 2});
  const auto broken_by = [&](const std::vector<Simplex>& simplices) {
    return broken(Claim::kSteinerTriangulation, {PointSet(points), simplices}, domain_of(hull));
  };
  CHECK(broken_by({{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {1, 5, 2}, {3, 0, 4}}) ==
        std::set{Rule::kOutside});
  CHECK(broken_by({{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {1, 5, 2}}) == std::set{Rule::kHullNotConvex});
}

}  // namespace circumspect::check
