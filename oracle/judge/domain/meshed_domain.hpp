// A mesh together with its domain, and facts about both, such as the segments as chains of mesh vertices.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "kernel/complex/simplex.hpp"
#include "kernel/piecewise_linear/regions.hpp"
#include "oracle/judge/domain/vertex_places.hpp"
#include "oracle/judge/fast/simplex_facts.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace circumspect::check {

// ---- Segment chains ----

// For each segment its ends and the vertices of the mesh inside it, in order from its first end to
// its second. Links are pairs of consecutive ones.
class SegmentChains {
 public:
  // Requires: places are complete, Steiner points located.
  SegmentChains(const ExactMesh& mesh, const PiecewiseLinearComplex& complex,
                const VertexPlaces& places);

  std::size_t size() const { return chains_.size(); }
  const std::vector<Vertex>& chain(std::size_t segment) const { return chains_[segment]; }

  // The segment that holds two vertices, and their places in its chain; nothing if none does.
  struct Stretch {
    std::size_t segment;
    std::size_t first;  // the smaller place
    std::size_t last;
    bool is_link() const { return last == first + 1; }
  };
  std::optional<Stretch> stretch(Vertex a, Vertex b) const;
  // Is it two consecutive vertices of a chain?
  bool is_link(Vertex a, Vertex b) const;
  // Is the vertex on any segment?
  bool touches(Vertex v) const { return touches_[VertexPlaces::place(v)]; }

 private:
  std::size_t place_on(std::size_t segment, Vertex v) const;
  // The segment of the domain with these ends, u < v, or kNowhere.
  std::size_t segment_between(Vertex u, Vertex v) const;

  const PiecewiseLinearComplex& complex_;
  const VertexPlaces& places_;
  std::vector<std::vector<Vertex>> chains_;
  // For each vertex of the domain where those segments begin in the list of which it is the first end.
  std::vector<std::ptrdiff_t> from_;
  std::vector<std::size_t> place_in_chain_;  // of Steiner points
  std::vector<bool> touches_;
};

// ---- Meshed domain ----

struct MeshedDomain {
  const ExactMesh& mesh;
  const PiecewiseLinearComplex& complex;
  const Regions& regions;
  const std::vector<FacetUse>&
      uses;                         // of the mesh's simplices: of all, or where there is something
  const fast::SimplexFacts* known;  // known of them, of those in listed_faces.hpp
  const VertexPlaces& places;
  const SegmentChains& chains;
  VertexSearch& search;

  bool is_inside(std::size_t region) const { return regions.where(region) == Where::kInside; }
  // The point of the mesh that a vertex of the domain is.
  Vertex in_mesh(Vertex v) const { return places.in_mesh[VertexPlaces::place(v)]; }
};

// A facet of the mesh, or a listed simplex of as many vertices, that lies in a wall of the domain: in
// a polygon, or in the plane in a segment.
struct WallPiece {
  Simplex facet;     // ascending
  std::size_t cell;  // which polygon, or segment
  // The regions behind it and in front of it, where a vertex appended makes it positively oriented.
  std::array<std::size_t, 2> regions;
};

// The place in `regions` of the side on which `apex` is. Requires: not in the facet's plane.
inline std::size_t side_index(int orientation) { return orientation > 0 ? 1 : 0; }

}  // namespace circumspect::check
