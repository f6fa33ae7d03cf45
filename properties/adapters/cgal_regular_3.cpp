#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include "properties/adapters/cgal_rows.hpp"

namespace circumspect::adapters {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex =
    CGAL::Triangulation_vertex_base_with_info_3<std::int64_t, Kernel,
                                                CGAL::Regular_triangulation_vertex_base_3<Kernel>>;
using Cell = CGAL::Regular_triangulation_cell_base_3<Kernel>;
using Structure = CGAL::Triangulation_data_structure_3<Vertex, Cell>;
using Mesh = CGAL::Regular_triangulation_3<Kernel, Structure>;

}  // namespace

SimplexArray cgal_regular_3(const PointArray& points) {
  Mesh mesh;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double* const p = points.point(i);
    const double weight = points.weights.empty() ? 0 : points.weights[i];
    const Mesh::Vertex_handle v =
        mesh.insert(Kernel::Weighted_point_3(Kernel::Point_3(p[0], p[1], p[2]), weight));
    // A submerged point has no vertex.
    if (v != Mesh::Vertex_handle()) v->info() = static_cast<std::int64_t>(i);
  }
  return rows_of(mesh);
}

}  // namespace circumspect::adapters
