// The positions of triangles as seen along the normal of a polygon.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "oracle/judge/within/distance.hpp"

namespace circumspect::check {

// Directed: each edge of a triangle has it on its left.
using Edge = std::pair<Vertex, Vertex>;
// Requires: counterclockwise.
inline std::array<Edge, 3> edges(const Simplex& triangle) {
  return {{{triangle[0], triangle[1]}, {triangle[1], triangle[2]}, {triangle[2], triangle[0]}}};
}

// The normal of a polygon whose first coordinate that is not zero is positive. Above is where it
// points.
Point normal_of(const PiecewiseLinearComplex& complex, std::size_t polygon);

// Which triangles are counterclockwise seen from above a polygon. Doubles decide where they can.
class SeenFromAbove {
 public:
  // The points of the domain and of the mesh, and both rounded; all must outlive this.
  SeenFromAbove(const PiecewiseLinearComplex& complex,
                const std::vector<RoundedPoint>& rounded_domain, std::size_t polygon,
                const PointSet& points, const std::vector<RoundedPoint>& rounded);

  // A triangle of the polygon itself, counterclockwise.
  Simplex own(Simplex triangle) const;
  // Positive if the triangle of the mesh is counterclockwise, zero if it is seen as a line.
  int turn(const Simplex& triangle) const;

 private:
  const Point& exact_normal() const;

  const PiecewiseLinearComplex& complex_;
  std::size_t polygon_;
  const PointSet& points_;
  const std::vector<RoundedPoint>& rounded_;
  Triple<Interval> normal_;
  bool is_reversed_;  // is the normal not that of the polygon's first triangle?
  mutable Point exact_normal_;
};

}  // namespace circumspect::check
