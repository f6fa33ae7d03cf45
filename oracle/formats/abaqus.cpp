#include "oracle/formats/abaqus.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kernel/exact/number_text.hpp"
#include "oracle/formats/abaqus_types.hpp"
#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/bytes/text_lines.hpp"
#include "oracle/formats/node_tags.hpp"

namespace circumspect::formats {
namespace {

// What is between the commas; a comma at the end ends no further field.
void split(std::string_view text, std::vector<std::string_view>& fields) {
  fields.clear();
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(','), text.size());
    fields.push_back(without_blanks(text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

// The text line by line; comments and empty lines are skipped.
class Fields {
 public:
  explicit Fields(const Source& source) : lines_(source) {}

  // Goes to the next line; false at the end.
  bool next() {
    while (lines_.next()) {
      text_ = without_blanks(lines_.text());
      if (!text_.empty() && !text_.starts_with("**")) return true;
    }
    text_ = {};
    return false;
  }

  bool is_keyword() const { return text_.starts_with('*'); }
  std::string_view text() const { return text_; }
  std::size_t line() const { return lines_.line(); }
  bool goes_on() const { return text_.ends_with(','); }

  const std::vector<std::string_view>& fields() {
    split(text_, fields_);
    return fields_;
  }

  tl::unexpected<FormatError> fail(std::string expected, std::string found) const {
    return lines_.fail(std::move(expected), std::move(found));
  }

 private:
  TextLines lines_;
  std::string_view text_;
  std::vector<std::string_view> fields_;
};

// "*ELEMENT" of "*Element, type=C3D4".
std::string keyword_of(std::string_view text) {
  return upper(without_blanks(text.substr(0, text.find(','))));
}

bool is_option(std::string_view field, std::string_view name) {
  return upper(without_blanks(field.substr(0, field.find('=')))) == name;
}

// The value of an option of a keyword; nothing if it does not have it.
std::optional<std::string> option_as_written(const std::vector<std::string_view>& fields,
                                             std::string_view name) {
  for (const std::string_view field : fields) {
    if (!is_option(field, name)) continue;
    const std::size_t equals = std::min(field.find('='), field.size());
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

std::string without_quotes(const std::string& path) {
  const bool is_quoted = path.size() > 1 && path.front() == '"' && path.back() == '"';
  return is_quoted ? path.substr(1, path.size() - 2) : path;
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
  Status read_elements(const AbaqusShape& shape);
  Status read_instance();
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
  if (fields.size() > 7) {
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
  if (option(fields_.fields(), "INPUT")) return fields_.fail("a file to include", "INPUT=");
  is_there_ = fields_.next();
  for (; has_line() && !fields_.is_keyword(); is_there_ = fields_.next()) {
    if (Status node = read_node(); !node) return node;
  }
  return {};
}

Status AbaqusReader::read_elements(const AbaqusShape& shape) {
  has_elements_ = true;
  if (option(fields_.fields(), "INPUT")) return fields_.fail("a file to include", "INPUT=");
  is_there_ = fields_.next();
  if (shape.nodes == 0) skip_data();
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
      if (!goes_on || vertices_.size() >= shape.nodes) break;
      is_there_ = fields_.next();
    }
    if (vertices_.size() != shape.nodes) {
      return fields_.fail(
          std::string(shape.words) + " of " + std::to_string(shape.nodes) + " nodes",
          std::to_string(vertices_.size()));
    }
    // The middle of an edge is listed between its ends.
    if (shape.shape == ElementShape::kCurvedEdge) std::swap(vertices_[1], vertices_[2]);
    add_element(file_, shape.shape, vertices_, shape.words, line);
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

Status AbaqusReader::read_section() {
  const std::string keyword = keyword_of(fields_.text());
  for (const auto& [refused, expected] : kRefused) {
    if (keyword == refused) return fields_.fail(std::string(expected), quote(fields_.text()));
  }
  if (keyword == "*INCLUDE") return fields_.fail("a file to include", quote(fields_.text()));
  if (keyword == "*NODE") return read_nodes();
  if (keyword == "*INSTANCE") return read_instance();
  if (keyword == "*PART" && std::exchange(has_part_, true)) {
    return fields_.fail("a mesh of one part", "another *Part");
  }
  if (keyword == "*ELEMENT") {
    const auto name = option(fields_.fields(), "TYPE");
    const AbaqusShape* const shape = name ? abaqus_shape_of(*name) : nullptr;
    if (shape != nullptr) return read_elements(*shape);
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

std::optional<Inclusion> abaqus_inclusion(TextLines lines) {
  const std::string_view text = without_blanks(lines.text());
  if (!text.starts_with('*') || text.starts_with("**")) return {};
  const std::string keyword = keyword_of(text);
  if (keyword != "*INCLUDE" && keyword != "*NODE" && keyword != "*ELEMENT") return {};
  std::vector<std::string_view> fields;
  split(text, fields);
  const auto path = option_as_written(fields, "INPUT");
  if (!path) return {};
  Inclusion inclusion{without_quotes(*path)};
  if (keyword == "*INCLUDE") return inclusion;
  for (const std::string_view field : fields) {
    if (is_option(field, "INPUT")) continue;
    inclusion.rest += (inclusion.rest.empty() ? "" : ", ") + std::string(field);
  }
  return inclusion;
}

Result<ElementFile> read_abaqus(const Source& source, NumberReading reading) {
  return AbaqusReader(source, reading).read();
}

}  // namespace circumspect::formats
