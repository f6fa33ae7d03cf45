// Finding the vertices in a ball.
#pragma once

#include "reference/kernel/complex/circumball.hpp"
#include "reference/kernel/exact/box_index.hpp"

namespace circumspect::check {

// An R-tree of points. Doubles only sift: balls are enclosed in boxes rounded outward.
class VertexIndex {
 public:
  explicit VertexIndex(const PointSet& points);
  // All vertices in the closed ball, and a few near it.
  std::vector<Vertex> near(const Ball& ball) const;

 private:
  BoxIndex index_;
};

}  // namespace circumspect::check
