#include "kernel/complex/polytope.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <set>
#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/predicates/orientation.hpp"

namespace circumspect {
namespace {

using Axes = std::vector<std::size_t>;

// On which side of the hyperplane through `basis` is q? Zero on it.
int side(const PointSet& points, const Axes& axes, const Simplex& basis, Vertex q) {
  return side_of_facet(points.configuration(), axes, basis, q);
}

// All members on the hyperplane through `basis`.
Face members_on(const PointSet& points, const Axes& axes, const Simplex& basis,
                const std::vector<Vertex>& members) {
  Face on_it;
  for (const Vertex q : members) {
    if (side(points, axes, basis, q) == 0) on_it.push_back(q);
  }
  return on_it;
}

Simplex joined(Simplex simplex, Vertex v) {
  simplex.push_back(v);
  return simplex;
}

// All facets of a simplex: each leaves out one vertex.
std::vector<Face> facets_of_simplex(const Face& simplex) {
  std::vector<Face> facets;
  if (simplex.size() == 1) return facets;
  for (std::size_t place = simplex.size(); place > 0; --place) {
    facets.push_back(facet_opposite(simplex, place - 1));
  }
  return facets;
}

// The facet of the polytope that shares the ridge with a given facet: of the hyperplanes through
// the ridge and one more point, the last that a plane turning about the ridge meets.
Face wrap(const PointSet& points, const Axes& axes, const Face& polytope, const Face& facet,
          const Face& ridge) {
  const Simplex hinge = flat_through(points, ridge).basis;
  const Vertex inner =
      *std::find_if(facet.begin(), facet.end(), [&](Vertex v) { return !contains(ridge, v); });
  Simplex hyperplane;
  int inner_side = 0;
  for (const Vertex q : polytope) {
    if (std::binary_search(facet.begin(), facet.end(), q)) continue;
    if (!hyperplane.empty() && side(points, axes, hyperplane, q) != -inner_side) continue;
    hyperplane = joined(hinge, q);
    inner_side = side(points, axes, hyperplane, inner);
  }
  return members_on(points, axes, hyperplane, polytope);
}

// The two ends of a segment.
std::vector<Face> ends(const PointSet& points, const Face& segment) {
  const auto [first, last] = std::minmax_element(
      segment.begin(), segment.end(), [&](Vertex a, Vertex b) { return points[a] < points[b]; });
  std::vector<Face> both = {{*first}, {*last}};
  std::sort(both.begin(), both.end());
  return both;
}

}  // namespace

std::vector<Face> facets_by_definition(const PointSet& points, const Face& polytope) {
  const Flat flat = flat_through(points, polytope);
  std::set<Face> facets;
  if (flat.dimension() == 0) return {};
  Simplex subset = first_subset(flat.dimension());
  do {
    Simplex hyperplane;
    for (const Vertex i : subset) hyperplane.push_back(polytope[static_cast<std::size_t>(i)]);
    std::set<int> sides;
    for (const Vertex q : polytope) sides.insert(side(points, flat.axes, hyperplane, q));
    const bool supports = sides.size() == 2;  // zero, and one other sign
    if (supports) facets.insert(members_on(points, flat.axes, hyperplane, polytope));
  } while (next_subset(subset, polytope.size()));
  return {facets.begin(), facets.end()};
}

std::vector<Face> facets_by_wrapping(const PointSet& points, const Face& polytope) {
  const Flat flat = flat_through(points, polytope);
  if (polytope.size() == flat.dimension() + 1) return facets_of_simplex(polytope);
  if (flat.dimension() == 1) return ends(points, polytope);
  std::set<Face> facets;
  std::map<Face, Face> open_ridges;  // with the one facet that is known to have it
  const auto add = [&](const Face& facet) {
    const bool is_new = facets.insert(facet).second;
    assert(is_new);
    for (const Face& ridge : facets_by_wrapping(points, facet)) {
      if (open_ridges.erase(ridge) == 0) open_ridges.emplace(ridge, facet);
    }
  };
  add(some_facet(points, flat.axes, polytope));
  while (!open_ridges.empty()) {
    const auto [ridge, facet] = *open_ridges.begin();
    add(wrap(points, flat.axes, polytope, facet, ridge));
  }
  return {facets.begin(), facets.end()};
}

Face some_facet(const PointSet& points, const std::vector<std::size_t>& axes,
                const std::vector<Vertex>& members) {
  assert(!axes.empty());
  const auto& configuration = points.configuration();
  if (axes.size() == 1) {
    const Vertex least = *std::min_element(members.begin(), members.end(), [&](Vertex a, Vertex b) {
      return points[a][axes[0]] < points[b][axes[0]];
    });
    return members_on(points, axes, {least}, members);
  }
  const Axes base(axes.begin(), axes.end() - 1);
  const Face touched = some_facet(points, base, members);
  const Flat flat = flat_through(points, axes, touched);
  if (flat.dimension() + 1 == axes.size()) return touched;
  // The vertical hyperplane touches a ridge only. Turn it until all points are on or above it.
  Simplex lowest;
  for (const Vertex q : members) {
    if (contains(touched, q)) continue;
    const bool below = !lowest.empty() &&
                       side(points, axes, lowest, q) * orientation(configuration, base, lowest) > 0;
    if (lowest.empty() || below) lowest = joined(flat.basis, q);
  }
  return members_on(points, axes, lowest, members);
}

}  // namespace circumspect
