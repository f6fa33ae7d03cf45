#include "oracle/formats/vtk_cells.hpp"

#include <algorithm>
#include <array>

namespace circumspect::formats {
namespace {

struct VtkType {
  Vertex code;
  std::size_t vertices;  // 0: any number
  ElementShape shape;
  std::string_view name;
};
constexpr std::array kVtkTypes = {
    VtkType{1, 1, ElementShape::kPoint, "a vertex"},
    VtkType{2, 0, ElementShape::kPoint, "a list of vertices"},
    VtkType{3, 2, ElementShape::kPolyline, "an edge"},
    VtkType{4, 0, ElementShape::kPolyline, "a polyline"},
    VtkType{5, 3, ElementShape::kPolygon, "a triangle"},
    VtkType{6, 0, ElementShape::kStrip, "a strip of triangles"},
    VtkType{7, 0, ElementShape::kPolygon, "a polygon"},
    VtkType{8, 4, ElementShape::kPixel, "a pixel"},
    VtkType{9, 4, ElementShape::kPolygon, "a quadrilateral"},
    VtkType{10, 4, ElementShape::kTetrahedron, "a tetrahedron"},
    VtkType{11, 8, ElementShape::kOtherSolid, "a voxel"},
    VtkType{12, 8, ElementShape::kOtherSolid, "a hexahedron"},
    VtkType{13, 6, ElementShape::kOtherSolid, "a prism"},
    VtkType{14, 5, ElementShape::kOtherSolid, "a pyramid"},
    VtkType{15, 10, ElementShape::kOtherSolid, "a pentagonal prism"},
    VtkType{16, 12, ElementShape::kOtherSolid, "a hexagonal prism"},
    VtkType{42, 0, ElementShape::kOtherSolid, "a polyhedron"},
};
constexpr Vertex kFirstCurved = 21;  // and those behind it, but for the polyhedron
constexpr Vertex kLastCurved = 81;

}  // namespace

std::optional<std::string> add_vtk_cell(ElementFile& file, Vertex type, Simplex vertices,
                                        std::size_t line) {
  const auto* const found = std::find_if(kVtkTypes.begin(), kVtkTypes.end(),
                                         [&](const VtkType& one) { return one.code == type; });
  if (found == kVtkTypes.end()) {
    if (type < kFirstCurved || type > kLastCurved) return "a type of cells that VTK knows";
    return add_element(file, ElementShape::kCurved, std::move(vertices),
                       "a cell of second order or more", line);
  }
  if (found->vertices != 0 && vertices.size() != found->vertices) {
    return std::string(found->name) + " of " + std::to_string(found->vertices) + " vertices";
  }
  return add_element(file, found->shape, std::move(vertices), found->name, line);
}

Result<VtkCells> cells_of(const MixedText& text, const std::vector<Vertex>& offsets,
                          const std::vector<Vertex>& connectivity, std::size_t line) {
  VtkCells cells;
  Vertex begin = 0;
  for (const Vertex end : offsets) {
    if (end < begin || end > static_cast<Vertex>(connectivity.size())) {
      return tl::unexpected(FormatError{
          text.name(), line,
          "an offset from " + std::to_string(begin) + " to " + std::to_string(connectivity.size()),
          std::to_string(end)});
    }
    cells.vertices.emplace_back(connectivity.begin() + begin, connectivity.begin() + end);
    cells.lines.push_back(line);
    begin = end;
  }
  if (begin == static_cast<Vertex>(connectivity.size())) return cells;
  return tl::unexpected(FormatError{text.name(), line,
                                    "offsets up to " + std::to_string(connectivity.size()) +
                                        ", the end of "
                                        "the vertices of cells",
                                    std::to_string(begin)});
}

Status read_vtk_points(MixedText& text, NumberType type, std::size_t count,
                       std::vector<Point>& points) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::string what =
        "a coordinate of point " + std::to_string(i + 1) + " of " + std::to_string(count);
    Point point;
    while (point.size() < 3) {
      Result<Rational> number = text.number(type, what);
      if (!number) return tl::unexpected(number.error());
      point.push_back(std::move(*number));
    }
    points.push_back(std::move(point));
  }
  return {};
}

Result<std::vector<Vertex>> read_vtk_integers(MixedText& text, NumberType type, std::size_t count,
                                              const std::string& what) {
  std::vector<Vertex> values;
  for (std::size_t i = 0; i < count; ++i) {
    const Result<Vertex> value = text.integer(type, what);
    if (!value) return tl::unexpected(value.error());
    values.push_back(*value);
  }
  return values;
}

}  // namespace circumspect::formats
