#include "reference/delaunay/flip.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/star_index.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/place.hpp"

namespace circumspect::delaunay {
namespace {

// The points of W by the sign of their coefficients in the affine dependence.
struct RadonPartition {
  Simplex with_apex;
  Simplex against_apex;
};

// apex = Σ_i λ_i p_i with the barycentric coordinates λ is the dependence: the apex has coefficient
// −1 and vertex i has λ_i. Where λ_i is zero, vertex i takes no part.
RadonPartition radon_partition(const PointSet& points, const Simplex& simplex, Vertex apex) {
  const std::vector<int> signs = barycentric_signs(points.configuration(), simplex, apex);
  RadonPartition parts{{apex}, {}};
  for (std::size_t place = 0; place < simplex.size(); ++place) {
    if (signs[place] < 0) parts.with_apex.push_back(simplex[place]);
    if (signs[place] > 0) parts.against_apex.push_back(simplex[place]);
  }
  return parts;
}

// The simplices on the vertices of both parts that omit one vertex of the first.
std::vector<Simplex> omitting_one_of(const Simplex& part, const Simplex& other) {
  std::vector<Simplex> simplices;
  for (std::size_t place = 0; place < part.size(); ++place) {
    simplices.push_back(join(facet_opposite(part, place), other));
  }
  std::sort(simplices.begin(), simplices.end());
  return simplices;
}

// T * Z.
std::vector<Simplex> joins(const std::vector<Simplex>& simplices, const std::set<Simplex>& others) {
  std::vector<Simplex> all;
  for (const Simplex& simplex : simplices) {
    for (const Simplex& other : others) all.push_back(join(simplex, other));
  }
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

BasicFlip basic_flip(const PointSet& points, const Simplex& simplex, Vertex apex) {
  const RadonPartition parts = radon_partition(points, simplex, apex);
  return {omitting_one_of(parts.with_apex, parts.against_apex),
          omitting_one_of(parts.against_apex, parts.with_apex)};
}

std::string ExtendedFlip::name() const {
  return std::to_string(deleted.size()) + "-" + std::to_string(created.size());
}

tl::expected<ExtendedFlip, BlockedFlip> extended_flip(const StarIndex& triangulation,
                                                      const BasicFlip& flip) {
  std::set<Simplex> z;
  for (const Simplex& simplex : flip.deleted) {
    for (Simplex& zeta : triangulation.link(simplex)) z.insert(std::move(zeta));
  }
  assert(!z.empty());
  ExtendedFlip extended{joins(flip.deleted, z), joins(flip.created, z)};
  BlockedFlip blocked;
  for (const Simplex& simplex : extended.deleted) {
    if (!triangulation.has(simplex)) blocked.missing.push_back(simplex);
  }
  if (!blocked.missing.empty()) return tl::unexpected(std::move(blocked));
  return extended;
}

BasicFlip flip_of_facet(const PointSet& points, const StarIndex& triangulation,
                        const Simplex& facet) {
  const std::vector<Simplex> sides = triangulation.star(facet);
  assert(sides.size() == 2);
  return basic_flip(points, sides[0], without(sides[1], facet).front());
}

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
