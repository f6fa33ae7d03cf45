#include "inputs/cases.hpp"

#include <algorithm>
#include <ostream>
#include <utility>

#include "inputs/in_doubles.hpp"
#include "kernel/piecewise_linear/validity.hpp"

namespace circumspect::generators {

PointsCase chosen(const PointsCase& set, const std::vector<std::size_t>& places) {
  PointsCase part;
  for (const std::size_t v : places) {
    part.points.push_back(set.points[v]);
    if (!set.weights.empty()) part.weights.push_back(set.weights[v]);
  }
  return part;
}

std::ostream& operator<<(std::ostream& out, const PointsCase& set) {
  const std::size_t dimension = set.points.empty() ? 0 : set.points.front().size();
  out << set.points.size() << ' ' << dimension << (set.weights.empty() ? " 0 0\n" : " 1 0\n");
  for (std::size_t v = 0; v < set.points.size(); ++v) {
    out << v;
    for (const Rational& x : set.points[v]) out << ' ' << x;
    if (!set.weights.empty()) out << ' ' << set.weights[v];
    out << '\n';
  }
  return out;
}

PointArray array(const PointsCase& set, std::size_t dimension) {
  PointArray result{set.points.empty() ? dimension : set.points.front().size(), {}, {}};
  result.coordinates.reserve(set.points.size() * result.dimension);
  for (const Point& point : set.points) {
    for (const Rational& x : point) result.coordinates.push_back(nearest_double(x));
  }
  for (const Rational& weight : set.weights) result.weights.push_back(nearest_double(weight));
  return result;
}

PointsCase from(const PointArray& points) {
  PointsCase set;
  set.points.reserve(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    Point point;
    for (std::size_t i = 0; i < points.dimension; ++i) {
      point.push_back(exact_value(points.point(v)[i]));
    }
    set.points.push_back(std::move(point));
  }
  for (const double weight : points.weights) set.weights.push_back(exact_value(weight));
  return set;
}

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
