#include "oracle/formats/json_events.hpp"

#include <algorithm>

#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/lines.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace circumspect::formats {
bool JsonEvents::fail(const std::string& expected, const std::string& found) {
  error_ = {text_.file(), text_.line(), expected, found};
  return false;
}

std::string JsonEvents::wanted() const {
  if (depth_ == 0) return "a JSON object";
  const bool in_list = depth_ > 1;
  switch (key_) {
    case kVersion:
      return std::to_string(kJsonSchemaVersion) + ", the version of the schema";
    case kDimension:
      return "a dimension from 1 to " + std::to_string(kLargestDimension);
    case kPoints:
      if (depth_ > 2) return "a coordinate";
      return in_list ? "a point, which is an array of coordinates" : "an array of points";
    case kWeights:
      return in_list ? "a weight" : "an array of weights";
    case kSimplices:
      if (depth_ > 2) return "a vertex, an integer that fits 64 bits";
      return in_list ? "a simplex, which is an array of vertices" : "an array of simplices";
    case kFaces:
      if (depth_ > 2) return "a vertex, an integer that fits 64 bits";
      return in_list ? "a face, which is an array of vertices" : "an array of faces";
    case kFirstIndex:
      return "the index of the first point, an integer that fits 64 bits";
    default:
      return "a string";
  }
}

bool JsonEvents::number_float(double, const std::string& text) { return number(as_written(text)); }

bool JsonEvents::number(std::string_view text) {
  Vertex vertex = 0;
  switch (depth_) {
    case 1:
      if (key_ == kVersion) return version(text);
      if (key_ == kDimension) return dimension(text);
      if (key_ == kFirstIndex) return integer(text, file_.points.first_index);
      break;
    case 2:
      if (key_ == kWeights) return exact(text, file_.weights);
      break;
    case 3:
      if (key_ == kPoints) return exact(text, point_);
      if (!integer(text, vertex)) return false;
      simplex_.push_back(vertex);
      return true;
    default:
      break;
  }
  return mismatch(quote(text));
}

bool JsonEvents::string(const std::string& value) {
  if (depth_ == 1 && key_ == kComment) return true;
  if (depth_ == 2 && key_ == kWeights) return exact(value, file_.weights);
  if (depth_ == 3 && key_ == kPoints) return exact(value, point_);
  return mismatch("the string " + quote(value));
}

bool JsonEvents::integer(std::string_view text, Vertex& value) {
  return parse_integer(text, value) == std::errc() || mismatch(quote(text));
}

bool JsonEvents::exact(std::string_view text, std::vector<Rational>& values) {
  tl::expected<Rational, NumberError> value = parse_number(text, reading_);
  if (!value) return fail(value.error().expected, quote(text));
  values.push_back(std::move(*value));
  return true;
}

bool JsonEvents::version(std::string_view text) {
  return text == std::to_string(kJsonSchemaVersion) || mismatch(quote(text));
}

bool JsonEvents::dimension(std::string_view text) {
  Vertex value = 0;
  if (parse_integer(text, value) != std::errc() || value < 1 ||
      value > static_cast<Vertex>(kLargestDimension)) {
    return mismatch(quote(text));
  }
  file_.points.dimension = static_cast<std::size_t>(value);
  return true;
}

bool JsonEvents::start_object(std::size_t) {
  if (depth_ > 0) return mismatch("an object");
  ++depth_;
  return true;
}

bool JsonEvents::key(const std::string& name) {
  const auto* const known = std::find(kNames.begin(), kNames.end(), name);
  if (known == kNames.end()) {
    std::string names;
    for (const std::string_view one : kNames) names += (names.empty() ? "" : ", ") + quote(one);
    return fail("one of the keys " + names, quote(name));
  }
  key_ = static_cast<Key>(known - kNames.begin());
  if (line_of_[key_] > 0) return fail("every key once", quote(name) + " again");
  line_of_[key_] = text_.line();
  return true;
}

bool JsonEvents::end_object() {
  --depth_;
  return true;
}

bool JsonEvents::start_array(std::size_t) {
  const bool is_list = key_ == kWeights || is_list_of_lists();
  const bool is_wanted = (depth_ == 1 && is_list) || (depth_ == 2 && is_list_of_lists());
  if (!is_wanted) return mismatch("an array");
  ++depth_;
  point_.clear();
  simplex_.clear();
  if (depth_ == 3 && is_list_of_vertices()) cells().lines.push_back(text_.line());
  return true;
}

bool JsonEvents::end_array() {
  --depth_;
  if (depth_ == 1) return true;
  return key_ == kPoints ? end_of_point() : end_of_simplex();
}

bool JsonEvents::end_of_point() {
  if (!size_of_first_) size_of_first_ = point_.size();
  const std::size_t known = file_.points.dimension;
  const std::size_t wanted_size = known > 0 ? known : *size_of_first_;
  if (point_.size() == wanted_size) {
    file_.points.points.push_back(point_);
    return true;
  }
  return fail("a point with " + std::to_string(wanted_size) + " coordinates",
              "one with " + std::to_string(point_.size()));
}

bool JsonEvents::end_of_simplex() {
  cells().simplices.push_back(simplex_);
  if (!simplex_.empty()) return true;
  const std::string one = key_ == kFaces ? "a face" : "a simplex";
  return fail(one + " of at least 1 vertex", "an empty array");
}

bool JsonEvents::parse_error(std::size_t, const std::string& last_token,
                             const nlohmann::json::exception& error) {
  error_ = text_.fault(last_token, error, " (a string may hold more)");
  return false;
}

Status JsonEvents::check_whole() const {
  const auto fail_at = [this](Key key, std::string expected, std::string found) {
    return tl::unexpected(
        FormatError{text_.file(), line_of_[key], std::move(expected), std::move(found)});
  };
  for (const Key key : {kVersion, kDimension, kPoints}) {
    if (line_of_[key] == 0) {
      return fail_at(key,
                     "the key " + quote(kNames[key]) +
                         R"(, as in {"circumspect": 1, "dimension": 2, "points": [...], )"
                         R"("simplices": [...]})",
                     "an object without it");
    }
  }
  const PointFile& points = file_.points;
  if (size_of_first_ && *size_of_first_ != points.dimension) {
    return fail_at(kDimension,
                   "the dimension " + std::to_string(*size_of_first_) + ", which the points have",
                   std::to_string(points.dimension));
  }
  if (!has_room(points.first_index, points.points.size())) {
    return fail_at(kFirstIndex,
                   "an index of the first point that leaves room for " +
                       std::to_string(points.points.size()) + " points in 64 bits",
                   std::to_string(points.first_index));
  }
  if (line_of_[kWeights] > 0 && file_.weights.size() != points.points.size()) {
    return fail_at(kWeights,
                   "one weight for each of " + std::to_string(points.points.size()) + " points",
                   std::to_string(file_.weights.size()));
  }
  return check_faces();
}

// A list with as many vertices as a simplex of full dimension is not a face of one.
Status JsonEvents::check_faces() const {
  const SimplexFile& faces = file_.faces;
  for (std::size_t i = 0; i < faces.simplices.size(); ++i) {
    const std::size_t size = faces.simplices.size_of(i);
    if (size <= file_.points.dimension) continue;
    return tl::unexpected(
        FormatError{text_.file(), faces.lines[i],
                    "a face of at most " + std::to_string(file_.points.dimension) +
                        " vertices in dimension " + std::to_string(file_.points.dimension),
                    "one of " + std::to_string(size)});
  }
  return {};
}

Result<JsonFile> JsonEvents::finish() {
  if (!error_.expected.empty()) return tl::unexpected(error_);
  if (Status whole = check_whole(); !whole) return tl::unexpected(whole.error());
  file_.has_simplices = line_of_[kSimplices] > 0;
  file_.simplices.first_index = file_.points.first_index;
  file_.simplices.vertices_per_simplex = file_.simplices.simplices.columns();
  file_.faces.first_index = file_.points.first_index;
  file_.faces.vertices_per_simplex = file_.faces.simplices.columns();
  return std::move(file_);
}

}  // namespace circumspect::formats
