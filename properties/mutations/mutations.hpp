// Ways to break a mesh.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include <rapidcheck.h>

#include "oracle/model/exact_mesh.hpp"

namespace circumspect::properties {

using Simplices = std::vector<Simplex>;

// A broken list of simplices, and what was done to it.
struct Mutant {
  std::string what;
  Simplices simplices;
};
std::ostream& operator<<(std::ostream& out, const Mutant& mutant);

// Mutations after which the list cannot be a triangulation of the points, whatever it was: one
// index of one simplex changed, to any other value; a simplex dropped, listed twice, or replaced by
// another set of points; one point merged into another. Requires: a triangulation with at least one
// simplex, of `points` ≥ 2 points.
rc::Gen<Mutant> corruption(const Simplices& simplices, std::size_t points);

// Mutations after which it may be one or not: the two simplices of a facet flipped, in the plane
// for the other two triangles and in space for three tetrahedra around the edge between the apexes;
// two vertices exchanged all over, or between two simplices; two corruptions at once. Requires: the
// same.
rc::Gen<Mutant> alteration(const Simplices& simplices, std::size_t points);

}  // namespace circumspect::properties
