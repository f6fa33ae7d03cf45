// The step of gift-wrapping a CDT that finds the simplex in front of a facet, and the obstacles
// that must not reach into that simplex. Book: Section 5.6 (in the plane Section 3.11, Finish),
// Section 4.5.2 (a simplex of a CDT respects the PLC).
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/piecewise_linear/cell_boxes.hpp"

namespace circumspect::constrained {

// Does the interior of the k-simplex contain a point of the (closed) (k−1)-simplex `facet`, k = 2
// or 3, on these axes? (It may be a simplex of lower dimension, too.) Clips the facet by the
// halfspaces of the simplex; a mean of the corners of what is left lies in the interior if any
// point of the facet does.
// Requires: neither is degenerate on the axes.
bool meets_interior(const PointSet& points, std::span<const std::size_t> axes,
                    const Simplex& simplex, const Simplex& facet);

// Some simplices of dimension 0 to k − 1 that must not reach into simplices of dimension k = 2 or
// 3; a simplex is clear if none does.
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

struct InFront {
  bool has_candidates = false;  // is any strictly in front of the facet?
  std::optional<Vertex> apex;   // the first candidate that counts
};

// The first candidate that counts, in the (perturbed) pencil of spheres through a facet, among
// those strictly in front of it: its simplex with the facet, positively oriented, must be clear of
// the constraints. The book scans the vertices, keeps the first that is visible and replaces it by
// any later one that is visible and in the ball; taking them in the order of the pencil tests
// fewer.
//
// Clear instead of visible: the first that is clear is right if there is a CDT that has the facet.
// Its simplex in front of the facet is clear, and any other clear apex is visible from the facet.
InFront first_clear_apex(const PointSet& points, const std::vector<std::size_t>& axes,
                         const OrientedFacet& facet, const std::vector<Vertex>& candidates,
                         const std::function<bool(const Simplex&)>& is_clear);

}  // namespace circumspect::constrained
