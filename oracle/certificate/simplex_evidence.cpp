#include <algorithm>
#include <numeric>

#include "oracle/certificate/evidence.hpp"
#include "oracle/certificate/face_uses.hpp"
#include "oracle/judge/points/simplices.hpp"

namespace circumspect::certificate {
namespace {

Integer number(std::size_t index) { return Integer(static_cast<unsigned long>(index)) + 1; }
Integer position(std::size_t index) { return static_cast<unsigned long>(index); }

// The entry that names no point.
std::optional<std::size_t> unknown_entry(const ExactMesh& mesh, const Simplex& simplex) {
  const auto unknown =
      std::find_if(simplex.begin(), simplex.end(), [&](Vertex v) { return !mesh.points.names(v); });
  if (unknown == simplex.end()) return std::nullopt;
  return static_cast<std::size_t>(unknown - simplex.begin());
}

// What one simplex shows about a rule.
std::optional<std::vector<Integer>> fault_of(const ExactMesh& mesh, Sidedness& sidedness,
                                             std::size_t s, Rule rule) {
  const Simplex& simplex = mesh.simplices[s];
  const bool has_right_size = simplex.size() == mesh.points.ambient_dimension() + 1;
  const auto unknown = unknown_entry(mesh, simplex);
  if (rule == Rule::kUnknownVertex && unknown) return {{number(s), position(*unknown)}};
  if (rule == Rule::kWrongDimension && !has_right_size) return {{number(s)}};
  if (rule == Rule::kRepeatedVertex) {
    for (std::size_t i = 0; i < simplex.size(); ++i) {
      for (std::size_t j = i + 1; j < simplex.size(); ++j) {
        if (simplex[i] == simplex[j]) return {{number(s), position(i), position(j)}};
      }
    }
  }
  if (rule == Rule::kDegenerateSimplex && has_right_size && !unknown &&
      sidedness.orientation(simplex) == 0) {
    return {{number(s)}};
  }
  return std::nullopt;
}

std::optional<std::vector<Integer>> same_vertices(const ExactMesh& mesh) {
  std::vector<Simplex> ascending;
  for (const Simplex& simplex : mesh.simplices) ascending.push_back(sorted(simplex));
  std::vector<std::size_t> order(ascending.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return ascending[a] < ascending[b]; });
  const auto twice = std::adjacent_find(
      order.begin(), order.end(),
      [&](std::size_t a, std::size_t b) { return ascending[a] == ascending[b]; });
  if (twice == order.end()) return std::nullopt;
  return {{number(*twice), number(*(twice + 1))}};
}

std::optional<std::vector<Integer>> overused_facet(const ExactMesh& mesh) {
  std::vector<FaceUse> uses = facets(mesh);
  std::optional<std::vector<Integer>> because;
  for_each_face(uses, [&](std::span<const FaceUse> group) {
    if (group.size() < 3 || because) return;
    because.emplace();
    for (const FaceUse& use : group.first(3)) {
      because->push_back(number(use.cell));
      because->push_back(position(use.place));
    }
  });
  return because;
}

std::optional<std::vector<Integer>> find(const ExactMesh& mesh, const ScaledPoints& points,
                                         Rule rule) {
  switch (rule) {
    case Rule::kDuplicateSimplex:
      return same_vertices(mesh);
    case Rule::kFacetOverused:
      return overused_facet(mesh);
    case Rule::kUnusedPoint: {
      const std::vector<Vertex> unused = check::unused_points(mesh);
      if (unused.empty()) return std::nullopt;
      return {{number(static_cast<std::size_t>(unused.front()))}};
    }
    default:
      break;
  }
  Sidedness sidedness(points);
  for (std::size_t s = 0; s < mesh.simplices.size(); ++s) {
    if (auto because = fault_of(mesh, sidedness, s, rule)) return because;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Evidence> simplex_evidence(const ExactMesh& mesh, const ScaledPoints& points,
                                         Rule rule) {
  auto because = find(mesh, points, rule);
  if (!because) return std::nullopt;
  return Evidence{rule, std::move(*because)};
}

}  // namespace circumspect::certificate
