#include "reference/delaunay/vertex_deletion.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/triangulation.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/place.hpp"
#include "reference/delaunay/dictionary.hpp"
#include "reference/delaunay/gift_wrapping.hpp"
#include "reference/delaunay/unfinished_facets.hpp"

namespace circumspect::delaunay {
namespace {

using Axes = std::vector<std::size_t>;

// The part of the triangulation that deleting v removes.
struct Star {
  std::vector<Simplex> simplices;  // positively oriented
  UnfinishedFacets link;           // its facets, v in front
  std::vector<Vertex> candidates;  // vertices of the link, then submerged points within
};

Star star_of(const PointSet& points, const Axes& axes, const std::vector<Simplex>& simplices,
             Vertex v, const std::vector<Vertex>& submerged) {
  Star star;
  std::set<Vertex> link_vertices;
  for (const Simplex& simplex : simplices) {
    if (!contains(simplex, v)) continue;
    star.simplices.push_back(positively_oriented(points, axes, simplex));
    const Simplex& last = star.simplices.back();
    const auto place =
        static_cast<std::size_t>(std::find(last.begin(), last.end(), v) - last.begin());
    star.link.add(OrientedFacet::opposite(last, place));
    for (const Vertex u : last) {
      if (u != v) link_vertices.insert(u);
    }
  }
  star.candidates.assign(link_vertices.begin(), link_vertices.end());
  for (const Vertex q : submerged) {
    const bool within = std::any_of(
        star.simplices.begin(), star.simplices.end(),
        [&](const Simplex& simplex) { return lies_in(points.configuration(), axes, simplex, q); });
    if (within) star.candidates.push_back(q);
  }
  return star;
}

// All points of the set but v.
std::vector<Vertex> remaining_points(const Triangulation& triangulation, Vertex v,
                                     const std::vector<Vertex>& submerged) {
  std::set<Vertex> remaining(submerged.begin(), submerged.end());
  for (const Simplex& simplex : triangulation.simplices()) {
    remaining.insert(simplex.begin(), simplex.end());
  }
  remaining.erase(v);
  return {remaining.begin(), remaining.end()};
}

}  // namespace

Triangulation delete_vertex(const PointSet& points, const Triangulation& triangulation, Vertex v,
                            const std::vector<Vertex>& submerged) {
  const int k = triangulation.dimension();
  const std::vector<Vertex> remaining = remaining_points(triangulation, v, submerged);
  if (remaining.empty()) return Triangulation(-1, {});
  const Axes axes = flat_through(points, triangulation.simplices().front()).axes;
  const Star star = star_of(points, axes, triangulation.simplices(), v, submerged);
  std::vector<Simplex> simplices;
  if (static_cast<int>(flat_through(points, remaining).dimension()) < k) {
    // The triangulation is the cone of v over the triangulation of a facet of the hull.
    for (const OrientedFacet& facet : star.link.all()) simplices.push_back(facet.vertices);
    return Triangulation(k - 1, std::move(simplices));
  }
  simplices = gift_wrap(points, axes, star.link, star.candidates);
  for (const Simplex& simplex : triangulation.simplices()) {
    if (!contains(simplex, v)) simplices.push_back(simplex);
  }
  return Triangulation(k, std::move(simplices));
}

}  // namespace circumspect::delaunay
