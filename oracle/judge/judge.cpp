#include "oracle/judge/judge.hpp"

#include <cassert>
#include <optional>
#include <string_view>
#include <utility>

#include "oracle/judge/complex/judge_complex.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "oracle/judge/failing_complex.hpp"
#include "oracle/judge/fast/judge.hpp"
#include "oracle/judge/fast_view.hpp"
#include "oracle/judge/held_complex.hpp"
#include "oracle/judge/held_surface.hpp"
#include "oracle/judge/known_mesh.hpp"
#include "oracle/judge/periodic/judge_periodic.hpp"
#include "oracle/judge/quality/judge_quality.hpp"
#include "oracle/judge/stray_faces.hpp"
#include "oracle/judge/verdict_of_faults.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::check {
namespace {

using FactsOrUndecided = tl::expected<fast::Facts, fast::Undecided>;

// With the neighbours that the mesh lists, if it does.
template <std::size_t kDimension, class Index>
FactsOrUndecided facts_of(const Mesh& mesh, fast::MeshView<kDimension, Index> view,
                          fast::Question question, unsigned threads,
                          std::optional<fast::SweptMesh>& swept) {
  if (!mesh.neighbors) return fast::judge(view, question, threads, &swept);
  const IndexLists& listed = mesh.neighbors->rows;
  if (!mesh.neighbors->are_as_listed && listed.size() == view.size() &&
      listed.columns() == kDimension + 1) {
    if (const auto* const narrow = listed.rows<std::int32_t>()) {
      return fast::judge(view, fast::Links<std::int32_t>(narrow->values()), question, threads);
    }
    if constexpr (std::is_same_v<Index, std::int64_t>) {
      view.neighbors = listed.rows<std::int64_t>()->values();
      return fast::judge(view, question, threads);
    }
  }
  return tl::unexpected(fast::Undecided::kUnmatchedNeighbor);
}

OrReason<Verdict> judged_fast(Claim claim, const Mesh& mesh, const Options& options,
                              std::optional<fast::SweptMesh>& swept) {
  const bool weighted = claim == Claim::kWeightedDelaunay && mesh.is_weighted();
  return asked_of_rows<Verdict>(mesh, weighted, [&](const auto& view) -> OrReason<Verdict> {
    const auto facts = facts_of(mesh, view, question_of(claim), threads_of(options), swept);
    if (!facts) return because(description(facts.error()));
    if (options.oriented && !facts->oriented) return because("simplices oriented by turns");
    Verdict verdict = verdict_of_facts(claim, view, *facts, options);
    verdict.course = {true, "", facts->stages.filtered, facts->stages.exact()};
    return verdict;
  });
}

// Of a mesh that is at fault, and has no equal points.
OrReason<Verdict> judged_by_faults(Claim claim, const Mesh& mesh, const Options& options,
                                   std::optional<fast::SweptMesh> swept) {
  const bool weighted = claim == Claim::kWeightedDelaunay && mesh.is_weighted();
  return asked_of_rows<Verdict>(mesh, weighted, [&](const auto& view) -> OrReason<Verdict> {
    const auto faults =
        fast::faults(view, question_of(claim), threads_of(options), std::move(swept));
    if (!faults) return because(description(faults.error()));
    auto verdict = verdict_of_faults(claim, view, mesh.neighbors ? &*mesh.neighbors : nullptr,
                                     *faults, options);
    if (!verdict) return because(description(fast::Undecided::kUnusedPoint));
    verdict->course = {true, "", faults->stages.filtered, faults->stages.exact()};
    return std::move(*verdict);
  });
}

Verdict judged_in_domain(Claim claim, const KnownMesh& mesh, const Domain& domain,
                         const Options& options) {
  const auto& facts = mesh.facts();
  std::optional<Verdict> at_once = mesh.held(claim, domain, options);
  if (!at_once && claim == Claim::kConformingDelaunay) {
    at_once = mesh.not_conforming(domain, options);
  }
  Verdict verdict = at_once ? *std::move(at_once)
                            : judge_exactly(claim, mesh.exact(), &domain, options, mesh.known());
  if (facts) {
    verdict.course = {true, "", facts->stages.filtered, facts->stages.exact()};
  } else {
    verdict.course.why_not_fast = facts.error();
  }
  return verdict;
}

// The simplices alone.
Verdict simplices_as_complex(const Mesh& mesh, const Options& options) {
  const bool by_definition = options.by == By::kDefinition;
  if (!by_definition) {
    const auto found =
        asked_of_rows<Verdict>(mesh, false, [&](const auto& view) -> OrReason<Verdict> {
          const unsigned threads = threads_of(options);
          auto held = held_complex(view, options.complex, options.max_violations, threads);
          if (held) return std::move(*held);
          auto failing = failing_complex(view, options.complex, options.max_violations, threads);
          if (failing) return std::move(*failing);
          return because("something to be asked of exact numbers");
        });
    if (found) return *found;
    auto surface = held_surface(mesh, options.complex, options.max_violations);
    if (surface) return std::move(*surface);
  }
  return judge_complex({mesh.exact_points(), mesh.simplices.lists()}, options.complex,
                       by_definition, options.max_violations, improper_of_surface(mesh));
}

// What is equal breaks a rule of this claim, and is not an error.
Verdict judged_as_complex(const Mesh& mesh, const Options& options) {
  Verdict verdict = simplices_as_complex(mesh, options);
  if (options.complex.faces) judge_listed_faces(mesh, options.by, verdict);
  return verdict;
}

using VerdictOrEqualPoints = tl::expected<Verdict, EqualPoints>;

// By lemma, a claim about a mesh of points.
VerdictOrEqualPoints judged_as_points(Claim claim, const Mesh& mesh, const Options& options) {
  std::optional<fast::SweptMesh> swept;
  OrReason<Verdict> verdict = judged_fast(claim, mesh, options, swept);
  if (verdict) return std::move(*verdict);
  const std::string_view why_not_fast = verdict.error();
  std::vector<Duplicate> repeated = equal_points(mesh);
  if (!repeated.empty()) return tl::unexpected(EqualPoints{std::move(repeated)});
  verdict = judged_by_faults(claim, mesh, options, std::move(swept));
  if (verdict) return std::move(*verdict);
  Verdict exactly = judge_exactly(claim, exact(mesh), nullptr, options);
  exactly.course.why_not_fast = why_not_fast;
  return exactly;
}

// The claim alone, without what is required of the shape of simplices.
VerdictOrEqualPoints judged(Claim claim, const Mesh& mesh, const Domain* domain,
                            const Options& options) {
  assert((domain != nullptr) == is_about_a_domain(claim));
  if (claim == Claim::kComplex) return judged_as_complex(mesh, options);
  if (claim == Claim::kPeriodicDelaunay) return judge_periodic(mesh, options);
  const bool is_about_list = is_about_a_list(claim);
  const bool by_lemma = options.by == By::kLemma;
  if (by_lemma && domain == nullptr && !is_about_list) {
    return judged_as_points(claim, mesh, options);
  }
  std::vector<Duplicate> repeated = equal_points(mesh);
  if (!repeated.empty()) return tl::unexpected(EqualPoints{std::move(repeated)});
  if (domain != nullptr) {
    const KnownMesh known(claim, mesh, domain->complex.kind, options);
    return judged_in_domain(claim, known, *domain, options);
  }
  Verdict verdict = judge_exactly(claim, exact(mesh), domain, options);
  verdict.course.why_not_fast = is_about_list ? "a claim about a list" : "judged by definition";
  return verdict;
}

}  // namespace

tl::expected<Verdict, EqualPoints> judge(Claim claim, const Mesh& mesh, const Domain* domain,
                                         const Options& options) {
  auto verdict = judged(claim, mesh, domain, options);
  if (verdict) judge_quality(mesh, domain, 0, options, *verdict);
  return verdict;
}

Verdict judge(Claim claim, const KnownMesh& mesh, const Domain& domain, const Options& options) {
  Verdict verdict = judged_in_domain(claim, mesh, domain, options);
  judge_quality(mesh.mesh(), &domain, 0, options, verdict);
  return verdict;
}

Verdict judge(Claim claim, Merging merging, const Domain* domain, const Options& options) {
  Mesh& mesh = merging.mesh;
  if (claim != Claim::kComplex) {
    auto verdict = judge(claim, mesh, domain, options);
    if (verdict) return std::move(*verdict);
  }
  const std::vector<Duplicate> repeated = merge_equal_points(mesh);
  if (merging.merged != nullptr) {
    merging.merged->insert(merging.merged->end(), repeated.begin(), repeated.end());
  }
  return judge(claim, mesh, domain, options).value();
}

}  // namespace circumspect::check
