#include "oracle/formats/vtk_cells.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace circumspect::formats {

namespace {

constexpr std::array kVtkTypes = {
    ElementType{1, 1, ElementShape::kPoint, "a vertex"},
    ElementType{2, 0, ElementShape::kPoint, "a list of vertices"},
    ElementType{3, 2, ElementShape::kPolyline, "an edge"},
    ElementType{4, 0, ElementShape::kPolyline, "a polyline"},
    ElementType{5, 3, ElementShape::kPolygon, "a triangle"},
    ElementType{6, 0, ElementShape::kStrip, "a strip of triangles"},
    ElementType{7, 0, ElementShape::kPolygon, "a polygon"},
    ElementType{8, 4, ElementShape::kPixel, "a pixel"},
    ElementType{9, 4, ElementShape::kPolygon, "a quadrilateral"},
    ElementType{10, 4, ElementShape::kTetrahedron, "a tetrahedron"},
    ElementType{11, 8, ElementShape::kOtherSolid, "a voxel"},
    ElementType{12, 8, ElementShape::kOtherSolid, "a hexahedron"},
    ElementType{13, 6, ElementShape::kOtherSolid, "a prism"},
    ElementType{14, 5, ElementShape::kOtherSolid, "a pyramid"},
    ElementType{15, 10, ElementShape::kOtherSolid, "a pentagonal prism"},
    ElementType{16, 12, ElementShape::kOtherSolid, "a hexagonal prism"},
    ElementType{21, 3, ElementShape::kCurvedEdge, "an edge of second order"},
    ElementType{22, 6, ElementShape::kCurvedTriangle, "a triangle of second order"},
    ElementType{24, 10, ElementShape::kCurvedTetrahedron, "a tetrahedron of second order"},
    ElementType{34, 7, ElementShape::kCurvedTriangle, "a triangle of second order"},
    ElementType{35, 4, ElementShape::kCurvedEdge, "an edge of third order"},
    ElementType{42, 0, ElementShape::kOtherSolid, "a polyhedron"},
    ElementType{68, 0, ElementShape::kCurvedEdge, "an edge of Lagrange's"},
    ElementType{69, 0, ElementShape::kCurvedTriangle, "a triangle of Lagrange's"},
    ElementType{71, 0, ElementShape::kCurvedTetrahedron, "a tetrahedron of Lagrange's"},
    ElementType{75, 0, ElementShape::kCurvedEdge, "an edge of Bézier's"},
    ElementType{76, 0, ElementShape::kCurvedTriangle, "a triangle of Bézier's"},
    ElementType{78, 0, ElementShape::kCurvedTetrahedron, "a tetrahedron of Bézier's"},
};
constexpr Vertex kFirstCurved = 21;  // and all later ones that are not listed above
constexpr Vertex kLastCurved = 81;

const ElementType* type_of(Vertex code) {
  const auto* const found = std::find_if(kVtkTypes.begin(), kVtkTypes.end(),
                                         [&](const ElementType& one) { return one.code == code; });
  return found == kVtkTypes.end() ? nullptr : found;
}

// The list of the file for simplices of this type; null if they are none.
SimplexFile* list_of(ElementFile& file, const ElementType& type) {
  switch (type.vertices == 0 ? ElementShape::kOtherSolid : type.shape) {
    case ElementShape::kPolyline:
      return &file.edges;
    case ElementShape::kPolygon:
      return type.vertices == 3 ? &file.triangles : nullptr;
    case ElementShape::kTetrahedron:
      return &file.tetrahedra;
    default:
      return nullptr;
  }
}

}  // namespace

std::optional<std::string> add_vtk_cell(ElementFile& file, Vertex type,
                                        std::span<const Vertex> vertices, std::size_t line,
                                        std::optional<Vertex> label) {
  const ElementType* const found = type_of(type);
  if (found == nullptr) {
    if (type < kFirstCurved || type > kLastCurved) return "a type of cells that VTK knows";
    return add_element(file, ElementShape::kCurved, vertices, "a cell of second order or more",
                       line, label);
  }
  if (found->vertices != 0 && vertices.size() != found->vertices) {
    return std::string(found->name) + " of " + std::to_string(found->vertices) + " vertices";
  }
  return add_element(file, found->shape, vertices, found->name, line, label);
}

bool take_vtk_cells(ElementFile& file, const Indices& types, VtkCells& cells) {
  if (types.size() == 0) return false;
  const ElementType* const type = type_of(types[0]);
  SimplexFile* const list = type == nullptr ? nullptr : list_of(file, *type);
  if (list == nullptr || !list->simplices.empty()) return false;
  if (cells.vertices.columns() != type->vertices) return false;
  for (std::size_t i = 1; i < types.size(); ++i) {
    if (types[i] != types[0]) return false;
  }
  list->simplices = std::move(cells.vertices);
  list->lines = std::move(cells.lines);
  return true;
}

namespace {

// Every cell has the same number of vertices, and all are used.
bool are_even(const Indices& offsets, std::size_t vertices) {
  if (offsets.size() == 0 || offsets[0] < 1) return false;
  const Vertex each = offsets[0];
  for (std::size_t i = 1; i < offsets.size(); ++i) {
    if (offsets[i] - offsets[i - 1] != each) return false;
  }
  return static_cast<std::size_t>(offsets.back()) == vertices;
}

}  // namespace

Result<VtkCells> cells_of(const MixedText& text, const Indices& offsets, Indices connectivity,
                          std::size_t line) {
  VtkCells cells;
  for (std::size_t i = 0; i < offsets.size(); ++i) cells.lines.push_back(line);
  const auto size = static_cast<Vertex>(connectivity.size());
  Vertex begin = 0;
  std::size_t i = 0;
  for (; i < offsets.size() && offsets[i] >= begin && offsets[i] <= size; ++i) begin = offsets[i];
  if (i < offsets.size()) {
    return tl::unexpected(
        FormatError{text.name(), line,
                    "an offset from " + std::to_string(begin) + " to " + std::to_string(size),
                    std::to_string(offsets[i])});
  }
  if (begin != size) {
    return tl::unexpected(
        FormatError{text.name(), line,
                    "offsets up to " + std::to_string(size) + ", the end of the vertices of cells",
                    std::to_string(begin)});
  }
  if (are_even(offsets, connectivity.size())) {
    const auto each = static_cast<std::size_t>(offsets[0]);
    cells.vertices = SimplexRows(std::move(connectivity), each);
    return cells;
  }
  Simplex vertices;
  begin = 0;
  for (i = 0; i < offsets.size(); ++i) {
    vertices.clear();
    for (; begin < offsets[i]; ++begin) {
      vertices.push_back(connectivity[static_cast<std::size_t>(begin)]);
    }
    cells.vertices.push_back(vertices);
  }
  return cells;
}

}  // namespace circumspect::formats
