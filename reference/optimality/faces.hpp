// The faces of a simplex, and the simplicial complex that a triangulation is.
// Book: Section 4.1 ("its total number of simplices of all dimensions").
#pragma once

#include <vector>

#include "reference/kernel/complex/triangulation.hpp"

namespace circumspect::optimality {

// Every non-empty set of vertices of the simplex, in its order, the simplex itself last.
std::vector<Simplex> faces(const Simplex& simplex);

// The simplices of all dimensions, each once: ascending vertices, small dimensions first.
std::vector<Simplex> simplicial_complex(const Triangulation& triangulation);

}  // namespace circumspect::optimality
