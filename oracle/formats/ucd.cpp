#include "oracle/formats/ucd.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/bytes/mixed_text.hpp"
#include "oracle/formats/node_tags.hpp"

namespace circumspect::formats {
namespace {

// A type of cells, of first order and of second.
struct CellType {
  std::string_view word;
  std::string_view name;
  std::size_t vertices;
  ElementShape shape;
  std::size_t nodes;  // of second order
  ElementShape curved;
};
constexpr std::array kUcdTypes = {
    CellType{"pt", "a point", 1, ElementShape::kPoint, 1, ElementShape::kPoint},
    CellType{"line", "an edge", 2, ElementShape::kPolyline, 3, ElementShape::kCurvedEdge},
    CellType{"tri", "a triangle", 3, ElementShape::kPolygon, 6, ElementShape::kCurvedTriangle},
    CellType{"quad", "a quadrilateral", 4, ElementShape::kPolygon, 8, ElementShape::kCurved},
    CellType{"tet", "a tetrahedron", 4, ElementShape::kTetrahedron, 10,
             ElementShape::kCurvedTetrahedron},
    CellType{"pyr", "a pyramid", 5, ElementShape::kOtherSolid, 13, ElementShape::kCurved},
    CellType{"prism", "a prism", 6, ElementShape::kOtherSolid, 15, ElementShape::kCurved},
    CellType{"hex", "a hexahedron", 8, ElementShape::kOtherSolid, 20, ElementShape::kCurved}};

constexpr std::size_t kCounts = 5;

class UcdReader {
 public:
  UcdReader(const Source& source, NumberReading reading) : lines_(source), reading_(reading) {}

  Result<ElementFile> read();

 private:
  Status read_node(const Item& item);
  Status read_cell(const Item& item);
  // Data is skipped; its first line stands right behind the last cell.
  Status expect_data(bool is_there);

  Lines lines_;
  NumberReading reading_;
  std::vector<Vertex> tags_;
  Simplex vertices_;
  ElementFile file_;
};

Status UcdReader::read_node(const Item& item) {
  if (!lines_.next()) return lines_.fail_at(0, item.words());
  if (lines_.size() != 4) {
    return lines_.fail("4 columns of " + item.words(), std::to_string(lines_.size()));
  }
  const Result<Vertex> tag = lines_.integer(0, "the index of a node");
  if (!tag) return tl::unexpected(tag.error());
  tags_.push_back(*tag);
  return lines_.add_numbers(1, 3, reading_, file_.points.points);
}

Status UcdReader::read_cell(const Item& item) {
  if (!lines_.next()) return lines_.fail_at(0, item.words());
  if (lines_.size() < 3) {
    return lines_.fail("an index, a material and the type of " + item.words(),
                       std::to_string(lines_.size()) + " columns");
  }
  const Result<std::vector<Vertex>> numbers = lines_.integers(0, 2, "an index and a material");
  if (!numbers) return tl::unexpected(numbers.error());
  const auto* const type =
      std::find_if(kUcdTypes.begin(), kUcdTypes.end(),
                   [&](const CellType& one) { return is_word(lines_.tokens()[2], one.word); });
  if (type == kUcdTypes.end()) {
    return lines_.fail_at(2, "pt, line, tri, quad, tet, pyr, prism or hex");
  }
  const std::size_t found = lines_.size() - 3;
  if (found != type->vertices && found != type->nodes) {
    return lines_.fail(std::to_string(type->vertices) + " vertices, or " +
                           std::to_string(type->nodes) + " of second order",
                       std::to_string(found));
  }
  if (Status read = lines_.integers(3, found, "a vertex", vertices_); !read) return read;
  const bool is_curved = found != type->vertices;
  const std::string name = std::string(type->name) + (is_curved ? " of second order" : "");
  add_element(file_, is_curved ? type->curved : type->shape, vertices_, name, lines_.line(),
              (*numbers)[1]);
  return {};
}

Status UcdReader::expect_data(bool is_there) {
  if (!lines_.next()) return {};
  if (!is_there) return lines_.fail_at(0, "the end of the file, since no data is announced");
  const Result<std::size_t> components = lines_.count(0, "the number of components of data");
  if (!components) return tl::unexpected(components.error());
  if (lines_.size() == 1 + *components) return {};
  return lines_.fail("the sizes of " + std::to_string(*components) + " components of data",
                     std::to_string(lines_.size() - 1));
}

Result<ElementFile> UcdReader::read() {
  if (!lines_.next()) return lines_.fail_at(0, "the numbers of nodes, cells and data");
  if (lines_.size() != kCounts) {
    return lines_.fail("5 numbers: of nodes, cells and data of 3 kinds",
                       std::to_string(lines_.size()));
  }
  std::array<std::size_t, kCounts> counts = {};
  for (std::size_t column = 0; column < kCounts; ++column) {
    const Result<std::size_t> count = lines_.count(column, "a count");
    if (!count) return tl::unexpected(count.error());
    counts[column] = *count;
  }
  file_.points.dimension = 3;
  file_.points.points.set_columns(3);
  Status status;
  for (std::size_t i = 0; status && i < counts[0]; ++i) {
    status = read_node({"", "node", i, counts[0]});
  }
  for (std::size_t i = 0; status && i < counts[1]; ++i) {
    status = read_cell({"", "cell", i, counts[1]});
  }
  // That of the model is numbers alone.
  const bool has_data = counts[2] + counts[3] > 0;
  if (status && (has_data || counts[4] == 0)) status = expect_data(has_data);
  if (status) status = index_by_tags(file_, std::move(tags_), lines_.file(), "at the beginning");
  if (!status) return tl::unexpected(status.error());
  finish_elements(file_);
  return std::move(file_);
}

}  // namespace

Result<ElementFile> read_ucd(const Source& source, NumberReading reading) {
  return UcdReader(source, reading).read();
}

bool is_ucd(const Beginning& beginning) {
  return !beginning.first_token.empty() && beginning.is_number() &&
         beginning.on_first_line == kCounts;
}

}  // namespace circumspect::formats
