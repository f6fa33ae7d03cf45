#include "oracle/formats/obj.hpp"

#include <algorithm>
#include <array>

#include "oracle/formats/bytes/lines.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace circumspect::formats {
namespace {

// Keywords that do not concern points, lines and faces.
constexpr std::array<std::string_view, 16> kReadOver = {
    "vt",     "vn",    "p",        "g",        "o",   "s",          "mg",        "usemtl",
    "mtllib", "bevel", "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj", "usemap"};

// Joins lines that end in a backslash; empty lines in their place keep the line numbers.
Source with_lines_joined(const Source& source) {
  Source joined{source.name, source.text};
  std::string& text = joined.text;
  std::size_t at = 0;
  std::string result;
  std::size_t owed = 0;  // line ends that were left out
  while (at < text.size()) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::size_t last = end;
    while (last > at && text[last - 1] == '\r') --last;
    const bool goes_on = last > at && text[last - 1] == '\\';
    result.append(text, at, (goes_on ? last - 1 : end) - at);
    if (goes_on) {
      result += ' ';
      ++owed;
    } else {
      result.append(owed + (end < text.size() ? 1 : 0), '\n');
      owed = 0;
    }
    at = end + 1;
  }
  text = std::move(result);
  return joined;
}

bool is_nan(std::string_view token) {
  if (token.starts_with('-')) token.remove_prefix(1);
  return token == "nan" || token == "NaN";
}

class ObjReader {
 public:
  ObjReader(const Source& source, NumberReading reading) : lines_(source), reading_(reading) {}

  Result<ElementFile> read() {
    file_.points.dimension = 3;
    file_.points.first_index = 1;
    file_.points.points.set_columns(3);
    while (lines_.next()) {
      const std::string_view word = lines_.tokens()[0];
      Status status;
      if (word == "v") {
        status = read_point();
      } else if (word == "f") {
        status = read_element(ElementShape::kPolygon, "a face");
      } else if (word == "l") {
        status = read_element(ElementShape::kPolyline, "a line");
      } else if (std::find(kReadOver.begin(), kReadOver.end(), word) == kReadOver.end()) {
        status = lines_.fail_at(0, "a point (v), a face (f), a line (l) or what may be read over");
      }
      if (!status) return tl::unexpected(status.error());
    }
    finish_elements(file_);
    return std::move(file_);
  }

 private:
  Status read_point() {
    const std::size_t coordinates = lines_.size() - 1;
    // Some programs write the plane without a third coordinate.
    if (file_.points.points.empty()) is_of_plane_ = coordinates == 2;
    if (is_of_plane_ ? coordinates != 2 : coordinates < 3) {
      return lines_.fail(is_of_plane_ ? "2 coordinates, as of the points before" : "3 coordinates",
                         std::to_string(coordinates));
    }
    const std::size_t columns = is_of_plane_ ? 2 : 3;
    const Status point = lines_.add_numbers(1, columns, reading_, file_.points.points);
    if (!point) return point;
    if (is_of_plane_) file_.points.points.add(0);
    for (std::size_t column = 1 + columns; column < lines_.size(); ++column) {
      // A weight or a colour, which nobody may have set.
      if (is_nan(lines_.tokens()[column])) continue;
      if (Status number = lines_.check_numbers(column, 1, reading_); !number) return number;
    }
    return {};
  }

  // The index of a point: 7, 7/1, 7//2, 7/1/2; from −1 on those before this line, backwards.
  Result<Vertex> read_vertex(std::size_t column) {
    if (const auto plain = lines_.plain_integer(column); plain && *plain > 0) return *plain;
    const std::string_view token = lines_.tokens()[column];
    Vertex index = 0;
    if (parse_integer(token.substr(0, token.find('/')), index) != std::errc()) {
      return lines_.fail_at(column, "a vertex, an integer that fits 64 bits");
    }
    if (index == 0) return lines_.fail_at(column, "a vertex, counted from 1, or back from -1");
    if (index > 0) return index;
    const auto count = static_cast<Vertex>(file_.points.points.size());
    if (index < -count) {
      return lines_.fail_at(column, "one of the " + std::to_string(count) + " vertices so far");
    }
    return count + 1 + index;
  }

  Status read_element(ElementShape shape, const std::string& name) {
    vertices_.clear();
    for (std::size_t column = 1; column < lines_.size(); ++column) {
      const Result<Vertex> vertex = read_vertex(column);
      if (!vertex) return tl::unexpected(vertex.error());
      vertices_.push_back(*vertex);
    }
    const std::size_t size = vertices_.size();
    const bool is_named = shape == ElementShape::kPolygon && size != 3;
    const auto fault = add_element(
        file_, shape, vertices_,
        is_named ? name + " of " + std::to_string(size) + " vertices" : name, lines_.line());
    if (!fault) return {};
    return lines_.fail(
        name + (shape == ElementShape::kPolygon ? " of 3" : " of 2") + " vertices or more",
        std::to_string(size));
  }

  Lines lines_;
  NumberReading reading_;
  bool is_of_plane_ = false;
  ElementFile file_;
  Simplex vertices_;  // of one element
};

}  // namespace

bool is_obj_keyword(std::string_view token) {
  constexpr std::array<std::string_view, 5> kFirst = {"v", "o", "g", "mtllib", "usemtl"};
  return std::find(kFirst.begin(), kFirst.end(), token) != kFirst.end();
}

Result<ElementFile> read_obj(const Source& source, NumberReading reading) {
  if (source.text.find('\\') == std::string::npos) return ObjReader(source, reading).read();
  const Source joined = with_lines_joined(source);
  return ObjReader(joined, reading).read();
}

void write_obj(std::ostream& out, const ElementFile& file) {
  for (const Point& point : file.points.points) {
    out << "v " + joined(point) + (point.size() == 2 ? " 0\n" : "\n");
  }
  const auto write = [&](const char* keyword, const std::vector<Simplex>& elements) {
    for (Simplex vertices : elements) {
      for (Vertex& v : vertices) v = index_of_place(place_of_index(v, file.points.first_index), 1);
      out << keyword + joined(vertices) + "\n";
    }
  };
  write("f ", surface_of(file));
  write("l ", file.edges.simplices.lists());
}

}  // namespace circumspect::formats
