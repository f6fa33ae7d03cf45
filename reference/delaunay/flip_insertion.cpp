#include "reference/delaunay/flip_insertion.hpp"

#include <optional>
#include <stdexcept>
#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/star_index.hpp"
#include "kernel/complex/triangulation.hpp"
#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/perturbation.hpp"
#include "kernel/predicates/place.hpp"
#include "reference/delaunay/flip.hpp"
#include "reference/delaunay/flip_algorithm.hpp"

namespace circumspect::delaunay {
namespace {

// The face of the simplex whose relative interior holds u; nothing if u is outside the simplex.
std::optional<Simplex> face_holding(const PointSet& points, const Simplex& simplex, Vertex u) {
  Simplex face;
  const std::vector<int> signs = barycentric_signs(points.configuration(), simplex, u);
  for (std::size_t place = 0; place < simplex.size(); ++place) {
    if (signs[place] < 0) return std::nullopt;
    if (signs[place] > 0) face.push_back(simplex[place]);
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
    const std::vector<int> signs = barycentric_signs(points.configuration(), simplex, u);
    for (std::size_t place = 0; place < simplex.size(); ++place) {
      if (signs[place] >= 0) continue;
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
