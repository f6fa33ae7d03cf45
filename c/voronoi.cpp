// circumspect_check_voronoi.
#include <fmt/format.h>

#include "c/guard.hpp"
#include "c/input.hpp"
#include "c/kept_verdict.hpp"
#include "oracle/judge/voronoi/judge_voronoi.hpp"

namespace circumspect::c {
namespace {

std::vector<Point> points_of(const double* coordinates, std::int64_t count, std::int64_t dimension,
                             const char* what) {
  require_count(count, what);
  array(coordinates, product(count, dimension, what), what);
  return exact_points(count, dimension, coordinates, nullptr);
}

std::vector<ListedCell> cells_of(const circumspect_voronoi& given) {
  const auto sites = static_cast<std::size_t>(given.site_count);
  const auto starts = array(given.cell_starts, sites + 1, "cell_starts");
  for (std::size_t s = 0; s < sites; ++s) {
    if (starts[0] != 0 || starts[s + 1] < starts[s]) {
      refuse_call("expected cell_starts that ascend from 0, found others");
    }
  }
  const auto corners = array(given.corners, static_cast<std::size_t>(starts[sites]), "corners");
  std::vector<ListedCell> cells(sites);
  for (std::size_t s = 0; s < sites; ++s) {
    for (std::int64_t i = starts[s]; i < starts[s + 1]; ++i) {
      const Vertex v = corners[static_cast<std::size_t>(i)];
      if (v == -1) {
        cells[s].is_unbounded = true;
      } else {
        cells[s].corners.push_back(v);
      }
    }
  }
  return cells;
}

VoronoiDiagram diagram_of(const circumspect_voronoi& given) {
  require_dimension(given.dimension, 2, 3);
  std::vector<Point> sites = points_of(given.sites, given.site_count, given.dimension, "sites");
  const std::vector<Duplicate> repeated = duplicates(sites);
  if (!repeated.empty()) refuse_equal_points(repeated);
  VoronoiDiagram diagram{PointSet(std::move(sites))};
  diagram.vertices = points_of(given.vertices, given.vertex_count, given.dimension, "vertices");
  diagram.cells = cells_of(given);
  require_count(given.ridge_count, "ridges");
  const auto pairs = array(given.ridges, product(given.ridge_count, 2, "ridges"), "ridges");
  for (std::size_t i = 0; i + 1 < pairs.size(); i += 2) {
    diagram.neighbors.push_back({pairs[i], pairs[i + 1]});
  }
  return diagram;
}

std::optional<JudgedBox> box_of(const circumspect_voronoi& given) {
  if (given.box == nullptr) return std::nullopt;
  std::vector<Point> ends = points_of(given.box, 2, given.dimension, "box");
  return JudgedBox{std::move(ends[0]), std::move(ends[1])};
}

}  // namespace
}  // namespace circumspect::c

using namespace circumspect;

circumspect_status circumspect_check_voronoi(const circumspect_voronoi* diagram,
                                             const circumspect_options* options,
                                             circumspect_verdict** verdict) {
  if (verdict != nullptr) *verdict = nullptr;
  return c::guarded([&] {
    c::required(verdict, "a place for the verdict");
    const circumspect_voronoi given = c::of_any_version<circumspect_voronoi>(
        *c::required(diagram, "a diagram"), CIRCUMSPECT_VORONOI, {}, "CIRCUMSPECT_VORONOI");
    const circumspect_options asked = c::asked_of(options);
    const check::Options own = c::options_of(asked);
    const Rational distance = asked.within == nullptr ? Rational(0) : c::distance_of(asked.within);
    const VoronoiDiagram listed = c::diagram_of(given);
    const std::optional<JudgedBox> box = c::box_of(given);
    const std::string fault = check::fault_of_diagram(listed, box);
    if (!fault.empty()) c::refuse_input(fault);
    const Verdict found = check::judge_voronoi(
        listed, box, distance * distance, own.by == check::By::kDefinition, own.max_violations);
    *verdict = c::kept_verdict(found, in_rows({listed.sites, {}}), nullptr, asked, own.by, {});
  });
}
