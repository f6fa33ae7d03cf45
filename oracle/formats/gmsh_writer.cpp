#include <array>
#include <utility>

#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/gmsh.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace circumspect::formats {

void write_gmsh(std::ostream& out, const ElementFile& file) {
  const PointRows& points = file.points.points;
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + std::to_string(points.size()) + "\n";
  for (std::size_t i = 0; i < points.size(); ++i) {
    out << std::to_string(i + 1) + " " + joined(points[i]) +
               (points[i].size() == 2 ? " 0\n" : "\n");
  }
  const std::array<std::pair<const SimplexFile*, const char*>, 3> lists = {
      {{&file.edges, " 1 2 "}, {&file.triangles, " 2 2 "}, {&file.tetrahedra, " 4 2 "}}};
  std::size_t count = 0;
  for (const auto& list : lists) count += list.first->simplices.size();
  out << "$EndNodes\n$Elements\n" + std::to_string(count) + "\n";
  std::size_t tag = 0;
  for (const auto& [list, type] : lists) {
    for (std::size_t i = 0; i < list->simplices.size(); ++i) {
      Simplex vertices = list->simplices[i];
      for (Vertex& v : vertices) v = index_of_place(place_of_index(v, file.points.first_index), 1);
      const std::string group = std::to_string(list->labels.empty() ? 0 : list->labels[i]);
      out << std::to_string(++tag) + type + group + " 1 " + joined(vertices) + "\n";
    }
  }
  out << "$EndElements\n";
}

}  // namespace circumspect::formats
