// How vertices, segments and triangles lie to one another, by signs of integer determinants alone.
// Where two of them meet, `intersection` says in what. Book: Definition 4.3.
#pragma once

#include <span>
#include <vector>

#include "reference/kernel/complex/simplex.hpp"

namespace circumspect {

// Does v lie in the relative interior of the segment? Requires: not one of its ends.
bool lies_inside_segment(const Configuration& points, Vertex v, const Simplex& segment);

// Have the segments a point in common that is inside both, without lying on one line?
// Requires: no vertex in common.
bool segments_cross(const Configuration& points, const Simplex& a, const Simplex& b);

// Two axes on which the plane of the triangle projects injectively, the first such pair; none if its
// corners are on one line.
std::vector<std::size_t> axes_of_plane(const Configuration& points, const Simplex& triangle);

// On which side of the triangle is v? Zero in its plane. Requires: in space.
int side_of_triangle(const Configuration& points, const Simplex& triangle, Vertex v);

// Does v lie in the closed triangle? Requires: in space; `axes` are a coordinate system of its plane.
bool lies_in_triangle(const Configuration& points, Vertex v, const Simplex& triangle,
                      std::span<const std::size_t> axes);

// Has the segment an end strictly on either side of the triangle, and goes through it?
// Requires: in space.
bool segment_pierces_triangle(const Configuration& points, const Simplex& segment,
                              const Simplex& triangle);

// Have the triangles of one plane, with coordinates `axes`, interior points in common?
bool interiors_meet(const Configuration& points, std::span<const std::size_t> axes,
                    const Simplex& a, const Simplex& b);

}  // namespace circumspect
