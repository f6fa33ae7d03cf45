#include <new>
#include <utility>

#include "oracle/formats/bytes/packed.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/npy.hpp"
#include "oracle/formats/plane.hpp"
#include "oracle/formats/tetgen.hpp"

namespace circumspect::formats {
namespace {

// A file, or its loaded text.
struct FileBytes {
  std::optional<RandomAccess> file = {};
  const Source* text = nullptr;  // if it has been loaded
};

FileBytes bytes_of(const MeshRequest& request, const std::string& path) {
  const Result<Source>* const loaded = find_loaded(request, path);
  if (loaded == nullptr) return {RandomAccess::open(path)};
  if (!*loaded) return {};
  return {RandomAccess(std::string_view((*loaded)->text)), &**loaded};
}

std::optional<PlainPoints> plain_points(const MeshRequest& request, const std::string& path,
                                        const PlainReading& reading) {
  const FileBytes bytes = bytes_of(request, path);
  if (!bytes.file) return std::nullopt;
  const std::string_view kind = format_of_points(path, bytes.text);
  if (kind == ".node") return read_plain_node(*bytes.file, reading);
  if (kind != ".npy") return std::nullopt;
  Result<Rows<double>> coordinates = read_rows_of_npy_points(*bytes.file, path);
  if (!coordinates) return std::nullopt;
  return PlainPoints{std::move(*coordinates)};
}

// Subtracts the index of the first point from each vertex; nothing if one does not fit.
template <class Index>
std::optional<IndexLists> counted_from(Vertex first_point, Rows<Index> simplices) {
  if (first_point != 0) {
    for (Index& vertex : simplices.values()) {
      if (__builtin_sub_overflow(vertex, first_point, &vertex)) return std::nullopt;
    }
  }
  return IndexLists(std::move(simplices));
}

std::optional<IndexLists> read_simplices(const RandomAccess& file, std::string_view kind,
                                         Vertex first_point, const PlainReading& reading) {
  if (kind == ".ele") {
    auto simplices = read_plain_ele(file, first_point, reading);
    if (!simplices) return std::nullopt;
    return IndexLists(std::move(simplices->rows));
  }
  Result<NpySimplices> simplices = read_rows_of_npy_simplices(file, "");
  if (!simplices) return std::nullopt;
  return std::visit(
      [first_point](auto& rows) { return counted_from(first_point, std::move(rows)); }, *simplices);
}

bool read_neighbors(const std::string& ele, std::size_t columns, const PlainReading& reading,
                    Mesh& mesh) {
  const std::optional<RandomAccess> file = RandomAccess::open(beside(ele, ".neigh"));
  if (!file) return false;
  auto neighbors = read_plain_neigh(*file, reading);
  if (!neighbors) return false;
  const bool fits =
      neighbors->rows.rows() == mesh.simplices.size() && neighbors->rows.columns() == columns;
  mesh.neighbors.emplace(IndexLists(std::move(neighbors->rows)), neighbors->first_index);
  return fits;
}

// The triangles and edges beside an .ele file, if there are such files.
bool read_plain_faces(const std::string& ele, MeshFile& read) {
  Mesh& mesh = read.mesh;
  for (const auto& [end, vertices] : {std::pair{".face", 3}, std::pair{".edge", 2}}) {
    const std::string path = beside(ele, end);
    if (!exists(path)) continue;
    const Result<Source> source = load_unpacked(path);
    if (!source) return false;
    Result<SimplexFile> file = read_face(*source, static_cast<std::size_t>(vertices));
    if (!file) return false;
    add_markers(*file, mesh.first_index, read.face_markers);
    for (Simplex face : file->simplices) {
      for (Vertex& v : face) {
        if (__builtin_sub_overflow(v, mesh.first_index, &v)) return false;
      }
      mesh.faces.push_back(std::move(face));
    }
  }
  return true;
}

// The number of columns of the simplices, even if there are no rows.
std::size_t columns_of(const IndexLists& simplices) {
  if (const auto* const wide = simplices.rows<std::int64_t>()) return wide->columns();
  return simplices.rows<std::int32_t>()->columns();
}

std::optional<MeshFile> read_rows(const MeshRequest& request, const PlainReading& reading) {
  if (request.reading != NumberReading::kDouble || request.own_points) return std::nullopt;
  std::string path = request.mesh;
  if (extension_inside(path) == ".node") path = beside(path, ".ele");
  const FileBytes bytes = bytes_of(request, path);
  if (!bytes.file) return std::nullopt;
  const std::string_view kind = format_of_mesh(path, bytes.text, request.points.has_value());
  const bool has_files_beside = extension_inside(path) == ".ele";
  if (kind != ".ele" && kind != ".npy") return std::nullopt;
  if (!has_files_beside && (!request.points || request.with_neighbors)) return std::nullopt;
  const std::string points_path = request.points ? *request.points : beside(path, ".node");
  auto points = plain_points(request, points_path, reading);
  if (!points) return std::nullopt;
  MeshFile file;
  Mesh& mesh = file.mesh;
  mesh.first_index = points->first_index;
  file.points_name = points_path == "-" ? std::string(kStandardInputName) : points_path;
  file.mesh_name = path == "-" ? std::string(kStandardInputName) : path;
  if (request.weights == Weights::kDemanded) {
    if (points->weights.rows() != points->coordinates.rows()) return std::nullopt;
    mesh.weights = std::move(points->weights);
  }
  mesh.coordinates = std::move(points->coordinates);
  auto simplices = read_simplices(*bytes.file, kind, mesh.first_index, reading);
  if (!simplices) return std::nullopt;
  mesh.simplices = std::move(*simplices);
  const std::size_t columns = columns_of(mesh.simplices);
  if (may_be_of_plane(request) && columns <= 3) leave_out_height(file, request.domain_height);
  if (columns > mesh.dimension() + 1) return std::nullopt;
  if (request.with_faces && has_files_beside && !read_plain_faces(path, file)) return std::nullopt;
  if (request.with_neighbors) {
    if (!read_neighbors(path, columns, reading, mesh)) return std::nullopt;
  } else if (is_of_domain_dimension(request, mesh)) {
    take_for_faces(file);
  }
  return file;
}

}  // namespace

std::optional<MeshFile> read_plain_mesh(const MeshRequest& request, const PlainReading& reading) {
  try {
    return read_rows(request, reading);
  } catch (const std::bad_alloc&) {
    return std::nullopt;
  }
}

}  // namespace circumspect::formats
