// delaunay_3 [--inexact] IN.node OUT.ele: what CGAL's 3D Delaunay triangulation makes of the
// points.
//
// CGAL's triangulation packages are under the GPL. This program only makes corpus entries; nothing
// of it is linked to, or part of, what ships.
//
// --inexact takes the kernel that CGAL's manual warns of, with plain floating-point predicates:
// what its users get who choose the wrong kernel.
#include <cstring>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include "node_and_ele.hpp"

template <class Kernel>
int triangulate(const char* in, const char* out) {
  using Vertex = CGAL::Triangulation_vertex_base_with_info_3<int, Kernel>;
  using Structure =
      CGAL::Triangulation_data_structure_3<Vertex,
                                           CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
  using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, Structure>;

  const Points input = read_node(in, 3);
  Delaunay mesh;
  int index = 0;  // in the order of the input, so that the output is reproducible
  for (const auto& p : input.coordinates)
    mesh.insert(typename Kernel::Point_3(p[0], p[1], p[2]))->info() = index++;

  const int columns = mesh.dimension() + 1;
  std::vector<std::vector<int>> simplices;
  const auto collect = [&](auto cell, int without) {
    std::vector<int> simplex;
    for (int i = 0; i < columns; ++i)
      if (i != without) simplex.push_back(cell->vertex(i)->info());
    simplices.push_back(simplex);
  };
  if (mesh.dimension() == 3)
    for (auto c : mesh.finite_cell_handles()) collect(c, -1);
  if (mesh.dimension() == 2)
    for (auto f : mesh.finite_facets()) collect(f.first, -1);
  if (mesh.dimension() == 1)
    for (auto e : mesh.finite_edges()) collect(e.first, -1);
  write_ele(out, simplices, columns, input.first_index);
  return 0;
}

int main(int argc, char** argv) {
  const bool inexact = argc == 4 && std::strcmp(argv[1], "--inexact") == 0;
  if (argc != 3 && !inexact) {
    std::cerr << "usage: delaunay_3 [--inexact] IN.node OUT.ele\n";
    return 2;
  }
  return inexact
             ? triangulate<CGAL::Simple_cartesian<double>>(argv[2], argv[3])
             : triangulate<CGAL::Exact_predicates_inexact_constructions_kernel>(argv[1], argv[2]);
}
