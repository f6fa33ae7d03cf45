// The words that texts and JSON share.
#pragma once

#include <string>

#include "oracle/check/check.hpp"
#include "oracle/mesh.hpp"
#include "oracle/verdict.hpp"

namespace circumspect::report {

// "vertices", "edges", "triangles", "tetrahedra", "simplices" for dimension 0, 1, 2, 3 and above.
std::string simplices_noun(int dimension);

// The vertices by the user's own indices: "3 7 9".
std::string labels(const Mesh& mesh, const Simplex& simplex);

std::string name(check::By by);

}  // namespace circumspect::report
