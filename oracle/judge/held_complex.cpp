#include "oracle/judge/held_complex.hpp"

#include <algorithm>
#include <vector>

#include "kernel/piecewise_linear/disjoint_sets.hpp"
#include "oracle/judge/boundary_of.hpp"
#include "oracle/judge/fast/facet_matching.hpp"
#include "oracle/judge/fast/predicates/lattice.hpp"
#include "oracle/judge/fast/predicates/predicates.hpp"
#include "oracle/judge/fast/simplex_facts.hpp"

namespace circumspect::check {
namespace {

// How many parts facets connect; none if that is not found out.
template <std::size_t kDimension, typename Index>
std::size_t parts_of(const fast::MeshView<kDimension, Index>& mesh, unsigned threads) {
  const auto links = fast::matched_facets(mesh, threads);
  if (!links) return 0;
  DisjointSets joined(mesh.size());
  for (std::size_t i = 0; i < links->count; ++i) {
    const std::int32_t across = links->view()[i];
    if (across >= 0) joined.unite(i / (kDimension + 1), static_cast<std::size_t>(across));
  }
  std::size_t parts = 0;
  for (std::size_t s = 0; s < mesh.size(); ++s) parts += joined.find(s) == s ? 1 : 0;
  return parts;
}

// How many simplices have the sign of det[p_1 − p_0; …; p_d − p_0] that is positive.
template <std::size_t kDimension, typename Index>
std::size_t positive_of(const fast::MeshView<kDimension, Index>& mesh, bool are_alike) {
  const fast::Lattice lattice =
      are_alike ? fast::Lattice() : fast::lattice_of_all(mesh.coordinates, {});
  fast::Stages stages;
  std::size_t positive = 0;
  for (std::size_t s = 0; s < (are_alike ? 1 : mesh.size()); ++s) {
    fast::SiteRow<kDimension> row;
    for (std::size_t i = 0; i <= kDimension; ++i)
      row[i] = mesh.template site<false>(mesh.row(s)[i]);
    // The predicate takes the last vertex for the first, which changes the sign in space.
    const int sign = fast::orientation(row, stages, lattice);
    positive += (kDimension == 2 ? sign : -sign) > 0 ? 1 : 0;
  }
  return are_alike ? positive * mesh.size() : positive;
}

bool has_signs(const ComplexFacts& facts, Orientations demanded) {
  if (demanded == Orientations::kPositive) return facts.negative == 0;
  if (demanded == Orientations::kNegative) return facts.positive == 0;
  return demanded == Orientations::kAny || facts.negative == 0 || facts.positive == 0;
}

}  // namespace

template <std::size_t kDimension, typename Index>
std::optional<Verdict> held_complex(const fast::MeshView<kDimension, Index>& mesh,
                                    const ComplexDemands& demands, std::size_t max_violations,
                                    unsigned threads) {
  if (demands.closed) return std::nullopt;
  const auto known = fast::simplex_facts(mesh, {.pairs_suffice = true}, threads);
  if (!known || !known->uses_all_points) return std::nullopt;  // unused ones may equal others
  const BoundaryOf<kDimension, Index> boundary(mesh, known->boundary);
  if (boundary.has_equal_points() || !boundary.improper().empty()) return std::nullopt;
  const auto [classes, unsettled] = boundary.classes();
  if (!boundary.just_outside(unsettled).empty()) return std::nullopt;
  if (demands.manifold && !boundary.is_manifold()) return std::nullopt;
  ComplexFacts facts;
  facts.dimension = kDimension;
  facts.is_complex = true;
  // Each part has a class of its own.
  facts.parts = classes == 1 ? 1 : parts_of(mesh, threads);
  facts.boundary_facets = known->boundary.size();
  facts.positive = positive_of(mesh, known->oriented);
  facts.negative = mesh.size() - facts.positive;
  const bool is_demanded = has_signs(facts, demands.oriented) && facts.parts > 0 &&
                           (!demands.connected || facts.parts == 1);
  if (!is_demanded) return std::nullopt;
  Verdict verdict(Claim::kComplex, max_violations);
  verdict.points = mesh.points();
  verdict.simplices = mesh.size();
  verdict.dimension = kDimension;
  verdict.complex = facts;
  verdict.course = {true, "", known->stages.filtered, known->stages.exact()};
  return verdict;
}

template std::optional<Verdict> held_complex(const fast::MeshView<2, std::int32_t>&,
                                             const ComplexDemands&, std::size_t, unsigned);
template std::optional<Verdict> held_complex(const fast::MeshView<2, std::int64_t>&,
                                             const ComplexDemands&, std::size_t, unsigned);
template std::optional<Verdict> held_complex(const fast::MeshView<3, std::int32_t>&,
                                             const ComplexDemands&, std::size_t, unsigned);
template std::optional<Verdict> held_complex(const fast::MeshView<3, std::int64_t>&,
                                             const ComplexDemands&, std::size_t, unsigned);

}  // namespace circumspect::check
