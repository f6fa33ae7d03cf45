// Every mutation of the catalogue on meshes of 10^5 points, made by CGAL: the fast judge vouches for none, and
// `judge` names a rule that the catalogue expects. Where the fast judge knows something, that is what the
// checkers say, too; where it knows nothing, they are whom `judge` asks.
#include <iostream>
#include <map>

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "properties/adapters/adapters.hpp"
#include "properties/catalogue_verdicts.hpp"

namespace circumspect::properties {
namespace {

constexpr std::size_t kPoints = 100'000;
constexpr std::uint64_t kSeeds = 3;  // of each mutation; the checkers see the first mutant

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

// With the neighbours that are left, with none, and of the first mutant also with right ones and with those
// of the mesh before. True if anything is known of one of them.
bool ask_the_fast_judge(const Mutation& mutation, ArrayMesh mutant, const ArrayMesh& mesh,
                        bool is_first, Answers& answers) {
  bool known = false;
  const auto ask = [&](Claim claim) {
    const std::string said = said_fast(mutant, claim);
    ++answers[said];
    known |= said == "accepted" || said == "not Delaunay";
    CHECK(fault_of_fast(mutation, said) == "");
  };
  if (!mutant.neighbors.empty()) ask(claim_of(mutant));
  if (mutation.rules.contains(Rule::kWrongNeighbor)) return known;
  mutant.neighbors.clear();
  ask(claim_of(mutant));
  if (!is_first) return known;
  if (mutant.weights.empty() && breaks_any_triangulation(mutation)) ask(Claim::kTriangulation);
  list_neighbors(mutant);
  ask(claim_of(mutant));
  if (mutant.simplices.size() == mesh.simplices.size() && mutation.expected != Expected::kHolds) {
    mutant.neighbors = mesh.neighbors;
    ask(claim_of(mutant));
  }
  return known;
}

// What is known of a mutant is compared with what the checkers say. If nothing is, `judge` has them judge.
std::string named_rule(const Mutation& mutation, ArrayMesh mutant, bool known) {
  if (mutation.expected == Expected::kEqualPoints) {
    mutant.neighbors.clear();
  } else if (mutant.neighbors.empty()) {
    list_neighbors(mutant);
  }
  const Claim claim = claim_of(mutant);
  const MeshJudgement judged = judge(claim, mutant, 2);
  if (known) {
    const Mesh merged = mesh_of(mutant, claim);
    CHECK(fault_of(mutation, judged, check::judge_points(claim, exact(merged)), merged) == "");
  } else {
    CHECK(fault_of(mutation, judged) == "");
  }
  return judged.holds ? "holds" : judged.rule;
}

// `always`: the checkers see a mutant of each mutation, and not only those of which something is known.
void hold_catalogue_against(const std::string& what, const ArrayMesh& mesh, bool always) {
  std::cout << what << ": " << mesh.points() << " points, " << mesh.size() << " simplices, seed "
            << first_seed() << std::endl;
  CAPTURE(what);
  REQUIRE(said_fast(mesh, claim_of(mesh)) == "accepted");
  for (const Mutation& mutation : catalogue()) {
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
      const bool known = ask_the_fast_judge(mutation, mutant, mesh, mutants == 0, answers);
      if (mutants++ > 0) continue;
      if (always || known) rule = named_rule(mutation, std::move(mutant), known);
    }
    std::cout << "  " << mutation.name << ": " << mutants << " mutants, " << rule << "; fast:";
    for (const auto& [said, count] : answers) std::cout << " " << count << " x " << said << ";";
    std::cout << std::endl;
  }
}

TEST_CASE("random points of space") {
  Dice dice(first_seed());
  hold_catalogue_against("random points of space",
                         mesh_by(adapters::cgal_delaunay_3, random_points(3, dice)), true);
}

TEST_CASE("a grid in space") {
  hold_catalogue_against("a grid in space", mesh_by(adapters::cgal_delaunay_3, grid_points(3, 46)),
                         false);
}

TEST_CASE("random points of the plane") {
  Dice dice(first_seed());
  hold_catalogue_against("random points of the plane",
                         mesh_by(adapters::cgal_delaunay_2, random_points(2, dice)), true);
}

TEST_CASE("a grid in the plane") {
  hold_catalogue_against("a grid in the plane",
                         mesh_by(adapters::cgal_delaunay_2, grid_points(2, 316)), true);
}

TEST_CASE("random weighted points of space, some submerged") {
  Dice dice(first_seed());
  PointArray points = random_points(3, dice);
  for (std::size_t i = 0; i < kPoints; ++i) points.weights.push_back(between(0, 0x1p-11, dice));
  hold_catalogue_against("random weighted points of space",
                         mesh_by(adapters::cgal_regular_3, points), false);
}

TEST_CASE("meshes of 10^5 points that wind twice") {
  for (const std::size_t d : {2u, 3u}) {
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
