#include "oracle/judge/judge_flat.hpp"

#include <algorithm>
#include <cstdint>
#include <thread>
#include <utility>
#include <variant>

#include "oracle/judge/fast/judge.hpp"
#include "oracle/judge/mesh_of_doubles.hpp"
#include "oracle/judge/shared_facets.hpp"

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

unsigned or_all(unsigned threads) {
  return threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency());
}

// Calls `conclude(view, facts)` if the fast judge knows any.
template <std::size_t kDimension, class Index, class Conclude>
void judge_rows(Claim claim, const formats::FlatMesh& mesh,
                const formats::FlatRows<Index>& simplices, const Options& options, unsigned threads,
                const Conclude& conclude) {
  if (simplices.columns() != kDimension + 1) return;
  fast::MeshView<kDimension, Index> view{mesh.points.coordinates.values(), {}, simplices.values()};
  if (claim == Claim::kWeightedDelaunay) {
    if (mesh.points.weights.rows() != mesh.points.coordinates.rows()) return;
    view.weights = mesh.points.weights.values();
  }
  const fast::Question question = *question_of(claim);
  const auto facts = mesh.neighbors
                         ? fast::judge(view, fast::Links<std::int32_t>(mesh.neighbors->values()),
                                       question, or_all(threads))
                         : fast::judge(view, question, or_all(threads));
  if (facts && (!options.oriented || facts->oriented)) conclude(view, *facts);
}

template <class Conclude>
void judge_arrays(Claim claim, const formats::FlatMesh& mesh, const Options& options,
                  unsigned threads, const Conclude& conclude) {
  if (!question_of(claim) || options.by != By::kLemma) return;
  std::visit(
      [&](const auto& simplices) {
        if (mesh.dimension() == 2) {
          judge_rows<2>(claim, mesh, simplices, options, threads, conclude);
        } else if (mesh.dimension() == 3) {
          judge_rows<3>(claim, mesh, simplices, options, threads, conclude);
        }
      },
      mesh.simplices);
}

}  // namespace

std::optional<FlatVerdict> judge_flat(Claim claim, const formats::FlatMesh& mesh,
                                      const Options& options, unsigned threads) {
  std::optional<FlatVerdict> verdict;
  judge_arrays(claim, mesh, options, threads, [&](const auto& view, const fast::Facts& facts) {
    verdict = verdict_of_facts(claim, view, mesh.points.first_index, facts, options);
  });
  return verdict;
}

std::optional<Verdict> judge_as_doubles(Claim claim, const Mesh& mesh, const Options& options,
                                        unsigned threads) {
  std::optional<Verdict> verdict;
  if (options.by != By::kLemma) return verdict;
  const std::optional<formats::FlatMesh> flat = mesh_of_doubles(mesh);
  if (!flat) return verdict;
  judge_arrays(claim, *flat, options, threads, [&](const auto& view, const fast::Facts& facts) {
    if (facts.holds()) {
      verdict = verdict_of_facts(claim, view, 0, facts, options).verdict;
    } else {
      verdict = not_locally_delaunay(claim, mesh, shared_facets(view, facts.not_local), options);
    }
  });
  return verdict;
}

}  // namespace circumspect::check
