// igl::delaunay_triangulation, with the exact predicates of CGAL as the functors that it asks for.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <igl/delaunay_triangulation.h>

#include "lines.hpp"

using K = CGAL::Exact_predicates_inexact_constructions_kernel;

int main() {
  return lines::serve([](const lines::Points& points) {
    Eigen::MatrixXd vertices(points.size(), 2);
    for (std::size_t i = 0; i < points.size(); ++i) vertices.row(i) << points[i][0], points[i][1];
    const auto at = [](const double* p) { return K::Point_2(p[0], p[1]); };
    Eigen::MatrixXi faces;
    igl::delaunay_triangulation(
        vertices,
        [&](const double* a, const double* b, const double* c) {
          return int(CGAL::orientation(at(a), at(b), at(c)));
        },
        [&](const double* a, const double* b, const double* c, const double* d) {
          return int(CGAL::side_of_oriented_circle(at(a), at(b), at(c), at(d)));
        },
        faces);
    lines::Simplices made;
    for (int i = 0; i < faces.rows(); ++i) made.push_back({faces(i, 0), faces(i, 1), faces(i, 2)});
    return made;
  });
}
