// A mesh as a list of elements of all dimensions, with the surface and its edges among them, as in
// the files of Medit, Gmsh, VTK and Wavefront.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/point_file.hpp"

namespace circumspect::formats {

// The shapes of elements. Vertices are listed around a polygon; kPixel lists a quadrilateral row by
// row, kStrip lists triangles, each continuing from the last two vertices, and kPolyline edges end
// to end.
enum class ElementShape {
  kPoint,
  kPolyline,  // an edge is one of two vertices
  kPolygon,   // a triangle is one of three
  kPixel,
  kStrip,
  kTetrahedron,
  kOtherSolid,  // hexahedra, prisms, pyramids and polyhedra, of first order
  // Simplices of second order or more: the corners come first.
  kCurvedEdge,
  kCurvedTriangle,
  kCurvedTetrahedron,
  kCurved,  // all others of second order or more
};

// An element type by its number in a format.
struct ElementType {
  Vertex code;
  std::size_t vertices;  // 0: any number
  ElementShape shape;
  std::string_view name;  // "a triangle"
};

struct ElementFile {
  PointFile points = {};
  SimplexFile edges = {};
  SimplexFile triangles = {};
  SimplexFile polygons = {};  // of four vertices and more
  // How many triangles the file lists before each of these polygons.
  std::vector<std::size_t> triangles_before = {};
  SimplexFile tetrahedra = {};
  SimplexFile other_solids = {};
  // All nodes of the simplices of second order or more, whose corners are listed above
  // (curved_elements.hpp).
  SimplexFile curved = {};
  Runs<std::size_t> corners_of_curved = {};  // how many of the nodes of each
  // The first element that is not a simplex, and the first that is curved, each with its line.
  struct Named {
    std::string name;  // "a hexahedron"
    std::size_t line = 0;
  };
  std::optional<Named> first_other = {};
  std::optional<Named> first_curved = {};
  std::vector<std::string> notes = {};

  // All of them, to go over the vertices of every element.
  std::array<SimplexFile*, 6> lists() {
    return {&edges, &triangles, &polygons, &tetrahedra, &other_solids, &curved};
  }
};

// Adds an element. `name`: "a hexahedron", for the message if it cannot be judged. If it has too
// few vertices for its shape, returns what was expected: "a triangle of 3 vertices or more".
// `label`: the group that the file gives it, if the file does so for all elements.
std::optional<std::string> add_element(ElementFile& file, ElementShape shape,
                                       std::span<const Vertex> vertices, std::string_view name,
                                       std::size_t line, std::optional<Vertex> label = {});

// Computes what follows from the simplices, once all have been added.
void finish_elements(ElementFile& file);

// Why the elements are not a mesh of simplices: nothing if they are one.
Status check_simplices(const ElementFile& file, const std::string& name);

// The simplices of highest dimension, and those below them.
struct TopElements {
  SimplexFile simplices = {};
  std::vector<Simplex> faces = {};
};
TopElements top_elements(ElementFile& file);

// Are there no elements of space, such as tetrahedra?
bool is_of_plane(const ElementFile& file);

// The visible surface of the elements: the triangles, and the facets of only one tetrahedron, with
// their vertices counterclockwise seen from outside if the tetrahedra are positively oriented.
std::vector<Simplex> surface_of(const ElementFile& file);

}  // namespace circumspect::formats
