#include "oracle/formats/flat_mesh.hpp"

#include <new>

#include "oracle/formats/npy.hpp"

namespace circumspect::formats {
namespace {

std::string beside(const std::string& path, std::string_view other_extension) {
  return path.substr(0, path.size() - extension(path).size()) + std::string(other_extension);
}

std::optional<FlatPoints> flat_points(const std::string& path, const PlainReading& reading) {
  const std::string kind = extension(path);
  if (kind != ".node" && kind != ".npy") return std::nullopt;
  const std::optional<RandomAccess> file = RandomAccess::open(path);
  if (!file) return std::nullopt;
  if (kind == ".node") return read_plain_node(*file, reading);
  Result<FlatRows<double>> coordinates = read_flat_npy_points(*file, path);
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

bool read_simplices(const std::string& path, const PlainReading& reading, FlatMesh& mesh) {
  const std::optional<RandomAccess> file = RandomAccess::open(path);
  if (!file) return false;
  const Vertex first_point = mesh.points.first_index;
  if (extension(path) == ".ele") {
    auto simplices = read_plain_ele(*file, first_point, reading);
    if (simplices) mesh.simplices = std::move(simplices->rows);
    return simplices.has_value();
  }
  Result<NpySimplices> simplices = read_flat_npy_simplices(*file, path);
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
  return std::visit(
      [&mesh](const auto& rows) {
        return rows.rows() == mesh.neighbors->rows() && rows.columns() == mesh.neighbors->columns();
      },
      mesh.simplices);
}

std::optional<FlatMesh> read(const MeshRequest& request, const PlainReading& reading) {
  if (request.reading != NumberReading::kDouble || request.with_faces || request.domain_dimension ||
      request.own_points) {
    return std::nullopt;
  }
  std::string path = request.mesh;
  if (extension(path) == ".node") path = beside(path, ".ele");
  const bool is_ele = extension(path) == ".ele";
  if (!is_ele && (extension(path) != ".npy" || !request.points || request.with_neighbors)) {
    return std::nullopt;
  }
  auto points = flat_points(request.points ? *request.points : beside(path, ".node"), reading);
  if (!points) return std::nullopt;
  FlatMesh mesh{std::move(*points)};
  if (!read_simplices(path, reading, mesh)) return std::nullopt;
  const std::size_t vertices =
      std::visit([](const auto& rows) { return rows.columns(); }, mesh.simplices);
  if (vertices > mesh.dimension() + 1) return std::nullopt;
  if (request.with_neighbors && !read_neighbors(path, reading, mesh)) return std::nullopt;
  return mesh;
}

}  // namespace

std::optional<FlatMesh> read_flat_mesh(const MeshRequest& request, const PlainReading& reading) {
  try {
    return read(request, reading);
  } catch (const std::bad_alloc&) {
    return std::nullopt;
  }
}

}  // namespace circumspect::formats
