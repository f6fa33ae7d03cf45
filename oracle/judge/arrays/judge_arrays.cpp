#include <stdexcept>
#include <string>

#include <circumspect/check.hpp>
#include <circumspect/judgement.hpp>

#include "oracle/judge/arrays/mesh_of.hpp"
#include "oracle/judge/fast/in_chunks.hpp"
#include "oracle/judge/judge.hpp"
#include "oracle/report/text.hpp"

namespace circumspect {

Claim arrays::claim_named(const std::string& claim) {
  for (const Claim known : {Claim::kTriangulation, Claim::kDelaunay, Claim::kWeightedDelaunay}) {
    if (claim == name(known)) return known;
  }
  throw std::invalid_argument("expected triangulation, delaunay or weighted-delaunay, found '" +
                              claim + "'");
}

namespace {

Verdict verdict_on(Claim claim, Mesh& mesh, const JudgeOptions& options) {
  if (mesh.points() == 0 && mesh.simplices.empty() && !options.allow_empty) {
    throw std::invalid_argument(
        "expected a mesh, found neither points nor simplices, as where a program made nothing; to "
        "judge an empty mesh, set allow_empty");
  }
  const check::Options own{.threads = options.threads};
  if (options.merge_equal_points) {
    return check::judge(claim, check::Merging{mesh}, nullptr, own);
  }
  auto verdict = check::judge(claim, mesh, nullptr, own);
  if (verdict) return *std::move(verdict);
  const auto& repeated = verdict.error().repeated;
  throw std::invalid_argument(report::fault_of_equal_points(
      repeated.front().kept, repeated.front().again, repeated.size(), "set merge_equal_points"));
}

}  // namespace

Judgement judge(const std::string& claim, const PointArray& points, const SimplexArray& simplices,
                const JudgeOptions& options) {
  const Claim known = arrays::claim_named(claim);
  Mesh mesh = arrays::mesh_of(points, simplices, known == Claim::kWeightedDelaunay);
  const Verdict verdict = verdict_on(known, mesh, options);
  if (verdict.holds()) return {true, "", ""};
  const Rule rule = verdict.violations().front().rule;
  return {false, std::string(identifier(rule)), report::explanation(verdict, mesh)};
}

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

// Uses the memory of the arrays.
template <typename Index>
Mesh mesh_of(const MeshArrays<Index>& arrays, bool weighted) {
  const std::size_t vertices = arrays.dimension + 1;
  Mesh mesh;
  mesh.coordinates = Rows<double>::of(arrays.coordinates, arrays.dimension);
  if (weighted && !arrays.weights.empty()) mesh.weights = Rows<double>::of(arrays.weights, 1);
  mesh.simplices = Rows<Index>::of(arrays.simplices, vertices);
  if (!arrays.neighbors.empty()) {
    mesh.neighbors.emplace(Rows<Index>::of(arrays.neighbors, vertices), 0);
  }
  return mesh;
}

template <typename Index>
MeshJudgement judged(const std::string& claim, const MeshArrays<Index>& arrays,
                     const JudgeOptions& options) {
  const Claim known = arrays::claim_named(claim);
  require_lengths(arrays);
  const unsigned threads = check::threads_of({.threads = options.threads});
  if (!fast::are_finite(arrays.coordinates, threads) ||
      !fast::are_finite(arrays.weights, threads)) {
    throw std::invalid_argument("expected finite coordinates and weights, found another");
  }
  Mesh mesh = mesh_of(arrays, known == Claim::kWeightedDelaunay);
  const Verdict verdict = verdict_on(known, mesh, options);
  MeshJudgement judgement;
  judgement.holds = verdict.holds();
  judgement.unique = verdict.unique;
  judgement.canonical = verdict.canonical;
  const Course& course = verdict.course;
  judgement.counts = {course.fast, course.why_not_fast, course.filtered_signs, course.exact_signs};
  if (!verdict.holds()) {
    judgement.rule = identifier(verdict.violations().front().rule);
    judgement.report = report::explanation(verdict, mesh);
  }
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
