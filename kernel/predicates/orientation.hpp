// Orientation of simplices. Book: Section 3.1 (Orient2D, Orient3D) and its use all over Chapter 5.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "kernel/predicates/configuration.hpp"

namespace circumspect {

// The sign of det[p_0 − p_k; p_1 − p_k; …; p_{k−1} − p_k], the rows taken on the given k axes.
// Positive in the plane for counterclockwise triangles, and in space for the book's (and
// Shewchuk's) positively oriented tetrahedra: p_0 p_1 p_2 turn counterclockwise seen from p_3's
// opposite side, that is p_3 lies below their plane seen from where they turn counterclockwise.
//
// Laws (held by orientation_test.cpp under these numbers):
//  O1 antisymmetry: swapping two vertices negates it.
//  O2 it is zero iff the points, projected on the axes, are affinely dependent.
//  O3 translation and positive uniform scaling keep it; a reflection of one axis negates it.
//  O4 Plücker: the (k+1)-subsets of any k+2 points p_0 … p_{k+1} satisfy
//     Σ_i (−1)^i det(all but p_i) = 0, and two (k+1)-sets satisfy the exchange relation.
//  O5 it agrees with CGAL's exact kernel: equal in the plane, negated in space.
//  O6 it does not depend on how the points are scaled to integers.
// Requires: simplex.size() == axes.size() + 1.
int orientation(const Configuration& points, std::span<const std::size_t> axes,
                std::span<const Vertex> simplex);

// Within the affine hull of all points, on the hull's own axes.
// Requires: simplex.size() == points.dimension() + 1.
int orientation(const Configuration& points, std::span<const Vertex> simplex);

// On which side of the hyperplane of a facet is q? The orientation of the simplex that joins them,
// with q as its last vertex; 0 in the hyperplane. Requires: facet.size() == axes.size().
int side_of_facet(const Configuration& points, std::span<const std::size_t> axes,
                  std::span<const Vertex> facet, Vertex q);
// Within the affine hull of all points.
int side_of_facet(const Configuration& points, std::span<const Vertex> facet, Vertex q);

// The orientation of the simplex with q in place of its vertex at `place`. Requires:
// simplex.size() == axes.size() + 1.
int orientation_with(const Configuration& points, std::span<const std::size_t> axes,
                     std::span<const Vertex> simplex, std::size_t place, Vertex q);

// The determinant itself, in the points' own coordinates: k! times the signed volume of the simplex
// projected on the axes. Requires: as for orientation.
Rational orientation_determinant(const Configuration& points, std::span<const std::size_t> axes,
                                 std::span<const Vertex> simplex);

// k axes on which the k-simplex keeps its dimension: a coordinate system of its affine hull. Fewer
// than k of them if its vertices are affinely dependent.
std::vector<std::size_t> axes_of(const Configuration& points, std::span<const Vertex> simplex);

// The axes of space, for tests that name them by number.
inline constexpr std::array<std::size_t, 3> kSpace = {0, 1, 2};

}  // namespace circumspect
