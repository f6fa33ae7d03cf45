#include "oracle/judge/points/simplices.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "kernel/predicates/orientation.hpp"

namespace circumspect::check {
namespace {

// The first rule that one simplex breaks by itself, or none. `ascending`: its vertices. Sets its
// orientation.
std::optional<Violation> fault_of_simplex(const ExactMesh& mesh, std::size_t place,
                                          const Simplex& ascending, int& orientation_of_it) {
  const PointSet& points = mesh.points;
  const Simplex& simplex = mesh.simplices[place];
  Witness witness{.simplices = {simplex}, .places = {place}};
  const auto unknown =
      std::find_if(simplex.begin(), simplex.end(), [&](Vertex v) { return !points.names(v); });
  if (unknown != simplex.end()) {
    witness.vertices = {*unknown};
    return Violation{Rule::kUnknownVertex, std::move(witness)};
  }
  // Nothing is a simplex of the empty set, not even one without vertices.
  if (simplex.empty() || static_cast<int>(simplex.size()) != points.dimension() + 1) {
    witness.values = {{"vertices", simplex.size()}, {"vertices expected", points.dimension() + 1}};
    return Violation{Rule::kWrongDimension, std::move(witness)};
  }
  const auto twice = std::adjacent_find(ascending.begin(), ascending.end());
  if (twice != ascending.end()) {
    witness.vertices = {*twice};
    return Violation{Rule::kRepeatedVertex, std::move(witness)};
  }
  orientation_of_it = orientation(points.configuration(), simplex);
  if (orientation_of_it != 0) return std::nullopt;
  witness.values = {{"orientation determinant", Rational(0)}};
  return Violation{Rule::kDegenerateSimplex, std::move(witness)};
}

bool judge_duplicates(const ExactMesh& mesh, const std::vector<Simplex>& ascending,
                      Verdict& verdict) {
  std::vector<std::size_t> order(ascending.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return ascending[a] < ascending[b]; });
  bool distinct = true;
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (ascending[order[i]] != ascending[order[i - 1]]) continue;
    distinct = false;
    verdict.add(Rule::kDuplicateSimplex,
                {.simplices = {mesh.simplices[order[i - 1]], mesh.simplices[order[i]]},
                 .places = {order[i - 1], order[i]}});
  }
  return distinct;
}

// The majority counts as right, whichever comes first, so that the order of the list changes no
// count.
int orientation_of_most(const std::vector<int>& orientations) {
  const auto positive = std::count(orientations.begin(), orientations.end(), 1);
  return 2 * positive >= std::ssize(orientations) ? 1 : -1;
}

void judge_orientations(const ExactMesh& mesh, const std::vector<int>& orientations, int of_most,
                        Verdict& verdict) {
  const auto example = std::find(orientations.begin(), orientations.end(), of_most);
  for (std::size_t s = 0; s < orientations.size(); ++s) {
    if (orientations[s] == of_most) continue;
    const auto place = static_cast<std::size_t>(example - orientations.begin());
    verdict.add(Rule::kOrientation, {.simplices = {mesh.simplices[place], mesh.simplices[s]},
                                     .values = {{"orientation of most", of_most},
                                                {"orientation of the other", orientations[s]}}});
  }
}

}  // namespace

bool judge_simplices(const ExactMesh& mesh, bool oriented, Verdict& verdict,
                     std::optional<int> of_most) {
  bool sound = true;
  std::vector<int> orientations(mesh.simplices.size(), 0);
  std::vector<Simplex> ascending = mesh.simplices;
  for (std::size_t s = 0; s < mesh.simplices.size(); ++s) {
    std::sort(ascending[s].begin(), ascending[s].end());
    const auto fault = fault_of_simplex(mesh, s, ascending[s], orientations[s]);
    if (fault) verdict.add(fault->rule, fault->witness);
    sound &= !fault;
  }
  sound &= judge_duplicates(mesh, ascending, verdict);
  if (sound && oriented) {
    judge_orientations(mesh, orientations, of_most.value_or(orientation_of_most(orientations)),
                       verdict);
  }
  return sound;
}

std::vector<Vertex> unused_points(const ExactMesh& mesh) {
  std::vector<bool> used(mesh.points.size(), false);
  for (const Simplex& simplex : mesh.simplices) {
    for (const Vertex v : simplex) {
      if (mesh.points.names(v)) used[static_cast<std::size_t>(v)] = true;
    }
  }
  std::vector<Vertex> unused;
  for (Vertex v = 0; mesh.points.names(v); ++v) {
    if (!used[static_cast<std::size_t>(v)]) unused.push_back(v);
  }
  return unused;
}

void judge_vertex_set(const ExactMesh& mesh, Verdict& verdict) {
  for (const Vertex v : unused_points(mesh)) {
    verdict.add(Rule::kUnusedPoint, {.vertices = {v}, .point = mesh.points[v]});
  }
}

}  // namespace circumspect::check
