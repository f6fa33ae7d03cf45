#include "oracle/formats/vtk.hpp"

#include <map>

#include "oracle/formats/bytes/mixed_text.hpp"
#include "oracle/formats/bytes/text_lines.hpp"
#include "oracle/formats/vtk_cells.hpp"

namespace circumspect::formats {

namespace {

constexpr std::string_view kFirstLine = "# vtk DataFile Version ";

// Surfaces list their cells by type.
const std::map<std::string, Vertex, std::less<>> kSurfaceKeywords = {
    {"VERTICES", kVtkVertices},
    {"LINES", kVtkPolyline},
    {"POLYGONS", kVtkPolygon},
    {"TRIANGLE_STRIPS", kVtkStrip}};

class VtkReader {
 public:
  VtkReader(const Source& source, NumberReading reading) : text_(source, reading) {}

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
  Result<Indices> read_array(std::string_view keyword, std::size_t count);
  std::optional<VtkCells> read_stored_rows(std::size_t count, std::size_t size);
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
  Indices types_;
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
  return text_.points(*type, *count, {"a coordinate of ", "point", 0, *count}, file_.points.points);
}

// Rows as read_rows reads them, from binary numbers all at once; nothing if something is wrong with
// them, and then nothing is read.
std::optional<VtkCells> VtkReader::read_stored_rows(std::size_t count, std::size_t size) {
  if (!text_.is_binary()) return std::nullopt;
  MixedText text = text_;
  Indices numbers;
  if (!text.integers(kInt32, size, "", numbers)) return std::nullopt;
  VtkCells cells;
  cells.vertices.reserve(size - std::min(count, size));
  Simplex vertices;
  std::size_t at = 0;
  for (; cells.vertices.size() < count && at < size;) {
    const Vertex of_cell = numbers[at++];
    if (of_cell < 0 || of_cell > static_cast<Vertex>(size - at)) return std::nullopt;
    vertices.clear();
    for (Vertex i = 0; i < of_cell; ++i) vertices.push_back(numbers[at++]);
    cells.vertices.push_back(vertices);
    cells.lines.push_back(0);
  }
  if (cells.vertices.size() < count || at < size) return std::nullopt;
  text_ = std::move(text);
  return cells;
}

// For each cell, the number of its vertices, then the vertices.
Result<VtkCells> VtkReader::read_rows(std::size_t count, std::size_t size) {
  go_to_numbers();
  if (auto stored = read_stored_rows(count, size)) return std::move(*stored);
  VtkCells cells;
  Simplex vertices;
  std::size_t read = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Vertex of_cell = text_.take(kInt32, {"the number of vertices of ", "cell", i, count});
    if (text_.has_failed()) return text_.failure();
    if (of_cell < 0) {
      return text_.fail(
          Item{"the number of vertices of ", "cell", i, count}.words() + ", 0 or more",
          std::to_string(of_cell));
    }
    cells.lines.push_back(text_.line());
    vertices.clear();
    for (Vertex j = 0; j < of_cell && !text_.has_failed(); ++j) {
      vertices.push_back(text_.take(kInt32, {"a vertex of ", "cell", i, count}));
    }
    if (text_.has_failed()) return text_.failure();
    cells.vertices.push_back(vertices);
    read += 1 + vertices.size();
  }
  if (read == size) return cells;
  return text_.fail(std::to_string(size) + " numbers of " + std::to_string(count) + " cells",
                    std::to_string(read));
}

Result<Indices> VtkReader::read_array(std::string_view keyword, std::size_t count) {
  if (upper(text_.word()) != keyword) return text_.fail_at_word(std::string(keyword));
  const Result<NumberType> type = read_type();
  if (!type) return tl::unexpected(type.error());
  go_to_numbers();
  const std::string what = "a number of " + std::string(keyword);
  Indices numbers;
  if (Status read = text_.integers(*type, count, what, numbers); !read) {
    return tl::unexpected(read.error());
  }
  return numbers;
}

Result<VtkCells> VtkReader::read_cells() {
  const Result<std::size_t> count = text_.count_in_text("the number of cells");
  if (!count) return tl::unexpected(count.error());
  const Result<std::size_t> size = text_.count_in_text("the number of numbers of all cells");
  if (!size) return tl::unexpected(size.error());
  if (!has_offsets_) return read_rows(*count, *size);
  const std::size_t line = text_.line();
  if (*count == 0 && upper(text_.peek()) != "OFFSETS") return VtkCells{};
  const Result<Indices> offsets = read_array("OFFSETS", *count);
  if (!offsets) return tl::unexpected(offsets.error());
  Result<Indices> vertices = read_array("CONNECTIVITY", *size);
  if (!vertices) return tl::unexpected(vertices.error());
  // The first offset, 0, begins the first cell.
  if (offsets->size() > 0 && (*offsets)[0] != 0) {
    return text_.fail("the first offset 0", std::to_string((*offsets)[0]));
  }
  Indices ends;
  for (std::size_t i = 1; i < offsets->size(); ++i) ends.push_back((*offsets)[i]);
  return cells_of(text_, ends, std::move(*vertices), line);
}

Status VtkReader::read_list(Vertex type) {
  Result<VtkCells> cells = read_cells();
  if (!cells) return tl::unexpected(cells.error());
  for (std::size_t i = 0; i < cells->vertices.size(); ++i) {
    const Simplex vertices = cells->vertices[i];
    const auto fault = add_vtk_cell(file_, type, vertices, cells->lines[i]);
    if (!fault) continue;
    return tl::unexpected(FormatError{text_.name(), cells->lines[i], *fault,
                                      "one of " + std::to_string(vertices.size())});
  }
  return {};
}

Status VtkReader::read_types() {
  const Result<std::size_t> count = text_.count_in_text("the number of cells");
  if (!count) return tl::unexpected(count.error());
  has_types_ = true;
  go_to_numbers();
  types_ = {};
  return text_.integers(kInt32, *count, "the type of a cell", types_);
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
  if (count > 0 && take_vtk_cells(file_, types_, *cells_)) return {};
  for (std::size_t i = 0; i < count; ++i) {
    const Simplex vertices = cells_->vertices[i];
    const std::size_t line = cells_->lines[i];
    const auto fault = add_vtk_cell(file_, types_[i], vertices, line);
    if (!fault) continue;
    return tl::unexpected(FormatError{text_.name(), line, *fault,
                                      "type " + std::to_string(types_[i]) + " of " +
                                          std::to_string(vertices.size()) + " vertices"});
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
  file_.points.points.set_columns(3);
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
