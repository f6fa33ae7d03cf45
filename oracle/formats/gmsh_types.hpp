// The types of elements in Gmsh's .msh, by their numbers.
#pragma once

#include <array>

#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

inline constexpr std::array kGmshTypes = {
    ElementType{15, 1, ElementShape::kPoint, "a point"},
    ElementType{1, 2, ElementShape::kPolyline, "an edge"},
    ElementType{2, 3, ElementShape::kPolygon, "a triangle"},
    ElementType{3, 4, ElementShape::kPolygon, "a quadrilateral"},
    ElementType{4, 4, ElementShape::kTetrahedron, "a tetrahedron"},
    ElementType{5, 8, ElementShape::kOtherSolid, "a hexahedron"},
    ElementType{6, 6, ElementShape::kOtherSolid, "a prism"},
    ElementType{7, 5, ElementShape::kOtherSolid, "a pyramid"},
    ElementType{8, 3, ElementShape::kCurvedEdge, "an edge of second order"},
    ElementType{9, 6, ElementShape::kCurvedTriangle, "a triangle of second order"},
    ElementType{10, 9, ElementShape::kCurved, "a quadrilateral of second order"},
    ElementType{11, 10, ElementShape::kCurvedTetrahedron, "a tetrahedron of second order"},
    ElementType{12, 27, ElementShape::kCurved, "a hexahedron of second order"},
    ElementType{13, 18, ElementShape::kCurved, "a prism of second order"},
    ElementType{14, 14, ElementShape::kCurved, "a pyramid of second order"},
    ElementType{16, 8, ElementShape::kCurved, "a quadrilateral of second order"},
    ElementType{17, 20, ElementShape::kCurved, "a hexahedron of second order"},
    ElementType{18, 15, ElementShape::kCurved, "a prism of second order"},
    ElementType{19, 13, ElementShape::kCurved, "a pyramid of second order"},
    ElementType{20, 9, ElementShape::kCurvedTriangle, "a triangle of third order"},
    ElementType{21, 10, ElementShape::kCurvedTriangle, "a triangle of third order"},
    ElementType{22, 12, ElementShape::kCurvedTriangle, "a triangle of fourth order"},
    ElementType{23, 15, ElementShape::kCurvedTriangle, "a triangle of fourth order"},
    ElementType{24, 15, ElementShape::kCurvedTriangle, "a triangle of fifth order"},
    ElementType{25, 21, ElementShape::kCurvedTriangle, "a triangle of fifth order"},
    ElementType{26, 4, ElementShape::kCurvedEdge, "an edge of third order"},
    ElementType{27, 5, ElementShape::kCurvedEdge, "an edge of fourth order"},
    ElementType{28, 6, ElementShape::kCurvedEdge, "an edge of fifth order"},
    ElementType{29, 20, ElementShape::kCurvedTetrahedron, "a tetrahedron of third order"},
    ElementType{30, 35, ElementShape::kCurvedTetrahedron, "a tetrahedron of fourth order"},
    ElementType{31, 56, ElementShape::kCurvedTetrahedron, "a tetrahedron of fifth order"},
};

// Its manual ends at 93, its sources at 140: elements of yet higher order, polygons, parts of
// elements.
inline constexpr Vertex kLastGmshType = 140;

}  // namespace circumspect::formats
