// Complexes that have a triangulation, or a CDT, and those that have none. Book: Sections 4.5, 5.6
// and 5.9.
#include "reference/existence/existence.hpp"

#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"
#include "reference/existence/refutation.hpp"

namespace circumspect::existence {
namespace {

Existence triangulation_of(const PiecewiseLinearInput& input) {
  const auto complex = assemble(input);
  return any_triangulation(complex, Regions(complex));
}

Existence cdt_of(const PiecewiseLinearInput& input) {
  const auto complex = assemble(input);
  return any_cdt(complex, Regions(complex));
}

bool is_impossible(const Existence& existence) {
  const auto* impossible = std::get_if<Impossible>(&existence);
  return impossible != nullptr && replay(impossible->formula, impossible->refutation).has_value();
}

std::size_t tetrahedra(const Existence& existence) {
  const auto* exists = std::get_if<Exists>(&existence);
  return exists == nullptr ? 0 : exists->tetrahedra.size();
}

// Book: Figure 4.10.
TEST_CASE("existence: Schönhardt's polyhedron has no triangulation; with a vertex inside it has") {
  CHECK(is_impossible(triangulation_of(generators::schonhardt())));
  auto with_centre = generators::schonhardt();
  with_centre.points.push_back({0, 0, 5});
  CHECK(tetrahedra(triangulation_of(with_centre)) == 8);
}

// Book: Figure 4.12. It is impossible because the segments pass each other closely: at twice the
// distance there is a triangulation.
TEST_CASE("existence: a cube with three segments has no triangulation, with two it has") {
  auto loose = generators::cube_with_three_segments();
  for (std::size_t v = 8; v < loose.points.size(); ++v) {
    for (Rational& x : loose.points[v]) x = x == 0 || x == 4 ? x : 2 * x - 2;
  }
  CHECK(tetrahedra(triangulation_of(loose)) > 0);
  CHECK(is_impossible(triangulation_of(generators::cube_with_three_segments())));
  for (const int without : {0, 1, 2}) {
    CAPTURE(without);
    CHECK(tetrahedra(triangulation_of(generators::cube_with_three_segments(without))) > 0);
  }
}

// Book: Figure 4.15.
TEST_CASE("existence: an encircled segment has one triangulation, which is no CDT") {
  const auto only = triangulation_of(generators::encircled_segment());
  REQUIRE(std::holds_alternative<Exists>(only));
  CHECK(std::get<Exists>(only).tetrahedra ==
        std::vector<Simplex>{{0, 1, 3, 4}, {0, 2, 3, 4}, {1, 2, 3, 4}});
  CHECK(is_impossible(cdt_of(generators::encircled_segment())));
  auto without = generators::encircled_segment();
  without.segments.clear();
  CHECK(tetrahedra(cdt_of(without)) == 2);
}

// Book: Exercise 5 of Chapter 5.
TEST_CASE("existence: a complex with a CDT, and none once a polygon has been inserted") {
  CHECK(tetrahedra(cdt_of(generators::prism_on_a_sphere(false))) == 7);
  CHECK(is_impossible(triangulation_of(generators::prism_on_a_sphere(true))));
}

TEST_CASE("existence: a cube, hollow or with a cube inside, and as a hull") {
  CHECK(tetrahedra(cdt_of(generators::box(0, 1))) >= 5);
  auto boxes = generators::both(generators::box(0, 9), generators::box(3, 6));
  const std::size_t solid = tetrahedra(triangulation_of(boxes));
  boxes.hole_seeds = {{4, 4, 4}};
  const std::size_t hollow = tetrahedra(triangulation_of(boxes));
  CHECK(hollow > 5);
  CHECK(solid >= hollow);
  PiecewiseLinearInput hull = generators::schonhardt();
  hull.kind = DomainKind::kHull;
  CHECK(is_impossible(triangulation_of(hull)));
  hull.polygons.clear();
  CHECK(tetrahedra(triangulation_of(hull)) > 0);
}

// Book: Figure 4.13. One notch above and one below still leave room.
TEST_CASE("existence: Chazelle's polyhedron") {
  CHECK(tetrahedra(cdt_of(generators::chazelle(1))) > 0);
  CHECK(is_impossible(triangulation_of(generators::chazelle(2))));
}

// Two roofs over one square, one above and one below it. The edge that the other diagonal of the
// square would need leaves the room, so that each room has a triangulation with one of them alone.
TEST_CASE("existence: two rooms that need different diagonals of the square between them") {
  const std::vector<std::vector<Vertex>> square = {{0, 1, 2, 3}};
  const std::vector<std::vector<Vertex>> above = {{0, 1, 4}, {1, 2, 4}, {2, 3, 5},
                                                  {0, 3, 5}, {0, 4, 5}, {2, 4, 5}};
  const std::vector<std::vector<Vertex>> below = {{1, 2, 6}, {2, 3, 6}, {0, 3, 7},
                                                  {0, 1, 7}, {1, 6, 7}, {3, 6, 7}};
  const std::vector<std::vector<Vertex>> other_diagonal = {{0, 1, 3}, {1, 2, 3}};
  const auto made_of = [](std::initializer_list<std::vector<std::vector<Vertex>>> walls,
                          bool has_room_below) {
    PiecewiseLinearInput input;
    input.points = {{-1, 0, 0}, {0, -1, 0}, {1, 0, 0}, {0, 1, 0}, {2, -1, 1}, {-2, 1, 1}};
    if (has_room_below) {
      input.points.push_back({1, 2, -1});
      input.points.push_back({-1, -2, -1});
    }
    for (const auto& polygons : walls) {
      for (const auto& polygon : polygons) input.polygons.push_back({{polygon}, {}});
    }
    return triangulation_of(input);
  };
  CHECK(tetrahedra(made_of({above, square}, false)) == 3);
  CHECK(is_impossible(made_of({above, other_diagonal}, false)));
  CHECK(is_impossible(made_of({above, square, below}, true)));
}

TEST_CASE("existence: a limit is an answer, not a guess") {
  const auto complex = assemble(generators::box(0, 1));
  CHECK(std::holds_alternative<Unknown>(any_triangulation(complex, Regions(complex), {7, 0})));
  CHECK(std::holds_alternative<Unknown>(any_cdt(complex, Regions(complex), {60, 0, 10})));
}

}  // namespace
}  // namespace circumspect::existence
