#include "oracle/check/flat/judge_flat.hpp"

#include <algorithm>
#include <cstdint>
#include <thread>
#include <type_traits>
#include <variant>

#include "oracle/fast/judge.hpp"

namespace circumspect::check {
namespace {

std::optional<fast::Question> question_of(Claim claim) {
  switch (claim) {
    case Claim::kTriangulation:
      return fast::Question::kTriangulation;
    case Claim::kDelaunay:
      return fast::Question::kDelaunay;
    case Claim::kWeightedDelaunay:
      return fast::Question::kWeightedDelaunay;
    default:
      return std::nullopt;
  }
}

template <std::size_t kDimension, class Index>
std::optional<fast::Facts> facts_of(fast::Question question, const formats::FlatMesh& mesh,
                                    const formats::FlatRows<Index>& simplices, unsigned threads) {
  if (simplices.columns() != kDimension + 1) return std::nullopt;
  fast::MeshView<kDimension, Index> view{mesh.points.coordinates.values(), {}, simplices.values()};
  if (question == fast::Question::kWeightedDelaunay) {
    if (mesh.points.weights.rows() != mesh.points.coordinates.rows()) return std::nullopt;
    view.weights = mesh.points.weights.values();
  }
  if (mesh.neighbors) {
    if constexpr (std::is_same_v<Index, std::int32_t>) {
      view.neighbors = mesh.neighbors->values();
    } else {
      return std::nullopt;
    }
  }
  const auto facts = fast::judge(view, question, threads);
  return facts ? std::optional(*facts) : std::nullopt;
}

std::optional<fast::Facts> facts_of(fast::Question question, const formats::FlatMesh& mesh,
                                    unsigned threads) {
  return std::visit(
      [&](const auto& simplices) -> std::optional<fast::Facts> {
        if (mesh.dimension() == 2) return facts_of<2>(question, mesh, simplices, threads);
        if (mesh.dimension() == 3) return facts_of<3>(question, mesh, simplices, threads);
        return std::nullopt;
      },
      mesh.simplices);
}

}  // namespace

std::optional<Verdict> judge_flat(Claim claim, const formats::FlatMesh& mesh,
                                  const Options& options, unsigned threads) {
  const std::optional<fast::Question> question = question_of(claim);
  if (!question || options.by != By::kLemma) return std::nullopt;
  if (threads == 0) threads = std::max(1U, std::thread::hardware_concurrency());
  const std::optional<fast::Facts> facts = facts_of(*question, mesh, threads);
  if (!facts || (options.oriented && !facts->oriented)) return std::nullopt;
  Verdict verdict(claim, Mesh{PointSet({}), {}}, options.max_violations);
  verdict.points = mesh.points.coordinates.rows();
  verdict.simplices = std::visit([](const auto& rows) { return rows.rows(); }, mesh.simplices);
  verdict.dimension = static_cast<int>(mesh.dimension());
  if (claim != Claim::kTriangulation) {
    verdict.unique = facts->unique;
    verdict.canonical = facts->canonical;
  }
  return verdict;
}

}  // namespace circumspect::check
