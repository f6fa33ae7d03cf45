// C6: impossible stays impossible. Complexes without a triangulation or without a CDT: no
// construction finds one, and a replayed refutation proves that there is none. Book: Section 4.5,
// Figures 4.10, 4.12, 4.13 and 4.15, and Section 4.5.3 on Schönhardt's polyhedron.
#include <algorithm>
#include <map>
#include <string>

#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "kernel/piecewise_linear/visibility.hpp"
#include "properties/arguments/complexes.hpp"
#include "properties/arguments/generated.hpp"
#include "properties/arguments/run.hpp"
#include "reference/constrained/cdt_by_polygon_insertion.hpp"
#include "reference/constrained/edge_protection.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/existence/existence.hpp"

namespace circumspect::properties {
namespace {

using existence::Existence;
using existence::Exists;
using existence::Impossible;
using generators::ComplexCase;

bool has_cdt(const PiecewiseLinearComplex& complex) {
  const bool has = constrained::gift_wrapping_cdt(complex).has_value();
  for (const auto by :
       {constrained::PolygonInsertion::kFlips, constrained::PolygonInsertion::kCavities}) {
    // It may fail where there is a CDT, not find one where there is none.
    if (constrained::cdt_by_polygon_insertion(complex, {by, {}})) REQUIRE(has);
  }
  return has;
}

bool is_proved_impossible(const Existence& existence) {
  const auto* impossible = std::get_if<Impossible>(&existence);
  return impossible != nullptr &&
         existence::replay(impossible->formula, impossible->refutation).has_value();
}
bool has_no_triangulation(const PiecewiseLinearComplex& complex) {
  return is_proved_impossible(existence::any_triangulation(complex, Regions(complex)));
}
bool has_triangulation(const PiecewiseLinearComplex& complex) {
  return std::holds_alternative<Exists>(existence::any_triangulation(complex, Regions(complex)));
}
bool has_no_cdt_at_all(const PiecewiseLinearComplex& complex) {
  return is_proved_impossible(existence::any_cdt(complex, Regions(complex)));
}

// The two triangles 0 1 2 and 3 4 5 and six triangles between them, as Schönhardt's polyhedron has:
// an octahedron, whose three pairs of vertices that are not edges are its diagonals.
const Simplex kDiagonals[] = {{0, 5}, {1, 3}, {2, 4}};

// Of the four corners of any tetrahedron two are the ends of a diagonal. So a domain that contains
// no diagonal contains no tetrahedron of its vertices.
bool contains_no_diagonal(const PiecewiseLinearComplex& complex) {
  const Regions regions(complex);
  return std::none_of(std::begin(kDiagonals), std::end(kDiagonals), [&](const Simplex& diagonal) {
    return respects(complex, regions, diagonal);
  });
}

std::size_t edges_not_strongly_delaunay(const PiecewiseLinearComplex& complex) {
  return static_cast<std::size_t>(
      std::count_if(complex.segments.begin(), complex.segments.end(), [&](const Simplex& segment) {
        return !delaunay::is_strongly_delaunay(complex.points, segment);
      }));
}

Point turned(const Point& u, std::size_t thirds) {
  return {u[(3 - thirds) % 3], u[(4 - thirds) % 3], u[(5 - thirds) % 3]};
}

// Two orbits under the rotations about the line x = y = z, of a point u and of an image of −u.
PiecewiseLinearInput random_octahedron_on_sphere(long size) {
  const auto coordinate = generators::integer_number(size);
  const Point u = {*coordinate, *coordinate, *coordinate};
  const auto shift = static_cast<std::size_t>(*generators::below(3));
  PiecewiseLinearInput input = generators::schonhardt();
  for (std::size_t i = 0; i < 3; ++i) {
    input.points[i] = turned(u, i);
    input.points[3 + i] = turned({-u[1], -u[0], -u[2]}, (i + shift) % 3);
  }
  return input;
}

// Schönhardt's polyhedron and its kin, on a sphere or not, with corners moved.
rc::Gen<ComplexCase> octahedra() {
  return generators::shrinking(rc::gen::exec([] {
    ComplexCase made{"octahedron", generators::schonhardt()};
    const PiecewiseLinearInput on_sphere = random_octahedron_on_sphere(16);
    if (validated(on_sphere, 1)) made.input = on_sphere;
    for (std::size_t v = 0; v < 6; ++v) {
      PiecewiseLinearInput changed = made.input;
      for (Rational& x : changed.points[v]) x += *generators::integer_within(3);
      if (validated(changed, 1)) made.input = changed;
    }
    return made;
  }));
}

TEST_CASE("C6 Schönhardt's polyhedron and its kin: no diagonal, no triangulation (Figure 4.10)") {
  std::map<std::size_t, std::size_t> unprotected;
  std::size_t others = 0, possible = 0;
  CHECK(holds("octahedra", 200, [&] {
    const ComplexCase one = *octahedra();
    RC_PRE(one.input.points.size() == 6u && one.input.polygons.size() == 8u);
    const PiecewiseLinearComplex complex = one.complex();
    if (!contains_no_diagonal(complex)) {
      ++others;
      return;
    }
    RC_ASSERT(has_no_triangulation(complex));
    RC_ASSERT(has_no_cdt_at_all(complex));
    RC_ASSERT(!has_cdt(complex));
    // "It is not possible to place the vertices of Schönhardt's polyhedron so that all three of its
    // reflex edges are strongly Delaunay, though any two may be." The others are edges of the hull.
    const std::size_t count = edges_not_strongly_delaunay(complex);
    RC_ASSERT(count > 0u);
    ++unprotected[count];
    // A vertex inside from which all facets can be seen makes it possible.
    PiecewiseLinearInput with_centre = one.input;
    with_centre.points.push_back(barycentre(one.input.points));
    const auto centred = validated(with_centre);
    RC_ASSERT(centred.has_value());
    const Regions regions(*centred);
    std::vector<Simplex> cone;
    for (const Polygon& polygon : centred->polygons) cone.push_back(join(polygon.vertices, {6}));
    const bool is_star_shaped = std::all_of(cone.begin(), cone.end(), [&](const Simplex& simplex) {
      return respects(*centred, regions, simplex);
    });
    if (!is_star_shaped) return;
    ++possible;
    RC_ASSERT(has_triangulation(*centred));
  }));
  CHECK(occurs(others));
  CHECK(occurs(possible));
  for (const std::size_t count : {1u, 2u}) {
    CAPTURE(count);
    CHECK(occurs(unprotected[count]));
  }
}

TEST_CASE("C6 on a sphere all its edges are Delaunay, and it has no triangulation (4.5.3)") {
  std::size_t found = 0;
  CHECK(holds("octahedra on a sphere", 300, [&] {
    const PiecewiseLinearInput input = random_octahedron_on_sphere(9);
    const auto complex = validated(input, 1);
    if (!complex || !contains_no_diagonal(*complex)) return;
    ++found;
    for (const auto& protection : constrained::edge_protection(*complex)) {
      RC_ASSERT(protection.status.delaunayhood != delaunay::Delaunayhood::kNotDelaunay);
    }
    for (const Polygon& facet : complex->polygons) {
      RC_ASSERT(delaunay::is_delaunay(complex->points, Simplex(facet.vertices)));
    }
    RC_ASSERT(!constrained::is_edge_protected(*complex));
    RC_ASSERT(!constrained::is_edge_protected_under_perturbation(*complex));
    RC_ASSERT(has_no_triangulation(*complex));
    RC_ASSERT(!has_cdt(*complex));
  }));
  CHECK(occurs(found));
}

TEST_CASE("C6 a cube with three segments, possible with any one left out (Figure 4.12)") {
  const auto all = assemble(generators::cube_with_three_segments());
  CHECK(has_no_triangulation(all));
  CHECK(has_no_cdt_at_all(all));
  CHECK_FALSE(has_cdt(all));
  for (const int without : {0, 1, 2}) {
    CAPTURE(without);
    CHECK(has_triangulation(assemble(generators::cube_with_three_segments(without))));
  }
}

TEST_CASE("C6 a segment through two tetrahedra: a triangulation, no CDT (Figure 4.15)") {
  PiecewiseLinearInput input = generators::encircled_segment();
  const auto complex = assemble(input);
  CHECK(has_triangulation(complex));
  CHECK(has_no_cdt_at_all(complex));
  CHECK_FALSE(has_cdt(complex));
  PiecewiseLinearInput without = input;
  without.segments.clear();
  CHECK(has_cdt(assemble(without)));
  // "… has a Steiner CDT with one Steiner point on its central segment."
  const auto middle = static_cast<Vertex>(input.points.size());
  input.points.push_back({0, 0, 0});
  input.segments = {{3, middle}, {middle, 4}};
  const auto steiner = assemble(input);
  CHECK(constrained::is_edge_protected(steiner));
  CHECK(has_cdt(steiner));
}

TEST_CASE("C6 Chazelle's polyhedra with two notches or more a side (Figure 4.13)") {
  CHECK(has_cdt(assemble(generators::chazelle(1))));
  for (const int notches : {2, 3, 4}) {
    CAPTURE(notches);
    const auto complex = assemble(generators::chazelle(notches));
    CHECK(has_no_triangulation(complex));
    CHECK_FALSE(has_cdt(complex));
  }
}

// Two polyhedra side by side, one of them impossible; an impossible one in a larger domain.
TEST_CASE("C6 what contains an impossible polyhedron is impossible") {
  PiecewiseLinearInput far = generators::schonhardt();
  for (Point& corner : far.points) corner[0] += 100;
  CHECK(has_no_triangulation(assemble(generators::both(generators::schonhardt(), far))));
  const auto boxed = generators::both(generators::box(-40, 40), generators::schonhardt());
  CHECK(has_no_triangulation(assemble(boxed)));
  PiecewiseLinearInput hollow = boxed;
  hollow.hole_seeds = {{0, 0, 5}};
  CHECK(has_triangulation(assemble(hollow)));
}

}  // namespace
}  // namespace circumspect::properties
