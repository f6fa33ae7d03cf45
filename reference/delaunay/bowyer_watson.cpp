#include "reference/delaunay/bowyer_watson.hpp"

#include <utility>

#include "reference/delaunay/conflict.hpp"

namespace circumspect::delaunay {

BowyerWatson::BowyerWatson(const PointSet& points) : points_(points) {
  for (const std::size_t v : points.configuration().hull().basis) {
    first_simplex_.push_back(static_cast<Vertex>(v));
  }
  first_simplex_ = positively_oriented(points, first_simplex_);
  dictionary_.add(first_simplex_);
  for (std::size_t place = 0; place < first_simplex_.size(); ++place) {
    dictionary_.add(join(OrientedFacet::opposite(first_simplex_, place).reverse(), kGhost));
  }
}

bool BowyerWatson::insert(Vertex u) {
  const std::optional<Simplex> located =
      dictionary_.find([&](const Simplex& simplex) { return is_in_conflict(points_, simplex, u); });
  if (located) insert(u, *located);
  return located.has_value();
}

void BowyerWatson::insert(Vertex u, const Simplex& in_conflict) {
  dictionary_.remove(in_conflict);
  std::vector<OrientedFacet> facets;
  for (std::size_t place = 0; place < in_conflict.size(); ++place) {
    facets.push_back(OrientedFacet::opposite(in_conflict, place));
  }
  dig_cavity(u, std::move(facets));
}

// DigCavity3D. The facets have the deleted simplex, and so u, in front. The book recurses; a stack
// of facets visits them in the same depth-first order and does not overflow on large cavities.
void BowyerWatson::dig_cavity(Vertex u, std::vector<OrientedFacet> facets) {
  while (!facets.empty()) {
    const OrientedFacet facet = facets.back();
    facets.pop_back();
    const std::optional<Vertex> z = dictionary_.adjacent(facet.reverse());
    if (!z) continue;  // Step 4: the simplex has already been deleted.
    const Simplex beyond = join(facet.reverse(), *z);
    if (is_in_conflict(points_, beyond, u)) {
      dictionary_.remove(beyond);
      for (std::size_t place = 0; place < beyond.size(); ++place) {
        const OrientedFacet next = OrientedFacet::opposite(beyond, place);
        if (beyond[place] != *z) facets.push_back(next);
      }
    } else {
      dictionary_.add(join(facet, u));  // Step 6: a facet of the star-shaped cavity.
    }
  }
}

Triangulation BowyerWatson::triangulation() const {
  std::vector<Simplex> solid;
  for (const Simplex& simplex : dictionary_.simplices()) {
    if (!is_ghost(simplex)) solid.push_back(simplex);
  }
  return Triangulation(points_.dimension(), std::move(solid));
}

Triangulation bowyer_watson(const PointSet& points) {
  if (points.empty()) return Triangulation(-1, {});
  if (points.dimension() == 0) return Triangulation(0, {{0}});
  BowyerWatson algorithm(points);
  for (Vertex u = 0; points.names(u); ++u) {
    if (!contains(algorithm.first_simplex(), u)) algorithm.insert(u);
  }
  return algorithm.triangulation();
}

}  // namespace circumspect::delaunay
