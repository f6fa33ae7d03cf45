// The claim `complex`: by lemma and by definition the same is said, word for word, of whole meshes,
// of parts of them, and of those in which faults were planted. Proof: docs/theory/complex.md.
#include <algorithm>
#include <map>
#include <set>

#include <doctest/doctest.h>

#include "inputs/dice.hpp"
#include "oracle/judge/complex/judge_complex.hpp"
#include "oracle/judge/definition/simplicial_complex.hpp"
#include "oracle/judge/fast/grid_mesh_test.hpp"
#include "oracle/judge/judge.hpp"
#include "oracle/judge/stray_faces.hpp"
#include "oracle/model/listed_mesh_test.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/report/text.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::properties {
namespace {

using definition::ListedComplex;
using generators::Dice;

// Few coordinates, so that much is degenerate.
Point small_point(Dice& dice, std::size_t d, long most) {
  Point point;
  for (std::size_t axis = 0; axis < d; ++axis) point.push_back(dice.within(0L, most));
  return point;
}

ListedComplex triangulated(Dice& dice, std::size_t d) {
  std::set<Point> points;
  const std::size_t count = d + 1 + dice.below(4);
  while (points.size() < count) points.insert(small_point(dice, d, d == 1 ? 9 : 3));
  const PointSet set({points.begin(), points.end()});
  return {set.points(), delaunay::bowyer_watson(set).simplices()};
}

Simplex& any(Dice& dice, std::vector<Simplex>& simplices) {
  return simplices[dice.below(simplices.size())];
}
void erase_any(Dice& dice, std::vector<Simplex>& simplices) {
  simplices.erase(simplices.begin() + static_cast<std::ptrdiff_t>(dice.below(simplices.size())));
}
Vertex any_vertex(Dice& dice, const ListedComplex& mesh) {
  return static_cast<Vertex>(dice.below(mesh.points.size()));
}

// Two halves of an octahedron above and below a square, which each cuts along another diagonal.
ListedComplex meshed_apart() {
  return {{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 1, 2, 4}, {0, 2, 3, 4}, {0, 1, 3, 5}, {1, 2, 3, 5}}};
}

// One more part, which may touch the others, lie in them or cross them.
void add_part(Dice& dice, ListedComplex& mesh) {
  const std::size_t d = mesh.points.front().size(), size = mesh.simplices.front().size();
  ListedComplex other = d == 3 && dice.below(3) == 0 ? meshed_apart() : triangulated(dice, d);
  if (size <= d) other.simplices = faces_of(other.simplices, size);
  const auto first = static_cast<Vertex>(mesh.points.size());
  const Point moved = small_point(dice, d, 3);
  for (const Point& point : other.points) {
    mesh.points.push_back(point);
    for (std::size_t axis = 0; axis < point.size(); ++axis) mesh.points.back()[axis] += moved[axis];
  }
  for (Simplex simplex : other.simplices) {
    for (Vertex& v : simplex) v += first;
    mesh.simplices.push_back(simplex);
  }
}

// Cuts one of the simplices at the middle of an edge, whether others have the edge or not.
void cut_one(Dice& dice, ListedComplex& mesh) {
  Simplex& simplex = any(dice, mesh.simplices);
  if (simplex.size() < 2 || simplex[0] == simplex[1]) return;
  const auto at = [&](Vertex v) -> const Point& {
    return mesh.points.at(static_cast<std::size_t>(v));
  };
  const Point middle = barycentre({at(simplex[0]), at(simplex[1])});
  const auto v = static_cast<Vertex>(mesh.points.size());
  Simplex half = simplex;
  half[0] = v;
  simplex[1] = v;
  mesh.points.push_back(middle);
  mesh.simplices.push_back(half);
}

// One more simplex on the far side of a facet of one that is there. A facet of its own lies in that
// plane, where a corner may be within the other facet while edges of both cross.
void lay_beside(Dice& dice, ListedComplex& mesh) {
  const Simplex simplex = any(dice, mesh.simplices);
  if (simplex.size() < 3) return;
  std::vector<Point> corners;
  for (const Vertex v : simplex) corners.push_back(mesh.points.at(static_cast<std::size_t>(v)));
  const Point apex = corners.back(), &origin = corners.front();
  corners.pop_back();
  Simplex added;
  const auto add = [&](const Point& point) {
    added.push_back(static_cast<Vertex>(mesh.points.size()));
    mesh.points.push_back(point);
  };
  for (std::size_t count = corners.size(); count > 0; --count) {
    Point point = origin;
    for (std::size_t i = 1; i < corners.size(); ++i) {
      const Rational part = Rational(1, 4) * dice.within(-2L, 4L);
      point = point + part * (corners[i] - origin);
    }
    add(point);
  }
  add(origin + origin - apex);
  mesh.simplices.push_back(added);
}

void break_once(Dice& dice, ListedComplex& mesh) {
  if (mesh.simplices.empty()) return;
  const std::size_t d = mesh.points.front().size();
  switch (dice.below(11)) {
    case 0:
      mesh.points[dice.below(mesh.points.size())] = small_point(dice, d, 3);
      return;
    case 1:
      return cut_one(dice, mesh);
    case 2:
      mesh.simplices.push_back(Simplex(any(dice, mesh.simplices)));
      std::reverse(mesh.simplices.back().begin(), mesh.simplices.back().end());
      return;
    case 3: {
      Simplex& simplex = any(dice, mesh.simplices);
      simplex[dice.below(simplex.size())] = any_vertex(dice, mesh);
      return;
    }
    case 4: {  // one corner comes to stand for itself
      Simplex& simplex = any(dice, mesh.simplices);
      Vertex& corner = simplex[dice.below(simplex.size())];
      mesh.points.push_back(mesh.points.at(static_cast<std::size_t>(corner)));
      corner = static_cast<Vertex>(mesh.points.size()) - 1;
      return;
    }
    case 5: {
      Simplex& simplex = any(dice, mesh.simplices);
      std::swap(simplex.front(), simplex.back());
      return;
    }
    case 6: {
      Simplex added = any(dice, mesh.simplices);
      for (Vertex& v : added) v = any_vertex(dice, mesh);
      mesh.simplices.push_back(added);
      return;
    }
    case 7:
      return add_part(dice, mesh);
    case 8:
      return lay_beside(dice, mesh);
    case 9:  // of no simplex, and at times equal to another
      mesh.points.push_back(small_point(dice, d, 3));
      return;
    default:
      erase_any(dice, mesh.simplices);
  }
}

// A mesh of simplices of k + 1 vertices, with up to two faults.
ListedComplex drawn(Dice& dice, std::size_t d, std::size_t k) {
  ListedComplex mesh = triangulated(dice, d);
  if (k < d) mesh.simplices = faces_of(mesh.simplices, k + 1);
  while (mesh.simplices.size() > 10) erase_any(dice, mesh.simplices);
  for (std::size_t faults = dice.below(3); faults > 0; --faults) break_once(dice, mesh);
  std::erase_if(mesh.simplices, [k](const Simplex& simplex) { return simplex.size() != k + 1; });
  while (mesh.simplices.size() > 14) erase_any(dice, mesh.simplices);
  return mesh;
}

// Faces of the simplices, some of which name another vertex: one that they have already, one that
// is a point or one that is not.
std::vector<Simplex> drawn_faces(Dice& dice, const ListedComplex& mesh) {
  std::vector<Simplex> faces;
  if (mesh.simplices.empty()) return faces;
  const auto end = static_cast<Vertex>(mesh.points.size());
  for (std::size_t count = 1 + dice.below(6); count > 0; --count) {
    Simplex face = mesh.simplices[dice.below(mesh.simplices.size())];
    while (face.size() > 1 && dice.below(2) == 0) {
      face.erase(face.begin() + static_cast<std::ptrdiff_t>(dice.below(face.size())));
    }
    if (dice.below(4) == 0) face[dice.below(face.size())] = dice.within(Vertex{-1}, end);
    std::rotate(face.begin(), face.begin() + 1, face.end());
    faces.push_back(std::move(face));
  }
  return faces;
}

ComplexDemands drawn_demands(Dice& dice) {
  ComplexDemands demands;
  demands.faces = dice.below(2) == 0;
  demands.manifold = dice.below(2) == 0;
  demands.connected = dice.below(4) == 0;
  demands.closed = dice.below(4) == 0;
  demands.oriented = static_cast<Orientations>(dice.below(4));
  demands.allow_hanging = dice.below(8) == 0;
  demands.allow_unused = dice.below(2) == 0;
  return demands;
}

Mesh in_arrays(const ListedComplex& listed, std::vector<Simplex> faces = {}) {
  Mesh mesh = listed_mesh(listed.points, listed.simplices);
  mesh.faces = std::move(faces);
  return mesh;
}

std::string text(const Verdict& verdict, const Mesh& mesh) {
  const ComplexFacts& facts = *verdict.complex;
  return report::explanation(verdict, mesh) + report::verdict_line(verdict, mesh, "m") +
         report::note_of_set_apart(verdict, "m").value_or("") +
         (facts.is_complex ? "a complex " : "none ") + std::to_string(facts.parts) + " " +
         std::to_string(facts.boundary_facets) + " " + std::to_string(facts.hanging_vertices) +
         " " + std::to_string(facts.positive) + " " + std::to_string(facts.overlaps_of_parts) +
         " " + std::to_string(facts.overlapping_parts) + " " + std::to_string(verdict.dimension);
}

// What comes up.
struct Outcomes {
  std::map<Rule, std::size_t> broken = {};
  std::size_t held = 0, held_fast = 0;
};

void compare(std::size_t d, std::size_t k, int inputs, Outcomes& seen) {
  CHECK(holds("by lemma as by definition, and as by the judge of arrays", inputs, [&, d, k] {
    Dice dice(*rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>()));
    const ListedComplex listed = drawn(dice, d, k);
    const ComplexDemands demands = drawn_demands(dice);
    const Mesh mesh = in_arrays(listed, drawn_faces(dice, listed));
    check::Options options{.complex = demands, .max_violations = 0};
    Verdict by_lemma = check::judge_complex(listed, demands, false, 0);
    if (demands.faces) check::judge_listed_faces(mesh, check::By::kLemma, by_lemma);
    const Verdict of_arrays = check::judge(Claim::kComplex, mesh, nullptr, options).value();
    RC_ASSERT(text(of_arrays, mesh) == text(by_lemma, mesh));
    options.by = check::By::kDefinition;
    const Verdict by_definition = check::judge(Claim::kComplex, mesh, nullptr, options).value();
    RC_ASSERT(text(by_lemma, mesh) == text(by_definition, mesh));
    seen.held += by_lemma.holds() ? 1 : 0;
    seen.held_fast += of_arrays.course.fast ? 1 : 0;
    for (const auto& [rule, tally] : by_lemma.tallies()) ++seen.broken[rule];
  }));
}

void check_all_kinds(int inputs_in_plane, int inputs_in_space) {
  Outcomes seen;
  compare(2, 2, inputs_in_plane, seen);
  compare(3, 3, inputs_in_space, seen);
  CHECK(occurs(seen.held_fast));
  compare(1, 1, inputs_in_plane / 4, seen);
  compare(2, 1, inputs_in_plane / 4, seen);
  compare(3, 2, inputs_in_space, seen);
  compare(3, 1, inputs_in_plane / 4, seen);
  CHECK(occurs(seen.held));
  // The property says nothing of a rule that never comes up.
  for (const Rule rule :
       {Rule::kPointsEqual, Rule::kHangingVertex, Rule::kFacesCross, Rule::kOverlap,
        Rule::kNotManifold, Rule::kNotOriented, Rule::kNotClosed, Rule::kNotConnected,
        Rule::kInverted, Rule::kOrientation, Rule::kStrayFace, Rule::kDegenerateSimplex,
        Rule::kRepeatedVertex, Rule::kDuplicateSimplex, Rule::kUnusedPoint}) {
    CAPTURE(identifier(rule));
    CHECK(occurs(seen.broken[rule]));
  }
}

// Adds a simplex with a corner there, and the others so far from it along the axes.
void add_corner(ListedComplex& mesh, const Point& at, long length) {
  mesh.simplices.emplace_back();
  for (std::size_t i = 0; i <= at.size(); ++i) {
    mesh.simplices.back().push_back(static_cast<Vertex>(mesh.points.size()));
    mesh.points.push_back(at);
    if (i > 0) mesh.points.back()[i - 1] += length;
  }
}

TEST_CASE("complex: a part within another one overlaps it, whichever of many that is") {
  constexpr long kParts = 4;
  for (const std::size_t d : {2u, 3u}) {
    for (long within = 0; within <= kParts; ++within) {
      ListedComplex mesh;
      for (long part = 0; part < kParts; ++part) add_corner(mesh, Point(d, 20 * part), 9);
      add_corner(mesh, Point(d, 20 * within + 1), 2);  // the last time beyond all of them
      const Verdict verdict = check::judge(Claim::kComplex, in_arrays(mesh), nullptr, {}).value();
      CHECK(verdict.holds() == (within == kParts));
      CHECK(verdict.tallies().contains(Rule::kOverlap) == (within < kParts));
    }
  }
}

// Simplices of a grid in which some vertices are in no facet of the boundary: most of them, or
// those at one such vertex alone.
std::vector<Simplex> some_of_grid(Dice& dice, std::size_t d, std::size_t side) {
  const auto rows =
      d == 2 ? fast::grid_mesh<2>(side).simplices : fast::grid_mesh<3>(side).simplices;
  const Vertex inner = d == 2 ? 12 : 21;
  const bool is_star = dice.below(2) == 0;
  const std::size_t left_out = dice.below(4);  // of ten
  std::vector<Simplex> simplices;
  for (std::size_t i = 0; i < rows.size(); i += d + 1) {
    Simplex simplex;
    for (std::size_t k = 0; k <= d; ++k) simplex.push_back(rows[i + k]);
    if (is_star ? contains(simplex, inner) : dice.below(10) >= left_out) {
      simplices.push_back(simplex);
    }
  }
  return simplices;
}

// Some of several grids in a row; each may touch the one before it at a vertex. All points are
// used.
ListedComplex of_several_grids(Dice& dice, std::size_t d) {
  const long side = d == 2 ? 5 : 4;
  ListedComplex mesh;
  std::map<Point, Vertex> known;
  Rational moved = 0;
  for (std::size_t grids = 1 + dice.below(3); grids > 0; --grids) {
    for (Simplex& simplex : some_of_grid(dice, d, static_cast<std::size_t>(side))) {
      for (Vertex& v : simplex) {
        Point point;
        for (std::size_t axis = 0; axis < d; ++axis, v /= side) point.push_back(v % side + moved);
        const auto [found, is_new] = known.emplace(point, static_cast<Vertex>(known.size()));
        if (is_new) mesh.points.push_back(point);
        v = found->second;
      }
      mesh.simplices.push_back(simplex);
    }
    moved += side - static_cast<long>(dice.below(2));
  }
  return mesh;
}

// What bounds such grids: surfaces that are closed and may touch. At times one triangle is left
// out, or one or all are turned.
ListedComplex surfaces_of_several_grids(Dice& dice) {
  ListedComplex mesh = of_several_grids(dice, 3);
  std::map<Simplex, Simplex> facets;  // as they are turned outwards, by their vertices
  for (const Simplex& simplex : mesh.simplices) {
    for (std::size_t i = 0; i <= 3; ++i) {
      Simplex facet = facet_opposite(simplex, i);
      const Simplex vertices = sorted(facet);
      if (i % 2 == 1) std::swap(facet[0], facet[1]);
      if (!facets.emplace(vertices, facet).second) facets.erase(vertices);
    }
  }
  mesh.simplices.clear();
  const bool are_turned = dice.below(4) == 0;
  for (auto& [vertices, facet] : facets) {
    if (are_turned) std::swap(facet[1], facet[2]);
    mesh.simplices.push_back(facet);
  }
  if (dice.below(3) == 0) erase_any(dice, mesh.simplices);
  if (dice.below(3) == 0) std::swap(mesh.simplices.front()[1], mesh.simplices.front()[2]);
  std::map<Vertex, Vertex> own;
  ListedComplex surfaces;
  for (Simplex& facet : mesh.simplices) {
    for (Vertex& v : facet) {
      const auto [found, is_new] = own.emplace(v, static_cast<Vertex>(own.size()));
      if (is_new) surfaces.points.push_back(mesh.points.at(static_cast<std::size_t>(v)));
      v = found->second;
    }
    surfaces.simplices.push_back(facet);
  }
  return surfaces;
}

// How many have several parts, and how many are judged by the fast engine.
struct Parts {
  std::size_t several = 0, fast = 0, held = 0;
};

void compare_parts(const ListedComplex& listed, const ComplexDemands& demands, Parts& seen) {
  const Mesh mesh = in_arrays(listed);
  const Verdict by_lemma = check::judge_complex(listed, demands, false, 0);
  const Verdict of_arrays =
      check::judge(Claim::kComplex, mesh, nullptr, {.complex = demands, .max_violations = 0})
          .value();
  RC_ASSERT(text(of_arrays, mesh) == text(by_lemma, mesh));
  seen.fast += of_arrays.course.fast ? 1 : 0;
  seen.several += of_arrays.complex->parts > 1 ? 1 : 0;
  seen.held += of_arrays.holds() ? 1 : 0;
}

TEST_CASE("complex: large parts are counted, and asked of, as by lemma") {
  Parts in_plane, in_space, of_surfaces;
  CHECK(holds("parts in the plane", 200, [&] {
    Dice dice(*rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>()));
    compare_parts(of_several_grids(dice, 2), {}, in_plane);
  }));
  CHECK(holds("parts in space", 60, [&] {
    Dice dice(*rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>()));
    compare_parts(of_several_grids(dice, 3), {}, in_space);
  }));
  CHECK(holds("surfaces", 300, [&] {
    Dice dice(*rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>()));
    const ListedComplex listed = surfaces_of_several_grids(dice);
    const std::size_t which = dice.below(4);  // of what is seldom asked for at once
    const ComplexDemands demands{.manifold = which == 0,
                                 .connected = which == 1,
                                 .closed = which == 2,
                                 .oriented = static_cast<Orientations>(dice.below(4))};
    compare_parts(listed, demands, of_surfaces);
  }));
  for (const Parts& seen : {in_plane, in_space, of_surfaces}) {
    CHECK(occurs(seen.several));
    CHECK(occurs(seen.fast));
    CHECK(occurs(seen.held));
  }
}

TEST_CASE("complex: by lemma and by definition the same is said of every mesh") {
  check_all_kinds(2000, 1500);
}

}  // namespace
}  // namespace circumspect::properties
