#include "reference/constructions.hpp"

#include <utility>

#include "reference/constrained/cdt_by_polygon_insertion.hpp"
#include "reference/constrained/planar_cdt.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/genericity.hpp"

namespace circumspect::reference {

Triangulation canonical_delaunay(const PointSet& points, const Progress& progress) {
  return delaunay::bowyer_watson(points, {.order = delaunay::InsertionOrder::kBrioHilbert,
                                          .location = delaunay::PointLocation::kWalking,
                                          .progress = progress});
}

std::optional<Simplex> cospherical_points_of_an_empty_ball(const PointSet& points,
                                                           const Triangulation& delaunay) {
  return delaunay::cospherical_points_of_an_empty_ball(points, delaunay);
}

tl::expected<PlcTriangulation, NoCdt> canonical_cdt(const PiecewiseLinearComplex& complex) {
  if (complex.ambient_dimension() == 2) return constrained::planar_cdt(complex);
  if (complex.points.size() > kFewVertices) {
    auto inserted = constrained::cdt_by_polygon_insertion(complex);
    if (inserted) return *std::move(inserted);
  }
  return constrained::gift_wrapping_cdt(complex);
}

}  // namespace circumspect::reference
