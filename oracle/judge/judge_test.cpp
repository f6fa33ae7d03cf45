// The one judge, on grids with facets that are not locally Delaunay and on meshes that the fast
// engine does not take: what it says is what the exact checkers say. On the corpus:
// corpus/judge_test.cpp.
#include "oracle/judge/judge.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/simplex.hpp"
#include "oracle/judge/default_claim.hpp"
#include "oracle/judge/domain/domain_cases_test.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "oracle/judge/fault_of_claim.hpp"
#include "oracle/judge/points/delaunay.hpp"
#include "oracle/judge/witness_text_test.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::check {

// Triangulations with many facets that are not locally Delaunay: grids, each cube cut alike, whose
// inner points are moved a little, and get weights.

// `side` points along each axis, two at least; coordinates and weights are doubles. By no more than
// `steps` / 1024 each coordinate moves: up to 50 keep every simplex as it is oriented.
inline ExactMesh shaken_grid(std::size_t dimension, std::size_t side, bool weighted,
                             long steps = 50) {
  std::mt19937 random(7);
  const auto draw = [&random](long most) {
    return static_cast<long>(random() % static_cast<unsigned long>(2 * most + 1)) - most;
  };
  std::vector<std::size_t> stride(dimension, 1);
  for (std::size_t axis = 1; axis < dimension; ++axis) stride[axis] = stride[axis - 1] * side;
  std::vector<Point> points;
  std::vector<Rational> weights;
  std::vector<Simplex> simplices;
  for (std::size_t v = 0; v < stride.back() * side; ++v) {
    Point point;
    bool is_inner = true, is_corner = true;
    for (const std::size_t step : stride) {
      const std::size_t place = v / step % side;
      point.push_back(static_cast<long>(place));
      is_inner &= place > 0 && place + 1 < side;
      is_corner &= place + 1 < side;
    }
    for (Rational& coordinate : point) {
      if (is_inner) coordinate += Rational(draw(steps)) / 1024;
    }
    points.push_back(point);
    if (weighted) weights.push_back(Rational(draw(100)) / 1024);
    if (!is_corner) continue;
    std::vector<std::size_t> order = stride;
    do {
      Simplex simplex = {static_cast<Vertex>(v)};
      for (const std::size_t step : order) {
        simplex.push_back(simplex.back() + static_cast<Vertex>(step));
      }
      simplices.push_back(std::move(simplex));
    } while (std::next_permutation(order.begin(), order.end()));
  }
  // In no particular order.
  std::shuffle(simplices.begin(), simplices.end(), random);
  return {PointSet(std::move(points), std::move(weights)), std::move(simplices)};
}

namespace {

const PointSet kSquare({{0, 0}, {1, 0}, {0, 1}, {1, 1}});
const std::vector<Simplex> kTwo = {{0, 1, 2}, {1, 3, 2}};

Verdict judged(Claim claim, const ExactMesh& mesh, const Options& options = {}) {
  Verdict verdict = judge(claim, in_rows(mesh), nullptr, options).value();
  CHECK(text_of(verdict, mesh) == text_of(judge_exactly(claim, mesh, nullptr, options), mesh));
  CHECK(verdict.course.fast == verdict.course.why_not_fast.empty());
  return verdict;
}

std::string why_not_fast(Claim claim, const ExactMesh& mesh, const Options& options = {}) {
  return judged(claim, mesh, options).course.why_not_fast;
}

}  // namespace

TEST_CASE("grids with many facets that are not locally Delaunay: the words, the order, the count") {
  for (const std::size_t dimension : {2u, 3u}) {
    for (const Claim claim : {Claim::kDelaunay, Claim::kWeightedDelaunay}) {
      const ExactMesh mesh =
          shaken_grid(dimension, dimension == 2 ? 9 : 5, claim == Claim::kWeightedDelaunay);
      REQUIRE(judge_points(Claim::kTriangulation, mesh).holds());
      for (const std::size_t most : {0u, 1u, 20u}) {
        for (const unsigned threads : {1u, 2u}) {
          const Verdict verdict = judged(claim, mesh, {.max_violations = most, .threads = threads});
          CHECK(verdict.course.fast);
          CHECK(verdict.tallies().begin()->second.count > 20);
        }
      }
    }
  }
}

TEST_CASE("many faulty ridges, most of which are counted alone: the words, the order, the count") {
  std::mt19937 random(3);
  for (const std::size_t dimension : {2u, 3u}) {
    for (const long steps : {0L, 50L}) {
      for (const unsigned one_in : {2u, 9u}) {
        ExactMesh mesh = shaken_grid(dimension, dimension == 2 ? 9 : 4, false, steps);
        std::erase_if(mesh.simplices, [&](const Simplex&) { return random() % one_in == 0; });
        for (const std::size_t most : {0u, 1u, 3u, 20u}) {
          const Verdict verdict = judged(Claim::kDelaunay, mesh, {.max_violations = most});
          const Verdict exactly =
              judge_exactly(Claim::kDelaunay, mesh, nullptr, {.max_violations = most});
          for (const auto& [rule, tally] : verdict.tallies()) {
            CHECK(tally.in_all == exactly.tallies().at(rule).in_all);
          }
          CHECK(verdict.course.fast);
          CHECK(verdict.tallies().contains(Rule::kHullNotConvex));
        }
      }
    }
  }
}

// Two holes beside one vertex, which all that is wrong names.
TEST_CASE("a vertex that every faulty ridge names is known where most are counted alone") {
  ExactMesh mesh = shaken_grid(3, 4, false, 0);
  std::erase_if(mesh.simplices, [](const Simplex& simplex) { return contains(simplex, 21); });
  for (const std::size_t most : {0u, 1u, 5u}) {
    const Verdict verdict = judged(Claim::kTriangulation, mesh, {.max_violations = most});
    const Verdict exactly =
        judge_exactly(Claim::kTriangulation, mesh, nullptr, {.max_violations = most});
    REQUIRE(verdict.tallies().size() == exactly.tallies().size());
    for (const auto& [rule, tally] : exactly.tallies()) {
      CHECK(verdict.tallies().at(rule).in_all == tally.in_all);
      CHECK(verdict.tallies().at(rule).count == tally.count);
    }
  }
}

TEST_CASE("one facet that is not locally Delaunay, in the midst of a mesh, by its own numbers") {
  ExactMesh mesh = shaken_grid(3, 5, false, 0);
  REQUIRE(judge_points(Claim::kDelaunay, mesh).holds());
  std::vector<Point> points = mesh.points.points();
  points[62][0] += Rational(1) / 1024;  // the middle of the grid
  mesh.points = PointSet(points);
  const Verdict verdict = judged(Claim::kDelaunay, mesh);
  CHECK(verdict.course.fast);
  const Witness& witness = verdict.violations().front().witness;
  const Simplex& simplex = witness.simplices.front();
  CHECK(std::find(mesh.simplices.begin(), mesh.simplices.end(), simplex) != mesh.simplices.end());
}

TEST_CASE("given neighbours are judged, where indices have 64 bits, too") {
  Mesh square = in_rows({kSquare, kTwo});
  const auto with_neighbors = [&square]<class Index>(Index width, std::vector<Simplex> rows) {
    Rows<Index> array(rows.size(), 3);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      std::copy(rows[i].begin(), rows[i].end(), array.row(i).begin());
    }
    square.neighbors.emplace(IndexLists(std::move(array)), width - width);
    return judge(Claim::kDelaunay, square).value();
  };
  const std::vector<Simplex> right = {{1, -1, -1}, {-1, 0, -1}}, wrong = {{-1, 1, -1}, {-1, 0, -1}};
  const auto check_all = [&](bool wide_simplices) {
    CHECK(with_neighbors(std::int32_t{}, right).course.fast);
    CHECK(with_neighbors(std::int64_t{}, right).course.fast == wide_simplices);
    CHECK(with_neighbors(std::int64_t{}, right).holds());
    CHECK(!with_neighbors(std::int32_t{}, wrong).holds());
    CHECK(!with_neighbors(std::int64_t{}, wrong).holds());
  };
  check_all(false);
  Rows<std::int64_t> wide(2, 3);
  for (std::size_t i = 0; i < 2; ++i)
    std::copy(kTwo[i].begin(), kTwo[i].end(), wide.row(i).begin());
  square.simplices = std::move(wide);
  check_all(true);
}

TEST_CASE("neighbours counted from 1: one before the first is not none") {
  ExactMesh listed{kSquare, kTwo};
  listed.neighbors = Neighbors{{{2, -1, -1}, {-1, 1, -1}}, 1};
  CHECK(judged(Claim::kDelaunay, listed).course.fast);
  listed.neighbors->rows[0][1] = 0;
  const Verdict verdict = judged(Claim::kDelaunay, listed);
  CHECK(!verdict.course.fast);
  CHECK(verdict.tallies().begin()->first == Rule::kWrongNeighbor);
}

TEST_CASE("what the fast engine does not take, and why") {
  const ExactMesh square{kSquare, kTwo};
  CHECK(why_not_fast(Claim::kDelaunay, square).empty());
  CHECK(why_not_fast(Claim::kWeightedDelaunay, square).empty());
  CHECK(why_not_fast(Claim::kDelaunay, square, {.by = By::kDefinition}) == "judged by definition");
  const PointSet thirds({{0, 0}, {1, 0}, {0, 1}, {Rational(1) / 3, 1}});
  CHECK(why_not_fast(Claim::kDelaunay, {thirds, kTwo}) == "a number that is not a double");
  const PointSet heavy({{0, 0}, {1, 0}, {0, 1}}, {Rational(1) / 3, 0, 0});
  CHECK(why_not_fast(Claim::kWeightedDelaunay, {heavy, {{0, 1, 2}}}) ==
        "a number that is not a double");
  CHECK(why_not_fast(Claim::kTriangulation, {heavy, {{0, 1, 2}}}).empty());
  CHECK(why_not_fast(Claim::kDelaunay, {kSquare, {{0, 1, 2}, {1, 3}}}) ==
        "simplices of various sizes");
  CHECK(why_not_fast(Claim::kDelaunay, {kSquare, {{0, 1}, {1, 3}}}) ==
        "simplices of a lower dimension");
  CHECK(why_not_fast(Claim::kDelaunay, {kSquare, {}}) == "no simplices");
  CHECK(why_not_fast(Claim::kDelaunay, {PointSet({}), {}}) == "no simplices");
  CHECK(why_not_fast(Claim::kDelaunay, {PointSet(std::vector<Point>{{0}, {1}}), {{0, 1}}}) ==
        "a dimension other than 2 and 3");
}

using Change = std::function<void(ExactMesh&)>;

// Changes that break a rule each, in the midst of a mesh.
std::vector<std::pair<Rule, Change>> faults_of(const ExactMesh& good) {
  const auto n = static_cast<Vertex>(good.points.size());
  const std::size_t s = good.simplices.size() / 2;
  return {
      {Rule::kUnknownVertex, [=](ExactMesh& m) { m.simplices[s][0] = n; }},
      {Rule::kUnknownVertex, [=](ExactMesh& m) { m.simplices[0][1] = Vertex{-1} << 40; }},
      {Rule::kRepeatedVertex, [=](ExactMesh& m) { m.simplices[s][0] = m.simplices[s][1]; }},
      {Rule::kDuplicateSimplex,
       [=](ExactMesh& m) {
         m.simplices.push_back(m.simplices[s]);
         std::swap(m.simplices.back()[0], m.simplices.back()[1]);
       }},
      {Rule::kOverlap,
       [=](ExactMesh& m) {
         std::vector<Point> points = m.points.points();
         points[static_cast<std::size_t>(n) / 2 + 3][0] += Rational(9) / 8;
         m.points = PointSet(points);
       }},
      {Rule::kHullNotConvex,
       [=](ExactMesh& m) {
         m.simplices.erase(m.simplices.begin() + static_cast<std::ptrdiff_t>(s));
       }},
      {Rule::kUnusedPoint,
       [=](ExactMesh& m) {
         std::vector<Point> points = m.points.points();
         points.push_back(points[0]);
         points.back()[0] -= Rational(1) / 8;
         m.points = PointSet(points);
       }},
  };
}

// Each fault by itself and all of them together, in the midst of a mesh that is large enough for
// several chunks.
TEST_CASE(
    "every fault of a mesh of doubles is found fast, and told in the words of the exact checkers") {
  for (const std::size_t dimension : {2u, 3u}) {
    const ExactMesh good = shaken_grid(dimension, dimension == 2 ? 50 : 10, false, 0);
    REQUIRE(good.simplices.size() > 4000);
    ExactMesh all = good;
    int asked = 0;
    const auto check_fast = [&asked](const ExactMesh& mesh, std::optional<Rule> rule) {
      for (const Claim claim :
           {Claim::kTriangulation, Claim::kDelaunay, Claim::kWeightedDelaunay}) {
        if (claim == Claim::kWeightedDelaunay && rule == Rule::kUnusedPoint) continue;
        for (const unsigned threads : {1u, 3u}) {
          if (properties::kOneInputIn > 1 && asked++ % 5 != 0) continue;  // of each fault another
          const Verdict verdict =
              judged(claim, mesh, {.oriented = threads == 3, .threads = threads});
          CHECK(verdict.course.fast);
          if (rule) CHECK(verdict.tallies().contains(*rule));
        }
      }
    };
    for (const auto& fault : faults_of(good)) {
      const Rule rule = fault.first;
      CAPTURE(identifier(rule));
      ExactMesh mesh = good;
      fault.second(mesh);
      check_fast(mesh, rule);
      fault.second(all);
    }
    check_fast(all, std::nullopt);
  }
}

TEST_CASE("two pieces apart, each convex, are told fast in the words of the exact checkers") {
  for (const std::size_t dimension : {2u, 3u}) {
    const ExactMesh one = shaken_grid(dimension, 3, false);
    std::vector<Point> points = one.points.points();
    std::vector<Simplex> simplices = one.simplices;
    for (Point point : one.points.points()) {
      point[0] += 10;
      points.push_back(point);
    }
    for (Simplex simplex : one.simplices) {
      for (Vertex& v : simplex) v += static_cast<Vertex>(one.points.size());
      simplices.push_back(simplex);
    }
    const Verdict verdict = judged(Claim::kTriangulation, {PointSet(points), simplices});
    CHECK(verdict.course.fast);
    CHECK(verdict.tallies().contains(Rule::kHullNotConvex));
  }
}

TEST_CASE("neighbours that are wrong are found fast, beside facets that are not locally Delaunay") {
  for (const std::size_t dimension : {2u, 3u}) {
    ExactMesh mesh = shaken_grid(dimension, 5, false);
    for (const Vertex first : {Vertex{0}, Vertex{1}}) {
      std::vector<std::vector<Vertex>> rows(mesh.simplices.size(),
                                            std::vector<Vertex>(dimension + 1, -1));
      for (const auto uses : ByFacet(facet_uses(mesh.simplices))) {
        if (uses.size() != 2) continue;
        rows[uses[0].simplex][uses[0].opposite] = static_cast<Vertex>(uses[1].simplex) + first;
        rows[uses[1].simplex][uses[1].opposite] = static_cast<Vertex>(uses[0].simplex) + first;
      }
      for (const Vertex wrong : {Vertex{-1}, Vertex{-2}, Vertex{7}, Vertex{1} << 20}) {
        rows[9][1] = wrong;
        mesh.neighbors = Neighbors{rows, first};
        const Verdict verdict = judged(Claim::kDelaunay, mesh);
        CHECK(verdict.course.fast);
        CHECK(verdict.tallies().contains(Rule::kWrongNeighbor));
        CHECK(verdict.tallies().contains(Rule::kFacetNotLocal));
      }
    }
  }
}

TEST_CASE("equal points are an error, or count as one, and then the fast engine decides") {
  const auto square_with = [](const Point& again) {
    Mesh mesh = in_rows({kSquare, {{0, 1, 2}, {1, 3, 4}}});
    std::vector<Point> points = kSquare.points();
    points.push_back(again);
    mesh.coordinates = numbers_of(points, 2);
    return mesh;
  };
  Mesh mesh = square_with({0, 1});
  for (const Claim claim : {Claim::kTriangulation, Claim::kDelaunay, Claim::kWeightedDelaunay}) {
    const auto verdict = judge(claim, mesh);
    REQUIRE(!verdict);
    REQUIRE(verdict.error().repeated.size() == 1);
    CHECK(verdict.error().repeated[0].kept == 2);
    CHECK(verdict.error().repeated[0].again == 4);
  }
  const Verdict merged = judge(Claim::kDelaunay, Merging{mesh});
  CHECK(merged.holds());
  CHECK(merged.points == 4);
  CHECK(merged.course.fast);
  Mesh apart = square_with({0, 1});
  CHECK(judge(Claim::kComplex, Merging{apart}, nullptr).holds());
  CHECK(mesh.listed(mesh.simplices[1], 1) == Simplex{1, 3, 4});
  Mesh thirds = square_with({Rational(1) / 3, 7});
  CHECK(judge(Claim::kDelaunay, thirds).has_value());
}

TEST_CASE("where nobody names a claim, the points of the mesh and of the domain decide") {
  PiecewiseLinearInput input;
  input.points = kSquare.points();
  input.segments = {{0, 1}, {1, 3}, {2, 3}, {0, 2}};
  const Domain domain = domain_of(input);
  const auto claim_of = [&](const std::vector<Point>& points, bool are_moved) {
    return default_claim(in_rows({PointSet(points), {{0, 1, 2}, {1, 3, 2}}}), &domain, are_moved);
  };
  std::vector<Point> points = kSquare.points();
  CHECK(default_claim(in_rows({kSquare, {{0, 1, 2}}}), nullptr) == Claim::kDelaunay);
  std::swap(points[0], points[3]);
  CHECK(claim_of(points, false) == Claim::kCdt);
  CHECK(claim_of(points, true) == Claim::kCdt);
  points[0] = {1, 2};
  CHECK(claim_of(points, false) == Claim::kSteinerCdt);
  CHECK(claim_of(points, true) == Claim::kCdt);
  points.push_back({5, 5});
  CHECK(claim_of(points, false) == Claim::kSteinerCdt);
  CHECK(claim_of(points, true) == Claim::kSteinerCdt);
  points.resize(3);
  CHECK(claim_of(points, true) == Claim::kSteinerCdt);
}

TEST_CASE("only a mesh that a lattice repeats can be asked for the claim periodic-delaunay") {
  Mesh mesh = in_rows({kSquare, {{0, 1, 2}}});
  CHECK(fault_of_claim(Claim::kPeriodicDelaunay, mesh, {}).starts_with("expected a mesh that a "));
  mesh.copies.emplace();
  CHECK(fault_of_claim(Claim::kPeriodicDelaunay, mesh, {}).empty());
  CHECK(fault_of_claim(Claim::kDelaunay, mesh, {}).empty());
  CHECK(fault_of_claim(Claim::kVoronoi, mesh, {}) ==
        "expected the cells of a Voronoi diagram for the claim voronoi, found a mesh");
}

}  // namespace circumspect::check
