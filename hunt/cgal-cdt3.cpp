// Surfaces in space, each polygon of one outline a face, with the kernel that the manual
// recommends.
#include <iomanip>
#include <iostream>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/make_conforming_constrained_Delaunay_triangulation_3.h>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;

int main() {
  std::cout << std::setprecision(17);
  std::size_t n = 0, d = 0, w = 0, s = 0, f = 0, h = 0, lines = 0, seeds = 0, corners = 0;
  while (std::cin >> n >> d >> w >> s >> f >> h) {
    std::vector<K::Point_3> points(n);
    for (auto& p : points) std::cin >> p;
    bool is_taken = s == 0 && h == 0;
    for (std::size_t end = 0; s > 0 && std::cin >> end >> end; --s) {
    }
    std::vector<std::vector<std::size_t>> faces(f);
    for (auto& face : faces) {
      std::cin >> lines >> seeds;
      is_taken = is_taken && lines == 1 && seeds == 0;
      for (; lines > 0 && std::cin >> corners; --lines) {
        face.resize(corners);
        for (auto& v : face) std::cin >> v;
      }
      for (K::Point_3 seed; seeds > 0 && std::cin >> seed; --seeds) {
      }
    }
    for (K::Point_3 hole; h > 0 && std::cin >> hole; --h) {
    }
    if (!is_taken) {
      std::cout << "error its function takes polygons of one outline" << std::endl;
      continue;
    }
    const auto made =
        CGAL::make_conforming_constrained_Delaunay_triangulation_3(points, faces).triangulation();
    if (made.number_of_vertices() > n) {
      std::cout << "error it has Steiner points, which are rounded" << std::endl;
      continue;
    }
    std::map<K::Point_3, std::size_t> place;
    std::cout << made.number_of_vertices() << " vertices\n"
              << made.number_of_finite_cells() << " tets\n";
    for (const auto v : made.finite_vertex_handles()) {
      std::cout << v->point() << '\n';
      place.emplace(v->point(), place.size());
    }
    for (const auto c : made.finite_cell_handles()) {
      std::cout << '4';
      for (int i = 0; i < 4; ++i) std::cout << ' ' << place.at(c->vertex(i)->point());
      std::cout << '\n';
    }
    std::cout.flush();
  }
}
