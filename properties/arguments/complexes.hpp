// Random piecewise linear complexes for properties. A failing one shrinks by dropping cells and
// vertices, and by moving vertices towards small integers.
#pragma once

#include <cstddef>

#include "inputs/complexes.hpp"
#include "properties/arguments/point_sets.hpp"

namespace circumspect::generators {

using Complexes = rc::Gen<ComplexCase>;

// Of one of the families of inputs/complexes.hpp, with point sets generic and degenerate, at most
// `max_points` of them where the family leaves a choice: in space, and in the plane.
Complexes any_complex(std::size_t max_points);
Complexes planar_complexes(std::size_t max_points);

// Cells scattered among points of a plane, of a grid or of a cube: many of them in one plane.
Complexes flat_cells(std::size_t max_points);

}  // namespace circumspect::generators

namespace circumspect::properties {

// Any of those of inputs/triangulated/protected_complexes.hpp, which have a CDT.
generators::Complexes any_protected_complex(std::size_t max_points);

}  // namespace circumspect::properties
