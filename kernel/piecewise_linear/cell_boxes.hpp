// Boxes around the cells of a complex, and which cells may meet a box or a line segment. For speed
// alone; see kernel/boxes/box_index.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <optional>
#include <vector>

#include "kernel/boxes/box_index.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/exact/each_once.hpp"

namespace circumspect {

// Every coordinate is rounded once. In more than three dimensions the boxes are around the first
// three coordinates, which is enough for a filter; on a line the second is 0.
class CellBoxes {
 public:
  explicit CellBoxes(const std::vector<Point>& points) {
    of_vertices_.reserve(points.size());
    for (const Point& point : points) of_vertices_.push_back(box_around(shadow(point)));
  }
  explicit CellBoxes(const PointSet& points) : CellBoxes(points.points()) {}
  const std::vector<Box>& of_vertices() const { return of_vertices_; }

  Box of(const Simplex& simplex) const {
    Box box = of_vertices_[static_cast<std::size_t>(simplex.front())];
    for (const Vertex v : simplex) box = box_around(box, of_vertices_[static_cast<std::size_t>(v)]);
    return box;
  }
  std::vector<Box> of(const std::vector<Simplex>& simplices) const {
    std::vector<Box> boxes;
    boxes.reserve(simplices.size());
    for (const Simplex& simplex : simplices) boxes.push_back(of(simplex));
    return boxes;
  }
  BoxIndex index_of(const std::vector<Simplex>& simplices) const { return BoxIndex(of(simplices)); }

 private:
  static Point shadow(Point point) {
    point.resize(std::clamp<std::size_t>(point.size(), 2, 3));
    return point;
  }

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
  keep_each_once(found);
  return found;
}

// The indices are built on the first query.
class NearbyCells {
 public:
  NearbyCells(const PointSet& points, const std::vector<Simplex>& segments)
      : boxes_(points), segments_(segments) {}

  Box box_of(const Simplex& simplex) const { return boxes_.of(simplex); }

  std::vector<Vertex> vertices(const Box& box) const {
    const std::vector<std::size_t> found = indices().vertices.meeting(box);
    return {found.begin(), found.end()};
  }
  std::vector<Vertex> vertices(const Point& from, const Point& to) const {
    const std::vector<std::size_t> found = near_line(indices().vertices, from, to);
    return {found.begin(), found.end()};
  }
  std::vector<Simplex> segments(const Box& box) const {
    return segments_at(indices().segments.meeting(box));
  }
  std::vector<Simplex> segments(const Point& from, const Point& to) const {
    return segments_at(near_line(indices().segments, from, to));
  }

 private:
  std::vector<Simplex> segments_at(const std::vector<std::size_t>& places) const {
    std::vector<Simplex> found;
    for (const std::size_t i : places) found.push_back(segments_[i]);
    return found;
  }

  struct Indices {
    BoxIndex vertices, segments;
  };
  const Indices& indices() const {
    std::call_once(asked_, [this] {
      indices_.emplace(Indices{BoxIndex(boxes_.of_vertices()), boxes_.index_of(segments_)});
    });
    return *indices_;
  }

  CellBoxes boxes_;
  std::vector<Simplex> segments_;
  mutable std::once_flag asked_;
  mutable std::optional<Indices> indices_;
};

}  // namespace circumspect
