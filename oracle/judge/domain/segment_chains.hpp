// The segments of a domain as chains of vertices of a mesh.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "oracle/judge/domain/vertex_places.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace circumspect::check {

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
  // For each vertex of the domain where those segments begin in the list that have it for their
  // first end.
  std::vector<std::ptrdiff_t> from_;
  std::vector<std::size_t> place_in_chain_;  // of Steiner points
  std::vector<bool> touches_;
};

}  // namespace circumspect::check
