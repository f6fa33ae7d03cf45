// The plane and space, with the kernel that the manual recommends.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include "lines.hpp"

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Plane = CGAL::Delaunay_triangulation_2<
    K, CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<long, K>>>;
using Space = CGAL::Delaunay_triangulation_3<
    K, CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_with_info_3<long, K>,
                                            CGAL::Delaunay_triangulation_cell_base_3<K>>>;

int main() {
  return lines::serve([](const lines::Points& points) {
    lines::Simplices made;
    std::vector<std::pair<K::Point_2, long>> flat;
    std::vector<std::pair<K::Point_3, long>> solid;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto& p = points[i];
      if (p.size() == 2)
        flat.emplace_back(K::Point_2(p[0], p[1]), i);
      else
        solid.emplace_back(K::Point_3(p[0], p[1], p[2]), i);
    }
    const Plane plane(flat.begin(), flat.end());
    for (const auto f : plane.finite_face_handles())
      made.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
    const Space space(solid.begin(), solid.end());
    for (const auto c : space.finite_cell_handles())
      made.push_back(
          {c->vertex(0)->info(), c->vertex(1)->info(), c->vertex(2)->info(), c->vertex(3)->info()});
    return made;
  });
}
