// For tests: meshes as arrays, and the verdicts of both judges on them.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <circumspect/check.hpp>

#include "kernel/predicates/orientation.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::arrays {

struct MeshInArrays {
  std::size_t dimension = 0;
  std::vector<double> coordinates = {};
  std::vector<double> weights = {};
  std::vector<std::int64_t> simplices = {};
  std::vector<std::int64_t> neighbors = {};

  MeshArrays<std::int64_t> view() const {
    return {dimension, coordinates, weights, simplices, neighbors};
  }
};

// Appends the number; false if it is not a double.
inline bool append(const Rational& number, std::vector<double>& doubles) {
  doubles.push_back(number.get_d());
  return exact_value(doubles.back()) == number;
}

inline bool append(const std::vector<Vertex>& row, std::vector<std::int64_t>& indices) {
  indices.insert(indices.end(), row.begin(), row.end());
  return true;
}

// Nothing if some number is not a double, or a row does not have d + 1 entries.
inline std::optional<MeshInArrays> arrays_of(const ExactMesh& mesh) {
  MeshInArrays arrays{.dimension = mesh.points.ambient_dimension()};
  bool fits = arrays.dimension > 0;
  for (const Point& point : mesh.points.points()) {
    for (const Rational& x : point) fits &= append(x, arrays.coordinates);
    if (!mesh.points.is_weighted()) continue;
    const auto v = static_cast<Vertex>(arrays.weights.size());
    fits &= append(mesh.points.weight(v), arrays.weights);
  }
  for (const Simplex& simplex : mesh.simplices) {
    fits &= simplex.size() == arrays.dimension + 1 && append(simplex, arrays.simplices);
  }
  if (mesh.neighbors) {
    for (std::vector<Vertex> row : mesh.neighbors->rows) {
      for (Vertex& s : row) s -= s == -1 ? 0 : mesh.neighbors->first_index;
      fits &= append(row, arrays.neighbors);
    }
  }
  if (!fits) return std::nullopt;
  return arrays;
}

// The mesh without the user's own indices, which arrays do not have.
inline ExactMesh without_labels(ExactMesh mesh) {
  mesh.labels.clear();
  mesh.first_index = 0;
  if (mesh.neighbors) {
    for (std::vector<Vertex>& row : mesh.neighbors->rows) {
      for (Vertex& s : row) s -= s == -1 ? 0 : mesh.neighbors->first_index;
    }
    mesh.neighbors->first_index = 0;
  }
  return mesh;
}

// For the plane or space.
inline bool has_sound_simplex(const ExactMesh& mesh) {
  const std::size_t d = mesh.points.ambient_dimension();
  if ((d != 2 && d != 3) || mesh.points.dimension() != static_cast<int>(d)) return false;
  return std::any_of(mesh.simplices.begin(), mesh.simplices.end(), [&](const Simplex& simplex) {
    const bool names_points =
        std::all_of(simplex.begin(), simplex.end(), [&](Vertex v) { return mesh.points.names(v); });
    return names_points && simplex.size() == d + 1 &&
           orientation(mesh.points.configuration(), simplex) != 0;
  });
}

// How the judgement of the arrays differs from that of oracle/judge/points; empty if it does not.
inline std::string difference_from_slow(Claim claim, const ExactMesh& labelled,
                                        const MeshJudgement& judgement) {
  const ExactMesh mesh = without_labels(labelled);
  const Verdict verdict = check::judge_exactly(claim, mesh);
  const std::string explanation =
      verdict.holds() ? "" : report::explanation(verdict, in_rows(mesh));
  if (judgement.holds != verdict.holds()) return "holds";
  if (judgement.report != explanation) return "report";
  if (judgement.unique != verdict.unique) return "unique";
  if (judgement.canonical != verdict.canonical) return "canonical";
  // Whether weighted points that are not vertices are submerged is left to oracle/judge/points.
  if (!judgement.counts.fast && !verdict.holds() && claim != Claim::kWeightedDelaunay &&
      has_sound_simplex(mesh)) {
    return "decided too little";
  }
  return "";
}

}  // namespace circumspect::arrays
