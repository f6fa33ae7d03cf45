// The facets of cells that a lattice repeats: two facets are one if the lattice moves one to the
// other.
#pragma once

#include <vector>

#include "oracle/model/periodic.hpp"

namespace circumspect {

// A listed point and the multiples of the vectors by which it is moved.
struct MovedPoint {
  Vertex point;
  Simplex offset;
  auto operator<=>(const MovedPoint&) const = default;
};
using PeriodicCell = std::vector<MovedPoint>;

Simplex sum(const Simplex& a, const Simplex& b);
Simplex difference(const Simplex& a, const Simplex& b);

// Where a facet is: opposite a corner of a cell, and how far from where `facet` has its first
// vertex.
struct FacetPlace {
  PeriodicCell facet;  // ascending, the first without an offset
  std::size_t cell;
  std::size_t opposite;
  Simplex moved;
};

// All of them, by facet and then by cell.
// Requires: cells of two corners or more, no two of them the same.
std::vector<FacetPlace> facet_places(const std::vector<PeriodicCell>& cells);

}  // namespace circumspect
