#include "reference/delaunay/flip.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <set>
#include <stdexcept>
#include <utility>

#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/perturbation.hpp"

namespace circumspect::delaunay {

namespace {

// The points of W by the sign of their coefficients in the affine dependence.
struct RadonPartition {
  Simplex with_apex;
  Simplex against_apex;
};

// apex = Σ_i λ_i p_i with the barycentric coordinates λ is the dependence: the apex has coefficient
// −1 and vertex i has λ_i, whose sign is the orientation with the apex in that vertex's stead over
// the simplex's own. Where λ_i is zero, vertex i takes no part.
RadonPartition radon_partition(const PointSet& points, const Simplex& simplex, Vertex apex) {
  const int own = orientation(points.configuration(), simplex);
  assert(own != 0);
  RadonPartition parts{{apex}, {}};
  for (std::size_t place = 0; place < simplex.size(); ++place) {
    const int coefficient =
        own * orientation(points.configuration(), with_vertex_replaced(simplex, place, apex));
    if (coefficient < 0) parts.with_apex.push_back(simplex[place]);
    if (coefficient > 0) parts.against_apex.push_back(simplex[place]);
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

// ---- Flip algorithm ----

bool is_locally_delaunay(const PointSet& points, const StarIndex& triangulation,
                         const Simplex& facet, FlipTest test) {
  const std::vector<Simplex> sides = triangulation.star(facet);
  if (sides.size() < 2) return true;
  const Vertex apex = without(sides[1], facet).front();
  const Configuration& configuration = points.configuration();
  return test == FlipTest::kPerturbed ? perturbed_in_ball(configuration, sides[0], apex) < 0
                                      : in_ball(configuration, sides[0], apex) <= 0;
}

FlipRun flip_until_done(const PointSet& points, StarIndex& triangulation,
                        std::vector<Simplex> facets, FlipTest test, const FlipWatch& watch) {
  FlipRun run;
  while (!facets.empty()) {
    const Simplex facet = facets.back();
    facets.pop_back();
    // A facet that a flip has removed meanwhile has no star.
    if (is_locally_delaunay(points, triangulation, facet, test)) continue;
    auto flip = extended_flip(triangulation, flip_of_facet(points, triangulation, facet));
    if (!flip) {
      run.blocked.push_back({facet, std::move(flip.error().missing)});
      continue;
    }
    triangulation.replace(flip->deleted, flip->created);
    if (watch) watch({*flip, {}, facet});
    ++run.flips;
    // The flip may have created simplices whose lack blocked others: look at those again, after the
    // facets of the new simplices.
    for (BlockedFacet& blocked : run.blocked) facets.push_back(std::move(blocked.facet));
    run.blocked.clear();
    for (Simplex& changed : facets_of(flip->created)) facets.push_back(std::move(changed));
  }
  std::sort(run.blocked.begin(), run.blocked.end(),
            [](const BlockedFacet& a, const BlockedFacet& b) { return a.facet < b.facet; });
  // A facet may have been pushed by the simplices on both of its sides.
  run.blocked.erase(
      std::unique(run.blocked.begin(), run.blocked.end(),
                  [](const BlockedFacet& a, const BlockedFacet& b) { return a.facet == b.facet; }),
      run.blocked.end());
  return run;
}

FlippedTriangulation flip_algorithm(const PointSet& points, const Triangulation& start,
                                    FlipTest test) {
  StarIndex triangulation(start.simplices());
  FlipRun run = flip_until_done(points, triangulation, facets_of(start.simplices()), test);
  return {triangulation.triangulation(start.dimension()), std::move(run)};
}

Integer most_flips(std::size_t n, std::size_t d) {
  Integer binomial = 1;
  Integer sum = 0;
  for (std::size_t i = 1; i <= 1 + d / 2 && i <= n; ++i) {
    binomial = binomial * Integer(n - i + 1) / Integer(i);
    sum += binomial;
  }
  return 2 * sum;
}

// ---- Flip insertion ----

namespace {

// On which side of the facet opposite a vertex does u lie? 1: the vertex's side; −1: beyond the
// facet; 0: on it. The sign of the barycentric coordinate of u at that vertex.
int side_of_facet(const PointSet& points, const Simplex& simplex, std::size_t place, Vertex u) {
  return orientation(points.configuration(), simplex) *
         orientation(points.configuration(), with_vertex_replaced(simplex, place, u));
}

// The face of the simplex whose relative interior holds u; nothing if u is outside the simplex.
std::optional<Simplex> face_holding(const PointSet& points, const Simplex& simplex, Vertex u) {
  Simplex face;
  for (std::size_t place = 0; place < simplex.size(); ++place) {
    const int side = side_of_facet(points, simplex, place, u);
    if (side < 0) return std::nullopt;
    if (side > 0) face.push_back(simplex[place]);
  }
  return face;
}

// Does u⁺ lie below the lifted simplex? The answer is the same for every simplex that holds u.
bool lies_below(const PointSet& points, const Simplex& simplex, Vertex u, FlipTest test) {
  const Configuration& configuration = points.configuration();
  return (test == FlipTest::kPerturbed ? perturbed_in_ball(configuration, simplex, u)
                                       : in_ball(configuration, simplex, u)) > 0;
}

// The joins of u with the hull facets that have u strictly on their outer side.
std::vector<Simplex> cone_over_visible_hull_facets(const PointSet& points,
                                                   const StarIndex& triangulation, Vertex u) {
  std::vector<Simplex> cone;
  for (const Simplex& simplex : triangulation.simplices()) {
    for (std::size_t place = 0; place < simplex.size(); ++place) {
      if (side_of_facet(points, simplex, place, u) >= 0) continue;
      const Simplex facet = facet_opposite(simplex, place);
      if (triangulation.star(facet).size() == 1) cone.push_back(join(facet, {u}));
    }
  }
  return cone;
}

}  // namespace

VertexInsertion insert_vertex_by_flips(const PointSet& points, StarIndex& triangulation, Vertex u,
                                       FlipTest test, const FlipWatch& watch) {
  VertexInsertion insertion;
  ExtendedFlip split;
  for (const Simplex& simplex : triangulation.simplices()) {
    const std::optional<Simplex> face = face_holding(points, simplex, u);
    if (!face) continue;
    insertion.dimension_of_face = face->size() - 1;
    insertion.is_submerged = !lies_below(points, simplex, u, test);
    if (insertion.is_submerged) return insertion;
    split = extended_flip(triangulation, basic_flip(points, simplex, u)).value();
    break;
  }
  if (!insertion.dimension_of_face) {
    split.created = cone_over_visible_hull_facets(points, triangulation, u);
  }
  triangulation.replace(split.deleted, split.created);
  if (watch) watch({split, u, {}});
  insertion.run = flip_until_done(points, triangulation, facets_of(split.created), test, watch);
  return insertion;
}

Triangulation flip_insertion(const PointSet& points, const FlipWatch& watch) {
  const int k = points.dimension();
  if (points.empty()) return Triangulation(k, {});
  Simplex first;
  for (const std::size_t v : points.configuration().hull().basis) {
    first.push_back(static_cast<Vertex>(v));
  }
  StarIndex triangulation({first});
  const ExtendedFlip start{{}, {first}};
  if (watch) watch({start, {}, {}});
  for (Vertex u = 0; points.names(u); ++u) {
    if (contains(first, u)) continue;
    if (insert_vertex_by_flips(points, triangulation, u, FlipTest::kPerturbed, watch)
            .run.is_stuck()) {
      throw std::logic_error("flip_insertion: stuck, which is impossible");
    }
  }
  return triangulation.triangulation(k);
}

}  // namespace circumspect::delaunay
