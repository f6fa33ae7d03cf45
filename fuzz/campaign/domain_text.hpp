// Writes domains in the formats that mesh generators read.
#pragma once

#include <optional>
#include <string>

#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect::campaign {

// As a .poly file: of Triangle in the plane, of TetGen in space, where a lone segment is a facet
// with one polygon of two corners. A facet lists all cells that lie in it, as TetGen requires, if
// the domain is valid: segments as polygons of two corners, vertices as polygons of one.
std::string poly_text(const PiecewiseLinearInput& input, Vertex first_index);

// As text for workers (docs/workers.md): six counts, the points, the segments, the facets as in
// .poly, and the hole seeds.
std::string case_text(const PiecewiseLinearInput& input, std::size_t dimension);

// As a .geo file for Gmsh, in space: the polygons are the surfaces of one volume; segments are one
// element long. Nothing for domains that the format cannot express: planar ones, polygons of more
// than one line or of one that passes a vertex again, polygons that are not closed up edge to edge
// (each edge in exactly two), segments that are not edges, isolated vertices, hole seeds.
std::optional<std::string> geo_text(const PiecewiseLinearInput& input);

// A surface in space as .off, .obj or .ply, or as .stl or .msh (Gmsh's 2.2) if all polygons are
// triangles. Nothing for domains that the format cannot express: planar ones, polygons of more than
// one line, segments that are not edges, isolated vertices, hole seeds.
bool is_surface_extension(const std::string& extension);
std::optional<std::string> surface_text(const PiecewiseLinearInput& input,
                                        const std::string& extension);

}  // namespace circumspect::campaign
