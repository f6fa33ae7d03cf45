// Which cells of a complex may meet a box, a segment or another cell. For speed alone.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <mutex>
#include <optional>
#include <vector>

#include "kernel/boxes/box_index.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/complex/simplex.hpp"

namespace circumspect {

// Which cells of a complex may meet one with which they share no vertex. For speed alone: the boxes
// of n cells at one vertex all meet, although none of their n² pairs needs a look. Without this
// index, `validated` takes 14 s for a double cone over a rim of 4,000 vertices; with it, 0.6 s.
// Cells on both sides of a plane that only touch it need no look either, because no cell takes its
// least or greatest coordinate in its interior.

// A binary tree of cells. A node knows a box around its cells and the vertices that all of them
// share. The cells at a vertex with many cells are a tree of their own, so that this tree is
// skipped as a whole.
class CellIndex {
 public:
  // The box of each cell, and vertices of it, ascending.
  CellIndex(const std::vector<Box>& boxes, const std::vector<Simplex>& vertices);

  // The places in the list of all cells whose boxes may meet the interior of this one and that have
  // none of these vertices, ascending. Requires: the vertices are in ascending order.
  std::vector<std::size_t> apart(const Box& box, const std::vector<Vertex>& vertices) const;

  // How many nodes all calls of `apart` have looked at.
  std::size_t work() const { return work_; }

 private:
  struct Node {
    Box box;
    std::array<double, 3> middle;  // of the box, doubled
    Simplex shared;  // vertices that all cells have; those of a single cell are all of its own
    std::size_t cell, other;  // a leaf: its place in the list; else the two nodes below it
    bool is_leaf;
  };

  std::size_t joined(std::vector<std::size_t>::iterator first,
                     std::vector<std::size_t>::iterator last);

  std::vector<Node> nodes_;  // children come before their parents
  mutable std::size_t work_ = 0;
};

// Boxes around cells, and which cells may meet a box or a line segment. For speed alone; see
// kernel/boxes/box_index.hpp.

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
