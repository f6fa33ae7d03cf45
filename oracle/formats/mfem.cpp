#include "oracle/formats/mfem.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/bytes/mixed_text.hpp"

namespace circumspect::formats {
namespace {

constexpr std::array kKinds = {
    ElementType{0, 1, ElementShape::kPoint, "a point"},
    ElementType{1, 2, ElementShape::kPolyline, "an edge"},
    ElementType{2, 3, ElementShape::kPolygon, "a triangle"},
    ElementType{3, 4, ElementShape::kPolygon, "a quadrilateral"},
    ElementType{4, 4, ElementShape::kTetrahedron, "a tetrahedron"},
    ElementType{5, 8, ElementShape::kOtherSolid, "a hexahedron"},
    ElementType{6, 6, ElementShape::kOtherSolid, "a prism"},
    ElementType{7, 5, ElementShape::kOtherSolid, "a pyramid"},
};

class MfemReader {
 public:
  MfemReader(const Source& source, NumberReading reading) : lines_(source), reading_(reading) {}

  Result<ElementFile> read();

 private:
  Status next_row(const std::string& what);
  Result<std::size_t> next_count(const std::string& what);
  Status skip_set_of_attributes();
  Status read_section();
  Status read_elements();
  Status read_vertices();
  // The word behind a key of the section `nodes`: "H1_3D_P2" of "FiniteElementCollection:".
  Result<std::string> word_behind(const std::string& key);
  Status read_nodes();
  // The values of the function, and from them the vertices.
  Status read_values(std::size_t columns, bool is_by_columns);

  Lines lines_;
  NumberReading reading_;
  std::size_t vertices_ = 0;
  bool has_elements_ = false;
  Simplex corners_;
  ElementFile file_;
};

Status MfemReader::next_row(const std::string& what) {
  if (lines_.next()) return {};
  return lines_.fail_at(0, what);
}

Result<std::size_t> MfemReader::next_count(const std::string& what) {
  if (Status row = next_row(what); !row) return tl::unexpected(row.error());
  return lines_.count(0, what);
}

Status MfemReader::read_elements() {
  const Result<std::size_t> count = next_count("the number of elements");
  if (!count) return tl::unexpected(count.error());
  for (std::size_t i = 0; i < *count; ++i) {
    const Item item("", "element", i, *count);
    if (Status row = next_row(item.words()); !row) return row;
    const Result<Vertex> label = lines_.integer(0, "an attribute");
    if (!label) return tl::unexpected(label.error());
    if (lines_.size() < 2) return lines_.fail_at(1, "the kind of " + item.words());
    const Result<Vertex> code = lines_.integer(1, "the kind of an element");
    if (!code) return tl::unexpected(code.error());
    const auto* const kind = std::find_if(
        kKinds.begin(), kKinds.end(), [&](const ElementType& one) { return one.code == *code; });
    if (kind == kKinds.end()) return lines_.fail_at(1, "a kind of elements from 0 to 7");
    if (lines_.size() != 2 + kind->vertices) {
      return lines_.fail("an attribute, a kind and " + std::to_string(kind->vertices) +
                             " vertices of " + std::string(kind->name),
                         std::to_string(lines_.size()) + " columns");
    }
    if (Status read = lines_.integers(2, kind->vertices, "a vertex", corners_); !read) return read;
    add_element(file_, kind->shape, corners_, kind->name, lines_.line(), *label);
  }
  return {};
}

Status MfemReader::read_vertices() {
  if (file_.points.dimension != 0) return lines_.fail("one section of vertices", "another");
  const Result<std::size_t> count = next_count("the number of vertices");
  if (!count) return tl::unexpected(count.error());
  vertices_ = *count;
  if (Status row = next_row("the dimension of vertices, or nodes"); !row) return row;
  if (lines_.tokens()[0] == "nodes") return read_nodes();
  const Result<std::size_t> dimension = lines_.count(0, "the dimension of vertices");
  if (!dimension) return tl::unexpected(dimension.error());
  if (*dimension < 1 || *dimension > 3) return lines_.fail_at(0, "a dimension from 1 to 3");
  file_.points.dimension = *dimension;
  file_.points.points.set_columns(*dimension);
  for (std::size_t i = 0; i < *count; ++i) {
    const Item item("the coordinates of ", "vertex", i, *count);
    if (Status row = next_row(item.words()); !row) return row;
    if (lines_.size() != *dimension) {
      return lines_.fail(std::to_string(*dimension) + " coordinates of vertex " +
                             std::to_string(i + 1) + " of " + std::to_string(*count),
                         std::to_string(lines_.size()));
    }
    Status read = lines_.add_numbers(0, *dimension, reading_, file_.points.points);
    if (!read) return read;
  }
  return {};
}

Result<std::string> MfemReader::word_behind(const std::string& key) {
  if (Status row = next_row(key); !row) return tl::unexpected(row.error());
  if (lines_.size() != 2 || lines_.tokens()[0] != key)
    return lines_.fail_at(0, key + " and its value");
  return std::string(lines_.tokens()[1]);
}

Status MfemReader::read_nodes() {
  if (file_.points.dimension != 0) return lines_.fail("one section of vertices", "another");
  if (Status row = next_row("FiniteElementSpace"); !row) return row;
  if (lines_.tokens()[0] != "FiniteElementSpace") return lines_.fail_at(0, "FiniteElementSpace");
  const Result<std::string> collection = word_behind("FiniteElementCollection:");
  if (!collection) return tl::unexpected(collection.error());
  constexpr std::array<std::string_view, 4> kContinuous = {"H1_", "Linear", "Quadratic", "Cubic"};
  if (std::none_of(kContinuous.begin(), kContinuous.end(),
                   [&](std::string_view one) { return collection->starts_with(one); })) {
    return lines_.fail_at(1, "nodes of a continuous function, as H1_3D_P2");
  }
  const Result<std::string> dimension = word_behind("VDim:");
  if (!dimension) return tl::unexpected(dimension.error());
  if (*dimension != "2" && *dimension != "3") return lines_.fail_at(1, "a dimension, 2 or 3");
  const Result<std::string> ordering = word_behind("Ordering:");
  if (!ordering) return tl::unexpected(ordering.error());
  if (*ordering != "0" && *ordering != "1") return lines_.fail_at(1, "0 or 1");
  if (!collection->starts_with("Linear") && !collection->ends_with("_P1")) {
    file_.notes.push_back(lines_.file() + ": elements of higher order (" + shortened(*collection) +
                          ") are judged by their corners");
  }
  return read_values(*dimension == "2" ? 2 : 3, *ordering == "0");
}

Status MfemReader::read_values(std::size_t columns, bool is_by_columns) {
  PointRows numbers;  // one a row
  numbers.set_columns(1);
  while (lines_.next() && lines_.tokens()[0] != "mfem_mesh_end") {
    if (Status read = lines_.add_numbers(0, lines_.size(), reading_, numbers); !read) return read;
  }
  const std::size_t nodes = numbers.size() / columns;
  if (numbers.size() % columns != 0 || nodes < vertices_) {
    return lines_.fail(std::to_string(columns) + " numbers for each node, and a node for each of " +
                           std::to_string(vertices_) + " vertices",
                       std::to_string(numbers.size()) + " numbers");
  }
  file_.points.dimension = columns;
  file_.points.points.set_columns(columns);
  for (std::size_t v = 0; v < vertices_; ++v) {
    for (std::size_t i = 0; i < columns; ++i) {
      file_.points.points.add(numbers.at(is_by_columns ? i * nodes + v : v * columns + i, 0));
    }
  }
  return {};
}

// A name, which has blanks only in quotes; a count; and as many attributes, on as many lines as
// they take.
Status MfemReader::skip_set_of_attributes() {
  if (Status row = next_row("a set of attributes"); !row) return row;
  std::size_t column = 0;
  const bool is_quoted = lines_.tokens()[0].front() == '"';
  while (is_quoted && column < lines_.size() && lines_.tokens()[column].back() != '"') ++column;
  if (column == lines_.size()) return lines_.fail_at(column, "the end of a name, a quotation mark");
  if (++column == lines_.size()) {
    if (Status row = next_row("the number of attributes of a set"); !row) return row;
    column = 0;
  }
  const Result<std::size_t> count = lines_.count(column, "the number of attributes of a set");
  if (!count) return tl::unexpected(count.error());
  for (std::size_t found = lines_.size() - column - 1; found < *count; found += lines_.size()) {
    if (Status row = next_row("an attribute of a set"); !row) return row;
  }
  return {};
}

Status MfemReader::read_section() {
  const std::string_view keyword = lines_.tokens()[0];
  if (keyword == "dimension") {
    const Result<std::size_t> dimension = next_count("the dimension");
    return dimension ? Status{} : Status(tl::unexpected(dimension.error()));
  }
  if (keyword == "elements" || keyword == "boundary") {
    has_elements_ = true;
    return read_elements();
  }
  if (keyword == "attribute_sets" || keyword == "bdr_attribute_sets") {
    const Result<std::size_t> sets = next_count("the number of sets of attributes");
    if (!sets) return tl::unexpected(sets.error());
    for (std::size_t i = 0; i < *sets; ++i) {
      if (Status set = skip_set_of_attributes(); !set) return set;
    }
    return {};
  }
  if (keyword == "vertices") return read_vertices();
  if (keyword == "nodes") return read_nodes();
  if (keyword == "mfem_mesh_end") return {};
  return lines_.fail_at(0, "a section of a conforming mesh, as elements or vertices");
}

Result<ElementFile> MfemReader::read() {
  const std::string expected = "the line MFEM mesh v1.0";
  if (!lines_.next() || lines_.size() < 3) return lines_.fail_at(lines_.size(), expected);
  if (lines_.tokens()[1] != "mesh") return lines_.fail_at(1, expected);
  if (!lines_.tokens()[2].starts_with("v1.")) return lines_.fail_at(2, expected);
  while (lines_.next()) {
    if (Status section = read_section(); !section) return tl::unexpected(section.error());
  }
  if (!has_elements_) return lines_.fail("the section elements", "the end of the file");
  if (file_.points.dimension == 0)
    return lines_.fail("the section vertices", "the end of the file");
  finish_elements(file_);
  return std::move(file_);
}

}  // namespace

bool is_mfem(const Beginning& beginning) { return beginning.first_token == "MFEM"; }

Result<ElementFile> read_mfem(const Source& source, NumberReading reading) {
  return MfemReader(source, reading).read();
}

}  // namespace circumspect::formats
