#include "oracle/formats/element_file.hpp"

#include <algorithm>
#include <iterator>
#include <span>

#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/simplex.hpp"

namespace circumspect::formats {

namespace {

void add_to(SimplexFile& list, std::span<const Vertex> vertices, std::size_t line,
            std::optional<Vertex> label) {
  list.simplices.push_back(vertices);
  list.lines.push_back(line);
  if (label) list.labels.push_back(*label);
}

// The least number of vertices of a shape.
std::size_t fewest_vertices(ElementShape shape) {
  switch (shape) {
    case ElementShape::kPolyline:
    case ElementShape::kCurvedEdge:
      return 2;
    case ElementShape::kPolygon:
    case ElementShape::kStrip:
    case ElementShape::kCurvedTriangle:
      return 3;
    case ElementShape::kPixel:
    case ElementShape::kTetrahedron:
    case ElementShape::kCurvedTetrahedron:
      return 4;
    default:
      return 1;
  }
}

// Its corners are the simplex that is judged.
void add_curved(ElementFile& file, SimplexFile& list, std::span<const Vertex> vertices,
                std::size_t corners, std::size_t line, std::optional<Vertex> label) {
  add_to(list, vertices.first(corners), line, label);
  add_to(file.curved, vertices, line, {});
  file.corners_of_curved.push_back(corners);
}

void add_polygon(ElementFile& file, std::span<const Vertex> vertices, std::string_view name,
                 std::size_t line, std::optional<Vertex> label) {
  if (vertices.size() == 3) {
    add_to(file.triangles, vertices, line, label);
    return;
  }
  if (!file.first_other) file.first_other = {std::string(name), line};
  add_to(file.polygons, vertices, line, label);
  file.triangles_before.push_back(file.triangles.simplices.size());
}

void add_strip(ElementFile& file, std::span<const Vertex> vertices, std::size_t line,
               std::optional<Vertex> label) {
  for (std::size_t i = 0; i + 2 < vertices.size(); ++i) {
    Simplex triangle = {vertices[i], vertices[i + 1], vertices[i + 2]};
    if (i % 2 == 1) std::swap(triangle[0], triangle[1]);  // all have one side in front
    add_to(file.triangles, triangle, line, label);
  }
}

}  // namespace

std::optional<std::string> add_element(ElementFile& file, ElementShape shape,
                                       std::span<const Vertex> vertices, std::string_view name,
                                       std::size_t line, std::optional<Vertex> label) {
  const std::size_t fewest = fewest_vertices(shape);
  if (vertices.size() < fewest) {
    return std::string(name) + " of " + std::to_string(fewest) +
           (fewest == 1 ? " vertex or more" : " vertices or more");
  }
  switch (shape) {
    case ElementShape::kPoint:
      break;
    case ElementShape::kPolyline:
      for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
        add_to(file.edges, vertices.subspan(i, 2), line, label);
      }
      break;
    case ElementShape::kPixel: {
      Simplex around(vertices.begin(), vertices.end());
      std::swap(around[2], around[3]);
      add_polygon(file, around, name, line, label);
      break;
    }
    case ElementShape::kPolygon:
      add_polygon(file, vertices, name, line, label);
      break;
    case ElementShape::kStrip:
      add_strip(file, vertices, line, label);
      break;
    case ElementShape::kTetrahedron:
      add_to(file.tetrahedra, vertices, line, label);
      break;
    case ElementShape::kOtherSolid:
      if (!file.first_other) file.first_other = {std::string(name), line};
      add_to(file.other_solids, vertices, line, label);
      break;
    case ElementShape::kCurvedEdge:
      add_curved(file, file.edges, vertices, 2, line, label);
      break;
    case ElementShape::kCurvedTriangle:
      add_curved(file, file.triangles, vertices, 3, line, label);
      break;
    case ElementShape::kCurvedTetrahedron:
      add_curved(file, file.tetrahedra, vertices, 4, line, label);
      break;
    case ElementShape::kCurved:
      if (!file.first_curved) file.first_curved = {std::string(name), line};
      break;
  }
  return std::nullopt;
}

void finish_elements(ElementFile& file) {
  for (SimplexFile* const list : file.lists()) {
    list->vertices_per_simplex = list->simplices.columns();
    list->first_index = file.points.first_index;
  }
}

Status check_simplices(const ElementFile& file, const std::string& name) {
  const auto& other = file.first_curved ? file.first_curved : file.first_other;
  if (!other) return {};
  return tl::unexpected(
      FormatError{name, other->line, "edges, triangles and tetrahedra", other->name});
}

TopElements top_elements(ElementFile& file) {
  TopElements top;
  for (SimplexFile* const list : {&file.edges, &file.triangles, &file.tetrahedra}) {
    if (list->simplices.empty()) continue;
    for (Simplex face : top.simplices.simplices) top.faces.push_back(std::move(face));
    top.simplices = std::move(*list);
  }
  return top;
}

std::vector<Simplex> surface_of(const ElementFile& file) {
  std::vector<Simplex> surface = file.triangles.simplices.lists();
  const std::vector<Simplex> tetrahedra = file.tetrahedra.simplices.lists();
  for (const auto uses : ByFacet(facet_uses(tetrahedra))) {
    if (uses.size() != 1) continue;
    const std::size_t place = uses.front().opposite;
    Simplex facet = facet_opposite(tetrahedra[uses.front().simplex], place);
    if (place % 2 == 0) std::swap(facet[0], facet[1]);
    surface.push_back(std::move(facet));
  }
  return surface;
}

bool is_of_plane(const ElementFile& file) {
  return file.tetrahedra.simplices.empty() && file.other_solids.simplices.empty() &&
         !file.first_curved;
}

}  // namespace circumspect::formats
