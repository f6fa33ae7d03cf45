#include "oracle/formats/unv.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/node_tags.hpp"

namespace circumspect::formats {
namespace {

using enum ElementShape;

constexpr std::string_view kEndOfDataSet = "-1";

struct UnvType {
  Vertex code;
  std::size_t nodes;  // 0: any number
  ElementShape shape;
  std::string_view words;
};
// Types of surfaces come in families of ten, one for each theory.
constexpr std::array kOfSurfaces = {
    UnvType{1, 3, kPolygon, "a triangle"},
    UnvType{2, 6, kCurvedTriangle, "a triangle of second order"},
    UnvType{4, 4, kPolygon, "a quadrilateral"},
    UnvType{5, 8, kCurved, "a quadrilateral of second order"},
};
constexpr Vertex kFirstSurface = 41;
constexpr Vertex kLastSurface = 99;
constexpr std::array kUnvTypes = {
    UnvType{11, 2, kPolyline, "an edge"},
    UnvType{21, 2, kPolyline, "an edge"},
    UnvType{22, 3, kCurvedEdge, "an edge of second order"},
    UnvType{24, 3, kCurvedEdge, "an edge of second order"},
    UnvType{111, 4, kTetrahedron, "a tetrahedron"},
    UnvType{112, 6, kOtherSolid, "a prism"},
    UnvType{113, 15, kCurved, "a prism of second order"},
    UnvType{115, 8, kOtherSolid, "a hexahedron"},
    UnvType{116, 20, kCurved, "a hexahedron of second order"},
    UnvType{118, 10, kCurvedTetrahedron, "a tetrahedron of second order"},
    // What joins nodes and has no shape: of any number of nodes.
    UnvType{121, 0, kPoint, "a rigid bar"},
    UnvType{122, 0, kPoint, "a rigid element"},
    UnvType{136, 0, kPoint, "a spring"},
    UnvType{137, 0, kPoint, "a spring"},
    UnvType{138, 0, kPoint, "a spring"},
    UnvType{139, 0, kPoint, "a damper"},
    UnvType{141, 0, kPoint, "a damper"},
    UnvType{142, 0, kPoint, "a damper"},
    UnvType{151, 0, kPoint, "a gap"},
    UnvType{152, 0, kPoint, "a gap"},
    UnvType{161, 1, kPoint, "a point"},
    // Seen in the half-plane that is turned about an axis.
    UnvType{171, 2, kPolyline, "an edge"},
    UnvType{172, 3, kCurvedEdge, "an edge of second order"},
};
// These have a line about their orientation.
constexpr std::array<Vertex, 5> kBeams = {11, 21, 22, 23, 24};

const UnvType* unv_type_of(Vertex code) {
  const auto is = [](Vertex wanted) {
    return [wanted](const UnvType& type) { return type.code == wanted; };
  };
  if (code >= kFirstSurface && code <= kLastSurface) {
    const auto* const surface = std::find_if(kOfSurfaces.begin(), kOfSurfaces.end(), is(code % 10));
    return surface == kOfSurfaces.end() ? nullptr : surface;
  }
  const auto* const type = std::find_if(kUnvTypes.begin(), kUnvTypes.end(), is(code));
  return type == kUnvTypes.end() ? nullptr : type;
}

// The corners, then the others: the format lists the nodes of second order on the way around a
// face.
void put_corners_first(Simplex& nodes, ElementShape shape) {
  if (shape == kCurvedEdge) nodes = {nodes[0], nodes[2], nodes[1]};
  if (shape == kCurvedTriangle)
    nodes = {nodes[0], nodes[2], nodes[4], nodes[1], nodes[3], nodes[5]};
  if (shape == kCurvedTetrahedron) {
    nodes = {nodes[0], nodes[2], nodes[4], nodes[9], nodes[1],
             nodes[3], nodes[5], nodes[6], nodes[7], nodes[8]};
  }
}

class UnvReader {
 public:
  UnvReader(const Source& source, NumberReading reading)
      : lines_(source, '\n', '\0'), reading_(reading) {}

  Result<ElementFile> read();

 private:
  bool is_at_end_of_set() const {
    return lines_.size() == 1 && lines_.tokens()[0] == kEndOfDataSet;
  }
  // Goes to the next line of this data set; false at its end.
  Result<bool> next_in_set();
  // Goes to the next line, which has to have so many columns.
  Status next_row(std::size_t columns, const std::string& what);
  Result<Rational> number(std::size_t column) const;
  Status read_set();
  Status read_nodes();
  // `count`: the column with the number of nodes of each; `property`: that with its property.
  Status read_elements(std::size_t count, std::size_t property);
  // `nodes`: how many it has.
  Status read_element(const UnvType& type, std::size_t nodes, std::size_t line, Vertex label);
  Status read_systems();

  Lines lines_;
  NumberReading reading_;
  bool has_elements_ = false;
  std::vector<Vertex> tags_;
  std::set<Vertex> moving_systems_;
  std::map<Vertex, std::size_t> systems_;  // of nodes, with the line of the first node in each
  Simplex vertices_;
  ElementFile file_;
};

Result<bool> UnvReader::next_in_set() {
  if (!lines_.next()) return lines_.fail("-1 behind the data set", "the end of the file");
  return !is_at_end_of_set();
}

Status UnvReader::next_row(std::size_t columns, const std::string& what) {
  if (!lines_.next() || lines_.size() < columns) return lines_.fail_at(lines_.size(), what);
  return {};
}

// With D in place of e.
Result<Rational> UnvReader::number(std::size_t column) const {
  std::string text(lines_.tokens()[column]);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == 'D' || c == 'd'; }, 'e');
  tl::expected<Rational, NumberError> value = parse_number(text, reading_);
  if (!value) return lines_.fail_at(column, std::move(value.error().expected));
  return std::move(*value);
}

Status UnvReader::read_nodes() {
  while (true) {
    const Result<bool> more = next_in_set();
    if (!more) return tl::unexpected(more.error());
    if (!*more) return {};
    if (lines_.size() < 2) return lines_.fail_at(1, "the label of a node and its system");
    const Result<Vertex> tag = lines_.integer(0, "the label of a node");
    if (!tag) return tl::unexpected(tag.error());
    const Result<Vertex> system = lines_.integer(1, "a system of coordinates");
    if (!system) return tl::unexpected(system.error());
    systems_.try_emplace(*system, lines_.line());
    tags_.push_back(*tag);
    if (Status row = next_row(3, "3 coordinates of a node"); !row) return row;
    if (lines_.size() > 3) return lines_.fail_at(3, "the end of the 3 coordinates of a node");
    for (std::size_t column = 0; column < 3; ++column) {
      Result<Rational> value = number(column);
      if (!value) return tl::unexpected(value.error());
      file_.points.points.add(std::move(*value));
    }
  }
}

Status UnvReader::read_element(const UnvType& type, std::size_t nodes, std::size_t line,
                               Vertex label) {
  if (std::find(kBeams.begin(), kBeams.end(), type.code) != kBeams.end()) {
    if (Status row = next_row(1, "the orientation of a beam"); !row) return row;
  }
  vertices_.clear();
  while (vertices_.size() < nodes) {
    if (Status row = next_row(1, "a node of an element"); !row) return row;
    for (std::size_t column = 0; column < lines_.size(); ++column) {
      const Result<Vertex> node = lines_.integer(column, "a node of an element");
      if (!node) return tl::unexpected(node.error());
      vertices_.push_back(*node);
    }
  }
  if (vertices_.size() > nodes) {
    return lines_.fail(std::string(type.words) + " of " + std::to_string(nodes) + " nodes",
                       std::to_string(vertices_.size()));
  }
  put_corners_first(vertices_, type.shape);
  if (type.shape != kPoint) add_element(file_, type.shape, vertices_, type.words, line, label);
  return {};
}

Status UnvReader::read_elements(std::size_t count, std::size_t property) {
  has_elements_ = true;
  while (true) {
    const Result<bool> more = next_in_set();
    if (!more) return tl::unexpected(more.error());
    if (!*more) return {};
    if (lines_.size() <= count)
      return lines_.fail_at(lines_.size(), "the number of nodes of an element");
    const std::size_t line = lines_.line();
    const Result<Vertex> code = lines_.integer(1, "the type of an element");
    if (!code) return tl::unexpected(code.error());
    const Result<Vertex> label = lines_.integer(property, "a physical property");
    if (!label) return tl::unexpected(label.error());
    const Result<std::size_t> nodes = lines_.count(count, "the number of nodes of an element");
    if (!nodes) return tl::unexpected(nodes.error());
    const UnvType* const type = unv_type_of(*code);
    if (type == nullptr) return lines_.fail_at(1, "a type of elements that is known, as 111");
    if (type->nodes != 0 && *nodes != type->nodes) {
      return lines_.fail(std::string(type->words) + " of " + std::to_string(type->nodes) + " nodes",
                         std::to_string(*nodes));
    }
    if (Status element = read_element(*type, *nodes, line, *label); !element) return element;
  }
}

// Systems of coordinates: a line of three integers, the label, the kind and a colour, then a name,
// which may be empty, and four rows of three numbers.
Status UnvReader::read_systems() {
  Vertex label = 0;
  std::size_t row = 0;
  while (true) {
    const Result<bool> more = next_in_set();
    if (!more) return tl::unexpected(more.error());
    if (!*more) return {};
    if (lines_.size() != 3) continue;
    Vertex one = 0;
    Vertex kind = 0;
    if (parse_integer(lines_.tokens()[0], one) == std::errc() &&
        parse_integer(lines_.tokens()[1], kind) == std::errc()) {
      label = one;
      row = 0;
      if (kind != 0) moving_systems_.insert(label);  // it is not Cartesian
      continue;
    }
    for (std::size_t column = 0; column < 3; ++column) {
      const Result<Rational> value = number(column);
      if (!value) break;  // a name
      if (*value != (row == column ? 1 : 0)) moving_systems_.insert(label);
      row += column == 2 ? 1 : 0;
    }
  }
}

Status UnvReader::read_set() {
  if (lines_.size() != 1) return lines_.fail_at(1, "the number of a data set alone");
  const std::string_view set = lines_.tokens()[0];
  if (set == "2411" || set == "781") return read_nodes();
  if (set == "2412") return read_elements(5, 2);
  if (set == "780") return read_elements(7, 3);
  if (set == "2420") return read_systems();
  while (true) {
    const Result<bool> more = next_in_set();
    if (!more) return tl::unexpected(more.error());
    if (!*more) return {};
  }
}

Result<ElementFile> UnvReader::read() {
  file_.points.dimension = 3;
  file_.points.points.set_columns(3);
  while (lines_.next()) {
    if (!is_at_end_of_set()) return lines_.fail_at(0, "-1 before a data set");
    if (Status row = next_row(1, "the number of a data set"); !row) {
      return tl::unexpected(row.error());
    }
    if (Status set = read_set(); !set) return tl::unexpected(set.error());
  }
  if (tags_.empty()) return lines_.fail("a data set 2411 of nodes", "the end of the file");
  if (!has_elements_) return lines_.fail("a data set 2412 of elements", "the end of the file");
  for (const auto& [system, line] : systems_) {
    if (moving_systems_.count(system) == 0) continue;
    return tl::unexpected(FormatError{lines_.file(), line,
                                      "nodes in a system of coordinates that leaves them in place",
                                      "system " + std::to_string(system)});
  }
  Status tags = index_by_tags(file_, std::move(tags_), lines_.file(), "in data set 2411");
  if (!tags) return tl::unexpected(tags.error());
  finish_elements(file_);
  return std::move(file_);
}

}  // namespace

bool is_unv(const Beginning& beginning) {
  return beginning.first_token == kEndOfDataSet && beginning.on_first_line == 1 &&
         beginning.on_second_line == 1;
}

Result<ElementFile> read_unv(const Source& source, NumberReading reading) {
  return UnvReader(source, reading).read();
}

}  // namespace circumspect::formats
