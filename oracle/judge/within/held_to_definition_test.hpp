// For tests: compares the search for the least reach with the definition, and the verdict with the
// planted fault.
#pragma once

#include <set>
#include <string>

#include <doctest/doctest.h>

#include "kernel/complex/polytope.hpp"
#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "kernel/predicates/orientation.hpp"
#include "oracle/judge/domain/vertex_places.hpp"
#include "oracle/judge/within/hull_faces.hpp"
#include "oracle/judge/within/hull_walls.hpp"
#include "oracle/judge/within/moved_meshes_test.hpp"
#include "oracle/judge/within/reach_by_definition.hpp"
#include "oracle/judge/within/reach_search.hpp"
#include "oracle/judge/within/without_image.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::check {

using Random = std::mt19937_64;
enum class Fault { kNone, kDeleted, kFarVertex, kMerged, kExchanged, kRepeated };

inline ExactMesh broken_mesh(const Sheet& sheet, Fault fault, Random& random) {
  ExactMesh mesh = sheet.moved.mesh;
  std::vector<Simplex>& list = mesh.simplices.empty() ? mesh.faces : mesh.simplices;
  const auto any = [&](std::size_t size) { return static_cast<std::size_t>(random() % size); };
  std::vector<Point> points = mesh.points.points();
  switch (fault) {
    case Fault::kNone:
      break;
    case Fault::kDeleted:
      list.erase(list.begin() + static_cast<std::ptrdiff_t>(any(list.size())));
      break;
    case Fault::kFarVertex:
      points[any(points.size())][0] += Rational(1, 7);
      mesh = with_points(mesh, points);
      break;
    case Fault::kMerged: {  // another vertex for one of a simplex: overlaps, or flat
      Simplex& simplex = list[any(list.size())];
      simplex[any(simplex.size())] = static_cast<Vertex>(any(points.size()));
      break;
    }
    case Fault::kExchanged: {
      const std::size_t a = any(points.size()), b = any(points.size());
      if (a != b) std::swap(points[a], points[b]);
      mesh = with_points(mesh, points);
      break;
    }
    case Fault::kRepeated:
      list.push_back(sheet.stray ? *sheet.stray : list[any(list.size())]);
      break;
  }
  return mesh;
}

// A listed triangle on an edge of another, with a new vertex a few bits off a point of that one's.
inline void add_stray_triangle(ExactMesh& mesh, Random& random) {
  const auto any = [&](std::size_t size) { return static_cast<std::size_t>(random() % size); };
  const std::vector<Simplex>& list = mesh.faces.empty() ? mesh.simplices : mesh.faces;
  const Simplex& beside = list[any(list.size())];
  std::vector<Point> points = mesh.points.points();
  Point near = Rational(1, 3) * (points[static_cast<std::size_t>(beside[0])] +
                                 points[static_cast<std::size_t>(beside[1])] +
                                 points[static_cast<std::size_t>(beside[2])]);
  for (Rational& x : near) x += kBit * Rational(static_cast<long>(random() % 81) - 40);
  points.push_back(near);
  const std::size_t without = any(3);
  Simplex stray = {static_cast<Vertex>(points.size()) - 1};
  for (std::size_t i = 0; i < 3; ++i) {
    if (i != without) stray.push_back(beside[i]);
  }
  std::vector<Simplex> faces = mesh.faces;
  faces.push_back(sorted(stray));
  mesh = with_points(mesh, points);
  mesh.faces = std::move(faces);
}

inline bool is_sound(const ExactMesh& mesh) {
  const auto is_flat_or_less = [&](const Simplex& face) {
    return has_repeated_vertex(face) ||
           affine_hull(coordinates(mesh.points, face)).dimension + 1 < std::ssize(face);
  };
  if (std::any_of(mesh.faces.begin(), mesh.faces.end(), is_flat_or_less)) return false;
  return std::all_of(mesh.simplices.begin(), mesh.simplices.end(), [&](const Simplex& simplex) {
    return !has_repeated_vertex(simplex) &&
           orientation(mesh.points.configuration(), mesh.points.configuration().axes(), simplex) !=
               0;
  });
}

inline std::string text_of_images(const ImageSet& set) {
  std::string text;
  const auto add = [&](const Simplex& s) {
    for (const Vertex v : s) text += std::to_string(v) + " ";
    text += "\n";
  };
  add(set.vertices);
  for (const auto& path : set.paths) add(path);
  for (const Patch& patch : set.patches) {
    std::set<Simplex> triangles;
    for (const Simplex& t : patch.triangles) triangles.insert(sorted(t));
    for (const Simplex& t : triangles) add(t);
    text += "\n";
  }
  return text;
}

// Of all triangles of the mesh, of most, or of none.
inline Markers random_markers(const ExactMesh& mesh, const PiecewiseLinearComplex& complex,
                              Random& random) {
  Markers markers;
  if (complex.ambient_dimension() == 2 || random() % 2 == 0) return markers;
  for (std::size_t p = 0; p < complex.polygons.size(); ++p) {
    markers.of_polygons.push_back(static_cast<Vertex>(random() % 3));
  }
  const auto mark = [&](const Simplex& triangle) {
    if (random() % 8 > 0) markers.of_triangles[sorted(triangle)] = 1;
  };
  for (const Simplex& face : mesh.faces) mark(face);
  for (const Simplex& simplex : mesh.simplices) {
    for (std::size_t i = 0; i < simplex.size(); ++i) mark(facet_opposite(simplex, i));
  }
  return markers;
}

struct Counts {
  int found = 0, moved = 0, holds = 0, none = 0, lacking = 0, not_judged = 0;
};

// How often each rule is broken is the same however many witnesses are kept.
inline void count_the_same(const Verdict& all, const ExactMesh& mesh, const Domain& domain,
                           const Markers& markers) {
  const auto few = judge_within(all.claim(), mesh, domain, kSquaredLimit, {.max_violations = 1},
                                nullptr, nullptr, markers);
  REQUIRE(few);
  REQUIRE(few->tallies().size() == all.tallies().size());
  for (const auto& tally : all.tallies()) {
    CAPTURE(identifier(tally.first));
    CHECK(few->tallies().at(tally.first).count == tally.second.count);
  }
}

// The same is said whether anything is known of the simplices or not.
inline void hold_with_known_facts(const tl::expected<Verdict, NotJudged>& verdict,
                                  const ExactMesh& mesh, const Domain& domain,
                                  const Markers& markers) {
  constexpr Claim claim = Claim::kSteinerTriangulation;
  const auto facts = exact_facts(claim, mesh, domain);
  if (!facts) return;
  const auto with = judge_within(claim, mesh, domain, kSquaredLimit, {.max_violations = 0},
                                 {&*facts}, nullptr, markers);
  CHECK(with.has_value() == verdict.has_value());
  if (with && verdict) CHECK(text_of(*with) == text_of(*verdict));
}

// A lone vertex in a hole, of the domain and of the mesh, changes nothing.
inline void hold_with_lone_vertex(const Verdict& verdict, const ExactMesh& mesh, Domain domain) {
  if (domain.complex.hole_seeds.empty()) return;
  const Point at = Rational(1, 3) * Point{1, 1} + domain.complex.hole_seeds.front();
  std::vector<Point> of_domain = domain.complex.points.points(), of_mesh = mesh.points.points();
  of_domain.push_back(at);
  of_mesh.push_back(at);
  domain.complex.points = PointSet(of_domain);
  const auto with =
      judge_within(verdict.claim(), with_points(mesh, of_mesh), domain, kSquaredLimit);
  REQUIRE(with);
  CHECK(with->holds() == verdict.holds());
}

// No cell is certainly without an image if all have one.
inline void hold_lacking(const ExactMesh& mesh, const PiecewiseLinearComplex& complex, bool found,
                         Counts& counts) {
  const Mesh rows = in_rows(mesh);
  const WithoutImage without(rows, complex, kSquaredLimit);
  const std::vector<LinearCell> cells = linear_cells(complex);
  const bool lacks = std::any_of(cells.begin(), cells.end(),
                                 [&](LinearCell cell) { return without.certainly(cell); });
  if (lacks) ++counts.lacking;
  CHECK(!(lacks && found));
}

// Of simplices and faces that are at fault by themselves it is said what is said at no distance.
inline void hold_exactly(const ExactMesh& mesh, const Domain& domain) {
  constexpr Claim claim = Claim::kSteinerTriangulation;
  const Options all{.max_violations = 0};
  const auto within = judge_within(claim, mesh, domain, kSquaredLimit, all);
  REQUIRE(within);
  CHECK(!within->holds());
  CHECK(text_of(*within) == text_of(judge_exactly(claim, mesh, &domain, all)));
}

// One random case; what came out is counted.
inline void hold_equal(unsigned long seed, std::size_t dimension, Counts& counts) {
  Random random(seed);
  const bool is_sheet = dimension == 3 && random() % 2 == 0;
  Sheet sheet = is_sheet ? random_sheet(random) : Sheet{random_mesh(random, dimension)};
  MovedMesh& moved = sheet.moved;
  moved.mesh = shaken(moved.mesh, random, 1 + static_cast<long>(random() % 4));
  const auto fault = static_cast<Fault>(random() % 7 == 6 ? 0 : random() % 6);
  ExactMesh mesh = broken_mesh(sheet, fault, random);
  const bool has_stray = random() % 4 == 0 && dimension == 3;
  if (has_stray) add_stray_triangle(mesh, random);
  const std::string which =
      "seed " + std::to_string(seed) + " fault " + std::to_string(static_cast<int>(fault));
  INFO(which);
  if (!is_sound(mesh)) return hold_exactly(mesh, moved.domain);
  PiecewiseLinearComplex complex = moved.domain.complex;
  if (complex.kind == DomainKind::kHull) {
    const auto faces = facets_by_definition(complex.points, all_vertices(complex.points));
    CHECK(hull_faces(complex.points) == faces);
    complex = with_hull_walls(complex, faces);
  }
  const std::vector<bool> used = match_vertices(mesh, complex).used;
  const Markers markers = random_markers(mesh, complex, random);
  const Cells cells(complex, markers);
  const Regions regions(complex);
  // All sets of so many triangles are tried at each distance.
  constexpr std::size_t kMost = 8;
  if (!is_small_enough_for_definition(mesh, used, cells, kSquaredLimit, kMost)) return;
  Work work;
  const ReachAnswer quick = least_reach(mesh, used, cells, regions, kSquaredLimit, 1, work);
  const ReachAnswer slow = least_reach_by_definition(mesh, used, cells, regions, kSquaredLimit);
  const bool found = slow.kind == ReachAnswer::Kind::kFound;
  CHECK((quick.kind == ReachAnswer::Kind::kFound) == found);
  if (found) {
    ++counts.found;
    CHECK(to_string(quick.squared_reach) == to_string(slow.squared_reach));
    CHECK(text_of_images(quick.images) == text_of_images(slow.images));
    if (sign(quick.squared_reach) > 0) ++counts.moved;
  } else {
    ++counts.none;
  }
  hold_lacking(mesh, complex, found, counts);
  const auto verdict = judge_within(Claim::kSteinerTriangulation, mesh, moved.domain, kSquaredLimit,
                                    {.max_violations = 0}, nullptr, nullptr, markers);
  hold_with_known_facts(verdict, mesh, moved.domain, markers);
  if (!verdict) {
    ++counts.not_judged;
    CHECK((has_stray || fault != Fault::kNone));
    return;
  }
  if (verdict->holds()) ++counts.holds;
  count_the_same(*verdict, mesh, moved.domain, markers);
  hold_with_lone_vertex(*verdict, mesh, moved.domain);
  // Every wall of these domains faces the inside.
  if (!is_sheet && verdict->within) CHECK(verdict->within->not_compared == 0);
  if (fault == Fault::kNone && !has_stray) CHECK_MESSAGE(verdict->holds(), text_of(*verdict));
  // Only a listed triangle may be listed twice.
  const bool must_fail =
      fault == Fault::kDeleted || (fault == Fault::kRepeated && (!is_sheet || sheet.stray));
  if (must_fail || !found) CHECK(!verdict->holds());
}

// So many random cases, each on its own seed.
inline void hold_equal_to_definition(std::size_t dimension, unsigned long first, int cases) {
  Counts counts;
  const int tried = properties::try_seeds(
      first, cases, [&](std::uint64_t seed) { hold_equal(seed, dimension, counts); });
  MESSAGE("dimension " << dimension << ": found " << counts.found << " moved " << counts.moved
                       << " holds " << counts.holds << " none " << counts.none << " lacking "
                       << counts.lacking << " not judged " << counts.not_judged);
  const auto occurs = [](int often, int at_least) {
    return properties::occurs(static_cast<std::size_t>(often),
                              static_cast<std::size_t>(at_least * properties::one_input_in()));
  };
  CHECK(occurs(counts.moved, tried / 5));
  CHECK(occurs(counts.holds, tried / 10));
  CHECK(occurs(counts.none, 1));
  CHECK(occurs(counts.lacking, 1));
}

}  // namespace circumspect::check
