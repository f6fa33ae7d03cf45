// Boxes around cells, and which cells may meet a box or a line segment. For speed alone; see
// reference/kernel/exact/box_index.hpp.
#pragma once

#include <algorithm>
#include <vector>

#include "reference/kernel/complex/point_set.hpp"
#include "reference/kernel/exact/box_index.hpp"

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
  std::vector<Box> of(const std::vector<Simplex>& simplices) const {
    std::vector<Box> boxes;
    for (const Simplex& simplex : simplices) boxes.push_back(of(simplex));
    return boxes;
  }
  BoxIndex index_of(const std::vector<Simplex>& simplices) const { return BoxIndex(of(simplices)); }

 private:
  std::vector<Box> of_vertices_;
};

// The places of all boxes that have a point in common with the segment, and some that are near it,
// ascending. A long segment has a box around it that is much larger than itself, so if too many are
// found it is halved.
inline std::vector<std::size_t> near_line(const BoxIndex& index, const Point& from, const Point& to,
                                          int halvings = 6) {
  std::vector<std::size_t> found = index.meeting(box_around(box_around(from), box_around(to)));
  constexpr std::size_t kFew = 12;
  if (halvings == 0 || found.size() <= kFew) return found;
  const Point middle = Rational(1, 2) * (from + to);
  found = near_line(index, from, middle, halvings - 1);
  const std::vector<std::size_t> rest = near_line(index, middle, to, halvings - 1);
  found.insert(found.end(), rest.begin(), rest.end());
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

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
