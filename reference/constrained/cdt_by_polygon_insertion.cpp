#include "reference/constrained/cdt_by_polygon_insertion.hpp"

#include <cassert>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "kernel/exact/progress.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "reference/constrained/cavity.hpp"
#include "reference/constrained/evolving_cdt.hpp"
#include "reference/constrained/flip_insert_polygon.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/constrained/plc_triangulation.hpp"

namespace circumspect::constrained {
namespace {

std::optional<NoChange> insert(const PointSet& points, EvolvingCdt& cdt, const Polygon& polygon,
                               PolygonInsertion by, std::vector<PolygonFlips>* runs) {
  if (by == PolygonInsertion::kCavities) return insert_polygon_by_cavity(points, cdt, polygon);
  auto run = flip_insert_polygon(points, cdt, polygon);
  if (!run) return run.error();
  if (runs != nullptr) runs->push_back(*std::move(run));
  return std::nullopt;
}

}  // namespace

tl::expected<EvolvingCdt, NoPolygonInsertion> hull_cdt_by_polygon_insertion(
    const PiecewiseLinearComplex& complex, const PolygonInsertionOptions& options,
    std::vector<PolygonFlips>* runs) {
  EvolvingCdt cdt = evolving_delaunay(complex.points, options.progress);
  for (const Simplex& segment : complex.segments) {
    if (cdt.tetrahedra.star(segment).empty()) {
      return tl::unexpected(
          NoPolygonInsertion{{WhyNoChange::kSegmentMissing, segment}, std::nullopt});
    }
    cdt.segments.insert(segment);
  }
  std::vector<std::size_t> order = options.order;
  if (order.empty()) {
    order.resize(complex.polygons.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
  }
  assert(order.size() == complex.polygons.size());
  std::size_t done = 0;
  for (const std::size_t i : order) {
    tell(options.progress, "polygons inserted", done++, order.size());
    const auto wrong = insert(complex.points, cdt, complex.polygons[i], options.by, runs);
    if (wrong) return tl::unexpected(NoPolygonInsertion{*wrong, i});
  }
  return cdt;
}

tl::expected<PlcTriangulation, NoPolygonInsertion> cdt_by_polygon_insertion(
    const PiecewiseLinearComplex& complex, const PolygonInsertionOptions& options,
    std::vector<PolygonFlips>* runs) {
  assert(complex.points.empty() || complex.ambient_dimension() == 3);
  if (complex.points.dimension() < 3) return gift_wrapping_cdt(complex).value();  // Planar CDTs.
  const auto cdt = hull_cdt_by_polygon_insertion(complex, options, runs);
  if (!cdt) return tl::unexpected(cdt.error());
  return carve(complex, *cdt);
}

EvolvingCdt evolving_cdt(const PiecewiseLinearComplex& complex, const PlcTriangulation& cdt) {
  assert(complex.kind == DomainKind::kHull && complex.points.dimension() == 3);
  EvolvingCdt evolving{
      StarIndex(cdt.simplices), {complex.segments.begin(), complex.segments.end()}, {}};
  for (const Polygon& polygon : complex.polygons) {
    evolving.walls.merge(
        facets_included_in(evolving.tetrahedra, PolygonInSpace(complex.points, polygon)));
  }
  return evolving;
}

}  // namespace circumspect::constrained
