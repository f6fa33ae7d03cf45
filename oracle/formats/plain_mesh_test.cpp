// Which meshes are read as plain ones, and that the result is the same as reading line by line.
#include <chrono>
#include <stdexcept>
#include <thread>

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "inputs/scratch_folder_test.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/reading_test.hpp"

namespace circumspect::formats {
namespace {

const std::string kNode = "4 2 1\n1 0 0 9\n2 1 0 9\n3 0 1 9\n4 1 1 -0.25\n";
const std::string kEle = "2 3 0\n1 1 2 3\n2 2 4 3\n";
const std::string kNeigh = "2 3\n1 2 -1 -1\n2 -1 1 -1\n";
const std::vector<double> kCorners = {0, 0, 1, 0, 0, 1, 1, 1};
const std::vector<Simplex> kTwoTriangles = {{0, 1, 2}, {1, 3, 2}};

void check_same(const MeshFile& plain, const MeshFile& listed) {
  CHECK(plain.points_name == listed.points_name);
  CHECK(plain.mesh_name == listed.mesh_name);
  CHECK(plain.notes == listed.notes);
  const Mesh& a = plain.mesh;
  const Mesh& b = listed.mesh;
  CHECK(a.dimension() == b.dimension());
  CHECK(a.exact_points() == b.exact_points());
  CHECK(a.is_weighted() == b.is_weighted());
  for (Vertex v = 0; a.names(v); ++v) CHECK(a.weight(v) == b.weight(v));
  CHECK(a.first_index == b.first_index);
  CHECK(a.labels.empty());
  CHECK(a.simplices.lists() == b.simplices.lists());
  CHECK(a.faces == b.faces);
  REQUIRE(a.neighbors.has_value() == b.neighbors.has_value());
  if (!a.neighbors) return;
  CHECK(a.neighbors->as_listed().rows == b.neighbors->as_listed().rows);
  CHECK(a.neighbors->first_index == b.neighbors->first_index);
}

// Both readers read the same mesh, with weights and without; true if the plain one has an answer.
bool is_read(MeshRequest request) {
  std::size_t answers = 0;
  for (const Weights weights : {Weights::kNone, Weights::kListed, Weights::kDemanded}) {
    request.weights = weights;
    const auto plain = read_plain_mesh(request);
    if (!plain) continue;
    answers += weights == Weights::kDemanded ? 0 : 1;
    const auto listed = read_mesh_line_by_line(request);
    REQUIRE(listed.has_value());
    check_same(*plain, *listed);
  }
  CHECK(answers != 1);
  return answers == 2;
}

}  // namespace

TEST_CASE("plain meshes: .ele beside .node, either named, and with other points") {
  const ScratchFolder folder;
  const std::string node = folder.write("x.node", kNode);
  const std::string ele = folder.write("x.ele", kEle);
  CHECK(is_read({ele}));
  CHECK(is_read({node}));
  const std::string from_0 = folder.write("y.node", "4 2\n0 0 0\n1 1 0\n2 0 1\n3 1 1\n");
  CHECK(is_read({ele, from_0}));
  CHECK(!is_read({folder.path("none.ele")}));
  CHECK(!is_read({ele, folder.path("none.node")}));
  CHECK(!is_read({folder.write("z.ele", kEle)}));
  CHECK(!is_read({ele, folder.write("points.off", kNode)}));
}

TEST_CASE("plain meshes: neighbours where they are asked for") {
  const ScratchFolder folder;
  folder.write("x.node", kNode);
  MeshRequest request{folder.write("x.ele", kEle)};
  request.with_neighbors = true;
  CHECK(!is_read(request));
  folder.write("x.neigh", kNeigh);
  CHECK(is_read(request));
  CHECK(read_plain_mesh(request)->mesh.neighbors->rows[1] == Simplex{-1, 0, -1});
  request.with_neighbors = false;
  CHECK(is_read(request));
  CHECK(!read_plain_mesh(request)->mesh.neighbors);
  request.with_neighbors = true;
  folder.write("x.neigh", "1 3\n1 2 -1 -1\n");
  CHECK(!is_read(request));
  folder.write("x.neigh", "2 2\n1 2 -1\n2 -1 1\n");
  CHECK(!is_read(request));
}

TEST_CASE("plain meshes: .npy for points, for simplices, and for both") {
  const ScratchFolder folder;
  const std::string points = folder.write("points.npy", npy("<f8", "(4, 2)", kCorners));
  const std::string narrow =
      folder.write("narrow.npy", npy<std::int32_t>("<i4", "(2, 3)", {0, 1, 2, 1, 3, 2}));
  const std::string wide =
      folder.write("wide.npy", npy<std::int64_t>("<i8", "(2, 3)", {0, 1, 2, 1, 3, 2}));
  CHECK(is_read({narrow, points}));
  CHECK(is_read({wide, points}));
  CHECK(read_mesh({wide, points})->mesh.simplices.lists() == kTwoTriangles);
  CHECK(read_mesh({wide, points})->mesh.simplices.rows<std::int64_t>());
  CHECK(read_mesh({wide, points})->points_name == points);
  CHECK(!is_read({wide}));
  CHECK(!is_read({wide, wide}));
  // Indices are counted from that of the first point, as in every other format.
  const std::string from_1 = folder.write("x.node", kNode);
  CHECK(is_read({narrow, from_1}));
  CHECK(is_read({wide, from_1}));
  CHECK(!is_read({folder.write("ele.npy", kEle), points}));
  CHECK(is_read({folder.write("y.ele", "1 3\n0 0 1 2\n"), points}));
  const std::string far = folder.write("far.node", "1 1\n9 0\n");
  CHECK(!is_read({folder.write("low.npy", npy<std::int32_t>("<i4", "(1, 1)", {INT32_MIN})), far}));
}

TEST_CASE("plain meshes: an archive of .npy files, by its name or by what it holds") {
  const ScratchFolder folder;
  const std::string simplices = npy<std::int32_t>("<i4", "(2, 3)", {0, 1, 2, 1, 3, 2});
  const std::string archive =
      npz({{"points.npy", npy("<f8", "(4, 2)", kCorners)}, {"simplices.npy", simplices}}, 8);
  for (const std::string name : {"x.npz", "x"}) {
    const auto file = read_mesh({folder.write(name, archive)});
    REQUIRE_MESSAGE(file.has_value(), error_of(file));
    CHECK(file->mesh.simplices.lists() == kTwoTriangles);
    CHECK(file->mesh.simplices.rows<std::int32_t>());  // exactly as in the file
    CHECK(file->points_name == folder.path(name) + "/points.npy");
    CHECK(read_points(folder.path(name), NumberReading::kDouble)->points.points.size() == 4);
  }
  // Points of another file take the place of these.
  const std::string from_1 = folder.write("x.node", kNode);
  CHECK(read_mesh({folder.path("x.npz"), from_1})->mesh.first_index == 1);
  CHECK(read_mesh_line_by_line({folder.path("x.npz")})->mesh.simplices.lists() == kTwoTriangles);
  const std::string lone = folder.write("lone.npz", npz({{"simplices.npy", simplices}}, 0));
  CHECK(error_of(read_mesh({lone})) ==
        lone +
            ": expected an array named points, as numpy.savez(file, points=..., simplices=...) "
            "writes it, found \"simplices.npy\"");
}

TEST_CASE("plain meshes: triangles and edges beside them, if they are asked for") {
  const ScratchFolder folder;
  folder.write("x.node", kNode);
  MeshRequest request{folder.write("x.ele", kEle)};
  request.with_faces = true;
  CHECK(is_read(request));
  folder.write("x.edge", "2\n1 3 2\n2 9 -5\n");
  folder.write("x.face", "1 1\n1 1 2 3 7\n");
  CHECK(is_read(request));
  CHECK(read_plain_mesh(request)->mesh.faces == std::vector<Simplex>{{0, 1, 2}, {2, 1}, {8, -6}});
  // A triangle is not a proper face of a mesh in the plane.
  CHECK(read_mesh(request)->mesh.faces == std::vector<Simplex>{{2, 1}, {8, -6}});
  CHECK(read_plain_mesh({request.mesh})->mesh.faces.empty());
  folder.write("x.face", "1 1\n1 1 2\n");
  CHECK(!is_read(request));
  CHECK(is_read({request.mesh}));
}

TEST_CASE("plain meshes: all else is read as ever") {
  const ScratchFolder folder;
  folder.write("x.node", kNode);
  const std::string ele = folder.write("x.ele", kEle);
  CHECK(!is_read({.mesh = ele, .reading = NumberReading::kDecimal}));
  MeshRequest request{ele};
  request.domain_dimension = 2;
  CHECK(is_read(request));
  request = {ele};
  request.own_points = PointFile{2};
  CHECK(!is_read(request));
  CHECK(!is_read({"-"}));
  folder.write("x.ele", "1 4\n1 1 2 3 4\n");
  CHECK(!is_read({ele}));
}

// Writes a text into a pipe of that name as soon as a reader opens it, within ten seconds.
class Pipe {
 public:
  Pipe(const std::string& path, const std::string& text) {
    if (mkfifo(path.c_str(), 0600) != 0) throw std::runtime_error("no pipe");
    writer_ = std::jthread([path, text] {
      for (int tries = 0; tries < 1000; ++tries) {
        const int pipe = open(path.c_str(), O_WRONLY | O_NONBLOCK);
        if (pipe >= 0) {
          CHECK(write(pipe, text.data(), text.size()) == static_cast<ssize_t>(text.size()));
          close(pipe);
          return;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
    });
  }

 private:
  std::jthread writer_;
};

TEST_CASE("plain meshes: what comes through pipes is read once, and kept for the other reader") {
  const ScratchFolder folder;
  const auto request_of = [&](const std::string& mesh, const std::string& points) {
    const Pipe mesh_pipe(folder.path(mesh), kEle);
    const Pipe points_pipe(folder.path(points), kNode);
    MeshRequest request{folder.path(mesh), folder.path(points)};
    CHECK(!read_plain_mesh(request));
    load_streams(request);
    CHECK(request.loaded.size() == 2);
    return request;
  };
  // They are recognised by their names, and by their contents.
  for (const std::string end : {"1", ".ele"}) {
    const MeshRequest request = request_of("mesh" + end, end == "1" ? "points" : "points.node");
    CHECK(is_read(request));
    CHECK(read_plain_mesh(request)->mesh.first_index == 1);
  }
}

TEST_CASE("load_streams: nothing of what can be read again, and what is wrong with the rest") {
  const ScratchFolder folder;
  folder.write("x.node", kNode);
  MeshRequest request{folder.write("x.ele", kEle)};
  load_streams(request);
  CHECK(request.loaded.empty());
  request = {folder.path("none.ele"), folder.path("none.node")};
  load_streams(request);
  CHECK(request.loaded.empty());
  request = {folder.path("none.ele"), "-"};
  load_streams(request);
  CHECK(request.loaded.empty());
  request = {"-", "-"};
  load_streams(request);
  CHECK(request.loaded.empty());
  // Neither its name nor its content tells a mesh format.
  request = {folder.write("mesh", kEle)};
  load_streams(request);
  CHECK(request.loaded.size() == 1);
  CHECK(!is_read(request));
  request = {folder.path("mesh"), folder.path("x.node")};
  load_streams(request);
  CHECK(is_read(request));
  request = {folder.path(""), folder.path("x.node")};
  load_streams(request);
  CHECK(!is_read(request));
  CHECK(read_mesh(request).error().to_string() ==
        folder.path("") + ": expected a file, found a directory");
}

TEST_CASE("npy files are known by what they hold, and need points") {
  const ScratchFolder folder;
  const std::string points = folder.write("points", npy("<f8", "(4, 2)", kCorners));
  const std::string simplices =
      folder.write("simplices", npy<std::int32_t>("<i4", "(2, 3)", {0, 1, 2, 1, 3, 2}));
  const auto mesh = read_mesh({simplices, points});
  REQUIRE(mesh.has_value());
  CHECK(mesh->mesh.simplices.lists() == kTwoTriangles);
  CHECK(mesh->mesh.points() == 4);
  CHECK(read_mesh({simplices}).error().to_string() ==
        simplices + ": expected --points FILE, with the points of these simplices, found none");
}

}  // namespace circumspect::formats
