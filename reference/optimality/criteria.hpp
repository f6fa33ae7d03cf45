// What Delaunay triangulations minimise. Book: Section 4.3.
#pragma once

#include <optional>
#include <vector>

#include "kernel/complex/circumball.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/complex/triangulation.hpp"

namespace circumspect::optimality {

// Barycentric coordinates in a simplex of any dimension.

// The λ with Σ λ_i v_i = p and Σ λ_i = 1; nothing if p is outside the affine hull of the simplex or
// its vertices are affinely dependent. Requires: the simplex not empty.
std::optional<std::vector<Rational>> barycentric_coordinates(const PointSet& points,
                                                             const Simplex& simplex,
                                                             const Point& p);

// The same for the point of the simplex's affine hull that is nearest to p. Requires: the simplex
// affinely independent, not empty.
std::vector<Rational> coordinates_of_projection(const PointSet& points, const Simplex& simplex,
                                                const Point& p);

// Σ λ_i v_i.
Point combination(const PointSet& points, const Simplex& simplex,
                  const std::vector<Rational>& coefficients);

// Are all coefficients nonnegative, so that the combination is a point of the simplex?
bool is_convex(const std::vector<Rational>& coefficients);

// 𝒯⁺(p): the height over p of the triangulation lifted to |v|² − weight(v) at each vertex v;
// nothing if p is not in any of its simplices.
std::optional<Rational> lifted_height(const PointSet& points, const Triangulation& triangulation,
                                      const Point& p);

// e(p) = 𝒯⁺(p) − |p|², "the error in the interpolated function 𝒯⁺ as an approximation of the
// paraboloid".
std::optional<Rational> interpolation_error(const PointSet& points,
                                            const Triangulation& triangulation, const Point& p);

// Where on a simplex the error is greatest, and how great.
struct GreatestError {
  Point where;
  Rational error;
};

// From the definition of e, which is concave on a simplex: its maximum lies in the relative
// interior of some face and is stationary there. Requires: the simplex affinely independent.
GreatestError greatest_interpolation_error(const PointSet& points, const Simplex& simplex);

// The greatest over all simplices. Requires: at least one.
GreatestError greatest_interpolation_error(const PointSet& points,
                                           const Triangulation& triangulation);

// ∫ 𝒯⁺ times (k+1)! over the coordinate axes of the hull. For two triangulations of the same point
// set, it differs exactly as the norm ‖e‖_{L₁} does. Requires: k = points.dimension().
Rational lifted_integral(const PointSet& points, const Triangulation& triangulation);

// The point of a simplex that is nearest to p. Requires: the simplex affinely independent.
Point nearest_point(const PointSet& points, const Simplex& simplex, const Point& p);

// The smallest closed ball that contains a simplex. Book: Proposition 4.6, "Let q be the point in σ
// nearest o. Then o_mc = q and r_mc² = r² − d(o, q)²".
// Requires: the simplex affinely independent; no weights.
Ball min_containment_ball(const PointSet& points, const Simplex& simplex);

// The largest of the min-containment balls of all simplices, the quantity of Proposition 4.7.
// Requires: at least one simplex; no weights.
Ball largest_min_containment_ball(const PointSet& points, const Triangulation& triangulation);

}  // namespace circumspect::optimality
