// What the fast judge decides, and what it leaves to oracle/judge/points. corpus/arrays_test.cpp
// and properties/arrays_property.cpp test that both agree.
#include "oracle/judge/fast/judge.hpp"

#include <limits>
#include <random>
#include <string>

#include <doctest/doctest.h>

#include "oracle/judge/fast/facet_matching.hpp"
#include "oracle/judge/fast/faults.hpp"
#include "oracle/judge/fast/grid_mesh_test.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::fast {
namespace {

// Why it is not decided that the mesh holds; empty if it does.
template <std::size_t kDimension, typename Index>
std::string undecided(const MeshInArrays<kDimension, Index>& mesh,
                      Question question = Question::kDelaunay, unsigned threads = 1) {
  const auto facts = judge(mesh.view(), question, threads);
  if (facts && facts->holds()) return "";
  return std::string(description(facts ? Undecided::kFacetNotLocal : facts.error()));
}

template <std::size_t kDimension, typename Index>
void list_neighbors(MeshInArrays<kDimension, Index>& mesh) {
  const auto links = matched_facets(mesh.view(), 1);
  mesh.neighbors.assign(links->view().begin(), links->view().end());
}

template <std::size_t kDimension, typename Index>
void check_judged_grid(bool mirrored) {
  auto mesh =
      grid_mesh<kDimension, Index>(properties::points_a_side(kDimension == 2 ? 40 : 9), mirrored);
  for (const bool with_neighbors : {false, true}) {
    if (with_neighbors) list_neighbors(mesh);
    for (const unsigned threads : {1U, 3U}) {
      const auto facts = judge(mesh.view(), Question::kDelaunay, threads);
      REQUIRE(facts.has_value());
      CHECK(facts->oriented == !mirrored);
      CHECK_FALSE(facts->unique);
      CHECK(facts->stages.filtered > 0);
      CHECK(facts->stages.exact() == 0);  // all points are on a lattice
      CHECK(judge(mesh.view(), Question::kWeightedDelaunay, threads).has_value());
      const auto triangulation = judge(mesh.view(), Question::kTriangulation, threads);
      REQUIRE(triangulation.has_value());
      CHECK(triangulation->unique);  // it was not asked for
    }
  }
}

TEST_CASE("grids are Delaunay triangulations, however their simplices are oriented") {
  for (const bool mirrored : {false, true}) {
    check_judged_grid<2, std::int32_t>(mirrored);
    check_judged_grid<2, std::int64_t>(mirrored);
    check_judged_grid<3, std::int32_t>(mirrored);
    check_judged_grid<3, std::int64_t>(mirrored);
  }
}

TEST_CASE("neighbours may be narrower than indices") {
  auto mesh = grid_mesh<3, std::int64_t>(6);
  list_neighbors(mesh);
  std::vector<std::int32_t> narrow(mesh.neighbors.begin(), mesh.neighbors.end());
  mesh.neighbors.clear();
  const auto judged = [&] {
    return judge(mesh.view(), Links<std::int32_t>(narrow), Question::kDelaunay, 2);
  };
  REQUIRE(judged().has_value());
  CHECK(judged()->holds());
  std::swap(narrow[0], narrow[2]);
  REQUIRE_FALSE(judged().has_value());
  CHECK(judged().error() == Undecided::kUnmatchedNeighbor);
}

TEST_CASE("of a square's two triangulations, one is canonical") {
  MeshInArrays<2> mesh{{0, 0, 1, 0, 0, 1, 1, 1}, {0, 1, 3, 0, 3, 2}};
  CHECK(judge(mesh.view(), Question::kDelaunay, 1)->canonical);
  mesh.simplices = {0, 1, 2, 1, 3, 2};
  CHECK_FALSE(judge(mesh.view(), Question::kDelaunay, 1)->canonical);
  mesh.coordinates.back() = 2;
  CHECK(judge(mesh.view(), Question::kDelaunay, 1)->unique);
  mesh.coordinates.back() = 0.75;
  CHECK(undecided(mesh) == description(Undecided::kFacetNotLocal));
  CHECK(undecided(mesh, Question::kTriangulation) == "");
}

// Each fault in turn, and the reason why the fast judge does not say that the mesh holds.
TEST_CASE("what is not a triangulation is left undecided") {
  const MeshInArrays<2> good{{0, 0, 4, 0, 4, 4, 0, 4, 2, 2}, {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4}};
  REQUIRE(undecided(good) == "");
  const auto with = [&](auto change) {
    MeshInArrays<2> mesh = good;
    change(mesh);
    return undecided(mesh);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(with([](auto& m) { m.simplices.clear(); }) == description(Undecided::kEmpty));
  CHECK(with([&](auto& m) { m.coordinates[9] = nan; }) == description(Undecided::kNotFinite));
  CHECK(with([&](auto& m) { m.coordinates[0] = -1 / 0.0; }) == description(Undecided::kNotFinite));
  CHECK(with([](auto& m) { m.simplices[0] = 5; }) == description(Undecided::kUnknownVertex));
  CHECK(with([](auto& m) { m.simplices[0] = -1; }) == description(Undecided::kUnknownVertex));
  CHECK(with([](auto& m) { m.simplices[11] = 3; }) == description(Undecided::kFlatSimplex));
  CHECK(with([](auto& m) { m.coordinates[9] = 0; }) == description(Undecided::kFlatSimplex));
  CHECK(with([](auto& m) { m.coordinates[9] = -1; }) == description(Undecided::kSameSide));
  CHECK(with([](auto& m) {
          m.simplices.insert(m.simplices.end(), {1, 4, 3});
        }) == description(Undecided::kFlatSimplex));
  CHECK(with([](auto& m) { m.simplices.resize(9); }) == description(Undecided::kBeyondHullFacet));
  CHECK(with([](auto& m) {
          m.coordinates.insert(m.coordinates.end(), {1, 2});
          m.simplices.insert(m.simplices.end(), {3, 5, 4, 5, 0, 4});
          m.simplices.erase(m.simplices.begin() + 9, m.simplices.begin() + 12);
        }) == description(Undecided::kHullNotConvex));
  CHECK(with([](auto& m) { m.simplices.resize(3); }) == description(Undecided::kUnusedPoint));
  CHECK(with([](auto& m) {
          m.coordinates.insert(m.coordinates.end(), {2, 2});
        }) == description(Undecided::kUnusedPoint));
  CHECK(with([](auto& m) {
          m.coordinates.insert(m.coordinates.end(), {9, 2});
        }) == description(Undecided::kUnusedPoint));
}

// Only the sample point finds that it is not a triangulation, if it is in one of the simplices near
// the middle.
TEST_CASE("a fan that winds twice is left undecided, and its cone in space") {
  const std::vector<double> ring = {14280, 6877, -7858, 9854,   -4612, -5783, 3739,
                                    -1801, 1181, 5176,  -10000, 0,     3269,  -14323};
  std::size_t covered_twice = 0;
  for (std::int32_t first = 0; first < 7; ++first) {
    MeshInArrays<2> fan{.coordinates = {0, 0}};
    MeshInArrays<3> cone{.coordinates = {0, 0, 0, 0, 0, 20000}};
    for (std::int32_t i = 0; i < 7; ++i) {
      const auto x = ring.begin() + 2 * i;
      fan.coordinates.insert(fan.coordinates.end(), {x[0], x[1]});
      cone.coordinates.insert(cone.coordinates.end(), {x[0], x[1], 0});
      const std::int32_t a = (first + i) % 7 + 1, b = (first + i + 1) % 7 + 1;
      fan.simplices.insert(fan.simplices.end(), {0, a, b});
      cone.simplices.insert(cone.simplices.end(), {0, 1, a + 1, b + 1});
    }
    CHECK(undecided(fan) != "");
    CHECK(undecided(cone) != "");
    covered_twice += undecided(fan) == description(Undecided::kCoveredTwice) ? 1 : 0;
    covered_twice += undecided(cone) == description(Undecided::kCoveredTwice) ? 1 : 0;
  }
  CHECK(covered_twice > 0);
}

TEST_CASE("a number of simplices apart, each convex, are left undecided") {
  MeshInArrays<2> two{{0, 0, 1, 0, 0, 1, 5, 5, 6, 5, 5, 6}, {0, 1, 2, 3, 4, 5}};
  CHECK(undecided(two) == description(Undecided::kBeyondHullFacet));
  two.coordinates = {0, 0, 9, 0, 0, 9, 1, 1, 2, 1, 1, 2};  // one within the other
  CHECK(undecided(two) == description(Undecided::kBeyondHullFacet));
}

TEST_CASE("weighted points may be left out where they are submerged") {
  MeshInArrays<2> mesh{{0, 0, 4, 0, 0, 4, 1, 1}, {0, 1, 2}};
  const auto weighted = [&](double weight) {
    mesh.weights = {0, 0, 0, weight};
    return undecided(mesh, Question::kWeightedDelaunay);
  };
  CHECK(weighted(-100) == "");
  CHECK(weighted(-6) == "");
  CHECK_FALSE(judge(mesh.view(), Question::kWeightedDelaunay, 1)->unique);  // on the plane
  CHECK(weighted(-5.75) == description(Undecided::kPointBelowPlane));
  CHECK(undecided(mesh) == description(Undecided::kUnusedPoint));
  mesh.coordinates[7] = 4;
  CHECK(weighted(-100) == description(Undecided::kUnusedPoint));  // beyond the hull
  mesh.coordinates[6] = 0;
  CHECK(weighted(-100) == description(Undecided::kEqualPoints));  // with a vertex
  mesh.coordinates = {0, 0, 4, 0, 0, 4, 1, 1, 1, 1};
  mesh.weights = {0, 0, 0, -100, -200};
  CHECK(undecided(mesh, Question::kWeightedDelaunay) == description(Undecided::kEqualPoints));
  mesh.weights.clear();
  CHECK(undecided(mesh, Question::kWeightedDelaunay) == description(Undecided::kUnusedPoint));
}

// The links of one facet, changed at one end or at both.
void check_wrong_neighbors(bool mirrored) {
  auto mesh = grid_mesh<3>(properties::points_a_side(18), mirrored);
  list_neighbors(mesh);
  REQUIRE(undecided(mesh) == "");
  const std::vector<std::int32_t> right = mesh.neighbors;
  *std::find(mesh.neighbors.begin(), mesh.neighbors.end(), -1) = -2;
  CHECK(undecided(mesh) == description(Undecided::kUnmatchedNeighbor));
  std::mt19937_64 random(1);
  const auto any = [&](std::size_t count) { return static_cast<std::size_t>(random() % count); };
  const auto back = [&](std::size_t facet) {
    const auto t = static_cast<std::size_t>(right[facet]);
    std::size_t place = 0;
    while (right[t * 4 + place] != static_cast<std::int32_t>(facet / 4)) ++place;
    return t * 4 + place;
  };
  for (int i = 0; i < 60 / properties::kOneInputIn; ++i) {
    mesh.neighbors = right;
    const std::size_t a = any(right.size()), b = any(right.size());
    if (right[a] < 0 || right[b] < 0 || right[a] == right[b] || a / 4 == b / 4) continue;
    const auto s = static_cast<std::int32_t>(a / 4);
    switch (i % 6) {
      case 0:  // one end
        mesh.neighbors[a] = right[b];
        break;
      case 1:  // an end that leads nowhere
        mesh.neighbors[a] = i % 4 == 1 ? -2 : static_cast<std::int32_t>(mesh.size());
        break;
      case 2:  // both ends, to be hull facets
        mesh.neighbors[a] = mesh.neighbors[back(a)] = -1;
        break;
      case 3:  // two pairs crossed, at both ends
        std::swap(mesh.neighbors[a], mesh.neighbors[b]);
        std::swap(mesh.neighbors[back(a)], mesh.neighbors[back(b)]);
        break;
      case 4:  // to itself
        mesh.neighbors[a] = s;
        break;
      default:  // within one row: right simplices, in the wrong order
        std::swap(mesh.neighbors[a], mesh.neighbors[a ^ 1]);
        if (right[a] == right[a ^ 1]) continue;
    }
    CAPTURE(i);
    CHECK(undecided(mesh, Question::kTriangulation) != "");
  }
}

TEST_CASE("no wrong neighbour of a large grid is taken for a right one") {
  check_wrong_neighbors(false);
  check_wrong_neighbors(true);
}

// properties/mutations for arrays of any size.
void mutate(MeshInArrays<3>& mesh, int kind, std::mt19937_64& random) {
  const auto any = [&](std::size_t count) { return static_cast<std::size_t>(random() % count); };
  const auto points = static_cast<std::int32_t>(mesh.view().points());
  const std::size_t place = any(mesh.simplices.size());
  const auto other = [&](std::int32_t v) {
    return static_cast<std::int32_t>(
        (v + 1 + static_cast<std::int32_t>(any(static_cast<std::size_t>(points) - 1))) % points);
  };
  const std::int32_t old = mesh.simplices[place], changed = other(old);
  const std::size_t row = place / 4 * 4;
  const auto at = [&](std::size_t i) { return mesh.simplices.begin() + static_cast<long>(i); };
  switch (kind) {
    case 0:  // one index changed
      mesh.simplices[place] = changed;
      break;
    case 1:  // a simplex dropped
      mesh.simplices.erase(at(row), at(row + 4));
      break;
    case 2: {  // a simplex listed twice
      const std::vector<std::int32_t> again(at(row), at(row + 4));
      mesh.simplices.insert(mesh.simplices.end(), again.rbegin(), again.rend());
      break;
    }
    case 3:  // a simplex replaced
      for (std::size_t i = row; i < row + 4; ++i) mesh.simplices[i] = other(mesh.simplices[i]);
      break;
    case 4:  // a point merged into another
      std::replace(mesh.simplices.begin(), mesh.simplices.end(), old, changed);
      break;
    case 5:  // two vertices exchanged everywhere
      for (std::int32_t& v : mesh.simplices) v = v == old ? changed : v == changed ? old : v;
      break;
    case 6: {  // the only simplex of a facet turned inside out
      std::swap(mesh.simplices[row], mesh.simplices[any(mesh.simplices.size())]);
      break;
    }
    case 7:  // a point moved onto another
      std::copy_n(mesh.coordinates.begin() + changed * 3, 3, mesh.coordinates.begin() + old * 3);
      break;
    case 8:  // a point that no simplex has, where another is
      mesh.coordinates.insert(mesh.coordinates.end(), {1, 1, 1});
      break;
    case 9:  // a point moved out of its place
      mesh.coordinates[static_cast<std::size_t>(old) * 3] += 1.5;
      break;
    default: {  // some consecutive simplices, listed again far away
      const std::size_t last = std::min(row + 400, mesh.simplices.size());
      const std::vector<std::int32_t> again(at(row), at(last));
      mesh.simplices.insert(mesh.simplices.end(), again.begin(), again.end());
    }
  }
}

TEST_CASE("no mutation of a grid of 10^5 points is taken for a triangulation") {
  const auto good = grid_mesh<3>(properties::kOneInputIn > 1 ? 8 : 47);
  REQUIRE(undecided(good) == "");
  std::mt19937_64 random(2);
  for (int i = 0; i < 22; ++i) {
    CAPTURE(i);
    MeshInArrays<3> mesh = good;
    mutate(mesh, i % 11, random);
    CHECK(undecided(mesh) != "");
  }
}

// Everything that is found about a mesh, list after list.
using Said = std::vector<std::vector<std::uint64_t>>;

std::uint64_t name_of(FacetId facet) { return facet.simplex() * 4 + facet.place(); }

void say_pairs(const std::vector<FacetPair>& pairs, Said& said) {
  auto& list = said.emplace_back();
  for (const auto& [first, second] : pairs) {
    list.insert(list.end(), {name_of(first), name_of(second)});
  }
}

Said said_of(const Faults& faults) {
  Said said = faults.overused.empty() ? Said() : Said{{faults.overused.size()}};
  for (const auto* const list :
       {&faults.unsound, &faults.duplicates, &faults.turned, &faults.unused, &faults.covering}) {
    said.emplace_back(list->begin(), list->end());
  }
  said.push_back({faults.sound_simplex, faults.first_of_most,
                  static_cast<std::uint64_t>(faults.orientation_of_most)});
  for (const auto& facets : faults.overused) {
    auto& list = said.emplace_back();
    for (const FacetId facet : facets) list.push_back(name_of(facet));
  }
  say_pairs(faults.same_side, said);
  say_pairs(faults.not_local, said);
  for (const FaultyRidge& ridge : faults.ridges) {
    auto& list = said.emplace_back(ridge.vertices.begin(), ridge.vertices.end());
    for (const FacetId facet : ridge.facets) list.push_back(name_of(facet));
  }
  auto& beyond = said.emplace_back();
  for (const FacetId facet : faults.beyond) beyond.push_back(name_of(facet));
  if (faults.facets_match()) {
    const auto links = faults.links.view();
    said.emplace_back(links.begin(), links.end());
  }
  return said;
}

TEST_CASE("what the judge found out leads to the faults that are found without it") {
  constexpr std::array kinds = {0, 1, 2, 3, 4, 5, 6, 9, 10};  // that make no points equal
  std::mt19937_64 random(5);
  std::size_t gone_on = 0;
  // Twenty-three has no divisor in common with what `i` chooses below.
  constexpr int kStep = properties::kOneInputIn > 1 ? 23 : 1;
  for (int i = 0; i < 220; i += kStep) {
    CAPTURE(i);
    MeshInArrays<3> mesh = grid_mesh<3>(kStep > 1 ? 8 : 12, i % 2 == 0);
    for (std::size_t k = 0; k <= static_cast<std::size_t>(i) / 9 % 3; ++k)
      mutate(mesh, kinds[(static_cast<std::size_t>(i) + 2 * k) % kinds.size()], random);
    std::optional<SweptMesh> swept;
    const unsigned threads = 1 + static_cast<unsigned>(i) % 3;
    const Question question = i % 5 == 0 ? Question::kTriangulation : Question::kDelaunay;
    const auto facts = judge(mesh.view(), question, threads, &swept);
    if (facts || !swept) continue;
    gone_on += static_cast<std::size_t>(!swept->swept.undecided);
    const auto without = faults(mesh.view(), question, threads);
    const auto with = faults(mesh.view(), question, threads, std::move(swept));
    REQUIRE(with.has_value() == without.has_value());
    if (with) CHECK(said_of(*with) == said_of(*without));
  }
  CHECK(gone_on > 100 / kStep);
}

}  // namespace
}  // namespace circumspect::fast
