#include "reference/constrained/steiner_cdt.hpp"

#include <limits>
#include <stdexcept>

#include "reference/constrained/cdt_by_polygon_insertion.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/constrained/planar_cdt.hpp"
#include "reference/constrained/segment_recovery.hpp"

namespace circumspect::constrained {
namespace {

template <typename Expected>
PlcTriangulation value_of(Expected result) {
  if (!result) throw std::logic_error("an edge-protected complex has a CDT");
  return *std::move(result);
}

}  // namespace

PlcTriangulation cdt_of_edge_protected(const PiecewiseLinearComplex& complex,
                                       CdtAlgorithm algorithm, const Progress& progress) {
  if (complex.ambient_dimension() == 2) {
    return planar_cdt(complex, PlanarAlgorithm::kSegmentInsertion);
  }
  switch (algorithm) {
    case CdtAlgorithm::kGiftWrapping:
      return value_of(gift_wrapping_cdt(complex, progress));
    case CdtAlgorithm::kPolygonFlips:
      return value_of(cdt_by_polygon_insertion(complex, {PolygonInsertion::kFlips, {}, progress}));
    case CdtAlgorithm::kPolygonCavities:
      return value_of(
          cdt_by_polygon_insertion(complex, {PolygonInsertion::kCavities, {}, progress}));
  }
  throw std::logic_error("no such algorithm");
}

SteinerCdt steiner_cdt(const PiecewiseLinearComplex& complex, CdtAlgorithm algorithm) {
  return *steiner_cdt(complex, algorithm, std::numeric_limits<std::size_t>::max());
}

tl::expected<SteinerCdt, SteinerLimitReached> steiner_cdt(const PiecewiseLinearComplex& complex,
                                                          CdtAlgorithm algorithm,
                                                          std::size_t most_steiner_points,
                                                          const Progress& progress) {
  if (complex.ambient_dimension() == 2) return SteinerCdt{complex, planar_cdt(complex), {}};
  auto recovered = recover_segments(complex, most_steiner_points, progress);
  if (!recovered) return tl::unexpected(recovered.error());
  PlcTriangulation triangulation = cdt_of_edge_protected(recovered->complex, algorithm, progress);
  return SteinerCdt{std::move(recovered->complex), std::move(triangulation),
                    std::move(recovered->steiner_points)};
}

}  // namespace circumspect::constrained
