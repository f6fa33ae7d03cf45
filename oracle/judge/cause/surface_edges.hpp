// The edges of triangles in space, and which of these have them.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "kernel/complex/simplex.hpp"
#include "oracle/judge/cause/case.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::check {

// A triangle has an edge, and goes along it from its lesser vertex to the greater, or back.
struct EdgeUse {
  Vertex low, high;
  bool goes_up;
  std::size_t triangle;
};

// In order of the edges. None of triangles that repeat a vertex or name no points; none at all if
// the mesh has no rows of three.
std::vector<EdgeUse> edge_uses(const Mesh& mesh);

// Visits the uses of each edge. Requires: in order of the edges.
template <class Visitor>
void for_each_edge(const std::vector<EdgeUse>& uses, Visitor visit) {
  for (std::size_t first = 0, end = 0; first < uses.size(); first = end) {
    const auto is_same = [&](const EdgeUse& use) {
      return use.low == uses[first].low && use.high == uses[first].high;
    };
    while (end < uses.size() && is_same(uses[end])) ++end;
    visit(std::span(uses).subspan(first, end - first));
  }
}

// An edge that only one triangle has, as that triangle goes along it.
struct OpenEdge {
  Vertex from, to;
};
std::vector<OpenEdge> open_edges(const Mesh& mesh);

// The loops that they form, each as its vertices in order, the least first. If all triangles at it
// go around it in one sense, it goes in the other, as what fills it would. Nothing if some vertex
// has not two of the edges.
std::optional<std::vector<std::vector<Vertex>>> loops_of(const std::vector<OpenEdge>& edges);

// Those of a surface that should be closed, but for the sides of cracks. None if triangles were set
// apart, which leave their edges open and are none of these.
std::vector<OpenEdge> edges_of_holes(const Case& of);

}  // namespace circumspect::check
