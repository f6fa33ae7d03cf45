// Is a simplex of any dimension Delaunay? strongly Delaunay? Book: Section 4.2.
#pragma once

#include <optional>
#include <vector>

#include "kernel/complex/circumball.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/complex/triangulation.hpp"

namespace circumspect::delaunay {

// "The simplex σ is Delaunay if there exists an open circumball of σ that contains no point in S.
// σ is strongly Delaunay if there exists a closed circumball of σ that contains no point in S
// except the vertices of σ." With weights: no lifted point is strictly below (at or below) some
// non-vertical hyperplane through σ⁺.
enum class Delaunayhood { kNotDelaunay, kDelaunay, kStronglyDelaunay };

// Why σ is not Delaunay, or not strongly so. The combination Σ coefficient · point lies in the
// affine hull of σ. For such a combination, the power Σ coefficient · power(ball, point) is the
// same for all circumballs of σ. So if it is negative, every open circumball contains one of the
// points; if it is zero, every closed one does.
struct Obstruction {
  Simplex points;                      // none a vertex of σ
  std::vector<Rational> coefficients;  // positive, with sum 1, one a point
  Rational power;
};

struct SimplexDelaunayhood {
  Delaunayhood delaunayhood = Delaunayhood::kNotDelaunay;
  std::optional<Ball> ball;                // the circumball that shows it; nothing if there is none
  std::optional<Obstruction> obstruction;  // unless strongly Delaunay
};

// By a linear program in the centre of the ball. The centre lies in the affine hull of S.
// Requires: the simplex affinely independent, of any dimension k ≥ 0.
SimplexDelaunayhood delaunayhood(const PointSet& points, const Simplex& simplex);

bool is_delaunay(const PointSet& points, const Simplex& simplex);
bool is_strongly_delaunay(const PointSet& points, const Simplex& simplex);

// "A Delaunay triangulation of S is a triangulation of S in which every k-simplex is Delaunay."
// Book: Definition 4.1. Requires: a triangulation of the points, without weights.
bool is_delaunay(const PointSet& points, const Triangulation& triangulation);

}  // namespace circumspect::delaunay
