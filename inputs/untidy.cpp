#include "inputs/untidy.hpp"

#include <algorithm>
#include <vector>

#include "inputs/in_doubles.hpp"
#include "reference/kernel/piecewise_linear/arrangement.hpp"
#include "reference/kernel/piecewise_linear/validity.hpp"

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

// A point of the line of a segment; inside it where 0 < quarters < 4.
Point on_line(const PiecewiseLinearInput& input, std::size_t segment, long quarters) {
  const std::vector<Vertex>& ends = input.segments[segment];
  const Point& a = input.points[static_cast<std::size_t>(ends[0])];
  const Point& b = input.points[static_cast<std::size_t>(ends[1])];
  const Rational part = Rational(quarters) / 4;  // in lowest terms
  return a + part * (b - a);
}

// Requires: there is a segment.
void make_untidy(Dice& dice, Untidiness kind, PiecewiseLinearInput& input) {
  const std::size_t segment = dice.below(input.segments.size());
  const long quarters = dice.within(1L, 3L);
  switch (kind) {
    case Untidiness::kTouching: {
      const auto other = static_cast<Vertex>(dice.below(input.points.size()));
      const Vertex v = added(input, on_line(input, segment, quarters));
      if (dice.below(2) == 0) input.segments.push_back({v, other});
      return;
    }
    case Untidiness::kCrossing: {
      // From a vertex through a point inside the segment, as far again.
      const Point from = some_vertex(dice, input);
      const Point through = on_line(input, segment, quarters);
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
      std::vector<Vertex>& ends = input.segments[segment];
      const std::size_t end = dice.below(2);
      ends[end] = added(input, input.points[static_cast<std::size_t>(ends[end])]);
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
  if (whole.input.segments.empty()) return whole;
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
