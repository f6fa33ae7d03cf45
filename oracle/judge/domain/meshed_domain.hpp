// A mesh together with its domain, and facts about both.
#pragma once

#include <array>
#include <vector>

#include "kernel/complex/simplex.hpp"
#include "kernel/piecewise_linear/regions.hpp"
#include "oracle/judge/domain/segment_chains.hpp"
#include "oracle/judge/domain/vertex_places.hpp"
#include "oracle/judge/domain/vertex_search.hpp"
#include "oracle/judge/fast/simplex_facts.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace circumspect::check {

struct MeshedDomain {
  const ExactMesh& mesh;
  const PiecewiseLinearComplex& complex;
  const Regions& regions;
  const std::vector<FacetUse>&
      uses;                         // of the mesh's simplices: of all, or where there is something
  const fast::SimplexFacts* known;  // known of them, of those in facets_of_interest.hpp
  const VertexPlaces& places;
  const SegmentChains& chains;
  VertexSearch& search;

  bool is_inside(std::size_t region) const { return regions.where(region) == Where::kInside; }
  // The point of the mesh that a vertex of the domain is.
  Vertex in_mesh(Vertex v) const { return places.in_mesh[VertexPlaces::place(v)]; }
};

// A facet of the mesh, or a listed simplex of as many vertices, that lies in a wall of the domain:
// in a polygon, or in the plane in a segment.
struct WallPiece {
  Simplex facet;     // ascending
  std::size_t cell;  // which polygon, or segment
  // The regions behind it and in front of it, where a vertex appended makes it positively oriented.
  std::array<std::size_t, 2> regions;
};

// The place in `regions` of the side on which `apex` is. Requires: not in the facet's plane.
inline std::size_t side_index(int orientation) { return orientation > 0 ? 1 : 0; }

}  // namespace circumspect::check
