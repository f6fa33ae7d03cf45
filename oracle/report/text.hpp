// Verdicts for people.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/exact/number.hpp"
#include "oracle/model/domain.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/options.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::report {

// One line, stable: "holds: delaunay x.1.ele 1000 points 6573 tetrahedra unique canonical", or
// "fails: delaunay x.1.ele delaunay.facet-not-local 3 face 3 7 9 vertex 12": the first broken
// rule, how often, its first witness, then "also RULE COUNT" for every further rule. A claim about
// a domain that holds says how many Steiner points there are, if any, and where: "12 steiner-points
// 5 on-segments 4 in-polygons 3 in-polyhedra". `domain` is the one that the claim is about.
std::string verdict_line(const Verdict& verdict, const Mesh& mesh, const std::string& mesh_name,
                         const Domain* domain = nullptr);

// Every witness kept, several lines each; for each rule the number of further ones; the worst
// relative margin; and what may be the cause, a line each. Empty if the claim holds. Exact values
// that are too long to read are given as decimals; JSON has them in full.
std::string explanation(const Verdict& verdict, const Mesh& mesh, const Domain* domain = nullptr);

// "cause: 1 tetrahedron is missing: 4 17 22 9 fills the hole (explains all 4 violations)".
std::string cause_line(const Cause& cause);

// The text of a note if no domain was given: the mesh may be a mesh of a domain, since it does not
// fill the convex hull of its points. Nothing if it does fill the hull, if weights count, or if
// domains have another dimension.
std::optional<std::string> note_of_domain_not_given(const Verdict& verdict, const Mesh& mesh,
                                                    const std::string& mesh_name);

// The text of a note if the claim `complex`, which was not asked, may be what was meant: the mesh
// does not fill the convex hull of its points, or has flat simplices, which keep the others from
// being judged.
std::optional<std::string> note_of_claim_complex(const Verdict& verdict,
                                                 const std::string& mesh_name);

// For a note, of the claim `complex`: that more overlap than were counted. None if all were.
std::optional<std::string> note_of_cut_counts(const Verdict& verdict, const std::string& mesh_name);

// For a note, of the claim `complex`: how many simplices were set apart, and whether the others
// form a complex. None if none was.
std::optional<std::string> note_of_set_apart(const Verdict& verdict, const std::string& mesh_name);

// For a mesh whose points have to differ: "expected distinct points, found points 2 and 3 equal and
// 1 more duplicate; to take equal points for one, add --duplicates merge". `count`: how many repeat
// an earlier point; the first of these is `again`, which repeats `kept`, by the user's indices.
// `to_merge`: what the user does to merge them, if that is possible.
std::string fault_of_equal_points(Vertex kept, Vertex again, std::uint64_t count,
                                  std::string_view to_merge);
// The text of a note on merged points: "points 2 and 3 are equal and count as one". Requires: some
// were merged; the user's index of the first point is `first_index`.
std::string note_of_merged_points(const std::vector<Duplicate>& merged, Vertex first_index = 0);

// The words that texts and JSON share.

// "1 point", "2 points". `several` is the plural if it is not formed with an s.
std::string counted(std::size_t count, std::string_view one, std::string_view several = {});

// "vertices", "edges", "triangles", "tetrahedra", "simplices" for dimension 0, 1, 2, 3 and above;
// "vertex" and so on for one.
std::string simplices_noun(int dimension, std::size_t count);

// "1 tetrahedron", "2 tetrahedra".
std::string counted_simplices(std::size_t count, int dimension);

// What a witness names, by the user's own indices.
struct NamedCells {
  std::vector<Simplex> simplices = {};  // as they are listed
  std::optional<Simplex> face = {};     // as the first of these that has it lists it
  // The indices above of points that were merged into equal ones, and the indices of the points
  // that were kept.
  std::map<Vertex, Vertex> merged = {};
};
NamedCells named_cells(const Witness& witness, const Mesh& mesh);

// Indices separated by blanks.
std::string joined(const Simplex& indices);

// The vertices of a mesh, of either type, by the user's own indices: "3 7 9".
template <class AnyMesh>
std::string labels(const AnyMesh& mesh, const Simplex& simplex) {
  Simplex own;
  for (const Vertex v : simplex) own.push_back(mesh.label(v));
  return joined(own);
}

std::string name(check::By by);

// Distances for people, never less than they are.

// The square root in two significant digits, rounded up: "2.1e-14"; "0" for zero. As a number it is
// at least the square root. Requires: squared >= 0.
std::string square_root_rounded_up(const Rational& squared);

}  // namespace circumspect::report
