#include "command/build/domain_mesh_output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "command/output/output.hpp"
#include "oracle/formats/format.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/tetgen.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::cli {
namespace {

// `size`: how many vertices each has, if there are none.
formats::SimplexFile numbered(const std::vector<Simplex>& simplices, std::size_t size,
                              Vertex first_index) {
  formats::SimplexFile file;
  file.first_index = first_index >= 0 && has_room(first_index, simplices.size()) ? first_index : 0;
  file.vertices_per_simplex = size;
  for (Simplex simplex : simplices) {
    for (Vertex& v : simplex) v += first_index;
    file.simplices.push_back(std::move(simplex));
  }
  return file;
}

// Those of full dimension, positively oriented. (Triangles of polygons in space have no
// orientation.)
formats::SimplexFile simplices_of(const DomainMesh& mesh, Vertex first_index) {
  const std::size_t full = mesh.points.ambient_dimension() + 1;
  std::vector<Simplex> simplices = mesh.triangulation.simplices;
  for (Simplex& simplex : simplices) {
    if (simplex.size() == full) simplex = positively_oriented(mesh.points, simplex);
  }
  const std::size_t size = simplices.empty() ? full : simplices.front().size();
  return numbered(simplices, size, first_index);
}

// The dangling triangles and edges. (Isolated vertices are among the points.)
std::vector<Simplex> dangling_faces(const DomainMesh& mesh) {
  std::vector<Simplex> faces;
  for (const Simplex& simplex : mesh.triangulation.dangling) {
    if (simplex.size() > 1) faces.push_back(simplex);
  }
  return faces;
}

formats::SimplexFile dangling(const DomainMesh& mesh, std::size_t size, Vertex first_index) {
  std::vector<Simplex> chosen;
  for (const Simplex& simplex : mesh.triangulation.dangling) {
    if (simplex.size() == size) chosen.push_back(simplex);
  }
  return numbered(chosen, size, first_index);
}

formats::PointFile points_of(const DomainMesh& mesh, Vertex first_index) {
  formats::PointFile file;
  file.dimension = mesh.points.ambient_dimension() + (mesh.height ? 1 : 0);
  for (Vertex v = 0; mesh.points.names(v); ++v) file.points.push_back(mesh.as_given(v));
  file.first_index = first_index;
  return file;
}

// OUT of OUT.ele.
std::string stem_of(const std::string& path) {
  return path.substr(0, path.size() - formats::extension(path).size());
}

formats::ElementFile element_file(const DomainMesh& mesh, Vertex first_index) {
  formats::ElementFile file;
  file.points = points_of(mesh, first_index);
  file.edges = dangling(mesh, 2, first_index);
  formats::SimplexFile simplices = simplices_of(mesh, first_index);
  if (simplices.vertices_per_simplex == 4) {
    file.triangles = dangling(mesh, 3, first_index);
    file.tetrahedra = std::move(simplices);
  } else {
    file.triangles = std::move(simplices);
  }
  return file;
}

// Do the points stand in a file of their own beside it? A stream, which is "-" or a pipe of any
// name, has nothing beside it.
bool has_files_beside(const std::string& path) { return formats::extension(path) == ".ele"; }
bool is_stream(const std::string& path) {
  const std::string end = formats::extension(path);
  return end != ".ele" && end != ".json" && formats::writer_of(end) == nullptr;
}

}  // namespace

std::vector<std::string_view> endings_of_domain_meshes() {
  std::vector<std::string_view> endings = formats::written_endings();
  endings.insert(endings.begin(), ".ele");
  endings.push_back(".json");
  return endings;
}

std::string numbering_fault(const DomainMesh& mesh, Vertex first_index) {
  if (has_room(first_index, mesh.points.size())) return "";
  return fmt::format(
      "expected indices of vertices that leave room for {} points in 64 bits, found the first "
      "index {}; "
      "count from 0 or 1",
      mesh.points.size(), first_index);
}

std::string domain_mesh_fault(const std::string& path, const DomainMesh& mesh) {
  if (!is_stream(path)) return "";
  const std::size_t dangling = dangling_faces(mesh).size();
  const std::size_t steiner_points = mesh.steiner_points.size();
  std::vector<std::string> lost;
  if (dangling > 0) {
    lost.push_back(
        report::counted(dangling, "dangling triangle or edge", "dangling triangles and edges"));
  }
  if (steiner_points > 0) {
    lost.push_back((steiner_points == 1 ? "the place of " : "the places of ") +
                   report::counted(steiner_points, "Steiner point"));
  }
  if (lost.empty()) return "";
  return fmt::format("expected -o OUT{} or --format json, found -o {}, which would lose {}",
                     fmt::join(endings_of_domain_meshes(), ", OUT"), path,
                     fmt::join(lost, " and "));
}

std::string write_domain_mesh(const std::string& path, const DomainMesh& mesh, Vertex first_index) {
  if (const formats::ElementWriter write = formats::writer_of(formats::extension(path))) {
    return write_file(
        path, [&](std::ostream& stream) { write(stream, element_file(mesh, first_index)); });
  }
  if (formats::extension(path) == ".json") {
    return write_file(path, [&](std::ostream& stream) {
      formats::write_json(stream, json_file(mesh, first_index));
    });
  }
  const std::string stem = stem_of(path);
  const auto write_faces = [&](const std::string& beside, std::size_t size) {
    return write_file(stem + beside, [&](std::ostream& stream) {
      formats::write_face(stream, dangling(mesh, size, first_index));
    });
  };
  std::string failure;
  if (has_files_beside(path)) {
    failure = write_file(stem + ".node", [&](std::ostream& stream) {
      formats::write_node(stream, points_of(mesh, first_index));
    });
    if (failure.empty()) failure = write_faces(".edge", 2);
    if (failure.empty() && mesh.points.ambient_dimension() == 3) failure = write_faces(".face", 3);
  }
  if (!failure.empty()) return failure;
  return write_file(path, [&](std::ostream& stream) {
    formats::write_ele(stream, simplices_of(mesh, first_index));
  });
}

std::vector<std::string> files_of_domain_mesh(const std::string& path, const DomainMesh& mesh) {
  if (!has_files_beside(path)) return {path};
  const std::string stem = stem_of(path);
  std::vector<std::string> paths = {path, stem + ".node", stem + ".edge"};
  if (mesh.points.ambient_dimension() == 3) paths.push_back(stem + ".face");
  return paths;
}

formats::JsonFile json_file(const DomainMesh& mesh, Vertex first_index) {
  formats::JsonFile file;
  file.points = points_of(mesh, first_index);
  file.has_simplices = true;
  file.simplices = simplices_of(mesh, first_index);
  file.faces = numbered(dangling_faces(mesh), 0, first_index);
  return file;
}

}  // namespace circumspect::cli
