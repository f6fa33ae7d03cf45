#include <algorithm>
#include <stdexcept>
#include <string>
#include <thread>

#include <circumspect/check.hpp>

#include "oracle/judge/arrays/claim_named.hpp"
#include "oracle/judge/arrays/mesh_of.hpp"
#include "oracle/judge/fast/judge.hpp"
#include "oracle/judge/points/check.hpp"
#include "oracle/judge/verdict_of_facts.hpp"
#include "oracle/report/text.hpp"

namespace circumspect {
namespace {

void require(bool agrees, const std::string& expected, std::size_t found) {
  if (agrees) return;
  throw std::invalid_argument("expected " + expected + ", found " + std::to_string(found));
}

template <typename Index>
void require_lengths(const MeshArrays<Index>& mesh) {
  require(mesh.dimension > 0, "a dimension of at least 1", mesh.dimension);
  const std::size_t vertices = mesh.dimension + 1;
  require(mesh.coordinates.size() % mesh.dimension == 0,
          std::to_string(mesh.dimension) + " coordinates a point", mesh.coordinates.size());
  require(mesh.simplices.size() % vertices == 0, std::to_string(vertices) + " indices a simplex",
          mesh.simplices.size());
  require(mesh.weights.empty() || mesh.weights.size() * mesh.dimension == mesh.coordinates.size(),
          "one weight a point", mesh.weights.size());
  require(mesh.neighbors.empty() || mesh.neighbors.size() == mesh.simplices.size(),
          "as many neighbours as indices of simplices, " + std::to_string(mesh.simplices.size()),
          mesh.neighbors.size());
}

fast::Question question_of(Claim claim) {
  if (claim == Claim::kTriangulation) return fast::Question::kTriangulation;
  return claim == Claim::kDelaunay ? fast::Question::kDelaunay : fast::Question::kWeightedDelaunay;
}

MeshJudgement judgement_of(const Verdict& verdict, const Mesh& mesh) {
  MeshJudgement judgement;
  judgement.holds = verdict.holds();
  judgement.unique = verdict.unique;
  judgement.canonical = verdict.canonical;
  if (!verdict.holds()) {
    judgement.rule = identifier(verdict.violations().front().rule);
    judgement.report = report::explanation(verdict, mesh);
  }
  return judgement;
}

// What the fast judge knows, or why it knows nothing.
template <std::size_t kDimension, typename Index>
MeshJudgement judged_fast(Claim claim, const MeshArrays<Index>& mesh, unsigned threads) {
  const fast::MeshView<kDimension, Index> view{mesh.coordinates, mesh.weights, mesh.simplices,
                                               mesh.neighbors};
  const auto facts = fast::judge(view, question_of(claim), threads);
  if (!facts) {
    MeshJudgement unknown;
    unknown.counts.why_not_fast = description(facts.error());
    return unknown;
  }
  const check::FlatVerdict found = check::verdict_of_facts(claim, view, 0, *facts, {});
  MeshJudgement judgement = judgement_of(found.verdict, found.named);
  judgement.counts = {true, "", facts->stages.filtered, facts->stages.exact()};
  return judgement;
}

template <typename Index>
std::vector<std::vector<std::int64_t>> rows_of(std::span<const Index> array, std::size_t width) {
  std::vector<std::vector<std::int64_t>> rows;
  rows.reserve(array.size() / width);
  for (std::size_t begin = 0; begin < array.size(); begin += width) {
    const auto row = array.subspan(begin, width);
    rows.emplace_back(row.begin(), row.end());
  }
  return rows;
}

template <typename Index>
MeshJudgement judged_slowly(Claim claim, const MeshArrays<Index>& arrays) {
  const PointArray points{arrays.dimension,
                          {arrays.coordinates.begin(), arrays.coordinates.end()},
                          {arrays.weights.begin(), arrays.weights.end()}};
  Mesh mesh = arrays::mesh_of(points, rows_of(arrays.simplices, arrays.dimension + 1),
                              claim == Claim::kWeightedDelaunay);
  if (!arrays.neighbors.empty()) {
    mesh.neighbors = Neighbors{{}, 0};
    for (const std::vector<std::int64_t>& row : rows_of(arrays.neighbors, arrays.dimension + 1)) {
      mesh.neighbors->rows.emplace_back(row.begin(), row.end());
    }
  }
  return judgement_of(check::judge(claim, mesh), mesh);
}

template <typename Index>
MeshJudgement judged(const std::string& claim, const MeshArrays<Index>& mesh,
                     const JudgeOptions& options) {
  const Claim known = arrays::claim_named(claim);
  require_lengths(mesh);
  const unsigned threads =
      options.threads > 0 ? options.threads : std::max(1U, std::thread::hardware_concurrency());
  MeshJudgement judgement;
  if (mesh.dimension == 2) {
    judgement = judged_fast<2>(known, mesh, threads);
  } else if (mesh.dimension == 3) {
    judgement = judged_fast<3>(known, mesh, threads);
  } else {
    judgement.counts.why_not_fast = "a dimension other than 2 and 3";
  }
  if (judgement.counts.fast) return judgement;
  const std::string why_not_fast = judgement.counts.why_not_fast;
  judgement = judged_slowly(known, mesh);
  judgement.counts.why_not_fast = why_not_fast;
  return judgement;
}

}  // namespace

MeshJudgement judge(const std::string& claim, const MeshArrays<std::int32_t>& mesh,
                    const JudgeOptions& options) {
  return judged(claim, mesh, options);
}

MeshJudgement judge(const std::string& claim, const MeshArrays<std::int64_t>& mesh,
                    const JudgeOptions& options) {
  return judged(claim, mesh, options);
}

}  // namespace circumspect
