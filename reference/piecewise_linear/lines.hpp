// What the lines of a polygon list.
#pragma once

#include <set>

#include "reference/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect {

// A line stands for its edges, each once however often it is passed, and for its vertices.
std::set<Simplex> edges_of(const PolygonLines& polygon);
std::vector<Vertex> vertices_of(const PolygonLines& polygon);  // ascending

// The segments of all that is handed in: ascending pairs, each once, in lexicographic order.
std::vector<Simplex> segments_of(const PiecewiseLinearInput& input);

}  // namespace circumspect
