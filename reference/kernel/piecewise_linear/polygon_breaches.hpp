// The stages of `validated` that hold polygons against other cells. Book: Section 4.5.1, Definition
// 4.3.
#pragma once

#include "reference/kernel/exact/progress.hpp"
#include "reference/kernel/piecewise_linear/breach.hpp"
#include "reference/kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect {

// Each adds what it finds and ends early when the list is full.
// Stage 4. Requires: no breach of stage 3.
void find_piercing_segments(const PiecewiseLinearComplex& complex, const Progress& progress,
                            BreachList& found);

// Stage 5. Requires: no breach of stage 4.
void find_polygon_pair_breaches(const PiecewiseLinearComplex& complex, const Progress& progress,
                                BreachList& found);
void find_hole_seed_breaches(const PiecewiseLinearComplex& complex, BreachList& found);

}  // namespace circumspect
