#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "properties/adapters/adapters.hpp"

namespace circumspect::adapters {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::int64_t, Kernel>;
using Plain = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>>;
using Face = CGAL::Constrained_triangulation_face_base_2<Kernel>;
// With the tag that is the default: segments may repeat, touch and overlap as long as no new point
// is needed.
using Constrained =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel,
                                               CGAL::Triangulation_data_structure_2<Vertex, Face>>;

template <class Mesh>
std::vector<typename Mesh::Vertex_handle> insert(Mesh& mesh, const PointArray& points) {
  std::vector<typename Mesh::Vertex_handle> vertices;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double* const p = points.point(i);
    const std::size_t before = mesh.number_of_vertices();
    vertices.push_back(mesh.insert(Kernel::Point_2(p[0], p[1])));
    if (mesh.number_of_vertices() > before) vertices.back()->info() = static_cast<std::int64_t>(i);
  }
  return vertices;
}

template <class Mesh>
std::vector<std::int64_t> edge_of(const Mesh& mesh, typename Mesh::Face_handle face, int place) {
  return {face->vertex(mesh.cw(place))->info(), face->vertex(mesh.ccw(place))->info()};
}

template <class Mesh>
SimplexArray rows_of(const Mesh& mesh) {
  SimplexArray rows;
  if (mesh.dimension() == 2) {
    for (const auto& f : mesh.finite_face_handles()) {
      rows.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
    }
  } else if (mesh.dimension() == 1) {
    for (const auto& [face, place] : mesh.finite_edges()) {
      rows.push_back(edge_of(mesh, face, place));
    }
  } else if (mesh.dimension() == 0) {
    rows.push_back({mesh.finite_vertices_begin()->info()});
  }
  return rows;
}

}  // namespace

SimplexArray cgal_delaunay_2(const PointArray& points) {
  Plain mesh;
  insert(mesh, points);
  return rows_of(mesh);
}

SimplexArray cgal_constrained_2(const PointArray& points, const Segments& segments) {
  Constrained mesh;
  const auto vertices = insert(mesh, points);
  for (const auto& [a, b] : segments) {
    mesh.insert_constraint(vertices.at(static_cast<std::size_t>(a)),
                           vertices.at(static_cast<std::size_t>(b)));
  }
  if (mesh.dimension() == 2) return rows_of(mesh);
  SimplexArray rows;
  if (mesh.dimension() == 1) {
    for (const auto& [face, place] : mesh.finite_edges()) {
      if (face->is_constrained(place)) rows.push_back(edge_of(mesh, face, place));
    }
  }
  return rows;
}

}  // namespace circumspect::adapters
