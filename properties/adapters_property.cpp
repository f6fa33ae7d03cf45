// Programs that people use, held to their claims in this process: CGAL on every family of inputs,
// TetGen and Qhull where their documents name no limit. Campaigns go further (hunt/pages/).
#include <circumspect/judgement.hpp>
#include <doctest/doctest.h>

#include "inputs/cases.hpp"
#include "inputs/complex_families.hpp"
#include "inputs/families.hpp"
#include "inputs/in_doubles.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "oracle/judge/domain/judge_domain.hpp"
#include "properties/adapters/adapters.hpp"

namespace circumspect::adapters {
namespace {

using generators::ComplexCase;
using generators::Family;

constexpr std::size_t kPoints = 12;

PointArray drawn(const Family& family, std::size_t dimension, std::uint64_t seed) {
  const auto set = generators::drawn(family, dimension, {kPoints}, seed);
  return generators::array(generators::in_doubles(set, family.repeats_points), dimension);
}

// Holds a program to a claim on so many sets of every family; says on how many.
std::size_t hold_on_all_families(const Triangulator& program, const std::string& claim,
                                 std::size_t dimension, std::uint64_t each) {
  std::size_t cases = 0;
  for (const Family& family : generators::modified_families()) {
    const bool fits = family.weighted == (claim == "weighted-delaunay");
    if (!fits || !family.exists_in(dimension)) continue;
    for (std::uint64_t seed = 0; seed < each; ++seed, ++cases) {
      const PointArray points = drawn(family, dimension, seed);
      const Judgement judgement =
          judge(claim, points, program(points), {.merge_equal_points = true, .allow_empty = true});
      CHECK_MESSAGE(judgement.holds, family.name << " --seed " << seed << "\n" << judgement.report);
    }
  }
  return cases;
}

// The same on sets of a generic family that span the space.
std::size_t hold_on_generic_sets(const Triangulator& program, std::size_t dimension) {
  const Family& family = *generators::find_family("uniform");
  std::size_t cases = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const PointArray points = drawn(family, dimension, seed);
    if (points.size() < dimension + 2) continue;
    ++cases;
    const Judgement judgement = judge("delaunay", points, program(points));
    CHECK_MESSAGE(judgement.holds, "uniform --seed " << seed << "\n" << judgement.report);
  }
  return cases;
}

Verdict constrained_verdict(ComplexCase whole) {
  whole.input.kind = DomainKind::kHull;
  whole.input.hole_seeds.clear();
  Segments segments;
  for (const auto& s : whole.input.segments) segments.push_back({s[0], s[1]});
  const SimplexArray rows =
      cgal_constrained_2(generators::array({whole.input.points, {}}, 2), segments);
  const ExactMesh mesh{PointSet(whole.input.points),
                       std::vector<Simplex>(rows.begin(), rows.end())};
  return check::judge_domain(Claim::kCdt, mesh, {whole.complex()});
}

}  // namespace

TEST_CASE("CGAL's Delaunay triangulations are Delaunay, on every family") {
  CHECK(hold_on_all_families(cgal_delaunay_2, "delaunay", 2, 2) > 200);
  CHECK(hold_on_all_families(cgal_delaunay_3, "delaunay", 3, 2) > 200);
}

TEST_CASE("CGAL's regular triangulation is weighted Delaunay, on every family with weights") {
  CHECK(hold_on_all_families(cgal_regular_3, "weighted-delaunay", 3, 10) > 50);
}

TEST_CASE("CGAL's constrained Delaunay triangulation is one, on every planar domain") {
  std::size_t cases = 0;
  for (const auto& family : generators::complex_families()) {
    if (family.dimension != 2) continue;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const auto whole = generators::in_doubles(generators::drawn(family, kPoints, seed));
      const PointSet points(whole.input.points);
      if (points.dimension() != 2) continue;
      ++cases;
      CHECK_MESSAGE(constrained_verdict(whole).holds(), family.name << " --seed " << seed);
    }
  }
  CHECK(cases > 50);
}

TEST_CASE("CGAL's is_valid() takes what CGAL makes, and not what has the wrong diagonal") {
  const Family& family = *generators::find_family("uniform");
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const PointArray points = drawn(family, 3, seed);
    SimplexArray rows = cgal_delaunay_3(points);
    if (points.size() < 5 || rows.size() < 2) continue;
    CHECK(cgal_is_valid_3(points, rows) == Opinion::kValid);
    rows.push_back(rows.front());
    CHECK(cgal_is_valid_3(points, rows) == Opinion::kNoDataStructure);
  }
  // Two tetrahedra on one facet; each has the other's apex in its ball.
  const PointArray flat_pair{3, {0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, 1, 1, 1, -1}, {}};
  CHECK(cgal_is_valid_3(flat_pair, {{0, 1, 2, 3}, {0, 2, 1, 4}}) == Opinion::kInvalid);
}

TEST_CASE("TetGen's and Qhull's Delaunay triangulations are Delaunay, on generic points") {
  CHECK(hold_on_generic_sets(tetgen_delaunay, 3) > 20);
  for (const std::size_t dimension : {2u, 3u, 4u}) {
    CHECK(hold_on_generic_sets(qhull_delaunay, dimension) > 20);
  }
}

TEST_CASE("Qhull says with an exception that it takes no points of a plane") {
  const PointArray flat{3, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 2, 3, 0}, {}};
  CHECK_THROWS_AS(qhull_delaunay(flat), std::runtime_error);
}

}  // namespace circumspect::adapters
