#include "fuzz/campaign/input.hpp"

#include <algorithm>
#include <sstream>

#include "fuzz/campaign/domain_text.hpp"
#include "inputs/in_doubles.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/json.hpp"
#include "oracle/formats/off.hpp"
#include "oracle/formats/point_file.hpp"
#include "oracle/formats/qhull.hpp"
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

// The same with a seventh count and the updates. A point is named by its place among those present.
std::string case_text(const UpdatesCase& whole, std::size_t dimension) {
  using generators::UpdateKind;
  std::vector<std::size_t> present = first_places(whole);
  std::string text = case_text(chosen(whole.set, present), dimension);
  text.insert(text.find('\n'), " " + std::to_string(whole.updates.size()));
  for (const generators::Update& update : whole.updates) {
    text += name(update.kind);
    if (update.kind == UpdateKind::kInsert) {
      text += " " + xyz_text(chosen(whole.set, {update.point}));
      present.push_back(update.point);
      continue;
    }
    if (update.kind == UpdateKind::kDelete) {
      const auto place = std::find(present.begin(), present.end(), update.point);
      text += " " + std::to_string(place - present.begin());
      present.erase(place);
    }
    text += "\n";
  }
  return text;
}

// The numbers of a point, and its weight if it has one, from a line.
bool read_point(std::istream& line, std::size_t dimension, bool has_weight, PointsCase& set) {
  std::vector<Rational> numbers;
  for (std::string token; line >> token;) {
    const auto number = read_number(token, NumberReading::kDouble);
    if (!number) return false;
    numbers.push_back(*number);
  }
  if (numbers.size() != dimension + (has_weight ? 1 : 0)) return false;
  if (has_weight) {
    set.weights.push_back(numbers.back());
    numbers.pop_back();
  }
  set.points.push_back(std::move(numbers));
  return true;
}

// Reads an update, and updates the list of points present.
bool read_update(std::istream& line, std::size_t dimension, bool has_weight, UpdatesCase& whole,
                 std::vector<std::size_t>& present) {
  using generators::UpdateKind;
  std::string word;
  line >> word;
  if (word == name(UpdateKind::kRestore)) {
    whole.updates.push_back({UpdateKind::kRestore});
  } else if (word == name(UpdateKind::kInsert)) {
    present.push_back(whole.set.points.size());
    whole.updates.push_back({UpdateKind::kInsert, whole.set.points.size()});
    return read_point(line, dimension, has_weight, whole.set);
  } else if (word == name(UpdateKind::kDelete)) {
    std::size_t place = 0;
    if (!(line >> place) || place >= present.size()) return false;
    const auto at = present.begin() + static_cast<std::ptrdiff_t>(place);
    whole.updates.push_back({UpdateKind::kDelete, *at});
    present.erase(at);
  } else {
    return false;
  }
  return !(line >> word);
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

// Making numbers small tries multiples that are beyond all doubles.
using generators::is_double;

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
  if (const auto* const whole = std::get_if<UpdatesCase>(&input)) return whole->set.points.size();
  return std::get<ComplexCase>(input).input.points.size();
}

std::optional<PointsCase> judged_points(const Input& input) {
  if (const auto* const set = std::get_if<PointsCase>(&input)) return *set;
  if (const auto* const whole = std::get_if<UpdatesCase>(&input)) return last_points(*whole);
  return std::nullopt;
}

std::optional<Input> image_of(generators::Relation relation, const Input& input) {
  if (const auto* const whole = std::get_if<ComplexCase>(&input)) {
    auto changed = image(relation, *whole);
    return changed ? std::optional<Input>(std::move(*changed)) : std::nullopt;
  }
  const auto* const set = std::get_if<PointsCase>(&input);
  auto changed = set == nullptr ? std::nullopt : image(relation, *set);
  if (!changed) return std::nullopt;
  const bool leaves = lie_within(*set, kOrdinary) && !lie_within(*changed, kOrdinary);
  return leaves ? std::nullopt : std::optional<Input>(std::move(*changed));
}

bool is_of_doubles(const Input& input) {
  if (const auto* const set = std::get_if<PointsCase>(&input)) {
    return are_doubles(set->points) && are_doubles(set->weights);
  }
  if (const auto* const whole = std::get_if<UpdatesCase>(&input)) {
    return are_doubles(whole->set.points) && are_doubles(whole->set.weights);
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
  if (const auto* const whole = std::get_if<UpdatesCase>(&input)) {
    if (extension == ".case") return case_text(*whole, dimension);
    return points_text(last_points(*whole), extension, first_index, dimension);
  }
  const PiecewiseLinearInput& domain = std::get<ComplexCase>(input).input;
  if (extension == ".poly") return poly_text(domain, first_index);
  if (extension == ".case") return case_text(domain, dimension);
  if (is_surface_extension(extension)) return surface_text(domain, extension);
  return geo_text(domain);
}

std::optional<UpdatesCase> read_updates(const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  constexpr std::size_t kCounts = 7;
  constexpr std::size_t kMostLines = 1'000'000'000;
  std::size_t counts[kCounts] = {};
  std::getline(lines, line);
  std::istringstream header(line);
  for (std::size_t& count : counts) {
    if (!(header >> count) || count > kMostLines) return std::nullopt;
  }
  const std::size_t dimension = counts[1];
  const bool has_weight = counts[2] == 1;
  if (header >> line || dimension == 0 || counts[3] + counts[4] + counts[5] != 0) {
    return std::nullopt;
  }
  UpdatesCase whole;
  std::vector<std::size_t> present;
  for (std::size_t i = 0; i < counts[0] + counts[6]; ++i) {
    if (!std::getline(lines, line)) return std::nullopt;
    std::istringstream words(line);
    const bool is_update = i >= counts[0];
    if (!is_update) present.push_back(i);
    if (is_update ? !read_update(words, dimension, has_weight, whole, present)
                  : !read_point(words, dimension, has_weight, whole.set)) {
      return std::nullopt;
    }
  }
  if (std::getline(lines, line) || !is_sound(whole)) return std::nullopt;
  return whole;
}

}  // namespace circumspect::campaign
