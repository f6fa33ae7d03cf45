// The facets of a mesh that only one simplex has, and on which side of them points are.
#pragma once

#include <span>
#include <vector>

#include "kernel/complex/simplex.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::check {

struct BareFacet {
  Simplex facet;  // ascending
  Vertex apex;    // of the simplex
};

// In order of their vertices. None if the mesh has not rows of d + 1 points each, in the plane or
// in space.
std::vector<BareFacet> bare_facets(const Mesh& mesh);

// The sign of the determinant of d + 1 points of a mesh in the plane or in space, exactly: by the
// fast predicates, if its coordinates are doubles.
int orientation_in(const Mesh& mesh, std::span<const Vertex> points);

// On which side of the facet is a point, −1, 0 or 1? The apex is not in its plane.
int side_of(const Mesh& mesh, const BareFacet& facet, Vertex point);

}  // namespace circumspect::check
