#include "oracle/formats/gmsh_types.hpp"

#include <algorithm>
#include <array>

namespace circumspect::formats {
namespace {

// Gmsh's types of elements: what has no shape here is curved.
constexpr std::array kGmshTypes = {
    ElementType{15, 1, ElementShape::kPoint, "a point"},
    ElementType{1, 2, ElementShape::kPolyline, "an edge"},
    ElementType{2, 3, ElementShape::kPolygon, "a triangle"},
    ElementType{3, 4, ElementShape::kPolygon, "a quadrilateral"},
    ElementType{4, 4, ElementShape::kTetrahedron, "a tetrahedron"},
    ElementType{5, 8, ElementShape::kOtherSolid, "a hexahedron"},
    ElementType{6, 6, ElementShape::kOtherSolid, "a prism"},
    ElementType{7, 5, ElementShape::kOtherSolid, "a pyramid"},
    ElementType{8, 3, ElementShape::kCurved, "an edge of second order"},
    ElementType{9, 6, ElementShape::kCurved, "a triangle of second order"},
    ElementType{10, 9, ElementShape::kCurved, "a quadrilateral of second order"},
    ElementType{11, 10, ElementShape::kCurved, "a tetrahedron of second order"},
    ElementType{12, 27, ElementShape::kCurved, "a hexahedron of second order"},
    ElementType{13, 18, ElementShape::kCurved, "a prism of second order"},
    ElementType{14, 14, ElementShape::kCurved, "a pyramid of second order"},
    ElementType{16, 8, ElementShape::kCurved, "a quadrilateral of second order"},
    ElementType{17, 20, ElementShape::kCurved, "a hexahedron of second order"},
    ElementType{18, 15, ElementShape::kCurved, "a prism of second order"},
    ElementType{19, 13, ElementShape::kCurved, "a pyramid of second order"},
    ElementType{20, 9, ElementShape::kCurved, "a triangle of third order"},
    ElementType{21, 10, ElementShape::kCurved, "a triangle of third order"},
    ElementType{22, 12, ElementShape::kCurved, "a triangle of fourth order"},
    ElementType{23, 15, ElementShape::kCurved, "a triangle of fourth order"},
    ElementType{24, 15, ElementShape::kCurved, "a triangle of fifth order"},
    ElementType{25, 21, ElementShape::kCurved, "a triangle of fifth order"},
    ElementType{26, 4, ElementShape::kCurved, "an edge of third order"},
    ElementType{27, 5, ElementShape::kCurved, "an edge of fourth order"},
    ElementType{28, 6, ElementShape::kCurved, "an edge of fifth order"},
    ElementType{29, 20, ElementShape::kCurved, "a tetrahedron of third order"},
    ElementType{30, 35, ElementShape::kCurved, "a tetrahedron of fourth order"},
    ElementType{31, 56, ElementShape::kCurved, "a tetrahedron of fifth order"},
};

// Types of higher order, from the first number to the last. Gmsh has changed how many nodes some of them have: those of
// type 99 have had 32 and 56.
struct HigherOrder {
  Vertex first;
  Vertex last;
  std::string_view name;
};
constexpr std::string_view kEdge = "an edge of higher order";
constexpr std::string_view kTriangle = "a triangle of higher order";
constexpr std::string_view kQuadrilateral = "a quadrilateral of higher order";
constexpr std::string_view kTetrahedron = "a tetrahedron of higher order";
constexpr std::string_view kPrism = "a prism of higher order";
constexpr std::array kHigherOrders = {
    HigherOrder{32, 33, kTetrahedron},
    HigherOrder{36, 41, kQuadrilateral},
    HigherOrder{42, 46, kTriangle},
    HigherOrder{47, 51, kQuadrilateral},
    HigherOrder{52, 56, kTriangle},
    HigherOrder{57, 61, kQuadrilateral},
    HigherOrder{62, 66, kEdge},
    HigherOrder{71, 75, kTetrahedron},
    HigherOrder{79, 83, kTetrahedron},
    HigherOrder{90, 91, kPrism},
    HigherOrder{92, 105, "a hexahedron of higher order"},
    HigherOrder{106, 117, kPrism},
    HigherOrder{118, 131, "a pyramid of higher order"},
    HigherOrder{137, 137, kTetrahedron},
};

// Polygons, polyhedra, elements of one node, parts of others: no two of a type need have as many nodes.
struct Others {
  Vertex first;
  Vertex last;
};
constexpr std::array kOthers = {Others{34, 35}, Others{67, 70}, Others{84, 89}, Others{132, 136},
                                Others{138, 140}};

}  // namespace

const ElementType* find_gmsh_type(Vertex code) {
  const auto* const type = std::find_if(kGmshTypes.begin(), kGmshTypes.end(),
                                        [&](const ElementType& one) { return one.code == code; });
  return type == kGmshTypes.end() ? nullptr : type;
}

std::optional<std::string_view> gmsh_higher_order(Vertex code) {
  for (const HigherOrder& one : kHigherOrders) {
    if (code >= one.first && code <= one.last) return one.name;
  }
  return std::nullopt;
}

bool is_known_to_gmsh(Vertex code) {
  return find_gmsh_type(code) != nullptr || gmsh_higher_order(code) ||
         std::any_of(kOthers.begin(), kOthers.end(),
                     [&](const Others& one) { return code >= one.first && code <= one.last; });
}

}  // namespace circumspect::formats
