// Coplanar triangles as one polygon. Book: Definition 4.3 (a linear cell may have holes, and may
// touch itself).
#pragma once

#include <vector>

#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect::properties {

// Groups triangles that are coplanar and joined across edges. Requires: no two triangles have
// interior points in common; no three coplanar ones have an edge in common.
std::vector<std::vector<Simplex>> coplanar_parts(const PointSet& points,
                                                 const std::vector<Simplex>& triangles);

// Their union: lines along its boundary, which may pass a vertex twice, and a point in every hole.
// Requires: one of the parts above.
PolygonLines polygon_of(const PointSet& points, const std::vector<Simplex>& part);

}  // namespace circumspect::properties
