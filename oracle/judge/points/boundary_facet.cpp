#include "oracle/judge/points/boundary_facet.hpp"

#include "reference/kernel/predicates/orientation.hpp"

namespace circumspect::check {
namespace {

Simplex with_apex(Simplex facet, Vertex apex) {
  facet.push_back(apex);
  return facet;
}

}  // namespace

std::vector<BoundaryFacet> boundary_facets(const ExactMesh& mesh,
                                           const std::vector<FacetUse>& uses) {
  std::vector<BoundaryFacet> boundary;
  for_each_facet(uses, [&](std::span<const FacetUse> group) {
    if (group.size() != 1) return;
    const FacetUse& use = group.front();
    boundary.push_back({use.facet, mesh.simplices[use.simplex][use.opposite], use.simplex});
  });
  return boundary;
}

int side_of(const Configuration& points, const BoundaryFacet& facet, Vertex q) {
  return orientation(points, with_apex(facet.facet, q)) *
         orientation(points, with_apex(facet.facet, facet.apex));
}

Witness beyond(const ExactMesh& mesh, const BoundaryFacet& facet, Vertex q) {
  Witness witness{
      .simplices = {mesh.simplices[facet.simplex]}, .face = facet.facet, .vertices = {q}};
  const Configuration& points = mesh.points.configuration();
  witness.values = {
      {"orientation determinant of facet and own apex",
       orientation_determinant(points, points.axes(), with_apex(facet.facet, facet.apex))},
      {"orientation determinant of facet and vertex beyond",
       orientation_determinant(points, points.axes(), with_apex(facet.facet, q))}};
  return witness;
}

}  // namespace circumspect::check
