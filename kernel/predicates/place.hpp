// Where a vertex lies with respect to a simplex, and how segments and triangles lie with respect to
// one another, by signs of integer determinants alone. If two of them meet, `intersection` computes
// where. Book: Definition 4.3 (cells that meet only in shared cells), Section 5.5 (the simplex that
// contains a point). All functions require distinct points.
//
// Laws (held by place_test.cpp under these numbers):
//  P1 v lies in a closed simplex iff it is a convex combination of its vertices, and inside iff all
//     coefficients are positive.
//  P2 v lies in a closed simplex iff it lies inside exactly one of its faces; a vertex lies inside
//     itself.
//  P3 the order of a simplex's vertices, and which of two simplices is named first, do not matter.
//  P4 a segment that crosses another, or pierces a triangle, has just one point in common with it,
//     which is inside both, or inside the segment and in the triangle.
//  P5 triangles of a plane whose interiors meet have a triangle in common.
//  P6 v has the barycentric signs of its coefficients in the affine combination of the vertices.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "kernel/predicates/configuration.hpp"

namespace circumspect {

// The sign of the barycentric coordinate of v at the vertex at `place` of the simplex: 1 on that
// vertex's side of the facet opposite, 0 in its hyperplane, −1 beyond. It is the orientation with v
// in that vertex's stead, over the simplex's own. Points that are not in the simplex's affine hull
// are seen on `axes`, a coordinate system of it. Requires: affinely independent vertices.
int barycentric_sign(const Configuration& points, std::span<const std::size_t> axes,
                     std::span<const Vertex> simplex, std::size_t place, Vertex v);
// Within the affine hull of all points.
int barycentric_sign(const Configuration& points, std::span<const Vertex> simplex,
                     std::size_t place, Vertex v);
// The same of a simplex whose orientation, `own`, is known: half of the work.
int barycentric_sign(const Configuration& points, std::span<const Vertex> simplex, int own,
                     std::size_t place, Vertex v);

// All of them, in the order of the vertices.
std::vector<int> barycentric_signs(const Configuration& points, std::span<const std::size_t> axes,
                                   std::span<const Vertex> simplex, Vertex v);
std::vector<int> barycentric_signs(const Configuration& points, std::span<const Vertex> simplex,
                                   Vertex v);

// Does v lie in the closed simplex, or in its relative interior? `axes` are a coordinate system of
// the simplex's affine hull. Requires: affinely independent vertices.
bool lies_in(const Configuration& points, std::span<const std::size_t> axes,
             std::span<const Vertex> simplex, Vertex v);
bool lies_inside(const Configuration& points, std::span<const std::size_t> axes,
                 std::span<const Vertex> simplex, Vertex v);

// The same where no coordinate system is known.
bool lies_in(const Configuration& points, std::span<const Vertex> simplex, Vertex v);
bool lies_inside(const Configuration& points, std::span<const Vertex> simplex, Vertex v);

// Does v lie in the affine hull of the simplex? `axes` are as above.
bool is_in_hull_of(const Configuration& points, std::span<const std::size_t> axes,
                   std::span<const Vertex> simplex, Vertex v);

// Does v lie in the relative interior of the segment?
bool lies_inside_segment(const Configuration& points, std::span<const Vertex> segment, Vertex v);

// Do the segments have a point in common that is inside both, without being collinear? Requires: no
// vertex in common.
bool segments_cross(const Configuration& points, std::span<const Vertex> a,
                    std::span<const Vertex> b);

// Two axes on which the plane of the triangle projects injectively, the first such pair; none if
// its corners are on one line.
std::vector<std::size_t> axes_of_plane(const Configuration& points,
                                       std::span<const Vertex> triangle);

// On which side of the triangle is v? Zero in its plane. Requires: points of space.
int side_of_triangle(const Configuration& points, std::span<const Vertex> triangle, Vertex v);

// Does the segment have ends strictly on both sides of the triangle, and pass through it? Requires:
// points of space.
bool segment_pierces_triangle(const Configuration& points, std::span<const Vertex> segment,
                              std::span<const Vertex> triangle);

// Do two coplanar triangles, with coordinates `axes`, have interior points in common?
bool interiors_meet(const Configuration& points, std::span<const std::size_t> axes,
                    std::span<const Vertex> a, std::span<const Vertex> b);

}  // namespace circumspect
