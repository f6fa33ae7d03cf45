// The canonical Delaunay triangulation of points given by doubles, constructed fast, and proved by
// the fast judge. Book: Sections 4.2 and 5.2 to 5.6.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/triangulation.hpp"
#include "kernel/exact/progress.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::construct {

// A triangulation that the fast judge has found to be the canonical (weighted) Delaunay
// triangulation of its points.
struct ProvedDelaunay {
  // Positively oriented, ascending but for the first two vertices, and in lexicographic order of
  // their vertices in ascending order, as those of a Triangulation are.
  Rows<std::int32_t> simplices;
  bool is_unique = true;  // is there no other Delaunay triangulation?

  Triangulation triangulation() const;
};

// Of points without weights if `weights` has no rows. Nothing if some number is not a double, if
// the points are of another dimension than 2 or 3 or lie in a flat, if the machine does not compute
// as the filters were proved for, or if there are more than a thousand million simplices: then
// reference::canonical_delaunay answers. Throws std::logic_error if the judge refutes what was
// constructed. Requires: no equal points; one weight a point, or none.
std::optional<ProvedDelaunay> canonical_delaunay(const Numbers& coordinates, const Numbers& weights,
                                                 const Progress& progress = {});
std::optional<ProvedDelaunay> canonical_delaunay(const PointSet& points,
                                                 const Progress& progress = {});

// The same of any number of points of any dimension: constructed fast, or else by the book.
struct CanonicalDelaunay {
  Triangulation triangulation;
  bool is_known_unique = false;  // if not, there may be another Delaunay triangulation
};
CanonicalDelaunay any_canonical_delaunay(const PointSet& points, const Progress& progress = {});

}  // namespace circumspect::construct
