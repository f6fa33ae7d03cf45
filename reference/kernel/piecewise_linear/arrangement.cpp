#include "reference/kernel/piecewise_linear/arrangement.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace circumspect {
namespace {

using Ends = std::pair<Point, Point>;

Rational determinant_of(const Point& a, const Point& b) { return a[0] * b[1] - a[1] * b[0]; }

// Does p lie inside the segment? Along a line the lexicographic order is that of the points of the line.
bool lies_inside(const Point& p, const Ends& segment) {
  const auto& [a, b] = segment;
  return a < p && p < b && sign(determinant_of(b - a, p - a)) == 0;
}

// The one point that two segments which are not parallel have in common, if they have one.
std::optional<Point> common_point(const Ends& s, const Ends& t) {
  const Point along_s = s.second - s.first;
  const Point along_t = t.second - t.first;
  const Rational area = determinant_of(along_s, along_t);
  if (sign(area) == 0) return std::nullopt;
  const Rational on_s = determinant_of(t.first - s.first, along_t) / area;
  const Rational on_t = determinant_of(t.first - s.first, along_s) / area;
  const bool meet = sign(on_s) >= 0 && on_s <= 1 && sign(on_t) >= 0 && on_t <= 1;
  return meet ? std::optional(s.first + on_s * along_s) : std::nullopt;
}

}  // namespace

PiecewiseLinearInput arranged(const PiecewiseLinearInput& input) {
  assert(input.polygons.empty());
  PiecewiseLinearInput result;
  result.hole_seeds = input.hole_seeds;
  result.kind = input.kind;
  std::map<Point, Vertex> place_of;
  const auto add = [&](const Point& point) {
    const bool is_new = place_of.emplace(point, static_cast<Vertex>(result.points.size())).second;
    if (is_new) result.points.push_back(point);
  };
  for (const Point& point : input.points) add(point);

  std::set<Ends> segments;
  for (const std::vector<Vertex>& segment : input.segments) {
    const Point& a = input.points[static_cast<std::size_t>(segment[0])];
    const Point& b = input.points[static_cast<std::size_t>(segment[1])];
    if (a != b) segments.insert(std::minmax(a, b));
  }
  // Where segments of one line overlap, each is cut at the ends of the other, which are vertices.
  for (auto s = segments.begin(); s != segments.end(); ++s) {
    for (auto t = std::next(s); t != segments.end(); ++t) {
      if (const auto point = common_point(*s, *t)) add(*point);
    }
  }
  std::set<std::pair<Vertex, Vertex>> parts;
  for (const Ends& segment : segments) {
    std::set<Point> on = {segment.first, segment.second};
    for (const Point& point : result.points) {
      if (lies_inside(point, segment)) on.insert(point);
    }
    for (auto end = std::next(on.begin()); end != on.end(); ++end) {
      parts.insert(std::minmax(place_of.at(*std::prev(end)), place_of.at(*end)));
    }
  }
  for (const auto& [a, b] : parts) result.segments.push_back({a, b});
  return result;
}

}  // namespace circumspect
