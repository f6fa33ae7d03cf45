#include "reference/delaunay/gift_wrapping_cells.hpp"

#include <cassert>
#include <map>
#include <set>
#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/polyhedral_complex.hpp"
#include "kernel/complex/polytope.hpp"
#include "kernel/complex/triangulation.hpp"
#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/orientation.hpp"
#include "reference/delaunay/dictionary.hpp"
#include "reference/delaunay/lifted_hull.hpp"
#include "reference/delaunay/unfinished_facets.hpp"

namespace circumspect::delaunay {
namespace {

// A facet of a cell with a front: the side on which orientation(basis, x) has the sign `front`.
// The basis is a function of the facet, so that the sign means the same to both of its cells.
struct CellFacet {
  Simplex basis;
  int front;
};

int side(const PointSet& points, const std::vector<std::size_t>& axes, const Simplex& basis,
         Vertex q) {
  return side_of_facet(points.configuration(), axes, basis, q);
}

// The side of the facet on which the other points of a cell are.
int side_of_cell(const PointSet& points, const std::vector<std::size_t>& axes, const Simplex& basis,
                 const Face& cell) {
  for (const Vertex q : cell) {
    if (const int s = side(points, axes, basis, q); s != 0) return s;
  }
  return 0;
}

// Finish: the cell in front of a facet, among the members of a flat; empty if the facet is on the
// hull.
Face cell_in_front(const PointSet& points, const std::vector<std::size_t>& axes,
                   const CellFacet& facet, const std::vector<Vertex>& members) {
  Simplex kept;
  for (const Vertex q : members) {
    if (side(points, axes, facet.basis, q) != facet.front) continue;
    if (!kept.empty() && in_ball(points.configuration(), axes, kept, q) <= 0) continue;
    kept = facet.basis;
    kept.push_back(q);
  }
  Face cell;
  if (kept.empty()) return cell;
  for (const Vertex q : members) {
    if (in_ball(points.configuration(), axes, kept, q) == 0) cell.push_back(q);
  }
  return cell;
}

// A cell of the Delaunay subdivision of the members in their own flat, on its boundary: wrapped
// from a cell of the subdivision of a hull facet.
Face first_cell(const PointSet& points, const std::vector<Vertex>& members) {
  const Flat flat = flat_through(points, members);
  if (flat.dimension() == 0) return members;
  const Face seed = first_cell(points, some_facet(points, flat.axes, members));
  const Simplex basis = flat_through(points, seed).basis;
  const int front = side_of_cell(points, flat.axes, basis, members);
  return cell_in_front(points, flat.axes, {basis, front}, members);
}

}  // namespace

PolyhedralComplex gift_wrapping_cells(const PointSet& points) {
  const std::vector<Vertex> all = all_vertices(points);
  std::set<Face> cells;
  std::map<Face, CellFacet> unfinished;
  std::vector<std::size_t> axes;
  const auto add = [&](const Face& cell) {
    const bool is_new = cells.insert(cell).second;
    assert(is_new);
    for (const Face& facet : facets_by_wrapping(points, cell)) {
      if (unfinished.erase(facet) == 1) continue;
      const Simplex basis = flat_through(points, facet).basis;
      unfinished[facet] = {basis, -side_of_cell(points, axes, basis, cell)};
    }
  };
  if (!points.empty()) {
    axes = flat_through(points, all).axes;
    add(first_cell(points, all));
  }
  while (!unfinished.empty()) {
    const auto [facet, oriented] = *unfinished.begin();
    const Face cell = cell_in_front(points, axes, oriented, all);
    if (cell.empty()) {
      unfinished.erase(facet);  // Nothing is in front: the facet is on the hull.
    } else {
      add(cell);
    }
  }
  return PolyhedralComplex(points, points.dimension(), {cells.begin(), cells.end()},
                           facets_by_wrapping);
}

Triangulation gift_wrapping_by_cells(const PointSet& points) {
  return least_vertex_triangulation(points, gift_wrapping_cells(points));
}

}  // namespace circumspect::delaunay
