// The cells of a domain that must have images in the mesh, and their faces.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "kernel/piecewise_linear/linear_cell.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect::check {

// What programs write beside triangles and users beside polygons, to say what belongs together; 0:
// nothing.
struct Markers {
  std::map<Simplex, Vertex> of_triangles = {};  // by their vertices, ascending
  std::vector<Vertex> of_polygons = {};         // of the first ones; others have none
};

using Cell = LinearCell;

class Cells {
 public:
  explicit Cells(const PiecewiseLinearComplex& complex, Markers markers = {});

  const PiecewiseLinearComplex& complex() const { return complex_; }
  // All, vertices first, polygons last.
  std::vector<Cell> all() const { return linear_cells(complex_); }

  // The cell itself and all its faces: the ends of a segment; the vertices and segments in a
  // polygon, slits among them.
  std::vector<Cell> closure(Cell cell) const;
  bool is_in_closure(Cell face, Cell cell) const;
  // Is it so of all proper faces?
  template <class Holds>
  bool holds_of_faces(Cell cell, const Holds& holds) const {
    if (cell.dimension == 0) return true;
    for (const Vertex v : cell.dimension == 1 ? complex_.segments[cell.place]
                                              : complex_.polygons[cell.place].vertices) {
      if (!holds(Cell{0, static_cast<std::size_t>(v)})) return false;
    }
    if (cell.dimension == 1) return true;
    for (const std::size_t s : segments_of_[cell.place]) {
      if (!holds(Cell{1, s})) return false;
    }
    return true;
  }
  // The segments and polygons that have the vertex, ascending.
  const std::vector<Cell>& star(std::size_t vertex) const { return stars_[vertex]; }
  // By the places of its segments, ascending.
  const std::vector<std::size_t>& segments_of(std::size_t polygon) const {
    return segments_of_[polygon];
  }
  // Has the triangle of the mesh the marker of the polygon? Requires: its vertices ascending.
  bool is_marked(const Simplex& triangle, std::size_t polygon) const;
  // Has a vertex in common with it: two cells of a valid complex meet only so.
  bool meet(Cell a, Cell b) const;

  // The vertices in the cell, ascending; the simplices it is made of, each by its vertices.
  std::vector<Vertex> vertices(Cell cell) const { return vertices_of(complex_, cell); }
  std::vector<Simplex> simplices(Cell cell) const { return simplices_of(complex_, cell); }

 private:
  const PiecewiseLinearComplex& complex_;
  Markers markers_;
  std::vector<std::vector<std::size_t>> segments_of_;
  std::vector<std::vector<Cell>> stars_;
};

}  // namespace circumspect::check
