// A constrained Delaunay triangulation that changes as polygons and vertices come and go.
// Book: Sections 5.7 and 5.8.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/complex/star_index.hpp"
#include "kernel/exact/progress.hpp"

namespace circumspect::constrained {

// The canonical CDT of a convex hull in space with some segments and polygons in it, that is, of a
// PLC of the hull kind. Functions that change it treat facets of only one tetrahedron as facets of
// the hull. So a domain that is not convex has no evolving CDT; its CDT is carved from that of its
// hull (below).
struct EvolvingCdt {
  StarIndex tetrahedra;
  std::set<Simplex> segments;  // pairs of vertices, ascending
  // The walls: the facets of the triangulation that a polygon includes, ascending. "Locally
  // Delaunay except those included in a polygon" means: except these.
  std::set<Simplex> walls;

  friend bool operator==(const EvolvingCdt& a, const EvolvingCdt& b) {
    return a.tetrahedra.simplices() == b.tetrahedra.simplices() && a.segments == b.segments &&
           a.walls == b.walls;
  }
};

// The canonical Delaunay triangulation of the points, all of them vertices; no segments, no walls.
// Requires: points.dimension() == 3.
EvolvingCdt evolving_delaunay(const PointSet& points, const Progress& progress = {});

// Why an evolving CDT cannot become the one that was asked for.
enum class WhyNoChange {
  kSegmentMissing,      // a segment of the polygon is not an edge of the triangulation
  kFlipBlocked,         // a facet that must go cannot be flipped
  kFacetUnfinished,     // no vertex in front of the facet can be joined to it in the cavity
  kSimplicesOverlap,    // a facet has two tetrahedra on one side
  kNotLocallyDelaunay,  // a facet that no polygon includes
  kSegmentLost,         // a segment is no longer an edge
  kNotStarShaped,       // the facet of a vertex's cavity is not seen from the vertex
  kSegmentInCavity,     // a segment runs through the interior of a vertex's cavity
  kPolygonInCavity,     // the same for a polygon, which includes the facet
  kOutsideHull,         // the vertex to be inserted lies outside the convex hull
  kVertexAlreadyThere,  // the vertex to be inserted is one of the triangulation's
  kExtremeVertex,       // without the vertex to be deleted the convex hull would shrink
  kVertexNeeded,        // segments end at the vertex to be deleted, or it is not a vertex
};

struct NoChange {
  WhyNoChange why;
  Simplex witness;  // the segment, facet, tetrahedron or vertex that it is about

  bool operator==(const NoChange&) const = default;
};

// A change of an evolving CDT. Items to be added must not be there yet; items to be removed must
// be.
struct Change {
  std::vector<Simplex> deleted;  // tetrahedra
  std::vector<Simplex> created;  // tetrahedra that fill the same space
  std::set<Simplex> walls_added = {};
  std::set<Simplex> walls_removed = {};
  std::set<Simplex> segments_added = {};
  std::set<Simplex> segments_removed = {};
};

// Performs a change. Returns nothing if the triangulation is still a CDT; otherwise returns the
// fault, and changes nothing. By the Constrained Delaunay Lemma (4.10) it suffices that all
// segments are edges, all walls facets, and each facet of the new tetrahedra locally Delaunay or a
// wall. Requires: the tetrahedra will be a triangulation of the hull, with all of its vertices, and
// besides only one that is to be inserted, or without one that is to be deleted; and all walls will
// be facets of it, which is asserted. It does not check that the created tetrahedra fill the space
// of the deleted ones, or that no vertex comes or goes. Throws std::logic_error if a deleted
// tetrahedron is not there, or a created one already is.
std::optional<NoChange> try_change(const PointSet& points, EvolvingCdt& cdt, const Change& change);

// The first of some facets of a triangulation that is neither a wall nor locally Delaunay: the
// condition of the Constrained Delaunay Lemma (4.10). Requires: the facets are in the
// triangulation.
std::optional<Simplex> facet_not_locally_delaunay(const PointSet& points,
                                                  const StarIndex& simplices,
                                                  const std::vector<Simplex>& facets,
                                                  const std::set<Simplex>& walls);

// Is the facet of the triangulation on the boundary of the convex hull? It is if only one
// tetrahedron has it. Asserts that then no vertex of the triangulation lies beyond.
bool is_on_hull(const PointSet& points, const EvolvingCdt& cdt, const Simplex& facet);

// The edges of some simplices, each once, ascending, in lexicographic order.
std::set<Simplex> edges_of(const std::vector<Simplex>& simplices);

// The vertices of some simplices.
std::set<Vertex> vertices_of(const std::vector<Simplex>& simplices);

}  // namespace circumspect::constrained
