// Barycentric coordinates in a simplex of any dimension.
#pragma once

#include <optional>
#include <vector>

#include "reference/kernel/complex/point_set.hpp"

namespace circumspect::optimality {

// The λ with Σ λ_i v_i = p and Σ λ_i = 1; nothing if p is outside the affine hull of the simplex or
// its vertices are affinely dependent. Requires: the simplex not empty.
std::optional<std::vector<Rational>> barycentric_coordinates(const PointSet& points,
                                                             const Simplex& simplex,
                                                             const Point& p);

// The same of the point of the simplex's affine hull that is nearest to p.
// Requires: the simplex affinely independent, not empty.
std::vector<Rational> coordinates_of_projection(const PointSet& points, const Simplex& simplex,
                                                const Point& p);

// Σ λ_i v_i.
Point combination(const PointSet& points, const Simplex& simplex,
                  const std::vector<Rational>& coefficients);

// None of the coefficients is negative: the combination is a point of the simplex.
bool is_convex(const std::vector<Rational>& coefficients);

}  // namespace circumspect::optimality
