// The rows of causes.cpp: each finds one cause, checks it, and says it. Nothing if it is not one.
#pragma once

#include <optional>

#include "oracle/judge/cause/case.hpp"

namespace circumspect::check {

// The mesh is mended, and judged again.
std::optional<Cause> missing_simplices(Case& of);
std::optional<Cause> indices_begin_elsewhere(Case& of);
std::optional<Cause> last_column_is_a_label(Case& of);
std::optional<Cause> last_coordinate_is_none(Case& of);
std::optional<Cause> near_points(Case& of);

// The mesh without the copies is judged, if that takes little time.
std::optional<Cause> listed_twice(Case& of);

// The count is verified.
std::optional<Cause> too_few_points(Case& of);
std::optional<Cause> one_vertex(Case& of);
std::optional<Cause> other_points(Case& of);
std::optional<Cause> turned_simplices(Case& of);

// What is listed beside the simplices is looked up among their faces again.
std::optional<Cause> faces_begin_elsewhere(Case& of);

// What the claim `complex` says of the mesh is asked.
std::optional<Cause> equal_points_of_parts(Case& of);
std::optional<Cause> hanging_vertices(Case& of);
std::optional<Cause> crossed_diagonals(Case& of);
std::optional<Cause> parts_in_each_other(Case& of);

// The claim `complex` alone knows of points that no simplex has to use.
std::optional<Cause> left_over_points(Case& of);

// The sides of the cracks are joined, and the edges around holes followed.
std::optional<Cause> cracks(Case& of);
std::optional<Cause> holes_of_surface(Case& of);

// A walk through the edges of a surface counts them.
std::optional<Cause> turned_triangles(Case& of);

// The simplices beside the vertices are cut, and their facets compared.
std::optional<Cause> vertices_beside_faces(Case& of);

}  // namespace circumspect::check
