// delaunay_2 [--inexact] IN.node OUT.ele: what CGAL's planar Delaunay triangulation makes of the
// points.
//
// CGAL's triangulation packages are under the GPL. This program only makes corpus entries; nothing
// of it is linked to, or part of, what ships. For --inexact see delaunay_3.cpp.
#include <cstring>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "node_and_ele.hpp"

template <class Kernel>
int triangulate(const char* in, const char* out) {
  using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
  using Structure = CGAL::Triangulation_data_structure_2<Vertex>;
  using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, Structure>;

  const Points input = read_node(in, 2);
  Delaunay mesh;
  int index = 0;  // in the order of the input, so that the output is reproducible
  for (const auto& p : input.coordinates)
    mesh.insert(typename Kernel::Point_2(p[0], p[1]))->info() = index++;

  std::vector<std::vector<int>> simplices;
  for (auto f : mesh.finite_face_handles())
    simplices.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  write_ele(out, simplices, 3, input.first_index);
  return 0;
}

int main(int argc, char** argv) {
  const bool inexact = argc == 4 && std::strcmp(argv[1], "--inexact") == 0;
  if (argc != 3 && !inexact) {
    std::cerr << "usage: delaunay_2 [--inexact] IN.node OUT.ele\n";
    return 2;
  }
  return inexact
             ? triangulate<CGAL::Simple_cartesian<double>>(argv[2], argv[3])
             : triangulate<CGAL::Exact_predicates_inexact_constructions_kernel>(argv[1], argv[2]);
}
