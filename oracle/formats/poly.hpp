// Piecewise linear complexes as Triangle and TetGen write them: .poly, and TetGen's .smesh.
//
//     points dimension [attributes [markers]]     points as in a .node file; 0: they are in one
//     segments [markers]                          in the plane
//     index v0 v1 [marker]
//     facets [markers]                            in space, .poly
//     polygons [holes [marker]]                   for each facet, then its polygons and its holes:
//     corners v0 … v(corners-1)                     they may go on over several lines
//     index x y z                                   a point in each hole of the facet
//     facets [markers]                            in space, .smesh: facets of one polygon each
//     corners v0 … v(corners-1) [marker]
//     holes                                       then a line "index x y [z]" for each
//     regions                                     may be missing; "index x y [z] attribute [bound]"
//                                                   bounds areas or volumes; one that is not
//                                                   positive, nothing
//
// A polygon of two corners is a segment, one of one corner an isolated vertex. Attributes and
// markers are checked and otherwise ignored. Where a region has no bound, its attribute is the
// bound: Triangle and TetGen read it so. TetGen reads a file that ends before the holes, so
// that in space their list may be missing too; this is noted.
#pragma once

#include <functional>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/domain_file.hpp"

namespace circumspect::formats {

// Reads the points that are not in the file itself.
using PointsElsewhere = std::function<Result<PointFile>()>;

Result<DomainFile> read_poly(const Source& source, NumberReading reading,
                             const PointsElsewhere& points_elsewhere);
Result<DomainFile> read_smesh(const Source& source, NumberReading reading,
                              const PointsElsewhere& points_elsewhere);

}  // namespace circumspect::formats
