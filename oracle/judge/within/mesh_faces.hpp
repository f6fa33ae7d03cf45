// The edges and triangles of a mesh that may belong to images: those with vertices near cells alone.
#pragma once

#include <utility>
#include <vector>

#include "oracle/judge/within/reaches.hpp"

namespace circumspect::check {

class MeshFaces {
 public:
  // Edges and triangles of simplices, and listed ones. Requires: each simplex is sound by itself.
  MeshFaces(const ExactMesh& mesh, const Cells& cells, const Reaches& reaches);

  bool has_edge(Vertex a, Vertex b) const;
  // With all vertices near the polygon; ascending, each once.
  const std::vector<Simplex>& triangles_near(std::size_t polygon) const {
    return triangles_[polygon];
  }

 private:
  std::vector<std::pair<Vertex, Vertex>> edges_;
  std::vector<std::vector<Simplex>> triangles_;
};

}  // namespace circumspect::check
