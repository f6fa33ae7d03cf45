// Measures of simplices, from the words of their definitions: docs/theory/quality.md.
#pragma once

#include <optional>
#include <vector>

#include "kernel/complex/simplex.hpp"
#include "kernel/exact/point.hpp"
#include "oracle/model/measure.hpp"

namespace circumspect::definition {

// sign(cos) · cos² of the angle at a point between the ways to a and to b, or at an edge between
// the half-planes with a and with b. Requires: neither a nor b is in the flat of the ridge.
Rational signed_square_at(const std::vector<Point>& ridge, const Point& a, const Point& b);

// The value of the measure, as oracle/model/measure.hpp holds it; none if the corners are affinely
// dependent. An angle is that of two vectors, a dihedral angle that of what is left of two vectors
// without their parts along the edge; heights are distances to the flats of the facets, and area
// and volume are bases times heights. Requires: two to four corners, and the measure exists for
// them.
std::optional<Rational> measured(Measure measure, const std::vector<Point>& corners);

// The places of the simplices that do not keep the requirement. Those of fewer vertices than others
// have, with indices that name no point, or with affinely dependent corners are not measured.
std::vector<std::size_t> not_keeping(const Requirement& requirement,
                                     const std::vector<Point>& points,
                                     const std::vector<Simplex>& simplices);

}  // namespace circumspect::definition
