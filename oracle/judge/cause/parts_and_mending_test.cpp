// Causes of meshes whose parts were meshed apart, beside other faults.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "oracle/judge/cause/planted_faults_test.hpp"

namespace circumspect::check {
namespace {

template <std::size_t kDimension>
void check_apart(std::size_t side) {
  Lists equal = grid<kDimension>(side);
  part(equal, 0);
  CHECK(named(equal, Claim::kComplex)
            .find(" equal another one, exactly: with --duplicates merge "
                  "the claim holds") != std::string::npos);
  Lists hanging = grid<kDimension>(side);
  hang_vertex(hanging, hanging.simplices.size() - 1);
  for (const Claim claim : {Claim::kTriangulation, Claim::kComplex}) {
    CAPTURE(name(claim));
    CHECK(named(hanging, claim).find("1 vertex lies inside faces of simplices that are not cut") !=
          std::string::npos);
  }
}

TEST_CASE("causes: equal points and hanging vertices") {
  check_apart<2>(7);
  check_apart<3>(6);
}

// The causes of stray faces, of a grid beside which all facets are listed: all but the first
// and the last few name vertices that come later by `shift`.
template <std::size_t kDimension>
std::vector<Cause> of_listed_facets(std::size_t few, Vertex shift) {
  const Lists lists = grid<kDimension>(4);
  Mesh mesh = in_arrays(lists);
  mesh.faces = faces_of(lists.simplices, kDimension);
  for (std::size_t i = few; i + few < mesh.faces.size(); ++i) {
    for (Vertex& v : mesh.faces[i]) v += shift;
  }
  const auto judged = [](const Mesh& one) -> std::optional<Verdict> {
    return judge(Claim::kComplex, one, nullptr, {.complex = {.faces = true}}).value();
  };
  return causes(*judged(mesh), mesh, judged).found;
}

TEST_CASE("causes: listed faces count from another number, or only some of them are stray") {
  for (const Vertex shift : {Vertex{1}, Vertex{-1}}) {
    for (const auto& found : {of_listed_facets<2>(0, shift), of_listed_facets<3>(0, shift)}) {
      REQUIRE(found.size() == 1);
      CHECK(found[0].name == "faces-begin-elsewhere");
      CHECK(found[0].explains == found[0].of);
      CHECK(found[0].words.find("begin at " + std::to_string(shift) + ", not at 0") !=
            std::string::npos);
    }
    CHECK(of_listed_facets<2>(2, shift).empty());
    CHECK(of_listed_facets<3>(2, shift).empty());
  }
}

TEST_CASE("causes: a mended mesh has the faces that are listed beside it") {
  Lists lists = grid<2>(4);
  lists.simplices.push_back(lists.simplices.front());
  Mesh mesh = in_arrays(lists);
  const auto judged = [](const Mesh& one) -> std::optional<Verdict> {
    return judge(Claim::kComplex, one, nullptr, {.complex = {.faces = true}}).value();
  };
  for (const bool is_stray : {false, true}) {
    mesh.faces = {is_stray ? Simplex{0, 15} : Simplex{0, 1}};
    const std::vector<Cause> found = causes(*judged(mesh), mesh, judged).found;
    REQUIRE(found.size() == 1);
    CHECK(found[0].name == "listed-twice");
    CHECK((found[0].words.find("the claim holds") == std::string::npos) == is_stray);
  }
}

// How much a cause explains, of how much.
std::pair<std::size_t, std::size_t> explained(const Lists& lists, Claim claim,
                                              const std::string& name) {
  for (const Cause& cause : causes_of(lists, claim)) {
    if (cause.name == name) return {cause.explains, cause.of};
  }
  return {0, 0};
}

TEST_CASE("causes: a fault elsewhere does not change how much a cause explains") {
  const Lists good = grid<2>(9);
  for (const Claim claim : {Claim::kTriangulation, Claim::kComplex}) {
    CAPTURE(name(claim));
    Lists hanging = good;
    hang_vertex(hanging, hanging.simplices.size() - 1);
    const auto alone = explained(hanging, claim, "hanging-vertices");
    CHECK(alone.first > 0);
    CHECK(alone.first == alone.second);
    // Beside a square that is not there, which leaves a hole of its own, or a triangle that is
    // listed twice.
    Lists both = hanging;
    if (claim == Claim::kComplex) {
      both.simplices.push_back(both.simplices.front());
    } else {
      std::erase_if(both.simplices, [&](const Simplex& simplex) {
        const Point middle = barycentre(both.corners(simplex));
        return middle[0] < 2 && middle[0] > 1 && middle[1] < 2 && middle[1] > 1;
      });
    }
    const auto beside = explained(both, claim, "hanging-vertices");
    CHECK(beside.first == alone.first);
    CHECK(beside.second > alone.second);
  }
}

TEST_CASE("causes: the mended mesh has the weights of the points") {
  // Without weights the other diagonal is right.
  Lists lists{{{0, 0}, {4, 0}, {5, 5}, {0, 4}}, {{1, 2, 3}, {1, 3, 4}}};
  for (const bool has_weights : {false, true}) {
    Mesh mesh = in_arrays(lists);
    const std::vector<Point> weights = {{has_weights ? 9 : 0}, {0}, {has_weights ? 9 : 0}, {0}};
    mesh.weights = numbers_of(weights, 1);
    const auto judged = [](const Mesh& one) -> std::optional<Verdict> {
      return judge(Claim::kWeightedDelaunay, one, nullptr, {}).value();
    };
    const auto found = causes(*judged(mesh), mesh, judged).found;
    const bool holds =
        !found.empty() && found[0].words.find("the claim holds") != std::string::npos;
    CHECK(holds == has_weights);
  }
}

TEST_CASE("causes: what is left when one is mended is counted and not explained") {
  Lists equal = grid<2>(7);
  part(equal, 0);
  equal.simplices.push_back(equal.simplices.front());
  CHECK(named(equal, Claim::kComplex).ends_with("count as one, and the rest remains in part"));
  Lists later = grid<2>(7);  // with two points that no simplex has
  later.points.insert(later.points.begin(), {{9, 9}, {10, 9}});
  for (Simplex& simplex : later.simplices) {
    for (Vertex& v : simplex) v += 3;
  }
  CHECK(named(later, Claim::kComplex)
            .ends_with("so read, all name points, and 2 violations are left in part"));
  const Cause cause = causes_of(later, Claim::kComplex).front();
  CHECK(cause.explains + 2 == cause.of);
}

// A square is not covered, and a triangle fits into a notch of the domain.
TEST_CASE("causes: what leaves something uncovered is not judged") {
  const PiecewiseLinearInput input{
      {{0, 0}, {8, 0}, {8, 8}, {4, 6}, {0, 8}}, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}}, {}, {}};
  const Domain domain{.complex = assemble(input)};
  Lists lists{input.points,
              {{0, 1, 5},
               {1, 6, 5},
               {1, 2, 7},
               {1, 7, 6},
               {2, 3, 7},
               {3, 8, 7},
               {3, 4, 8},
               {4, 0, 8},
               {0, 5, 8}}};
  for (const Point& corner : {Point{3, 2}, Point{5, 2}, Point{5, 4}, Point{3, 4}}) {
    lists.points.push_back(corner);
  }
  const Mesh mesh = in_arrays(lists);
  std::size_t asked = 0;
  const auto judged = [&](const Mesh& one) -> std::optional<Verdict> {
    ++asked;
    return judge(Claim::kSteinerTriangulation, one, &domain, {}).value();
  };
  const auto verdict = judged(mesh);
  CHECK(verdict->tallies().at(Rule::kUncovered).count == 4);
  CHECK(causes(*verdict, mesh, judged).found.empty());
  CHECK(asked == 1);
}

TEST_CASE("causes: beside a notch of the domain, a triangle is missing at a wall") {
  const PiecewiseLinearInput input{
      {{0, 0}, {8, 0}, {8, 8}, {4, 6}, {0, 8}}, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}}, {}, {}};
  const Domain domain{.complex = assemble(input)};
  Lists lists{input.points, {{1, 2, 5}, {2, 3, 5}, {3, 4, 5}, {4, 0, 5}}};
  lists.points.push_back({4, 3});
  const Mesh mesh = in_arrays(lists);
  const auto judged = [&](const Mesh& one) -> std::optional<Verdict> {
    return judge(Claim::kSteinerTriangulation, one, &domain, {}).value();
  };
  const auto found = causes(*judged(mesh), mesh, judged).found;
  REQUIRE(found.size() == 1);
  CHECK(found[0].words == "1 triangle is missing: 0 1 5 fills the hole");
}

TEST_CASE("causes: points that no simplex uses") {
  Lists arcs = grid<2>(7);
  arcs.points.push_back({9, 9});  // as the centre of an arc
  CHECK(
      named(arcs, Claim::kComplex) ==
      "unused-points: 1 point is in no triangle: --allow-unused lets it pass, and the claim holds");
  arcs.points.push_back({10, 9});
  CHECK(named(arcs, Claim::kComplex) ==
        "unused-points: 2 points are in no triangle: --allow-unused lets them pass, and the claim "
        "holds");
  CHECK(named(arcs, Claim::kTriangulation).find("--allow-unused") == std::string::npos);
  // Of a beam, the ends of which are in no triangle.
  Mesh with_beam = in_arrays(arcs);
  const auto said = [&](Simplex beam) {
    with_beam.faces = {{0, 1}, std::move(beam)};
    const Verdict verdict = judge(Claim::kComplex, with_beam, nullptr, {}).value();
    return causes(verdict, with_beam, [](const Mesh&) { return std::nullopt; }).found[0].words;
  };
  const auto end = static_cast<Vertex>(arcs.points.size());
  CHECK(said({end - 2, end - 1}).starts_with("2 points are in no triangle, but in listed faces: "));
  CHECK(said({0, end - 1}).starts_with("2 points are in no triangle: "));
  CHECK(said({end, end - 1}).starts_with("2 points are in no triangle: "));
  arcs.simplices.push_back(arcs.simplices.front());
  CHECK(explained(arcs, Claim::kComplex, "unused-points") == std::pair{2UL, 3UL});
  // If all that is unused is so since indices begin at 1, that is the cause.
  Lists later = grid<2>(7);
  for (Simplex& simplex : later.simplices) {
    for (Vertex& v : simplex) ++v;
  }
  CHECK(explained(later, Claim::kComplex, "unused-points").first == 0);
}

// Two squares of triangles in space, the second one turned into a plane across the first.
Lists two_sheets(const Rational& height) {
  const Lists square = grid<2>(4);
  Lists both;
  for (const Point& p : square.points) both.points.push_back({p[0], p[1], 0});
  for (const Point& p : square.points) {
    both.points.push_back({p[0] + Rational(1, 3), Rational(4, 3), p[1] + height});
  }
  both.simplices = square.simplices;
  for (Simplex simplex : square.simplices) {
    for (Vertex& v : simplex) v += std::ssize(square.points);
    both.simplices.push_back(std::move(simplex));
  }
  return both;
}

TEST_CASE("causes: parts that pass through each other") {
  CHECK(causes_of(two_sheets(1), Claim::kComplex).empty());
  Lists crossing = two_sheets(Rational(-4, 3));
  const std::string words =
      "parts-in-each-other: 2 parts that no facet connects pass through each other, and no part "
      "overlaps itself";
  CHECK(named(crossing, Claim::kComplex) == words);
  // A part that passes through itself is another matter.
  crossing.points[0] = {Rational(3, 2), Rational(3, 2), 0};
  CHECK(explained(crossing, Claim::kComplex, "parts-in-each-other").first == 0);
  Lists solids = grid<3>(3);
  const Lists one = solids;
  for (Point p : one.points) {
    for (Rational& x : p) x += Rational(1, 3);
    solids.points.push_back(std::move(p));
  }
  for (Simplex simplex : one.simplices) {
    for (Vertex& v : simplex) v += std::ssize(one.points);
    solids.simplices.push_back(std::move(simplex));
  }
  CHECK(named(solids, Claim::kComplex) ==
        "parts-in-each-other: 2 parts that no facet connects overlap each other, and no part "
        "overlaps itself");
}

TEST_CASE("causes: parts that were meshed apart") {
  // In the plane their vertices differ where they meet.
  Lists plane = grid<2>(7);
  part(plane, Rational(1, 4));
  // In space the diagonals do: the one half is the mirror image of what it was.
  Lists space = grid<3>(5);
  const long most = 4;
  for (Simplex& simplex : space.simplices) {
    if (barycentre(space.corners(simplex))[0] < 2) continue;
    for (Vertex& v : simplex) v += 5 * (most - 2 * (v / 5 % 5));
  }
  for (const Claim claim : {Claim::kTriangulation, Claim::kDelaunay, Claim::kComplex}) {
    CAPTURE(name(claim));
    CHECK(named(plane, claim).find("parts that were meshed apart meet: 10 vertices lie inside") !=
          std::string::npos);
    CHECK(named(space, claim)
              .find("parts that were meshed apart meet in 16 quadrilaterals with different "
                    "diagonals") != std::string::npos);
  }
}

}  // namespace
}  // namespace circumspect::check
