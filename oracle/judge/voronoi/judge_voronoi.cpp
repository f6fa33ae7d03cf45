#include "oracle/judge/voronoi/judge_voronoi.hpp"

#include <algorithm>

#include "kernel/exact/number_text.hpp"
#include "oracle/judge/definition/distance.hpp"
#include "oracle/judge/definition/voronoi.hpp"
#include "oracle/judge/voronoi/clipped_cell.hpp"
#include "oracle/judge/voronoi/judge_structure.hpp"
#include "oracle/judge/voronoi/listed_cell.hpp"
#include "oracle/judge/voronoi/nearest_in_hull.hpp"
#include "oracle/judge/voronoi/sites_around.hpp"
#include "oracle/judge/voronoi/structure_by_corners.hpp"

namespace circumspect::check {
namespace {

using definition::FarthestCorner;

class VoronoiJudge {
 public:
  VoronoiJudge(const VoronoiDiagram& diagram, const JudgedBox& box, bool by_definition,
               Verdict& verdict)
      : diagram_(diagram), box_(box), by_definition_(by_definition), verdict_(verdict) {
    if (!by_definition) around_.emplace(diagram.sites, box);
  }

  void judge_cells(const Rational& squared_distance) {
    for (Vertex site = 0; diagram_.sites.names(site); ++site) {
      if (names_vertices(site)) compare(site, exact_corners(site), squared_distance);
    }
  }

  void judge_cells_vertices_and_ridges(const Rational& squared_distance) {
    if (by_definition_) {
      judge_cells(squared_distance);
      judge_structure(diagram_, box_, squared_distance,
                      definition::exact_structure(diagram_.sites, box_), true, verdict_);
      return;
    }
    std::vector<std::vector<Point>> cells;
    for (Vertex site = 0; diagram_.sites.names(site); ++site) {
      cells.push_back(exact_corners(site));
      if (names_vertices(site)) compare(site, cells.back(), squared_distance);
    }
    judge_structure(diagram_, box_, squared_distance, structure_by_corners(diagram_.sites, cells),
                    false, verdict_);
  }

 private:
  bool names_vertices(Vertex site) {
    for (const Vertex v : diagram_.cells[static_cast<std::size_t>(site)].corners) {
      if (v >= 0 && v < std::ssize(diagram_.vertices)) continue;
      verdict_.add(
          Rule::kVoronoiUnknownVertex,
          {.vertices = {site}, .values = {{"index among the finite vertices, from 0", v}}});
      return false;
    }
    return true;
  }

  std::vector<Point> exact_corners(Vertex site) const {
    return by_definition_ ? definition::exact_corners(diagram_.sites, site, box_)
                          : around_->corners_of_cell(site);
  }

  void compare(Vertex site, const std::vector<Point>& exact, const Rational& allowed) {
    const std::vector<Point> listed = by_definition_
                                          ? definition::listed_corners(diagram_, site, box_)
                                          : corners_of_listed(diagram_, site, box_);
    if (listed.empty() && exact.empty()) return;
    if (listed.empty()) {
      verdict_.add(Rule::kCellMissing, {.vertices = {site}, .point = exact.front()});
      return;
    }
    if (exact.empty()) {
      verdict_.add(Rule::kCellDiffers, {.vertices = {site}, .point = listed.front()});
      return;
    }
    const auto to_hull = [this](const Point& q, const std::vector<Point>& points) {
      return by_definition_ ? definition::squared_distance_between({q}, points)
                            : squared_distance_to_hull(q, points);
    };
    const FarthestCorner farthest = definition::farthest_corner(listed, exact, to_hull);
    VoronoiFacts& facts = *verdict_.voronoi;
    if (farthest.squared_distance > facts.squared_distance) {
      facts.squared_distance = farthest.squared_distance;
      facts.site = site;
    }
    if (farthest.squared_distance <= allowed) return;
    verdict_.add(Rule::kCellDiffers,
                 {.vertices = {site},
                  .values = {{farthest.is_listed
                                  ? "squared distance of this listed corner from the Voronoi cell"
                                  : "squared distance of this exact corner from the listed cell",
                              farthest.squared_distance}},
                  .rounded = {{"distance", square_root_to_decimal(farthest.squared_distance)}},
                  .point = farthest.corner});
  }

  const VoronoiDiagram& diagram_;
  const JudgedBox& box_;
  bool by_definition_;
  Verdict& verdict_;
  std::optional<SitesAround> around_;
};

}  // namespace

std::string fault_of_diagram(const VoronoiDiagram& diagram, const std::optional<JudgedBox>& box) {
  const std::size_t d = diagram.sites.ambient_dimension();
  if (diagram.sites.empty()) return "expected sites, found none";
  if (d != 2 && d != 3) {
    return "expected sites in the plane or in space for the claim voronoi, found dimension " +
           std::to_string(d);
  }
  if (diagram.cells.size() != diagram.sites.size()) {
    return "expected a cell for each of " + std::to_string(diagram.sites.size()) +
           " sites, found " + std::to_string(diagram.cells.size()) + " cells";
  }
  const auto has_other_dimension = [d](const Point& point) { return point.size() != d; };
  if (std::any_of(diagram.vertices.begin(), diagram.vertices.end(), has_other_dimension)) {
    return "expected vertices of dimension " + std::to_string(d) + ", as the sites, found another";
  }
  const auto is_unbounded = [](const ListedCell& cell) { return cell.is_unbounded; };
  if (diagram.neighbors.empty() && diagram.sites.size() > 1 &&
      std::any_of(diagram.cells.begin(), diagram.cells.end(), is_unbounded)) {
    return "expected the pairs of sites that have a common ridge beside unbounded cells, found "
           "none: run qvoronoi with both o and Fv";
  }
  for (const auto& [a, b] : diagram.neighbors) {
    if (!diagram.sites.names(a) || !diagram.sites.names(b)) {
      return "expected ridges between sites, found one of site " +
             std::to_string(diagram.sites.names(a) ? b : a);
    }
  }
  if (!box) return "";
  for (std::size_t axis = 0; axis < d; ++axis) {
    if (box->low.size() != d || box->low[axis] >= box->high[axis]) {
      return "expected a box with " + std::to_string(2 * d) +
             " numbers, the least and then the larger coordinates, found another";
    }
  }
  return "";
}

Verdict judge_voronoi(const VoronoiDiagram& diagram, const std::optional<JudgedBox>& box,
                      const Rational& squared_distance, bool by_definition,
                      std::size_t max_violations, bool has_structure) {
  Verdict verdict(Claim::kVoronoi, max_violations);
  verdict.points = diagram.sites.size();
  verdict.simplices = diagram.cells.size();
  verdict.dimension = diagram.sites.dimension();
  verdict.voronoi.emplace();
  const JudgedBox within = box ? *box : default_box(diagram.sites);
  VoronoiJudge judge(diagram, within, by_definition, verdict);
  if (has_structure) {
    judge.judge_cells_vertices_and_ridges(squared_distance);
  } else {
    judge.judge_cells(squared_distance);
  }
  return verdict;
}

}  // namespace circumspect::check
