#include "oracle/formats/poly_mesh.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "kernel/exact/each_once.hpp"
#include "oracle/formats/bytes/packed.hpp"
#include "oracle/formats/foam_file.hpp"
#include "platform/files.hpp"

namespace circumspect::formats {
namespace {

// The file of this name in the folder, packed or not.
std::string file_in(const std::string& folder, const char* name) {
  const std::string path = folder + "/" + name;
  return packed_or_not(path);
}

bool holds_mesh(const std::string& folder) {
  return exists(file_in(folder, "points")) && exists(file_in(folder, "faces")) &&
         exists(file_in(folder, "owner"));
}

class PolyMeshReader {
 public:
  PolyMeshReader(std::string folder, NumberReading reading)
      : folder_(std::move(folder)), reading_(reading) {}

  Result<ElementFile> read();

 private:
  // Reads a file by what `read` takes from it.
  template <class Read>
  Status read_file(const char* name, const Read& read) const {
    const Result<Source> source = load_unpacked(file_in(folder_, name));
    if (!source) return tl::unexpected(source.error());
    Result<FoamFile> file = FoamFile::open(*source, reading_);
    if (!file) return tl::unexpected(file.error());
    return read(*file);
  }
  Status read_cells_of_faces(const char* name, Indices& cells) const;
  // The faces of each cell, one cell after the other.
  Status collect_faces();
  void add_cell(std::size_t cell);
  // A tetrahedron of these faces, positively oriented if the first face is as it should be; nothing
  // if they are not four triangles of four vertices.
  std::optional<Simplex> tetrahedron_of(std::size_t cell) const;
  tl::unexpected<FormatError> fail(const char* file, std::string expected,
                                   std::string found) const {
    return tl::unexpected(
        FormatError{file_in(folder_, file), 0, std::move(expected), std::move(found)});
  }

  std::string folder_;
  NumberReading reading_;
  SimplexRows faces_;
  Indices owner_;
  Indices neighbour_;
  std::vector<std::size_t> ends_;  // of the faces of each cell
  std::vector<std::size_t> faces_of_cells_;
  ElementFile file_;
};

Status PolyMeshReader::read_cells_of_faces(const char* name, Indices& cells) const {
  return read_file(name, [&](FoamFile& file) -> Status {
    Result<Indices> labels = file.read_labels();
    if (!labels) return tl::unexpected(labels.error());
    cells = std::move(*labels);
    return {};
  });
}

Status PolyMeshReader::collect_faces() {
  const std::size_t faces = faces_.size();
  if (owner_.size() != faces) {
    return fail("owner", std::to_string(faces) + " cells, one for each face",
                std::to_string(owner_.size()));
  }
  if (neighbour_.size() > faces) {
    return fail("neighbour", "at most " + std::to_string(faces) + " cells, as there are faces",
                std::to_string(neighbour_.size()));
  }
  // A cell has four faces or more, and a face at most two cells.
  const Vertex most = static_cast<Vertex>(faces) / 2 + 1;
  const auto count = [&](const Indices& cells, const char* name) -> Status {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Vertex cell = cells[i];
      if (cell == -1 && &cells == &neighbour_) continue;  // of the boundary, in old files
      if (cell < 0 || cell >= most) {
        return fail(
            name, "a cell from 0 to " + std::to_string(most - 1) + " at face " + std::to_string(i),
            std::to_string(cell));
      }
      const auto place = static_cast<std::size_t>(cell);
      if (place >= ends_.size()) ends_.resize(place + 1);
      ++ends_[place];
    }
    return {};
  };
  Status status = count(owner_, "owner");
  if (status) status = count(neighbour_, "neighbour");
  if (!status) return status;
  std::vector<std::size_t> next(ends_.size());
  std::size_t all = 0;
  for (std::size_t cell = 0; cell < ends_.size(); ++cell) {
    next[cell] = all;
    all += ends_[cell];
    if (ends_[cell] < 4) {
      return fail("owner", "4 faces or more of cell " + std::to_string(cell),
                  std::to_string(ends_[cell]));
    }
    ends_[cell] = all;
  }
  faces_of_cells_.resize(all);
  for (std::size_t face = 0; face < faces; ++face) {
    faces_of_cells_[next[static_cast<std::size_t>(owner_[face])]++] = face;
    const Vertex across = face < neighbour_.size() ? neighbour_[face] : -1;
    if (across >= 0) faces_of_cells_[next[static_cast<std::size_t>(across)]++] = face;
  }
  return {};
}

std::optional<Simplex> PolyMeshReader::tetrahedron_of(std::size_t cell) const {
  const std::size_t begin = cell == 0 ? 0 : ends_[cell - 1];
  if (ends_[cell] - begin != 4) return std::nullopt;
  Simplex vertices;
  std::array<Simplex, 4> sides;
  for (std::size_t i = 0; i < 4; ++i) {
    sides[i] = faces_[faces_of_cells_[begin + i]];
    if (sides[i].size() != 3) return std::nullopt;
    vertices.insert(vertices.end(), sides[i].begin(), sides[i].end());
    std::sort(sides[i].begin(), sides[i].end());
    if (std::adjacent_find(sides[i].begin(), sides[i].end()) != sides[i].end()) return std::nullopt;
  }
  keep_each_once(vertices);
  std::sort(sides.begin(), sides.end());
  if (vertices.size() != 4 || std::unique(sides.begin(), sides.end()) != sides.end()) {
    return std::nullopt;
  }
  // Seen from the owner the vertices of a face go around clockwise.
  const std::size_t face = faces_of_cells_[begin];
  Simplex tetrahedron = faces_[face];
  if (owner_[face] == static_cast<Vertex>(cell)) std::swap(tetrahedron[1], tetrahedron[2]);
  for (const Vertex v : vertices) {
    if (std::find(tetrahedron.begin(), tetrahedron.end(), v) == tetrahedron.end()) {
      tetrahedron.push_back(v);
    }
  }
  return tetrahedron;
}

void PolyMeshReader::add_cell(std::size_t cell) {
  if (const auto tetrahedron = tetrahedron_of(cell)) {
    add_element(file_, ElementShape::kTetrahedron, *tetrahedron, "a tetrahedron", 0);
    return;
  }
  const std::size_t begin = cell == 0 ? 0 : ends_[cell - 1];
  Simplex vertices;
  for (std::size_t i = begin; i < ends_[cell]; ++i) {
    const Simplex face = faces_[faces_of_cells_[i]];
    vertices.insert(vertices.end(), face.begin(), face.end());
  }
  keep_each_once(vertices);
  add_element(file_, ElementShape::kOtherSolid, vertices,
              "cell " + std::to_string(cell) + " of " + std::to_string(ends_[cell] - begin) +
                  " faces and " + std::to_string(vertices.size()) + " vertices",
              0);
}

Result<ElementFile> PolyMeshReader::read() {
  file_.points.dimension = 3;
  file_.points.points.set_columns(3);
  Status status =
      read_file("points", [&](FoamFile& file) { return file.read_points(file_.points.points); });
  if (status) {
    status = read_file("faces", [&](FoamFile& file) -> Status {
      Result<SimplexRows> faces = file.read_faces();
      if (!faces) return tl::unexpected(faces.error());
      faces_ = std::move(*faces);
      return {};
    });
  }
  if (status) status = read_cells_of_faces("owner", owner_);
  if (status) status = read_cells_of_faces("neighbour", neighbour_);
  if (status) status = collect_faces();
  if (!status) return tl::unexpected(status.error());
  for (std::size_t cell = 0; cell < ends_.size(); ++cell) add_cell(cell);
  for (std::size_t face = 0; face < faces_.size(); ++face) {
    const bool is_inside = face < neighbour_.size() && neighbour_[face] >= 0;
    if (is_inside || faces_.size_of(face) != 3) continue;
    add_element(file_, ElementShape::kPolygon, faces_[face], "a triangle", 0);
  }
  finish_elements(file_);
  return std::move(file_);
}

}  // namespace

std::optional<std::string> poly_mesh_folder(const std::string& path) {
  std::string folder = path;
  if (path.ends_with(".foam")) {
    const std::size_t slash = path.find_last_of(platform::kSeparators);
    folder = slash == std::string::npos ? "." : path.substr(0, slash);
  }
  for (const char* const below : {"", "/polyMesh", "/constant/polyMesh"}) {
    if (holds_mesh(folder + below)) return folder + below;
  }
  return std::nullopt;
}

Result<ElementFile> read_poly_mesh(const Source& source, NumberReading reading) {
  const auto folder = poly_mesh_folder(source.name);
  if (folder) return PolyMeshReader(*folder, reading).read();
  return tl::unexpected(FormatError{
      source.name, 0, "a case of OpenFOAM, with constant/polyMesh/points", "no such file"});
}

}  // namespace circumspect::formats
