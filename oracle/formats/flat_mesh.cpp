#include "oracle/formats/flat_mesh.hpp"

#include <new>
#include <utility>

#include "oracle/formats/face.hpp"
#include "oracle/formats/npy.hpp"

namespace circumspect::formats {
namespace {

std::string beside(const std::string& path, std::string_view other_extension) {
  return path.substr(0, path.size() - extension(path).size()) + std::string(other_extension);
}

// A file, or what has been loaded of it.
struct Bytes {
  std::optional<RandomAccess> file = {};
  const Source* text = nullptr;  // if it has been loaded
};

Bytes bytes_of(const MeshRequest& request, const std::string& path) {
  const Result<Source>* const loaded = find_loaded(request, path);
  if (loaded == nullptr) return {RandomAccess::open(path)};
  if (!*loaded) return {};
  return {RandomAccess(std::string_view((*loaded)->text)), &**loaded};
}

std::optional<FlatPoints> flat_points(const MeshRequest& request, const std::string& path,
                                      const PlainReading& reading) {
  const Bytes bytes = bytes_of(request, path);
  if (!bytes.file) return std::nullopt;
  const std::string_view kind = format_of_points(path, bytes.text);
  if (kind == ".node") return read_plain_node(*bytes.file, reading);
  if (kind != ".npy") return std::nullopt;
  Result<FlatRows<double>> coordinates = read_flat_npy_points(*bytes.file, path);
  if (!coordinates) return std::nullopt;
  return FlatPoints{std::move(*coordinates)};
}

// Vertices less the index of the first point.
template <class Index>
bool count_from(Vertex first_point, FlatRows<Index>& simplices) {
  if (first_point == 0) return true;
  for (Index& vertex : simplices.values()) {
    if (__builtin_sub_overflow(vertex, first_point, &vertex)) return false;
  }
  return true;
}

bool read_simplices(const RandomAccess& file, std::string_view kind, const PlainReading& reading,
                    FlatMesh& mesh) {
  const Vertex first_point = mesh.points.first_index;
  if (kind == ".ele") {
    auto simplices = read_plain_ele(file, first_point, reading);
    if (simplices) mesh.simplices = std::move(simplices->rows);
    return simplices.has_value();
  }
  Result<NpySimplices> simplices = read_flat_npy_simplices(file, "");
  if (!simplices) return false;
  mesh.simplices = std::move(*simplices);
  return std::visit([first_point](auto& rows) { return count_from(first_point, rows); },
                    mesh.simplices);
}

bool read_neighbors(const std::string& ele, const PlainReading& reading, FlatMesh& mesh) {
  const std::optional<RandomAccess> file = RandomAccess::open(beside(ele, ".neigh"));
  if (!file) return false;
  auto neighbors = read_plain_neigh(*file, reading);
  if (!neighbors) return false;
  mesh.neighbors = std::move(neighbors->rows);
  mesh.first_neighbor = neighbors->first_index;
  return std::visit(
      [&mesh](const auto& rows) {
        return rows.rows() == mesh.neighbors->rows() && rows.columns() == mesh.neighbors->columns();
      },
      mesh.simplices);
}

// The triangles and edges beside an .ele file, as far as there are files of them.
bool read_faces(const std::string& ele, FlatMesh& mesh) {
  for (const auto& [end, vertices] : {std::pair{".face", 3}, std::pair{".edge", 2}}) {
    const std::string path = beside(ele, end);
    if (!exists(path)) continue;
    const Result<Source> source = load(path);
    if (!source) return false;
    Result<SimplexFile> file = read_face(*source, static_cast<std::size_t>(vertices));
    if (!file) return false;
    for (Simplex& face : file->simplices) {
      for (Vertex& v : face) {
        if (__builtin_sub_overflow(v, mesh.points.first_index, &v)) return false;
      }
      mesh.faces.push_back(std::move(face));
    }
  }
  return true;
}

std::optional<FlatMesh> read(const MeshRequest& request, const PlainReading& reading) {
  if (request.reading != NumberReading::kDouble || request.domain_dimension || request.own_points) {
    return std::nullopt;
  }
  std::string path = request.mesh;
  if (extension(path) == ".node") path = beside(path, ".ele");
  const Bytes bytes = bytes_of(request, path);
  if (!bytes.file) return std::nullopt;
  const std::string_view kind = format_of_mesh(path, bytes.text, request.points.has_value());
  const bool has_files_beside = extension(path) == ".ele";
  if (kind != ".ele" && kind != ".npy") return std::nullopt;
  if (!has_files_beside && (!request.points || request.with_neighbors)) return std::nullopt;
  const std::string points_path = request.points ? *request.points : beside(path, ".node");
  auto points = flat_points(request, points_path, reading);
  if (!points) return std::nullopt;
  FlatMesh mesh{std::move(*points)};
  mesh.points_name = points_path == "-" ? "<stdin>" : points_path;
  if (!read_simplices(*bytes.file, kind, reading, mesh)) return std::nullopt;
  const std::size_t vertices =
      std::visit([](const auto& rows) { return rows.columns(); }, mesh.simplices);
  if (vertices > mesh.dimension() + 1) return std::nullopt;
  if (request.with_neighbors && !read_neighbors(path, reading, mesh)) return std::nullopt;
  if (request.with_faces && has_files_beside && !read_faces(path, mesh)) return std::nullopt;
  return mesh;
}

std::vector<Rational> exact_values(std::span<const double> numbers) {
  std::vector<Rational> values;
  values.reserve(numbers.size());
  for (const double number : numbers) values.push_back(exact_value(number));
  return values;
}

std::vector<std::vector<Rational>> exact_rows(const FlatRows<double>& rows) {
  std::vector<std::vector<Rational>> lists;
  lists.reserve(rows.rows());
  for (std::size_t i = 0; i < rows.rows(); ++i) lists.push_back(exact_values(rows.row(i)));
  return lists;
}

template <class Index>
std::vector<std::vector<Vertex>> index_rows(const FlatRows<Index>& rows) {
  std::vector<std::vector<Vertex>> lists;
  lists.reserve(rows.rows());
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    lists.emplace_back(rows.row(i).begin(), rows.row(i).end());
  }
  return lists;
}

}  // namespace

RawMesh raw_mesh(const FlatMesh& mesh) {
  RawMesh raw;
  raw.points.dimension = mesh.dimension();
  raw.points.points = exact_rows(mesh.points.coordinates);
  raw.points.attributes = exact_rows(mesh.points.weights);
  raw.points.first_index = mesh.points.first_index;
  raw.points_name = mesh.points_name;
  raw.first_index = mesh.points.first_index;
  raw.faces = mesh.faces;
  std::visit(
      [&raw](const auto& rows) {
        raw.simplices.simplices = index_rows(rows);
        raw.simplices.vertices_per_simplex = rows.columns();
      },
      mesh.simplices);
  if (mesh.neighbors) {
    NeighborFile& file = raw.neighbors.emplace();
    file.neighbors = index_rows(*mesh.neighbors);
    file.neighbors_per_simplex = mesh.neighbors->columns();
    file.first_index = mesh.first_neighbor;
    for (std::vector<Vertex>& row : file.neighbors) {
      for (Vertex& simplex : row) simplex += simplex == -1 ? 0 : file.first_index;
    }
  }
  return raw;
}

std::optional<FlatMesh> read_flat_mesh(const MeshRequest& request, const PlainReading& reading) {
  try {
    return read(request, reading);
  } catch (const std::bad_alloc&) {
    return std::nullopt;
  }
}

}  // namespace circumspect::formats
