#include "oracle/judge/held_complex.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "kernel/piecewise_linear/disjoint_sets.hpp"
#include "oracle/judge/boundary_of.hpp"
#include "oracle/judge/fast/simplex_facts.hpp"

namespace circumspect::check {
namespace {

// How many parts facets connect, of a complex with this boundary. All simplices at a vertex that is
// not in the boundary are of one part, so that only facets between vertices of the boundary are
// looked at. Requires: all points are vertices.
template <std::size_t kDimension, typename Index>
class Parts {
 public:
  using View = fast::MeshView<kDimension, Index>;

  Parts(const View& mesh, const std::vector<fast::FacetId>& boundary)
      : mesh_(mesh), is_outer_(mesh.points(), false), joined_(mesh.points() + mesh.size()) {
    for (const fast::FacetId id : boundary) {
      for (const Index v : facet(id.simplex(), id.place())) is_outer_[at(v)] = true;
    }
    for (std::size_t s = 0; s < mesh.size(); ++s) add(s);
    std::sort(outer_facets_.begin(), outer_facets_.end());
    for (std::size_t i = 1; i < outer_facets_.size(); ++i) {
      const auto& [before, one] = outer_facets_[i - 1];
      const auto& [same, other] = outer_facets_[i];
      if (before == same) joined_.unite(one, other);
    }
  }

  std::size_t count() {
    std::size_t parts = 0;
    for (std::size_t v = 0; v < is_outer_.size(); ++v) {
      parts += !is_outer_[v] && joined_.find(v) == v ? 1 : 0;
    }
    for (const std::size_t own : of_outer_vertices_) parts += joined_.find(own) == own ? 1 : 0;
    return parts;
  }

 private:
  static std::size_t at(Index v) { return static_cast<std::size_t>(v); }
  auto facet(std::size_t s, std::size_t opposite) const {
    return fast::facet_of<kDimension + 1, Index>(mesh_.row(s), opposite);
  }

  void add(std::size_t s) {
    const auto row = mesh_.row(s);
    std::size_t inner = 0, own = mesh_.points() + s, last_inner = 0;
    for (std::size_t i = 0; i <= kDimension; ++i) {
      if (is_outer_[at(row[i])]) continue;
      if (inner++ > 0) joined_.unite(own, at(row[i]));
      own = at(row[i]);
      last_inner = i;
    }
    if (inner == 0) of_outer_vertices_.push_back(own);
    for (std::size_t i = 0; inner < 2 && i <= kDimension; ++i) {
      if (inner == 1 && i != last_inner) continue;
      auto vertices = facet(s, i);
      std::sort(vertices.begin(), vertices.end());
      outer_facets_.emplace_back(vertices, own);
    }
  }

  const View& mesh_;
  std::vector<bool> is_outer_;
  DisjointSets joined_;  // of points that are not in the boundary, and of simplices without one
  std::vector<std::size_t> of_outer_vertices_ = {};
  std::vector<std::pair<std::array<Index, kDimension>, std::size_t>> outer_facets_ = {};
};

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
  facts.parts = classes == 1 ? 1 : Parts<kDimension, Index>(mesh, known->boundary).count();
  facts.boundary_facets = known->boundary.size();
  // The predicate takes the last vertex for the first, which changes the sign in space.
  facts.positive = kDimension == 2 ? known->positive : mesh.size() - known->positive;
  facts.negative = mesh.size() - facts.positive;
  const bool is_demanded =
      has_signs(facts, demands.oriented) && (!demands.connected || facts.parts == 1);
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
