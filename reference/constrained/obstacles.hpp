// What may not reach into a simplex of a constrained triangulation. Book: Section 4.5.2 (a simplex of a
// CDT respects the PLC).
#pragma once

#include <optional>
#include <vector>

#include "reference/complex/point_set.hpp"
#include "reference/piecewise_linear/cell_boxes.hpp"

namespace circumspect::constrained {

// Some simplices of dimension 0 to k − 1, for simplices of dimension k = 2 or 3 to be clear of.
class Obstacles {
 public:
  // On these k axes. Refers to the points. Requires: no simplex is degenerate on the axes.
  Obstacles(const PointSet& points, std::vector<std::size_t> axes, std::vector<Simplex> obstacles);

  // The first obstacle that has a point in the interior of the k-simplex; nothing if it is clear.
  // Requires: the simplex is not degenerate on the axes.
  std::optional<Simplex> inside(const Simplex& simplex) const;
  bool is_clear(const Simplex& simplex) const { return !inside(simplex).has_value(); }

 private:
  const PointSet& points_;
  std::vector<std::size_t> axes_;
  std::vector<Simplex> obstacles_;
  CellBoxes boxes_;
  BoxIndex index_;
};

}  // namespace circumspect::constrained
