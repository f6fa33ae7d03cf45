// Cells of a domain that a mesh lacks, whatever was rounded.
#pragma once

#include <span>
#include <vector>

#include "kernel/piecewise_linear/linear_cell.hpp"
#include "oracle/judge/within/distance.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::check {

// Looks at one cell after another, so a few of them take much less time than the search for a
// reach, which looks at all. docs/theory/within.md, "Cells without an image".
class WithoutImage {
 public:
  // Both must outlive this. Requires: not a convex hull.
  WithoutImage(const Mesh& mesh, const PiecewiseLinearComplex& complex,
               const Rational& squared_distance);

  // True only if the cell has no image at any reach up to the distance; false says nothing.
  bool certainly(LinearCell cell) const;

 private:
  // The points of the mesh, ascending, that may be so near to one of some simplices of the domain.
  std::vector<Vertex> near(const std::vector<Simplex>& simplices) const;
  std::vector<RoundedPoint> corners(const Simplex& simplex) const;
  bool lacks_path(const Simplex& segment) const;
  bool lacks_patch(const Polygon& polygon) const;

  const Mesh& mesh_;
  const PiecewiseLinearComplex& complex_;
  Rounding rounding_;
  double distance_;
  std::vector<RoundedPoint> points_;
};

}  // namespace circumspect::check
