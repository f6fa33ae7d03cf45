// A box from which halfspaces cut more and more: the Voronoi cell of a site within a box.
#pragma once

#include <vector>

#include "oracle/judge/definition/voronoi.hpp"

namespace circumspect::check {

// Its corners, each with the halfspaces on whose boundary it is. A corner is added where an edge is
// cut, and two corners have a common edge if no third is on all boundaries that both are on
// (T. Motzkin et al., "The double description method", 1953).
class ClippedCell {
 public:
  explicit ClippedCell(const JudgedBox& box);

  void cut(const definition::Halfspace& half);
  std::vector<Point> corners() const;
  // Of the corner that is farthest from the point; 0 if there is none.
  Rational largest_squared_distance(const Point& from) const;

 private:
  struct Corner {
    Point point;
    std::vector<std::size_t> boundaries;  // ascending
  };

  bool have_common_edge(const Corner& a, const Corner& b) const;

  std::vector<Corner> corners_;
  std::size_t halves_ = 0;
};

}  // namespace circumspect::check
