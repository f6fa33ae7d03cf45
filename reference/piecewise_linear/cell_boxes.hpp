// Boxes around vertices, segments and triangles.
#pragma once

#include <vector>

#include "reference/complex/point_set.hpp"
#include "reference/exact/box_index.hpp"

namespace circumspect {

// Every coordinate is rounded once.
class CellBoxes {
 public:
  explicit CellBoxes(const PointSet& points) {
    for (const Point& point : points.points()) of_vertices_.push_back(box_around(point));
  }
  const std::vector<Box>& of_vertices() const { return of_vertices_; }

  Box of(const Simplex& simplex) const {
    Box box = of_vertices_[static_cast<std::size_t>(simplex.front())];
    for (const Vertex v : simplex) box = box_around(box, of_vertices_[static_cast<std::size_t>(v)]);
    return box;
  }
  BoxIndex index_of(const std::vector<Simplex>& simplices) const {
    std::vector<Box> boxes;
    for (const Simplex& simplex : simplices) boxes.push_back(of(simplex));
    return BoxIndex(boxes);
  }

 private:
  std::vector<Box> of_vertices_;
};

}  // namespace circumspect
