// Is a piecewise linear complex edge-protected? Book: Section 4.5.3.
#pragma once

#include <optional>
#include <vector>

#include "kernel/complex/star_index.hpp"
#include "kernel/exact/progress.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "reference/delaunay/simplex_predicates.hpp"

namespace circumspect::constrained {

// "If a segment σ is missing from the triangulation, then σ is not strongly Delaunay … If σ is
// present, it is Delaunay."
struct SegmentProtection {
  Simplex segment;
  bool is_present = false;  // is it an edge of the canonical Delaunay triangulation?
  // Delaunay or strongly so, with the ball; or not (strongly) Delaunay, with the obstruction:
  // points such that every open (closed) circumball of the segment contains one of them.
  delaunay::SimplexDelaunayhood status;
};

// One for each segment, in the order given. It only needs the star of each segment, or of one of
// its ends, in the canonical Delaunay triangulation of the points, so thousands of segments do not
// take much longer than the triangulation itself. Requires: points without weights; segments are
// pairs of them.
std::vector<SegmentProtection> edge_protection(const PointSet& points,
                                               const StarIndex& canonical_delaunay,
                                               const std::vector<Simplex>& segments,
                                               const Progress& progress = {});
std::vector<SegmentProtection> edge_protection(const PiecewiseLinearComplex& complex,
                                               const Progress& progress = {});

// A point of the obstruction that the diametral ball of the segment contains; nothing if the
// segment is strongly Delaunay.
std::optional<Vertex> encroaching_vertex(const PointSet& points,
                                         const SegmentProtection& protection);

// Is the edge of the canonical Delaunay triangulation strongly Delaunay?
bool is_strongly_delaunay_edge(const PointSet& points, const StarIndex& canonical_delaunay,
                               const Simplex& edge);

// Does the closed diametral ball of the edge contain no point except its ends? (Such an edge is
// strongly Delaunay, but not every strongly Delaunay edge has this property.)
bool has_empty_diametral_ball(const PointSet& points, const StarIndex& canonical_delaunay,
                              const Simplex& edge);

// Two readings of "A three-dimensional PLC P is edge-protected if every edge in P is strongly
// Delaunay": as it stands, and with "the symbolic perturbations … used to make the vertices in P
// generic", when every edge of the canonical Delaunay triangulation is strongly Delaunay. The first
// implies the second, because a strongly Delaunay edge is in every Delaunay triangulation
// (Proposition 4.2). In the plane both make sense too.
bool is_edge_protected(const PiecewiseLinearComplex& complex);
bool is_edge_protected_under_perturbation(const PiecewiseLinearComplex& complex);

// The same for all segments of a complex, given the results of `edge_protection`.
bool is_edge_protected(const std::vector<SegmentProtection>& segments);
bool is_edge_protected_under_perturbation(const std::vector<SegmentProtection>& segments);

// The canonical Delaunay triangulation of any points, with access to stars.
StarIndex canonical_delaunay(const PointSet& points, const Progress& progress = {});

}  // namespace circumspect::constrained
