// A Steiner CDT of any complex. Book: Sections 4.5.2 and 4.5.3.
#pragma once

#include <vector>

#include <tl/expected.hpp>

#include "reference/constrained/plc_triangulation.hpp"
#include "reference/constrained/split_segments.hpp"
#include "reference/kernel/exact/progress.hpp"

namespace circumspect::constrained {

enum class CdtAlgorithm { kGiftWrapping, kPolygonFlips, kPolygonCavities };

// The canonical CDT of a complex that has one by Theorem 4.9, or because it is planar.
// Requires: in space, that the complex is edge-protected in either reading; the complex is valid.
// Throws std::logic_error if it turns out to have no CDT, and so was not edge-protected.
PlcTriangulation cdt_of_edge_protected(const PiecewiseLinearComplex& complex,
                                       CdtAlgorithm algorithm = CdtAlgorithm::kPolygonFlips,
                                       const Progress& progress = {});

struct SteinerCdt {
  PiecewiseLinearComplex complex;  // the augmented complex: the original points come first
  PlcTriangulation triangulation;  // its canonical CDT
  std::vector<PointOnSegment> steiner_points;  // in the order of their indices
};

// "The augmented PLC has a CDT, which is a Steiner CDT of the original PLC." A complex that is
// edge-protected gets no Steiner points; nor does one in the plane, where every complex has a CDT.
// However short the subsegments have to be, as many are made: that ends (see segment_recovery.hpp).
// Requires: the complex is valid.
// Throws std::logic_error if the augmented complex has no CDT, which would refute Theorem 4.9.
SteinerCdt steiner_cdt(const PiecewiseLinearComplex& complex,
                       CdtAlgorithm algorithm = CdtAlgorithm::kPolygonFlips);

// The same, unless more than so many Steiner points are needed.
tl::expected<SteinerCdt, SteinerLimitReached> steiner_cdt(const PiecewiseLinearComplex& complex,
                                                          CdtAlgorithm algorithm,
                                                          std::size_t most_steiner_points,
                                                          const Progress& progress = {});

}  // namespace circumspect::constrained
