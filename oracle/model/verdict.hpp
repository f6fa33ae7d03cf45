// The answer to a claim, and the witness that shows a broken rule.
#pragma once

#include <concepts>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "kernel/complex/circumball.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/complex/simplex.hpp"
#include "oracle/model/claim.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/measure.hpp"
#include "oracle/model/rule.hpp"

namespace circumspect {

// The evidence for a broken rule: enough to re-check it by hand.

// An exact value with the name under which it is reported: a rational number, a count or an index.
struct NamedValue {
  std::string name;
  Rational value;

  NamedValue(std::string as, Rational exact) : name(std::move(as)), value(std::move(exact)) {}
  template <std::integral Number>
  NamedValue(std::string as, Number whole)
      : NamedValue(std::move(as), Rational(to_integer(whole))) {}
};

// A value that is not rational, such as an angle: the double next to it, as text.
struct RoundedValue {
  std::string name;
  std::string decimal;
};

// The vertex of a mesh that is nearest to where one was expected: far below the size of the mesh,
// the distance tells rounding from a fault.
struct NearestVertex {
  Vertex vertex;
  Rational squared_distance;
};

// What was measured of a simplex that does not keep a requirement. Its text is in measure.hpp.
struct Measured {
  Measure measure;
  Rational value;        // as measure.hpp holds it
  std::string required;  // "min-angle >= 20.7deg"
};

// Simplices and vertices are named by indices from 0 (see Mesh::label for the user's own). Which
// fields are set depends on the rule; report/ puts them into words.
struct Witness {
  std::vector<Simplex> simplices = {};  // with their vertices as the user listed them
  // Their places among the simplices of the mesh, if other simplices may have the same vertices.
  std::vector<std::size_t> places = {};
  std::optional<Simplex> face = {};     // the facet or ridge in question
  std::vector<Vertex> vertices = {};    // the vertices that decide
  std::vector<NamedValue> values = {};  // the exact values that decide
  std::vector<RoundedValue> rounded = {};
  std::optional<Ball> ball = {};    // the circumball of the first simplex
  std::optional<Point> point = {};  // a point that decides without being a vertex
  // The cell of the domain in question: a vertex or a segment by the domain's own vertices, a
  // polygon by its place in the domain's list; a face of its convex hull by three vertices that
  // span it.
  std::optional<Simplex> domain_cell = {};
  std::optional<std::size_t> polygon = {};
  std::optional<NearestVertex> nearest = {};  // to the missing cell of the domain
  std::optional<Measured> measured = {};      // of the first simplex
};

// The answer to a claim. A fault of the input is not a verdict: it never reaches a checker.

struct Violation {
  Rule rule;
  Witness witness;
};

// How often a rule is broken, and the worst margin. The margin is relative and unitless: the depth
// r² − |q − o|² of a point in a ball over r², between 0 and 1 (weighted: plus its weight, and
// possibly more than 1). A margin near 0 indicates a rounding error and not a bug.
struct Tally {
  std::size_t count = 0;
  std::optional<Rational> worst_margin = {};
  // The vertices that every one of them names; none if one came without a witness.
  std::set<Vertex> in_all = {};
};

// What may be all that is wrong, found after the judgement (oracle/judge/cause) and checked: one
// clause for people, by the user's own indices. It explains some of the violations: all that the
// verdict counts, or, if `of_listed`, those whose witnesses it keeps.
struct Cause {
  std::string name;  // "missing-simplex": it never changes its meaning
  std::string words;
  std::size_t explains = 0;
  std::size_t of = 0;
  bool of_listed = false;
};

// The vertices of a mesh that are not vertices of the domain, by the linear cell in whose relative
// interior they lie. Book: Definition 4.5.
struct SteinerPoints {
  std::size_t on_segments = 0;
  std::size_t in_polygons = 0;
  std::size_t in_polyhedra = 0;

  // Counts one in a cell of this dimension.
  void add(int dimension) {
    ++(dimension == 1 ? on_segments : dimension == 2 ? in_polygons : in_polyhedra);
  }
  std::size_t count() const { return on_segments + in_polygons + in_polyhedra; }
};

// The vertices that a mesh has beyond those of the domain: how many, and the first ones.
struct ExtraVertices {
  std::size_t count = 0;
  std::vector<Vertex> first = {};  // ascending

  // Counts v, and keeps it if fewer than `limit` are kept; 0 keeps all.
  void add(Vertex v, std::size_t limit) {
    if (limit == 0 || count < limit) first.push_back(v);
    ++count;
  }
};

// How a verdict was found. The verdict does not depend on it.
struct Course {
  bool fast = false;              // did the fast engine (oracle/judge/fast) decide?
  std::string why_not_fast = {};  // if not
  // For the fast engine: signs decided by doubles, and by integers.
  std::uint64_t filtered_signs = 0;
  std::uint64_t exact_signs = 0;
};

// How far the cells of a domain were moved to be unions of faces of a mesh: docs/theory/within.md.
struct Within {
  Rational squared_reach = 0;
  // Polygons with no inside beside them that are no longer flat: their triangles were not compared.
  std::size_t not_compared = 0;
};

// For the claim `complex`: what the mesh is, of the simplices that were compared.
struct ComplexFacts {
  int dimension = -1;           // of its simplices
  std::size_t set_apart = 0;    // flat, repeated, doubled and such
  bool is_complex = false;      // do the others form one?
  bool are_counts_cut = false;  // do so many overlap that no more were counted?
  std::size_t parts = 0;        // that facets connect
  std::size_t boundary_facets = 0;
  std::size_t hanging_vertices = 0;
  std::size_t listed_faces = 0;  // beside the simplices, if they are demanded to be faces of these
  // How many quadrilaterals two simplices have on the one side and two on the other, which are cut
  // along different diagonals; and whether vertices hang only in simplices of other parts.
  std::size_t crossed_quadrilaterals = 0;
  bool only_parts_hang = false;
  // How many pairs of simplices of different parts overlap, and of how many pairs of parts.
  std::size_t overlaps_of_parts = 0, overlapping_parts = 0;
  // How many have each sign of det[p_1 − p_0; …; p_d − p_0]; none if they have no full dimension.
  std::size_t positive = 0, negative = 0;
};

// What was required of the shape of simplices beside the claim.
struct QualityFacts {
  std::vector<std::string> required;  // "min-angle:20.7deg"
  std::string except_sharp = {};      // "60deg"; empty: none was set aside
  std::size_t set_aside = 0;          // simplices at sharp angles
};

// For the claim `surface-delaunay`: how many edges are in two triangles, in one, and in more.
struct SurfaceFacts {
  std::size_t interior_edges = 0, boundary_edges = 0, edges_of_many = 0;
};

// Where the vertices and ridges of a Voronoi diagram are judged: how many places in the box have a
// vertex, and how many ridges have different ends.
struct StructureFacts {
  std::size_t vertices = 0, ridges = 0;
};

// For the claim `voronoi`: how far the farthest cell is from the exact one, and its site.
struct VoronoiFacts {
  Rational squared_distance = 0;
  std::optional<Vertex> site = {};  // none if all are exact
  std::optional<StructureFacts> structure = {};
};

class Verdict {
 public:
  Verdict(Claim claim, std::size_t max_violations)
      : claim_(claim), max_violations_(max_violations) {}
  Verdict(Claim claim, const ExactMesh& mesh, std::size_t max_violations);

  // Counts a violation, and keeps it unless the limit is reached.
  void add(Rule rule, const Witness& witness, const std::optional<Rational>& margin = std::nullopt);
  // Would the next violation be kept? A checker need not compute a witness that is dropped.
  bool keeps_more() const { return max_violations_ == 0 || violations_.size() < max_violations_; }
  // How many violations are kept; 0: all.
  std::size_t max_violations() const { return max_violations_; }
  // Counts a violation whose witness is not kept; `named`: the vertices that it would name, in any
  // order, if they are known.
  void count(Rule rule, const std::optional<Rational>& margin = std::nullopt, Simplex named = {});
  // After judging a part of a mesh: renames the vertices and simplices of the witnesses as in the
  // whole mesh. The arguments give, for each vertex and simplex of the part, its place in the
  // whole, ascending. Requires: everything that is named is in the part, except indices that name
  // no point of the whole.
  void name_in_whole(const std::vector<Vertex>& vertex_of,
                     const std::vector<std::size_t>& simplex_of);

  bool holds() const { return tallies_.empty(); }
  Claim claim() const { return claim_; }
  const std::vector<Violation>& violations() const { return violations_; }
  // By the stage at which rules are judged: the first names the cause.
  const std::map<Rule, Tally, JudgedBefore>& tallies() const { return tallies_; }

  // Facts beside the verdict, for a Delaunay claim that holds: is there no other Delaunay
  // triangulation of the points? is this the canonical one? (For constrained Delaunay
  // triangulations, `unique` is set only where it is certain.)
  std::optional<bool> unique = {};
  std::optional<bool> canonical = {};

  // For a claim about a domain: the vertices that the mesh has beyond those of the domain.
  // The vertices themselves (as many as violations are kept) are known before their cells.
  std::optional<SteinerPoints> steiner_points = {};
  std::optional<ExtraVertices> extra_vertices = {};
  // For a claim about a domain that holds: how many of the listed triangles and edges are faces of
  // no larger simplex, listed ones included.
  std::size_t dangling = 0;

  // For a claim about a domain that may be moved: how far it was moved. `beyond`: there is no
  // distance, with a square of at most this, at which every cell of the domain is a union of faces.
  std::optional<Within> within = {};
  std::optional<Rational> beyond = {};

  std::optional<ComplexFacts> complex = {};
  std::optional<QualityFacts> quality = {};
  std::optional<SurfaceFacts> surface = {};
  std::optional<VoronoiFacts> voronoi = {};

  // The most that one of them explains comes first.
  std::vector<Cause> causes = {};

  std::size_t points = 0;
  std::size_t simplices = 0;
  int dimension = -1;  // of the affine hull of the points

  Course course = {};

 private:
  Claim claim_;
  std::size_t max_violations_;
  std::vector<Violation> violations_;
  std::map<Rule, Tally, JudgedBefore> tallies_;
};

}  // namespace circumspect
