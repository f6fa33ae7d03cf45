// What all judges say of a mutant of the catalogue, held against what must be said.
#pragma once

#include <algorithm>
#include <limits>
#include <string>

#include <circumspect/check.hpp>

#include "oracle/judge/fast/judge.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/verdict.hpp"
#include "oracle/report/text.hpp"
#include "properties/mutations/catalogue.hpp"

namespace circumspect::properties {

inline fast::Question question_of(Claim claim) {
  if (claim == Claim::kTriangulation) return fast::Question::kTriangulation;
  return claim == Claim::kDelaunay ? fast::Question::kDelaunay : fast::Question::kWeightedDelaunay;
}

// Says "accepted", "not Delaunay", or why nothing is decided: the fast judge, for arrays of this
// type.
template <std::size_t kDimension, typename Index>
std::string said_fast(const ArrayMesh& mesh, Claim claim, unsigned threads) {
  const std::vector<Index> simplices(mesh.simplices.begin(), mesh.simplices.end());
  const std::vector<Index> neighbors(mesh.neighbors.begin(), mesh.neighbors.end());
  const fast::MeshView<kDimension, Index> view{mesh.coordinates, mesh.weights, simplices,
                                               neighbors};
  const auto facts = fast::judge(view, question_of(claim), threads);
  if (!facts) return std::string(description(facts.error()));
  return facts->holds() ? "accepted" : "not Delaunay";
}

inline bool fits_in_32_bits(const std::vector<std::int64_t>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(),
                     [](std::int64_t x) { return x == static_cast<std::int32_t>(x); });
}

// The same for one thread and for several, and for either type of indices, or "different answers:
// …".
inline std::string said_fast(const ArrayMesh& mesh, Claim claim) {
  const bool in_plane = mesh.dimension == 2;
  const std::string wide = in_plane ? said_fast<2, std::int64_t>(mesh, claim, 4)
                                    : said_fast<3, std::int64_t>(mesh, claim, 4);
  if (!fits_in_32_bits(mesh.simplices) || !fits_in_32_bits(mesh.neighbors)) return wide;
  const std::string narrow = in_plane ? said_fast<2, std::int32_t>(mesh, claim, 1)
                                      : said_fast<3, std::int32_t>(mesh, claim, 1);
  return wide == narrow ? wide : "different answers: " + wide + "; " + narrow;
}

// The mesh as the exact checkers see it, once it is exact: equal points merged.
inline Mesh mesh_of(const ArrayMesh& arrays, Claim claim) {
  Mesh mesh;
  mesh.coordinates = Rows<double>::of(arrays.coordinates, arrays.dimension);
  if (claim == Claim::kWeightedDelaunay && !arrays.weights.empty()) {
    mesh.weights = Rows<double>::of(arrays.weights, 1);
  }
  mesh.simplices = Rows<std::int64_t>::of(arrays.simplices, arrays.width());
  if (!arrays.neighbors.empty()) {
    mesh.neighbors.emplace(Rows<std::int64_t>::of(arrays.neighbors, arrays.width()), 0);
  }
  merge_equal_points(mesh);
  return mesh;
}

// Would the fast judge, asked alone, vouch for a mutant that it must not vouch for? What is wrong
// with what it says; empty if nothing. Of mutations that may do no harm nothing is known.
inline std::string fault_of_fast(const Mutation& mutation, const std::string& said) {
  const bool accepted = said == "accepted";
  switch (mutation.expected) {
    case Expected::kFails:
    case Expected::kEqualPoints:
      return accepted || said.starts_with("different") ? said : "";
    case Expected::kHolds:
      return accepted ? "" : said;
    case Expected::kEither:
      break;
  }
  return said.starts_with("different") ? said : "";
}

// Is a mutation that fails one that every claim sees, and not only those about balls?
inline bool breaks_any_triangulation(const Mutation& mutation) {
  return mutation.expected == Expected::kFails && !mutation.rules.contains(Rule::kFacetNotLocal) &&
         mutation.rules != std::set{Rule::kPointBelowPlane};
}

// Is it what the catalogue expects? What is wrong; empty if nothing.
inline std::string fault_of(const Mutation& mutation, const MeshJudgement& judged) {
  const Expected expected = mutation.expected;
  if (judged.holds) {
    // Equal points have been merged, then. That the fast judge sees them: fault_of_fast.
    return expected == Expected::kFails ? "holds" : "";
  }
  if (expected == Expected::kHolds || expected == Expected::kEqualPoints) return judged.report;
  const bool is_expected = expected == Expected::kEither ||
                           std::any_of(mutation.rules.begin(), mutation.rules.end(),
                                       [&](Rule rule) { return identifier(rule) == judged.rule; });
  return is_expected ? "" : "not expected: " + judged.rule;
}

// And is it what the checkers of oracle/judge/points say of the same mesh, word for word?
inline std::string fault_of(const Mutation& mutation, const MeshJudgement& judged,
                            const Verdict& slow, const Mesh& mesh) {
  if (judged.holds != slow.holds()) return "holds for one of the judges only";
  if (judged.unique != slow.unique || judged.canonical != slow.canonical) return "other facts";
  if (!judged.holds && judged.report != report::explanation(slow, mesh)) return "another report";
  return fault_of(mutation, judged);
}

inline MeshJudgement judge(Claim claim, const ArrayMesh& mesh, unsigned threads) {
  const MeshArrays<std::int64_t> view{mesh.dimension, mesh.coordinates, mesh.weights,
                                      mesh.simplices, mesh.neighbors};
  return circumspect::judge(std::string(name(claim)), view,
                            {.threads = threads, .merge_equal_points = true});
}

}  // namespace circumspect::properties
