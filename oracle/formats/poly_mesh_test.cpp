// OpenFOAM's polyMesh: text and binary, packed or not, found by four names; what is refused.
#include "oracle/formats/poly_mesh.hpp"

#include <filesystem>

#include <doctest/doctest.h>

#include "inputs/dice.hpp"
#include "inputs/scratch_folder_test.hpp"
#include "oracle/formats/foam_file.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/reading_test.hpp"
#include "oracle/formats/written_elements_test.hpp"

namespace circumspect::formats {
namespace {

std::string foam_header(const std::string& of_class, const std::string& format = "ascii",
                        const std::string& arch = "LSB;label=32;scalar=64") {
  return "/*--- a banner ---*/\nFoamFile\n{\n    version 2.0;\n    format " + format +
         ";\n    arch \"" + arch + "\";\n    class " + of_class +
         ";\n    note \"nCells: 2 }\";\n}\n// * * //\n\n";
}

template <class Value>
std::string foam_bytes(std::initializer_list<Value> values) {
  std::string bytes;
  for (const Value value : values) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  return bytes;
}

struct FoamFiles {
  std::string points, faces, owner, neighbour;
};

// Two tetrahedra at the face 1 2 3.
const FoamFiles kFoamText = {
    foam_header("vectorField") +
        "5\n(\n(0 0 0)\n(1 0 0)\n(0 1 0)\n(0 0 1)\n(1 1 0.1)\n)\n\n// *** //\n",
    foam_header("faceList") +
        "7\n(\n3(1 2 3)\n3(0 2 1)\n3(0 1 3)\n3(0 3 2)\n3(1 4 3)\n3(2 3 4)\n3(1 2 4)\n)\n",
    foam_header("labelList") + "7(0 0 0 0 1 1 1)\n", foam_header("labelList") + "1\n(\n1\n)\n"};

const std::vector<Simplex> kFoamCells = {{1, 3, 2, 0}, {1, 2, 3, 4}};

class FoamCase {
 public:
  explicit FoamCase(const FoamFiles& files, const std::string& below = "/constant/polyMesh")
      : path(folder_.path("case")) {
    std::filesystem::create_directories(path + below);
    mesh = "case" + below + "/";
    folder_.write(mesh + "points", files.points);
    folder_.write(mesh + "faces", files.faces);
    folder_.write(mesh + "owner", files.owner);
    folder_.write(mesh + "neighbour", files.neighbour);
  }
  std::string error() const {
    const std::string said = error_of(read_poly_mesh({path, ""}, kDouble));
    const std::string begin = path + "/constant/polyMesh/";
    return said.starts_with(begin) ? said.substr(begin.size()) : said;
  }
  const ScratchFolder& folder() const { return folder_; }

 private:
  ScratchFolder folder_;

 public:
  std::string path;
  std::string mesh;  // the folder polyMesh within the scratch folder
};

std::string foam_error_with(std::string FoamFiles::*file, const std::string& text) {
  FoamFiles files = kFoamText;
  files.*file = text;
  return FoamCase(files).error();
}

// How a list is stored.
struct FoamForm {
  std::optional<ByteOrder> binary = {};
  std::size_t label = 4, scalar = 8;
  bool is_compact = false;  // its faces
  bool is_padded = false;   // its neighbours, up to the number of faces

  std::string header(const std::string& of_class) const {
    const auto bits = [](std::size_t bytes) { return std::to_string(8 * bytes); };
    return foam_header(of_class, binary ? "binary" : "ascii",
                       std::string(binary == ByteOrder::kBigEndian ? "MSB" : "LSB") +
                           ";label=" + bits(label) + ";scalar=" + bits(scalar));
  }
  std::string list(const std::vector<Vertex>& labels) const {
    std::string text = std::to_string(labels.size()) + "(";
    for (const Vertex v : labels) {
      text +=
          binary ? stored(static_cast<std::uint64_t>(v), label, *binary) : std::to_string(v) + " ";
    }
    return text + ")\n";
  }
  std::string coordinate(long x) const {
    if (!binary) return std::to_string(x) + " ";
    return scalar == 8 ? stored(std::bit_cast<std::uint64_t>(static_cast<double>(x)), 8, *binary)
                       : stored(std::bit_cast<std::uint32_t>(static_cast<float>(x)), 4, *binary);
  }
  std::string faces(const std::vector<Simplex>& faces) const {
    if (is_compact) {
      std::vector<Vertex> begins = {0}, all;
      for (const Simplex& face : faces) {
        all.insert(all.end(), face.begin(), face.end());
        begins.push_back(static_cast<Vertex>(all.size()));
      }
      return header("faceCompactList") + list(begins) + list(all);
    }
    std::string text = header("faceList") + std::to_string(faces.size()) + "\n(\n";
    for (const Simplex& face : faces) text += list(face);
    return text + ")\n";
  }
};

Simplex on_moment_curve(Vertex t) { return {t, t * t, t * t * t}; }

// Tetrahedra of four points that follow one another on the moment curve, in any order, by their
// faces, those between two cells first.
struct FoamChain {
  FoamChain(generators::Dice& dice, Vertex count) {
    for (Vertex c = 0; c < count; ++c) cells.push_back({c, c + 1, c + 2, c + 3});
    for (std::size_t i = cells.size(); i > 1; --i) std::swap(cells[i - 1], cells[dice.below(i)]);
    std::vector<std::size_t> opposite = {0, 1, 2, 3};
    for (std::size_t c = 0; c < cells.size(); ++c) {
      std::rotate(opposite.begin(), opposite.begin() + dice.within(0, 3), opposite.end());
      for (const std::size_t place : opposite) add_face(c, place);
    }
    faces = inside;
    faces.insert(faces.end(), boundary.begin(), boundary.end());
    owners.insert(owners.end(), boundary_owners.begin(), boundary_owners.end());
  }
  FoamFiles files(const FoamForm& form) const {
    std::string points = form.header("vectorField") + std::to_string(cells.size() + 3) + "\n(";
    for (Vertex v = 0; v < std::ssize(cells) + 3; ++v) {
      points += form.binary ? "" : "(";
      for (const Vertex x : on_moment_curve(v)) points += form.coordinate(x);
      points += form.binary ? "" : ")";
    }
    std::vector<Vertex> across = neighbours;
    if (form.is_padded) across.resize(faces.size(), -1);
    return {points + ")\n", form.faces(faces), form.header("labelList") + form.list(owners),
            form.header("labelList") + form.list(across)};
  }

  std::vector<Simplex> cells, faces, inside, boundary;
  std::vector<Vertex> owners, boundary_owners, neighbours;

 private:
  // Seen from its owner, which comes first, it goes around clockwise.
  void add_face(std::size_t cell, std::size_t place) {
    Simplex face = facet_opposite(cells[cell], place);
    if (place % 2 == 1) std::swap(face[0], face[1]);
    for (std::size_t other = 0; other < cells.size(); ++other) {
      if (other == cell || !has_face(cells[other], sorted(face))) continue;
      if (other < cell) return;
      inside.push_back(face);
      owners.push_back(static_cast<Vertex>(cell));
      neighbours.push_back(static_cast<Vertex>(other));
      return;
    }
    boundary.push_back(face);
    boundary_owners.push_back(static_cast<Vertex>(cell));
  }
};

std::vector<Simplex> each_sorted(std::vector<Simplex> simplices) {
  for (Simplex& simplex : simplices) std::sort(simplex.begin(), simplex.end());
  std::sort(simplices.begin(), simplices.end());
  return simplices;
}

}  // namespace

TEST_CASE("openfoam: a mesh has the same cells in every form, and all are positively oriented") {
  std::vector<FoamForm> forms = {{}, {.is_compact = true}, {.is_padded = true}};
  for (const ByteOrder order : {ByteOrder::kLittleEndian, ByteOrder::kBigEndian}) {
    for (const std::size_t label : {4U, 8U}) {
      for (const std::size_t scalar : {4U, 8U}) {
        forms.push_back({order, label, scalar, true, label == scalar});
      }
    }
  }
  generators::Dice dice(1);
  for (const FoamForm& form : forms) {
    for (const Vertex count : {1, 2, 3, 6}) {
      const FoamChain chain(dice, count);
      const FoamCase mesh(chain.files(form));
      const auto file = read_poly_mesh({mesh.path, ""}, kDouble);
      REQUIRE_MESSAGE(file, error_of(file));
      CHECK(each_sorted(file->tetrahedra.simplices.lists()) == each_sorted(chain.cells));
      CHECK(each_sorted(file->triangles.simplices.lists()) == each_sorted(chain.boundary));
      for (const Simplex& cell : file->tetrahedra.simplices.lists()) {
        CHECK(!is_odd_permutation(cell));  // ascending ones are positive on the curve
      }
      for (Vertex v = 0; v < count + 3; ++v) {
        const Simplex place = on_moment_curve(v);
        const Point expected = {to_integer(place[0]), to_integer(place[1]), to_integer(place[2])};
        CHECK(file->points.points[static_cast<std::size_t>(v)] == expected);
      }
    }
  }
}

TEST_CASE("openfoam: cells of faces, owners and neighbours, as text and binary") {
  const FoamFiles binary = {
      foam_header("vectorField", "binary") + "5\n(" +
          foam_bytes<double>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 0.1}) + ")\n",
      foam_header("faceCompactList", "binary") + "8\n(" +
          foam_bytes<int>({0, 3, 6, 9, 12, 15, 18, 21}) + ")\n21\n(" +
          foam_bytes<int>({1, 2, 3, 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 4, 3, 2, 3, 4, 1, 2, 4}) + ")\n",
      foam_header("labelList", "binary", "LSB;label=64;scalar=64") + "7\n(" +
          foam_bytes<std::int64_t>({0, 0, 0, 0, 1, 1, 1}) + ")\n",
      foam_header("labelList", "binary") + "7\n(" + foam_bytes<int>({1, -1, -1, -1, -1, -1, -1}) +
          ")\n"};
  for (const FoamFiles& files : {kFoamText, binary}) {
    const FoamCase mesh(files);
    const auto file = read_poly_mesh({mesh.path, ""}, kDouble);
    REQUIRE_MESSAGE(file, error_of(file));
    CHECK(file->points.points.size() == 5);
    CHECK(file->points.points[4] == Point{1, 1, exact_value(0.1)});
    CHECK(file->tetrahedra.simplices == kFoamCells);
    CHECK(file->triangles.simplices ==
          std::vector<Simplex>{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 4, 3}, {2, 3, 4}, {1, 2, 4}});
  }
}

TEST_CASE("openfoam: a file is told by its header, wherever that stands") {
  CHECK(is_foam_file("FoamFile\n{\n}\n"));
  CHECK(is_foam_file("/* a banner */\nFoamFile\n{\n}\n"));
  CHECK(!is_foam_file("oamFile\n{\n}\n"));
}

TEST_CASE("openfoam: the case, its folders and ParaView's file name one mesh") {
  const FoamCase mesh(kFoamText);
  const std::string foam = mesh.folder().write("case/case.foam", "");
  for (const std::string& path : {mesh.path, mesh.path + "/", mesh.path + "/constant",
                                  mesh.path + "/constant/polyMesh", foam}) {
    CAPTURE(path);
    CHECK(extension_inside(path) == ".foam");
    const auto read = read_mesh({.mesh = path});
    REQUIRE_MESSAGE(read, error_of(read));
    CHECK(read->mesh.simplices.lists() == kFoamCells);
    CHECK(read->mesh_name == path);
  }
  const std::string empty = mesh.folder().write("y.foam", "");
  CHECK(error_of(read_mesh({.mesh = empty})) ==
        empty + ": expected a case of OpenFOAM, with constant/polyMesh/points, found no such file");
  const std::string bare = mesh.path + "/constant/..";
  CHECK(read_mesh({.mesh = bare}));
  std::filesystem::remove(mesh.folder().path(mesh.mesh + "faces"));
  CHECK(error_of(read_mesh({.mesh = mesh.path})) ==
        mesh.path + ": expected a file, found a directory");
}

TEST_CASE("openfoam: cells that are not tetrahedra are named") {
  FoamFiles prism = kFoamText;
  prism.owner = foam_header("labelList") + "7(0 0 0 0 0 0 0)";
  prism.neighbour = foam_header("labelList") + "0()";
  const FoamCase mesh(prism);
  CHECK(error_of(read_mesh({.mesh = mesh.path})) ==
        mesh.path +
            ": expected edges, triangles and tetrahedra, found cell 0 of 7 faces and 5 vertices");
  // Four triangles, two of them of the same vertices.
  FoamFiles twice = kFoamText;
  twice.faces.replace(twice.faces.find("3(0 3 2)"), 8, "3(0 1 2)");
  const FoamCase folded(twice);
  CHECK(error_of(read_mesh({.mesh = folded.path})) ==
        folded.path +
            ": expected edges, triangles and tetrahedra, found cell 0 of 4 faces and 4 vertices");
}

TEST_CASE("openfoam: faults, with file and line") {
  CHECK(foam_error_with(&FoamFiles::points, "") ==
        "points:1: expected FoamFile, found the end of the file");
  CHECK(foam_error_with(&FoamFiles::points, "FoamFile {") ==
        "points:1: expected \"}\" behind the header, found the end of the file");
  CHECK(foam_error_with(&FoamFiles::points, "FoamFile { format ascii") ==
        "points:1: expected \";\" behind a value of the header, found the end of the file");
  CHECK(foam_error_with(&FoamFiles::points, foam_header("vectorField", "xml")) ==
        "points:5: expected the format ascii or binary, found \"xml\"");
  CHECK(foam_error_with(&FoamFiles::points, foam_header("vectorField") + "2\n(\n(0 0 0)\n") ==
        "points:15: expected \"(\" before point 2 of 2, found the end of the file");
  CHECK(foam_error_with(&FoamFiles::points, foam_header("vectorField") + "1\n(\n(0 x 0)\n)") ==
        "points:14: expected a finite number of point 1 of 1, found \"x\"");
  CHECK(foam_error_with(&FoamFiles::points, foam_header("vectorField") + "-1\n") ==
        "points:12: expected the number of points, 0 or more, found \"-1\"");
  CHECK(foam_error_with(&FoamFiles::points,
                        foam_header("vectorField", "binary") + "999999999999\n(abc)") ==
        "points:13: expected 999999999999 points of 24 bytes, found 4 bytes");
  CHECK(foam_error_with(&FoamFiles::faces, foam_header("faceList") + "1\n(\n3(0 1)\n)") ==
        "faces:14: expected a vertex of face 1 of 1, an integer, found \")\"");
  CHECK(foam_error_with(&FoamFiles::faces, foam_header("faceCompactList") + "2(0 4)\n3(0 1 2)\n") ==
        "faces:13: expected places of faces that go up to 3, found 0, then 4");
  CHECK(
      foam_error_with(&FoamFiles::faces, foam_header("faceCompactList") + "2(-1 2)\n3(0 1 2)\n") ==
      "faces:13: expected places of faces that go up to 3, found -1, then 2");
  CHECK(foam_error_with(&FoamFiles::faces, foam_header("faceCompactList") + "2(3 0)\n3(0 1 2)\n") ==
        "faces:13: expected places of faces that go up to 3, found 3, then 0");
  CHECK(foam_error_with(&FoamFiles::faces, foam_header("faceList", "binary") + "1\n(") ==
        "faces:9: expected faces of the class faceCompactList in a binary file, found others");
  CHECK(foam_error_with(&FoamFiles::owner, foam_header("labelList") + "6(0 0 0 0 1 1)") ==
        "owner: expected 7 cells, one for each face, found 6");
  CHECK(foam_error_with(&FoamFiles::owner, foam_header("labelList") + "8(0 0 0 0 1 1 1 1)") ==
        "owner: expected 7 cells, one for each face, found 8");
  CHECK(foam_error_with(&FoamFiles::owner, foam_header("labelList") + "7(0 0 0 0 1 1 -1)") ==
        "owner: expected a cell from 0 to 3 at face 6, found -1");
  CHECK(foam_error_with(&FoamFiles::owner, foam_header("labelList") + "7(0 0 0 0 1 1 4)") ==
        "owner: expected a cell from 0 to 3 at face 6, found 4");
  CHECK(foam_error_with(&FoamFiles::neighbour, foam_header("labelList") + "1(2)") ==
        "owner: expected 4 faces or more of cell 1, found 3");
  CHECK(foam_error_with(&FoamFiles::neighbour, foam_header("labelList") + "8(1 1 1 1 1 1 1 1)") ==
        "neighbour: expected at most 7 cells, as there are faces, found 8");
}

}  // namespace circumspect::formats
