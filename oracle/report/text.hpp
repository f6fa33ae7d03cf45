// Verdicts for people.
#pragma once

#include <string>

#include "oracle/model/domain.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::report {

// One line, stable: "holds: delaunay x.1.ele 1000 points 6573 tetrahedra unique canonical", or
// "fails: delaunay x.1.ele delaunay.facet-not-local 3 face 3 7 9 vertex 12": the first broken
// rule, how often, its first witness, then "also RULE COUNT" for every further rule. A claim about a
// domain that holds says how many Steiner points there are, if any, and where: "12 steiner-points 5
// on-segments 4 in-polygons 3 in-polyhedra". `domain` is the one that the claim is about.
std::string verdict_line(const Verdict& verdict, const Mesh& mesh, const std::string& mesh_name,
                         const Domain* domain = nullptr);

// Every witness kept, several lines each; how many of each rule there are beyond those; and the
// worst relative margin. Empty if the claim holds. Exact values too long to read are given by their
// decimals; JSON has them whole.
std::string explanation(const Verdict& verdict, const Mesh& mesh, const Domain* domain = nullptr);

}  // namespace circumspect::report
