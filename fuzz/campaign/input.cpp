#include "fuzz/campaign/input.hpp"

#include <algorithm>
#include <sstream>

#include "fuzz/campaign/domain_text.hpp"
#include "oracle/formats/json.hpp"
#include "oracle/formats/lines.hpp"
#include "oracle/formats/point_lists.hpp"
#include "oracle/formats/surface_formats.hpp"
#include "oracle/formats/tetgen.hpp"

namespace circumspect::campaign {
namespace {

// The file of the points alone.
formats::PointFile point_file(const PointsCase& set, Vertex first_index, std::size_t dimension) {
  formats::PointFile file;
  file.dimension = set.points.empty() ? dimension : set.points.front().size();
  file.points = set.points;
  file.first_index = first_index;
  return file;
}

std::string node_text(const PointsCase& set, Vertex first_index, std::size_t dimension) {
  formats::PointFile file = point_file(set, first_index, dimension);
  for (const Rational& weight : set.weights) file.attributes.push_back({weight});
  std::ostringstream text;
  formats::write_node(text, file);
  return text.str();
}

std::string json_text(const PointsCase& set, Vertex first_index, std::size_t dimension) {
  formats::JsonFile file;
  file.points = point_file(set, first_index, dimension);
  file.weights = set.weights;
  std::ostringstream text;
  formats::write_json(text, file);
  return text.str();
}

std::string xyz_text(const PointsCase& set) {
  std::string text;
  for (std::size_t v = 0; v < set.points.size(); ++v) {
    text += formats::joined(set.points[v]);
    if (!set.weights.empty()) text += " " + formats::joined({set.weights[v]});
    text += "\n";
  }
  return text;
}

// What a worker reads (docs/workers.md): six counts, then the points, with their weights.
std::string case_text(const PointsCase& set, std::size_t dimension) {
  if (!set.points.empty()) dimension = set.points.front().size();
  return std::to_string(set.points.size()) + " " + std::to_string(dimension) +
         (set.weights.empty() ? " 0" : " 1") + " 0 0 0\n" + xyz_text(set);
}

std::string points_text(const PointsCase& set, const std::string& extension, Vertex first_index,
                        std::size_t dimension) {
  if (extension == ".node") return node_text(set, first_index, dimension);
  if (extension == ".json") return json_text(set, first_index, dimension);
  if (extension == ".xyz") return xyz_text(set);
  if (extension == ".case") return case_text(set, dimension);
  std::ostringstream text;
  if (extension == ".qhull") {
    formats::write_qhull_points(text, point_file(set, 0, dimension));
  } else {
    formats::write_off(text, {point_file(set, 0, dimension), {}});
  }
  return text.str();
}

bool is_double(const Rational& value) { return exact_value(value.get_d()) == value; }

bool are_doubles(const std::vector<Rational>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), is_double);
}

bool are_doubles(const std::vector<Point>& points) {
  return std::all_of(points.begin(), points.end(),
                     [](const Point& point) { return are_doubles(point); });
}

}  // namespace

std::size_t point_count(const Input& input) {
  if (const auto* const set = std::get_if<PointsCase>(&input)) return set->points.size();
  return std::get<ComplexCase>(input).input.points.size();
}

bool is_of_doubles(const Input& input) {
  if (const auto* const set = std::get_if<PointsCase>(&input)) {
    return are_doubles(set->points) && are_doubles(set->weights);
  }
  const PiecewiseLinearInput& domain = std::get<ComplexCase>(input).input;
  return are_doubles(domain.points) && are_doubles(domain.hole_seeds) &&
         std::all_of(domain.polygons.begin(), domain.polygons.end(),
                     [](const PolygonLines& polygon) { return are_doubles(polygon.hole_seeds); });
}

bool is_points_extension(const std::string& extension) {
  return extension == ".node" || extension == ".qhull" || extension == ".off" ||
         extension == ".json" || extension == ".xyz" || extension == ".case";
}

bool is_domain_extension(const std::string& extension) {
  return extension == ".poly" || extension == ".geo" || extension == ".case" ||
         is_surface_extension(extension);
}

std::optional<std::string> file_text(const Input& input, const std::string& extension,
                                     Vertex first_index, std::size_t dimension) {
  if (const auto* const set = std::get_if<PointsCase>(&input)) {
    return points_text(*set, extension, first_index, dimension);
  }
  const PiecewiseLinearInput& domain = std::get<ComplexCase>(input).input;
  if (extension == ".poly") return poly_text(domain, first_index);
  if (extension == ".case") return case_text(domain, dimension);
  if (is_surface_extension(extension)) return surface_text(domain, extension);
  return geo_text(domain);
}

}  // namespace circumspect::campaign
