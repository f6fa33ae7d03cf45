// On which side of the facets of simplices a point lies: the sign that most of a certificate is
// about. Book: Section 3.1 (Orient2D, Orient3D).
#pragma once

#include <array>
#include <optional>
#include <span>

#include "oracle/certificate/scaled_points.hpp"

namespace circumspect::certificate {

// Orientations in the plane and in space, of integer points and one rational point among them. The
// numbers in between keep their memory, so that millions of calls allocate nothing.
class Sidedness {
 public:
  // Requires: points of dimension 2 or 3, which outlive this.
  explicit Sidedness(const ScaledPoints& points) : points_(points) {}

  // The sign of det[v_i − v_d]. Requires: d+1 vertices.
  int orientation(std::span<const Vertex> simplex);

  // Likewise with vertex number `place` moved to q.
  int orientation_with(std::span<const Vertex> simplex, std::size_t place,
                       const HomogeneousPoint& q);

  // A place whose opposite facet has q strictly on its outer side; none if the closed simplex
  // contains q. `own` is the orientation of the simplex, not 0; place `first` is tried first.
  std::optional<std::size_t> separating_place(std::span<const Vertex> simplex, int own,
                                              const HomogeneousPoint& q, std::size_t first = 0);

 private:
  int sign_of_determinant();

  const ScaledPoints& points_;
  std::array<std::array<Integer, 3>, 3> rows_;
  Integer minor_;
  Integer determinant_;
};

}  // namespace circumspect::certificate
