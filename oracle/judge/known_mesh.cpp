#include "oracle/judge/known_mesh.hpp"

#include <utility>

#include "oracle/judge/domain/judge_domain.hpp"

namespace circumspect::check {

OrReason<fast::SimplexFacts> facts_of_simplices(Claim claim, const Mesh& mesh, DomainKind kind,
                                                const Options& options) {
  if (options.by != By::kLemma) return because("judged by definition");
  const fast::Wanted wanted{.balls = is_about_balls(claim),
                            .hull = kind == DomainKind::kHull,
                            .boundary_balls = claim == Claim::kConformingDelaunay};
  return asked_of_rows<fast::SimplexFacts>(
      mesh, false, [&](const auto& view) -> OrReason<fast::SimplexFacts> {
        auto facts = fast::simplex_facts(view, wanted, threads_of(options));
        if (!facts) return because(description(facts.error()));
        if (options.oriented && !facts->oriented) return because("simplices oriented by turns");
        return std::move(*facts);
      });
}

KnownMesh::KnownMesh(Claim claim, const Mesh& mesh, DomainKind kind, const Options& options)
    : exact(circumspect::exact(mesh)) {
  auto found = facts_of_simplices(claim, mesh, kind, options);
  if (found) facts = std::move(*found);
}

}  // namespace circumspect::check
