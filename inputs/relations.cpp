#include "inputs/relations.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "inputs/dice.hpp"
#include "inputs/in_doubles.hpp"
#include "inputs/set_parts.hpp"

namespace circumspect::generators {
namespace {

using Map = std::function<Point(const Point&)>;

// Another order of so many points, which depends only on their number.
std::vector<std::size_t> shuffled(std::size_t count) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  Dice dice(count);
  shuffle(order, dice);
  if (std::is_sorted(order.begin(), order.end())) std::reverse(order.begin(), order.end());
  return order;
}

// Does the map send each of these to doubles?
bool is_exact(const Map& map, const std::vector<Point>& points) {
  return std::all_of(points.begin(), points.end(), [&](const Point& point) {
    const Point moved = map(point);
    return std::all_of(moved.begin(), moved.end(), is_double);
  });
}

// The largest binary exponent e of a coordinate, |x| < 2^e; 0 if all are 0.
int largest_exponent(const std::vector<Point>& points) {
  std::optional<int> largest;
  for (const Point& point : points) {
    for (const Rational& x : point) {
      if (sign(x) == 0) continue;
      int exponent = 0;
      std::frexp(x.get_d(), &exponent);
      largest = std::max(largest.value_or(exponent), exponent);
    }
  }
  return largest.value_or(0);
}

// The map that moves all points of an input, which depends on the points; nothing if no such map is
// exact.
std::optional<Map> map_of(Relation relation, const std::vector<Point>& points) {
  if (points.empty()) return std::nullopt;
  const int top = largest_exponent(points);
  if (relation == Relation::kReflection) {
    return [](const Point& point) {
      Point turned = point;
      turned.front() = -turned.front();
      return turned;
    };
  }
  if (relation == Relation::kScaling) {
    constexpr long kShift = 17;
    const Rational factor = power_of_two(top > 0 ? -kShift : kShift);
    const Map scales = [factor](const Point& point) { return factor * point; };
    return is_exact(scales, points) ? std::optional(scales) : std::nullopt;
  }
  // The distance begins at four times their size, and shrinks until all stay doubles.
  constexpr int kMoves = 60;
  for (int exponent = top + 2; exponent > top - kMoves; --exponent) {
    const Map moves = [step = power_of_two(exponent)](const Point& point) {
      Point moved = point;
      moved.front() += step;
      return moved;
    };
    if (is_exact(moves, points)) return moves;
  }
  return std::nullopt;
}

void apply(const Map& map, std::vector<Point>& points) {
  std::transform(points.begin(), points.end(), points.begin(), map);
}

// The factor of weights: the square of the factor of lengths.
Rational weight_factor(const Map& map, std::size_t dimension) {
  Point unit(dimension, 0);
  unit.front() = 1;
  return squared_distance(map(unit), map(Point(dimension, 0)));
}

ComplexCase in_other_order(ComplexCase whole) {
  const std::vector<std::size_t> order = shuffled(whole.input.points.size());
  std::vector<Vertex> place_of(order.size());
  std::vector<Point> points;
  for (std::size_t place = 0; place < order.size(); ++place) {
    place_of[order[place]] = static_cast<Vertex>(place);
    points.push_back(whole.input.points[order[place]]);
  }
  whole.input.points = std::move(points);
  const auto renumber = [&](std::vector<Vertex>& cell) {
    for (Vertex& v : cell) v = place_of[static_cast<std::size_t>(v)];
  };
  for (auto& segment : whole.input.segments) renumber(segment);
  for (PolygonLines& polygon : whole.input.polygons) {
    for (auto& line : polygon.lines) renumber(line);
  }
  return whole;
}

}  // namespace

std::string_view name(Relation relation) {
  switch (relation) {
    case Relation::kOrder:
      return "order";
    case Relation::kTranslation:
      return "translation";
    case Relation::kReflection:
      return "reflection";
    case Relation::kScaling:
      return "scaling";
    case Relation::kRepetition:
      return "repetition";
  }
  return "";
}

std::optional<PointsCase> image(Relation relation, const PointsCase& set) {
  const std::size_t count = set.points.size();
  if (relation == Relation::kOrder) {
    return count < 2 ? std::nullopt : std::optional(chosen(set, shuffled(count)));
  }
  if (relation == Relation::kRepetition) {
    std::vector<std::size_t> places(count);
    std::iota(places.begin(), places.end(), std::size_t{0});
    for (std::size_t v = 0; v < count; v += 3) places.push_back(v);
    return count == 0 ? std::nullopt : std::optional(chosen(set, places));
  }
  const std::optional<Map> map = map_of(relation, set.points);
  if (!map) return std::nullopt;
  PointsCase moved = set;
  apply(*map, moved.points);
  const Rational factor = weight_factor(*map, set.points.front().size());
  for (Rational& weight : moved.weights) weight *= factor;
  if (!std::all_of(moved.weights.begin(), moved.weights.end(), is_double)) return std::nullopt;
  return moved;
}

std::optional<ComplexCase> image(Relation relation, const ComplexCase& whole) {
  if (relation == Relation::kRepetition || whole.input.points.size() < 2) return std::nullopt;
  if (relation == Relation::kOrder) return in_other_order(whole);
  ComplexCase moved = whole;
  std::vector<std::vector<Point>*> parts = {&moved.input.points, &moved.input.hole_seeds};
  for (PolygonLines& polygon : moved.input.polygons) parts.push_back(&polygon.hole_seeds);
  std::vector<Point> all;
  for (const std::vector<Point>* part : parts) all.insert(all.end(), part->begin(), part->end());
  const std::optional<Map> map = map_of(relation, all);
  if (!map) return std::nullopt;
  for (std::vector<Point>* part : parts) apply(*map, *part);
  return moved;
}

}  // namespace circumspect::generators
