// The sweep of a mesh, and the facts about simplices that do not depend on what they cover.
#include "oracle/judge/fast/sweep.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <string>

#include <doctest/doctest.h>

#include "oracle/judge/fast/facet_matching.hpp"
#include "oracle/judge/fast/grid_mesh_test.hpp"
#include "oracle/judge/fast/judge.hpp"
#include "oracle/judge/fast/predicates/exact_sign.hpp"
#include "oracle/judge/fast/predicates/predicates.hpp"
#include "oracle/judge/fast/simplex_facts.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::fast {

// The sweep itself: for every width of vectors, and where the filter leaves much to the exact
// stages.

namespace {

template <std::size_t kDimension>
SiteRow<kDimension> row_of(const MeshView<kDimension, std::int32_t>& mesh, std::size_t s) {
  SiteRow<kDimension> row;
  for (std::size_t i = 0; i <= kDimension; ++i) row[i] = mesh.template site<false>(mesh.row(s)[i]);
  return row;
}

// All simplices are oriented alike.
template <std::size_t kDimension>
int orientation_of(const MeshView<kDimension, std::int32_t>& mesh) {
  Stages stages;
  return exact_orientation(row_of<kDimension>(mesh, 0), stages);
}

template <std::size_t kDimension>
Swept swept(const MeshView<kDimension, std::int32_t>& mesh, Lattice lattice,
            const BlockKernels<kDimension>& kernels) {
  const Orientations orientations(orientation_of<kDimension>(mesh));
  UsedPoints used(mesh.points());
  BoundarySimplices boundary(mesh.size());
  return sweep<kDimension, std::int32_t, std::int32_t>({.mesh = mesh,
                                                        .links = mesh.neighbors,
                                                        .orientations = orientations,
                                                        .sample = nullptr,
                                                        .balls = true,
                                                        .weighted = false,
                                                        .ties = true,
                                                        .lattice = lattice,
                                                        .used = used,
                                                        .boundary = boundary,
                                                        .kernels = &kernels},
                                                       0, mesh.size());
}

// Facets of two simplices whose far apexes are inside, on the ball: by exact signs.
struct Facets {
  std::vector<FacetId> not_local, ties;
};
template <std::size_t kDimension>
Facets facets_of(const MeshView<kDimension, std::int32_t>& mesh) {
  constexpr std::size_t kVertices = kDimension + 1;
  const int own = orientation_of<kDimension>(mesh);
  Facets facets;
  Stages stages;
  for (std::size_t f = 0; f < mesh.neighbors.size(); ++f) {
    const auto beyond = static_cast<std::size_t>(mesh.neighbors[f]);
    if (mesh.neighbors[f] < static_cast<std::int32_t>(f / kVertices)) continue;
    std::int32_t apex = mesh.row(f / kVertices)[f % kVertices];
    for (std::size_t i = 0; i < kVertices; ++i) {
      apex ^= mesh.row(f / kVertices)[i] ^ mesh.row(beyond)[i];
    }
    const int side = own * exact_ball_sign(row_of<kDimension>(mesh, f / kVertices),
                                           mesh.template site<false>(apex), false, stages);
    if (side >= 0)
      (side > 0 ? facets.not_local : facets.ties).emplace_back(f / kVertices, f % kVertices);
  }
  return facets;
}

template <std::size_t kDimension>
void hold_grid(std::size_t side) {
  auto mesh = grid_mesh<kDimension>(side);
  const auto links = matched_facets(mesh.view(), 1);
  mesh.neighbors.assign(links->view().begin(), links->view().end());
  std::mt19937_64 random(kDimension);
  // Unchanged; moved off any useful lattice, by the same amount everywhere; then moved by various
  // amounts.
  for (const int turn : {0, 1, 2}) {
    CAPTURE(turn);
    for (double& x : mesh.coordinates) {
      if (turn > 0) x += 0x1p-43;
      if (turn == 2 && random() % 4 == 0) x += static_cast<double>(random() % 5) * 0x1p-43;
    }
    const Lattice lattice = lattice_of_all(mesh.coordinates, {});
    CHECK((lattice.unit != 0) == (turn == 0));
    const Facets facets = facets_of<kDimension>(mesh.view());
    CHECK(facets.not_local.empty() == (turn < 2));
    CHECK_FALSE(facets.ties.empty());
    const Swept first = swept<kDimension>(mesh.view(), lattice, block_kernels<kDimension>()[0]);
    CHECK((first.stages.exact() > 0) == (turn > 0));
    CHECK(first.up == first.down);
    for (const BlockKernels<kDimension>& kernels : block_kernels<kDimension>()) {
      CAPTURE(std::string(kernels.name));
      const Swept again = swept<kDimension>(mesh.view(), lattice, kernels);
      REQUIRE(again.goes_on());
      CHECK(again.not_local == facets.not_local);
      CHECK(again.ties == facets.ties);
      CHECK(again.not_canonical == first.not_canonical);
      CHECK_FALSE(again.unique);
      CHECK(again.canonical == first.not_canonical.empty());
      CHECK(again.stages == first.stages);
    }
  }
}

TEST_CASE("facets that are not locally Delaunay are found, and ties, whatever decides") {
  hold_grid<2>(23);
  hold_grid<3>(7);
}

// Simplices oriented unlike most: sweeping some of them again gives the result of a sweep that
// knows all orientations.

// A sweep that knows all orientations; a flat simplex counts as positive.
struct SeenByAll {
  Swept swept;
  std::vector<std::size_t> unused;
  std::vector<FacetId> boundary;
};

template <std::size_t kDimension>
SeenByAll with_every_orientation_known(const MeshView<kDimension, std::int32_t>& mesh,
                                       bool past_doubts) {
  Stages stages;
  std::vector<std::uint64_t> negative(mesh.size() / 64 + 1, 0);
  for (std::size_t s = 0; s < mesh.size(); ++s) {
    const int sign = exact_orientation(row_of<kDimension>(mesh, s), stages);
    negative[s / 64] |= std::uint64_t{sign < 0} << (s % 64);
  }
  const Orientations orientations(negative);
  UsedPoints used(mesh.points());
  BoundarySimplices boundary(mesh.size());
  Swept swept = sweep<kDimension, std::int32_t, std::int32_t>(
      {.mesh = mesh,
       .links = mesh.neighbors,
       .orientations = orientations,
       .sample = nullptr,
       .balls = true,
       .weighted = false,
       .ties = true,
       .past_doubts = past_doubts,
       .lattice = lattice_of_all(mesh.coordinates, {}),
       .used = used,
       .boundary = boundary},
      0, mesh.size());
  return {std::move(swept), used.missing(),
          boundary.facets<kDimension + 1>(Links<std::int32_t>(mesh.neighbors), 0, mesh.size())};
}

// Returns whether orientations differ, and whether something else is wrong.
template <std::size_t kDimension>
std::array<bool, 2> hold_whole_sweep(const MeshInArrays<kDimension>& mesh, bool past_doubts) {
  const SeenByAll expected = with_every_orientation_known<kDimension>(mesh.view(), past_doubts);
  bool is_mixed = false;
  for (const unsigned threads : {1U, 3U}) {
    if (properties::kOneInputIn > 1 && threads == 1) continue;
    CAPTURE(threads);
    const auto view = mesh.view();
    WholeSweep<kDimension, std::int32_t, std::int32_t> sweep(view, mesh.neighbors, threads);
    const Swept found = sweep.run({.balls = true, .ties = true, .past_doubts = past_doubts});
    CHECK(found.undecided.has_value() == expected.swept.undecided.has_value());
    is_mixed = !sweep.orientations().are_equal();
    if (found.undecided || !is_mixed) continue;
    CHECK(found.doubtful == expected.swept.doubtful);
    CHECK(found.doubt == expected.swept.doubt);
    CHECK(found.not_local == expected.swept.not_local);
    CHECK(found.ties == expected.swept.ties);
    CHECK(found.not_canonical == expected.swept.not_canonical);
    CHECK(found.canonical == expected.swept.canonical);
    CHECK(found.up == expected.swept.up);
    CHECK(found.down == expected.swept.down);
    CHECK(found.stages == expected.swept.stages);
    CHECK(sweep.unused() == expected.unused);
    CHECK(sweep.boundary().template facets<kDimension + 1>(view.neighbors, 0, mesh.size()) ==
          expected.boundary);
  }
  return {is_mixed, is_mixed && expected.swept.doubt};
}

// Changes orientations: of rows, and of stars, by moving their points through facets.
template <std::size_t kDimension>
void hold_turned(std::size_t side) {
  constexpr std::size_t kVertices = kDimension + 1;
  std::mt19937_64 random(kDimension);
  auto grid = grid_mesh<kDimension>(side);
  for (std::size_t s = grid.size() - 1; s > 0; --s) {
    const auto row = grid.simplices.begin() + static_cast<std::ptrdiff_t>(s * kVertices);
    const std::size_t other = random() % (s + 1);
    std::swap_ranges(row, row + kVertices,
                     grid.simplices.begin() + static_cast<std::ptrdiff_t>(other * kVertices));
  }
  REQUIRE(grid.size() > 4 * WholeSweep<kDimension, std::int32_t, std::int32_t>::kChunk);
  std::array<int, 2> seen = {};  // among the mixed meshes: sound ones, and others
  // Under the sanitizers there is one turn in space, and two in the plane.
  constexpr bool kFew = properties::kOneInputIn > 1;
  constexpr int kFirst = kFew ? static_cast<int>(kDimension) - 1 : 0, kTurns = kFew ? 3 : 36;
  for (int turn = kFirst; turn < kTurns; ++turn) {
    CAPTURE(turn);
    auto mesh = grid;
    const bool all = turn % 8 == 7;  // negative, except for some
    const auto turn_row = [&](std::size_t s) {
      std::swap(mesh.simplices[s * kVertices], mesh.simplices[s * kVertices + 1]);
    };
    for (std::size_t s = 0; all && s < mesh.size(); ++s) turn_row(s);
    const std::size_t turned = turn == 2 ? 0 : random() % mesh.size();
    if (turn % 2 == 0) turn_row(turned);
    if (turn % 3 > 0 && turn % 8 != 2) {
      const std::size_t v = random() % mesh.view().points();
      mesh.coordinates[v * kDimension] += turn % 4 == 1 ? 1 : 1.5;  // flat ones, or none
    }
    const auto links = matched_facets(mesh.view(), 1);
    mesh.neighbors.assign(links->view().begin(), links->view().end());
    if (turn % 8 == 2) {  // the sweep does not come to the block's orientations
      mesh.neighbors[turned / kBlock * kBlock * kVertices] =
          static_cast<std::int32_t>(mesh.size() - 1);
    }
    hold_whole_sweep<kDimension>(mesh, false);
    const auto [is_mixed, is_wrong] = hold_whole_sweep<kDimension>(mesh, true);
    if (is_mixed) ++seen[is_wrong ? 1 : 0];
  }
  CHECK(std::min(seen[0], seen[1]) >= kTurns / 9);
}

TEST_CASE("simplices that are oriented otherwise than most") {
  hold_turned<2>(100);
  hold_turned<3>(16);
}

// The facts about simplices that need not cover anything in particular.

using FacetIds = std::vector<FacetId>;

constexpr Wanted kBalls{.balls = true};

Undecided why_not(const MeshInArrays<2>& mesh) {
  const auto found = simplex_facts(mesh.view(), kBalls, 1);
  REQUIRE_FALSE(found.has_value());
  return found.error();
}

// Two squares that share no vertex; the second one has no unique Delaunay diagonal.
const MeshInArrays<2> kTwoSquares{{0, 0, 1, 0, 0, 1, 1, 1, 5, 5, 6, 5, 5, 6, 7, 7},
                                  {0, 1, 3, 0, 3, 2, 4, 5, 6, 5, 7, 6}};

TEST_CASE("a domain in two parts: boundary, ties, and facets that are not locally Delaunay") {
  MeshInArrays<2> mesh = kTwoSquares;
  const auto found = simplex_facts(mesh.view(), kBalls, 1);
  REQUIRE(found.has_value());
  CHECK(found->boundary ==
        FacetIds{{0, 0}, {0, 2}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {3, 0}, {3, 2}});
  CHECK(found->ties == FacetIds{{0, 1}});
  CHECK(found->not_canonical.empty());
  CHECK(found->not_local.empty());
  CHECK(found->oriented);
  CHECK(!found->fills_hull);

  mesh.simplices = {0, 1, 2, 1, 3, 2, 4, 5, 7, 4, 7, 6};
  const auto flipped = simplex_facts(mesh.view(), kBalls, 1);
  REQUIRE(flipped.has_value());
  CHECK(flipped->ties == FacetIds{{0, 0}});
  CHECK(flipped->not_canonical == FacetIds{{0, 0}});
  CHECK(flipped->not_local == FacetIds{{2, 1}});

  const auto unasked = simplex_facts(mesh.view(), {}, 1);
  REQUIRE(unasked.has_value());
  CHECK(unasked->ties.empty());
  CHECK(unasked->not_local.empty());
  CHECK(unasked->boundary == flipped->boundary);
}

TEST_CASE("whether they fill the hull of all points, if that is asked") {
  MeshInArrays<2> mesh{{0, 0, 1, 0, 0, 1, 1, 1}, {0, 1, 3, 0, 3, 2}};
  CHECK(simplex_facts(mesh.view(), {.hull = true}, 1)->fills_hull);
  CHECK_FALSE(simplex_facts(mesh.view(), kBalls, 1)->fills_hull);
  CHECK_FALSE(simplex_facts(kTwoSquares.view(), {.hull = true}, 1)->fills_hull);
  mesh.coordinates.insert(mesh.coordinates.end(), {0.5, 0.25});
  CHECK_FALSE(simplex_facts(mesh.view(), {.hull = true}, 1)->fills_hull);  // a point is unused
  mesh.coordinates.resize(8);
  mesh.simplices.resize(3);
  CHECK_FALSE(simplex_facts(mesh.view(), {.hull = true}, 1)->fills_hull);
}

// Tetrahedra here and there, some of them beside others: each with four points of its own.
MeshInArrays<3> scattered(std::mt19937_64& random, double size, double offset, bool rounded) {
  std::uniform_real_distribution<double> in_cube(0, 1);
  MeshInArrays<3> mesh;
  std::array<double, 3> centre = {};
  for (std::int32_t v = 0; v < 40; ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (v % 4 == 0) centre[axis] = in_cube(random);
      const double at = centre[axis] + size * in_cube(random);
      mesh.coordinates.push_back(offset + (rounded ? std::floor(16 * at) : at));
    }
    mesh.simplices.push_back(v);
  }
  return mesh;
}

std::vector<std::size_t> full_balls(const MeshInArrays<3>& mesh) {
  const auto view = mesh.view();
  std::vector<std::size_t> full;
  Stages stages;
  for (std::size_t s = 0; s < mesh.size(); ++s) {
    SiteRow<3> row;
    for (std::size_t i = 0; i < 4; ++i) row[i] = view.site<false>(view.row(s)[i]);
    const auto ball = ball_of<3, false>(row);
    const int own = ball.orientation(stages);
    std::int32_t v = 0;
    while (view.names_point(v) && ball.contains(view.site<false>(v), stages) * own <= 0) ++v;
    if (view.names_point(v)) full.push_back(s);
  }
  return full;
}

TEST_CASE("which balls at the boundary are not empty, if that is asked") {
  std::mt19937_64 random(1);
  std::array<int, 2> seen = {};
  for (int i = 0; i < 2000 / properties::kOneInputIn; ++i) {
    CAPTURE(i);
    const auto mesh = scattered(random, i % 2 == 0 ? 0.1 : 0.4, i % 3 == 0 ? 1000 : 0, i % 5 == 0);
    const auto found = simplex_facts(mesh.view(), {.balls = true, .boundary_balls = true}, 1);
    if (!found) continue;  // one is flat
    const std::vector<std::size_t> full = full_balls(mesh);
    CHECK(found->doubtful_balls == full);
    CHECK(found->boundary_balls_are_empty() == full.empty());
    ++seen[full.empty() ? 1 : 0];
  }
  CHECK(std::min(seen[0], seen[1]) > 100 / properties::kOneInputIn);
  const auto grid = grid_mesh<3>(8);
  for (const unsigned threads : {1U, 3U}) {
    CHECK(simplex_facts(grid.view(), {.balls = true, .boundary_balls = true}, threads)
              ->boundary_balls_are_empty());
  }
  CHECK_FALSE(simplex_facts(grid.view(), kBalls, 1)->boundary_balls_are_empty());
  // Nothing is known if numbers differ too much in size. One ball has a radius beyond all doubles.
  const auto is_known_empty = [](double height) {
    const MeshInArrays<3> one{{0, 0, 0, 1, 0, 0, 0, 1, 0, 0.25, 0.25, height}, {0, 1, 2, 3}};
    return simplex_facts(one.view(), {.balls = true, .boundary_balls = true}, 1)
        ->boundary_balls_are_empty();
  };
  CHECK_FALSE(is_known_empty(1e200));
  CHECK(is_known_empty(1e-200));
}

TEST_CASE("a facet is named in order of simplices, then of places") {
  constexpr std::size_t kLast = (std::size_t{1} << 62) - 1;
  static_assert(FacetId(kLast, 3).simplex() == kLast && FacetId(kLast, 3).place() == 3);
  static_assert(FacetId(2, 3) < FacetId(3, 0) && FacetId(3, 0) < FacetId(3, 1));
}

TEST_CASE("what is not sound is left undecided") {
  const auto with = [](auto change) {
    MeshInArrays<2> mesh = kTwoSquares;
    change(mesh);
    return why_not(mesh);
  };
  CHECK(with([](auto& m) { m.simplices.clear(); }) == Undecided::kEmpty);
  CHECK(with([](auto& m) { m.simplices[0] = 8; }) == Undecided::kUnknownVertex);
  CHECK(with([](auto& m) { m.simplices[7] = 4; }) == Undecided::kFlatSimplex);
  CHECK(with([](auto& m) { m.coordinates[3] = std::numeric_limits<double>::infinity(); }) ==
        Undecided::kNotFinite);
  // A simplex twice, alone and beside another one; three at an edge; two on the same side of one.
  CHECK(with([](auto& m) {
          m.simplices.insert(m.simplices.end(), {6, 5, 4});
        }) == Undecided::kFacetOverused);
  CHECK(why_not({{0, 0, 1, 0, 0, 1}, {0, 1, 2, 2, 0, 1}}) == Undecided::kUnmatchedNeighbor);
  CHECK(with([](auto& m) {
          m.simplices.insert(m.simplices.end(), {0, 3, 5});
        }) == Undecided::kFacetOverused);
  CHECK(why_not({{0, 0, 1, 0, 0, 1, 1, 1}, {0, 1, 2, 0, 1, 3}}) == Undecided::kSameSide);
}

// As `judge` says of a grid, for any number of threads.
template <std::size_t kDimension>
void check_facts_of_grid(bool mirrored) {
  const auto mesh =
      grid_mesh<kDimension>(properties::points_a_side(kDimension == 2 ? 200 : 24), mirrored);
  const auto judged = judge(mesh.view(), Question::kDelaunay, 1);
  const auto first = simplex_facts(mesh.view(), kBalls, 1);
  REQUIRE(judged.has_value());
  REQUIRE(first.has_value());
  CHECK(first->oriented == judged->oriented);
  CHECK(first->ties.empty() == judged->unique);
  CHECK(first->not_canonical.empty() == judged->canonical);
  const auto again = simplex_facts(mesh.view(), kBalls, 3);
  REQUIRE(again.has_value());
  CHECK(again->boundary == first->boundary);
  CHECK(again->ties == first->ties);
  CHECK(again->not_canonical == first->not_canonical);
  CHECK(std::is_sorted(first->boundary.begin(), first->boundary.end()));
  CHECK(std::is_sorted(first->ties.begin(), first->ties.end()));
}

TEST_CASE("grids, however their simplices are oriented") {
  for (const bool mirrored : {false, true}) {
    check_facts_of_grid<2>(mirrored);
    check_facts_of_grid<3>(mirrored);
  }
}

}  // namespace

}  // namespace circumspect::fast
