// Meshes of domains, judged with what the fast judge knows of their simplices and without: the same
// word for word, whatever is wrong with them. On the corpus: corpus/simplex_facts_slow_test.cpp.
#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"
#include "oracle/judge/domain/domain_cases_test.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "oracle/judge/judge.hpp"
#include "oracle/judge/known_mesh.hpp"
#include "oracle/judge/not_conforming.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::check {
namespace {

constexpr Claim kClaims[] = {Claim::kPlcTriangulation, Claim::kSteinerTriangulation, Claim::kCdt,
                             Claim::kSteinerCdt, Claim::kConformingDelaunay};

std::optional<fast::SimplexFacts> facts_of(Claim claim, const ExactMesh& mesh, const Domain& domain,
                                           Options options = {}) {
  options.threads = 2;
  auto facts = facts_of_simplices(claim, in_rows(mesh), domain.complex.kind, options);
  return facts ? std::optional(std::move(*facts)) : std::nullopt;
}

Verdict judged(Claim claim, const ExactMesh& mesh, const Domain& domain, Options options = {}) {
  options.threads = 1;
  return judge(claim, in_rows(mesh), &domain, options).value();
}

// How many meshes there was something known of, and how many judgements found something wrong.
struct Counted {
  std::size_t known = 0;
  std::size_t unknown = 0;
  std::size_t broken = 0;
};

// The fast judge finds what the exact predicates find, if it finds anything; and the verdict is the
// same.
void compare(Claim claim, const ExactMesh& mesh, const Domain& domain, const Options& options,
             Counted& counted) {
  const std::optional<fast::SimplexFacts> known = facts_of(claim, mesh, domain, options);
  const Verdict slow = judge_exactly(claim, mesh, &domain, options);
  const Verdict verdict = judged(claim, mesh, domain, options);
  CHECK(text_of(verdict) == text_of(slow));
  CHECK(verdict.course.fast == known.has_value());
  counted.broken += slow.holds() ? 0 : 1;
  ++(known ? counted.known : counted.unknown);
  if (!known) return;
  const std::optional<fast::SimplexFacts> exact = exact_facts(claim, mesh, domain);
  REQUIRE(exact.has_value());
  CHECK(known->boundary == exact->boundary);
  CHECK(known->not_local == exact->not_local);
  CHECK(known->ties == exact->ties);
  CHECK(known->not_canonical == exact->not_canonical);
  CHECK((!known->fills_hull || exact->fills_hull));
}

// A domain and a mesh that fills it.
struct Filled {
  Domain domain;
  ExactMesh mesh;
};

// A triangle beside a vertex that is a polygon within the cube, and a point at its centre.
std::vector<Filled> filled_domains() {
  std::vector<Filled> filled;
  const PiecewiseLinearInput box = generators::box(0, 2);
  filled.push_back({domain_of(box), {PointSet(box.points), kCubeInFive}});
  PiecewiseLinearInput cut = box;
  cut.polygons.push_back({{{0, 3, 5}}, {}});
  filled.push_back({domain_of(cut), {PointSet(box.points), kCubeInFive}});
  PiecewiseLinearInput hull = box;
  hull.polygons = {{{{0, 3, 5}}, {}}};
  hull.kind = DomainKind::kHull;
  filled.push_back({domain_of(hull), {PointSet(box.points), kCubeInFive}});
  const ExactMesh in_plane = grid({0, 1, 2}, {0, 2}, {0}, every_cell);
  PiecewiseLinearInput square = cuboid({0, 0}, {2, 2});
  filled.push_back({domain_of(square), in_plane});
  square.kind = DomainKind::kHull;
  square.segments = {{0, 2}};
  filled.push_back({domain_of(square), {PointSet(square.points), {{0, 1, 2}, {0, 2, 3}}}});
  // What is not flat is dangling.
  PiecewiseLinearInput flag = box;
  flag.points.insert(flag.points.end(), {{4, 0, 0}, {4, 2, 0}});
  flag.polygons.push_back({{{1, 8, 9, 3}}, {}});
  filled.push_back(
      {domain_of(flag), {PointSet(flag.points), kCubeInSix, {}, 0, {}, {{1, 8, 9}, {1, 3, 9}}}});
  return filled;
}

// One index of one simplex changed to any other, or a simplex dropped, or listed twice.
std::vector<ExactMesh> mutants(const ExactMesh& mesh) {
  std::vector<ExactMesh> all;
  for (std::size_t s = 0; s < mesh.simplices.size(); ++s) {
    ExactMesh fewer = mesh;
    fewer.simplices.erase(fewer.simplices.begin() + static_cast<Vertex>(s));
    all.push_back(fewer);
    ExactMesh more = mesh;
    more.simplices.push_back(mesh.simplices[s]);
    all.push_back(more);
    for (std::size_t place = 0; place < mesh.simplices[s].size(); ++place) {
      for (Vertex v = -1; v <= static_cast<Vertex>(mesh.points.size()); ++v) {
        ExactMesh other = mesh;
        other.simplices[s][place] = v;
        all.push_back(other);
      }
    }
  }
  return all;
}

std::set<Rule> rules(Claim claim, const ExactMesh& mesh, const Domain& domain,
                     const Options& options = {}) {
  std::set<Rule> broken;
  const Verdict verdict = judged(claim, mesh, domain, options);
  for (const auto& [rule, tally] : verdict.tallies()) broken.insert(rule);
  CHECK(text_of(verdict) == text_of(judge_exactly(claim, mesh, &domain, options)));
  return broken;
}

ExactMesh cube_with(std::vector<Simplex> simplices) {
  return {PointSet(generators::box(0, 2).points), std::move(simplices)};
}

TEST_CASE("meshes that fill their domains, by all claims") {
  Counted counted;
  for (const Filled& filled : filled_domains()) {
    for (const Claim claim : kClaims) {
      compare(claim, filled.mesh, filled.domain, {}, counted);
      compare(claim, filled.mesh, filled.domain, {.oriented = true}, counted);
    }
  }
  CHECK(counted.known > 30);
  CHECK(counted.unknown > 0);  // not all oriented alike
}

TEST_CASE("a Steiner point that divides an inner segment may have any number") {
  PiecewiseLinearInput halves = cuboid({0, 0}, {2, 2});
  halves.points.insert(halves.points.end(), {{1, 0}, {1, 2}});
  halves.segments = {{0, 4}, {1, 4}, {1, 2}, {2, 5}, {3, 5}, {0, 3}, {4, 5}};
  const ExactMesh mesh = grid({0, 1, 2}, {0, 1, 2}, {0}, every_cell);
  const auto n = static_cast<Vertex>(mesh.points.size());
  for (Vertex by = 0; by < n; ++by) {
    std::vector<Point> points(mesh.points.size());
    for (Vertex v = 0; v < n; ++v) points[static_cast<std::size_t>((v + by) % n)] = mesh.points[v];
    std::vector<Simplex> simplices = mesh.simplices;
    for (Simplex& simplex : simplices) {
      for (Vertex& v : simplex) v = (v + by) % n;
    }
    Counted counted;
    compare(Claim::kSteinerCdt, {PointSet(points), simplices}, domain_of(halves), {}, counted);
    CHECK(counted.known == 1);
    CHECK(counted.broken == 0);
  }
}

TEST_CASE("meshes with one fault, in every place") {
  Counted counted;
  std::size_t seen = 0;
  for (const Filled& filled : filled_domains()) {
    for (const ExactMesh& mutant : mutants(filled.mesh)) {
      if (seen++ % properties::kOneInputIn != 0) continue;
      compare(Claim::kSteinerCdt, mutant, filled.domain, {.max_violations = 0}, counted);
    }
  }
  CHECK(counted.known > 20 / properties::kOneInputIn);
  CHECK(counted.unknown > 500 / properties::kOneInputIn);
  CHECK(counted.broken > 900 / properties::kOneInputIn);
}

TEST_CASE("of simplices that are not sound, or not matched, nothing is known") {
  const Domain cube = domain_of(generators::box(0, 2));
  const auto broken_by = [&](const std::function<void(std::vector<Simplex>&)>& change,
                             const Options& options = {}) {
    std::vector<Simplex> simplices = kCubeInFive;
    change(simplices);
    const ExactMesh mesh = cube_with(simplices);
    CHECK(!facts_of(Claim::kCdt, mesh, cube, options));
    return rules(Claim::kCdt, mesh, cube, options);
  };
  const auto is = [](std::initializer_list<Rule> rules) { return std::set<Rule>(rules); };
  CHECK(broken_by([](auto& all) { all[0][0] = 8; }) == is({Rule::kUnknownVertex}));
  CHECK(broken_by([](auto& all) { all[0][0] = Vertex{1} << 32; }) == is({Rule::kUnknownVertex}));
  CHECK(broken_by([](auto& all) { all[0].pop_back(); }) == is({Rule::kWrongDimension}));
  CHECK(broken_by([](auto& all) { all[0][0] = all[0][1]; }) == is({Rule::kRepeatedVertex}));
  CHECK(broken_by([](auto& all) { all[1] = {0, 1, 2, 3}; }) == is({Rule::kDegenerateSimplex}));
  CHECK(broken_by([](auto& all) { all.push_back({6, 5, 3, 0}); }) == is({Rule::kDuplicateSimplex}));
  CHECK(broken_by([](auto& all) { all.push_back({0, 3, 5, 7}); }).contains(Rule::kFacetOverused));
  CHECK(broken_by([](auto& all) { all[0] = {3, 5, 6, 1}; }).contains(Rule::kOverlap));
  CHECK(broken_by([](auto& all) { std::swap(all[0][0], all[0][1]); }, {.oriented = true}) ==
        is({Rule::kOrientation}));
  CHECK(broken_by([](auto& all) { all.clear(); }).contains(Rule::kSegmentMissing));
}

TEST_CASE("facets of two simplices are not locally Delaunay, in walls and off them") {
  PiecewiseLinearInput input = generators::encircled_segment();
  const ExactMesh ring{PointSet(input.points), {{0, 1, 3, 4}, {1, 2, 3, 4}, {0, 2, 3, 4}}};
  REQUIRE(facts_of(Claim::kCdt, ring, domain_of(input)));
  CHECK(rules(Claim::kCdt, ring, domain_of(input)) == std::set{Rule::kConstrainedFacetNotLocal});
  CHECK(rules(Claim::kPlcTriangulation, ring, domain_of(input)).empty());
  for (Vertex v = 0; v < 3; ++v) input.polygons.push_back({{{v, 3, 4}}, {}});
  CHECK(rules(Claim::kCdt, ring, domain_of(input)).empty());
  CHECK(rules(Claim::kConformingDelaunay, ring, domain_of(input)).contains(Rule::kFacetNotLocal));
}

TEST_CASE("sheared grids fill their domains, but are not Delaunay") {
  const ExactMesh upright = grid({0, 1, 2, 3, 4}, {0, 1, 2}, {0, 1, 2, 3}, every_cell);
  for (const auto& [along_y, along_z] : {std::pair{0, 1}, {2, 0}, {1, -1}, {3, 5}}) {
    std::vector<Point> points = upright.points.points();
    for (Point& point : points) point[0] += along_y * point[1] + along_z * point[2];
    const ExactMesh mesh{PointSet(points), upright.simplices};
    const Domain domain = domain_of_facets(mesh, [](std::size_t uses) { return uses == 1; });
    const Claim claim = Claim::kConformingDelaunay;
    const auto known = facts_of(claim, mesh, domain);
    REQUIRE(known.has_value());
    const Mesh in_arrays = in_rows(mesh);
    const fast::MeshView<3, std::int32_t> view{
        std::get<Rows<double>>(in_arrays.coordinates).values(),
        {},
        in_arrays.simplices.rows<std::int32_t>()->values()};
    for (const std::size_t most : {0, 1, 7}) {
      const Options options{.max_violations = most};
      const auto verdict = not_conforming(view, {}, domain, *known, options);
      REQUIRE(verdict.has_value());
      const Verdict exactly = judge_exactly(claim, mesh, &domain, options);
      CHECK(text_of(*verdict) == text_of(exactly));
      CHECK(text_of(judged(claim, mesh, domain, options)) == text_of(exactly));
      CHECK(exactly.tallies().contains(Rule::kFacetNotLocal));
      CHECK(exactly.tallies().contains(Rule::kVertexInBall));
    }
  }
}

TEST_CASE("a room has vertices in the balls of another one, beyond the walls of both") {
  ExactMesh mesh = grid({0, 10}, {0, 10}, {0, 1}, every_cell);
  const ExactMesh other = grid({4, 6}, {4, 6}, {2, 3}, every_cell);
  std::vector<Point> points = mesh.points.points();
  const auto first = static_cast<Vertex>(points.size());
  for (const Point& point : other.points.points()) points.push_back(point);
  for (Simplex simplex : other.simplices) {
    for (Vertex& v : simplex) v += first;
    mesh.simplices.push_back(simplex);
  }
  mesh.points = PointSet(points);
  const Domain domain = domain_of_facets(mesh, [](std::size_t uses) { return uses == 1; });
  CHECK(rules(Claim::kSteinerCdt, mesh, domain).empty());
  CHECK(rules(Claim::kConformingDelaunay, mesh, domain) == std::set{Rule::kVertexInBall});
}

TEST_CASE("a facet of one simplex, off the walls") {
  const Domain cube = domain_of(generators::box(0, 2));
  const ExactMesh mesh = eight_cubes_with_a_gap();
  REQUIRE(facts_of(Claim::kSteinerCdt, mesh, cube));
  CHECK(rules(Claim::kSteinerCdt, mesh, cube) == std::set{Rule::kUncovered});
}

TEST_CASE("simplices that do not fill a convex hull") {
  PiecewiseLinearInput input;
  input.points = generators::box(0, 2).points;
  input.kind = DomainKind::kHull;
  const Domain hull = domain_of(input);
  CHECK(facts_of(Claim::kCdt, cube_with(kCubeInFive), hull)->fills_hull);
  ExactMesh fewer = cube_with(kCubeInFive);
  fewer.simplices.pop_back();
  CHECK(!facts_of(Claim::kCdt, fewer, hull)->fills_hull);
  CHECK(!rules(Claim::kCdt, fewer, hull).empty());
}

TEST_CASE("nothing is known by definition, nor of points that are not doubles") {
  const PiecewiseLinearInput box = generators::box(0, Rational(1) / 3);
  const ExactMesh thirds{PointSet(box.points), kCubeInFive};
  CHECK(!facts_of(Claim::kCdt, thirds, domain_of(box)));
  CHECK(rules(Claim::kCdt, thirds, domain_of(box)).empty());
  const Domain cube = domain_of(generators::box(0, 2));
  CHECK(!facts_of(Claim::kCdt, cube_with(kCubeInFive), cube, {.by = By::kDefinition}));
  const ExactMesh nothing{PointSet({}), {}};
  CHECK(!facts_of(Claim::kCdt, nothing, cube));
}

}  // namespace
}  // namespace circumspect::check
