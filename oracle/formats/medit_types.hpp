// The sections of elements in Medit's files: their keywords as text, and their codes in binary.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

struct MeditSection {
  std::string_view keyword;
  std::uint64_t code;  // 0: a spelling that occurs in text alone
  std::size_t vertices;
  ElementShape shape;
  std::string_view noun;  // of one, without its article
  std::string_view article = "a";
};
inline constexpr std::array kMeditSections = {
    MeditSection{"Edges", 5, 2, ElementShape::kPolyline, "edge", "an"},
    MeditSection{"Triangles", 6, 3, ElementShape::kPolygon, "triangle"},
    MeditSection{"Quadrilaterals", 7, 4, ElementShape::kPolygon, "quadrilateral"},
    MeditSection{"Tetrahedra", 8, 4, ElementShape::kTetrahedron, "tetrahedron"},
    MeditSection{"Hexahedra", 10, 8, ElementShape::kOtherSolid, "hexahedron"},
    MeditSection{"Hexaedra", 0, 8, ElementShape::kOtherSolid, "hexahedron"},
    MeditSection{"Prisms", 9, 6, ElementShape::kOtherSolid, "prism"},
    MeditSection{"Pentahedra", 0, 6, ElementShape::kOtherSolid, "prism"},
    MeditSection{"Pyramids", 49, 5, ElementShape::kOtherSolid, "pyramid"},
};

}  // namespace circumspect::formats
