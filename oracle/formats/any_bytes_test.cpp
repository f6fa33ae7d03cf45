// Properties of all readers: no bytes crash them, every error is one line with the name of the
// file, and a mesh that is written is read back unchanged.
#include <sstream>

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "oracle/formats/format.hpp"
#include "oracle/formats/json.hpp"
#include "oracle/formats/medit.hpp"
#include "oracle/formats/npy.hpp"
#include "oracle/formats/obj.hpp"
#include "oracle/formats/off.hpp"
#include "oracle/formats/ply.hpp"
#include "oracle/formats/point_file.hpp"
#include "oracle/formats/point_lists.hpp"
#include "oracle/formats/poly.hpp"
#include "oracle/formats/qhull.hpp"
#include "oracle/formats/reading_test.hpp"
#include "oracle/formats/stl.hpp"
#include "oracle/formats/tetgen.hpp"
#include "oracle/formats/written_elements_test.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::formats {
namespace {

template <class T>
void expect_success_or_one_line(const Result<T>& result) {
  if (result) return;
  const std::string message = result.error().to_string();
  RC_ASSERT((message.starts_with("f:") || message.starts_with("f.node:")) &&
            message.find('\n') == std::string::npos);
  RC_ASSERT(message.size() < 1000U);
}

Result<PointFile> three_points() {
  return PointFile{3, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, {}, 1};
}

void read_as_every_format(const std::string& text) {
  const Source source{"f", text};
  for (const NumberReading reading : {kDouble, NumberReading::kDecimal}) {
    for (const Format& format : formats()) {
      if (format.has_points()) expect_success_or_one_line(format.read_points(source, reading));
      if (format.has_mesh()) expect_success_or_one_line(format.read_mesh(source, reading));
      if (format.has_domain()) expect_success_or_one_line(format.read_domain(source, reading));
    }
    // The points of these may be elsewhere.
    expect_success_or_one_line(read_poly(source, reading, three_points));
    expect_success_or_one_line(read_smesh(source, reading, three_points));
  }
  expect_success_or_one_line(read_neigh(source));
  expect_success_or_one_line(read_face(source, 3));
  expect_success_or_one_line(read_face(source, 2));
}

const std::vector<std::string> kSamples = {
    "# points\n3 2 1 1\r\n1 0 0 0.5 7\n2 1.5 -2e3 1/3 0\n3 0x1p3 4 5 6\n",
    "2 4 1\n1 1 2 3 4 9\n2 2 3 4 5 9\n",
    "2 3\n0 -1 1 -1\n1 0 -1 -1\n",
    "nOFF\n2\n3 1 3\n0 0\n1 0\n0 1\n3 0 1 2\n",
    "COFF 3 1 3\n0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2 0.5\n",
    "3 rbox\n2\n0 0 0\n0.25 1e-300 7\n",
    "2\n0 1 2\n1 2 3 4\n",
    "{\"circumspect\": 1, \"dimension\": 2, \"first_index\": 1,\n\"points\": [[0, 1e5], [\"1/3\", "
    "-2.5], [3, \"0x1p-3\"]],\n\"weights\": [0, 1, \"1/2\"],\n\"simplices\": [[1, 2, 3]], "
    "\"comment\": \"\\u00e9\"}\n",
    "3 2\n1 0 0\n2 1 0\n3 0 1\n2 1\n1 1 2 1\n2 2 3 1\n1\n1 5 5\n1\n1 2 2 3 4\n",
    "4 3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n2 1\n2 1 1\n3 1 2 3\n2 1 4\n1 .2 .2 0\n1\n2 3 "
    "4\n0\n",
    "0\n2 1\n3 1 2 3 1\n2 1 2 1\n0\n1\n1 0 0 0 7\n",
    "2 1\n1 1 2 3 0 1 -1\n2 1 2 4 0 -1 2\n",
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
    "0\nendloop\nendfacet\nendsolid a\n",
    std::string(80, ' ') + std::string("\1\0\0\0", 4) + std::string(24, '\0') + "@@@@" +
        std::string(12, '\0') + "@@@@" + std::string(4, '\0') + "\1\2",
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 "
    "0 1 2\n",
    "ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty char x\nproperty char "
    "y\nproperty char z\nelement face 1\nproperty list uchar char vertex_index\nend_header\n" +
        std::string("\1\2\3\4\5\6\2\0\1", 9),
    "MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\nCorners "
    "1\n1\nEdges 1\n1 2 0\nTriangles 1\n1 2 3 0\nTetrahedra 1\n1 2 3 4 0\nEnd\n",
    "mtllib a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 \\\n3/1\nl -1 -2\n",
    "id;x;y\n1;0.5;2\n2;1/3;4\n",
    "<Xdmf><Domain><Grid><Geometry GeometryType=\"XY\"><DataItem Dimensions=\"3 2\">0 0 1 0 0 1"
    "</DataItem></Geometry><Topology TopologyType=\"Mixed\"><DataItem Dimensions=\"8\">4 0 1 2 2 2 "
    "0 1</DataItem></Topology></Grid></Domain></Xdmf>"};

// Draws one of the forms of a mesh of elements.
const WrittenMesh kElements = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.1}},
                               {{0, 1}, {0, 1, 2}, {0, 1, 2, 3}}};

const std::vector<std::string> kTokens = {"0",
                                          "1",
                                          "2",
                                          "3",
                                          "-1",
                                          "4",
                                          "1.5",
                                          "1e400",
                                          "nan",
                                          "0x1p9",
                                          "1/3",
                                          "1/0",
                                          "ply",
                                          "solid",
                                          "endsolid",
                                          "MeshVersionFormatted",
                                          "Vertices",
                                          "End",
                                          "property",
                                          "$Nodes",
                                          "$EndNodes",
                                          "$Elements",
                                          "\n$MeshFormat\n2.2 0 8\n$EndMeshFormat\n",
                                          "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\n",
                                          "POINTS",
                                          "CELLS",
                                          "POLYGONS",
                                          "double",
                                          "OFFSETS",
                                          "FIELD",
                                          "METADATA",
                                          "<VTKFile>",
                                          "</DataArray>",
                                          "<AppendedData>_",
                                          "offset=\"9\"",
                                          "vertices",
                                          "inner tets",
                                          "v",
                                          "f",
                                          "l",
                                          "-1/2",
                                          "element",
                                          "end_header",
                                          "#",
                                          "OFF",
                                          "nOFF",
                                          "{",
                                          "}",
                                          "[",
                                          "]",
                                          ",",
                                          ":",
                                          "\"points\"",
                                          "9223372036854775807",
                                          "-9223372036854775808",
                                          "99999999999999999999",
                                          "1e999999999",
                                          "\"circumspect\"",
                                          "\"dimension\"",
                                          "\"simplices\"",
                                          "\"weights\"",
                                          "\"",
                                          "\\",
                                          "null",
                                          "true",
                                          "\"1/3\"",
                                          std::string(1, '\0'),
                                          "\xff",
                                          "\r",
                                          "x"};

// Numbers that a double holds, and numbers that it does not.
rc::Gen<Rational> number() {
  return rc::gen::apply(
      [](std::int32_t above, std::uint8_t below, bool huge) {
        Rational value(above, below + 1U);
        value.canonicalize();
        return huge ? Rational(value * Integer("9007199254740993")) : value;
      },
      rc::gen::arbitrary<std::int32_t>(), rc::gen::arbitrary<std::uint8_t>(),
      rc::gen::arbitrary<bool>());
}

PointFile some_points() {
  PointFile file;
  file.dimension = *rc::gen::inRange<std::size_t>(1, 5);
  const auto count = *rc::gen::inRange<std::size_t>(0, 6);
  for (std::size_t i = 0; i < count; ++i) {
    file.points.push_back(*rc::gen::container<Point>(file.dimension, number()));
  }
  return file;
}

SimplexFile some_simplices() {
  SimplexFile file;
  file.vertices_per_simplex = *rc::gen::inRange<std::size_t>(1, 5);
  const auto count = *rc::gen::inRange<std::size_t>(1, 6);
  for (std::size_t i = 0; i < count; ++i) {
    file.simplices.push_back(
        *rc::gen::container<Simplex>(file.vertices_per_simplex, rc::gen::arbitrary<Vertex>()));
  }
  return file;
}

template <class File, class Write>
Source written(const File& file, Write write) {
  std::ostringstream out;
  write(out, file);
  return {"f", out.str()};
}

}  // namespace

TEST_CASE("any bytes") {
  CHECK(properties::holds("bytes", [] {
    read_as_every_format(*rc::gen::container<std::string>(rc::gen::arbitrary<char>()));
  }));
  CHECK(properties::holds("tokens in any order", [] {
    std::string text;
    for (const std::string& token :
         *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(kTokens))) {
      text += token + *rc::gen::element<std::string>(" ", "\n", "");
    }
    read_as_every_format(text);
  }));
}

TEST_CASE("files with a few bytes changed, lost, added, or cut off") {
  CHECK(properties::holds("mutations", [] {
    static const std::vector<WrittenForm> kForms = all_forms(kElements);
    const bool is_sample = *rc::gen::arbitrary<bool>();
    std::string text =
        is_sample ? *rc::gen::elementOf(kSamples) : (*rc::gen::elementOf(kForms)).text;
    const int edits = *rc::gen::inRange(1, 5);
    for (int i = 0; i < edits && !text.empty(); ++i) {
      const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
      switch (*rc::gen::inRange(0, 5)) {
        case 0:
          text[at] = *rc::gen::arbitrary<char>();
          break;
        case 1:
          text.erase(at, 1);
          break;
        case 2:
          text.insert(at, *rc::gen::elementOf(kTokens));
          break;
        case 3:
          text.insert(at, text.substr(at / 2, *rc::gen::inRange<std::size_t>(0, 30)));
          break;
        default:
          text.resize(at);
      }
    }
    read_as_every_format(text);
  }));
}

TEST_CASE("every sample is read by its own format") {
  const auto source = [](std::size_t i) { return Source{"f", kSamples[i]}; };
  CHECK(read_node(source(0), kDouble));
  CHECK(read_ele(source(1)));
  CHECK(read_neigh(source(2)));
  CHECK(read_off(source(3), kDouble));
  CHECK(read_off(source(4), kDouble));
  CHECK(read_qhull_points(source(5), kDouble));
  CHECK(read_qhull_simplices(source(6)));
  CHECK(read_json(source(7), kDouble));
  CHECK(read_poly(source(8), kDouble, three_points));
  CHECK(read_poly(source(9), kDouble, three_points));
  CHECK(read_smesh(source(10), kDouble, three_points));
  CHECK(read_face(source(11), 3));
  CHECK(read_stl(source(12), kDouble));
  CHECK(read_stl(source(13), kDouble));
  CHECK(read_ply(source(14), kDouble));
  CHECK(read_ply(source(15), kDouble));
  CHECK(read_medit(source(16), kDouble));
  CHECK(read_obj(source(17), kDouble));
  CHECK(read_csv(source(18), kDouble));
}

TEST_CASE("points that are written are read back") {
  CHECK(properties::holds("node", [] {
    PointFile file = some_points();
    if (!file.points.empty()) file.first_index = *rc::gen::arbitrary<int>();
    for (std::size_t i = 0; i < file.points.size(); ++i) {
      file.attributes.push_back(*rc::gen::container<std::vector<Rational>>(2, number()));
      file.markers.push_back(std::to_string(*rc::gen::arbitrary<int>()));
    }
    RC_ASSERT(read_node(written(file, write_node), kDouble) == file);
  }));
  CHECK(properties::holds("qhull", [] {
    const PointFile file = some_points();
    RC_ASSERT(read_qhull_points(written(file, write_qhull_points), kDouble) == file);
  }));
  CHECK(properties::holds("off", [] {
    const OffFile file{some_points(), some_simplices()};
    const auto again = read_off(written(file, write_off), kDouble);
    RC_ASSERT(again.has_value());
    RC_ASSERT(again->points == file.points);
    RC_ASSERT(again->faces.simplices == file.faces.simplices);
  }));
  CHECK(properties::holds("json", [] {
    JsonFile file{some_points()};
    file.points.first_index = *rc::gen::arbitrary<Vertex>();
    if (*rc::gen::arbitrary<bool>()) {
      file.weights =
          *rc::gen::container<std::vector<Rational>>(file.points.points.size(), number());
    }
    file.has_simplices = *rc::gen::arbitrary<bool>();
    if (file.has_simplices) file.simplices = some_simplices();
    file.faces = some_simplices();
    if (file.faces.vertices_per_simplex > file.points.dimension) file.faces = {};
    const auto again = read_json(written(file, write_json), kDouble);
    RC_ASSERT(again.has_value());
    RC_ASSERT(again->points == file.points);
    RC_ASSERT(again->weights == file.weights);
    RC_ASSERT(again->has_simplices == file.has_simplices);
    RC_ASSERT(again->simplices.simplices == file.simplices.simplices);
    RC_ASSERT(again->faces.simplices == file.faces.simplices);
  }));
}

TEST_CASE("simplices that are written are read back") {
  CHECK(properties::holds("ele", [] {
    SimplexFile file = some_simplices();
    file.first_index = *rc::gen::arbitrary<int>();
    const auto again = read_ele(written(file, write_ele));
    RC_ASSERT(again.has_value());
    RC_ASSERT(again->simplices == file.simplices);
    RC_ASSERT(again->first_index == file.first_index);
    RC_ASSERT(again->vertices_per_simplex == file.vertices_per_simplex);
  }));
  CHECK(properties::holds("face", [] {
    SimplexFile file;
    for (Simplex simplex : some_simplices().simplices) {
      simplex.resize(3);
      file.simplices.push_back(simplex);
    }
    const auto again = read_face(written(file, write_face), 3);
    RC_ASSERT(again.has_value());
    RC_ASSERT(again->simplices == file.simplices);
  }));
  CHECK(properties::holds("qhull", [] {
    const SimplexFile file = some_simplices();
    const auto again = read_qhull_simplices(written(file, write_qhull_simplices));
    RC_ASSERT(again.has_value());
    RC_ASSERT(again->simplices == file.simplices);
  }));
  CHECK(properties::holds("neigh", [] {
    const SimplexFile file = some_simplices();
    const NeighborFile neighbors{file.simplices.lists(), file.vertices_per_simplex, 1};
    RC_ASSERT(read_neigh(written(neighbors, write_neigh)) == neighbors);
  }));
}

}  // namespace circumspect::formats
