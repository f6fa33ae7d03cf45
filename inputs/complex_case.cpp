#include "inputs/complex_case.hpp"

#include <algorithm>
#include <ostream>
#include <utility>

#include "reference/kernel/piecewise_linear/validity.hpp"

namespace circumspect::generators {
namespace {

void print_line(std::ostream& out, const std::vector<Vertex>& line) {
  for (const Vertex v : line) out << " " << v;
  out << "\n";
}

void print_points(std::ostream& out, const std::vector<Point>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    out << i;
    for (const Rational& x : points[i]) out << " " << x;
    out << "\n";
  }
}

void print_facets(std::ostream& out, const PiecewiseLinearInput& input) {
  out << input.polygons.size() + input.segments.size() << " 0\n";
  for (const PolygonLines& polygon : input.polygons) {
    out << polygon.lines.size() << " " << polygon.hole_seeds.size() << "\n";
    for (const auto& line : polygon.lines) {
      out << line.size();
      print_line(out, line);
    }
    print_points(out, polygon.hole_seeds);
  }
  for (const auto& segment : input.segments) {
    out << "1 0\n2";
    print_line(out, segment);
  }
}

// Collects the simpler inputs that are valid.
class Simpler {
 public:
  explicit Simpler(const ComplexCase& whole) : whole_(whole) {}

  // `change` takes a copy of the input and makes it simpler.
  template <typename Change>
  void try_out(const Change& change) {
    ComplexCase part = whole_;
    change(part.input);
    if (!part.input.points.empty() && validated(part.input, 1)) found_.push_back(std::move(part));
  }

  std::vector<ComplexCase> take() { return std::move(found_); }

 private:
  const ComplexCase& whole_;
  std::vector<ComplexCase> found_;
};

template <typename T>
void erase_at(std::vector<T>& list, std::size_t place) {
  list.erase(list.begin() + static_cast<std::ptrdiff_t>(place));
}

template <typename T>
void drop_half(std::vector<T>& list, bool first_half) {
  const auto middle = list.begin() + static_cast<std::ptrdiff_t>((list.size() + 1) / 2);
  first_half ? list.erase(list.begin(), middle) : list.erase(middle, list.end());
}

void try_out_fewer_points(const ComplexCase& whole, Simpler& simpler) {
  std::vector<bool> unused = is_used(whole.input);
  unused.flip();
  const auto count = std::count(unused.begin(), unused.end(), true);
  if (count == 0) return;
  simpler.try_out([&](PiecewiseLinearInput& input) { drop_points(input, unused); });
  for (std::size_t v = 0; v < unused.size() && count > 1; ++v) {
    if (!unused[v]) continue;
    std::vector<bool> dropped(unused.size());
    dropped[v] = true;
    simpler.try_out([&](PiecewiseLinearInput& input) { drop_points(input, dropped); });
  }
}

std::vector<ComplexCase> simpler(const ComplexCase& whole) {
  Simpler result(whole);
  const auto fewer = [&](auto PiecewiseLinearInput::*list) {
    const std::size_t count = (whole.input.*list).size();
    for (const bool first_half : {true, false}) {
      if (count < 3) break;
      result.try_out([&](PiecewiseLinearInput& input) { drop_half(input.*list, first_half); });
    }
    for (std::size_t i = 0; i < count; ++i) {
      result.try_out([&](PiecewiseLinearInput& input) { erase_at(input.*list, i); });
    }
  };
  fewer(&PiecewiseLinearInput::polygons);
  fewer(&PiecewiseLinearInput::segments);
  fewer(&PiecewiseLinearInput::hole_seeds);
  for (std::size_t i = 0; i < whole.input.polygons.size(); ++i) {
    const PolygonLines& polygon = whole.input.polygons[i];
    for (std::size_t line = 1; line < polygon.lines.size(); ++line) {
      result.try_out([&](PiecewiseLinearInput& input) { erase_at(input.polygons[i].lines, line); });
    }
    if (!polygon.hole_seeds.empty()) {
      result.try_out([&](PiecewiseLinearInput& input) {
        input.polygons[i].lines.resize(1);
        input.polygons[i].hole_seeds.clear();
      });
    }
  }
  try_out_fewer_points(whole, result);
  return result.take();
}

}  // namespace

std::vector<bool> is_used(const PiecewiseLinearInput& input) {
  std::vector<bool> used(input.points.size());
  const auto use = [&used](const std::vector<Vertex>& line) {
    for (const Vertex v : line) used[static_cast<std::size_t>(v)] = true;
  };
  for (const auto& segment : input.segments) use(segment);
  for (const PolygonLines& polygon : input.polygons) {
    for (const auto& line : polygon.lines) use(line);
  }
  return used;
}

void drop_points(PiecewiseLinearInput& input, const std::vector<bool>& dropped) {
  std::vector<Vertex> image(input.points.size());
  std::vector<Point> kept;
  for (std::size_t v = 0; v < input.points.size(); ++v) {
    image[v] = static_cast<Vertex>(kept.size());
    if (!dropped[v]) kept.push_back(std::move(input.points[v]));
  }
  input.points = std::move(kept);
  const auto renumber = [&image](std::vector<Vertex>& line) {
    for (Vertex& v : line) v = image[static_cast<std::size_t>(v)];
  };
  std::for_each(input.segments.begin(), input.segments.end(), renumber);
  for (PolygonLines& polygon : input.polygons) {
    std::for_each(polygon.lines.begin(), polygon.lines.end(), renumber);
  }
}

std::ostream& operator<<(std::ostream& out, const ComplexCase& value) {
  const PiecewiseLinearInput& input = value.input;
  const std::size_t dimension = input.points.empty() ? 3 : input.points.front().size();
  out << "# " << value.family << ", kind "
      << (input.kind == DomainKind::kHull ? "hull" : "enclosed") << "\n"
      << input.points.size() << " " << dimension << " 0 0\n";
  print_points(out, input.points);
  if (dimension == 2) {
    out << input.segments.size() << " 0\n";
    for (std::size_t i = 0; i < input.segments.size(); ++i) {
      out << i;
      print_line(out, input.segments[i]);
    }
  } else {
    print_facets(out, input);
  }
  out << input.hole_seeds.size() << "\n";
  print_points(out, input.hole_seeds);
  return out;
}

Complexes shrinking(const Complexes& complexes) {
  return [=](const rc::Random& random, int size) {
    return rc::shrinkable::shrinkRecur(
        complexes(random, size).value(),
        [](const ComplexCase& whole) { return rc::seq::fromContainer(simpler(whole)); });
  };
}

PolygonLines polygon_along(std::vector<Vertex> line) { return {{std::move(line)}, {}}; }

bool add_if_valid(PiecewiseLinearInput& input, const Cells& cells) {
  const std::size_t segments = input.segments.size(), polygons = input.polygons.size();
  input.segments.insert(input.segments.end(), cells.segments.begin(), cells.segments.end());
  input.polygons.insert(input.polygons.end(), cells.polygons.begin(), cells.polygons.end());
  if (validated(input, 1)) return true;
  input.segments.resize(segments);
  input.polygons.resize(polygons);
  return false;
}

}  // namespace circumspect::generators
