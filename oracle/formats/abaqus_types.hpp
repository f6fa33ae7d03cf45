// The types of elements of Abaqus and CalculiX.
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

// A shape of elements, and how many nodes one of them lists.
struct AbaqusShape {
  std::size_t nodes;
  ElementShape shape;
  std::string_view words;
};
inline constexpr AbaqusShape kAbaqusTetrahedron = {4, ElementShape::kTetrahedron, "a tetrahedron"};
inline constexpr AbaqusShape kAbaqusTetrahedron10 = {10, ElementShape::kCurvedTetrahedron,
                                                     "a tetrahedron of second order"};
inline constexpr AbaqusShape kAbaqusPyramid = {5, ElementShape::kOtherSolid, "a pyramid"};
inline constexpr AbaqusShape kAbaqusPrism = {6, ElementShape::kOtherSolid, "a prism"};
inline constexpr AbaqusShape kAbaqusPrism15 = {15, ElementShape::kCurved,
                                               "a prism of second order"};
inline constexpr AbaqusShape kAbaqusHexahedron = {8, ElementShape::kOtherSolid, "a hexahedron"};
inline constexpr AbaqusShape kAbaqusHexahedron20 = {20, ElementShape::kCurved,
                                                    "a hexahedron of second order"};
inline constexpr AbaqusShape kAbaqusTriangle = {3, ElementShape::kPolygon, "a triangle"};
inline constexpr AbaqusShape kAbaqusTriangle6 = {6, ElementShape::kCurvedTriangle,
                                                 "a triangle of second order"};
inline constexpr AbaqusShape kAbaqusQuadrilateral = {4, ElementShape::kPolygon, "a quadrilateral"};
inline constexpr AbaqusShape kAbaqusQuadrilateral8 = {8, ElementShape::kCurved,
                                                      "a quadrilateral of second order"};
inline constexpr AbaqusShape kAbaqusQuadrilateral9 = {9, ElementShape::kCurved,
                                                      "a quadrilateral of second order"};
inline constexpr AbaqusShape kAbaqusEdge = {2, ElementShape::kPolyline, "an edge"};
inline constexpr AbaqusShape kAbaqusEdge3 = {3, ElementShape::kCurvedEdge,
                                             "an edge of second order"};
// Masses, and what joins nodes but has no shape of its own: springs, gaps, couplings, networks.
inline constexpr AbaqusShape kAbaqusNoShape = {0, ElementShape::kPoint, "no shape"};

// Types by what their names begin with: the letters that follow (R: reduced integration, H: hybrid,
// …) say nothing about the shape. No two of them begin one name. F3D4 is not among them: it is a
// tetrahedron to CalculiX, and a quadrilateral to Abaqus.
struct AbaqusType {
  std::string_view name;
  AbaqusShape shape;
};
inline constexpr std::array kAbaqusTypes = {
    AbaqusType{"C3D4", kAbaqusTetrahedron},
    AbaqusType{"C3D5", kAbaqusPyramid},
    AbaqusType{"C3D6", kAbaqusPrism},
    AbaqusType{"C3D8", kAbaqusHexahedron},
    AbaqusType{"C3D10", kAbaqusTetrahedron10},
    AbaqusType{"C3D15", kAbaqusPrism15},
    AbaqusType{"C3D20", kAbaqusHexahedron20},
    AbaqusType{"AC3D4", kAbaqusTetrahedron},
    AbaqusType{"AC3D6", kAbaqusPrism},
    AbaqusType{"AC3D8", kAbaqusHexahedron},
    AbaqusType{"AC3D10", kAbaqusTetrahedron10},
    AbaqusType{"AC3D15", kAbaqusPrism15},
    AbaqusType{"AC3D20", kAbaqusHexahedron20},
    AbaqusType{"DC3D4", kAbaqusTetrahedron},
    AbaqusType{"DC3D6", kAbaqusPrism},
    AbaqusType{"DC3D8", kAbaqusHexahedron},
    AbaqusType{"DC3D10", kAbaqusTetrahedron10},
    AbaqusType{"DC3D15", kAbaqusPrism15},
    AbaqusType{"DC3D20", kAbaqusHexahedron20},
    AbaqusType{"EC3D8", kAbaqusHexahedron},
    AbaqusType{"FC3D4", kAbaqusTetrahedron},
    AbaqusType{"FC3D5", kAbaqusPyramid},
    AbaqusType{"FC3D6", kAbaqusPrism},
    AbaqusType{"FC3D8", kAbaqusHexahedron},
    AbaqusType{"F3D6", kAbaqusPrism},
    AbaqusType{"F3D8", kAbaqusHexahedron},
    AbaqusType{"COH3D6", kAbaqusPrism},
    AbaqusType{"COH3D8", kAbaqusHexahedron},
    AbaqusType{"SC6", kAbaqusPrism},
    AbaqusType{"SC8", kAbaqusHexahedron},
    AbaqusType{"CPS3", kAbaqusTriangle},
    AbaqusType{"CPE3", kAbaqusTriangle},
    AbaqusType{"CAX3", kAbaqusTriangle},
    AbaqusType{"AC2D3", kAbaqusTriangle},
    AbaqusType{"ACAX3", kAbaqusTriangle},
    AbaqusType{"DC2D3", kAbaqusTriangle},
    AbaqusType{"DCAX3", kAbaqusTriangle},
    AbaqusType{"DS3", kAbaqusTriangle},
    AbaqusType{"S3", kAbaqusTriangle},
    AbaqusType{"US3", kAbaqusTriangle},
    AbaqusType{"STRI3", kAbaqusTriangle},
    AbaqusType{"M3D3", kAbaqusTriangle},
    AbaqusType{"R3D3", kAbaqusTriangle},
    AbaqusType{"SFM3D3", kAbaqusTriangle},
    AbaqusType{"CPS6", kAbaqusTriangle6},
    AbaqusType{"CPE6", kAbaqusTriangle6},
    AbaqusType{"CAX6", kAbaqusTriangle6},
    AbaqusType{"DC2D6", kAbaqusTriangle6},
    AbaqusType{"DCAX6", kAbaqusTriangle6},
    AbaqusType{"STRI65", kAbaqusTriangle6},
    AbaqusType{"S6", kAbaqusTriangle6},
    AbaqusType{"M3D6", kAbaqusTriangle6},
    AbaqusType{"CPS4", kAbaqusQuadrilateral},
    AbaqusType{"CPE4", kAbaqusQuadrilateral},
    AbaqusType{"CAX4", kAbaqusQuadrilateral},
    AbaqusType{"AC2D4", kAbaqusQuadrilateral},
    AbaqusType{"ACAX4", kAbaqusQuadrilateral},
    AbaqusType{"COH2D4", kAbaqusQuadrilateral},
    AbaqusType{"COHAX4", kAbaqusQuadrilateral},
    AbaqusType{"DC2D4", kAbaqusQuadrilateral},
    AbaqusType{"DCAX4", kAbaqusQuadrilateral},
    AbaqusType{"DS4", kAbaqusQuadrilateral},
    AbaqusType{"S4", kAbaqusQuadrilateral},
    AbaqusType{"M3D4", kAbaqusQuadrilateral},
    AbaqusType{"R3D4", kAbaqusQuadrilateral},
    AbaqusType{"SFM3D4", kAbaqusQuadrilateral},
    AbaqusType{"CPS8", kAbaqusQuadrilateral8},
    AbaqusType{"CPE8", kAbaqusQuadrilateral8},
    AbaqusType{"CAX8", kAbaqusQuadrilateral8},
    AbaqusType{"DC2D8", kAbaqusQuadrilateral8},
    AbaqusType{"DCAX8", kAbaqusQuadrilateral8},
    AbaqusType{"DS8", kAbaqusQuadrilateral8},
    AbaqusType{"S8", kAbaqusQuadrilateral8},
    AbaqusType{"M3D8", kAbaqusQuadrilateral8},
    AbaqusType{"S9", kAbaqusQuadrilateral9},
    AbaqusType{"T2D2", kAbaqusEdge},
    AbaqusType{"T3D2", kAbaqusEdge},
    AbaqusType{"B21", kAbaqusEdge},
    AbaqusType{"B23", kAbaqusEdge},
    AbaqusType{"B31", kAbaqusEdge},
    AbaqusType{"B33", kAbaqusEdge},
    AbaqusType{"PIPE21", kAbaqusEdge},
    AbaqusType{"PIPE31", kAbaqusEdge},
    AbaqusType{"R2D2", kAbaqusEdge},
    AbaqusType{"RAX2", kAbaqusEdge},
    AbaqusType{"SAX1", kAbaqusEdge},
    AbaqusType{"T2D3", kAbaqusEdge3},
    AbaqusType{"T3D3", kAbaqusEdge3},
    AbaqusType{"B22", kAbaqusEdge3},
    AbaqusType{"B32", kAbaqusEdge3},
    AbaqusType{"PIPE22", kAbaqusEdge3},
    AbaqusType{"PIPE32", kAbaqusEdge3},
    AbaqusType{"SAX2", kAbaqusEdge3},
    AbaqusType{"CONN", kAbaqusNoShape},
    AbaqusType{"DASHPOT", kAbaqusNoShape},
    AbaqusType{"DCOUP", kAbaqusNoShape},
    AbaqusType{"GAP", kAbaqusNoShape},
    AbaqusType{"HEATCAP", kAbaqusNoShape},
    AbaqusType{"MASS", kAbaqusNoShape},
    AbaqusType{"ROTARY", kAbaqusNoShape},
    AbaqusType{"SPRING", kAbaqusNoShape},
};

// The shape of a type, by its name in capitals; null if the type is not known.
inline const AbaqusShape* abaqus_shape_of(std::string_view name) {
  if (name == "D") return &kAbaqusNoShape;  // of CalculiX's networks, and the whole of their name
  const auto* const found =
      std::find_if(kAbaqusTypes.begin(), kAbaqusTypes.end(), [&](const AbaqusType& type) {
        if (!name.starts_with(type.name)) return false;
        if (type.shape.nodes == 0) return true;  // DCOUP3D, CONN3D2, SPRING1
        // "C3D10" is no "C3D1" with something behind it.
        const std::string_view behind = name.substr(type.name.size());
        return behind.empty() || std::isdigit(static_cast<unsigned char>(behind.front())) == 0;
      });
  return found == kAbaqusTypes.end() ? nullptr : &found->shape;
}

}  // namespace circumspect::formats
