#include "oracle/judge/voronoi/sites_around.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "oracle/judge/definition/voronoi.hpp"
#include "oracle/judge/voronoi/clipped_cell.hpp"

namespace circumspect::check {
namespace {

std::vector<Box> boxes_of(const PointSet& sites) {
  std::vector<Box> boxes;
  for (const Point& site : sites.points()) boxes.push_back(box_around(site));
  return boxes;
}

// Within which there are some sites, if they are spread evenly: any number is right.
Rational reach_of_some(const PointSet& sites, const JudgedBox& box) {
  Rational longest = 0;
  for (const Rational& edge : box.high - box.low) longest = std::max(longest, edge);
  const auto d = static_cast<double>(sites.ambient_dimension());
  const double a_side =
      std::max(1.0, std::floor(std::pow(static_cast<double>(sites.size()), 1 / d)));
  return longest / Rational(static_cast<long>(a_side));
}

}  // namespace

SitesAround::SitesAround(const PointSet& sites, const JudgedBox& box)
    : sites_(sites), box_(box), index_(boxes_of(sites)), first_reach_(reach_of_some(sites, box)) {}

std::vector<Point> SitesAround::corners_of_cell(Vertex site) const {
  ClippedCell cell(box_);
  std::vector<std::size_t> known;
  for (Rational reach = first_reach_;; reach *= 2) {
    std::vector<std::size_t> near = index_.meeting(cube(sites_[site], reach));
    std::vector<std::size_t> fresh;
    std::set_difference(near.begin(), near.end(), known.begin(), known.end(),
                        std::back_inserter(fresh));
    std::vector<std::pair<Rational, std::size_t>> in_order;
    for (const std::size_t other : fresh) {
      const auto j = static_cast<Vertex>(other);
      if (j != site) in_order.emplace_back(squared_distance(sites_[site], sites_[j]), other);
    }
    std::sort(in_order.begin(), in_order.end());
    Rational farthest = cell.largest_squared_distance(sites_[site]);
    for (const auto& [squared, other] : in_order) {
      if (squared > 4 * farthest) break;
      cell.cut(definition::nearer_to(sites_, site, static_cast<Vertex>(other)));
      farthest = cell.largest_squared_distance(sites_[site]);
    }
    if (4 * farthest <= reach * reach || near.size() == sites_.size()) return cell.corners();
    known = std::move(near);
  }
}

}  // namespace circumspect::check
