// Polygons whose corners were rounded, so that they are no longer in one plane.
// docs/theory/within.md has what their images are, under "Polygons that are not flat".
#pragma once

#include <optional>
#include <vector>

#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect::check {

// An input whose polygons are all flat: those that are not were cut into triangles.
struct CutPolygons {
  PiecewiseLinearInput input;
  std::vector<std::size_t> cut_of;  // of each polygon: the one of the input that it is, or is of
  std::vector<Simplex> listed;      // all segments of the input, as `segments_of` returns them
  std::size_t cut = 0;              // so many polygons were cut
  Rational squared_height = 0;      // how far corners are at most from the plane nearest to all
};

// The triangles of one polygon follow one another, and those segments between them that are not
// listed have only two of them; so `nearly_coplanar_polygons_joined` can put them together again.
// Nothing if the corners of a polygon are farther than the distance from every plane, or if it is
// not a polygon seen along the normal of the nearest one. Requires: points in space.
std::optional<CutPolygons> rounded_polygons_cut(const PiecewiseLinearInput& input,
                                                const Rational& squared_distance);

}  // namespace circumspect::check
