// A generated piecewise linear complex, printed so that a failing case can be pasted into a file.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "reference/kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect::generators {

// A valid input and the family it comes from.
struct ComplexCase {
  std::string family;
  PiecewiseLinearInput input;

  PiecewiseLinearComplex complex() const { return assemble(input); }
};

// As a .poly file counted from 0, with exact rationals. In space a lone segment is a facet of one
// line with two corners.
std::ostream& operator<<(std::ostream& out, const ComplexCase& value);

// Cells that are added together or not at all.
struct Cells {
  std::vector<std::vector<Vertex>> segments;
  std::vector<PolygonLines> polygons;
};

// The closed line through some vertices as a polygon without holes.
PolygonLines polygon_along(std::vector<Vertex> line);

// Adds the cells if the input remains valid; says whether it has. Requires: the input is valid.
bool add_if_valid(PiecewiseLinearInput& input, const Cells& cells);

// Whether any segment or polygon has a vertex for a corner, for each vertex.
std::vector<bool> is_used(const PiecewiseLinearInput& input);

// Takes some vertices out and numbers the others anew. Requires: no cell uses them.
void drop_points(PiecewiseLinearInput& input, const std::vector<bool>& dropped);

}  // namespace circumspect::generators
