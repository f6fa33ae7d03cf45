// Constructing a CDT by inserting polygons. Book: Section 5.8 ("first constructing a Delaunay
// triangulation of the vertices in P …, then inserting the polygons one by one").
#pragma once

#include <optional>
#include <vector>

#include <tl/expected.hpp>

#include "kernel/exact/progress.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "reference/constrained/evolving_cdt.hpp"
#include "reference/constrained/flip_insert_polygon.hpp"
#include "reference/constrained/plc_triangulation.hpp"

namespace circumspect::constrained {

enum class PolygonInsertion { kFlips, kCavities };

// The obstacle, and the polygon that was to be inserted; without polygon, a segment that is not an
// edge of the canonical Delaunay triangulation of the vertices. Neither implies that there is no
// CDT: a subset of the polygons may have none although all of them together have one.
struct NoPolygonInsertion {
  NoChange cause;
  std::optional<std::size_t> polygon;
};

struct PolygonInsertionOptions {
  PolygonInsertion by = PolygonInsertion::kFlips;
  std::vector<std::size_t> order = {};  // of the polygons; empty: as given
  Progress progress = {};
};

// The canonical CDT of the complex. It is found whenever all segments are in the canonical Delaunay
// triangulation of the vertices, in particular if the complex is edge-protected (Theorem 4.9), for
// then every subset of the polygons has a CDT too. `runs` receives the record of each insertion by
// flips, in the order of insertion. Requires: a complex in space, valid; the order is empty or
// names each polygon once. Throws tl::bad_expected_access if coplanar points turn out to have no
// CDT; in fact they always have one.
tl::expected<PlcTriangulation, NoPolygonInsertion> cdt_by_polygon_insertion(
    const PiecewiseLinearComplex& complex, const PolygonInsertionOptions& options = {},
    std::vector<PolygonFlips>* runs = nullptr);

// The CDT of the convex hull with all segments, and with the polygons in it, whatever the kind of
// the domain. Requires: as above, and complex.points.dimension() == 3.
tl::expected<EvolvingCdt, NoPolygonInsertion> hull_cdt_by_polygon_insertion(
    const PiecewiseLinearComplex& complex, const PolygonInsertionOptions& options = {},
    std::vector<PolygonFlips>* runs = nullptr);

// A CDT that some other construction has found, ready to change.
// Requires: the canonical CDT of a complex of the hull kind, which is asserted, in dimension 3.
EvolvingCdt evolving_cdt(const PiecewiseLinearComplex& complex, const PlcTriangulation& cdt);

}  // namespace circumspect::constrained
