#include "inputs/untidy.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "inputs/in_doubles.hpp"
#include "kernel/piecewise_linear/arrangement.hpp"
#include "kernel/piecewise_linear/validity.hpp"

namespace circumspect::generators {
namespace {

bool are_of_doubles(const std::vector<Point>& points) {
  return std::all_of(points.begin(), points.end(), [](const Point& point) {
    return std::all_of(point.begin(), point.end(), is_double);
  });
}

Vertex added(PiecewiseLinearInput& input, Point point) {
  input.points.push_back(std::move(point));
  return static_cast<Vertex>(input.points.size() - 1);
}

const Point& some_vertex(Dice& dice, const PiecewiseLinearInput& input) {
  return input.points[dice.below(input.points.size())];
}

// The two places in a domain that hold the ends of a segment, or of an edge of a polygon.
using Ends = std::array<Vertex*, 2>;

std::vector<Ends> all_ends(PiecewiseLinearInput& input) {
  std::vector<Ends> all;
  for (std::vector<Vertex>& segment : input.segments) all.push_back({&segment[0], &segment[1]});
  for (PolygonLines& polygon : input.polygons) {
    for (std::vector<Vertex>& line : polygon.lines) {
      for (std::size_t i = line.size() == 2 ? 1 : 0; i < line.size() && line.size() > 1; ++i) {
        all.push_back({&line[i], &line[(i + 1) % line.size()]});
      }
    }
  }
  return all;
}

// A point of the line of a segment; inside it where 0 < quarters < 4.
Point on_line(const PiecewiseLinearInput& input, const Ends& ends, long quarters) {
  const Point& a = input.points[static_cast<std::size_t>(*ends[0])];
  const Point& b = input.points[static_cast<std::size_t>(*ends[1])];
  const Rational part = Rational(quarters) / 4;  // in lowest terms
  return a + part * (b - a);
}

// Half way from a point inside an edge of a polygon to a vertex of it: often inside the polygon.
// Requires: a polygon with an edge.
Point about_inside(Dice& dice, const PiecewiseLinearInput& input, const Point& on_edge) {
  const PolygonLines& polygon = input.polygons[dice.below(input.polygons.size())];
  const std::vector<Vertex> vertices = vertices_of(polygon);
  const Vertex v = vertices[dice.below(vertices.size())];
  const Point& corner = input.points[static_cast<std::size_t>(v)];
  return on_edge + Rational(1, 2) * (corner - on_edge);
}

// Requires: there is a segment.
void make_untidy(Dice& dice, Untidiness kind, PiecewiseLinearInput& input) {
  const std::vector<Ends> segments = all_ends(input);
  const Ends& segment = segments[dice.below(segments.size())];
  const long quarters = dice.within(1L, 3L);
  switch (kind) {
    case Untidiness::kTouching: {
      const auto other = static_cast<Vertex>(dice.below(input.points.size()));
      const Vertex v = added(input, on_line(input, segment, quarters));
      if (dice.below(2) == 0) input.segments.push_back({v, other});
      return;
    }
    case Untidiness::kCrossing: {
      // From a vertex through a point inside the segment, or inside a polygon, and as far again
      // beyond.
      const Point from = some_vertex(dice, input);
      Point through = on_line(input, segment, quarters);
      if (!input.polygons.empty() && dice.below(2) == 0) {
        through = about_inside(dice, input, through);
      }
      const auto a = std::find(input.points.begin(), input.points.end(), from);
      const auto start = static_cast<Vertex>(a - input.points.begin());
      const Vertex end = added(input, through + (through - from));
      input.segments.push_back({start, end});
      return;
    }
    case Untidiness::kOverlapping: {
      const Point p = on_line(input, segment, quarters);
      const Point q = on_line(input, segment, dice.within(-2L, 6L));
      const Vertex start = added(input, p);
      const Vertex end = added(input, q);
      input.segments.push_back({start, end});
      return;
    }
    case Untidiness::kRepetition: {
      Vertex& end = *segment[dice.below(2)];
      end = added(input, Point(input.points[static_cast<std::size_t>(end)]));
      return;
    }
  }
}

}  // namespace

std::string_view name(Untidiness kind) {
  switch (kind) {
    case Untidiness::kTouching:
      return "touching";
    case Untidiness::kCrossing:
      return "crossing";
    case Untidiness::kOverlapping:
      return "overlapping";
    case Untidiness::kRepetition:
      return "repetition";
  }
  return "";
}

ComplexCase untidied(Dice& dice, ComplexCase whole, const std::set<Untidiness>& kinds) {
  if (all_ends(whole.input).empty()) return whole;
  const std::vector<Untidiness> asked(kinds.begin(), kinds.end());
  const std::size_t wanted = 1 + dice.below(4);
  constexpr int kTries = 20;
  std::size_t made = 0;
  for (int i = 0; i < kTries && made < wanted; ++i) {
    PiecewiseLinearInput candidate = whole.input;
    make_untidy(dice, asked[dice.below(asked.size())], candidate);
    const PiecewiseLinearInput tidy = arranged(candidate);
    if (!are_of_doubles(tidy.points) || !validated(tidy, 1)) continue;
    whole.input = std::move(candidate);
    ++made;
  }
  return whole;
}

}  // namespace circumspect::generators
