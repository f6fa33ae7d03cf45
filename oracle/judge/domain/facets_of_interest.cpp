#include "oracle/judge/domain/facets_of_interest.hpp"

#include <algorithm>

namespace circumspect::check {

namespace {

// The points of the mesh that are vertices of facets of two simplices that are of interest for
// themselves, and in the plane those in walls.
std::vector<bool> vertices_of_interest(const ExactMesh& mesh, const PiecewiseLinearComplex& complex,
                                       const VertexPlaces& places,
                                       const fast::SimplexFacts& known) {
  std::vector<bool> of_interest(mesh.points.size(), false);
  const auto add = [&](const Simplex& vertices) {
    for (const Vertex v : vertices) of_interest[VertexPlaces::place(v)] = true;
  };
  if (complex.ambient_dimension() == 2) {
    for (const Simplex& segment : complex.segments) {
      for (const Vertex v : segment) add({places.in_mesh[VertexPlaces::place(v)]});
    }
    for (Vertex v = 0; mesh.points.names(v); ++v) {
      if (places.segment[VertexPlaces::place(v)] != kNowhere) add({v});
    }
  }
  for (const Simplex& face : mesh.faces) {
    if (face.size() == complex.ambient_dimension()) add(face);
  }
  for (const fast::FacetId facet : known.not_local) add(vertices_of(mesh, facet));
  return of_interest;
}

// Do all of the points lie in one polygon?
bool are_in_a_polygon(const Simplex& points,
                      const std::vector<std::vector<std::size_t>>& polygons_at) {
  const std::vector<std::size_t>& first = polygons_at[VertexPlaces::place(points.front())];
  return std::any_of(first.begin(), first.end(), [&](std::size_t p) {
    return std::all_of(points.begin() + 1, points.end(), [&](Vertex v) {
      const std::vector<std::size_t>& others = polygons_at[VertexPlaces::place(v)];
      return std::binary_search(others.begin(), others.end(), p);
    });
  });
}

}  // namespace

Simplex vertices_of(const ExactMesh& mesh, fast::FacetId facet) {
  return sorted(facet_opposite(mesh.simplices[facet.simplex()], facet.place()));
}

std::vector<FacetUse> uses_of_interest(const ExactMesh& mesh, const PiecewiseLinearComplex& complex,
                                       const VertexPlaces& places,
                                       const fast::SimplexFacts& known) {
  const std::vector<bool> of_interest = vertices_of_interest(mesh, complex, places, known);
  const auto polygons_at = polygons_at_vertices(mesh, complex, places);
  std::vector<bool> may_count = of_interest;
  for (std::size_t v = 0; v < may_count.size(); ++v) {
    if (!polygons_at[v].empty()) may_count[v] = true;
  }
  auto boundary = known.boundary.begin();
  std::vector<FacetUse> uses;
  Simplex facet;
  for (std::size_t s = 0; s < mesh.simplices.size(); ++s) {
    const Simplex& simplex = mesh.simplices[s];
    const bool has_single = boundary != known.boundary.end() && boundary->simplex() == s;
    // Most simplices are away from all walls.
    const auto others = std::count_if(simplex.begin(), simplex.end(),
                                      [&](Vertex v) { return !may_count[VertexPlaces::place(v)]; });
    if (others > 1 && !has_single) continue;
    for (std::size_t place = 0; place < simplex.size(); ++place) {
      const bool is_single =
          boundary != known.boundary.end() && *boundary == fast::FacetId(s, place);
      if (is_single) ++boundary;
      facet.assign(simplex.begin(), simplex.end());
      facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(place));
      const bool counts = is_single || are_in_a_polygon(facet, polygons_at) ||
                          std::all_of(facet.begin(), facet.end(), [&](Vertex v) {
                            return of_interest[VertexPlaces::place(v)];
                          });
      if (counts) uses.push_back({sorted(facet), s, place});
    }
  }
  std::stable_sort(uses.begin(), uses.end(),
                   [](const FacetUse& a, const FacetUse& b) { return a.facet < b.facet; });
  return uses;
}

}  // namespace circumspect::check
