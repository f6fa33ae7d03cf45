#include "oracle/judge/voronoi/clipped_cell.hpp"

#include <algorithm>
#include <iterator>

namespace circumspect::check {
namespace {

using Places = std::vector<std::size_t>;

Places common(const Places& a, const Places& b) {
  Places both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

}  // namespace

ClippedCell::ClippedCell(const JudgedBox& box) : halves_(2 * box.low.size()) {
  const std::size_t d = box.low.size();
  for (std::size_t which = 0; which < std::size_t{1} << d; ++which) {
    Corner corner{box.low, {}};
    for (std::size_t axis = 0; axis < d; ++axis) {
      const bool is_high = (which >> axis & 1) != 0;
      if (is_high) corner.point[axis] = box.high[axis];
      corner.boundaries.push_back(2 * axis + (is_high ? 0 : 1));
    }
    corners_.push_back(corner);
  }
}

bool ClippedCell::have_common_edge(const Corner& a, const Corner& b) const {
  const Places both = common(a.boundaries, b.boundaries);
  if (both.size() + 1 < a.point.size()) return false;
  return std::none_of(corners_.begin(), corners_.end(), [&](const Corner& other) {
    return &other != &a && &other != &b &&
           std::includes(other.boundaries.begin(), other.boundaries.end(), both.begin(),
                         both.end());
  });
}

void ClippedCell::cut(const definition::Halfspace& half) {
  std::vector<Rational> depths;
  for (const Corner& corner : corners_) {
    depths.push_back(half.offset - inner_product(half.normal, corner.point));
  }
  const std::size_t own = halves_++;
  std::vector<Corner> kept;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    if (sign(depths[i]) < 0) continue;
    kept.push_back(corners_[i]);
    if (sign(depths[i]) == 0) kept.back().boundaries.push_back(own);
  }
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    for (std::size_t j = 0; j < corners_.size(); ++j) {
      if (sign(depths[i]) <= 0 || sign(depths[j]) >= 0) continue;
      if (!have_common_edge(corners_[i], corners_[j])) continue;
      const Rational part = depths[i] / (depths[i] - depths[j]);
      Corner cut{corners_[i].point + part * (corners_[j].point - corners_[i].point),
                 common(corners_[i].boundaries, corners_[j].boundaries)};
      cut.boundaries.push_back(own);
      kept.push_back(cut);
    }
  }
  corners_ = std::move(kept);
}

std::vector<Point> ClippedCell::corners() const {
  std::vector<Point> points;
  for (const Corner& corner : corners_) points.push_back(corner.point);
  std::sort(points.begin(), points.end());
  return points;
}

Rational ClippedCell::largest_squared_distance(const Point& from) const {
  Rational largest = 0;
  for (const Corner& corner : corners_) {
    largest = std::max(largest, squared_distance(from, corner.point));
  }
  return largest;
}

}  // namespace circumspect::check
