// Which vertices of a mesh are vertices of the domain, where the others lie in it, and which vertex is nearest to one
// that is missing.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "kernel/boxes/box_index.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// ---- Nearest vertex ----
// The vertex of a mesh nearest to a vertex or a segment of the domain that the mesh has not. It is
// part of a witness, never of a verdict: whoever reads it sees whether a coordinate was rounded.

class VertexSearch {
 public:
  // Among the vertices of simplices and listed faces: `used` says of each point whether it is one.
  // The index is made with the first question. Both must outlive the search.
  VertexSearch(const ExactMesh& mesh, const std::vector<bool>& used) : mesh_(mesh), used_(used) {}

  // The nearest to a point, ties to the lower index; distance 0 if it is a vertex. Nothing if there is
  // no vertex, or too much has been looked at: see kMostLookedAt.
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

// ---- Vertex places ----
// Which vertices of a mesh are vertices of the domain, and where the others lie in it. Foreign meshes
// number their points as they like, so coordinates decide.

inline constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);
inline constexpr Vertex kNoVertex = -1;

struct VertexPlaces {
  // The point of the mesh that each vertex of the domain is, or kNoVertex.
  std::vector<Vertex> in_mesh;
  // By the points of the mesh: the vertex of the domain that it is, or kNoVertex; whether a simplex,
  // listed triangle or edge has it for a vertex; and for those that are used without being vertices
  // of the domain the segment or the polygon whose relative interior holds it, or kNowhere.
  std::vector<Vertex> in_domain;
  std::vector<bool> used;
  std::vector<std::size_t> segment;
  std::vector<std::size_t> polygon;

  bool is_steiner(Vertex v) const { return used[place(v)] && in_domain[place(v)] == kNoVertex; }
  static std::size_t place(Vertex v) { return static_cast<std::size_t>(v); }
};

// Matches the vertices. Requires: simplices and faces name points.
VertexPlaces match_vertices(const ExactMesh& mesh, const PiecewiseLinearComplex& complex);

// Finds the segments and polygons of the Steiner points.
// Requires: the mesh has every vertex of the domain.
void locate_steiner_points(const ExactMesh& mesh, const PiecewiseLinearComplex& complex,
                           VertexPlaces& places);

SteinerPoints count_steiner_points(const VertexPlaces& places);

// domain.vertex-missing, triangulation.unused-point and, if the claim allows no Steiner points,
// domain.steiner-forbidden; and which the Steiner points are. True if every vertex of the domain is a
// point of the mesh. The search is for what is nearest to one that is not.
bool judge_vertices(const ExactMesh& mesh, const PiecewiseLinearComplex& complex,
                    const VertexPlaces& places, bool steiner_points_allowed, VertexSearch& search,
                    Verdict& verdict);

}  // namespace circumspect::check
