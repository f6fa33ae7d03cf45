// When a simplex respects a piecewise linear complex.
//
// Why the tests below suffice. A simplex σ is the disjoint union of the relative interiors of its
// faces φ. A cell f meets it in a union of faces iff every relint φ is disjoint from f or within f.
// The vertices and segments of P are tested as that says. (A segment that meets relint φ without an
// end there either crosses an edge, or pierces a triangle φ; if it shares an end with the edge φ,
// it is φ or meets relint φ not at all, for otherwise the end of one would lie inside the other.)
// Suppose that they pass, and take a polygon f and a face φ.
//
// φ an edge. If f's plane contains φ: the edges of f are segments, none meets relint φ unless it is
// φ, so relint φ is within f or disjoint from it. Else relint φ meets the plane in a point at most,
// which must not lie in f: tested triangle by triangle.
//
// φ a triangle. If f's plane contains φ, the same holds. Else f ∩ relint φ lies on a line; if it is
// not empty, a component of it is a part of a chord of φ, closed in relint φ. If it ends in relint
// φ, it does so on an edge of f, which is a segment that meets relint φ: excluded. If not, it is a
// whole chord, and one end of that is in the relative interior of an edge of φ that f's plane does
// not contain: excluded.
//
// φ a tetrahedron. f ∩ relint φ, if not empty, is the whole of what f's plane cuts out of φ, or an
// edge of f meets relint φ. In the first case f meets the relative interior of a facet of φ in a
// chord: excluded. In the second case a segment without an end in φ other than at φ's vertices
// leaves it through the relative interior of an edge or a facet (if both ends were vertices of φ,
// it were an edge of φ): excluded.
//
// Polyhedra: relint φ meets no polygon that it is not within, so it lies within one region or one
// polygon, or is a segment, and meets the closure of a region only if it lies within that.
//
// In the plane segments are the walls, and the first, second and last paragraph do.
//
// |P| is closed, so σ ⊆ |P| iff relint σ is, and as that lies within one region, polygon or
// segment, its barycentre decides.
#include <algorithm>
#include <cassert>

#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "kernel/piecewise_linear/visibility.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/place.hpp"

namespace circumspect {
namespace {

bool is_segment(const PiecewiseLinearComplex& complex, const Simplex& edge) {
  return std::binary_search(complex.segments.begin(), complex.segments.end(), edge);
}

bool share_a_vertex(const Simplex& a, const Simplex& b) {
  return std::any_of(a.begin(), a.end(), [&](Vertex v) { return contains(b, v); });
}

class Respecting {
 public:
  Respecting(const PiecewiseLinearComplex& complex, const Regions& regions, const Simplex& simplex)
      : complex_(complex),
        points_(complex.points.configuration()),
        regions_(regions),
        simplex_(sorted(simplex)),
        box_(regions.cells().box_of(simplex)) {}

  bool holds() const {
    if (simplex_.size() == 1) return true;
    return no_wall_across() && no_vertex_inside() && no_segment_across() && is_in_domain();
  }

 private:
  bool no_vertex_inside() const {
    const std::vector<Vertex> near = regions_.cells().vertices(box_);
    return std::all_of(near.begin(), near.end(), [&](Vertex v) {
      return contains(simplex_, v) || !lies_in(points_, simplex_, v);
    });
  }

  bool no_segment_across() const {
    const std::vector<Simplex> edges = faces_of({simplex_}, 2);
    const std::vector<Simplex> triangles =
        points_.ambient_dimension() == 3 ? faces_of({simplex_}, 3) : std::vector<Simplex>();
    for (const Simplex& segment : regions_.cells().segments(box_)) {
      for (const Simplex& edge : edges) {
        if (!share_a_vertex(segment, edge) && segments_cross(points_, segment, edge)) return false;
      }
      for (const Simplex& triangle : triangles) {
        if (segment_pierces_triangle(points_, segment, triangle)) return false;
      }
    }
    return true;
  }

  bool no_wall_across() const {
    if (points_.ambient_dimension() == 2) return true;  // walls are segments
    const PointSet& points = complex_.points;
    for (const Simplex& edge : faces_of({simplex_}, 2)) {
      for (const std::size_t i : regions_.walls().near(points[edge[0]], points[edge[1]])) {
        const Simplex& wall = regions_.walls().simplices()[i];
        if (segment_pierces_triangle(points_, edge, wall)) return false;
      }
    }
    return true;
  }

  bool is_in_domain() const {
    if (simplex_.size() == 2 && is_segment(complex_, simplex_)) return true;
    const auto region = regions_.region_at(barycentre(complex_.points, simplex_));
    return !region || regions_.where(*region) == Where::kInside;
  }

  const PiecewiseLinearComplex& complex_;
  const Configuration& points_;
  const Regions& regions_;
  const Simplex simplex_;
  const Box box_;
};

}  // namespace

bool respects(const PiecewiseLinearComplex& complex, const Regions& regions,
              const Simplex& simplex) {
  return Respecting(complex, regions, simplex).holds();
}

}  // namespace circumspect
