// Which vertices of a mesh are vertices of the domain, and where the others lie in it. Foreign
// meshes number their points as they like, so coordinates decide.
#pragma once

#include <cstddef>
#include <vector>

#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "oracle/judge/domain/vertex_search.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

inline constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);
inline constexpr Vertex kNoVertex = -1;

struct VertexPlaces {
  // The point of the mesh that each vertex of the domain is, or kNoVertex.
  std::vector<Vertex> in_mesh;
  // By the points of the mesh: the vertex of the domain that it is, or kNoVertex; whether a
  // simplex, listed triangle or edge has it for a vertex; and for those that are used without being
  // vertices of the domain the segment or the polygon whose relative interior holds it, or
  // kNowhere.
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

// The polygons that each point of the mesh lies in, ascending.
// Requires: Steiner points are located.
std::vector<std::vector<std::size_t>> polygons_at_vertices(const ExactMesh& mesh,
                                                           const PiecewiseLinearComplex& complex,
                                                           const VertexPlaces& places);

SteinerPoints count_steiner_points(const VertexPlaces& places);

// domain.vertex-missing, triangulation.unused-point and, if the claim allows no Steiner points,
// domain.steiner-forbidden; and which the Steiner points are. True if every vertex of the domain is
// a point of the mesh. The search is for what is nearest to one that is not.
bool judge_vertices(const ExactMesh& mesh, const PiecewiseLinearComplex& complex,
                    const VertexPlaces& places, bool steiner_points_allowed, VertexSearch& search,
                    Verdict& verdict);

}  // namespace circumspect::check
