// Has a simplex of lower dimension an empty circumball, and which vertices are in a ball? Book:
// Section 4.1 (Delaunay simplices of any dimension).
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "kernel/boxes/box_index.hpp"
#include "kernel/complex/point_set.hpp"

namespace circumspect::check {

// ---- Vertices near ----
// Finding the vertices in a ball.

// An R-tree of points. Doubles only sift: balls are enclosed in boxes rounded outward, and of the vertices
// in such a box those are left out that are certainly too far from the centre.
class VertexIndex {
 public:
  explicit VertexIndex(const PointSet& points);
  // All vertices in the closed ball, and a few near it.
  std::vector<Vertex> near(const Ball& ball) const;

 private:
  explicit VertexIndex(const std::vector<Box>& boxes);

  BoxIndex index_;
  std::vector<std::array<double, 3>> low_, high_;  // of each vertex
};

// ---- Empty circumball ----

// Some or all of the vertices in a closed ball; at least one strictly inside, if there is any.
using VerticesNear = std::function<std::vector<Vertex>(const Ball&)>;

// A few vertices such that every open circumball of the simplex contains one of them; none iff some
// open circumball contains no vertex at all. The circumballs of a j-simplex have their centres on a
// flat of dimension d − j, and each vertex cuts off a halfspace of it: a linear program in the
// centre, to which vertices are added only when the centre found so far is too near to one.
// Requires: the simplex affinely independent, of dimension d − 1 or 1, in the plane or in space.
std::vector<Vertex> vertices_in_every_circumball(const PointSet& points, const Simplex& simplex,
                                                 const VerticesNear& near);

}  // namespace circumspect::check
