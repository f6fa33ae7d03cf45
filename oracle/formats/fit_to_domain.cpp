#include "oracle/formats/fit_to_domain.hpp"

#include <algorithm>
#include <iterator>

#include "reference/kernel/exact/number_text.hpp"

namespace circumspect::formats {

void leave_out_constant_coordinate(RawMesh& mesh) {
  std::vector<Point>& points = mesh.points.points;
  if (mesh.points.dimension != 3 || points.empty()) return;
  const Rational height = points.front()[2];
  const bool is_flat = std::all_of(points.begin(), points.end(),
                                   [&height](const Point& point) { return point[2] == height; });
  if (!is_flat) return;
  for (Point& point : points) point.pop_back();
  mesh.points.dimension = 2;
  mesh.notes.push_back(mesh.points_name + ": the third coordinate, " +
                       to_text_of_double_or_fraction(height) + " for all points, was left out");
}

void take_for_faces(RawMesh& mesh) {
  std::vector<Simplex>& simplices = mesh.simplices.simplices;
  const std::size_t size = size_of_each(simplices);
  const std::size_t dimension = mesh.points.dimension;
  if (size < 2 || size > dimension || dimension > 3) return;
  const std::string kind = size == 3 ? "triangle" : "edge";
  const bool is_one = simplices.size() == 1;
  mesh.notes.push_back(mesh.mesh_name + ": no " + (dimension == 3 ? "tetrahedra" : "triangles") +
                       "; the " + std::to_string(simplices.size()) + " " + kind +
                       (is_one ? " is judged as a dangling one" : "s are judged as dangling ones"));
  mesh.faces.insert(mesh.faces.end(), std::make_move_iterator(simplices.begin()),
                    std::make_move_iterator(simplices.end()));
  simplices.clear();
  mesh.simplices.lines.clear();
  mesh.simplices.vertices_per_simplex = 0;
}

}  // namespace circumspect::formats
