// What others may ask the book to construct, whatever the algorithm. This header is the only one of
// reference/ that the oracle, the C and Python interfaces and the harness may include
// (`tidy/tidy.py`). Whoever wants a certain algorithm, its steps or its statistics, as `build`
// does, includes that algorithm's header.
#pragma once

#include <cstddef>
#include <optional>

#include <tl/expected.hpp>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/triangulation.hpp"
#include "kernel/exact/progress.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/constrained/plc_triangulation.hpp"

namespace circumspect::reference {

using constrained::NoCdt;
using constrained::PlcTriangulation;

// The canonical Delaunay triangulation of the points, the weighted one if they have weights. Any
// number of points, of any dimension. Book: Sections 4.2 and 5.2 to 5.5.
Triangulation canonical_delaunay(const PointSet& points, const Progress& progress = {});

// k+2 points on the sphere of an empty ball, k the dimension of the points: because of them there
// is another Delaunay triangulation. Nothing if there is only one. Requires: a Delaunay
// triangulation of the points. Book: Section 4.2.
std::optional<Simplex> cospherical_points_of_an_empty_ball(const PointSet& points,
                                                           const Triangulation& delaunay);

// With more vertices, gift-wrapping, which always answers, takes longer than inserting polygons.
inline constexpr std::size_t kFewVertices = 200;

// The canonical constrained Delaunay triangulation of a domain, or what shows that there is none,
// which happens in space alone. Requires: the complex is valid, of two or three dimensions. Book:
// Sections 3.11, 5.6 and 5.8.
tl::expected<PlcTriangulation, NoCdt> canonical_cdt(const PiecewiseLinearComplex& complex);

}  // namespace circumspect::reference
