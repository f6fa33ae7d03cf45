#include <stdexcept>

#include <gts.h>

#include "lines.hpp"

int main() {
  return lines::serve([](const lines::Points& points) {
    GSList* vertices = nullptr;
    for (const auto& p : points)
      vertices = g_slist_append(vertices, gts_vertex_new(gts_vertex_class(), p[0], p[1], 0.0));
    GtsTriangle* around = gts_triangle_enclosing(gts_triangle_class(), vertices, 100.0);
    GtsSurface* surface = gts_surface_new(gts_surface_class(), gts_face_class(), gts_edge_class(),
                                          gts_vertex_class());
    gts_surface_add_face(surface,
                         gts_face_new(gts_face_class(), around->e1, around->e2, around->e3));
    for (GSList* v = vertices; v != nullptr; v = v->next) {
      GtsVertex* left = gts_delaunay_add_vertex(surface, static_cast<GtsVertex*>(v->data), nullptr);
      if (left != nullptr) throw std::runtime_error("gts_delaunay_add_vertex returns a vertex");
    }
    std::pair<lines::Indices, lines::Simplices> made(lines::Indices(points), {});
    gts_surface_foreach_face(
        surface,
        [](gpointer face, gpointer data) -> gint {
          auto& [index, simplices] =
              *static_cast<std::pair<lines::Indices, lines::Simplices>*>(data);
          GtsVertex* v[3];
          gts_triangle_vertices(GTS_TRIANGLE(face), v, v + 1, v + 2);
          std::vector<long> simplex;
          for (auto* one : v) simplex.push_back(index({GTS_POINT(one)->x, GTS_POINT(one)->y}));
          if (simplex[0] >= 0 && simplex[1] >= 0 && simplex[2] >= 0) simplices.push_back(simplex);
          return 0;
        },
        &made);
    return made.second;
  });
}
