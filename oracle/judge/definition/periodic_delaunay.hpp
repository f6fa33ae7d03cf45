// Is a mesh that a lattice repeats a Delaunay triangulation of the points that it repeats? The
// cells, moved by all of the lattice, form a complex, cover everything, have all these points for
// vertices, and none of their open circumballs has one of the points in it.
// Book: Definitions 2.1 and 4.1, which ask for finitely many points; everything here is finite in
// every bounded part.
#pragma once

#include <functional>
#include <vector>

#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/periodic.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::definition {

// A box that need not have an inside.
struct Bounds {
  Point low, high;
};
// Requires: there is a point.
Bounds bounds_of(const std::vector<Point>& points);

// Calls `visit` with all multiples of the vectors whose sum is in the box, in lexicographic order,
// until it returns false. Keeps none of them: a cell may be long and the vectors short. Throws
// Interrupted. Requires: the vectors are linearly independent, and as many as they have
// coordinates.
void for_each_shift(const std::vector<Point>& lattice, const Bounds& box,
                    const std::function<bool(const Simplex&)>& visit);

// How many times the cells cover everything, if that is everywhere the same: their volumes, over
// that of the lattice. Requires: as below; sound cells.
Rational times_covered(const ExactMesh& mesh, const Copies& copies);

// The values that say how a cell of a witness is moved.
std::vector<NamedValue> shift_in_words(const Simplex& multiples);

// Requires: `mesh` and `copies` are those of an unfolded mesh (oracle/judge/periodic).
void judge_periodic_delaunay(const ExactMesh& mesh, const Copies& copies, Verdict& verdict);

}  // namespace circumspect::definition
