#include "oracle/formats/fit_to_domain.hpp"

#include <algorithm>
#include <iterator>

#include "reference/kernel/exact/number_text.hpp"

namespace circumspect::formats {
namespace {

// Points in space without their third coordinate, or none if it differs.
template <class Value>
std::optional<Rows<Value>> in_plane(const Rows<Value>& points) {
  for (std::size_t i = 1; i < points.rows(); ++i) {
    if (points.row(i)[2] != points.row(0)[2]) return std::nullopt;
  }
  Rows<Value> plane(points.rows(), 2);
  for (std::size_t i = 0; i < points.rows(); ++i) {
    std::copy_n(points.row(i).begin(), 2, plane.row(i).begin());
  }
  return plane;
}

}  // namespace

void leave_out_constant_coordinate(MeshFile& file) {
  Mesh& mesh = file.mesh;
  if (mesh.dimension() != 3 || mesh.points() == 0) return;
  const Rational height = mesh.point(0)[2];
  std::optional<Numbers> plane =
      std::visit([](const auto& points) -> std::optional<Numbers> { return in_plane(points); },
                 mesh.coordinates);
  if (!plane) return;
  mesh.coordinates = std::move(*plane);
  file.notes.push_back(file.points_name + ": the third coordinate, " +
                       to_text_of_double_or_fraction(height) + " for all points, was left out");
}

void take_for_faces(MeshFile& file) {
  Mesh& mesh = file.mesh;
  const std::size_t size = mesh.simplices.columns();
  const std::size_t dimension = mesh.dimension();
  if (size < 2 || size > dimension || dimension > 3) return;
  const std::string kind = size == 3 ? "triangle" : "edge";
  const std::size_t count = mesh.simplices.size();
  file.notes.push_back(
      file.mesh_name + ": no " + (dimension == 3 ? "tetrahedra" : "triangles") + "; the " +
      std::to_string(count) + " " + kind +
      (count == 1 ? " is judged as a dangling one" : "s are judged as dangling ones"));
  std::vector<Simplex> faces = mesh.simplices.lists();
  mesh.faces.insert(mesh.faces.end(), std::make_move_iterator(faces.begin()),
                    std::make_move_iterator(faces.end()));
  mesh.simplices = {};
}

}  // namespace circumspect::formats
