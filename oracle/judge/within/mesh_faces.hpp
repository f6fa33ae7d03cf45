// The edges and triangles of a mesh that may belong to images: those with vertices near cells
// alone.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "oracle/judge/within/reaches.hpp"

namespace circumspect::check {

class MeshFaces {
 public:
  // Edges and triangles of simplices, and listed ones. Requires: each simplex is sound by itself.
  MeshFaces(const ExactMesh& mesh, const Cells& cells, const Reaches& reaches, Work& work);

  bool has_edge(Vertex a, Vertex b) const;
  // All edges of a vertex, each from it to the other.
  std::span<const std::pair<Vertex, Vertex>> edges_at(Vertex v) const;
  // With all vertices near the polygon; ascending, each once.
  const std::vector<Simplex>& triangles_near(std::size_t polygon) const {
    return triangles_[polygon];
  }

 private:
  std::vector<std::pair<Vertex, Vertex>> edges_;  // in both directions, ascending
  std::vector<std::vector<Simplex>> triangles_;
};

}  // namespace circumspect::check
