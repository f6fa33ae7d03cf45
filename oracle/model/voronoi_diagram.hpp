// A Voronoi diagram as a program lists it: a cell for each site.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "kernel/complex/point_set.hpp"

namespace circumspect {

// The convex hull of some vertices. If it is unbounded, it also has every direction that does not
// come nearer to another site than to its own.
struct ListedCell {
  std::vector<Vertex> corners = {};  // among the listed vertices, from 0; others name none
  bool is_unbounded = false;
};

struct VoronoiDiagram {
  PointSet sites;
  std::vector<Point> vertices = {};
  std::vector<ListedCell> cells = {};  // one a site
  // Pairs of sites whose cells have a common ridge; need not be all, since Qhull leaves out those
  // with too few vertices. They tell where the directions of unbounded cells end.
  std::vector<std::array<Vertex, 2>> neighbors = {};
  std::vector<ListedCell> ridges = {};  // of each of these pairs by its ends, if they are listed
};

// A box that is not flat, in which cells are compared.
struct JudgedBox {
  Point low, high;
};

// That of the sites, enlarged on each side by half its longest edge; by 1 if there is one site.
// Requires: there is one.
inline JudgedBox default_box(const PointSet& sites) {
  JudgedBox box{sites[0], sites[0]};
  for (const Point& site : sites.points()) {
    for (std::size_t axis = 0; axis < site.size(); ++axis) {
      box.low[axis] = std::min(box.low[axis], site[axis]);
      box.high[axis] = std::max(box.high[axis], site[axis]);
    }
  }
  Rational longest = 0;
  for (const Rational& edge : box.high - box.low) longest = std::max(longest, edge);
  const Rational margin = sign(longest) == 0 ? Rational(1) : Rational(longest / 2);
  for (Rational& x : box.low) x -= margin;
  for (Rational& x : box.high) x += margin;
  return box;
}

}  // namespace circumspect
