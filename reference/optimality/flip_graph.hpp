// The flip graph. Book: Section 4.4: "For a specified point set, the flip graph has one node for
// every triangulation of those points. Two nodes are connected by an edge if one triangulation can
// be transformed into the other by a single bistellar flip, excluding those flips that create or
// delete a vertex."
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/triangulation.hpp"
#include "reference/optimality/all_triangulations.hpp"

namespace circumspect::optimality {

// A circuit: a minimal affinely dependent set of points, the vertex set W of a (lower-dimensional)
// basic flip. The points of both parts are affinely dependent, those of no proper subset are. The
// sign is that of a point's coefficient in the dependence: the two parts are those of Radon's
// theorem, and conv(positive) meets conv(negative) in one point.
struct Circuit {
  Simplex positive;  // ascending
  Simplex negative;  // ascending
};

// All circuits, each once; which part is called positive is arbitrary.
std::vector<Circuit> circuits(const PointSet& points);

// The triangulation after the bistellar flip on a circuit that deletes the simplices which leave
// out one positive point; nothing if the triangulation has no such flip. Basic if the circuit has
// d+2 points, extended otherwise.
std::optional<Triangulation> flipped(const Triangulation& triangulation, const Circuit& circuit);

// All triangulations one flip away. Flips that create or delete a vertex count only for
// kSomePoints.
std::vector<Triangulation> neighbours(const Triangulation& triangulation,
                                      const std::vector<Circuit>& circuits, VertexUse use);

struct FlipGraph {
  std::vector<Triangulation> triangulations;         // ascending, as in all_triangulations
  std::vector<std::vector<std::size_t>> neighbours;  // of each triangulation, ascending

  // The connected components under flips, as one number for each triangulation, from 0.
  std::vector<std::size_t> components() const;
  bool is_connected() const;
};

// The part of the graph that a breadth-first search reaches from one triangulation.
FlipGraph flip_graph_from(const PointSet& points, const Triangulation& start,
                          VertexUse use = VertexUse::kAllPoints);

// The graph on given triangulations, such as all of them.
FlipGraph flip_graph_on(const PointSet& points, std::vector<Triangulation> triangulations,
                        VertexUse use = VertexUse::kAllPoints);

}  // namespace circumspect::optimality
