// Every mutation of the catalogue on meshes of 10^5 points, made by CGAL: the fast judge vouches
// for none, and `judge` names a rule that the catalogue expects, in the words of the exact
// checkers, for one thread as for four.
#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "oracle/judge/domain/judge_exactly.hpp"
#include "properties/adapters/adapters.hpp"
#include "properties/arguments/run.hpp"
#include "properties/catalogue_verdicts.hpp"

namespace circumspect::properties {
namespace {

constexpr std::size_t kPoints = 100'000;
constexpr std::uint64_t kSeeds = 3;  // of each mutation; the exact checkers see its first mutant

// Where `make soak` draws another seed each round.
std::uint64_t first_seed() { return rc::detail::configuration().testParams.seed; }

double between(double least, double most, Dice& dice) {
  return least + (most - least) * static_cast<double>(dice.below(std::size_t{1} << 53)) * 0x1p-53;
}

PointArray random_points(std::size_t d, Dice& dice) {
  PointArray points{d, {}, {}};
  for (std::size_t i = 0; i < d * kPoints; ++i) points.coordinates.push_back(between(-1, 1, dice));
  return points;
}

// As many as there are with this number along each axis.
PointArray grid_points(std::size_t d, std::size_t side) {
  PointArray points{d, {}, {}};
  std::size_t count = 1;
  for (std::size_t axis = 0; axis < d; ++axis) count *= side;
  for (std::size_t v = 0; v < count; ++v) {
    std::size_t rest = v;
    for (std::size_t axis = 0; axis < d; ++axis, rest /= side) {
      points.coordinates.push_back(static_cast<double>(rest % side) -
                                   static_cast<double>(side / 2));
    }
  }
  return points;
}

ArrayMesh mesh_by(SimplexArray (*triangulate)(const PointArray&), const PointArray& points) {
  ArrayMesh mesh{points.dimension, points.coordinates, points.weights, {}, {}};
  for (const auto& row : triangulate(points)) {
    mesh.simplices.insert(mesh.simplices.end(), row.begin(), row.end());
  }
  list_neighbors(mesh);
  return mesh;
}

Claim claim_of(const ArrayMesh& mesh) {
  return mesh.weights.empty() ? Claim::kDelaunay : Claim::kWeightedDelaunay;
}

// What is said of the mutants of one mutation, and how often.
using Answers = std::map<std::string, std::size_t>;

// With the neighbours that are left, with none, and of the first mutant also with right ones and
// with those of the mesh before.
void ask_the_fast_judge(const Mutation& mutation, ArrayMesh mutant, const ArrayMesh& mesh,
                        bool is_first, Answers& answers) {
  const auto ask = [&](Claim claim) {
    const std::string said = said_fast(mutant, claim);
    ++answers[said];
    CHECK(fault_of_fast(mutation, said) == "");
  };
  if (!mutant.neighbors.empty()) ask(claim_of(mutant));
  if (mutation.rules.contains(Rule::kWrongNeighbor)) return;
  mutant.neighbors.clear();
  ask(claim_of(mutant));
  if (!is_first) return;
  if (mutant.weights.empty() && breaks_any_triangulation(mutation)) ask(Claim::kTriangulation);
  list_neighbors(mutant);
  ask(claim_of(mutant));
  if (mutant.simplices.size() == mesh.simplices.size() && mutation.expected != Expected::kHolds) {
    mutant.neighbors = mesh.neighbors;
    ask(claim_of(mutant));
  }
}

// The rule that is named first, and "holds" if none is. On one to four threads the judge says, word
// for word, what the exact checkers say.
std::string named_rule(const Mutation& mutation, ArrayMesh mutant) {
  if (mutation.expected == Expected::kEqualPoints) {
    mutant.neighbors.clear();
  } else if (mutant.neighbors.empty()) {
    list_neighbors(mutant);
  }
  const Claim claim = claim_of(mutant);
  const Mesh merged = mesh_of(mutant, claim);
  const Verdict slow = check::judge_exactly(claim, exact(merged));
  std::string rule;
  for (unsigned threads = 1; threads <= 4; ++threads) {
    CAPTURE(threads);
    const MeshJudgement judged = judge(claim, mutant, threads);
    CHECK(fault_of(mutation, judged, slow, merged) == "");
    rule = judged.holds ? "holds" : judged.rule;
  }
  return rule;
}

void hold_catalogue_against(const std::string& what, const ArrayMesh& mesh) {
  std::cout << what << ": " << mesh.points() << " points, " << mesh.size() << " simplices, seed "
            << first_seed() << std::endl;
  CAPTURE(what);
  if (!has_time()) return;
  REQUIRE(said_fast(mesh, claim_of(mesh)) == "accepted");
  // A soak that has no time for all of them begins with another each time.
  std::vector<Mutation> all = catalogue();
  std::rotate(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(first_seed() % all.size()),
              all.end());
  int tried = 0;
  for (const Mutation& mutation : all) {
    if (!has_time()) break;
    ++tried;
    CAPTURE(mutation.name);
    std::size_t mutants = 0;
    Answers answers;
    std::string rule = "-";
    for (std::uint64_t i = 0; i < kSeeds; ++i) {
      const std::uint64_t seed = first_seed() + i;
      CAPTURE(seed);
      ArrayMesh mutant = mesh;
      Dice dice(seed);
      if (!mutation.apply(mutant, dice)) continue;
      ask_the_fast_judge(mutation, mutant, mesh, mutants == 0, answers);
      if (mutants++ == 0) rule = named_rule(mutation, std::move(mutant));
    }
    std::cout << "  " << mutation.name << ": " << mutants << " mutants, " << rule << "; fast:";
    for (const auto& [said, count] : answers) std::cout << " " << count << " x " << said << ";";
    std::cout << std::endl;
  }
  say_inputs(tried, static_cast<int>(all.size()));
}

TEST_CASE("random points of space") {
  Dice dice(first_seed());
  hold_catalogue_against("random points of space",
                         mesh_by(adapters::cgal_delaunay_3, random_points(3, dice)));
}

TEST_CASE("a grid in space") {
  hold_catalogue_against("a grid in space", mesh_by(adapters::cgal_delaunay_3, grid_points(3, 46)));
}

TEST_CASE("random points of the plane") {
  Dice dice(first_seed());
  hold_catalogue_against("random points of the plane",
                         mesh_by(adapters::cgal_delaunay_2, random_points(2, dice)));
}

TEST_CASE("a grid in the plane") {
  hold_catalogue_against("a grid in the plane",
                         mesh_by(adapters::cgal_delaunay_2, grid_points(2, 316)));
}

TEST_CASE("points on a sphere, as near as doubles are, and its centre") {
  Dice dice(first_seed());
  PointArray points{3, {0, 0, 0}, {}};
  while (points.coordinates.size() < 3 * kPoints) {
    const std::array<double, 3> p = {between(-1, 1, dice), between(-1, 1, dice),
                                     between(-1, 1, dice)};
    const double length = std::hypot(p[0], p[1], p[2]);
    if (length > 1 || length < 0x1p-10) continue;  // as many in all directions
    for (const double x : p) points.coordinates.push_back(x / length);
  }
  hold_catalogue_against("points on a sphere", mesh_by(adapters::cgal_delaunay_3, points));
}

TEST_CASE("random weighted points of space, some submerged") {
  Dice dice(first_seed());
  PointArray points = random_points(3, dice);
  for (std::size_t i = 0; i < kPoints; ++i) points.weights.push_back(between(0, 0x1p-11, dice));
  hold_catalogue_against("random weighted points of space",
                         mesh_by(adapters::cgal_regular_3, points));
}

TEST_CASE("meshes of 10^5 points that wind twice") {
  for (const std::size_t d : {2u, 3u}) {
    if (!has_time()) return;
    CAPTURE(d);
    ArrayMesh mesh = doubly_wound(d, 315, 317);
    const std::string said = "a sample point that is covered twice";
    CHECK(said_fast(mesh, Claim::kTriangulation) == said);
    list_neighbors(mesh);
    CHECK(said_fast(mesh, Claim::kTriangulation) == said);
    CHECK(judge(Claim::kTriangulation, mesh, 2).rule == identifier(Rule::kCoveredTwice));
  }
}

}  // namespace
}  // namespace circumspect::properties
