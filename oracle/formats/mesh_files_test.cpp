// Finding the files of a mesh, and opening them.
#include "oracle/formats/mesh_files.hpp"

#include <filesystem>
#include <fstream>
#include <limits>

#include <doctest/doctest.h>

#include "inputs/scratch_folder_test.hpp"
#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/domain_file.hpp"
#include "oracle/formats/format.hpp"
#include "oracle/formats/read_domain.hpp"
#include "oracle/formats/reading_test.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace circumspect::formats {

// A mesh is found by each name that users give.

namespace {

const std::string kSquareFrom1 = "4 2\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n";
const std::string kTwoFrom1 = "2 3\n1 1 2 3\n2 1 3 4\n";
const std::string kSquareQhull = "2\n4\n0 0\n1 0\n1 1\n0 1\n";
const std::string kTwoQhull = "2\n0 1 2\n0 2 3\n";
const std::string kJson =
    "{\"circumspect\": 1, \"dimension\": 2, \"points\": [[0,0],[1,0],[1,1],[0,1]],\n"
    "\"weights\": [0,0,0,1], \"simplices\": [[0,1,2],[0,2,3]]}";
const std::string kOff = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
const std::vector<Simplex> kTwo = {{0, 1, 2}, {0, 2, 3}};

Result<MeshFile> mesh_of(const std::string& path) { return read_mesh({.mesh = path}); }
Result<MeshFile> mesh_of(const std::string& path, const std::string& points) {
  return read_mesh({.mesh = path, .points = points});
}
Result<MeshFile> weighted(const std::string& path, const std::optional<std::string>& points,
                          Weights weights) {
  return read_mesh({.mesh = path, .points = points, .weights = weights});
}

}  // namespace

TEST_CASE("extensions") {
  CHECK(extension("a/x.1.ELE") == ".ele");
  CHECK(extension("a.b/x") == "");
  CHECK(extension(".node") == "");
  CHECK(extension("a/.node") == "");
  CHECK(extension("a/.x.node") == ".node");
  CHECK(extension("-") == "");
  CHECK(extension("x.qhull-i") == ".qhull-i");
  CHECK(extension("") == "");
}

TEST_CASE("x.1.ele has its points in x.1.node; x.1.node its simplices in x.1.ele") {
  const ScratchFolder folder;
  const std::string node = folder.write("x.1.node", kSquareFrom1);
  const std::string ele = folder.write("x.1.ele", kTwoFrom1);
  for (const std::string& asked : {ele, node}) {
    const auto mesh = mesh_of(asked);
    REQUIRE(mesh);
    CHECK(mesh->mesh.points() == 4);
    CHECK(mesh->mesh.simplices.lists() == kTwo);
    CHECK(mesh->mesh.first_index == 1);
    CHECK(mesh->mesh_name == ele);
    CHECK(mesh->points_name == node);
    CHECK(!mesh->mesh.neighbors);
  }
}

TEST_CASE("neighbours are read where they are wanted and there") {
  const ScratchFolder folder;
  folder.write("x.node", kSquareFrom1);
  const std::string ele = folder.write("x.ele", kTwoFrom1);
  MeshRequest request{ele};
  request.with_neighbors = true;
  CHECK(!read_mesh(request)->mesh.neighbors);
  folder.write("x.neigh", "2 3\n1 -1 2 -1\n2 -1 -1 1\n");
  REQUIRE(read_mesh(request)->mesh.neighbors);
  CHECK(read_mesh(request)->mesh.neighbors->rows[0] == Simplex{-1, 1, -1});
  CHECK(read_mesh(request)->mesh.neighbors->as_listed().rows[0] == Simplex{-1, 2, -1});
  folder.write("x.neigh", "2 x\n");
  CHECK(!read_mesh(request));
  CHECK(mesh_of(ele));
}

TEST_CASE("points of another file and another base") {
  const ScratchFolder folder;
  const std::string ele = folder.write("x.ele", "2 3\n0 0 1 2\n1 0 2 3\n");
  const std::string qhull = folder.write("y.qhull", kSquareQhull);
  const std::string text = folder.write("y.txt", kSquareQhull);
  const std::string json = folder.write("y.json", kJson);
  for (const std::string& points : {qhull, text, json}) {
    const auto mesh = mesh_of(ele, points);
    REQUIRE(mesh);
    CHECK(mesh->mesh.simplices.lists() == kTwo);
    CHECK(mesh->points_name == points);
    CHECK(!mesh->mesh.is_weighted());
    const auto listed = weighted(ele, points, Weights::kListed);
    CHECK(rows_of(listed->mesh.weights) == (points == json ? 4 : 0));
  }
  CHECK(!weighted(json, qhull, Weights::kListed)->mesh.is_weighted());
  // Points that the caller has are taken, whatever the mesh's own file has.
  const PointFile others{2, {{0, 0}, {5, 0}, {5, 5}, {0, 5}}};
  const auto own = read_mesh({.mesh = json, .own_points = others});
  REQUIRE_MESSAGE(own, error_of(own));
  CHECK(own->mesh.exact_points() == others.points.points());
}

TEST_CASE("weights are listed as such, or where they are demanded the first attributes") {
  const ScratchFolder folder;
  const std::string ele = folder.write("x.ele", "1 3\n0 0 1 2\n");
  const std::string node = folder.write("x.node", "3 2 2\n0 0 0 7 1\n1 1 0 8 1\n2 0 1 0.5 1\n");
  const std::string bare = folder.write("y.node", "3 2\n0 0 0\n1 1 0\n2 0 1\n");
  CHECK(!weighted(ele, node, Weights::kNone)->mesh.is_weighted());
  CHECK(!weighted(ele, node, Weights::kListed)->mesh.is_weighted());
  const auto demanded = weighted(ele, node, Weights::kDemanded);
  REQUIRE(demanded);
  CHECK(rows_of(demanded->mesh.weights) == 3);
  CHECK(demanded->mesh.weight(2) == Rational(1) / 2);
  CHECK(error_of(weighted(ele, bare, Weights::kDemanded)) ==
        bare +
            ": expected a weight for each point (the first attribute of a .node file, the key "
            "\"weights\" of JSON), found none");
  const auto json = folder.write("y.json", kJson);
  CHECK(weighted(json, {}, Weights::kDemanded)->mesh.weight(3) == 1);
  CHECK(weighted(ele, folder.write("none.node", "0 2\n"), Weights::kDemanded));
}

TEST_CASE("an index that names no point still names none") {
  const ScratchFolder folder;
  folder.write("x.node", "1 1\n5 0\n");
  const auto mesh =
      mesh_of(folder.write("x.ele", "3 1\n0 -9223372036854775808\n1 9223372036854775807\n2 4\n"));
  REQUIRE(mesh);
  // The smallest index wraps around, and comes back.
  CHECK(mesh->mesh.simplices.lists() ==
        std::vector<Simplex>{{std::numeric_limits<Vertex>::max() - 4},
                             {std::numeric_limits<Vertex>::max() - 5},
                             {-1}});
  CHECK(index_of_place(mesh->mesh.simplices[0][0], mesh->mesh.first_index) ==
        std::numeric_limits<Vertex>::min());
}

TEST_CASE("json, off and qhull") {
  const ScratchFolder folder;
  const std::string qhull = folder.write("x.qhull", kSquareQhull);
  const std::string facets = folder.write("x.qhull-i", kTwoQhull);
  const std::string json = folder.write("x.json", kJson);
  const std::string off = folder.write("x.off", kOff);
  for (const std::string& asked :
       {qhull, facets, json, off, folder.write("a", kJson), folder.write("b", "\n" + kOff)}) {
    const auto mesh = mesh_of(asked);
    REQUIRE_MESSAGE(mesh.has_value(), error_of(mesh));
    CHECK(mesh->mesh.simplices.lists() == kTwo);
    CHECK(mesh->mesh.points() == 4);
    CHECK(mesh->mesh.first_index == 0);
  }
  CHECK(weighted(json, {}, Weights::kListed)->mesh.weight(3) == 1);
  CHECK(mesh_of(facets)->points_name == qhull);
}

TEST_CASE("medit: the cells of highest dimension, and the others beside them where wanted") {
  const ScratchFolder folder;
  const std::string vertices =
      "MeshVersionFormatted 2 Dimension 3 Vertices 4 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 0 ";
  MeshRequest request{folder.write("x.mesh", vertices + "Edges 1 1 2 0 Triangles 2 1 2 3 0 1 2 4 7 "
                                                        "Tetrahedra 1 1 2 3 4 0 End")};
  const auto mesh = read_mesh(request);
  REQUIRE_MESSAGE(mesh.has_value(), error_of(mesh));
  CHECK(mesh->mesh.simplices.lists() == std::vector<Simplex>{{0, 1, 2, 3}});
  CHECK(mesh->mesh.first_index == 1);
  CHECK(mesh->mesh.faces.empty());
  request.with_faces = true;
  CHECK(read_mesh(request)->mesh.faces == std::vector<Simplex>{{0, 1}, {0, 1, 2}, {0, 1, 3}});
  const auto surface = mesh_of(folder.write("y", vertices + "Triangles 1 1 2 3 0 End"));
  REQUIRE_MESSAGE(surface.has_value(), error_of(surface));
  CHECK(surface->mesh.simplices.lists() == std::vector<Simplex>{{0, 1, 2}});
  const std::string quads = folder.write("z.mesh", vertices + "\nQuadrilaterals 1 1 2 3 4 0 End");
  CHECK(error_of(mesh_of(quads)) ==
        quads + ":2: expected edges, triangles and tetrahedra, found a quadrilateral");
}

TEST_CASE("triangles and edges beside an .ele are read where they are wanted and there") {
  const ScratchFolder folder;
  folder.write("x.node", "4 3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n");
  MeshRequest request{folder.write("x.ele", "1 4\n1 1 2 3 4\n")};
  request.with_faces = true;
  CHECK(read_mesh(request)->mesh.faces.empty());
  folder.write("x.face", "2 1\n1 2 1 3 8 5 -1\n2 1 2 9 0 -1 5\n");
  folder.write("x.edge", "1\n1 4 1\n");
  CHECK(read_mesh(request)->mesh.faces == std::vector<Simplex>{{1, 0, 2}, {0, 1, 8}, {3, 0}});
  for (const auto& read : {read_mesh(request), read_mesh_line_by_line(request)}) {
    CHECK(read->face_markers == std::map<Simplex, Vertex>{{{0, 1, 2}, 8}});
  }
  folder.write("x.edge", "1\n1 4\n");
  CHECK(!read_mesh(request));
  request.with_faces = false;
  CHECK(read_mesh(request)->mesh.faces.empty());
}

TEST_CASE("files without a telling name are known by what they hold") {
  const ScratchFolder folder;
  const NumberReading reading = NumberReading::kDouble;
  CHECK(read_points(folder.write("a", kJson), reading)->weights.size() == 4);
  CHECK(read_points(folder.write("b.dat", kOff), reading)->points.dimension == 3);
  CHECK(read_points(folder.write("c.txt", kSquareQhull), reading)->points.points.size() == 4);
  CHECK(read_points(folder.write("d", kSquareFrom1), reading)->points.first_index == 1);
  // A point on each line, and no header that announces as many columns.
  CHECK(read_points(folder.write("l.txt", "0 0\n3 0\n0 3\n2 2\n"), reading)->points.points.size() ==
        4);
  CHECK(read_points(folder.write("l.dat", "1 2 3 4\n5 6 7 8\n"), reading)->points.dimension == 4);
  // A header has four numbers at most, of which the last three announce columns.
  CHECK(read_points(folder.write("l.dat", "7 1 1 1 1\n0 0 0 0 0\n"), reading)->points.dimension ==
        5);
  CHECK(
      read_points(folder.write("l", "2 3 0 0\n7 1 2 3\n8 1 2 4\n"), reading)->points.first_index ==
      7);
  CHECK(read_points(folder.write("l", "1 0.5\n2 1.5\n"), reading)->points.points.size() == 2);
  const std::string points = folder.write("p.node", kSquareFrom1);
  CHECK(mesh_of(folder.write("e", kTwoFrom1), points)->mesh.simplices.lists() == kTwo);
  CHECK(mesh_of(folder.write("f", kTwoQhull), points));
}

TEST_CASE("formats of elements: faces, points of the plane, points alone, names that say nothing") {
  const ScratchFolder folder;
  const std::string obj = "v 0 0 5\nv 1 0 5\nv 1 1 5\nv 0 1 5\nf 1 2 3\nf 1 3 4\nl 2 4\n";
  const std::string gmsh =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 "
      "0\n$EndNodes\n"
      "$Elements\n3\n1 1 0 2 4\n2 2 0 1 2 3\n3 2 0 1 3 4\n$EndElements\n";
  for (const std::string& path : {folder.write("x.obj", obj), folder.write("x.msh", gmsh),
                                  folder.write("y", gmsh), folder.write("z", obj)}) {
    MeshRequest request{path};
    request.with_faces = true;
    const auto mesh = read_mesh(request);
    REQUIRE_MESSAGE(mesh.has_value(), error_of(mesh));
    CHECK(mesh->mesh.dimension() == 2);
    CHECK(mesh->notes.size() == 1);
    CHECK(mesh->mesh.simplices.lists() == kTwo);
    CHECK(mesh->mesh.faces == std::vector<Simplex>{{1, 3}});
    CHECK(mesh->mesh.first_index == 1);
    // A domain in space says that the points are in space.
    request.domain_dimension = 3;
    CHECK(read_mesh(request)->mesh.dimension() == 3);
    CHECK(read_points(path, NumberReading::kDouble)->points.dimension == 3);
    const auto domain = read_domain(path, NumberReading::kDouble);
    REQUIRE(domain);
    CHECK(domain->dimension == 2);
    // Points that belong only to triangles belong to the mesh, not to the domain.
    CHECK(domain->input.segments == std::vector<Simplex>{{0, 1}});
    CHECK(domain->labels == std::vector<Vertex>{2, 4});
  }
  const std::string tet = "4 vertices\n1 tets\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n4 0 1 2 3\n";
  CHECK(mesh_of(folder.write("w", tet))->mesh.simplices.lists() ==
        std::vector<Simplex>{{0, 1, 2, 3}});
  const std::string ply =
      folder.write("x.ply",
                   "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\n"
                   "property int z\nend_header\n1 2 3\n");
  CHECK(read_points(ply, NumberReading::kDouble)->points.points.size() == 1);
  CHECK(!is_domain_file(ply));
  CHECK(is_domain_file(folder.path("x.obj")));
  CHECK(is_domain_file(folder.path("x.vtp")));
}

TEST_CASE("what cannot be found or judged") {
  const ScratchFolder folder;
  const std::string ele = folder.write("x.ele", kTwoFrom1);
  CHECK(error_of(mesh_of(ele)) == folder.path("x.node") + ": expected a file with the points of " +
                                      ele +
                                      ", found no file of that name (--points names another)");
  const std::string lone = folder.write("y.node", kSquareFrom1);
  CHECK(error_of(mesh_of(lone)) == folder.path("y.ele") +
                                       ": expected a file with the simplices of " + lone +
                                       ", found no file of that name");
  CHECK(error_of(mesh_of(folder.path("none.ele"))) ==
        folder.path("none.ele") + ": expected a file, found no file of that name");
  CHECK(error_of(mesh_of(lone, ele)) != "no error");
  const std::string known = "a mesh (" + endings_of(&Format::has_mesh) +
                            "; .ele goes with .node, .qhull-i with .qhull, .npy with --points)";
  const std::string unknown = folder.write("x.plt", "TITLE a mesh\n");
  CHECK(error_of(mesh_of(unknown)) == unknown + ":1: expected " + known + ", found \"TITLE\"");
  // Lists of points begin with a number, which may have a sign.
  const std::string negative = folder.write("y.plt", "-1 2\n");
  CHECK(error_of(read_points(negative, NumberReading::kDouble)) ==
        negative + ":1: expected the number of points, 0 or more, found \"-1\"");
  // For a format of another program, the message names the command that converts it.
  const std::string step = folder.write("x.STEP", "ISO-10303-21;\n");
  CHECK(error_of(mesh_of(step)) ==
        step + ": expected " + known + ", found a STEP geometry (gmsh -3 IN.step -o IN.msh)");
  CHECK(error_of(mesh_of("-", "-")) ==
        "<stdin>: expected the mesh or its points on standard input, found both");
  const auto points = read_points(ele, NumberReading::kDouble);
  REQUIRE(!points);
  CHECK(points.error().to_string() == ele + ": expected a file of points (" +
                                          endings_of(&Format::has_points) + "), found a .ele file");
  CHECK(endings_of(&Format::has_points).starts_with(".node, .json, .off, .stl, .mesh, "));
  CHECK(endings_of(&Format::has_domain).starts_with(".poly, .smesh, .off, .stl, "));
  CHECK(endings_in_help(&Format::has_mesh).starts_with(".ele (points in the .node beside it), "));
  const auto salome = read_points(folder.write("x.med", "\x89HDF\n"), NumberReading::kDouble);
  REQUIRE(!salome);
  CHECK(salome.error().found ==
        "a mesh of Salome (with Debian's python3-meshio and python3-h5py: python3 -c 'import "
        "meshio; meshio.read(\"IN.med\").write(\"OUT.vtu\")')");
  const std::string bare =
      folder.write("bare.json", "{\"circumspect\": 1, \"dimension\": 2, \"points\": []}");
  CHECK(error_of(mesh_of(bare)) ==
        bare + ": expected a mesh, with the key \"simplices\", found points alone");
}

TEST_CASE("simplices that are none are named by their line") {
  const ScratchFolder folder;
  const std::string node = folder.write("x.node", kSquareFrom1);
  const std::string ele = folder.write("x.ele", "1 5\n1 1 2 3 4 1\n");
  CHECK(error_of(mesh_of(ele)) ==
        ele +
            ":2: expected at most 3 vertices of a simplex in dimension 2, found 5 (elements of "
            "second order and facets that are not simplices are not judged)");
  const std::string facets = folder.write("y.qhull-i", "2\n0 1 2\n0 1 2 3\n");
  CHECK(error_of(mesh_of(facets, node)) ==
        facets +
            ":3: expected at most 3 vertices of a simplex in dimension 2, found 4 (elements "
            "of second order and facets that are not simplices are not judged)");
  CHECK(mesh_of(folder.write("z.qhull-i", "2\n0 1 2\n0 1\n"), node));
  const std::string off =
      folder.write("x.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
  CHECK(error_of(mesh_of(off)) == off + ":7: expected a triangle, found a face with 4 vertices");
}

// Loading files, messages on one line, and the lines of a text.

namespace {

std::string complaint(const std::string& path) {
  const Result<Source> source = load(path);
  return source ? "no error" : source.error().to_string();
}

}  // namespace

TEST_CASE("a file is read with every byte of it") {
  const ScratchFolder folder;
  const std::string bytes("a\0\xff\r\n", 5);
  const std::string path = folder.write("x.node", bytes);
  const Result<Source> source = load(path);
  REQUIRE(source);
  CHECK(source->name == path);
  CHECK(source->text == bytes);
  const std::string large(300000, 'x');
  CHECK(load(folder.write("large", large))->text == large);
  CHECK(load(folder.write("empty", ""))->text.empty());
}

TEST_CASE("what cannot be read says why") {
  const ScratchFolder folder;
  CHECK(complaint(folder.path("none")) ==
        folder.path("none") + ": expected a file, found no file of that name");
  CHECK(complaint(folder.path("none/x.node")) ==
        folder.path("none/x.node") + ": expected a file, found no file of that name");
  CHECK(complaint(folder.path("")) == folder.path("") + ": expected a file, found a directory");
  CHECK(complaint("/dev/zero") == "/dev/zero: expected a file, found a device");
  const std::string secret = folder.write("secret", "1 2\n");
  std::filesystem::permissions(secret, std::filesystem::perms::none);
  // The superuser may read everything.
  if (!std::ifstream(secret)) {
    CHECK(complaint(secret) ==
          secret + ": expected a file to read, found no permission to read it");
  }
}

TEST_CASE("a message is one line, whatever the bytes are") {
  CHECK(FormatError{"a\nb", 3, "x\ty", "z"}.to_string() == "a\\x0ab:3: expected x\\x09y, found z");
  CHECK(FormatError{"f", 0, "x", "y"}.to_string() == "f: expected x, found y");
  CHECK(quote(std::string("\0\x1b[1m\xc3\xa9\n", 8)) == "\"\\x00\\x1b[1m\\xc3\\xa9\\x0a\"");
  CHECK(quote(std::string(41, 'a')) == "\"" + std::string(40, 'a') + "...\"");
}

TEST_CASE("integers") {
  Vertex value = 0;
  CHECK(parse_integer("+7", value) == std::errc());
  CHECK(value == 7);
  CHECK(parse_integer("-9223372036854775808", value) == std::errc());
  for (const char* token : {"", "+", "-", "+-1", "1x", "0x1", "1.0", "99999999999999999999x"}) {
    CHECK_MESSAGE(parse_integer(token, value) == std::errc::invalid_argument, token);
  }
  CHECK(parse_integer("9223372036854775808", value) == std::errc::result_out_of_range);
}

TEST_CASE("lines with tokens, counted from 1") {
  const Source source{"f", "\n a\tb#c d\n#x\n\r\n c"};
  Lines lines(source);
  REQUIRE(lines.next());
  CHECK(lines.line() == 2);
  CHECK(lines.tokens() == std::vector<std::string_view>{"a", "b"});
  REQUIRE(lines.next());
  CHECK(lines.line() == 5);
  CHECK(lines.tokens() == std::vector<std::string_view>{"c"});
  CHECK(!lines.next());
  CHECK(lines.size() == 0);
  CHECK(lines.line() == 5);
}

}  // namespace circumspect::formats
