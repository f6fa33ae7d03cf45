// The input of a program under test: points, points with updates, or a domain; and the text of its
// file.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>

#include "inputs/cases.hpp"
#include "inputs/modifiers.hpp"
#include "inputs/relations.hpp"
#include "inputs/updates.hpp"
#include "kernel/complex/simplex.hpp"

namespace circumspect::campaign {

using generators::ComplexCase;
using generators::PointsCase;

using generators::UpdatesCase;

using Input = std::variant<PointsCase, UpdatesCase, ComplexCase>;

// All points that are present at some time.
std::size_t point_count(const Input& input);

// The points whose mesh is judged: for a sequence of updates, the last ones. Null: a domain.
std::optional<PointsCase> judged_points(const Input& input);

// The input under a relation; nothing if there is no such image. Numbers within kOrdinary stay
// within it.
std::optional<Input> image_of(generators::Relation relation, const Input& input);

// The range of numbers for which programs may be held to all their promises.
inline constexpr generators::Exponents kOrdinary = {-100, 100};

// Are all coordinates, weights and seeds doubles, so that a program reads what is judged?
bool is_of_doubles(const Input& input);

// The extensions of the files that inputs can be written to: ".node .qhull .off .json .xyz .case"
// for points, ".case" for those that come and go, ".poly .geo .off .stl .ply .obj .msh .case" for
// domains.
bool is_points_extension(const std::string& extension);
bool is_domain_extension(const std::string& extension);

// The text of such a file. The points are counted from `first_index` if the format leaves the
// choice.
//
//   .node, .qhull, .off, .json   as oracle/formats writes them
//   .xyz                         a line of coordinates a point, and its weight, if there are any
//   .case                        what workers read, docs/workers.md; counted from 0
//                                (of points that come and go, .node and the like hold the last)
//   .poly                        of Triangle in the plane, of TetGen in space
//   .geo                         Gmsh's: the surface of one volume (in the plane: one surface,
//                                outlined by the first closed line), each segment one element long
//   .off, .obj, .ply             a surface in space, a face a polygon
//   .stl, .msh                   the same of triangles alone; .msh is Gmsh's 2.2
//
// Numbers are the shortest decimals of their doubles. `dimension` is that of an empty set.
// Requires: an extension for this kind of input. Returns nothing if the format cannot express the
// input (.geo and surfaces: polygons with slits or holes, dangling cells, several surfaces, hole
// seeds).
std::optional<std::string> file_text(const Input& input, const std::string& extension,
                                     Vertex first_index, std::size_t dimension);

// The points and updates of a .case file that was written in this way; nothing if the text is not
// such a file.
std::optional<UpdatesCase> read_updates(const std::string& text);

}  // namespace circumspect::campaign
