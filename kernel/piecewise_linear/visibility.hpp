// Simplices that respect a complex, visibility in it, and the cone of directions that decides it.
// Book: Section 4.5.2, Definitions 2.11 and 2.13.
#pragma once

#include <optional>
#include <vector>

#include "kernel/exact/linear_algebra.hpp"
#include "kernel/exact/point.hpp"
#include "kernel/piecewise_linear/regions.hpp"

namespace circumspect {

// The part of a simplex that can be seen from a point, past obstacles. Book: Definition 2.13
// (visibility).

// The cone of directions from a point v over a simplex φ of k = 2 or 3 vertices, v not in its
// affine hull: a segment seen in its plane with v, or a triangle seen in space. A point p of the
// plane (of space) has the coordinates c with p − v = Σ c_i (φ_i − v): it is in the cone iff all
// are non-negative, and before φ, or on it, iff their sum is at most 1. Divided by their sum, they
// are the barycentric coordinates of the point of φ behind p, as seen from v.
//
// Obstacles are clipped to the cone and to the near side of φ, and the rest is projected on φ,
// which gives a convex polygon (an interval). What remains of φ is cut into convex polygons along
// the edges of these. Only those with interior points are kept: the obstacles count as closed.
class SightCone {
 public:
  SightCone(Point v, std::vector<Point> simplex);

  // The coordinates of a point. Requires: it is in the affine hull of v and the simplex.
  Point coordinates(const Point& point) const;

  // Subtracts the directions in which an obstacle, a triangle (if k = 2, a segment) given by the
  // coordinates of its corners, lies before the simplex. An obstacle whose plane (line) contains v
  // covers no open set of directions, and neither does one that is not before the simplex. Returns
  // whether fewer directions are open now.
  bool obstruct(const std::vector<Point>& obstacle);

  // k affinely independent points of the simplex such that no obstacle lies before the interior of
  // their convex hull; nothing if the obstacles cover all of the simplex.
  std::optional<std::vector<Point>> open_part() const;

 private:
  using Polygon = std::vector<Point>;  // counterclockwise; for an interval, its ends in order

  Polygon shadow(Polygon obstacle) const;

  std::size_t k_;
  Point v_;
  std::vector<Point> simplex_;
  std::vector<std::size_t> axes_;
  RationalMatrix directions_;  // the columns are the φ_i − v, on the axes
  std::vector<Polygon> open_;  // in barycentric coordinates, the first left out
};

// Respecting a piecewise linear complex, and visibility in it.
// Book: Definitions 2.11 and 2.13, quoted in Section 4.5.2.

// A simplex σ respects P if σ ⊆ |P| and for every cell f of P that meets σ, f ∩ σ is a union of
// faces of σ. Requires: vertices of P, affinely independent; the regions are those of the complex.
bool respects(const PiecewiseLinearComplex& complex, const Regions& regions,
              const Simplex& simplex);

// Is the vertex v visible from some point in the relative interior of the simplex?
// Requires: the simplex respects the complex; v is not one of its vertices.
bool is_visible(const PiecewiseLinearComplex& complex, const Regions& regions, Vertex v,
                const Simplex& simplex);

// A point in the relative interior of the simplex from which v is visible; nothing if there is
// none. Requires: as for is_visible.
std::optional<Point> visible_point(const PiecewiseLinearComplex& complex, const Regions& regions,
                                   Vertex v, const Simplex& simplex);

}  // namespace circumspect
