#include "reference/constrained/evolving_cdt.hpp"

#include <cassert>

#include "kernel/predicates/orientation.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/flip_algorithm.hpp"

namespace circumspect::constrained {
namespace {

bool is_absent(const EvolvingCdt& cdt, const Simplex& face) {
  return cdt.tetrahedra.star(face).empty();
}

std::optional<NoChange> why_no_cdt(const PointSet& points, const EvolvingCdt& cdt,
                                   const Change& change) {
  std::set<Simplex> edges = edges_of(change.deleted);
  edges.insert(change.segments_added.begin(), change.segments_added.end());
  for (const Simplex& edge : edges) {
    if (cdt.segments.contains(edge) && is_absent(cdt, edge)) {
      return NoChange{WhyNoChange::kSegmentLost, edge};
    }
  }
  std::vector<Simplex> facets = facets_of(change.deleted);
  facets.insert(facets.end(), change.walls_added.begin(), change.walls_added.end());
  for (const Simplex& facet : facets) {
    // Walls bound cavities, or lie inside them with both sides; for flips, see FlipInsertPolygon.
    assert(!cdt.walls.contains(facet) || !is_absent(cdt, facet));
  }
  const auto bad =
      facet_not_locally_delaunay(points, cdt.tetrahedra, facets_of(change.created), cdt.walls);
  if (bad) return NoChange{WhyNoChange::kNotLocallyDelaunay, *bad};
  return std::nullopt;
}

void exchange(std::set<Simplex>& set, const std::set<Simplex>& out, const std::set<Simplex>& in) {
  for (const Simplex& simplex : out) set.erase(simplex);
  set.insert(in.begin(), in.end());
}

}  // namespace

EvolvingCdt evolving_delaunay(const PointSet& points, const Progress& progress) {
  assert(points.dimension() == 3);
  delaunay::BowyerWatsonOptions options;
  options.order = delaunay::InsertionOrder::kBrioHilbert;
  options.location = delaunay::PointLocation::kWalking;
  options.progress = progress;
  return {StarIndex(delaunay::bowyer_watson(points, options).simplices()), {}, {}};
}

std::optional<NoChange> try_change(const PointSet& points, EvolvingCdt& cdt, const Change& change) {
  cdt.tetrahedra.replace(change.deleted, change.created);
  exchange(cdt.walls, change.walls_removed, change.walls_added);
  exchange(cdt.segments, change.segments_removed, change.segments_added);
  std::optional<NoChange> wrong = why_no_cdt(points, cdt, change);
  if (wrong) {
    cdt.tetrahedra.replace(change.created, change.deleted);
    exchange(cdt.walls, change.walls_added, change.walls_removed);
    exchange(cdt.segments, change.segments_added, change.segments_removed);
  }
  return wrong;
}

std::optional<Simplex> facet_not_locally_delaunay(const PointSet& points,
                                                  const StarIndex& simplices,
                                                  const std::vector<Simplex>& facets,
                                                  const std::set<Simplex>& walls) {
  for (const Simplex& facet : facets) {
    if (walls.contains(facet)) continue;
    if (!delaunay::is_locally_delaunay(points, simplices, facet, delaunay::FlipTest::kPerturbed)) {
      return facet;
    }
  }
  return std::nullopt;
}

bool is_on_hull(const PointSet& points, const EvolvingCdt& cdt, const Simplex& facet) {
  const std::vector<Simplex> star = cdt.tetrahedra.star(facet);
  if (star.size() != 1) return false;
  const auto side = [&](Vertex v) {
    return orientation(points.configuration(), Simplex{facet[0], facet[1], facet[2], v});
  };
  const int inner = side(without(star.front(), facet).front());
  for (Vertex v = 0; points.names(v); ++v) {
    const bool is_beyond = !contains(facet, v) && side(v) == -inner;
    assert(!is_beyond || cdt.tetrahedra.star({v}).empty());  // The CDT fills a convex hull.
  }
  return true;
}

std::set<Simplex> edges_of(const std::vector<Simplex>& simplices) {
  const std::vector<Simplex> edges = faces_of(simplices, 2);
  return {edges.begin(), edges.end()};
}

std::set<Vertex> vertices_of(const std::vector<Simplex>& simplices) {
  std::set<Vertex> vertices;
  for (const Simplex& simplex : simplices) vertices.insert(simplex.begin(), simplex.end());
  return vertices;
}

}  // namespace circumspect::constrained
