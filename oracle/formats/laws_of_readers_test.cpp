// Laws of the readers of elements: a count that is wrong by one is noticed, in either direction,
// and an integer means the same number whatever type stores it.
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <variant>

#include <doctest/doctest.h>

#include "inputs/scratch_folder_test.hpp"
#include "oracle/formats/format.hpp"
#include "oracle/formats/npy.hpp"
#include "oracle/formats/reading_test.hpp"
#include "oracle/formats/written_elements_test.hpp"
#include "oracle/model/words.hpp"

namespace circumspect::formats {
namespace {

constexpr std::size_t kManyPoints = 30, kManyCells = 23;
constexpr std::size_t kManyCorners = 8 * 2 + 8 * 3 + 7 * 4;  // of all cells

// None of these numbers is an index of a cell, or stands in a coordinate.
WrittenMesh mesh_of_telling_counts() {
  WrittenMesh mesh;
  for (std::size_t i = 0; i < kManyPoints; ++i)
    mesh.points.push_back({0.5 + 0.125 * static_cast<double>(i), 0.0625, 1.5});
  for (std::size_t i = 0; i < kManyCells; ++i) {
    const int v = static_cast<int>(i % 7);
    mesh.cells.push_back({v, v + 1, v + 2, v + 3});
    mesh.cells.back().resize(2 + i % 3);
  }
  return mesh;
}

bool is_decimal_digit(char c) { return c >= '0' && c <= '9'; }

// Where the bytes stand in a text; a number in digits only if it is not part of another one.
std::vector<std::size_t> places_of(const std::string& text, const std::string& bytes) {
  std::vector<std::size_t> places;
  for (std::size_t at = text.find(bytes); at != std::string::npos; at = text.find(bytes, at + 1)) {
    const std::size_t end = at + bytes.size();
    const auto is_of_number = [&](char c) { return is_decimal_digit(c) || c == '.'; };
    const bool goes_on =
        is_decimal_digit(bytes.front()) &&
        ((at > 0 && is_of_number(text[at - 1])) || (end < text.size() && is_of_number(text[end])));
    if (!goes_on) places.push_back(at);
  }
  return places;
}

// A count as text, and as binary formats store it.
std::vector<std::string> ways_to_write(std::size_t count) {
  std::vector<std::string> ways = {std::to_string(count)};
  for (const std::size_t size : {4U, 8U}) {
    for (const ByteOrder order : {ByteOrder::kLittleEndian, ByteOrder::kBigEndian}) {
      ways.push_back(stored(count, size, order));
    }
  }
  return ways;
}

bool are_same(const ElementFile& a, const ElementFile& b) {
  return a.points.points == b.points.points && a.points.first_index == b.points.first_index &&
         a.edges.simplices == b.edges.simplices && a.triangles.simplices == b.triangles.simplices &&
         a.tetrahedra.simplices == b.tetrahedra.simplices;
}

// One triangle whose last vertex has these bytes, in VTK's XML.
std::string vtu_with(const std::string& type, const std::string& bytes, ByteOrder order) {
  return std::string("<VTKFile type=\"UnstructuredGrid\" byte_order=\"") +
         (order == ByteOrder::kBigEndian ? "BigEndian" : "LittleEndian") +
         "\"><UnstructuredGrid><Piece NumberOfPoints=\"0\" NumberOfCells=\"1\"><Cells>"
         "<DataArray type=\"" +
         type +
         "\" Name=\"connectivity\" format=\"appended\" offset=\"0\"/>"
         "<DataArray type=\"Int8\" Name=\"offsets\" format=\"ascii\">3</DataArray>"
         "<DataArray type=\"Int8\" Name=\"types\" format=\"ascii\">5</DataArray>"
         "</Cells></Piece></UnstructuredGrid><AppendedData encoding=\"raw\">_" +
         stored(bytes.size(), 4, order) + bytes + "</AppendedData></VTKFile>";
}

// The same in VTK's legacy form.
std::string vtk_with(const std::string& type, const std::string& bytes) {
  constexpr ByteOrder kOrder = ByteOrder::kBigEndian;
  return "# vtk DataFile Version 5.1\nx\nBINARY\nDATASET POLYDATA\nPOINTS 0 double\n\n"
         "POLYGONS 2 3\nOFFSETS int\n" +
         stored(0, 4, kOrder) + stored(3, 4, kOrder) + "\nCONNECTIVITY " + type + "\n" + bytes +
         "\n";
}

struct IntegerType {
  const char* of_xml;
  const char* of_legacy;
  const char* of_numpy;
  std::size_t size;
  bool is_signed;
};
constexpr IntegerType kIntegerTypes[] = {
    {"Int8", "char", "i1", 1, true},       {"UInt8", "unsigned_char", "u1", 1, false},
    {"Int16", "short", "i2", 2, true},     {"UInt16", "unsigned_short", "u2", 2, false},
    {"Int32", "int", "i4", 4, true},       {"UInt32", "unsigned_int", "u4", 4, false},
    {"Int64", "long", "i8", 8, true},      {"UInt64", "unsigned_long", "u8", 8, false},
    {"Int32", "vtkIdType", "i4", 4, true}, {"Int64", "vtktypeint64", "i8", 8, true}};

std::string bytes_of_vertices(const IntegerType& type, Vertex last, ByteOrder order) {
  return stored(0, type.size, order) + stored(1, type.size, order) +
         stored(static_cast<std::uint64_t>(last), type.size, order);
}

// The same in XDMF, with the bytes in a file beside it.
void check_in_xdmf(const IntegerType& type, const std::string& bytes, ByteOrder order,
                   const Simplex& expected) {
  if (type.size == 2) return;  // it has no such type
  const ScratchFolder folder;
  const std::string name =
      std::string(type.is_signed ? "" : "U") + (type.size > 1 ? "Int" : "Char");
  const Source source{folder.path("x.xdmf"),
                      "<Xdmf><Domain><Grid><Geometry><DataItem Dimensions=\"0 3\"/></Geometry>"
                      "<Topology Type=\"Triangle\"><DataItem Dimensions=\"1 3\" NumberType=\"" +
                          name + "\" Precision=\"" + std::to_string(type.size) +
                          "\" Format=\"Binary\" Endian=\"" +
                          (order == ByteOrder::kBigEndian ? "Big" : "Little") +
                          "\">cells.bin</DataItem></Topology></Grid></Domain></Xdmf>"};
  folder.write("cells.bin", bytes);
  const auto read = read_xdmf(source, kDouble);
  REQUIRE_MESSAGE(read, error_of(read));
  CHECK(read->triangles.simplices == std::vector<Simplex>{expected});
  for (const std::string& other : {bytes.substr(1), bytes + "\1"}) {
    folder.write("cells.bin", other);
    CHECK(!read_xdmf(source, kDouble));
  }
}

// What the readers make of a triangle 0, 1 and `last`.
void check_last_vertex(const IntegerType& type, Vertex last) {
  CAPTURE(type.of_legacy);
  CAPTURE(last);
  const Simplex expected = {0, 1, last};
  for (const ByteOrder order : {ByteOrder::kLittleEndian, ByteOrder::kBigEndian}) {
    const std::string bytes = bytes_of_vertices(type, last, order);
    const auto xml = read_vtu(named(vtu_with(type.of_xml, bytes, order)), kDouble);
    REQUIRE_MESSAGE(xml, error_of(xml));
    CHECK(xml->triangles.simplices == std::vector<Simplex>{expected});
    check_in_xdmf(type, bytes, order, expected);
    const std::string header = std::string("{'descr': '") +
                               (order == ByteOrder::kBigEndian ? ">" : "<") + type.of_numpy +
                               "', 'fortran_order': False, 'shape': (1, 3), }";
    const auto numpy = read_npy_simplices(named(npy_with_header(header, bytes)));
    REQUIRE_MESSAGE(numpy, error_of(numpy));
    CHECK(numpy->simplices == std::vector<Simplex>{expected});
  }
  const auto legacy = read_vtk(
      named(vtk_with(type.of_legacy, bytes_of_vertices(type, last, ByteOrder::kBigEndian))),
      kDouble);
  REQUIRE_MESSAGE(legacy, error_of(legacy));
  CHECK(legacy->triangles.simplices == std::vector<Simplex>{expected});
}

}  // namespace

TEST_CASE("a count that is one more or one less than what is there changes no mesh unnoticed") {
  for (const WrittenForm& form : all_forms(mesh_of_telling_counts())) {
    CAPTURE(form.name);
    const auto whole = read_form(form, kDouble);
    REQUIRE_MESSAGE(whole, error_of(whole));
    std::size_t tried = 0, refused = 0;
    for (const std::size_t count :
         {kManyPoints, kManyCells, kManyCorners, kManyCorners + kManyCells}) {
      for (const std::string& way : ways_to_write(count)) {
        for (const std::size_t place : places_of(form.text, way)) {
          for (const std::size_t other : {count - 1, count + 1}) {
            WrittenForm changed = form;
            const auto ways = ways_to_write(count), others = ways_to_write(other);
            const auto which = std::find(ways.begin(), ways.end(), way) - ways.begin();
            changed.text.replace(place, way.size(), others[static_cast<std::size_t>(which)]);
            const auto file = read_form(changed, kDouble);
            CAPTURE(place);
            CAPTURE(other);
            if (file) CHECK(are_same(*file, *whole));
            ++tried;
            refused += file ? 0 : 1;
          }
        }
      }
    }
    CHECK(tried > 0);
    CHECK(refused > 0);
  }
}

TEST_CASE("a byte order mark, carriage returns and the end of the last line change no text") {
  std::size_t texts = 0;
  for (const WrittenForm& form : all_forms(mesh_of_telling_counts())) {
    const bool is_text = std::all_of(form.text.begin(), form.text.end(), [](unsigned char c) {
      return c == '\n' || (c >= ' ' && c <= '~');
    });
    if (!is_text) continue;
    CAPTURE(form.name);
    const auto whole = read_form(form, kDouble);
    REQUIRE_MESSAGE(whole, error_of(whole));
    std::string returned;
    for (const char c : form.text) returned += c == '\n' ? "\r\n" : std::string(1, c);
    std::string cut = form.text;
    while (cut.ends_with('\n')) cut.pop_back();
    for (const std::string& text :
         {std::string(kByteOrderMark) + form.text, returned, cut, form.text + "\n \n"}) {
      CAPTURE(text);
      WrittenForm changed = form;
      changed.text = text;
      const auto read = read_form(changed, kDouble);
      REQUIRE_MESSAGE(read, error_of(read));
      CHECK(are_same(*read, *whole));
    }
    ++texts;
  }
  CHECK(texts >= 8);
}

TEST_CASE("a decimal in text is what the reading says, and a double in binary is itself") {
  WrittenMesh mesh = mesh_of_telling_counts();
  mesh.points[2][1] = 0.1;
  const std::string digits = digits_of(0.1);
  std::size_t decimals = 0;
  for (WrittenForm form : all_forms(mesh)) {
    CAPTURE(form.name);
    std::size_t place = form.text.find(digits);
    const bool is_text = place != std::string::npos;
    // As it is written by hand; a field of fixed columns stays as long as it is.
    if (is_text) form.text.replace(place, digits.size(), in_columns("0.1", digits.size()));
    const auto rounded = read_form(form, kDouble);
    const auto exact = read_form(form, NumberReading::kDecimal);
    REQUIRE_MESSAGE(rounded, error_of(rounded));
    REQUIRE_MESSAGE(exact, error_of(exact));
    CHECK(rounded->points.points.at(2, 1) == exact_value(0.1));
    const bool is_ours = form.name.find("ours") != std::string::npos || form.name == "medit";
    if (is_ours) continue;
    CHECK(exact->points.points.at(2, 1) == (is_text ? Rational(1, 10) : exact_value(0.1)));
    decimals += is_text ? 1 : 0;
  }
  CHECK(decimals > 10);
}

TEST_CASE("a zero is the same zero in every form, whatever its sign") {
  WrittenMesh mesh = mesh_of_telling_counts();
  mesh.points[2] = {-0.0, -0.0, -0.0};
  for (const WrittenForm& form : all_forms(mesh)) {
    CAPTURE(form.name);
    auto file = read_form(form, kDouble);
    REQUIRE_MESSAGE(file, error_of(file));
    const Numbers numbers = std::move(file->points.points).as_numbers(3);
    const auto row = std::get<Rows<double>>(numbers).row(2);
    CHECK(std::none_of(row.begin(), row.end(), [](double x) { return std::signbit(x); }));
  }
}

TEST_CASE("an element has the line on which its vertices begin; in binary it has none") {
  const WrittenMesh mesh = mesh_of_telling_counts();
  for (const WrittenForm& form : all_forms(mesh)) {
    CAPTURE(form.name);
    const auto file = read_form(form, kDouble);
    REQUIRE_MESSAGE(file, error_of(file));
    std::vector<std::string> lines = {""};
    for (const char c : form.text) {
      if (c == '\n') lines.emplace_back();
      if (c != '\n') lines.back() += c == ',' ? ' ' : c;
    }
    const bool is_binary = form.name.find("endian") != std::string::npos ||
                           form.extension == ".meshb" || form.name.ends_with("binary");
    if (!is_binary && (form.extension == ".vtu" || form.extension == ".vtk")) continue;
    const SimplexFile& list = file->tetrahedra;
    for (std::size_t i = 0; i < list.simplices.size(); ++i) {
      const std::size_t line = list.lines[i];
      CHECK((line == 0) == is_binary);
      if (line == 0 || line >= lines.size()) continue;
      const std::string text = " " + lines[line - 1] + " " + lines[line] + " ";
      for (const Vertex v : list.simplices[i]) {
        CHECK(text.find(" " + std::to_string(v) + " ") != std::string::npos);
      }
    }
  }
}

TEST_CASE("elements belong to the first group that a file of Gmsh names for them") {
  for (const WrittenForm& form : all_forms(mesh_of_telling_counts())) {
    if (!form.name.starts_with("gmsh") || form.name.ends_with("ours")) continue;
    CAPTURE(form.name);
    const auto file = read_form(form, kDouble);
    REQUIRE_MESSAGE(file, error_of(file));
    for (const SimplexFile* const list : {&file->edges, &file->triangles, &file->tetrahedra}) {
      CHECK(list->labels == std::vector<Vertex>(list->simplices.size(), 7));
    }
  }
}

TEST_CASE("the content of a file tells its format, in every form that does not need its name") {
  for (const WrittenForm& form : all_forms(mesh_of_telling_counts())) {
    CAPTURE(form.name);
    if (form.name == "ucd") continue;
    const Format* const format = told_format(named(form.text), &Format::has_mesh);
    REQUIRE(format != nullptr);
    CHECK(format->endings.front() == form.extension);
  }
}

TEST_CASE("a mesh that is written is read back, in the plane and in space") {
  for (const std::size_t dimension : {2U, 3U}) {
    ElementFile mesh;
    mesh.points.dimension = dimension;
    mesh.points.points.set_columns(dimension);
    for (const double x : {0.5, 0.0, 1.0, 7.0, 2.0, 1.0, 3.0, 0.25, 5.0}) {
      if (dimension == 3 || x < 5.0) mesh.points.points.add(x);
    }
    add_element(mesh, ElementShape::kPolygon, Simplex{0, 1, 2}, "a triangle", 0);
    finish_elements(mesh);
    for (const std::string_view ending : written_endings()) {
      CAPTURE(ending);
      std::ostringstream out;
      writer_of(ending)(out, mesh);
      const auto read = format_of(ending)->elements(named(out.str()), kDouble);
      REQUIRE_MESSAGE(read, error_of(read));
      CHECK(read->triangles.simplices.size() == 1);
      CHECK(out.str().find("Tetrahedra") == std::string::npos);  // no list of none
      for (std::size_t i = 0; i < mesh.points.points.size(); ++i) {
        for (std::size_t axis = 0; axis < read->points.points.columns(); ++axis) {
          const Rational expected = axis < dimension ? mesh.points.points.at(i, axis) : Rational(0);
          CHECK(read->points.points.at(i, axis) == expected);
        }
      }
    }
  }
}

TEST_CASE("an integer is the same number in every type that can store it") {
  for (const IntegerType& type : kIntegerTypes) {
    const std::size_t bits = 8 * type.size - (type.is_signed ? 1 : 0);
    const Vertex most = bits >= 63 ? std::numeric_limits<Vertex>::max()
                                   : static_cast<Vertex>((std::uint64_t{1} << bits) - 1);
    for (const Vertex last : {Vertex{2}, most / 2 + 1, most}) check_last_vertex(type, last);
    if (type.is_signed) {
      check_last_vertex(type, -1);
      check_last_vertex(type, -most - 1);
    }
  }
}

TEST_CASE("an integer of 64 bits without a sign that is none with one is refused") {
  const IntegerType& type = kIntegerTypes[7];
  const Vertex negative = std::numeric_limits<Vertex>::min();
  for (const ByteOrder order : {ByteOrder::kLittleEndian, ByteOrder::kBigEndian}) {
    const std::string bytes = bytes_of_vertices(type, negative, order);
    CHECK(!read_vtu(named(vtu_with(type.of_xml, bytes, order)), kDouble));
  }
  CHECK(!read_vtk(
      named(vtk_with(type.of_legacy, bytes_of_vertices(type, negative, ByteOrder::kBigEndian))),
      kDouble));
}

}  // namespace circumspect::formats
