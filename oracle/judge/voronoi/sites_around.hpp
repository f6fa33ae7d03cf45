// The Voronoi cells of sites within a box, each by the sites around it.
#pragma once

#include <optional>
#include <vector>

#include "kernel/boxes/box_index.hpp"
#include "oracle/model/voronoi_diagram.hpp"

namespace circumspect::check {

class SitesAround {
 public:
  // Requires: both outlive this object; two or three coordinates.
  SitesAround(const PointSet& sites, const JudgedBox& box);

  // The answer of definition::exact_corners. A site that is more than twice as far away as the
  // farthest corner cuts nothing: x is nearer to it only if |x − site| > |site − other| / 2.
  std::vector<Point> corners_of_cell(Vertex site) const;

 private:
  const PointSet& sites_;
  const JudgedBox& box_;
  BoxIndex index_;
  Rational first_reach_;
};

}  // namespace circumspect::check
