#include "oracle/judge/domain/vertex_search.hpp"

#include <algorithm>
#include <utility>

#include "kernel/exact/each_once.hpp"

namespace circumspect::check {

namespace {

// A long segment that runs aslant has a box that holds much of the mesh, its pieces have not.
constexpr int kPieces = 32;
// The first radius is this many doublings below the last.
constexpr int kDoublings = 24;
constexpr int kDoublingsAtOnce = 2;

Rational power_of_two(int exponent) {
  Rational power = 1;
  for (int i = 0; i < exponent; ++i) power *= 2;
  return power;
}

}  // namespace

// A point, or a segment in pieces.
struct VertexSearch::Target {
  std::vector<Point> points;
  bool is_point() const { return points.size() == 1; }

  Rational squared_distance_to(const Point& p) const {
    return is_point() ? squared_distance(points.front(), p)
                      : squared_distance_to_segment(p, points.front(), points.back());
  }

  // Boxes that hold every point within a distance of it.
  std::vector<Box> boxes_around(const Rational& radius) const {
    std::vector<Box> ends;
    for (const Point& point : points) ends.push_back(cube(point, radius));
    if (is_point()) return ends;
    std::vector<Box> pieces;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      pieces.push_back(box_around(ends[i], ends[i + 1]));
    }
    return pieces;
  }
};

std::optional<NearestVertex> VertexSearch::to_point(const Point& point) {
  return nearest_to({{point}});
}

std::optional<NearestVertex> VertexSearch::to_segment(const Point& a, const Point& b) {
  Target target{{a}};
  for (int i = 1; i < kPieces; ++i) {
    target.points.push_back(a + Rational(i) / kPieces * (b - a));
  }
  target.points.push_back(b);
  return nearest_to(target);
}

void VertexSearch::make_index() {
  std::vector<Box> boxes;
  for (Vertex v = 0; mesh_.points.names(v); ++v) {
    if (!used_[static_cast<std::size_t>(v)]) continue;
    const Point& point = mesh_.points[v];
    if (indexed_.empty()) low_ = high_ = point;
    for (std::size_t i = 0; i < point.size(); ++i) {
      low_[i] = std::min(low_[i], point[i]);
      high_[i] = std::max(high_[i], point[i]);
    }
    boxes.push_back(box_around(point));
    indexed_.push_back(v);
  }
  index_ = std::make_unique<const BoxIndex>(boxes);
}

// The vertex in some boxes that is nearest to the target, but not on it if that is a segment.
std::optional<NearestVertex> VertexSearch::best_of(const Target& target,
                                                   const std::vector<Box>& boxes) {
  std::vector<std::size_t> places;
  for (const Box& box : boxes) {
    const std::vector<std::size_t> more = index_->meeting(box);
    places.insert(places.end(), more.begin(), more.end());
  }
  keep_each_once(places);
  std::optional<NearestVertex> best;
  for (const std::size_t place : places) {
    if (++looked_at_ > kMostLookedAt) return std::nullopt;
    const Vertex v = indexed_[place];
    Rational squared = target.squared_distance_to(mesh_.points[v]);
    if (squared == 0 && !target.is_point()) continue;
    if (!best || squared < best->squared_distance) best = {v, std::move(squared)};
  }
  return best;
}

// In growing neighbourhoods: what is found within one's radius cannot be beaten outside it.
std::optional<NearestVertex> VertexSearch::nearest_to(const Target& target) {
  if (index_ == nullptr) make_index();
  if (indexed_.empty()) return std::nullopt;
  // No vertex is further than this from the target along any axis, nor twice this in all.
  Rational furthest = 0;
  for (const Point& end : {target.points.front(), target.points.back()}) {
    for (std::size_t i = 0; i < end.size(); ++i) {
      furthest = std::max({furthest, Rational(abs(Rational(end[i] - low_[i]))),
                           Rational(abs(Rational(end[i] - high_[i])))});
    }
  }
  Rational radius = 2 * furthest / power_of_two(kDoublings);
  for (int doubled = 0; doubled <= kDoublings; doubled += kDoublingsAtOnce) {
    const auto best = best_of(target, target.boxes_around(radius));
    if (looked_at_ > kMostLookedAt) return std::nullopt;
    if (best && best->squared_distance <= radius * radius) return best;
    radius *= power_of_two(kDoublingsAtOnce);
  }
  return std::nullopt;
}

}  // namespace circumspect::check
