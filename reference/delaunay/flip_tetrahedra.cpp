#include "reference/delaunay/flip_tetrahedra.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <set>

#include "reference/predicates/orientation.hpp"

namespace circumspect::delaunay {
namespace {

// Adjacent(u, v, w): the vertex x such that uvwx is a positively oriented tetrahedron of T.
Vertex adjacent(const PointSet& points, const StarIndex& triangulation, Vertex u, Vertex v,
                Vertex w) {
  const std::vector<Simplex> sides = triangulation.link({u, v, w});
  const auto in_front = std::find_if(sides.begin(), sides.end(), [&](const Simplex& x) {
    return orientation(points.configuration(), Simplex{u, v, w, x.front()}) > 0;
  });
  assert(in_front != sides.end());
  return in_front->front();
}

// Remove the vertices in V from every simplex, yielding j-simplices.
std::set<Simplex> without_each(const std::set<Simplex>& simplices, const Simplex& vertices) {
  std::set<Simplex> faces;
  for (const Simplex& simplex : simplices) faces.insert(without(simplex, vertices));
  return faces;
}

}  // namespace

tl::expected<ExtendedFlip, BlockedFlip> flip(const PointSet& points, StarIndex& triangulation,
                                             Vertex u, Vertex v, Vertex w) {
  const Vertex x = adjacent(points, triangulation, u, v, w);
  const Vertex y = adjacent(points, triangulation, w, v, u);
  std::set<Simplex> t_d{sorted({w, v, u, y}), sorted({u, v, w, x})};
  std::set<Simplex> t_c;
  Simplex vertical;  // V: vertices that are not part of the basic flip
  for (const auto& [a, b, c] : {std::array{u, v, w}, std::array{v, w, u}, std::array{w, u, v}}) {
    const int alpha = orientation(points.configuration(), Simplex{a, b, x, y});
    if (alpha > 0) {
      t_d.insert(sorted({a, b, x, y}));
    } else if (alpha < 0) {
      t_c.insert(sorted({a, b, y, x}));
    } else {
      vertical.push_back(c);  // abxy is degenerate.
    }
  }

  // Perform a flip that replaces T_D with T_C, or finds it blocked before it changes anything.
  ExtendedFlip performed;
  BlockedFlip blocked;
  const auto delete_tetrahedron = [&](const Simplex& tetrahedron) {
    (triangulation.has(tetrahedron) ? performed.deleted : blocked.missing).push_back(tetrahedron);
  };
  if (vertical.empty()) {  // Basic flip: 2-3 flip or 3-2 flip or 4-1 flip.
    for (const Simplex& tau : t_d) delete_tetrahedron(tau);
    for (const Simplex& tau : t_c) performed.created.push_back(tau);
  } else {  // Extended flip: 2-2 flip or 4-4 flip or 3-1 flip or 6-2 flip or edge merge.
    t_d = without_each(t_d, vertical);
    t_c = without_each(t_c, vertical);
    // The book says "a j-simplex in T_D"; it must be one that is a face of T.
    const Simplex sigma = without({u, v, w, x}, vertical);
    for (const Simplex& zeta : triangulation.link(sigma)) {
      for (const Simplex& tau : t_d) delete_tetrahedron(join(tau, zeta));
      for (const Simplex& tau : t_c) performed.created.push_back(join(tau, zeta));
    }
  }
  if (!blocked.missing.empty()) return tl::unexpected(std::move(blocked));
  std::sort(performed.deleted.begin(), performed.deleted.end());
  std::sort(performed.created.begin(), performed.created.end());
  triangulation.replace(performed.deleted, performed.created);
  return performed;
}

}  // namespace circumspect::delaunay
