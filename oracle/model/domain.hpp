// The domain that a mesh must fill, as a user gives it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "kernel/piecewise_linear/regions.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace circumspect {

// A bound on the area, or the volume, of the elements in one region.
struct RegionBound {
  Point seed;  // in the region
  Rational most;
};

// A valid piecewise linear complex, and the user's names for its parts. A mesh has its own indices:
// vertices of mesh and domain are matched by their coordinates.
struct Domain {
  PiecewiseLinearComplex complex;
  std::vector<Vertex> labels = {};              // of its vertices; empty: the index itself
  Vertex first_index = 0;                       // the user's index of the first vertex
  std::vector<std::string> polygon_names = {};  // "3 (line 17)"; empty: counted from 1
  std::vector<RegionBound> region_bounds = {};
  // The regions of the complex, if they have been found already; a change of the complex must reset
  // them.
  std::optional<Regions> known_regions = {};

  Regions regions() const { return known_regions ? *known_regions : Regions(complex); }
  // The user's own index of a vertex.
  Vertex label(Vertex v) const {
    return labels.empty() ? index_of_place(v, first_index) : labels[static_cast<std::size_t>(v)];
  }
  std::string polygon_name(std::size_t polygon) const {
    return polygon_names.empty() ? std::to_string(polygon + 1) : polygon_names[polygon];
  }
};

}  // namespace circumspect
