#include "oracle/formats/medit.hpp"

#include <array>
#include <cctype>
#include <optional>

#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/bytes/mixed_text.hpp"
#include "oracle/formats/medit_types.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace circumspect::formats {
namespace {

// Sections that are skipped, with the number of numbers of each entry. In the plane, `Normals` and
// `Tangents` have one number less.
struct OtherSection {
  std::string_view keyword;
  std::size_t numbers;
  bool is_spatial = false;
};
constexpr std::array kOtherSections = {
    OtherSection{"Corners", 1},
    OtherSection{"Ridges", 1},
    OtherSection{"RequiredVertices", 1},
    OtherSection{"RequiredEdges", 1},
    OtherSection{"RequiredTriangles", 1},
    OtherSection{"RequiredQuadrilaterals", 1},
    OtherSection{"Normals", 3, true},
    OtherSection{"NormalAtVertices", 2},
    OtherSection{"NormalAtTriangleVertices", 3},
    OtherSection{"NormalAtQuadrilateralVertices", 3},
    OtherSection{"Tangents", 3, true},
    OtherSection{"TangentAtVertices", 2},
    OtherSection{"TangentAtEdges", 3},
    OtherSection{"SubDomainFromMesh", 4},
    OtherSection{"SubDomainFromGeom", 4},
};

class MeditReader {
 public:
  MeditReader(const Source& source, NumberReading reading) : lines_(source), reading_(reading) {}

  Result<ElementFile> read();

 private:
  // Goes to the next token; false at the end of the text.
  bool next();
  std::string_view token() const { return lines_.tokens()[column_]; }
  bool is_ended() const { return column_ >= lines_.size(); }
  tl::unexpected<FormatError> fail(const std::string& expected) const {
    return lines_.fail_at(column_, expected);
  }
  Result<std::size_t> next_count(std::string_view what);
  // The next integer; after the first error all are 0, and failure_ is that error.
  Vertex take(const Item& item);

  Status read_header();
  Status read_dimension();
  Status read_section();
  Status read_vertices();
  Status read_elements(const MeditSection& section);
  Status skip_numbers(const OtherSection& section);
  void skip_unknown();

  Lines lines_;
  NumberReading reading_;
  std::size_t column_ = 0;
  ElementFile file_;
  bool has_vertices_ = false;
  std::optional<FormatError> failure_ = {};
  bool has_token_ = false;  // the keyword of the next section was met by skipping
};

bool MeditReader::next() {
  if (has_token_) {
    has_token_ = false;
    return true;
  }
  if (++column_ < lines_.size()) return true;
  column_ = 0;
  return lines_.next();
}

Result<std::size_t> MeditReader::next_count(std::string_view what) {
  if (!next()) return fail(std::string(what));
  return lines_.count(column_, what);
}

Vertex MeditReader::take(const Item& item) {
  if (failure_) return 0;
  if (!next()) {
    failure_ = fail(item.words()).value();
    return 0;
  }
  if (const auto plain = lines_.plain_integer(column_)) return *plain;
  const Result<Vertex> value = lines_.integer(column_, item.words());
  if (value) return *value;
  failure_ = value.error();
  return 0;
}

Status MeditReader::read_header() {
  if (!next() || !is_medit_keyword(token())) return fail("the keyword MeshVersionFormatted");
  const Result<std::size_t> version = next_count("the version");
  if (!version) return tl::unexpected(version.error());
  return {};
}

Status MeditReader::read_dimension() {
  if (file_.points.dimension != 0) return fail("one Dimension");
  const Result<std::size_t> dimension = next_count("the dimension");
  if (!dimension) return tl::unexpected(dimension.error());
  if (*dimension != 2 && *dimension != 3) return fail("dimension 2 or 3");
  file_.points.dimension = *dimension;
  file_.points.points.set_columns(*dimension);
  return {};
}

Status MeditReader::read_vertices() {
  const std::size_t dimension = file_.points.dimension;
  if (dimension == 0) return fail("\"Dimension\" before Vertices");
  if (has_vertices_) return fail("one section Vertices");
  has_vertices_ = true;
  const Result<std::size_t> count = next_count("the number of vertices");
  if (!count) return tl::unexpected(count.error());
  for (std::size_t i = 0; i < *count; ++i) {
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      if (!next()) return fail(Item("", "vertex", i, *count).words());
      const Status number = lines_.add_numbers(column_, 1, reading_, file_.points.points);
      if (!number) return number;
    }
    take({"the reference of ", "vertex", i, *count});
    if (failure_) return tl::unexpected(*failure_);
  }
  return {};
}

Status MeditReader::read_elements(const MeditSection& section) {
  const Result<std::size_t> count = next_count("the number of cells");
  if (!count) return tl::unexpected(count.error());
  const std::string noun(section.noun);
  const std::string name = std::string(section.article) + " " + noun;
  Simplex element(section.vertices);
  for (std::size_t i = 0; i < *count; ++i) {
    std::size_t line = 0;
    for (Vertex& vertex : element) {
      vertex = take({"a vertex of ", noun, i, *count});
      if (line == 0) line = lines_.line();
    }
    const Vertex label = take({"the reference of ", noun, i, *count});
    if (failure_) return tl::unexpected(*failure_);
    add_element(file_, section.shape, element, name, line, label);
  }
  return {};
}

Status MeditReader::skip_numbers(const OtherSection& section) {
  const std::string keyword(section.keyword);
  const Result<std::size_t> count = next_count("the number of " + keyword);
  if (!count) return tl::unexpected(count.error());
  const bool is_flat = section.is_spatial && file_.points.dimension == 2;
  const std::size_t numbers = section.numbers - (is_flat ? 1 : 0);
  for (std::size_t i = 0; i < *count; ++i) {
    for (std::size_t j = 0; j < numbers; ++j) {
      const std::string what = "a number of " + keyword;
      if (!next()) return fail(what);
      const Result<Rational> number = lines_.number(column_, NumberReading::kDouble);
      if (!number) return fail(what);
    }
  }
  return {};
}

// Skips to the next keyword; text in quotes is not a keyword.
void MeditReader::skip_unknown() {
  bool in_quotes = false;
  while (next()) {
    const std::string_view word = token();
    for (const char c : word) in_quotes ^= c == '"';
    if (in_quotes || word.back() == '"') continue;
    if (std::isalpha(static_cast<unsigned char>(word.front())) != 0) {
      has_token_ = true;
      return;
    }
  }
}

// Requires: the current token is the keyword of a section.
Status MeditReader::read_section() {
  const std::string_view keyword = token();
  if (keyword == "Dimension") return read_dimension();
  if (keyword == "Vertices") return read_vertices();
  for (const MeditSection& section : kMeditSections) {
    if (section.keyword == keyword) return read_elements(section);
  }
  for (const OtherSection& section : kOtherSections) {
    if (section.keyword == keyword) return skip_numbers(section);
  }
  if (std::isalpha(static_cast<unsigned char>(keyword.front())) == 0) return fail("a keyword");
  skip_unknown();
  return {};
}

Result<ElementFile> MeditReader::read() {
  if (Status header = read_header(); !header) return tl::unexpected(header.error());
  while (true) {
    if (!next()) {
      if (!has_vertices_) return fail("a keyword, as Vertices");
      file_.notes.push_back(lines_.file() +
                            ": no keyword End; if the file was cut off, it is in between sections");
      break;
    }
    if (token() == "End") break;
    if (Status section = read_section(); !section) return tl::unexpected(section.error());
  }
  if (!has_vertices_) return fail("Vertices before the end");
  if (file_.notes.empty() && next()) return fail("the end of the file after End");
  file_.points.first_index = 1;
  finish_elements(file_);
  return std::move(file_);
}

}  // namespace

bool is_medit_keyword(std::string_view token) { return token == "MeshVersionFormatted"; }

Result<ElementFile> read_medit(const Source& source, NumberReading reading) {
  return MeditReader(source, reading).read();
}

void write_medit(std::ostream& out, const ElementFile& file) {
  out << "MeshVersionFormatted 2\nDimension " + std::to_string(file.points.dimension) + "\n";
  out << "Vertices " + std::to_string(file.points.points.size()) + "\n";
  for (const Point& point : file.points.points) out << joined(point) + " 0\n";
  const auto write = [&](const char* keyword, const SimplexFile& cells) {
    if (cells.simplices.empty()) return;
    out << keyword << " " + std::to_string(cells.simplices.size()) + "\n";
    for (std::size_t i = 0; i < cells.simplices.size(); ++i) {
      Simplex cell = cells.simplices[i];
      for (Vertex& v : cell) v = index_of_place(place_of_index(v, file.points.first_index), 1);
      const Vertex reference = cells.labels.empty() ? 0 : cells.labels[i];
      out << joined(cell) + " " + std::to_string(reference) + "\n";
    }
  };
  write("Edges", file.edges);
  write("Triangles", file.triangles);
  write("Quadrilaterals", file.polygons);
  write("Tetrahedra", file.tetrahedra);
  out << "End\n";
}

}  // namespace circumspect::formats
