#include "oracle/judge/known_mesh.hpp"

#include <utility>

#include "oracle/judge/domain/judge_domain.hpp"
#include "oracle/judge/domain/triangle_walls.hpp"
#include "oracle/judge/not_conforming.hpp"

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

const ExactMesh& KnownMesh::exact() const {
  if (!exact_) exact_ = circumspect::exact(mesh_);
  return *exact_;
}

template <class Ask>
std::optional<Verdict> KnownMesh::asked_of_space(const Ask& ask) const {
  if (!facts_ || mesh_.neighbors) return std::nullopt;
  const auto verdict = asked_of_rows<Verdict>(
      mesh_, false,
      [&]<std::size_t kDimension, class Index>(
          const fast::MeshView<kDimension, Index>& view) -> OrReason<Verdict> {
        if constexpr (kDimension == 3) {
          if (auto found = ask(view)) return *std::move(found);
        }
        return because("something to be asked of exact numbers");
      });
  return verdict ? std::optional(*verdict) : std::nullopt;
}

std::optional<Verdict> KnownMesh::held(Claim claim, const Domain& domain,
                                       const Options& options) const {
  return asked_of_space([&](const auto& view) {
    return held_by_facets(claim, view, mesh_.faces, domain, *facts_, options);
  });
}

std::optional<Verdict> KnownMesh::not_conforming(const Domain& domain,
                                                 const Options& options) const {
  return asked_of_space([&](const auto& view) {
    return check::not_conforming(view, mesh_.faces, domain, *facts_, options);
  });
}

KnownBeside KnownMesh::beside(const Options& options) const {
  return {known(), [this, &options](Claim claim, const Domain& domain) {
            return held(claim, domain, options);
          }};
}

}  // namespace circumspect::check
