// The two ways to judge a claim about a domain are one: by lemma and by definition, on CDTs, on
// other triangulations, on finer ones and on broken meshes; and what the fast judge knows of a mesh
// changes no word of the verdict. Book: Definitions 4.4 to 4.7, Lemma 4.10.
#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include <doctest/doctest.h>

#include "kernel/exact/point.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "oracle/judge/judge.hpp"
#include "oracle/judge/witness_text_test.hpp"
#include "properties/arguments/complexes.hpp"
#include "properties/arguments/generated.hpp"
#include "properties/arguments/run.hpp"
#include "properties/constrained_delaunay.hpp"
#include "properties/mutations/mutations.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/constrained/planar_cdt.hpp"
#include "reference/constrained/plc_triangulation.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/existence/matching.hpp"
#include "reference/optimality/criteria.hpp"

namespace circumspect::properties {
namespace {

using constrained::PlcTriangulation;
using generators::ComplexCase;

constexpr Claim kClaims[] = {Claim::kPlcTriangulation, Claim::kSteinerTriangulation, Claim::kCdt,
                             Claim::kSteinerCdt, Claim::kConformingDelaunay};

// How often the fast judge knew something of a mesh that it was asked about.
std::size_t known = 0;

// How many simplices and listed faces are wrong by themselves, rule by rule.
std::map<Rule, std::size_t> wrong_alone(const Verdict& verdict) {
  std::map<Rule, std::size_t> counts;
  for (const auto& [rule, tally] : verdict.tallies()) {
    if (stage(rule) == Stage::kSimplices) counts[rule] = tally.count;
  }
  return counts;
}

// The vertices that are not the domain's, and how many of them are in cells of each dimension.
std::vector<std::size_t> beyond_domain(const Verdict& verdict) {
  const auto& [count, first] = *verdict.extra_vertices;
  const auto& [on_segments, in_polygons, in_polyhedra] = *verdict.steiner_points;
  std::vector<std::size_t> all = {count, on_segments, in_polygons, in_polyhedra};
  for (const Vertex v : first) all.push_back(static_cast<std::size_t>(v));
  return all;
}

// The common answers of both ways.
std::map<Claim, bool> judged(const ExactMesh& mesh, const PiecewiseLinearComplex& complex) {
  const Domain domain{complex};
  std::map<Claim, bool> answers;
  for (const Claim claim : kClaims) {
    const Verdict verdict = check::judge_exactly(claim, mesh, &domain, {.by = check::By::kLemma});
    const Verdict quick = check::judge(claim, in_rows(mesh), &domain, {.threads = 1}).value();
    RC_ASSERT(check::text_of(quick, mesh) == check::text_of(verdict, mesh));
    known += quick.course.fast ? 1U : 0U;
    const bool by_lemma = verdict.holds();
    const Verdict defined =
        check::judge_exactly(claim, mesh, &domain, {.by = check::By::kDefinition});
    const bool by_definition = defined.holds();
    RC_ASSERT(wrong_alone(verdict) == wrong_alone(defined));
    if (by_lemma && by_definition) {
      RC_ASSERT(quick.dangling == defined.dangling);
      RC_ASSERT(verdict.dangling == defined.dangling);
      RC_ASSERT(beyond_domain(verdict) == beyond_domain(defined));
    }
    RC_LOG() << name(claim) << " by lemma: " << by_lemma << ", by definition: " << by_definition
             << "\n";
    RC_ASSERT(by_lemma == by_definition);
    answers[claim] = by_lemma;
  }
  // A claim is never easier to meet than one that it contains.
  RC_ASSERT(answers[Claim::kPlcTriangulation] || !answers[Claim::kCdt]);
  RC_ASSERT(answers[Claim::kSteinerTriangulation] || !answers[Claim::kPlcTriangulation]);
  RC_ASSERT(answers[Claim::kSteinerTriangulation] || !answers[Claim::kSteinerCdt]);
  RC_ASSERT(answers[Claim::kSteinerTriangulation] || !answers[Claim::kConformingDelaunay]);
  RC_ASSERT(answers[Claim::kSteinerCdt] || !answers[Claim::kCdt]);
  return answers;
}

ExactMesh mesh_of(const PointSet& points, const PlcTriangulation& triangulation) {
  ExactMesh mesh{points, triangulation.simplices};
  for (const Simplex& simplex : triangulation.dangling) {
    if (simplex.size() > 1) mesh.faces.push_back(simplex);
  }
  return mesh;
}

void print(const ExactMesh& mesh) {
  for (const auto* simplices : {&mesh.simplices, &mesh.faces}) {
    for (const Simplex& simplex : *simplices) {
      for (const Vertex v : simplex) RC_LOG() << v << " ";
      RC_LOG() << "\n";
    }
  }
}

// In the plane or in space.
ComplexCase any_domain() {
  return *rc::gen::oneOf(any_protected_complex(9), generators::any_complex(8),
                         generators::planar_complexes(9));
}

// The canonical CDT of the complex if it has one.
std::optional<PlcTriangulation> cdt_of(const PiecewiseLinearComplex& complex) {
  if (complex.ambient_dimension() == 2) return constrained::planar_cdt(complex);
  auto cdt = constrained::gift_wrapping_cdt(complex);
  if (!cdt) return std::nullopt;
  return *std::move(cdt);
}

TEST_CASE("C2 CDTs pass by lemma and by definition; all but some faces or simplices do not") {
  std::size_t broken = 0;
  CHECK(holds("every corruption is rejected", 100, [&] {
    const ComplexCase one = any_domain();
    const PiecewiseLinearComplex complex = one.complex();
    const auto cdt = cdt_of(complex);
    if (!cdt) return;
    ExactMesh mesh = mesh_of(complex.points, *cdt);
    print(mesh);
    const auto answers = judged(mesh, complex);
    RC_ASSERT(answers.at(Claim::kCdt));
    if (!mesh.faces.empty()) {
      ExactMesh without = mesh;
      without.faces.erase(without.faces.begin() +
                          *generators::below(static_cast<long>(mesh.faces.size())));
      RC_ASSERT_FALSE(judged(without, complex).at(Claim::kSteinerTriangulation));
    }
    if (mesh.simplices.empty()) return;
    const Mutant mutant = *corruption(mesh.simplices, complex.points.size());
    if (mutant.simplices == mesh.simplices) return;  // of a point merged that is isolated
    mesh.simplices = mutant.simplices;
    RC_ASSERT_FALSE(judged(mesh, complex).at(Claim::kSteinerTriangulation));
    ++broken;
  }));
  CHECK(occurs(broken));
  CHECK(occurs(known, 100));
}

TEST_CASE("C1 lemma and definition agree on altered CDTs") {
  std::map<Claim, std::size_t> hold;
  CHECK(holds("both ways agree", 100, [&] {
    const ComplexCase one = any_domain();
    const PiecewiseLinearComplex complex = one.complex();
    const auto cdt = cdt_of(complex);
    if (!cdt || cdt->simplices.empty()) return;
    ExactMesh mesh = mesh_of(complex.points, *cdt);
    mesh.simplices = (*alteration(mesh.simplices, complex.points.size())).simplices;
    print(mesh);
    for (const auto& [claim, answer] : judged(mesh, complex)) hold[claim] += answer ? 1u : 0u;
  }));
  CHECK(occurs(hold[Claim::kPlcTriangulation]));
}

// Three points of space on a line: the first such after any place in the list, or none.
std::optional<Simplex> any_flat_face(const ExactMesh& mesh) {
  const auto points = static_cast<Vertex>(mesh.points.size());
  if (mesh.points.ambient_dimension() < 3 || points < 3) return std::nullopt;
  const Vertex first = *generators::below(points);
  for (Vertex i = 0; i < points; ++i) {
    for (Vertex j = i + 1; j < points; ++j) {
      for (Vertex k = j + 1; k < points; ++k) {
        const Simplex face = {(first + i) % points, (first + j) % points, (first + k) % points};
        if (affine_hull(coordinates(mesh.points, face)).dimension < 2) return face;
      }
    }
  }
  return std::nullopt;
}

// A face of a simplex, or any vertices of the mesh: flat, twice the same, or of no point at all.
Simplex any_face(const ExactMesh& mesh) {
  const auto d = static_cast<long>(mesh.points.ambient_dimension());
  const auto points = static_cast<long>(mesh.points.size());
  Simplex face;
  if (*generators::below(4) == 0) {
    if (const auto flat = any_flat_face(mesh)) return *flat;
  }
  if (!mesh.simplices.empty() && *generators::below(2) == 0) {
    const auto s = *generators::below(static_cast<long>(mesh.simplices.size()));
    face = mesh.simplices[static_cast<std::size_t>(s)];
    while (static_cast<long>(face.size()) > d || (face.size() > 2 && *generators::below(3) == 0)) {
      face.erase(face.begin() + *generators::below(static_cast<long>(face.size())));
    }
    return face;
  }
  for (long size = 2 + *generators::below(d - 1); size > 0; --size) {
    face.push_back(*generators::below(40) == 0 ? points : *generators::below(points));
  }
  return face;
}

TEST_CASE("C1 lemma and definition agree on CDTs that list any faces besides") {
  std::map<Claim, std::size_t> hold;
  std::size_t fail = 0;
  CHECK(holds("both ways agree", 200, [&] {
    const ComplexCase one = any_domain();
    const PiecewiseLinearComplex complex = one.complex();
    const auto cdt = cdt_of(complex);
    if (!cdt || cdt->simplices.empty()) return;
    ExactMesh mesh = mesh_of(complex.points, *cdt);
    for (long more = 1 + *generators::below(2); more > 0; --more) {
      mesh.faces.push_back(any_face(mesh));
    }
    print(mesh);
    for (const auto& [claim, answer] : judged(mesh, complex)) ++(answer ? hold[claim] : fail);
  }));
  CHECK(occurs(hold[Claim::kCdt]));
  CHECK(occurs(fail));
}

// The triangles, segments and vertices of the triangulation that lie in cells of lower dimension.
std::set<Simplex> faces_in_cells(const PiecewiseLinearComplex& complex, const Regions& regions,
                                 const PlcTriangulation& triangulation) {
  std::set<Simplex> faces(complex.segments.begin(), complex.segments.end());
  faces.insert(triangulation.dangling.begin(), triangulation.dangling.end());
  for (const Simplex& facet : facets_of(triangulation.simplices)) {
    const Point centre = barycentre(complex.points, facet);
    if (regions.locate(centre) == Where::kOnWall) faces.insert(facet);
  }
  return faces;
}

TEST_CASE("C2 a polyhedron left empty, or a hole filled, is not a triangulation of the domain") {
  std::size_t left_empty = 0, filled = 0;
  CHECK(holds("regions", 100, [&] {
    const ComplexCase one = any_domain();
    const PiecewiseLinearComplex complex = one.complex();
    const Regions regions(complex);
    const auto cdt = cdt_of(complex);
    if (!cdt || cdt->simplices.empty()) return;
    const Simplex& any = cdt->simplices[static_cast<std::size_t>(
        *generators::below(static_cast<long>(cdt->simplices.size())))];
    const auto region_of = [&](const Simplex& simplex) {
      return regions.region_at(barycentre(complex.points, simplex));
    };
    std::vector<Simplex> others = cdt->simplices;
    std::erase_if(others,
                  [&](const Simplex& simplex) { return region_of(simplex) == region_of(any); });
    const auto faces = faces_in_cells(complex, regions, *cdt);
    const ExactMesh mesh =
        mesh_of(complex.points, constrained::with_dangling(std::move(others), faces));
    print(mesh);
    RC_ASSERT_FALSE(judged(mesh, complex).at(Claim::kSteinerTriangulation));
    ++left_empty;
    bool has_hole = false;
    for (std::size_t r = 0; r < regions.size(); ++r) {
      has_hole = has_hole || regions.where(r) == Where::kHole;
    }
    if (!has_hole) return;
    PiecewiseLinearComplex without_holes = complex;
    without_holes.hole_seeds.clear();
    const auto full = cdt_of(without_holes);
    if (!full) return;
    RC_ASSERT_FALSE(
        judged(mesh_of(complex.points, *full), complex).at(Claim::kSteinerTriangulation));
    ++filled;
  }));
  CHECK(occurs(left_empty));
  CHECK(occurs(filled));
}

// The dangling triangles of the polygons cut in another way.
std::vector<Simplex> recut(const PiecewiseLinearComplex& complex, std::vector<Simplex> dangling) {
  for (const Polygon& polygon : complex.polygons) {
    const std::size_t before = dangling.size();
    std::erase_if(dangling, [&](const Simplex& simplex) {
      return simplex.size() == 3 && is_included(complex.points, simplex, polygon);
    });
    if (dangling.size() == before) continue;
    for (Simplex& triangle : any_triangulation_of(complex.points, polygon)) {
      dangling.push_back(std::move(triangle));
    }
  }
  return dangling;
}

TEST_CASE("C1 lemma and definition agree on dangling polygons however they are cut") {
  std::size_t cdts = 0, others = 0;
  CHECK(holds("both ways agree", 250, [&] {
    const ComplexCase one = *generators::flat_cells(10);
    const PiecewiseLinearComplex complex = one.complex();
    RC_PRE(complex.kind == DomainKind::kEnclosed);
    const auto cdt = cdt_of(complex);
    if (!cdt) return;
    ExactMesh mesh = mesh_of(complex.points, *cdt);
    mesh.faces = recut(complex, mesh.faces);
    print(mesh);
    const auto answers = judged(mesh, complex);
    ++(answers.at(Claim::kCdt) ? cdts : others);
  }));
  CHECK(occurs(cdts));
  CHECK(occurs(others));
}

TEST_CASE("C1 lemma and definition agree on any triangulation of a complex in space") {
  std::map<Claim, std::size_t> hold;
  std::size_t others = 0;
  CHECK(holds("both ways agree", 100, [&] {
    const ComplexCase one = *rc::gen::oneOf(any_protected_complex(8), generators::any_complex(7));
    const PiecewiseLinearComplex complex = one.complex();
    const auto cdt = cdt_of(complex);
    if (!cdt || cdt->simplices.empty()) return;
    const Regions regions(complex);
    const auto candidates = existence::respecting_tetrahedra(complex, regions);
    for (const auto& tetrahedra : plc_triangulations(complex, regions, candidates, 5)) {
      // What dangles is the same in each, but for the way a polygon is cut.
      const ExactMesh mesh = mesh_of(complex.points, {tetrahedra, cdt->dangling});
      print(mesh);
      const auto answers = judged(mesh, complex);
      RC_ASSERT(answers.at(Claim::kPlcTriangulation));
      ++(answers.at(Claim::kCdt) ? hold[Claim::kCdt] : others);
    }
  }));
  CHECK(occurs(hold[Claim::kCdt]));
  CHECK(occurs(others));
}

// Fewer cells, and without some of the points that no cell uses and that are not extreme: then a
// triangulation of the finer complex is one of the coarser with Steiner points. (Of the hull kind.)
PiecewiseLinearInput coarser(PiecewiseLinearInput input) {
  const auto by_chance = [](const auto&) { return *generators::below(2) == 0; };
  std::erase_if(input.segments, by_chance);
  std::erase_if(input.polygons, by_chance);
  for (std::size_t v = input.points.size(); v > 0 && input.points.size() > 4; --v) {
    if (generators::is_used(input)[v - 1] || *generators::below(4) == 0) continue;
    std::vector<Point> others = input.points;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(v - 1));
    const PointSet points(others);
    if (points.dimension() < 3) continue;
    const Triangulation hull = delaunay::bowyer_watson(points);
    if (!optimality::lifted_height(points, hull, input.points[v - 1])) continue;
    std::vector<bool> dropped(input.points.size());
    dropped[v - 1] = true;
    generators::drop_points(input, dropped);
  }
  return input;
}

TEST_CASE("C1 lemma and definition agree on triangulations of a finer complex") {
  std::map<Claim, std::size_t> hold;
  std::size_t steiner_points = 0;
  CHECK(holds("both ways agree", 200, [&] {
    const ComplexCase fine = *rc::gen::oneOf(any_protected_complex(9), generators::any_complex(8));
    const PiecewiseLinearComplex complex = fine.complex();
    const auto cdt = cdt_of(complex);
    if (!cdt || complex.kind != DomainKind::kHull) return;
    const auto coarse = validated(coarser(fine.input));
    const ExactMesh mesh = mesh_of(complex.points, *cdt);
    RC_ASSERT(coarse.has_value());
    steiner_points += complex.points.size() - coarse->points.size();
    print(mesh);
    for (const auto& [claim, answer] : judged(mesh, *coarse)) hold[claim] += answer ? 1u : 0u;
  }));
  CHECK(occurs(hold[Claim::kSteinerTriangulation]));
  CHECK(occurs(hold[Claim::kSteinerCdt]));
  CHECK(occurs(steiner_points));
}

}  // namespace
}  // namespace circumspect::properties
