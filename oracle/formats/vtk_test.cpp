// VTK's legacy and XML files: surfaces, several pieces, what is refused, and the messages. The
// forms of the same mesh are in element_formats_test.cpp.
#include "oracle/formats/vtk.hpp"

#include <bit>

#include <doctest/doctest.h>

#include "oracle/formats/base64.hpp"
#include "oracle/formats/reading_test.hpp"
#include "oracle/formats/vtu.hpp"
#include "oracle/formats/vtu_arrays.hpp"
#include "oracle/formats/written_elements_test.hpp"

namespace circumspect::formats {
namespace {

Result<ElementFile> vtk(const std::string& text) {
  return read_vtk({"f", text}, NumberReading::kDouble);
}
Result<ElementFile> xml(const std::string& text) {
  return read_vtu({"f", text}, NumberReading::kDouble);
}

std::string grid(const std::string& sections) {
  return "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\n" + sections;
}
const std::string kPoints = "POINTS 4 float\n0 0 0 1 0 0\n0 1 0 0 0 1\n";

std::string array(const std::string& name, const std::string& type, const std::string& values) {
  return "<DataArray type=\"" + type + "\" Name=\"" + name +
         "\" NumberOfComponents=\"3\" format=\"ascii\">" + values + "</DataArray>\n";
}
std::string piece(const std::string& points, const std::string& vertices) {
  return "<Piece NumberOfPoints=\"3\" NumberOfCells=\"1\">\n<Points>\n" +
         array("p", "Float64", points) + "</Points>\n<Cells>\n" +
         array("connectivity", "Int32", vertices) + array("offsets", "Int32", "3") +
         array("types", "UInt8", "5") + "</Cells>\n</Piece>\n";
}
std::string document(const std::string& pieces, const std::string& type = "UnstructuredGrid",
                     const std::string& more = "") {
  return "<VTKFile type=\"" + type + "\"" + more + ">\n<" + type + ">\n" + pieces + "</" + type +
         ">\n</VTKFile>\n";
}
const std::string kThree = "0 0 0 1 0 0 0 1 0";

}  // namespace

TEST_CASE("vtk: surfaces list their cells by type") {
  const auto file = vtk("# vtk DataFile Version 2.0\n\nascii\ndataset polydata\n" + kPoints +
                        "VERTICES 1 2\n1 0\nLINES 1 4\n3 0 1 3\nPOLYGONS 2 9\n3 0 1 2\n4 0 1 2 "
                        "3\nTRIANGLE_STRIPS 1 5\n"
                        "4 0 1 2 3\nPOINT_DATA 4\nSCALARS a float\n");
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->edges.simplices == std::vector<Simplex>{{0, 1}, {1, 3}});
  CHECK(file->triangles.simplices == std::vector<Simplex>{{0, 1, 2}, {0, 1, 2}, {2, 1, 3}});
  CHECK(file->triangles.lines == std::vector<std::size_t>{13, 16, 16});
  CHECK(file->polygons.simplices == std::vector<Simplex>{{0, 1, 2, 3}});
}

TEST_CASE("vtk: numbers in text are what is written; binary floats are exact") {
  const auto text = vtk(grid("POINTS 1 float\n0.1 1/3 0\n"));
  REQUIRE_MESSAGE(text, error_of(text));
  CHECK(text->points.points == std::vector<Point>{{exact_value(0.1), Rational(1, 3), 0}});
  const std::string header =
      "# vtk DataFile Version 3.0\ntitle\nBINARY\nDATASET POLYDATA\nPOINTS 1 ";
  const auto floats = [&](std::uint64_t x) {
    return vtk(header + "float\n" + stored(x, 4, ByteOrder::kBigEndian) +
               stored(1, 4, ByteOrder::kBigEndian) + stored(0, 4, ByteOrder::kBigEndian));
  };
  const auto third = floats(0x3eaaaaab);
  REQUIRE_MESSAGE(third, error_of(third));
  CHECK(third->points.points.front()[0] == Rational(11184811, 33554432));
  CHECK(third->points.points.front()[1] == exact_value(std::ldexp(1, -149)));
  CHECK(error_of(floats(0x7fc00000)) ==
        "f:5: expected a coordinate of point 1 of 1, a finite number, found NaN or an infinity at "
        "byte 72, in POINTS");
}

TEST_CASE("vtk: a cell is what its own type says, whatever those beside it are") {
  const std::string cells = kPoints + "CELLS 2 10\n4 0 1 2 3\n4 0 1 3 2\nCELL_TYPES 2\n";
  const auto first = vtk(grid(cells + "10\n9\n")), last = vtk(grid(cells + "9\n10\n"));
  REQUIRE_MESSAGE(first, error_of(first));
  REQUIRE_MESSAGE(last, error_of(last));
  CHECK(first->tetrahedra.simplices == std::vector<Simplex>{{0, 1, 2, 3}});
  CHECK(first->polygons.simplices == std::vector<Simplex>{{0, 1, 3, 2}});
  CHECK(last->tetrahedra.simplices == std::vector<Simplex>{{0, 1, 3, 2}});
  CHECK(last->polygons.simplices == std::vector<Simplex>{{0, 1, 2, 3}});
}

TEST_CASE("vtk: numbers of cells are those of as many cells, in binary and in text") {
  const auto rows = [](bool is_binary, std::size_t cells, const std::vector<std::size_t>& numbers) {
    NumberWriter out(is_binary ? std::optional(ByteOrder::kBigEndian) : std::nullopt);
    out.word(std::string("# vtk DataFile Version 3.0\nx\n") + (is_binary ? "BINARY" : "ASCII") +
             "\nDATASET POLYDATA\nPOINTS 0 double\n\nLINES " + std::to_string(cells) + " " +
             std::to_string(numbers.size()) + "\n");
    for (const std::size_t number : numbers) out.integer(number, 4);
    return vtk(out.text + "\n");
  };
  for (const bool is_binary : {false, true}) {
    // The numbers of a cell are not those of others, even if they could be.
    const auto file = rows(is_binary, 2, {3, 0, 1, 3, 2, 4, 5});
    REQUIRE_MESSAGE(file, error_of(file));
    CHECK(file->edges.simplices == std::vector<Simplex>{{0, 1}, {1, 3}, {4, 5}});
    CHECK(error_of(rows(is_binary, 1, {2, 0, 1, 2, 1, 2})).find("expected ") != std::string::npos);
    CHECK(error_of(rows(is_binary, 3, {2, 0, 1, 2, 1, 2})).find("expected ") != std::string::npos);
  }
}

TEST_CASE("vtk: what is refused") {
  CHECK(error_of(vtk("vtk")) == "f:1: expected \"# vtk DataFile Version …\", found \"vtk\"");
  CHECK(error_of(vtk("# vtk DataFile Version 3.0\n\nTEXT\n")) ==
        "f:3: expected ASCII or BINARY, found \"TEXT\"");
  CHECK(error_of(vtk("# vtk DataFile Version 3.0\n\nASCII\nDATASET STRUCTURED_POINTS\n")) ==
        "f:4: expected UNSTRUCTURED_GRID or POLYDATA, found \"STRUCTURED_POINTS\"");
  CHECK(error_of(vtk(grid(""))) == "f:4: expected the section POINTS, found the end of the file");
  CHECK(error_of(vtk(grid("POINTS 2 bit\n"))) ==
        "f:5: expected a type of numbers, as double, found \"bit\"");
  CHECK(error_of(vtk(grid("POINTS 999999999999 double\n0 0\n"))) ==
        "f:6: expected a coordinate of point 1 of 999999999999, found the end of the file");
  CHECK(error_of(vtk(grid(kPoints + kPoints))) ==
        "f:8: expected one section POINTS, found \"POINTS\"");
  const std::string cells = "CELLS 1 5\n4 0 1 2 3\n";
  CHECK(error_of(vtk(grid(kPoints + cells + cells))) ==
        "f:10: expected one section CELLS, found \"CELLS\"");
  CHECK(error_of(vtk(grid(kPoints + "CELLS 1 5\n4 0 1 2 3\n"))) ==
        "f:9: expected as many CELL_TYPES as CELLS, 1, found 0");
  CHECK(error_of(vtk(grid(kPoints + "CELLS 1 4\n4 0 1 2 3\nCELL_TYPES 1\n10\n"))) ==
        "f:9: expected 4 numbers of 1 cells, found 5");
  CHECK(error_of(vtk(grid(kPoints + "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n10\n"))) ==
        "f:9: expected a tetrahedron of 4 vertices, found type 10 of 3 vertices");
  CHECK(error_of(vtk(grid(kPoints + "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n0\n"))) ==
        "f:9: expected a type of cells that VTK knows, found type 0 of 3 vertices");
  CHECK(error_of(vtk(grid(kPoints + "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n82\n"))) ==
        "f:9: expected a type of cells that VTK knows, found type 82 of 3 vertices");
  CHECK(vtk(grid(kPoints + "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n81\n"))->first_curved);
  CHECK(error_of(vtk(grid(kPoints + "CELLS 1 4\n-3 0 1 2\n"))) ==
        "f:9: expected the number of vertices of cell 1 of 1, 0 or more, found -3");
  CHECK(error_of(vtk(grid(kPoints + "SCALARS a float\n"))) ==
        "f:8: expected a section, as POINTS or CELLS, found \"SCALARS\"");
  CHECK(error_of(vtk(grid(kPoints + "FIELD f 1\na 8589934592 8589934592 int\n1\n"))) ==
        "f:9: expected a field that the file has room for, found \"int\"");
  CHECK(error_of(vtk(
            grid(kPoints + "FIELD f 2\na 1 1 int\n1\nMETADATA\nINFORMATION 0\n\nb 1 1 real\n"))) ==
        "f:14: expected a type of numbers, as double, found \"real\"");
  const std::string five = "# vtk DataFile Version 5.1\ntitle\nASCII\nDATASET POLYDATA\n" + kPoints;
  CHECK(
      error_of(vtk(
          five + "POLYGONS 2 3\nOFFSETS vtktypeint64\n0 4\nCONNECTIVITY vtktypeint64\n0 1 2\n")) ==
      "f:8: expected an offset from 0 to 3, found 4");
  CHECK(
      error_of(vtk(
          five + "POLYGONS 2 3\nOFFSETS vtktypeint64\n1 3\nCONNECTIVITY vtktypeint64\n0 1 2\n")) ==
      "f:12: expected the first offset 0, found 1");
  CHECK(
      error_of(vtk(
          five + "POLYGONS 2 3\nOFFSETS vtktypeint64\n0 2\nCONNECTIVITY vtktypeint64\n0 1 2\n")) ==
      "f:8: expected offsets up to 3, the end of the vertices of cells, found 2");
  CHECK(error_of(vtk(
            five + "POLYGONS 2 2\nOFFSETS vtktypeint64\n0 2\nCONNECTIVITY vtktypeint64\n0 1\n")) ==
        "f:8: expected a polygon of 3 vertices or more, found one of 2");
  CHECK(vtk(five + "POLYGONS 0 0\n"));
}

TEST_CASE("vtk: doubles are no indices, in a binary file either") {
  const auto bytes_of = [](const std::vector<std::uint64_t>& values) {
    std::string bytes;
    for (const std::uint64_t value : values) bytes += stored(value, 8, ByteOrder::kBigEndian);
    return bytes;
  };
  const auto triangle = [&](const std::string& type, const std::vector<std::uint64_t>& corners) {
    return vtk("# vtk DataFile Version 5.1\nx\nBINARY\nDATASET POLYDATA\nPOINTS 3 double\n" +
               bytes_of(std::vector<std::uint64_t>(9, 0)) +
               "\nPOLYGONS 2 3\nOFFSETS vtktypeint64\n" + bytes_of({0, 3}) + "\nCONNECTIVITY " +
               type + "\n" + bytes_of(corners));
  };
  const auto read = triangle("vtktypeint64", {0, 1, 2});
  REQUIRE_MESSAGE(read, error_of(read));
  CHECK(read->triangles.simplices == std::vector<Simplex>{{0, 1, 2}});
  std::vector<std::uint64_t> doubles;
  for (const double v : {0.0, 1.0, 2.0}) doubles.push_back(std::bit_cast<std::uint64_t>(v));
  CHECK(error_of(triangle("double", doubles)).find(", an integer, found floating-point numbers") !=
        std::string::npos);
}

TEST_CASE("vtu: points of several pieces follow one another") {
  const auto file = xml(document(piece(kThree, "0 1 2") + piece("5 0 0 6 0 0 5 1 0", "2 1 0")));
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->points.points.size() == 6);
  CHECK(file->triangles.simplices == std::vector<Simplex>{{0, 1, 2}, {5, 4, 3}});
  CHECK(error_of(xml(document(piece(kThree, "0 1 3") + piece(kThree, "2 1 0")))) ==
        "f:7: expected a point of this piece in cell 1, found 3");
  // With only one piece, it is the mesh's fault.
  CHECK(xml(document(piece(kThree, "0 1 3"))));
}

TEST_CASE("vtu: numbers in attributes have blanks around, as VTK reads them") {
  const auto with = [](std::string text, const std::string& number, const std::string& other) {
    for (std::size_t at = 0; (at = text.find(number, at)) != std::string::npos;) {
      text.replace(at, number.size(), other);
      at += other.size();
    }
    return text;
  };
  const std::string one = document(piece(kThree, "0 1 2"));
  const auto file = xml(with(with(one, "=\"3\"", "=\"  3\t\""), "=\"1\"", "=\"\n1\""));
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->triangles.simplices == std::vector<Simplex>{{0, 1, 2}});
  const WrittenMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const std::string appended = vtu(mesh, {VtuForm::Place::kAppendedRaw});
  CHECK(xml(with(appended, "offset=\"0\"", "offset=\" 0 \"")));
  CHECK(error_of(xml(with(appended, "offset=\"0\"", "offset=\"x\""))).find("expected offset=") !=
        std::string::npos);
  CHECK(error_of(xml(with(appended, "offset=\"0\"", ""))).find("expected offset=") !=
        std::string::npos);
  CHECK(error_of(xml(with(one, "Points=\"3\"", "Points=\"1 3\""))) ==
        "f:3: expected NumberOfPoints=\"N\", an integer, 0 or more, found \"1 3\"");
  CHECK(error_of(xml(with(one, "Points=\"3\"", "Points=\"  \""))) ==
        "f:3: expected NumberOfPoints=\"N\", an integer, 0 or more, found \"  \"");
  CHECK(error_of(xml(with(one, "Components=\"3\"", "Components=\" 2\""))) ==
        "f:5: expected NumberOfComponents=\"3\", found \" 2\"");
}

TEST_CASE("vtp: surfaces") {
  const auto surface = [](const std::string& line) {
    return xml(
        document("<Piece NumberOfPoints=\"3\" NumberOfVerts=\"0\" NumberOfLines=\"1\" "
                 "NumberOfPolys=\"1\">\n<Points>\n" +
                     array("p", "Float64", kThree) + "</Points>\n<Lines>\n" +
                     array("connectivity", "Int64", line) + array("offsets", "Int64", "2") +
                     "</Lines>\n<Polys>\n" + array("connectivity", "Int64", "2 1 0") +
                     array("offsets", "Int64", "3") + "</Polys>\n</Piece>\n",
                 "PolyData"));
  };
  const auto file = surface("0 2");
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->edges.simplices == std::vector<Simplex>{{0, 2}});
  CHECK(file->triangles.simplices == std::vector<Simplex>{{2, 1, 0}});
  for (const char* const slip : {"0", "0 x", "0 2 1"}) {
    CHECK(error_of(surface(slip)).starts_with("f:"));
  }
}

TEST_CASE("vtu: what is refused") {
  CHECK(error_of(xml("<VTKFile>\n<a>\n</b>\n</VTKFile>"))
            .starts_with("f:3: expected XML, found a fault: "));
  CHECK(error_of(xml("<html/>")) == "f:1: expected the element VTKFile, found \"html\"");
  CHECK(error_of(xml("\n<VTKFile type=\"ImageData\"/>")) ==
        "f:2: expected type=\"UnstructuredGrid\" or \"PolyData\", found \"ImageData\"");
  CHECK(error_of(xml(document("", "UnstructuredGrid", " byte_order=\"PDP\""))) ==
        "f:1: expected byte_order=\"LittleEndian\" or \"BigEndian\", found \"PDP\"");
  CHECK(error_of(xml(document("", "UnstructuredGrid", " compressor=\"vtkBrotli\""))) ==
        "f:1: expected no compressor, vtkZLibDataCompressor, vtkLZ4DataCompressor or "
        "vtkLZMADataCompressor, found \"vtkBrotli\"");
  CHECK(error_of(xml(document("", "UnstructuredGrid", " header_type=\"Int32\""))) ==
        "f:1: expected header_type=\"UInt32\" or \"UInt64\", found \"Int32\"");
  std::string longer = document(piece(kThree, "0 1 2"));
  longer.replace(longer.find("\"offsets\""), 9, "\"others\"");
  CHECK(error_of(xml(longer)) == "f:7: expected a DataArray offsets, found none");
  std::string descending = document(piece(kThree, "0 1 2"));
  for (const auto& [before, after] : {std::pair{"Cells=\"1\"", "Cells=\"2\""},
                                      {"ascii\">3<", "ascii\">4 3<"},
                                      {"ascii\">5<", "ascii\">5 5<"}}) {
    descending.replace(descending.find(before), std::string(before).size(), after);
  }
  CHECK(error_of(xml(descending)) == "f:7: expected an offset from 0 to 3, found 4");
  CHECK(error_of(xml(document(""))) ==
        "f:1: expected an element UnstructuredGrid with a Piece, found none");
  CHECK(error_of(xml(document("<Piece NumberOfCells=\"1\"/>\n"))) ==
        "f:3: expected NumberOfPoints=\"N\", an integer, 0 or more, found none");
  CHECK(error_of(xml(document(piece("0 0 0 1 0 0 0 1", "0 1 2")))) ==
        "f:5: expected a coordinate of point 3 of 3, found the end of the file");
  CHECK(error_of(xml(document(piece(kThree + " 7", "0 1 2")))) ==
        "f:5: expected the end of the points, found \"7\"");
  CHECK(error_of(xml(document(piece("0 0 0\n1 0 0\n0 x 0", "0 1 2")))) ==
        "f:7: expected a coordinate of point 3 of 3, a finite number, found \"x\"");
  std::string negative = document(piece(kThree, "0 1 2"));
  CHECK(error_of(xml(negative.replace(negative.find("ascii\">3<") + 7, 1, "-3"))) ==
        "f:7: expected offsets of 0 or more, found -3");
  CHECK(error_of(xml(document(piece(kThree, "0 1")))) ==
        "f:8: expected one of 3 connectivity, found the end of the file");
}

TEST_CASE("vtu: a piece in bytes follows one in text, whose decimals are exact") {
  const WrittenMesh mesh{{{0, 0, 0}, {0.5, 0, 0}, {0, 3, 0}}, {{0, 1, 2}}};
  std::string text = vtu(mesh, {VtuForm::Place::kInline});
  text.insert(text.find("<Piece"), piece("0.1 0 0 1 0 0 0 1 0", "0 1 2"));
  const auto file = read_vtu({"f", text}, NumberReading::kDecimal);
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->points.points == std::vector<Point>{{Rational(1, 10), 0, 0},
                                                  {1, 0, 0},
                                                  {0, 1, 0},
                                                  {0, 0, 0},
                                                  {Rational(1, 2), 0, 0},
                                                  {0, 3, 0}});
  CHECK(file->triangles.simplices == std::vector<Simplex>{{0, 1, 2}, {3, 4, 5}});
}

TEST_CASE("vtu: bytes that are not what their lengths promise") {
  using enum VtuForm::Place;
  const WrittenMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const std::string raw = vtu(mesh, {kAppendedRaw});
  const auto with_length = [&](const std::string& length) {
    std::string text = raw;
    return error_of(xml(text.replace(text.find("\n_") + 2, 4, length)));
  };
  CHECK(with_length(std::string("\x48\0\0\0", 4)) == "no error");
  CHECK(with_length("\xff\xff\xff\xff")
            .starts_with("f:6: expected 4294967295 bytes of the array, found "));
  CHECK(with_length(std::string("\x40\0\0\0", 4)) ==
        "f:6: expected a coordinate of point 3 of 3, found the end of the data at byte 64");
  std::string inline_text = vtu(mesh, {kInline});
  inline_text.replace(inline_text.find("binary\">\n  ") + 11, 4, "~~~~");
  CHECK(error_of(xml(inline_text)) == "f:6: expected bytes in base 64, found other characters");
  std::string packed = vtu(mesh, {kAppendedRaw, VtuForm::Packed::kByZlib});
  const std::size_t head = packed.find("\n_") + 2;
  CHECK(error_of(xml(packed.substr(0, head) + "\n</AppendedData></VTKFile>")) ==
        "f:6: expected the number of compressed blocks, found the end of the data");
  std::string many = packed;
  CHECK(error_of(xml(many.replace(head, 4, "\xff\xff\xff\xff"))) ==
        "f:6: expected compressed blocks, found 4294967295, more than there are bytes");
  std::string large = packed;
  CHECK(error_of(xml(large.replace(head + 4, 4, "\xff\xff\xff\xff")))
            .starts_with("f:6: expected at most 1"));
  std::string broken = packed;
  CHECK(error_of(xml(broken.replace(head + 20, 4, "abcd"))) ==
        "f:6: expected block 1 of 2, compressed, of 50 bytes, found other data");
  std::string longer = packed;
  CHECK(error_of(xml(longer.replace(head + 4, 4, stored(51, 4, ByteOrder::kLittleEndian)))) ==
        "f:6: expected block 1 of 2, compressed, of 51 bytes, found other data");
  // Two sizes of blocks whose sum is 1, if more than 64 bits are cut off.
  std::string wrapped =
      vtu(mesh, {kAppendedRaw, VtuForm::Packed::kByZlib, ByteOrder::kLittleEndian, 8});
  const std::size_t sizes = wrapped.find("\n_") + 2 + 24;
  wrapped.replace(sizes, 16, std::string(8, '\xff') + stored(2, 8, ByteOrder::kLittleEndian));
  CHECK(error_of(xml(wrapped)) == "f:6: expected compressed blocks, found the end of the data");
  const auto with_offset = [&](std::size_t offset) {
    std::string far = raw;
    const std::string attribute = "offset=\"" + std::to_string(offset) + "\"";
    return error_of(xml(far.replace(far.find("offset=\"0\""), 10, attribute)));
  };
  const std::string refused = with_offset(99999);
  const std::string before = "f:6: expected an offset within the ";
  REQUIRE(refused.starts_with(before));
  const std::size_t end = std::stoul(refused.substr(before.size()));
  CHECK(with_offset(end + 1).starts_with(before));
  CHECK(with_offset(end) ==
        "f:6: expected the number of bytes of the array, found the end of the data");
}

TEST_CASE("base 64: padding within, blanks, faults") {
  CHECK(decode_base64("QUJD", 3) == "ABC");
  CHECK(decode_base64("QQ==QkM=", 9) == "ABC");
  CHECK(decode_base64(" Q\nUJ D", 2) == "AB");
  CHECK(decode_base64("QU\r\nJ\tD", 3) == "ABC");
  CHECK(decode_base64("", 5) == "");
  // What follows the text is another one's.
  CHECK(decode_base64(std::string_view("QUJDREVGR0hJSktM").substr(0, 12), 12) == "ABCDEFGHI");
  CHECK(!decode_base64("QUJ", 3));
  CHECK(!decode_base64("QU*D", 3));
  CHECK(!decode_base64("Q=BD", 3));
  CHECK(!decode_base64("Q===", 3));
}

namespace {

// `count` pieces that all have the same points, whose bytes are appended to the document once.
std::string pieces_of_one_array(std::size_t pieces, std::size_t count) {
  std::string text =
      "<VTKFile type=\"UnstructuredGrid\" byte_order=\"LittleEndian\" header_type=\"UInt32\">"
      "<UnstructuredGrid>\n";
  for (std::size_t i = 0; i < pieces; ++i) {
    text += "<Piece NumberOfPoints=\"" + std::to_string(count) +
            "\" NumberOfCells=\"0\"><Points><DataArray type=\"Float64\" "
            "NumberOfComponents=\"3\" format=\"appended\" offset=\"0\"/></Points></Piece>\n";
  }
  const std::string numbers(24 * count, '\0');
  return text + "</UnstructuredGrid><AppendedData encoding=\"raw\">_" +
         stored(numbers.size(), 4, ByteOrder::kLittleEndian) + numbers +
         "</AppendedData></VTKFile>\n";
}

}  // namespace

TEST_CASE("vtu: pieces may share an array, but not make a large mesh of a small file") {
  const auto few = read_vtu({"f", pieces_of_one_array(3, 5000)}, kDouble);
  REQUIRE_MESSAGE(few, error_of(few));
  CHECK(few->points.points.size() == 15000);
  const std::string text = pieces_of_one_array(1000, 10000);
  CHECK(text.size() < 500'000);
  // The limit is 100000 numbers and one for each byte; each piece has 30000.
  const std::size_t most = 100'000 + text.size();
  CHECK(error_of(read_vtu({"f", text}, kDouble)) ==
        "f:" + std::to_string(2 + most / 30'000) + ": expected at most " + std::to_string(most) +
            " numbers in all arrays of a file of " + std::to_string(text.size()) +
            " bytes, found more, with this array (one that several pieces share counts for each of "
            "them)");
}

TEST_CASE("vtk: a fault behind binary numbers is named by its byte and its section with its line") {
  const auto points = [](const std::string& behind) {
    return "# vtk DataFile Version 5.1\nx\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 1 double\n" +
           std::string(24, '\n') + "\nCELLS 2 1\nOFFSETS vtktypeint64\n" + std::string(15, '\0') +
           "\1" + behind;
  };
  const auto read = [](const std::string& text) {
    return error_of(read_vtk({"f", text}, kDouble));
  };
  const std::string text = points("\nIVITY vtktypeint64\n");
  // For an editor, the numbers of the points contain 24 line ends.
  CHECK(read(text) == "f:31: expected CONNECTIVITY, found \"IVITY\" at byte " +
                          std::to_string(text.find("IVITY")) + ", in CELLS");
  const std::string cut = points("\nCONNECTIVITY vtktypeint64\n\1");
  CHECK(read(cut) == "f:31: expected a number of CONNECTIVITY, found the end of the data at byte " +
                         std::to_string(cut.size() - 1) + ", in CELLS");
  const std::string other =
      points("\nCONNECTIVITY vtktypeint64\n" + std::string(8, '\0') + "\nKELLS 1\n");
  CHECK(read(other) == "f:36: expected a section, as POINTS or CELLS, found \"KELLS\" at byte " +
                           std::to_string(other.find("KELLS")));
}

}  // namespace circumspect::formats
