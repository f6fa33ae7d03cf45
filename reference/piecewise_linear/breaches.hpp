// The stages of `validated`. Each adds what it finds and ends early when the list is full.
// Book: Section 4.5.1, Definition 4.3.
#pragma once

#include "reference/piecewise_linear/breach.hpp"
#include "reference/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect {

// Stage 1. Requires: as `validated`.
void find_list_breaches(const PiecewiseLinearInput& input, BreachList& found);

// Stage 2. Requires: no breach of stage 1. `points` are those of the input, `segments` all of it.
void find_plane_breaches(const PiecewiseLinearInput& input, const PointSet& points,
                         BreachList& found);
void find_segment_breaches(const PointSet& points, const std::vector<Simplex>& segments,
                           BreachList& found);

// Stage 3. Requires: no breach of stage 2. The complex is what `assemble` makes of the input.
void find_area_breaches(const PiecewiseLinearInput& input, const PiecewiseLinearComplex& complex,
                        BreachList& found);

// Stage 4. Requires: no breach of stage 3.
void find_piercing_segments(const PiecewiseLinearComplex& complex, BreachList& found);

// Stage 5. Requires: no breach of stage 4.
void find_polygon_pair_breaches(const PiecewiseLinearComplex& complex, BreachList& found);
void find_hole_seed_breaches(const PiecewiseLinearComplex& complex, BreachList& found);

}  // namespace circumspect
