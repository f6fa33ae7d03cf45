// Respecting a piecewise linear complex, and visibility in it.
// Book: Definitions 2.11 and 2.13, quoted in Section 4.5.2.
#pragma once

#include <optional>

#include "reference/kernel/piecewise_linear/regions.hpp"

namespace circumspect {

// A simplex σ respects P if σ ⊆ |P| and for every cell f of P that meets σ, f ∩ σ is a union of
// faces of σ. Requires: vertices of P, affinely independent; the regions are those of the complex.
bool respects(const PiecewiseLinearComplex& complex, const Regions& regions,
              const Simplex& simplex);

// Is the vertex v visible from some point in the relative interior of the simplex?
// Requires: the simplex respects the complex; v is not one of its vertices.
bool is_visible(const PiecewiseLinearComplex& complex, const Regions& regions, Vertex v,
                const Simplex& simplex);

// A point in the relative interior of the simplex from which v is visible; nothing if there is
// none. Requires: as for is_visible.
std::optional<Point> visible_point(const PiecewiseLinearComplex& complex, const Regions& regions,
                                   Vertex v, const Simplex& simplex);

}  // namespace circumspect
