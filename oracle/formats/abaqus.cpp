#include "oracle/formats/abaqus.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/bytes/packed.hpp"
#include "oracle/formats/bytes/text_lines.hpp"
#include "oracle/formats/node_tags.hpp"
#include "platform/files.hpp"

namespace circumspect::formats {
namespace {

// Types by what their names begin with: the letters that follow (R: reduced integration, H: hybrid,
// …) say nothing about the shape. No two of them begin one name.
struct AbaqusType {
  std::string_view name;
  std::size_t nodes;
  ElementShape shape;
  std::string_view words;
};
using enum ElementShape;
constexpr std::array kAbaqusTypes = {
    AbaqusType{"C3D4", 4, kTetrahedron, "a tetrahedron"},
    AbaqusType{"C3D10", 10, kCurvedTetrahedron, "a tetrahedron of second order"},
    AbaqusType{"C3D5", 5, kOtherSolid, "a pyramid"},
    AbaqusType{"C3D6", 6, kOtherSolid, "a prism"},
    AbaqusType{"C3D8", 8, kOtherSolid, "a hexahedron"},
    AbaqusType{"C3D15", 15, kCurved, "a prism of second order"},
    AbaqusType{"C3D20", 20, kCurved, "a hexahedron of second order"},
    AbaqusType{"DC3D4", 4, kTetrahedron, "a tetrahedron"},
    AbaqusType{"DC3D10", 10, kCurvedTetrahedron, "a tetrahedron of second order"},
    AbaqusType{"DC3D6", 6, kOtherSolid, "a prism"},
    AbaqusType{"DC3D8", 8, kOtherSolid, "a hexahedron"},
    AbaqusType{"AC3D4", 4, kTetrahedron, "a tetrahedron"},
    AbaqusType{"CPS3", 3, kPolygon, "a triangle"},
    AbaqusType{"CPE3", 3, kPolygon, "a triangle"},
    AbaqusType{"CAX3", 3, kPolygon, "a triangle"},
    AbaqusType{"DC2D3", 3, kPolygon, "a triangle"},
    AbaqusType{"S3", 3, kPolygon, "a triangle"},
    AbaqusType{"STRI3", 3, kPolygon, "a triangle"},
    AbaqusType{"M3D3", 3, kPolygon, "a triangle"},
    AbaqusType{"R3D3", 3, kPolygon, "a triangle"},
    AbaqusType{"SFM3D3", 3, kPolygon, "a triangle"},
    AbaqusType{"CPS6", 6, kCurvedTriangle, "a triangle of second order"},
    AbaqusType{"CPE6", 6, kCurvedTriangle, "a triangle of second order"},
    AbaqusType{"CAX6", 6, kCurvedTriangle, "a triangle of second order"},
    AbaqusType{"STRI65", 6, kCurvedTriangle, "a triangle of second order"},
    AbaqusType{"S6", 6, kCurvedTriangle, "a triangle of second order"},
    AbaqusType{"CPS4", 4, kPolygon, "a quadrilateral"},
    AbaqusType{"CPE4", 4, kPolygon, "a quadrilateral"},
    AbaqusType{"CAX4", 4, kPolygon, "a quadrilateral"},
    AbaqusType{"S4", 4, kPolygon, "a quadrilateral"},
    AbaqusType{"M3D4", 4, kPolygon, "a quadrilateral"},
    AbaqusType{"R3D4", 4, kPolygon, "a quadrilateral"},
    AbaqusType{"SFM3D4", 4, kPolygon, "a quadrilateral"},
    AbaqusType{"CPS8", 8, kCurved, "a quadrilateral of second order"},
    AbaqusType{"CPE8", 8, kCurved, "a quadrilateral of second order"},
    AbaqusType{"S8", 8, kCurved, "a quadrilateral of second order"},
    AbaqusType{"T2D2", 2, kPolyline, "an edge"},
    AbaqusType{"T3D2", 2, kPolyline, "an edge"},
    AbaqusType{"B21", 2, kPolyline, "an edge"},
    AbaqusType{"B31", 2, kPolyline, "an edge"},
    AbaqusType{"MASS", 1, kPoint, "a point"},
};

const AbaqusType* abaqus_type_of(std::string_view name) {
  const auto* const found =
      std::find_if(kAbaqusTypes.begin(), kAbaqusTypes.end(), [&](const AbaqusType& type) {
        if (!name.starts_with(type.name)) return false;
        // "C3D10" is no "C3D1" with something behind it.
        const std::string_view behind = name.substr(type.name.size());
        return behind.empty() || std::isdigit(static_cast<unsigned char>(behind.front())) == 0;
      });
  return found == kAbaqusTypes.end() ? nullptr : found;
}

// The text line by line; comments and empty lines are skipped.
class Fields {
 public:
  explicit Fields(const Source& source) { files_.emplace_back(source); }

  // Goes to the next line; false at the end.
  bool next() {
    while (true) {
      TextLines& lines = files_.back();
      while (lines.next()) {
        text_ = without_blanks(lines.text());
        if (!text_.empty() && !text_.starts_with("**")) return true;
      }
      text_ = {};
      if (files_.size() == 1) return false;
      files_.pop_back();  // an included file has ended
    }
  }
  // From here on the lines of another file, and behind them the rest of this one. False if there is
  // no such file in the folder of the first or below it, or if too many have been included.
  bool include(const std::string& path) {
    constexpr std::size_t kMostFiles = 100;
    const bool is_below =
        !path.empty() && platform::is_relative(path) && path.find("..") == std::string::npos;
    const std::string& first = files_.front().file();
    const std::string whole = first.substr(0, first.find_last_of(platform::kSeparators) + 1) + path;
    if (!is_below || included_.size() >= kMostFiles || !is_regular(whole)) return false;
    Result<Source> source = load_unpacked(whole);
    if (!source) return false;
    included_.push_back(std::make_unique<const Source>(std::move(*source)));
    files_.emplace_back(*included_.back());
    return true;
  }

  bool is_keyword() const { return text_.starts_with('*'); }
  std::string_view text() const { return text_; }
  std::size_t line() const { return files_.back().line(); }
  bool goes_on() const { return text_.ends_with(','); }

  // What is between the commas; a comma at the end ends no further field.
  const std::vector<std::string_view>& fields() {
    fields_.clear();
    std::string_view rest = text_;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find(','), rest.size());
      fields_.push_back(without_blanks(rest.substr(0, end)));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return fields_;
  }

  tl::unexpected<FormatError> fail(std::string expected, std::string found) const {
    return files_.back().fail(std::move(expected), std::move(found));
  }

 private:
  std::vector<std::unique_ptr<const Source>> included_;
  std::deque<TextLines> files_;  // that are being read, the innermost last
  std::string_view text_;
  std::vector<std::string_view> fields_;
};

// "*ELEMENT" of "*Element, type=C3D4".
std::string keyword_of(std::string_view text) {
  return upper(without_blanks(text.substr(0, text.find(','))));
}

// The value of an option of a keyword; nothing if it does not have it.
std::optional<std::string> option_as_written(const std::vector<std::string_view>& fields,
                                             std::string_view name) {
  for (const std::string_view field : fields) {
    const std::size_t equals = std::min(field.find('='), field.size());
    if (upper(without_blanks(field.substr(0, equals))) != name) continue;
    return std::string(without_blanks(field.substr(std::min(equals + 1, field.size()))));
  }
  return std::nullopt;
}

// The same in capitals.
std::optional<std::string> option(const std::vector<std::string_view>& fields,
                                  std::string_view name) {
  const auto value = option_as_written(fields, name);
  return value ? std::optional(upper(*value)) : std::nullopt;
}

// Keywords that would make the mesh another one than what is listed.
constexpr std::array<std::pair<std::string_view, std::string_view>, 7> kRefused = {{
    {"*NGEN", "nodes that are listed"},
    {"*NFILL", "nodes that are listed"},
    {"*NCOPY", "nodes that are listed"},
    {"*ELGEN", "elements that are listed"},
    {"*ELCOPY", "elements that are listed"},
    {"*SYSTEM", "nodes in one system of coordinates"},
    {"*TRANSFORM NODES", "nodes in one system of coordinates"},
}};

class AbaqusReader {
 public:
  AbaqusReader(const Source& source, NumberReading reading)
      : fields_(source), name_(source.name), reading_(reading) {}

  Result<ElementFile> read();

 private:
  // A keyword; the line after its data is then the current one.
  Status read_section();
  Status read_nodes();
  Status read_node();
  Status read_elements(const AbaqusType& type);
  Status read_instance();
  Status read_include();
  Result<Vertex> integer(std::string_view field, std::string_view what) const;
  void skip_data() {
    while (has_line() && !fields_.is_keyword()) is_there_ = fields_.next();
  }
  bool has_line() const { return is_there_; }

  Fields fields_;
  std::string name_;
  NumberReading reading_;
  bool is_there_ = false;
  bool has_nodes_ = false;
  bool has_elements_ = false;
  bool has_part_ = false;
  bool has_instance_ = false;
  std::vector<Vertex> tags_;
  Simplex vertices_;
  ElementFile file_;
};

Result<Vertex> AbaqusReader::integer(std::string_view field, std::string_view what) const {
  Vertex value = 0;
  if (parse_integer(field, value) == std::errc()) return value;
  return fields_.fail(std::string(what) + ", an integer of 64 bits",
                      field.empty() ? "nothing" : quote(field));
}

Status AbaqusReader::read_node() {
  const std::vector<std::string_view>& fields = fields_.fields();
  const Result<Vertex> tag = integer(fields.front(), "the tag of a node");
  if (!tag) return tl::unexpected(tag.error());
  if (fields.size() < 2 || fields.size() > 7) {
    return fields_.fail("a tag and 3 coordinates of a node",
                        std::to_string(fields.size()) + " fields");
  }
  tags_.push_back(*tag);
  for (std::size_t axis = 1; axis <= 3; ++axis) {  // directions may follow
    const std::string_view field = axis < fields.size() ? fields[axis] : "";
    tl::expected<Rational, NumberError> number = Rational(0);
    if (!field.empty()) number = parse_number(field, reading_);
    if (!number) return fields_.fail(std::move(number.error().expected), quote(field));
    file_.points.points.add(std::move(*number));
  }
  return {};
}

Status AbaqusReader::read_nodes() {
  has_nodes_ = true;
  const auto system = option(fields_.fields(), "SYSTEM");
  if (system && *system != "R") {
    return fields_.fail("rectangular coordinates, SYSTEM=R", quote(*system));
  }
  if (option(fields_.fields(), "INPUT")) return fields_.fail("a mesh in one file", "INPUT=");
  is_there_ = fields_.next();
  for (; has_line() && !fields_.is_keyword(); is_there_ = fields_.next()) {
    if (Status node = read_node(); !node) return node;
  }
  return {};
}

Status AbaqusReader::read_elements(const AbaqusType& type) {
  has_elements_ = true;
  if (option(fields_.fields(), "INPUT")) return fields_.fail("a mesh in one file", "INPUT=");
  is_there_ = fields_.next();
  while (has_line() && !fields_.is_keyword()) {
    const std::size_t line = fields_.line();
    vertices_.clear();
    std::size_t read = 0;
    while (has_line() && !fields_.is_keyword()) {
      const bool goes_on = fields_.goes_on();
      for (const std::string_view field : fields_.fields()) {
        const Result<Vertex> number =
            integer(field, read == 0 ? "the tag of an element" : "a node of an element");
        if (!number) return tl::unexpected(number.error());
        if (read++ > 0) vertices_.push_back(*number);
      }
      if (!goes_on || vertices_.size() >= type.nodes) break;
      is_there_ = fields_.next();
    }
    if (vertices_.size() != type.nodes) {
      return fields_.fail(std::string(type.words) + " of " + std::to_string(type.nodes) + " nodes",
                          std::to_string(vertices_.size()));
    }
    add_element(file_, type.shape, vertices_, type.words, line);
    is_there_ = fields_.next();
  }
  return {};
}

// A part in its place: a line below would move it.
Status AbaqusReader::read_instance() {
  if (std::exchange(has_instance_, true)) return fields_.fail("a mesh of one instance", "another");
  is_there_ = fields_.next();
  if (!has_line() || fields_.is_keyword()) return {};
  return fields_.fail("a part where its nodes say", "an instance that moves it");
}

Status AbaqusReader::read_include() {
  const std::string path = option_as_written(fields_.fields(), "INPUT").value_or("");
  if (!fields_.include(path)) {
    return fields_.fail("a file to include, in the same folder or below it", quote(path));
  }
  is_there_ = fields_.next();
  return {};
}

Status AbaqusReader::read_section() {
  const std::string keyword = keyword_of(fields_.text());
  for (const auto& [refused, expected] : kRefused) {
    if (keyword == refused) return fields_.fail(std::string(expected), quote(fields_.text()));
  }
  if (keyword == "*INCLUDE") return read_include();
  if (keyword == "*NODE") return read_nodes();
  if (keyword == "*INSTANCE") return read_instance();
  if (keyword == "*PART" && std::exchange(has_part_, true)) {
    return fields_.fail("a mesh of one part", "another *Part");
  }
  if (keyword == "*ELEMENT") {
    const auto name = option(fields_.fields(), "TYPE");
    const AbaqusType* const type = name ? abaqus_type_of(*name) : nullptr;
    if (type != nullptr) return read_elements(*type);
    return fields_.fail("a type of elements that is known, as TYPE=C3D4",
                        name ? quote(*name) : "none");
  }
  is_there_ = fields_.next();
  skip_data();
  return {};
}

Result<ElementFile> AbaqusReader::read() {
  file_.points.dimension = 3;
  file_.points.points.set_columns(3);
  is_there_ = fields_.next();
  if (!has_line() || !fields_.is_keyword()) {
    return fields_.fail("a keyword, as *Node",
                        has_line() ? quote(fields_.text()) : "the end of the file");
  }
  while (has_line()) {
    if (Status section = read_section(); !section) return tl::unexpected(section.error());
  }
  if (!has_nodes_) return fields_.fail("the keyword *Node", "the end of the file");
  if (!has_elements_) return fields_.fail("the keyword *Element", "the end of the file");
  Status tags = index_by_tags(file_, std::move(tags_), name_, "below *Node");
  if (!tags) return tl::unexpected(tags.error());
  finish_elements(file_);
  return std::move(file_);
}

}  // namespace

bool is_abaqus(const Beginning& beginning) {
  std::string_view rest = beginning.text.substr(0, 4096);
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = without_blanks(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (line.empty() || line.starts_with("**")) continue;
    return line.size() > 1 && line[0] == '*' &&
           std::isalpha(static_cast<unsigned char>(line[1])) != 0;
  }
  return false;
}

Result<ElementFile> read_abaqus(const Source& source, NumberReading reading) {
  return AbaqusReader(source, reading).read();
}

}  // namespace circumspect::formats
