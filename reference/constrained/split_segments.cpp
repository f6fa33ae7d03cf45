#include "reference/constrained/split_segments.hpp"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <utility>

#include "kernel/piecewise_linear/cell_boxes.hpp"
#include "kernel/piecewise_linear/polygon_triangles.hpp"

namespace circumspect::constrained {

namespace {

Rational power_of_four(long exponent) {
  const Integer power = Integer(1) << static_cast<unsigned long>(2 * std::abs(exponent));
  return exponent >= 0 ? Rational(power) : Rational(Integer(1), power);
}

// The largest k with 4^k ≤ value. Requires: value > 0.
long logarithm_base_four(const Rational& value) {
  const long bits = static_cast<long>(bit_length(value.get_num())) -
                    static_cast<long>(bit_length(value.get_den()));
  long k = bits / 2 - 2;
  while (power_of_four(k + 1) <= value) ++k;
  return k;
}

BoxIndex boxes_of(const PiecewiseLinearComplex& complex) {
  const CellBoxes around(complex.points);
  std::vector<Box> boxes = around.of(complex.segments);
  boxes.insert(boxes.end(), around.of_vertices().begin(), around.of_vertices().end());
  return BoxIndex(boxes);
}

Vertex other_end(const Simplex& segment, Vertex end) {
  return segment[0] == end ? segment[1] : segment[0];
}

}  // namespace

ProtectingShells::ProtectingShells(const PiecewiseLinearComplex& complex)
    : complex_(complex), segments_at_(complex.points.size()), boxes_(boxes_of(complex)) {
  for (std::size_t i = 0; i < complex.segments.size(); ++i) {
    for (const Vertex end : complex.segments[i]) {
      segments_at_[static_cast<std::size_t>(end)].push_back(i);
    }
  }
}

bool ProtectingShells::is_acute(std::size_t segment, Vertex apex) const {
  return around(apex).acute.contains(segment);
}

Rational ProtectingShells::where_to_split(std::size_t segment, Vertex apex,
                                          const Rational& squared_length) const {
  const Apex& here = around(apex);
  const Simplex& ends = complex_.segments[segment];
  const Rational whole = squared_distance(complex_.points[ends[0]], complex_.points[ends[1]]);
  const Rational two_thirds = Rational(4, 9) * squared_length;
  const Rational squared_shell =
      power_of_four(std::max(logarithm_base_four(two_thirds), here.least_shell));
  // The least fraction numerator / 2^j that is not inside the shell, for rising j.
  const Rational low = squared_shell / whole;
  const Rational high = here.squared_width * low;
  assert(low <= 1);
  Rational fraction = 1;
  Rational step = 1;
  while (fraction * fraction > high) {
    step /= 2;
    const Rational smaller = fraction - step;
    if (smaller * smaller >= low) fraction = smaller;
  }
  assert(fraction * fraction * whole < squared_length);
  return fraction;
}

Rational ProtectingShells::squared_least_shell(Vertex apex) const {
  return power_of_four(around(apex).least_shell);
}

const ProtectingShells::Apex& ProtectingShells::around(Vertex apex) const {
  const auto [entry, is_new] = apexes_.try_emplace(apex);
  if (is_new) {
    measure_angles(apex, entry->second);
    entry->second.least_shell = logarithm_base_four(squared_distance_to_others(apex) / 16);
  }
  return entry->second;
}

// m is half-way between 1 and the least 1/cos² θ, but at most (9/8)².
void ProtectingShells::measure_angles(Vertex apex, Apex& around) const {
  const std::vector<std::size_t>& segments = segments_at_[static_cast<std::size_t>(apex)];
  std::vector<Point> directions;
  for (const std::size_t i : segments) {
    directions.push_back(complex_.points[other_end(complex_.segments[i], apex)] -
                         complex_.points[apex]);
  }
  around.squared_width = Rational(81, 64);
  bool is_narrow = false;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Rational product = inner_product(directions[i], directions[j]);
      if (sign(product) <= 0) continue;
      around.acute.insert({segments[i], segments[j]});
      const Rational inverse_squared_cosine =
          squared_length(directions[i]) * squared_length(directions[j]) / (product * product);
      assert(inverse_squared_cosine > 1);
      is_narrow = is_narrow || inverse_squared_cosine < 16;
      const Rational half_way = (1 + inverse_squared_cosine) / 2;
      around.squared_width = std::min(around.squared_width, half_way);
    }
  }
  if (!is_narrow) around.acute.clear();
}

// The squared distance to the nearest vertex or segment that does not end at the apex. The boxes to
// look at are those that come as near as the nearest vertex on a segment of the apex.
// Requires: a segment ends at the apex.
Rational ProtectingShells::squared_distance_to_others(Vertex apex) const {
  const Point& centre = complex_.points[apex];
  const std::vector<std::size_t>& own = segments_at_[static_cast<std::size_t>(apex)];
  assert(!own.empty());
  Rational least = -1;
  const auto take = [&](const Rational& distance) {
    if (sign(least) < 0 || distance < least) least = distance;
  };
  for (const std::size_t i : own) {
    take(squared_distance(centre, complex_.points[other_end(complex_.segments[i], apex)]));
  }
  Rational reach = 1;
  while (reach * reach < least) reach *= 2;
  while (reach * reach / 4 >= least) reach /= 2;
  for (const std::size_t place : boxes_.meeting(cube(centre, reach))) {
    if (place < complex_.segments.size()) {
      const Simplex& segment = complex_.segments[place];
      if (contains(segment, apex)) continue;
      take(squared_distance_to_segment(centre, complex_.points[segment[0]],
                                       complex_.points[segment[1]]));
    } else {
      const auto vertex = static_cast<Vertex>(place - complex_.segments.size());
      if (vertex != apex) take(squared_distance(centre, complex_.points[vertex]));
    }
  }
  return least;
}

namespace {

// The number in an open interval whose denominator is the least power of two; the first of these.
// Requires: 0 ≤ low < high.
Rational shortest_dyadic(const Rational& low, const Rational& high) {
  Rational below =
      0;  // the greatest multiple of the step that is at most `low`, if that is below 1
  Rational step = 1;
  while (below + step >= high) {
    step /= 2;
    if (below + step <= low) below += step;
  }
  return below + step;
}

}  // namespace

SplitSegments::SplitSegments(const PiecewiseLinearComplex& complex)
    : complex_(complex), shells_(complex) {
  for (const Simplex& segment : complex.segments) {
    stops_.push_back({{0, segment[0]}, {1, segment[1]}});
  }
}

std::vector<Subsegment> SplitSegments::subsegments() const {
  std::vector<Subsegment> all;
  for (std::size_t i = 0; i < stops_.size(); ++i) {
    const std::vector<Simplex> edges = edges_of(i);
    for (std::size_t place = 0; place < edges.size(); ++place) {
      all.push_back({i, place, edges[place]});
    }
  }
  return all;
}

std::vector<Simplex> SplitSegments::edges_of(std::size_t segment) const {
  const std::vector<Stop>& stops = stops_[segment];
  std::vector<Simplex> edges;
  for (std::size_t place = 0; place + 1 < stops.size(); ++place) {
    edges.push_back(sorted({stops[place].vertex, stops[place + 1].vertex}));
  }
  return edges;
}

Rational SplitSegments::squared_length_of(const Subsegment& subsegment) const {
  const Simplex& segment = complex_.segments[subsegment.segment];
  const Stop* stop = &stops_[subsegment.segment][subsegment.place];
  const Rational part = stop[1].parameter - stop[0].parameter;
  return part * part * squared_distance(complex_.points[segment[0]], complex_.points[segment[1]]);
}

Rational SplitSegments::where_to_split(const Subsegment& subsegment,
                                       const std::vector<Point>& in_the_way) const {
  const Simplex& segment = complex_.segments[subsegment.segment];
  const Stop* stop = &stops_[subsegment.segment][subsegment.place];
  const Rational middle = (stop[0].parameter + stop[1].parameter) / 2;
  if (is_protected(subsegment)) return middle;
  const bool begins =
      stop[0].vertex == segment[0] && shells_.is_acute(subsegment.segment, segment[0]);
  const bool ends =
      stop[1].vertex == segment[1] && shells_.is_acute(subsegment.segment, segment[1]);
  if (begins != ends) {
    const Rational from_apex = shells_.where_to_split(subsegment.segment, segment[begins ? 0 : 1],
                                                      squared_length_of(subsegment));
    return begins ? from_apex : 1 - from_apex;
  }
  const std::optional<Interval> beside = beside_nearest(subsegment, in_the_way);
  if (!beside || (beside->low < middle && middle < beside->high)) return middle;
  return shortest_dyadic(beside->low, beside->high);
}

// Measured in parts of the whole segment: a point with the foot t and the height h is outside the
// closed ball over [u, s], u < t < s, iff (t − u)(s − t) < h².
std::optional<SplitSegments::Interval> SplitSegments::beside_nearest(
    const Subsegment& subsegment, const std::vector<Point>& in_the_way) const {
  const Simplex& segment = complex_.segments[subsegment.segment];
  const Stop* stop = &stops_[subsegment.segment][subsegment.place];
  const Rational quarter = (stop[1].parameter - stop[0].parameter) / 4;
  const Point& start = complex_.points[segment[0]];
  const Point along = complex_.points[segment[1]] - start;
  const Rational whole = squared_length(along);
  std::optional<Interval> nearest;
  Rational least_height;  // squared
  for (const Point& point : in_the_way) {
    const Point to = point - start;
    const Rational foot = inner_product(to, along) / whole;
    const Rational height = squared_length(to) / whole - foot * foot;
    const Rational before = foot - stop[0].parameter;
    const Rational after = stop[1].parameter - foot;
    if (sign(before) <= 0 || sign(after) <= 0 || (nearest && height >= least_height)) continue;
    Interval beside{std::max<Rational>(foot - height / after, stop[0].parameter + quarter),
                    std::min<Rational>(foot + height / before, stop[1].parameter - quarter)};
    if (beside.low >= beside.high) continue;
    nearest = std::move(beside);
    least_height = height;
  }
  return nearest;
}

Point SplitSegments::point_at(std::size_t segment, const Rational& parameter) const {
  const Simplex& ends = complex_.segments[segment];
  const Point& start = complex_.points[ends[0]];
  return start + parameter * (complex_.points[ends[1]] - start);
}

bool SplitSegments::is_protected(const Subsegment& subsegment) const {
  for (const Vertex end : complex_.segments[subsegment.segment]) {
    if (contains(subsegment.edge, end) && shells_.is_acute(subsegment.segment, end) &&
        squared_length_of(subsegment) <=
            shells_.squared_width(end) * shells_.squared_least_shell(end)) {
      return true;
    }
  }
  return false;
}

void SplitSegments::add(const PointOnSegment& point) {
  std::vector<Stop>& stops = stops_[point.segment];
  const auto after = std::find_if(stops.begin(), stops.end(), [&](const Stop& stop) {
    return stop.parameter >= point.parameter;
  });
  assert(after != stops.begin() && after != stops.end() && after->parameter > point.parameter);
  stops.insert(after, {point.parameter, point.vertex});
  added_.push_back(point);
}

void SplitSegments::split_segments_of(Polygon& polygon) const {
  std::vector<Simplex> whole;
  std::swap(whole, polygon.segments);
  for (const Simplex& segment : whole) {
    const auto place =
        std::lower_bound(complex_.segments.begin(), complex_.segments.end(), segment);
    const auto i = static_cast<std::size_t>(place - complex_.segments.begin());
    const std::vector<Simplex> edges = edges_of(i);
    polygon.segments.insert(polygon.segments.end(), edges.begin(), edges.end());
    std::for_each(stops_[i].begin() + 1, stops_[i].end() - 1,
                  [&](const Stop& stop) { polygon.vertices.push_back(stop.vertex); });
  }
}

PiecewiseLinearComplex SplitSegments::augmented(
    const PointSet& points, const std::vector<PointInPolygon>& in_polygons) const {
  PiecewiseLinearComplex augmented{
      points, {}, complex_.polygons, complex_.hole_seeds, complex_.kind};
  for (const Subsegment& subsegment : subsegments()) augmented.segments.push_back(subsegment.edge);
  std::sort(augmented.segments.begin(), augmented.segments.end());
  for (const PointInPolygon& point : in_polygons) {
    augmented.polygons[point.polygon].vertices.push_back(point.vertex);
  }
  for (std::size_t i = 0; i < complex_.polygons.size(); ++i) {
    Polygon& polygon = augmented.polygons[i];
    split_segments_of(polygon);
    if (polygon.vertices.size() == complex_.polygons[i].vertices.size()) continue;
    std::sort(polygon.vertices.begin(), polygon.vertices.end());
    std::sort(polygon.segments.begin(), polygon.segments.end());
    polygon.triangles = polygon_triangles(points, polygon.axes, polygon.vertices, polygon.segments,
                                          polygon.hole_seeds);
  }
  return augmented;
}

}  // namespace circumspect::constrained
