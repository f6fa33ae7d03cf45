#include "reference/optimality/flip_graph.hpp"

#include <algorithm>
#include <deque>
#include <iterator>
#include <optional>
#include <set>

#include "kernel/complex/simplex.hpp"
#include "reference/optimality/criteria.hpp"

namespace circumspect::optimality {

namespace {

// The barycentric coordinates of the last point with respect to the others, if they exist and none
// is zero.
std::optional<Circuit> circuit_of(const PointSet& points, const Simplex& subset) {
  const Simplex others(subset.begin(), subset.end() - 1);
  const auto coefficients = barycentric_coordinates(points, others, points[subset.back()]);
  if (!coefficients) return std::nullopt;
  Circuit circuit;
  for (std::size_t i = 0; i < others.size(); ++i) {
    const int side = sign((*coefficients)[i]);
    if (side == 0) return std::nullopt;
    (side > 0 ? circuit.positive : circuit.negative).push_back(others[i]);
  }
  circuit.negative.push_back(subset.back());
  return circuit;
}

}  // namespace

std::vector<Circuit> circuits(const PointSet& points) {
  std::vector<Circuit> all;
  const auto largest = static_cast<std::size_t>(points.dimension() + 2);
  for (std::size_t size = 3; size <= largest && size <= points.size(); ++size) {
    Simplex subset = first_subset(size);
    do {
      if (const auto circuit = circuit_of(points, subset)) all.push_back(*circuit);
    } while (next_subset(subset, points.size()));
  }
  return all;
}

namespace {

// The simplices that are joined to a face in the simplices that have it.
std::vector<Simplex> link(const Triangulation& triangulation, const Simplex& face) {
  std::vector<Simplex> joined;
  for (const Simplex& simplex : triangulation.simplices()) {
    if (!std::includes(simplex.begin(), simplex.end(), face.begin(), face.end())) continue;
    Simplex rest;
    std::set_difference(simplex.begin(), simplex.end(), face.begin(), face.end(),
                        std::back_inserter(rest));
    joined.push_back(std::move(rest));
  }
  std::sort(joined.begin(), joined.end());
  return joined;
}

// The simplices on all points except one, for each point of `left_out` as the exception.
std::vector<Simplex> leaving_out_one(const Simplex& all, const Simplex& left_out) {
  std::vector<Simplex> simplices;
  for (const Vertex v : left_out) {
    simplices.push_back(all);
    simplices.back().erase(std::find(simplices.back().begin(), simplices.back().end(), v));
  }
  return simplices;
}

// "Let the join T * Z of two sets of simplices be the set {τ * ζ: τ ∈ T and ζ ∈ Z}."
std::vector<Simplex> join(const std::vector<Simplex>& t, const std::vector<Simplex>& z) {
  std::vector<Simplex> joined;
  for (const Simplex& tau : t) {
    for (const Simplex& zeta : z) {
      Simplex both = tau;
      both.insert(both.end(), zeta.begin(), zeta.end());
      joined.push_back(sorted(std::move(both)));
    }
  }
  std::sort(joined.begin(), joined.end());
  return joined;
}

bool ascending(const Triangulation& a, const Triangulation& b) {
  return a.simplices() < b.simplices();
}

}  // namespace

// T_D and T_C are the two triangulations of the circuit. The flip exists if T_D * Z, for one set Z,
// is all that the triangulation has around the simplices of T_D.
std::optional<Triangulation> flipped(const Triangulation& triangulation, const Circuit& circuit) {
  Simplex all;
  std::merge(circuit.positive.begin(), circuit.positive.end(), circuit.negative.begin(),
             circuit.negative.end(), std::back_inserter(all));
  const std::vector<Simplex> t_d = leaving_out_one(all, circuit.positive);
  const std::vector<Simplex> t_c = leaving_out_one(all, circuit.negative);
  const std::vector<Simplex> z = link(triangulation, t_d.front());
  if (z.empty()) return std::nullopt;
  for (const Simplex& tau : t_d) {
    if (link(triangulation, tau) != z) return std::nullopt;
  }
  const std::vector<Simplex> deleted = join(t_d, z);
  std::vector<Simplex> simplices = join(t_c, z);
  std::set_difference(triangulation.simplices().begin(), triangulation.simplices().end(),
                      deleted.begin(), deleted.end(), std::back_inserter(simplices));
  return Triangulation(triangulation.dimension(), std::move(simplices));
}

std::vector<Triangulation> neighbours(const Triangulation& triangulation,
                                      const std::vector<Circuit>& circuits, VertexUse use) {
  std::vector<Triangulation> found;
  for (const Circuit& circuit : circuits) {
    // T_D leaves out the single positive point altogether, or T_C the single negative one.
    const bool keeps_vertices = circuit.positive.size() > 1 && circuit.negative.size() > 1;
    if (use == VertexUse::kAllPoints && !keeps_vertices) continue;
    for (const Circuit& way : {circuit, Circuit{circuit.negative, circuit.positive}}) {
      if (auto next = flipped(triangulation, way)) found.push_back(std::move(*next));
    }
  }
  return found;
}

std::vector<std::size_t> FlipGraph::components() const {
  const std::size_t unseen = triangulations.size();
  std::vector<std::size_t> component(triangulations.size(), unseen);
  std::size_t count = 0;
  for (std::size_t start = 0; start < component.size(); ++start) {
    if (component[start] != unseen) continue;
    std::deque<std::size_t> pending{start};
    component[start] = count;
    for (; !pending.empty(); pending.pop_front()) {
      for (const std::size_t next : neighbours[pending.front()]) {
        if (component[next] != unseen) continue;
        component[next] = count;
        pending.push_back(next);
      }
    }
    ++count;
  }
  return component;
}

bool FlipGraph::is_connected() const {
  const std::vector<std::size_t> component = components();
  return std::all_of(component.begin(), component.end(),
                     [](std::size_t number) { return number == 0; });
}

FlipGraph flip_graph_from(const PointSet& points, const Triangulation& start, VertexUse use) {
  const std::vector<Circuit> all_circuits = circuits(points);
  std::set<std::vector<Simplex>> seen{start.simplices()};
  std::deque<Triangulation> pending{start};
  std::vector<Triangulation> reached;
  for (; !pending.empty(); pending.pop_front()) {
    for (Triangulation& next : neighbours(pending.front(), all_circuits, use)) {
      if (seen.insert(next.simplices()).second) pending.push_back(std::move(next));
    }
    reached.push_back(pending.front());
  }
  return flip_graph_on(points, std::move(reached), use);
}

FlipGraph flip_graph_on(const PointSet& points, std::vector<Triangulation> triangulations,
                        VertexUse use) {
  const std::vector<Circuit> all_circuits = circuits(points);
  FlipGraph graph{std::move(triangulations), {}};
  std::sort(graph.triangulations.begin(), graph.triangulations.end(), ascending);
  for (const Triangulation& one : graph.triangulations) {
    std::set<std::size_t> found;
    for (const Triangulation& next : neighbours(one, all_circuits, use)) {
      const auto place = std::lower_bound(graph.triangulations.begin(), graph.triangulations.end(),
                                          next, ascending);
      if (place == graph.triangulations.end() || *place != next) continue;
      found.insert(static_cast<std::size_t>(place - graph.triangulations.begin()));
    }
    graph.neighbours.emplace_back(found.begin(), found.end());
  }
  return graph;
}

}  // namespace circumspect::optimality
