// CGAL's Delaunay triangulations of points in the plane and in space, as rows of indices.
#include <algorithm>
#include <utility>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include "properties/adapters/adapters.hpp"

namespace circumspect::adapters {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

using PlaneVertex = CGAL::Triangulation_vertex_base_with_info_2<std::int64_t, Kernel>;
using PlaneDelaunay =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<PlaneVertex>>;
using PlaneFace = CGAL::Constrained_triangulation_face_base_2<Kernel>;
// With the tag that is the default: segments may repeat, touch and overlap as long as no new point
// is needed.
using PlaneConstrained = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<PlaneVertex, PlaneFace>>;

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
SimplexArray rows_in_plane(const Mesh& mesh) {
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
  PlaneDelaunay mesh;
  insert(mesh, points);
  return rows_in_plane(mesh);
}

SimplexArray cgal_constrained_2(const PointArray& points, const Segments& segments) {
  PlaneConstrained mesh;
  const auto vertices = insert(mesh, points);
  for (const auto& [a, b] : segments) {
    mesh.insert_constraint(vertices.at(static_cast<std::size_t>(a)),
                           vertices.at(static_cast<std::size_t>(b)));
  }
  if (mesh.dimension() == 2) return rows_in_plane(mesh);
  SimplexArray rows;
  if (mesh.dimension() == 1) {
    for (const auto& [face, place] : mesh.finite_edges()) {
      if (face->is_constrained(place)) rows.push_back(edge_of(mesh, face, place));
    }
  }
  return rows;
}

namespace {

using SpaceVertex = CGAL::Triangulation_vertex_base_with_info_3<std::int64_t, Kernel>;
using SpaceDelaunay = CGAL::Delaunay_triangulation_3<
    Kernel, CGAL::Triangulation_data_structure_3<SpaceVertex,
                                                 CGAL::Delaunay_triangulation_cell_base_3<Kernel>>>;
using RegularVertex =
    CGAL::Triangulation_vertex_base_with_info_3<std::int64_t, Kernel,
                                                CGAL::Regular_triangulation_vertex_base_3<Kernel>>;
using SpaceRegular = CGAL::Regular_triangulation_3<
    Kernel, CGAL::Triangulation_data_structure_3<RegularVertex,
                                                 CGAL::Regular_triangulation_cell_base_3<Kernel>>>;

// Requires: info() of a vertex is the index of its point.
template <class Triangulation>
SimplexArray rows_in_space(const Triangulation& mesh) {
  SimplexArray rows;
  const auto add = [&](const auto& cell, std::initializer_list<int> places) {
    rows.emplace_back();
    for (const int place : places) rows.back().push_back(cell->vertex(place)->info());
  };
  switch (mesh.dimension()) {
    case 3:
      for (const auto& cell : mesh.finite_cell_handles()) add(cell, {0, 1, 2, 3});
      break;
    case 2:
      for (const auto& facet : mesh.finite_facets()) add(facet.first, {0, 1, 2});
      break;
    case 1:
      for (const auto& edge : mesh.finite_edges()) add(edge.first, {edge.second, edge.third});
      break;
    case 0:
      rows.push_back({mesh.finite_vertices_begin()->info()});
      break;
    default:
      break;
  }
  return rows;
}

}  // namespace

SimplexArray cgal_delaunay_3(const PointArray& points) {
  SpaceDelaunay mesh;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double* const p = points.point(i);
    const std::size_t before = mesh.number_of_vertices();
    const SpaceDelaunay::Vertex_handle v = mesh.insert(Kernel::Point_3(p[0], p[1], p[2]));
    if (mesh.number_of_vertices() > before) v->info() = static_cast<std::int64_t>(i);
  }
  return rows_in_space(mesh);
}

SimplexArray cgal_regular_3(const PointArray& points) {
  SpaceRegular mesh;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double* const p = points.point(i);
    const double weight = points.weights.empty() ? 0 : points.weights[i];
    const SpaceRegular::Vertex_handle v =
        mesh.insert(Kernel::Weighted_point_3(Kernel::Point_3(p[0], p[1], p[2]), weight));
    // A submerged point has no vertex.
    if (v != SpaceRegular::Vertex_handle()) v->info() = static_cast<std::int64_t>(i);
  }
  return rows_in_space(mesh);
}

}  // namespace circumspect::adapters
