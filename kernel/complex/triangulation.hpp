// A triangulation as a set of simplices. Book: Definition 2.1, Section 4.1.
#pragma once

#include <map>
#include <vector>

#include "kernel/complex/simplex.hpp"

namespace circumspect {

// A k-dimensional triangulation, given by its k-simplices: each with its vertices ascending, the
// simplices in lexicographic order, so that two triangulations are the same set of simplices iff
// they compare equal. The lower-dimensional simplices are the faces of these.
class Triangulation {
 public:
  // Requires: every simplex has dimension + 1 distinct vertices; no simplex twice. Dimension −1,
  // without simplices, is the triangulation of the empty set.
  Triangulation(int dimension, std::vector<Simplex> simplices);

  int dimension() const { return dimension_; }
  const std::vector<Simplex>& simplices() const { return simplices_; }
  bool operator==(const Triangulation&) const = default;

  bool has(const Simplex& simplex) const;

 private:
  int dimension_;
  std::vector<Simplex> simplices_;
};

// Facet look-up: for each facet (ascending vertices) the vertices opposite to it, one for each
// simplex that has it. In a triangulation one (on the hull) or two.
std::map<Simplex, std::vector<Vertex>> apexes_by_facet(const Triangulation& triangulation);

}  // namespace circumspect
