// The vertices and segments of a complex that may meet a box, or a line segment.
#pragma once

#include <vector>

#include "reference/piecewise_linear/cell_boxes.hpp"
#include "reference/piecewise_linear/near_line.hpp"

namespace circumspect {

class NearbyCells {
 public:
  NearbyCells(const PointSet& points, const std::vector<Simplex>& segments)
      : boxes_(points),
        segments_(segments),
        vertex_index_(boxes_.of_vertices()),
        segment_index_(boxes_.index_of(segments)) {}

  Box box_of(const Simplex& simplex) const { return boxes_.of(simplex); }

  std::vector<Vertex> vertices(const Box& box) const {
    const std::vector<std::size_t> found = vertex_index_.meeting(box);
    return {found.begin(), found.end()};
  }
  std::vector<Vertex> vertices(const Point& from, const Point& to) const {
    const std::vector<std::size_t> found = near_line(vertex_index_, from, to);
    return {found.begin(), found.end()};
  }
  std::vector<Simplex> segments(const Box& box) const {
    return segments_at(segment_index_.meeting(box));
  }
  std::vector<Simplex> segments(const Point& from, const Point& to) const {
    return segments_at(near_line(segment_index_, from, to));
  }

 private:
  std::vector<Simplex> segments_at(const std::vector<std::size_t>& places) const {
    std::vector<Simplex> found;
    for (const std::size_t i : places) found.push_back(segments_[i]);
    return found;
  }

  CellBoxes boxes_;
  std::vector<Simplex> segments_;
  BoxIndex vertex_index_;
  BoxIndex segment_index_;
};

}  // namespace circumspect
