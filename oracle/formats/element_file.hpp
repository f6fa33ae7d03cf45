// A mesh as a list of elements of all dimensions, with the surface and its edges among them: what Medit,
// Gmsh, VTK and Wavefront keep in a file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/formats/domain_file.hpp"
#include "oracle/formats/point_file.hpp"

namespace circumspect::formats {

// The shapes of elements. Vertices are listed round about a polygon; kPixel lists a quadrilateral row by
// row, kStrip triangles each of which goes on from the last two vertices, kPolyline edges end to end.
enum class ElementShape {
  kPoint,
  kPolyline,  // an edge is one of two vertices
  kPolygon,   // a triangle is one of three
  kPixel,
  kStrip,
  kTetrahedron,
  kOtherSolid,  // hexahedra, prisms, pyramids and polyhedra, of first order
  kCurved,      // of second order or more, of any dimension
};

// A type of elements as a format numbers it.
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
  // The first element that is not a simplex, and the first that is curved: what it is and its line.
  struct Named {
    std::string name;  // "a hexahedron"
    std::size_t line = 0;
  };
  std::optional<Named> first_other = {};
  std::optional<Named> first_curved = {};
  std::vector<std::string> notes = {};
};

// Adds an element. `name`: "a hexahedron"; it is named where it cannot be judged. Too few vertices for its
// shape are a fault, which is what comes back: "a triangle of 3 vertices or more". `label`: what the file says it
// belongs to, if it says so of all elements.
std::optional<std::string> add_element(ElementFile& file, ElementShape shape, Simplex vertices,
                                       std::string_view name, std::size_t line,
                                       std::optional<Vertex> label = {});

// Fills in what follows from the simplices, once all have been added.
void finish_elements(ElementFile& file);

// Why the elements are not a mesh of simplices: nothing if they are one.
Status check_simplices(const ElementFile& file, const std::string& name);

// The simplices of highest dimension, and those below them.
struct TopElements {
  SimplexFile simplices = {};
  std::vector<Simplex> faces = {};
};
TopElements top_elements(ElementFile& file);

// Is no element one of space?
bool is_of_plane(const ElementFile& file);

// What of the elements can be seen: the triangles, and the facets that belong to one tetrahedron alone, their
// vertices counterclockwise seen from outside, if those of tetrahedra are positively oriented.
std::vector<Simplex> surface_of(const ElementFile& file);

// The surface: edges are segments; triangles and polygons are polygons in space, and in the
// plane, if there are no edges, theirs are taken. Where there are cells, vertices that belong to
// these alone are left out: they are the mesh's, not its domain's. Errors: curved elements; cells alone.
Result<DomainFile> domain_of(const ElementFile& elements, const std::string& name);

}  // namespace circumspect::formats
