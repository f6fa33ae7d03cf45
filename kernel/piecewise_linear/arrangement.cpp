#include "kernel/piecewise_linear/arrangement.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "kernel/piecewise_linear/validity.hpp"

namespace circumspect {
namespace {

using Ends = std::pair<Point, Point>;

// The cross product in space; in the plane, the single number that replaces it.
Point normal_of(const Point& a, const Point& b) {
  return a.size() == 3 ? cross_product(a, b) : Point{cross_product(a, b, 0, 1)};
}

// Does p lie inside the segment? Points of a line are in lexicographic order along it.
bool lies_inside(const Point& p, const Ends& segment) {
  const auto& [a, b] = segment;
  return a < p && p < b && sign(squared_length(normal_of(b - a, p - a))) == 0;
}

// The common point of two segments that are not parallel, if there is one.
std::optional<Point> common_point(const Ends& s, const Ends& t) {
  const Point along_s = s.second - s.first;
  const Point along_t = t.second - t.first;
  const Point between = t.first - s.first;
  const Point normal = normal_of(along_s, along_t);
  const Rational area = squared_length(normal);
  if (sign(area) == 0) return std::nullopt;
  const bool are_skew = normal.size() == 3 && sign(inner_product(normal, between)) != 0;
  if (are_skew) return std::nullopt;
  const Rational on_s = inner_product(normal_of(between, along_t), normal) / area;
  const Rational on_t = inner_product(normal_of(between, along_s), normal) / area;
  const bool meet = sign(on_s) >= 0 && on_s <= 1 && sign(on_t) >= 0 && on_t <= 1;
  return meet ? std::optional(s.first + on_s * along_s) : std::nullopt;
}

// The vertices of an arrangement, without repetition.
class Vertices {
 public:
  // False: it was already there.
  bool add(const Point& point) {
    const bool is_new = place_of_.emplace(point, static_cast<Vertex>(points_.size())).second;
    if (is_new) points_.push_back(point);
    return is_new;
  }
  const std::vector<Point>& points() const { return points_; }
  Vertex at(const Point& point) const { return place_of_.at(point); }

  // The path from one to the other through every vertex between them.
  std::vector<Vertex> path(Vertex from, Vertex to) const {
    const Ends ends = std::minmax(point(from), point(to));
    std::set<Point> on = {ends.first, ends.second};
    for (const Point& p : points_) {
      if (lies_inside(p, ends)) on.insert(p);
    }
    std::vector<Vertex> path;
    for (const Point& p : on) path.push_back(at(p));
    if (path.front() != from) std::reverse(path.begin(), path.end());
    return path;
  }

 private:
  const Point& point(Vertex v) const { return points_[static_cast<std::size_t>(v)]; }

  std::vector<Point> points_;
  std::map<Point, Vertex> place_of_;
};

// The pieces of a segment of two vertices.
std::set<std::pair<Vertex, Vertex>> pieces(const Vertices& vertices, Vertex a, Vertex b) {
  std::set<std::pair<Vertex, Vertex>> pieces;
  const std::vector<Vertex> path = vertices.path(a, b);
  for (std::size_t i = 1; i < path.size(); ++i) pieces.insert(std::minmax(path[i - 1], path[i]));
  return pieces;
}

// The lines of a polygon, cut. A line with two vertices left is a segment.
PolygonLines cut(const PolygonLines& polygon, const std::vector<Vertex>& place,
                 const Vertices& vertices) {
  PolygonLines result;
  result.hole_seeds = polygon.hole_seeds;
  for (const std::vector<Vertex>& line : polygon.lines) {
    std::vector<Vertex> corners;
    for (const Vertex v : line) {
      const Vertex corner = place[static_cast<std::size_t>(v)];
      if (corners.empty() || corners.back() != corner) corners.push_back(corner);
    }
    while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
    if (corners.size() == 2) {
      for (const auto& [a, b] : pieces(vertices, corners[0], corners[1])) {
        result.lines.push_back({a, b});
      }
      continue;
    }
    std::vector<Vertex> whole;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto path = vertices.path(corners[i], corners[(i + 1) % corners.size()]);
      whole.insert(whole.end(), path.begin(), path.size() == 1 ? path.end() : path.end() - 1);
    }
    result.lines.push_back(std::move(whole));
  }
  return result;
}

PiecewiseLinearInput cut(const PiecewiseLinearInput& input, const std::vector<Vertex>& place,
                         const Vertices& vertices) {
  PiecewiseLinearInput result;
  result.points = vertices.points();
  result.hole_seeds = input.hole_seeds;
  result.kind = input.kind;
  std::set<std::pair<Vertex, Vertex>> parts;
  for (const std::vector<Vertex>& segment : input.segments) {
    parts.merge(pieces(vertices, place[static_cast<std::size_t>(segment[0])],
                       place[static_cast<std::size_t>(segment[1])]));
  }
  for (const auto& [a, b] : parts) result.segments.push_back({a, b});
  for (const PolygonLines& polygon : input.polygons) {
    result.polygons.push_back(cut(polygon, place, vertices));
  }
  return result;
}

}  // namespace

PiecewiseLinearInput arranged(const PiecewiseLinearInput& input) {
  Vertices vertices;
  std::vector<Vertex> place;  // for each vertex of the input
  for (const Point& point : input.points) {
    vertices.add(point);
    place.push_back(vertices.at(point));
  }
  std::set<Ends> segments;
  for (const Simplex& segment : segments_of(input)) {
    const Point& a = input.points[static_cast<std::size_t>(segment[0])];
    const Point& b = input.points[static_cast<std::size_t>(segment[1])];
    if (a != b) segments.insert(std::minmax(a, b));
  }
  // Collinear segments that overlap are each cut at the ends of the other, which are vertices.
  for (auto s = segments.begin(); s != segments.end(); ++s) {
    for (auto t = std::next(s); t != segments.end(); ++t) {
      if (const auto point = common_point(*s, *t)) vertices.add(*point);
    }
  }
  while (true) {
    PiecewiseLinearInput result = cut(input, place, vertices);
    const bool is_planar = !input.points.empty() && input.points.front().size() == 2;
    if (result.polygons.empty() || is_planar) return result;
    // Segments are compared with polygons after everything else about both is settled.
    bool has_more = false;
    const auto valid = validated(result, 0);
    for (const Breach& breach : valid ? std::vector<Breach>{} : valid.error()) {
      if (breach.kind != BreachKind::kSegmentPiercesPolygon) continue;
      has_more = vertices.add(*breach.point) || has_more;
    }
    if (!has_more) return result;
  }
}

}  // namespace circumspect
