// The tetrahedra that a triangulation of a complex can consist of.
#pragma once

#include <vector>

#include "reference/kernel/piecewise_linear/visibility.hpp"

namespace circumspect::existence {

// Every tetrahedron with vertices of the complex that respects it, ascending, in lexicographic order.
// A triangulation has no others (Definition 4.4), whatever its vertices' order.
// Requires: the complex is in space.
std::vector<Simplex> respecting_tetrahedra(const PiecewiseLinearComplex& complex,
                                           const Regions& regions);

// Those of them that are constrained Delaunay, without any perturbation. Book: Definition 4.6.
std::vector<Simplex> constrained_delaunay_tetrahedra(const PiecewiseLinearComplex& complex,
                                                     const Regions& regions);

}  // namespace circumspect::existence
