#include "oracle/formats/vtk.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>

#include "oracle/formats/bytes/mixed_text.hpp"

namespace circumspect::formats {

namespace {

constexpr std::array kVtkTypes = {
    ElementType{1, 1, ElementShape::kPoint, "a vertex"},
    ElementType{2, 0, ElementShape::kPoint, "a list of vertices"},
    ElementType{3, 2, ElementShape::kPolyline, "an edge"},
    ElementType{4, 0, ElementShape::kPolyline, "a polyline"},
    ElementType{5, 3, ElementShape::kPolygon, "a triangle"},
    ElementType{6, 0, ElementShape::kStrip, "a strip of triangles"},
    ElementType{7, 0, ElementShape::kPolygon, "a polygon"},
    ElementType{8, 4, ElementShape::kPixel, "a pixel"},
    ElementType{9, 4, ElementShape::kPolygon, "a quadrilateral"},
    ElementType{10, 4, ElementShape::kTetrahedron, "a tetrahedron"},
    ElementType{11, 8, ElementShape::kOtherSolid, "a voxel"},
    ElementType{12, 8, ElementShape::kOtherSolid, "a hexahedron"},
    ElementType{13, 6, ElementShape::kOtherSolid, "a prism"},
    ElementType{14, 5, ElementShape::kOtherSolid, "a pyramid"},
    ElementType{15, 10, ElementShape::kOtherSolid, "a pentagonal prism"},
    ElementType{16, 12, ElementShape::kOtherSolid, "a hexagonal prism"},
    ElementType{42, 0, ElementShape::kOtherSolid, "a polyhedron"},
};
constexpr Vertex kFirstCurved = 21;  // and all later ones except the polyhedron
constexpr Vertex kLastCurved = 81;

}  // namespace

std::optional<std::string> add_vtk_cell(ElementFile& file, Vertex type, Simplex vertices,
                                        std::size_t line) {
  const auto* const found = std::find_if(kVtkTypes.begin(), kVtkTypes.end(),
                                         [&](const ElementType& one) { return one.code == type; });
  if (found == kVtkTypes.end()) {
    if (type < kFirstCurved || type > kLastCurved) return "a type of cells that VTK knows";
    return add_element(file, ElementShape::kCurved, std::move(vertices),
                       "a cell of second order or more", line);
  }
  if (found->vertices != 0 && vertices.size() != found->vertices) {
    return std::string(found->name) + " of " + std::to_string(found->vertices) + " vertices";
  }
  return add_element(file, found->shape, std::move(vertices), found->name, line);
}

Result<VtkCells> cells_of(const MixedText& text, const std::vector<Vertex>& offsets,
                          const std::vector<Vertex>& connectivity, std::size_t line) {
  VtkCells cells;
  Vertex begin = 0;
  for (const Vertex end : offsets) {
    if (end < begin || end > static_cast<Vertex>(connectivity.size())) {
      return tl::unexpected(FormatError{
          text.name(), line,
          "an offset from " + std::to_string(begin) + " to " + std::to_string(connectivity.size()),
          std::to_string(end)});
    }
    cells.vertices.emplace_back(connectivity.begin() + begin, connectivity.begin() + end);
    cells.lines.push_back(line);
    begin = end;
  }
  if (begin == static_cast<Vertex>(connectivity.size())) return cells;
  return tl::unexpected(FormatError{text.name(), line,
                                    "offsets up to " + std::to_string(connectivity.size()) +
                                        ", the end of "
                                        "the vertices of cells",
                                    std::to_string(begin)});
}

Status read_vtk_points(MixedText& text, NumberType type, std::size_t count,
                       std::vector<Point>& points) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::string what =
        "a coordinate of point " + std::to_string(i + 1) + " of " + std::to_string(count);
    Point point;
    while (point.size() < 3) {
      Result<Rational> number = text.number(type, what);
      if (!number) return tl::unexpected(number.error());
      point.push_back(std::move(*number));
    }
    points.push_back(std::move(point));
  }
  return {};
}

Result<std::vector<Vertex>> read_vtk_integers(MixedText& text, NumberType type, std::size_t count,
                                              const std::string& what) {
  std::vector<Vertex> values;
  for (std::size_t i = 0; i < count; ++i) {
    const Result<Vertex> value = text.integer(type, what);
    if (!value) return tl::unexpected(value.error());
    values.push_back(*value);
  }
  return values;
}

// ---- VTK ----

namespace {

constexpr std::string_view kFirstLine = "# vtk DataFile Version ";

std::string upper(std::string_view word) {
  std::string text(word);
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

// Surfaces list their cells by type.
const std::map<std::string, Vertex, std::less<>> kSurfaceKeywords = {
    {"VERTICES", kVtkVertices},
    {"LINES", kVtkPolyline},
    {"POLYGONS", kVtkPolygon},
    {"TRIANGLE_STRIPS", kVtkStrip}};

class VtkReader {
 public:
  VtkReader(const Source& source, NumberReading reading)
      : text_(source.name, source.text, reading) {}

  Result<ElementFile> read();

 private:
  Status read_header();
  Status read_section(const std::string& keyword);
  Result<NumberType> read_type();
  // Goes to the numbers of a section; in binary files they begin on the next line.
  void go_to_numbers() {
    if (text_.is_binary()) text_.rest_of_line();
  }
  Status read_points();
  Result<VtkCells> read_cells();
  Result<VtkCells> read_rows(std::size_t count, std::size_t size);
  Result<std::vector<Vertex>> read_array(std::string_view keyword, std::size_t count);
  Status read_list(Vertex type);
  Status read_types();
  Status skip_fields();
  void skip_information();
  Status add_cells();

  MixedText text_;
  bool has_offsets_ = false;  // since version 5
  bool has_points_ = false;
  bool is_binary_ = false;
  ElementFile file_;
  std::optional<VtkCells> cells_;  // of a grid
  std::vector<Vertex> types_;
  bool has_types_ = false;
};

Status VtkReader::read_header() {
  const std::string_view first = text_.rest_of_line();
  if (!is_vtk(first)) {
    return text_.fail("\"" + std::string(kFirstLine) + "…\"", quote(first));
  }
  const std::string_view version = first.substr(kFirstLine.size());
  has_offsets_ = !version.empty() && version.front() >= '5' && version.front() <= '9';
  text_.rest_of_line();
  const std::string encoding = upper(text_.word());
  if (encoding != "ASCII" && encoding != "BINARY") return text_.fail_at_word("ASCII or BINARY");
  is_binary_ = encoding == "BINARY";
  return {};
}

Result<NumberType> VtkReader::read_type() {
  using enum NumberType::Kind;
  static const std::map<std::string, NumberType, std::less<>> types = {
      {"CHAR", {kSigned, 1}},         {"UNSIGNED_CHAR", {kUnsigned, 1}},
      {"SHORT", {kSigned, 2}},        {"UNSIGNED_SHORT", {kUnsigned, 2}},
      {"INT", {kSigned, 4}},          {"UNSIGNED_INT", {kUnsigned, 4}},
      {"LONG", {kSigned, 8}},         {"UNSIGNED_LONG", {kUnsigned, 8}},
      {"VTKTYPEINT64", {kSigned, 8}}, {"VTKTYPEUINT64", {kUnsigned, 8}},
      {"VTKIDTYPE", {kSigned, 4}},    {"FLOAT", {kFloating, 4}},
      {"DOUBLE", {kFloating, 8}}};
  const auto found = types.find(upper(text_.word()));
  if (found != types.end()) return found->second;
  return text_.fail_at_word("a type of numbers, as double");
}

Status VtkReader::read_points() {
  if (has_points_) return text_.fail_at_word("one section POINTS");
  has_points_ = true;
  const Result<std::size_t> count = text_.count_in_text("the number of points");
  if (!count) return tl::unexpected(count.error());
  const Result<NumberType> type = read_type();
  if (!type) return tl::unexpected(type.error());
  go_to_numbers();
  return read_vtk_points(text_, *type, *count, file_.points.points);
}

// For each cell, the number of its vertices, then the vertices.
Result<VtkCells> VtkReader::read_rows(std::size_t count, std::size_t size) {
  go_to_numbers();
  VtkCells cells;
  std::size_t read = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string one = "cell " + std::to_string(i + 1) + " of " + std::to_string(count);
    const Result<std::size_t> vertices = text_.count(kInt32, "the number of vertices of " + one);
    if (!vertices) return tl::unexpected(vertices.error());
    cells.lines.push_back(text_.line());
    Result<std::vector<Vertex>> cell =
        read_vtk_integers(text_, kInt32, *vertices, "a vertex of " + one);
    if (!cell) return tl::unexpected(cell.error());
    cells.vertices.push_back(std::move(*cell));
    read += 1 + *vertices;
  }
  if (read == size) return cells;
  return text_.fail(std::to_string(size) + " numbers of " + std::to_string(count) + " cells",
                    std::to_string(read));
}

Result<std::vector<Vertex>> VtkReader::read_array(std::string_view keyword, std::size_t count) {
  if (upper(text_.word()) != keyword) return text_.fail_at_word(std::string(keyword));
  const Result<NumberType> type = read_type();
  if (!type) return tl::unexpected(type.error());
  go_to_numbers();
  return read_vtk_integers(text_, *type, count, "a number of " + std::string(keyword));
}

Result<VtkCells> VtkReader::read_cells() {
  const Result<std::size_t> count = text_.count_in_text("the number of cells");
  if (!count) return tl::unexpected(count.error());
  const Result<std::size_t> size = text_.count_in_text("the number of numbers of all cells");
  if (!size) return tl::unexpected(size.error());
  if (!has_offsets_) return read_rows(*count, *size);
  const std::size_t line = text_.line();
  if (*count == 0 && upper(text_.peek()) != "OFFSETS") return VtkCells{};
  Result<std::vector<Vertex>> offsets = read_array("OFFSETS", *count);
  if (!offsets) return tl::unexpected(offsets.error());
  const Result<std::vector<Vertex>> vertices = read_array("CONNECTIVITY", *size);
  if (!vertices) return tl::unexpected(vertices.error());
  // The first offset, 0, begins the first cell.
  if (!offsets->empty() && offsets->front() != 0)
    return text_.fail("the first offset 0", std::to_string(offsets->front()));
  if (!offsets->empty()) offsets->erase(offsets->begin());
  return cells_of(text_, *offsets, *vertices, line);
}

Status VtkReader::read_list(Vertex type) {
  Result<VtkCells> cells = read_cells();
  if (!cells) return tl::unexpected(cells.error());
  for (std::size_t i = 0; i < cells->vertices.size(); ++i) {
    const std::size_t size = cells->vertices[i].size();
    const auto fault = add_vtk_cell(file_, type, std::move(cells->vertices[i]), cells->lines[i]);
    if (!fault) continue;
    return tl::unexpected(
        FormatError{text_.name(), cells->lines[i], *fault, "one of " + std::to_string(size)});
  }
  return {};
}

Status VtkReader::read_types() {
  const Result<std::size_t> count = text_.count_in_text("the number of cells");
  if (!count) return tl::unexpected(count.error());
  has_types_ = true;
  go_to_numbers();
  Result<std::vector<Vertex>> types =
      read_vtk_integers(text_, kInt32, *count, "the type of a cell");
  if (!types) return tl::unexpected(types.error());
  types_ = std::move(*types);
  return {};
}

// FIELD name n, then n times: name, components, tuples, type, numbers.
Status VtkReader::skip_fields() {
  text_.word();
  const Result<std::size_t> count = text_.count_in_text("the number of fields");
  if (!count) return tl::unexpected(count.error());
  for (std::size_t i = 0; i < *count; ++i) {
    if (text_.peek() == "METADATA") {
      text_.word();
      skip_information();
    }
    if (text_.word().empty()) return text_.fail_at_word("the name of a field");
    const Result<std::size_t> components = text_.count_in_text("the number of components");
    if (!components) return tl::unexpected(components.error());
    const Result<std::size_t> tuples = text_.count_in_text("the number of tuples");
    if (!tuples) return tl::unexpected(tuples.error());
    const Result<NumberType> type = read_type();
    if (!type) return tl::unexpected(type.error());
    go_to_numbers();
    std::size_t numbers = 0;
    if (__builtin_mul_overflow(*components, *tuples, &numbers)) {
      return text_.fail_at_word("a field that the file has room for");
    }
    const Status skipped = text_.skip_numbers(*type, numbers, "a number of a field");
    if (!skipped) return skipped;
  }
  return {};
}

// METADATA ends at an empty line.
void VtkReader::skip_information() {
  text_.rest_of_line();
  while (text_.bytes_left() > 0 && !text_.rest_of_line().empty()) continue;
}

Status VtkReader::read_section(const std::string& keyword) {
  text_.begin_section();
  if (keyword == "POINTS") return read_points();
  if (keyword == "METADATA") {
    skip_information();
    return {};
  }
  if (keyword == "FIELD") return skip_fields();
  if (keyword == "CELL_TYPES") return read_types();
  if (keyword == "CELLS") {
    if (cells_) return text_.fail_at_word("one section CELLS");
    Result<VtkCells> cells = read_cells();
    if (!cells) return tl::unexpected(cells.error());
    cells_ = std::move(*cells);
    return {};
  }
  const auto list = kSurfaceKeywords.find(keyword);
  if (list != kSurfaceKeywords.end()) return read_list(list->second);
  return text_.fail_at_word("a section, as POINTS or CELLS");
}

Status VtkReader::add_cells() {
  const std::size_t count = cells_ ? cells_->vertices.size() : 0;
  if (types_.size() != count) {
    return text_.fail("as many CELL_TYPES as CELLS, " + std::to_string(count),
                      std::to_string(types_.size()));
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t size = cells_->vertices[i].size();
    const std::size_t line = cells_->lines[i];
    const auto fault = add_vtk_cell(file_, types_[i], std::move(cells_->vertices[i]), line);
    if (!fault) continue;
    return tl::unexpected(FormatError{
        text_.name(), line, *fault,
        "type " + std::to_string(types_[i]) + " of " + std::to_string(size) + " vertices"});
  }
  return {};
}

Result<ElementFile> VtkReader::read() {
  if (Status header = read_header(); !header) return tl::unexpected(header.error());
  if (upper(text_.word()) != "DATASET") return text_.fail_at_word("DATASET");
  const std::string kind = upper(text_.word());
  if (kind != "UNSTRUCTURED_GRID" && kind != "POLYDATA") {
    return text_.fail_at_word("UNSTRUCTURED_GRID or POLYDATA");
  }
  if (is_binary_) text_.set_binary(ByteOrder::kBigEndian);
  file_.points.dimension = 3;
  while (true) {
    const std::string keyword = upper(text_.word());
    if (keyword.empty() || keyword == "CELL_DATA" || keyword == "POINT_DATA") break;
    if (Status section = read_section(keyword); !section) return tl::unexpected(section.error());
  }
  if (!has_points_) return text_.fail_at_word("the section POINTS");
  if (Status cells = add_cells(); !cells) return tl::unexpected(cells.error());
  finish_elements(file_);
  return std::move(file_);
}

}  // namespace

bool is_vtk(std::string_view text) { return text.starts_with(kFirstLine); }

Result<ElementFile> read_vtk(const Source& source, NumberReading reading) {
  return VtkReader(source, reading).read();
}

}  // namespace circumspect::formats
