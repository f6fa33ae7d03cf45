// Generated inputs, printed so that a failing case can be pasted into a file.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

#include <circumspect/subject.hpp>

#include "kernel/exact/point.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect::generators {

// A generated point set, printed so that a failing case can be pasted into a file.

struct PointsCase {
  std::vector<Point> points;
  std::vector<Rational> weights = {};  // empty, or one for each point
};

// The points at these places, with their weights.
PointsCase chosen(const PointsCase& set, const std::vector<std::size_t>& places);

// As a `.node` file with exact rationals; the weights are its attribute.
std::ostream& operator<<(std::ostream& out, const PointsCase& set);

// Generated sets as arrays of doubles, for programs under test, and back.

// Each number rounded to the nearest double: call in_doubles first, so that what the program sees
// is what is judged. `dimension`: that of an empty set, which has no points that tell it.
PointArray array(const PointsCase& set, std::size_t dimension = 3);

// The exact values. Requires: all numbers are finite; coordinates.size() is a multiple of
// dimension; weights are none or one a point.
PointsCase from(const PointArray& points);

// A generated piecewise linear complex, printed so that a failing case can be pasted into a file.

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

// Removes some vertices and renumbers the others. Requires: no cell uses the removed ones.
void drop_points(PiecewiseLinearInput& input, const std::vector<bool>& dropped);

}  // namespace circumspect::generators
