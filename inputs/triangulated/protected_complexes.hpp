// Random piecewise linear complexes made of edges of a Delaunay triangulation: edge-protected, so
// that they have a CDT. Book: Section 4.5.3, Theorem 4.9 (the CDT Theorem).
#pragma once

#include <vector>

#include "inputs/cases.hpp"
#include "inputs/dice.hpp"

namespace circumspect::properties {

// The two readings of "edge-protected". "If the symbolic perturbations … are used to make the
// vertices … generic, then every Delaunay edge is strongly Delaunay": the segments are edges of the
// canonical Delaunay triangulation. Without perturbation, each has a closed circumball that
// contains no other vertex.
enum class Protection { kCanonical, kStrong };

// Triangles of three edges of the Delaunay triangulation, seldom facets of it, and quadrilaterals
// of four coplanar ones, as long as they do not cross; other edges as lone segments, which may be
// slits. The kind is hull, with dangling and isolated cells.
generators::ComplexCase protected_polygons(generators::Dice& dice, std::vector<Point> points,
                                           Protection protection = Protection::kCanonical);

// The domain enclosed by tetrahedra whose six edges are edges of the Delaunay triangulation; seldom
// are these tetrahedra in it. There are also dangling polygons and lone segments. The tetrahedra
// share facets, edges, vertices or nothing; coplanar facets may be merged into one polygon.
generators::ComplexCase protected_solid(generators::Dice& dice, std::vector<Point> points,
                                        Protection protection = Protection::kCanonical);

// The hull, or a face-connected union of tetrahedra of the canonical Delaunay triangulation: convex
// or not, with or without cavities, pinched at edges or vertices. All or some coplanar boundary
// facets that are joined across edges become one polygon, which may have holes and may touch
// itself.
generators::ComplexCase delaunay_polyhedron(generators::Dice& dice, std::vector<Point> points);

}  // namespace circumspect::properties
