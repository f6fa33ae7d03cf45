#include "oracle/judge/definition/simplicial_complex.hpp"

#include <algorithm>
#include <optional>

#include "kernel/complex/improper_intersection.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/predicates/orientation.hpp"

namespace circumspect::definition {
namespace {

// The first rule that a simplex breaks by itself.
std::optional<Violation> fault_of(const PointSet& points, const Simplex& simplex, bool has_size) {
  const auto breaks = [&](Rule rule, Simplex vertices) {
    return Violation{rule, {.simplices = {simplex}, .vertices = std::move(vertices)}};
  };
  for (const Vertex v : simplex) {
    if (!points.names(v)) return breaks(Rule::kUnknownVertex, {v});
  }
  if (!has_size) {
    return Violation{Rule::kWrongDimension,
                     {.simplices = {simplex}, .values = {{"vertices", simplex.size()}}}};
  }
  const Simplex ascending = sorted(simplex);
  const auto repeated = std::adjacent_find(ascending.begin(), ascending.end());
  if (repeated != ascending.end()) return breaks(Rule::kRepeatedVertex, {*repeated});
  if (axes_of(points.configuration(), simplex).size() + 1 < simplex.size()) {
    return breaks(Rule::kDegenerateSimplex, {});
  }
  return std::nullopt;
}

}  // namespace

bool judge_each_simplex(const ExactMesh& mesh, std::size_t size, Verdict& verdict) {
  const std::vector<Simplex>& simplices = mesh.simplices;
  bool sound = true;
  for (std::size_t s = 0; s < simplices.size(); ++s) {
    // Nothing is a simplex of the empty set, not even one without vertices.
    const bool has_size = !simplices[s].empty() && simplices[s].size() == size;
    auto fault = fault_of(mesh.points, simplices[s], has_size);
    if (!fault) continue;
    sound = false;
    fault->witness.places = {s};
    std::vector<NamedValue>& values = fault->witness.values;
    if (fault->rule == Rule::kWrongDimension) values.emplace_back("vertices expected", size);
    if (fault->rule == Rule::kDegenerateSimplex) values = {{"orientation determinant", 0}};
    verdict.add(fault->rule, fault->witness);
  }
  for (std::size_t a = 0; a < simplices.size(); ++a) {
    for (std::size_t b = a + 1; b < simplices.size(); ++b) {
      if (sorted(simplices[a]) != sorted(simplices[b])) continue;
      sound = false;
      verdict.add(Rule::kDuplicateSimplex,
                  {.simplices = {simplices[a], simplices[b]}, .places = {a, b}});
      break;  // the next one repeats that one
    }
  }
  return sound;
}

bool judge_each_face(const ExactMesh& mesh, std::size_t most, Verdict& verdict) {
  bool sound = true;
  for (const Simplex& face : mesh.faces) {
    const auto fault = fault_of(mesh.points, face, 2 <= face.size() && face.size() <= most);
    if (!fault) continue;
    sound = false;
    verdict.add(fault->rule, fault->witness);
  }
  return sound;
}

bool judge_every_two(const PointSet& points, const std::vector<Simplex>& simplices,
                     Verdict& verdict) {
  bool proper = true;
  for (std::size_t a = 0; a < simplices.size(); ++a) {
    for (std::size_t b = a + 1; b < simplices.size(); ++b) {
      const auto common = improper_intersection(points, simplices[a], simplices[b]);
      if (!common) continue;
      proper = false;
      verdict.add(Rule::kOverlap, {.simplices = {simplices[a], simplices[b]}, .point = common});
    }
  }
  return proper;
}

}  // namespace circumspect::definition
