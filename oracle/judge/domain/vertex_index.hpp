// Which vertices are in a ball?
#pragma once

#include <vector>

#include "kernel/boxes/box_index.hpp"
#include "kernel/complex/circumball.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/exact/triple.hpp"

namespace circumspect::check {

// An R-tree of points. Doubles only sift: balls are enclosed in boxes rounded outward, and of the
// vertices in such a box those are left out that are certainly too far from the centre.
class VertexIndex {
 public:
  explicit VertexIndex(const PointSet& points);
  // All vertices in the closed ball, and a few near it.
  std::vector<Vertex> near(const Ball& ball) const;

 private:
  explicit VertexIndex(const std::vector<Box>& boxes);

  BoxIndex index_;
  std::vector<Triple<double>> low_, high_;  // of each vertex
};

}  // namespace circumspect::check
