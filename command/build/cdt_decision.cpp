#include "command/build/cdt_decision.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "command/options/option_rows.hpp"
#include "command/options/whole_number.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/complex/star_index.hpp"
#include "kernel/predicates/intersection.hpp"
#include "reference/constrained/cdt_by_polygon_insertion.hpp"
#include "reference/constrained/planar_cdt.hpp"
#include "reference/constrained/plc_triangulation.hpp"

namespace circumspect::cli {
namespace {

using constrained::PlcTriangulation;

// Those facets whose vertices all lie in the polygon.
std::vector<Simplex> facets_in(const Polygon& polygon, const std::vector<Simplex>& facets) {
  std::vector<Simplex> in_polygon;
  std::copy_if(facets.begin(), facets.end(), std::back_inserter(in_polygon),
               [&](const Simplex& facet) {
                 return std::includes(polygon.vertices.begin(), polygon.vertices.end(),
                                      facet.begin(), facet.end());
               });
  return in_polygon;
}

// The tetrahedra are those of a CDT. Where a polygon has some of the domain beside it, they tile
// it; elsewhere it dangles, and its planar CDT is as good as any. Segments bound these parts of a
// polygon, and no triangle of either kind crosses a segment: so a triangle of the planar CDT is in
// a tiled part iff its barycentre is in one of the tiles.
PlcTriangulation completed(const PiecewiseLinearComplex& complex, std::vector<Simplex> tetrahedra) {
  const std::vector<Simplex> facets = facets_of(tetrahedra);
  std::set<Simplex> faces(complex.segments.begin(), complex.segments.end());
  for (const Vertex v : all_vertices(complex.points)) faces.insert({v});
  for (const Polygon& polygon : complex.polygons) {
    const std::vector<Simplex> tiles = facets_in(polygon, facets);
    for (const Simplex& triangle : constrained::planar_cdt(complex.points, polygon)) {
      const Point middle = barycentre(complex.points, triangle);
      const bool is_tiled = std::any_of(tiles.begin(), tiles.end(), [&](const Simplex& tile) {
        return !intersection({middle}, coordinates(complex.points, tile)).empty();
      });
      if (!is_tiled) faces.insert(triangle);
    }
  }
  return constrained::with_dangling(std::move(tetrahedra), faces);
}

}  // namespace

double seconds_of_gift_wrapping(std::size_t vertices) {
  const auto n = static_cast<double>(vertices);
  return 1.5e-5 * n * n;
}

std::string_view word(CdtAnswer answer) {
  switch (answer) {
    case CdtAnswer::kCanonical:
      return "canonical";
    case CdtAnswer::kAnother:
      return "another";
    case CdtAnswer::kNone:
      return "none";
    case CdtAnswer::kUnknown:
      return "unknown";
  }
  return "";
}

existence::Limits existence_limits(const SearchLimits& limits) {
  return {.vertices = limits.vertices, .conflicts = limits.conflicts};
}

CdtDecision decide_cdt(const PiecewiseLinearComplex& complex, const SearchLimits& limits,
                       bool insert, const std::string& name, Output& output) {
  CdtDecision decision;
  const std::size_t vertices = complex.points.size();
  if (insert && vertices > reference::kFewVertices) {
    output.begin("inserting the polygons of " + name);
    auto inserted = constrained::cdt_by_polygon_insertion(
        complex, {constrained::PolygonInsertion::kFlips, {}, output.progress()});
    if (inserted) {
      decision.answer = CdtAnswer::kCanonical;
      decision.cdt = *std::move(inserted);
      return decision;
    }
  }
  if (limits.wrapped_vertices != 0 && vertices > limits.wrapped_vertices) {
    decision.limit = fmt::format("more than {} vertices", limits.wrapped_vertices);
    return decision;
  }
  output.begin("gift-wrapping " + name, seconds_of_gift_wrapping(vertices));
  auto canonical = constrained::gift_wrapping_cdt(complex, output.progress());
  if (canonical) {
    decision.answer = CdtAnswer::kCanonical;
    decision.cdt = *std::move(canonical);
    return decision;
  }
  decision.not_canonical = canonical.error();
  output.begin("searching for a CDT of " + name);
  existence::Existence any =
      existence::any_cdt(complex, Regions(complex), existence_limits(limits));
  if (auto* exists = std::get_if<existence::Exists>(&any)) {
    decision.answer = CdtAnswer::kAnother;
    decision.cdt = completed(complex, std::move(exists->tetrahedra));
  } else if (auto* impossible = std::get_if<existence::Impossible>(&any)) {
    decision.answer = CdtAnswer::kNone;
    decision.refutation = std::move(*impossible);
  } else {
    decision.limit = std::get<existence::Unknown>(any).limit;
  }
  return decision;
}

void add_search_options(CLI::App& command, SearchLimits& limits) {
  add_options(
      command,
      {{"--search-vertices", "N", into(limits.vertices, whole_number()),
        "If there is no canonical CDT, search for another one in domains of at most N vertices "
        "(default 60)"},
       {"--search-conflicts", "N", into(limits.conflicts, whole_number()),
        "Give up this search after N conflicts of the SAT solver (default 1000000; 0: never)"}});
}

}  // namespace circumspect::cli
