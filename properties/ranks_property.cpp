// Meshes and every mutation of the catalogue, dealt to the ranks of an MPI program in all ways:
// they find the very verdict that one process finds, word for word. `mpirun -n 3 ranks_property`;
// RANKS_CASES says how many meshes.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <memory>
#include <random>
#include <string>

#include <doctest/doctest.h>

#include "inputs/in_doubles.hpp"
#include "oracle/distributed/judge.hpp"
#include "oracle/distributed/mpi.hpp"
#include "oracle/judge/fast/grid_mesh_test.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"
#include "properties/dealt_meshes.hpp"
#include "properties/mutations/catalogue.hpp"
#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::properties {
namespace {

// All ranks of the program; those of one that mpirun has not started are one. They send each other
// no more than some thirty items at a time.
distributed::Ranks& world() {
  static const std::unique_ptr<distributed::Ranks> ranks = [] {
    MPI_Init(nullptr, nullptr);
    std::atexit([] { MPI_Finalize(); });
    static distributed::MpiCommunicator communicator(MPI_COMM_WORLD);
    return std::make_unique<distributed::Ranks>(communicator, 5);
  }();
  return *ranks;
}

// A rank that leaves a test early never meets the others again, which would wait for it until the
// test's time is over. So a test that fails at one rank ends all of them; what failed has been
// printed by then.
class EndsAllRanks : public doctest::IReporter {
 public:
  explicit EndsAllRanks(const doctest::ContextOptions&) {}
  void test_case_end(const doctest::CurrentTestCaseStats& ended) override {
    if (ended.testCaseSuccess) return;
    std::fflush(nullptr);
    std::cout.flush();
    int is_running = 0;
    MPI_Initialized(&is_running);
    if (is_running != 0) MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
  }
  void report_query(const doctest::QueryData&) override {}
  void test_run_start() override {}
  void test_run_end(const doctest::TestRunStats&) override {}
  void test_case_start(const doctest::TestCaseData&) override {}
  void test_case_exception(const doctest::TestCaseException&) override {}
  void test_case_reenter(const doctest::TestCaseData&) override {}
  void subcase_start(const doctest::SubcaseSignature&) override {}
  void subcase_end() override {}
  void log_assert(const doctest::AssertData&) override {}
  void log_message(const doctest::MessageData&) override {}
  void test_case_skipped(const doctest::TestCaseData&) override {}
};
REGISTER_LISTENER("ends-all-ranks", 1, EndsAllRanks);

std::size_t cases() {
  const char* const said = std::getenv("RANKS_CASES");
  return said == nullptr ? 300 : std::strtoul(said, nullptr, 10);
}

// The ranks agree with one process on this mesh, dealt in this way.
void check_agreement(Claim claim, const ArrayMesh& mesh, Way way, Dice& dice,
                     const check::Options& options) {
  const std::string said = said_by_all(world(), claim, dealt(mesh, way, dice, world()), options);
  const std::string expected =
      world().is_first() ? said_by_one(claim, mesh, options) : std::string();
  const bool agree = world().is_first() ? said == expected : expected.empty();
  CAPTURE(static_cast<int>(way));
  CAPTURE(std::string(name(claim)));
  if (!agree) {
    CHECK(said == expected);
  } else {
    CHECK(agree);
  }
  if (world().is_first()) {
    Dice own = dice;
    CHECK(said_in_turns(claim, mesh, way, own, options, 7) == expected);
  }
}

ArrayMesh drawn_mesh(std::size_t d, bool weighted, std::uint64_t seed) {
  const auto cases =
      weighted ? generators::any_case(d, 16) : generators::any_unweighted_case(d, 16);
  const auto set = generators::in_doubles(cases(rc::Random(seed), 60).value());
  const PointSet points(set.points, set.weights);
  if (points.dimension() != static_cast<int>(d)) return {};
  ArrayMesh mesh = array_mesh(points, delaunay::bowyer_watson(points).simplices());
  list_neighbors(mesh);
  return mesh;
}

std::uint64_t first_seed() { return rc::detail::configuration().testParams.seed; }

TEST_CASE(
    "ranks agree with one process on every mutation of small meshes, however they are dealt") {
  std::vector<Mutation> all = catalogue();
  std::erase_if(all, [](const Mutation& one) { return one.rules.contains(Rule::kWrongNeighbor); });
  std::map<std::string, std::size_t> applied;
  std::size_t i = 0;
  for (; i < cases() && !world().any(!has_time()); ++i) {
    const std::uint64_t seed = world().of_rank(0, first_seed()) + i;
    CAPTURE(seed);
    Dice dice(seed);
    const bool weighted = i % 3 == 0;
    ArrayMesh mesh = drawn_mesh(2 + i % 2, weighted, seed);
    if (mesh.simplices.empty()) continue;
    const bool has_weights = !mesh.weights.empty();
    std::vector<Mutation> some = all;
    if (has_weights && dice.below(2) == 0) {
      std::erase_if(some, [](const Mutation& one) { return !one.needs_weights; });
    }
    const Mutation& mutation = some[dice.below(some.size())];
    CAPTURE(mutation.name);
    const ArrayMesh before = mesh;
    const bool is_applied = dice.below(8) > 0 && mutation.apply(mesh, dice);
    if (!is_applied) mesh = before;
    applied[is_applied ? mutation.name : "none"] += 1;
    const Claim claim = dice.below(4) == 0 ? Claim::kTriangulation
                        : has_weights      ? Claim::kWeightedDelaunay
                                           : Claim::kDelaunay;
    const check::Options options{.max_violations = dice.below(3) == 0 ? 2u : 20u};
    check_agreement(claim, mesh, drawn_way(dice), dice, options);
  }
  if (world().is_first()) say_inputs(static_cast<int>(i), static_cast<int>(cases()));
  // Each of them, where there are enough meshes.
  for (const Mutation& mutation : all) {
    CAPTURE(mutation.name);
    if (cases() >= 5000) CHECK(occurs(applied[mutation.name]));
  }
}

TEST_CASE(
    "ranks agree with one process on meshes that wind twice, of one simplex, of none, and flat") {
  for (const Way way : {Way::kSlices, Way::kRoundRobin, Way::kAllToOne, Way::kSomeToNone}) {
    Dice dice(5);
    for (const std::size_t d : {2u, 3u}) {
      CAPTURE(d);
      check_agreement(Claim::kTriangulation, doubly_wound(d, 7, 3), way, dice, {});
      ArrayMesh mesh{.dimension = d};
      for (std::size_t i = 0; i <= d; ++i) {
        mesh.simplices.push_back(static_cast<std::int64_t>(i));
        for (std::size_t axis = 0; axis < d; ++axis)
          mesh.coordinates.push_back(i == axis + 1 ? 1 : 0);
      }
      check_agreement(Claim::kDelaunay, mesh, way, dice, {});
      ArrayMesh flat = mesh;
      for (std::size_t i = 0; i <= d; ++i) flat.coordinates[i * d] = 0;
      flat.coordinates[d] = 0.5;
      check_agreement(Claim::kDelaunay, flat, way, dice, {});
      ArrayMesh unknown = mesh;
      unknown.simplices[1] = 1000;
      check_agreement(Claim::kDelaunay, unknown, way, dice, {});
      mesh.simplices.clear();
      check_agreement(Claim::kDelaunay, mesh, way, dice, {});
    }
  }
}

TEST_CASE("ranks agree with one process on a large grid, whole and broken") {
  const auto grid = fast::grid_mesh<3>(cases() < 1000 ? 10 : 25);
  ArrayMesh mesh{.dimension = 3};
  mesh.coordinates = grid.coordinates;
  mesh.simplices.assign(grid.simplices.begin(), grid.simplices.end());
  list_neighbors(mesh);
  Dice dice(world().of_rank(0, first_seed()));
  const std::vector<Mutation> all = catalogue();
  for (int i = 0; i < 5; ++i) {
    ArrayMesh mutant = mesh;
    const Mutation& mutation = all[dice.below(all.size())];
    CAPTURE(mutation.name);
    if (i > 0 && !mutation.apply(mutant, dice)) continue;
    check_agreement(Claim::kDelaunay, mutant, static_cast<Way>(i), dice, {});
  }
}

// The test that expects this failure says at which rank it is wanted.
TEST_CASE("a test that fails at one rank ends all of them") {
  const char* const at = std::getenv("RANKS_FAIL_AT");
  if (at == nullptr) return;
  REQUIRE(world().rank() != std::strtoul(at, nullptr, 10));
  CHECK(!world().any(false));  // waits for the rank that has failed
}

}  // namespace
}  // namespace circumspect::properties
