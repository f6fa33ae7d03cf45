// Every mutation of the catalogue on small meshes, degenerate ones above all: whoever judges,
// quickly, by lemma or by definition, sees through it, and the rule named is one that the catalogue
// expects.
#include <algorithm>
#include <limits>
#include <map>

#include <doctest/doctest.h>

#include "inputs/in_doubles.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"
#include "properties/catalogue_verdicts.hpp"
#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::properties {
namespace {

ArrayMesh any_mesh(std::size_t d, bool weighted) {
  const auto cases =
      weighted ? generators::any_case(d, 14) : generators::any_unweighted_case(d, 14);
  const generators::PointsCase set = generators::in_doubles(*cases);
  const PointSet points(set.points, set.weights);
  RC_PRE(points.dimension() == static_cast<int>(d));
  ArrayMesh mesh = array_mesh(points, delaunay::bowyer_watson(points).simplices());
  list_neighbors(mesh);
  return mesh;
}

Claim any_claim(const Mutation& mutation, bool weighted) {
  if (weighted) return Claim::kWeightedDelaunay;
  if (!breaks_any_triangulation(mutation)) return Claim::kDelaunay;
  return *rc::gen::element(Claim::kTriangulation, Claim::kDelaunay);
}

// Equal points are merged by those who look for witnesses, and then the neighbours may be wrong.
void give_or_take_neighbors(const Mutation& mutation, ArrayMesh& mutant) {
  if (mutation.expected == Expected::kEqualPoints) {
    mutant.neighbors.clear();
  } else if (mutant.neighbors.empty() && *rc::gen::arbitrary<bool>()) {
    list_neighbors(mutant);
  }
}

// A weighted mesh may leave points out: what should break any triangulation may leave one of fewer
// points, which is right, is not Delaunay, or lacks points that are not submerged.
bool is_of_fewer_points(const Mutation& mutation, Claim claim, const Verdict& said) {
  if (claim != Claim::kWeightedDelaunay || !breaks_any_triangulation(mutation)) return false;
  const auto& rules = said.tallies();
  return std::all_of(rules.begin(), rules.end(), [](const auto& one) {
    return one.first == Rule::kUnusedPoint || stage(one.first) == Stage::kDelaunay;
  });
}

TEST_CASE("mutations of small meshes are seen through, with the rules that the catalogue expects") {
  const std::vector<Mutation> all = catalogue();
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < all.size(); ++i) places.push_back(i);
  std::vector<std::size_t> weighted_places = places;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].needs_weights) weighted_places.insert(weighted_places.end(), 8, i);
  }
  std::map<std::string, std::size_t> applied;
  for (const std::size_t d : {2u, 3u}) {
    for (const bool weighted : {false, true}) {
      CHECK(holds("whoever judges", 670, [&] {
        const Mutation& mutation = all[*rc::gen::elementOf(weighted ? weighted_places : places)];
        ArrayMesh mesh = any_mesh(d, weighted);
        const bool has_weights = !mesh.weights.empty();
        Dice dice(*rc::gen::arbitrary<std::uint64_t>());
        if (!mutation.apply(mesh, dice)) return;
        give_or_take_neighbors(mutation, mesh);
        const Claim claim = any_claim(mutation, has_weights);
        RC_LOG() << mutation.name << '\n';
        const Mesh merged = mesh_of(mesh, claim);
        const ExactMesh exact_mesh = exact(merged);
        const Verdict slow = check::judge_exactly(claim, exact_mesh);
        const bool is_known = !is_of_fewer_points(mutation, claim, slow);
        if (is_known) RC_ASSERT(fault_of_fast(mutation, said_fast(mesh, claim)) == "");
        if (is_known) RC_ASSERT(fault_of(mutation, judge(claim, mesh, 2), slow, merged) == "");
        RC_ASSERT(check::judge_exactly(claim, exact_mesh, nullptr, {.by = check::By::kDefinition})
                      .holds() == slow.holds());
        ++applied[mutation.name];
      }));
    }
  }
  for (const Mutation& mutation : all) {
    CAPTURE(mutation.name);
    CHECK(occurs(applied[mutation.name]));
  }
}

TEST_CASE("a mesh that winds twice is seen through by its sample point alone") {
  for (const std::size_t d : {2u, 3u}) {
    for (const std::size_t around : {5u, 7u, 31u}) {
      ArrayMesh mesh = doubly_wound(d, around, 3);
      CAPTURE(d);
      CAPTURE(around);
      CHECK(said_fast(mesh, Claim::kTriangulation) == "a sample point that is covered twice");
      list_neighbors(mesh);
      CHECK(said_fast(mesh, Claim::kTriangulation) == "a sample point that is covered twice");
      CHECK(judge(Claim::kTriangulation, mesh, 1).rule == identifier(Rule::kCoveredTwice));
    }
  }
}

// A strip of so many triangles, and in space a cone over it; oriented alike, or by turns.
ArrayMesh strip(std::size_t d, std::size_t simplices, bool alike) {
  ArrayMesh mesh{.dimension = d};
  for (std::size_t i = 0; i < simplices + 2; ++i) {
    mesh.coordinates.insert(mesh.coordinates.end(),
                            {static_cast<double>(i / 2), static_cast<double>(i % 2)});
    if (d == 3) mesh.coordinates.push_back(0);
  }
  if (d == 3) mesh.coordinates.insert(mesh.coordinates.end(), {0.25, 0.25, 1});
  for (std::size_t s = 0; s < simplices; ++s) {
    const auto v = static_cast<std::int64_t>(s);
    const bool swapped = alike && s % 2 == 1;
    mesh.simplices.insert(mesh.simplices.end(), {v + swapped, v + !swapped, v + 2});
    if (d == 3) mesh.simplices.push_back(static_cast<std::int64_t>(simplices + 2));
  }
  list_neighbors(mesh);
  return mesh;
}

// Each fault at one simplex, with the neighbours that were right before, and without.
void check_faults_at(const ArrayMesh& mesh, std::size_t s) {
  CAPTURE(s);
  const auto check_refused = [](ArrayMesh broken) {
    CHECK(said_fast(broken, Claim::kTriangulation) != "accepted");
    broken.neighbors.clear();
    CHECK(said_fast(broken, Claim::kTriangulation) != "accepted");
  };
  const std::size_t width = mesh.width();
  ArrayMesh broken = mesh;
  broken.row(s)[0] = -1;
  check_refused(broken);
  broken = mesh;
  broken.row(s)[0] = broken.row(s)[1];
  check_refused(broken);
  broken = mesh;
  const auto row = static_cast<std::ptrdiff_t>(s * width);
  for (std::vector<std::int64_t>* rows : {&broken.simplices, &broken.neighbors}) {
    rows->erase(rows->begin() + row, rows->begin() + row + static_cast<std::ptrdiff_t>(width));
  }
  if (s > 0 && s + 1 < mesh.size()) check_refused(broken);  // the first and the last leave a point
  broken = mesh;
  const auto v = static_cast<std::size_t>(mesh.row(s)[2]);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    broken.coordinates[v * mesh.dimension + axis] = axis == 0 ? -1 : 0.5;
  }
  if (mesh.size() > 1) check_refused(broken);  // one simplex is as good as another
  for (std::size_t place = 0; place < width; ++place) {
    broken = mesh;
    std::int64_t& link = broken.neighbors[s * width + place];
    for (const std::int64_t wrong :
         {std::int64_t{-2}, std::int64_t{-1}, static_cast<std::int64_t>(s),
          static_cast<std::int64_t>(mesh.size() - 1 - s)}) {
      if (wrong == mesh.neighbors[s * width + place]) continue;
      link = wrong;
      CHECK(said_fast(broken, Claim::kTriangulation) != "accepted");
    }
  }
}

// What looks at simplices block by block and chunk by chunk looks at the first and the last of
// each.
TEST_CASE("strips of all lengths near the sizes of blocks hold, and no fault anywhere is missed") {
  const std::size_t longest = kOneInputIn > 1 ? 65 : 4097;
  for (const std::size_t d : {2u, 3u}) {
    for (const std::size_t size : {1u, 2u, 31u, 32u, 33u, 63u, 64u, 65u, 4095u, 4096u, 4097u}) {
      if (size > longest) continue;
      for (const bool alike : {true, false}) {
        CAPTURE(d);
        CAPTURE(size);
        const ArrayMesh mesh = strip(d, size, alike);
        ArrayMesh without = mesh;
        without.neighbors.clear();
        CHECK(said_fast(mesh, Claim::kTriangulation) == "accepted");
        CHECK(said_fast(without, Claim::kTriangulation) == "accepted");
        for (const std::size_t s :
             {0u, 1u, 30u, 31u, 32u, 33u, 62u, 63u, 64u, 4094u, 4095u, 4096u}) {
          if (s < size) check_faults_at(mesh, s);
        }
      }
    }
  }
}

TEST_CASE("arrays of no points, of no simplices, of simplices of no points") {
  for (const std::size_t d : {2u, 3u}) {
    ArrayMesh mesh{.dimension = d};
    CHECK(said_fast(mesh, Claim::kDelaunay) == "no simplices");
    for (std::size_t i = 0; i <= d; ++i) mesh.simplices.push_back(static_cast<std::int64_t>(i));
    CHECK(said_fast(mesh, Claim::kDelaunay) == "an index that names no point");
    mesh.neighbors.assign(d + 1, -1);
    CHECK(said_fast(mesh, Claim::kDelaunay) == "an index that names no point");
  }
}

TEST_CASE("numbers at the ends of the doubles") {
  const double largest = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  for (const double unit : {1.0, largest, least, 0x1p-1022, 0x1p1000}) {
    CAPTURE(unit);
    ArrayMesh mesh{2, {0, 0, unit, 0, -0.0, unit}, {}, {0, 1, 2}, {}};
    CHECK(said_fast(mesh, Claim::kDelaunay) == "accepted");
    mesh.coordinates = {-unit, -unit, unit, -unit, -unit, unit, unit, unit};
    mesh.simplices = {0, 1, 2, 1, 3, 2};
    CHECK(said_fast(mesh, Claim::kDelaunay) == "accepted");
    mesh.coordinates.insert(mesh.coordinates.end(), {0.0, -0.0, -0.0, 0.0});
    mesh.simplices = {0, 1, 4, 1, 3, 4, 3, 2, 4, 2, 0, 5};  // equal points are not one
    CHECK(said_fast(mesh, Claim::kDelaunay) != "accepted");
    mesh.simplices.back() = 4;
    CHECK(said_fast(mesh, Claim::kDelaunay) != "accepted");  // the sixth point
    mesh.coordinates.resize(10);
    CHECK(said_fast(mesh, Claim::kDelaunay) == "accepted");
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
          -std::numeric_limits<double>::infinity()}) {
      ArrayMesh broken = mesh;
      broken.coordinates[9] = bad;
      CHECK(said_fast(broken, Claim::kDelaunay) == "a number that is not finite");
      broken = mesh;
      broken.weights = {0, 0, 0, 0, bad};
      CHECK(said_fast(broken, Claim::kWeightedDelaunay) == "a number that is not finite");
    }
  }
}

}  // namespace
}  // namespace circumspect::properties
