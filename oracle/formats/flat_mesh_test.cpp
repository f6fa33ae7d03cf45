// Which meshes are read into flat arrays, and that they are those that read_mesh reads.
#include "oracle/formats/flat_mesh.hpp"

#include <chrono>
#include <stdexcept>
#include <thread>

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "inputs/scratch_folder_test.hpp"
#include "oracle/formats/npy_bytes_test.hpp"
#include "oracle/formats/same_values_test.hpp"

namespace circumspect::formats {
namespace {

const std::string kNode = "4 2 1\n1 0 0 9\n2 1 0 9\n3 0 1 9\n4 1 1 -0.25\n";
const std::string kEle = "2 3 0\n1 1 2 3\n2 2 4 3\n";
const std::string kNeigh = "2 3\n1 2 -1 -1\n2 -1 1 -1\n";
const std::vector<double> kSquare = {0, 0, 1, 0, 0, 1, 1, 1};
const std::vector<Simplex> kTwo = {{0, 1, 2}, {1, 3, 2}};

// All that raw_mesh promises.
void check_same(const RawMesh& raw, const RawMesh& read) {
  CHECK(raw.points.dimension == read.points.dimension);
  CHECK(raw.points.points == read.points.points);
  CHECK(raw.points.first_index == read.points.first_index);
  CHECK(raw.points.attributes.size() == read.points.attributes.size());
  for (std::size_t i = 0; i < raw.points.attributes.size(); ++i) {
    CHECK(raw.points.attributes[i].front() == read.points.attributes[i].front());
  }
  CHECK(raw.simplices.simplices == read.simplices.simplices);
  CHECK(raw.simplices.vertices_per_simplex == read.simplices.vertices_per_simplex);
  CHECK(raw.first_index == read.first_index);
  CHECK(raw.points_name == read.points_name);
  CHECK(raw.neighbors == read.neighbors);
  CHECK(raw.faces == read.faces);
}

// What both readers read is the same; true if the flat one has an answer.
bool is_read(const MeshRequest& request) {
  const auto flat = read_flat_mesh(request);
  if (!flat) return false;
  const auto mesh = read_mesh(request);
  REQUIRE(mesh.has_value());
  check_same(raw_mesh(*flat), *mesh);
  CHECK(flat->dimension() == mesh->points.dimension);
  CHECK(flat->points.first_index == mesh->first_index);
  CHECK(has_same_rows(flat->points.coordinates, mesh->points.points));
  CHECK(has_same_rows(flat->points.weights, mesh->points.attributes));
  std::visit(
      [&mesh](const auto& rows) { CHECK(has_same_rows(rows, mesh->simplices.simplices, 0)); },
      flat->simplices);
  CHECK(flat->neighbors.has_value() == mesh->neighbors.has_value());
  if (flat->neighbors) {
    CHECK(
        has_same_rows(*flat->neighbors, mesh->neighbors->neighbors, mesh->neighbors->first_index));
  }
  return true;
}

}  // namespace

TEST_CASE("flat meshes: .ele beside .node, either named, and with other points") {
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

TEST_CASE("flat meshes: neighbours where they are asked for") {
  const ScratchFolder folder;
  folder.write("x.node", kNode);
  MeshRequest request{folder.write("x.ele", kEle)};
  request.with_neighbors = true;
  CHECK(!is_read(request));
  folder.write("x.neigh", kNeigh);
  CHECK(is_read(request));
  CHECK(read_flat_mesh(request)->neighbors->row(1)[1] == 0);
  request.with_neighbors = false;
  CHECK(is_read(request));
  CHECK(!read_flat_mesh(request)->neighbors);
  request.with_neighbors = true;
  folder.write("x.neigh", "1 3\n1 2 -1 -1\n");
  CHECK(!is_read(request));
  folder.write("x.neigh", "2 2\n1 2 -1\n2 -1 1\n");
  CHECK(!is_read(request));
}

TEST_CASE("flat meshes: .npy for points, for simplices, and for both") {
  const ScratchFolder folder;
  const std::string points = folder.write("points.npy", npy("<f8", "(4, 2)", kSquare));
  const std::string narrow =
      folder.write("narrow.npy", npy<std::int32_t>("<i4", "(2, 3)", {0, 1, 2, 1, 3, 2}));
  const std::string wide =
      folder.write("wide.npy", npy<std::int64_t>("<i8", "(2, 3)", {0, 1, 2, 1, 3, 2}));
  CHECK(is_read({narrow, points}));
  CHECK(is_read({wide, points}));
  CHECK(read_mesh({wide, points})->simplices.simplices == kTwo);
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

TEST_CASE("flat meshes: triangles and edges beside them, if they are asked for") {
  const ScratchFolder folder;
  folder.write("x.node", kNode);
  MeshRequest request{folder.write("x.ele", kEle)};
  request.with_faces = true;
  CHECK(is_read(request));
  folder.write("x.edge", "2\n1 3 2\n2 9 -5\n");
  folder.write("x.face", "1 1\n1 1 2 3 7\n");
  CHECK(is_read(request));
  CHECK(read_flat_mesh(request)->faces == std::vector<Simplex>{{0, 1, 2}, {2, 1}, {8, -6}});
  CHECK(read_flat_mesh({request.mesh})->faces.empty());
  folder.write("x.face", "1 1\n1 1 2\n");
  CHECK(!is_read(request));
  CHECK(is_read({request.mesh}));
}

TEST_CASE("flat meshes: all else is read as ever") {
  const ScratchFolder folder;
  folder.write("x.node", kNode);
  const std::string ele = folder.write("x.ele", kEle);
  CHECK(!is_read({ele, {}, NumberReading::kDecimal}));
  MeshRequest request{ele};
  request.domain_dimension = 2;
  CHECK(!is_read(request));
  request = {ele};
  request.own_points = PointFile{2};
  CHECK(!is_read(request));
  CHECK(!is_read({"-"}));
  folder.write("x.ele", "1 4\n1 1 2 3 4\n");
  CHECK(!is_read({ele}));
}

// Writes a text into a pipe of that name as soon as somebody reads it, within ten seconds.
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

TEST_CASE("flat meshes: what comes through pipes is read once, and kept for the other reader") {
  const ScratchFolder folder;
  const auto request_of = [&](const std::string& mesh, const std::string& points) {
    const Pipe mesh_pipe(folder.path(mesh), kEle);
    const Pipe points_pipe(folder.path(points), kNode);
    MeshRequest request{folder.path(mesh), folder.path(points)};
    CHECK(!read_flat_mesh(request));
    load_streams(request);
    CHECK(request.loaded.size() == 2);
    return request;
  };
  // Known by their names, and by what they hold.
  for (const std::string end : {"1", ".ele"}) {
    const MeshRequest request = request_of("mesh" + end, end == "1" ? "points" : "points.node");
    CHECK(is_read(request));
    CHECK(read_flat_mesh(request)->points.first_index == 1);
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
  // No format by name, and none of a mesh by what it holds.
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
  const std::string points = folder.write("points", npy("<f8", "(4, 2)", kSquare));
  const std::string simplices =
      folder.write("simplices", npy<std::int32_t>("<i4", "(2, 3)", {0, 1, 2, 1, 3, 2}));
  const auto mesh = read_mesh({simplices, points});
  REQUIRE(mesh.has_value());
  CHECK(mesh->simplices.simplices == kTwo);
  CHECK(mesh->points.points.size() == 4);
  CHECK(read_mesh({simplices}).error().to_string() ==
        simplices + ": expected --points FILE, with the points of these simplices, found none");
}

}  // namespace circumspect::formats
