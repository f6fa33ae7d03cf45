// The plane with segments, with the kernel that the manual recommends.
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "lines.hpp"

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Plane = CGAL::Constrained_Delaunay_triangulation_2<
    K, CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<long, K>,
                                            CGAL::Constrained_triangulation_face_base_2<K>>>;

int main() {
  return lines::serve_domains([](const lines::Points& points, const lines::Segments& segments) {
    Plane plane;
    std::vector<Plane::Vertex_handle> own;
    for (std::size_t i = 0; i < points.size(); ++i) {
      own.push_back(plane.insert(K::Point_2(points[i][0], points[i][1])));
      own.back()->info() = static_cast<long>(i);
    }
    for (const auto& [a, b] : segments)
      plane.insert_constraint(own[static_cast<std::size_t>(a)], own[static_cast<std::size_t>(b)]);
    lines::Simplices made;
    for (const auto f : plane.finite_face_handles())
      made.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
    return made;
  });
}
