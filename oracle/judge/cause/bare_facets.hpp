// The facets of a mesh that only one simplex has, and on which side of them points are.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "kernel/complex/simplex.hpp"
#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::check {

struct BareFacet {
  Simplex facet;  // ascending
  Vertex apex;    // of the simplex
};

// In order of their vertices. None if the mesh has not rows of d + 1 points each, in the plane or
// in space; none of simplices whose indices do not all name points.
std::vector<BareFacet> bare_facets(const Mesh& mesh);
// The same where it is known which facets these are.
std::vector<BareFacet> bare_facets(const Mesh& mesh, const std::vector<fast::FacetId>& boundary);

// Do all of these indices name points of the mesh? The claim `complex` judges what is left where
// some do not, so whoever looks at the simplices has to ask.
template <class Row>
bool name_points(const Mesh& mesh, const Row& row) {
  return std::all_of(row.begin(), row.end(), [&mesh](auto v) { return mesh.names(v); });
}

// The sign of the determinant of d + 1 points of a mesh in the plane or in space, exactly: by the
// fast predicates, if its coordinates are doubles. 0 if an index names no point.
int orientation_in(const Mesh& mesh, std::span<const Vertex> points);

// On which side of the facet is a point, −1, 0 or 1? The apex is not in its plane.
int side_of(const Mesh& mesh, const BareFacet& facet, Vertex point);

}  // namespace circumspect::check
