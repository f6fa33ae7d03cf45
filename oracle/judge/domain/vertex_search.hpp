// The vertex of a mesh nearest to a vertex or a segment of the domain that the mesh has not. It is
// part of a witness, never of a verdict: whoever reads it sees whether a coordinate was rounded.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "kernel/boxes/box_index.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

class VertexSearch {
 public:
  // Among the vertices of simplices and listed faces: `used` says of each point whether it is one.
  // The index is made with the first question. Both must outlive the search.
  VertexSearch(const ExactMesh& mesh, const std::vector<bool>& used) : mesh_(mesh), used_(used) {}

  // The nearest to a point, ties to the lower index; distance 0 if it is a vertex. Nothing if there
  // is no vertex, or too much has been looked at: see kMostLookedAt.
  std::optional<NearestVertex> to_point(const Point& point);
  // The nearest to a segment of those that do not lie on it: a vertex rounded off it, if one was.
  // Requires: a != b.
  std::optional<NearestVertex> to_segment(const Point& a, const Point& b);

 private:
  struct Target;
  std::optional<NearestVertex> nearest_to(const Target& target);
  std::optional<NearestVertex> best_of(const Target& target, const std::vector<Box>& boxes);
  void make_index();

  // A mesh that is nowhere near its domain makes every search look at most of its vertices. After
  // this many exact distances a search gives up rather than keep the verdict waiting.
  static constexpr std::size_t kMostLookedAt = 4'000'000;

  const ExactMesh& mesh_;
  const std::vector<bool>& used_;
  std::unique_ptr<const BoxIndex> index_;
  std::vector<Vertex> indexed_;
  Point low_, high_;  // the corners of a box around all of them
  std::size_t looked_at_ = 0;
};

}  // namespace circumspect::check
