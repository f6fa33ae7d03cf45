// Judges a mesh in arrays, at its full size: exactly, and faster than programs make meshes.
//
//   std::vector<double> points = …;            // x y z, x y z, …
//   std::vector<std::int32_t> tetrahedra = …;  // four indices from 0 each
//   circumspect::MeshArrays<std::int32_t> mesh{.coordinates = points, .simplices = tetrahedra};
//   const auto found = circumspect::judge("delaunay", mesh);
//   if (!found.holds) puts(found.report.c_str());
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include <circumspect/judgement.hpp>

namespace circumspect {

// A view of a mesh in memory; nothing is copied while the fast judge decides. Index: std::int32_t
// or std::int64_t.
template <typename Index>
struct MeshArrays {
  std::size_t dimension = 3;                 // d, of the points and of the simplices
  std::span<const double> coordinates = {};  // d a point
  std::span<const double> weights = {};      // none, or one a point
  std::span<const Index> simplices = {};  // d + 1 indices of points a simplex, from 0, in any order
  // None, or as many as `simplices`: the index of the simplex across the facet opposite each
  // vertex, −1 where there is none. If they are given they are judged too (rule
  // "complex.wrong-neighbor"), and the judgement is faster.
  std::span<const Index> neighbors = {};
};

// How the answer was found.
struct JudgeCounts {
  // Did the fast judge decide, and if not, why not? In the plane and in space it decides wherever
  // the claim holds, or only some facets of a triangulation are not locally Delaunay. The slow
  // judge does the rest.
  bool fast = false;
  std::string why_not_fast = {};
  // For the fast judge: signs decided by doubles, and by integers.
  std::uint64_t filtered_signs = 0;
  std::uint64_t exact_signs = 0;
};

struct MeshJudgement : Judgement {
  // For a Delaunay claim that holds: is it the only Delaunay triangulation of the points? Is this
  // the canonical one, in which ties are broken by the lexicographic order of the points? Book:
  // Section 4.2.
  std::optional<bool> unique = {};
  std::optional<bool> canonical = {};
  JudgeCounts counts = {};
};

// As judge(claim, points, simplices) of judgement.hpp, word for word, for the claims
// "triangulation", "delaunay" and "weighted-delaunay" (Book: Definitions 2.1 and 4.1, Section 5.2).
// Throws std::invalid_argument: an unknown claim; arrays whose lengths do not agree; numbers that
// are not finite; equal points, and a mesh without points and simplices, unless `options` let them
// pass. Memory, while the fast judge decides: at most 32 bytes a simplex of a large mesh of space;
// with the neighbours given, about 1.
MeshJudgement judge(const std::string& claim, const MeshArrays<std::int32_t>& mesh,
                    const JudgeOptions& options = {});
MeshJudgement judge(const std::string& claim, const MeshArrays<std::int64_t>& mesh,
                    const JudgeOptions& options = {});

// For tests of any framework: throws DoesNotHold, with the witnesses, if the claim does not hold.
template <typename Index>
void assert_holds(const std::string& claim, const MeshArrays<Index>& mesh,
                  const JudgeOptions& options = {}) {
  const MeshJudgement found = judge(claim, mesh, options);
  if (!found.holds) throw DoesNotHold(found.report);
}

}  // namespace circumspect
