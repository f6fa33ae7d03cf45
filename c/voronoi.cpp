// circumspect_check_voronoi.
#include <cstddef>

#include <fmt/format.h>

#include "c/demands.hpp"
#include "c/guard.hpp"
#include "c/input.hpp"
#include "c/kept_verdict.hpp"
#include "oracle/judge/voronoi/judge_structure.hpp"
#include "oracle/judge/voronoi/judge_voronoi.hpp"

namespace circumspect::c {
namespace {

std::vector<Point> points_of(const double* coordinates, std::int64_t count, std::int64_t dimension,
                             const char* what) {
  require_count(count, what);
  array(coordinates, product(count, dimension, what), what);
  return exact_points(count, dimension, coordinates, nullptr);
}

struct Names {
  const char *starts, *corners;
};
std::vector<ListedCell> cells_of(std::int64_t count, const std::int64_t* cell_starts,
                                 const std::int64_t* cell_corners, const Names& names) {
  const auto all = static_cast<std::size_t>(count);
  const auto starts = array(cell_starts, all + 1, names.starts);
  for (std::size_t s = 0; s < all; ++s) {
    if (starts[0] != 0 || starts[s + 1] < starts[s]) {
      refuse_call(fmt::format("expected {} that ascend from 0, found others", names.starts));
    }
  }
  const auto corners = array(cell_corners, static_cast<std::size_t>(starts[all]), names.corners);
  std::vector<ListedCell> cells(all);
  for (std::size_t s = 0; s < all; ++s) {
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
  diagram.cells =
      cells_of(given.site_count, given.cell_starts, given.corners, {"cell_starts", "corners"});
  require_count(given.ridge_count, "ridges");
  if (given.ridge_starts != nullptr) {
    diagram.ridges = cells_of(given.ridge_count, given.ridge_starts, given.ridge_ends,
                              {"ridge_starts", "ridge_ends"});
  }
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
        *c::required(diagram, "a diagram"), CIRCUMSPECT_VORONOI,
        {offsetof(circumspect_voronoi, ridge_starts)}, "CIRCUMSPECT_VORONOI");
    const circumspect_options asked = c::asked_of(options);
    check::Options own = c::options_of(asked);
    c::set_demands(asked.demands, Claim::kVoronoi, own);
    const Rational distance = asked.within == nullptr ? Rational(0) : c::distance_of(asked.within);
    const VoronoiDiagram listed = c::diagram_of(given);
    const std::optional<JudgedBox> box = c::box_of(given);
    std::string fault = check::fault_of_diagram(listed, box);
    if (fault.empty() && own.structure) fault = check::fault_of_structure(listed);
    if (!fault.empty()) c::refuse_input(fault);
    const Verdict found =
        check::judge_voronoi(listed, box, distance * distance, own.by == check::By::kDefinition,
                             own.max_violations, own.structure);
    *verdict = c::kept_verdict(found, in_rows({listed.sites, {}}), nullptr, asked, own.by, {});
  });
}
