#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include "properties/adapters/cgal_rows.hpp"

namespace circumspect::adapters {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_3<std::int64_t, Kernel>;
using Cell = CGAL::Delaunay_triangulation_cell_base_3<Kernel>;
using Structure = CGAL::Triangulation_data_structure_3<Vertex, Cell>;
using Mesh = CGAL::Delaunay_triangulation_3<Kernel, Structure>;

}  // namespace

SimplexArray cgal_delaunay_3(const PointArray& points) {
  Mesh mesh;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double* const p = points.point(i);
    const std::size_t before = mesh.number_of_vertices();
    const Mesh::Vertex_handle v = mesh.insert(Kernel::Point_3(p[0], p[1], p[2]));
    if (mesh.number_of_vertices() > before) v->info() = static_cast<std::int64_t>(i);
  }
  return rows_of(mesh);
}

}  // namespace circumspect::adapters
