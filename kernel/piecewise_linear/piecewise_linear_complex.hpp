// Piecewise linear complexes, and how their vertices, segments and triangles lie to one another.
// Book: Section 4.5.1, Definition 4.3.
#pragma once

#include <set>
#include <span>
#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/simplex.hpp"

namespace circumspect {

// Which part of space a complex is meant to fill. `kEnclosed`: its polyhedra are the bounded
// components of the complement of its polygons (in the plane: its polygons those of the complement
// of its segments), without those that hold a hole seed. `kHull`: the convex hull of its vertices;
// the polygons and segments are internal constraints.
enum class DomainKind { kEnclosed, kHull };

// A polygon: a linear cell of dimension 2 in space, possibly with holes, with slits, and with
// vertices in its relative interior. It is the part of its plane that its triangles cover.
struct Polygon {
  std::vector<Vertex> vertices;    // every vertex of the complex that lies in it, ascending
  std::vector<Simplex> segments;   // every segment that lies in it: outline, holes and slits
  std::vector<Point> hole_seeds;   // a point in each of its holes
  std::vector<std::size_t> axes;   // two axes on which its plane projects injectively
  std::vector<Simplex> triangles;  // some triangulation of it that has its segments as edges
};

// The cells of a PLC in the plane (d = 2: no polygon is listed, they follow from the segments) or
// in space (d = 3: the polyhedra follow from the polygons). Segments are pairs of vertices,
// ascending, each once, in lexicographic order; every edge of a polygon's outline is among them.
struct PiecewiseLinearComplex {
  PointSet points;
  std::vector<Simplex> segments;
  std::vector<Polygon> polygons;
  std::vector<Point> hole_seeds;
  DomainKind kind = DomainKind::kEnclosed;

  std::size_t ambient_dimension() const { return points.ambient_dimension(); }
};

// The walls of the complex: linear cells of dimension d − 1 cut into simplices with their vertices
// ascending. In the plane the segments; in space the triangles of all polygons, which meet edge to
// edge because polygons meet only in shared cells.
std::vector<Simplex> walls(const PiecewiseLinearComplex& complex);

// A user's input, before it is known whether it is a PLC. Vertices are indices from 0.
struct PolygonLines {
  // Closed lines of three vertices or more; a line of two is a segment, and a line of one is an
  // isolated vertex.
  std::vector<std::vector<Vertex>> lines;
  std::vector<Point> hole_seeds;
};
struct PiecewiseLinearInput {
  std::vector<Point> points;
  std::vector<std::vector<Vertex>> segments;  // pairs
  std::vector<PolygonLines> polygons;
  std::vector<Point> hole_seeds;
  DomainKind kind = DomainKind::kEnclosed;
};

// The complex that an input describes. Vertices and segments of the complex that lie in a polygon
// whose lines do not list them are adopted: Definition 4.3 makes them faces of it.
// Requires: the input is a valid PLC (see validity.hpp).
PiecewiseLinearComplex assemble(const PiecewiseLinearInput& input);

// A line stands for its vertices and for its edges, each counted once however often the line passes
// it.
std::set<Simplex> edges_of(const PolygonLines& polygon);
std::vector<Vertex> vertices_of(const PolygonLines& polygon);  // ascending

// All segments of the input: ascending pairs, each once, in lexicographic order.
std::vector<Simplex> segments_of(const PiecewiseLinearInput& input);

}  // namespace circumspect
