#include "oracle/judge/domain/facets_of_interest.hpp"

#include <algorithm>

namespace circumspect::check {

namespace {

// The points of the mesh that are in walls, or vertices of facets that are of interest for
// themselves.
std::vector<bool> vertices_of_interest(const ExactMesh& mesh, const PiecewiseLinearComplex& complex,
                                       const VertexPlaces& places,
                                       const fast::SimplexFacts& known) {
  std::vector<bool> of_interest(mesh.points.size(), false);
  const auto add = [&](const Simplex& vertices) {
    for (const Vertex v : vertices) of_interest[VertexPlaces::place(v)] = true;
  };
  const auto add_from_domain = [&](const Simplex& vertices) {
    for (const Vertex v : vertices) add({places.in_mesh[VertexPlaces::place(v)]});
  };
  const bool in_plane = complex.ambient_dimension() == 2;
  if (in_plane) std::for_each(complex.segments.begin(), complex.segments.end(), add_from_domain);
  for (const Polygon& polygon : complex.polygons) add_from_domain(polygon.vertices);
  for (Vertex v = 0; mesh.points.names(v); ++v) {
    const std::size_t place = VertexPlaces::place(v);
    if (places.segment[place] != kNowhere || places.polygon[place] != kNowhere) add({v});
  }
  for (const Simplex& face : mesh.faces) {
    if (face.size() == complex.ambient_dimension()) add(face);
  }
  for (const fast::FacetId facet : known.boundary) add(vertices_of(mesh, facet));
  for (const fast::FacetId facet : known.not_local) add(vertices_of(mesh, facet));
  return of_interest;
}

}  // namespace

Simplex vertices_of(const ExactMesh& mesh, fast::FacetId facet) {
  return sorted(facet_opposite(mesh.simplices[facet.simplex()], facet.place()));
}

std::vector<FacetUse> uses_of_interest(const ExactMesh& mesh, const PiecewiseLinearComplex& complex,
                                       const VertexPlaces& places,
                                       const fast::SimplexFacts& known) {
  const std::vector<bool> of_interest = vertices_of_interest(mesh, complex, places, known);
  std::vector<FacetUse> uses;
  for (std::size_t s = 0; s < mesh.simplices.size(); ++s) {
    const Simplex& simplex = mesh.simplices[s];
    const auto others = std::count_if(simplex.begin(), simplex.end(), [&](Vertex v) {
      return !of_interest[VertexPlaces::place(v)];
    });
    if (others > 1) continue;
    for (std::size_t place = 0; place < simplex.size(); ++place) {
      if (others == 1 && of_interest[VertexPlaces::place(simplex[place])]) continue;
      uses.push_back({sorted(facet_opposite(simplex, place)), s, place});
    }
  }
  std::stable_sort(uses.begin(), uses.end(),
                   [](const FacetUse& a, const FacetUse& b) { return a.facet < b.facet; });
  return uses;
}

}  // namespace circumspect::check
