#include "oracle/judge/verdict_of_faults.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include "kernel/exact/each_once.hpp"
#include "oracle/judge/fast/facet_records.hpp"
#include "oracle/judge/part_of_mesh.hpp"
#include "oracle/judge/points/simplices.hpp"
#include "oracle/judge/points/triangulation.hpp"

namespace circumspect::check {

namespace {

// Looks facets up by their vertices.
template <std::size_t kDimension, typename Index>
class FacetTable {
 public:
  static constexpr std::size_t kVertices = kDimension + 1;
  struct Entry {
    std::array<Index, kDimension> facet;
    std::size_t simplex;
  };

  FacetTable(const fast::MeshView<kDimension, Index>& mesh, std::span<const fast::FacetId> facets)
      : has_facet_(mesh.points(), 0), has_hash_(std::bit_ceil(16 * facets.size() + 1), false) {
    entries_.reserve(facets.size());
    for (const fast::FacetId facet : facets) {
      const std::size_t simplex = facet.simplex();
      entries_.push_back({fast::facet_of(mesh.row(simplex), facet.place()), simplex});
      for (const Index v : entries_.back().facet) has_facet_[static_cast<std::size_t>(v)] = 1;
      fast::for_each_facet_of<kVertices>(mesh.row(simplex),
                                         [&](std::uint64_t hash, std::size_t place) {
                                           if (place == facet.place())
                                             has_hash_[hash & (has_hash_.size() - 1)] = true;
                                         });
    }
    std::sort(entries_.begin(), entries_.end(),
              [](const Entry& a, const Entry& b) { return a.facet < b.facet; });
  }

  // Can a facet of the simplex be among them? Most meshes have few, and most simplices none.
  bool may_have(std::span<const Index, kVertices> simplex) const {
    std::size_t vertices = 0;
    for (const Index v : simplex) vertices += has_facet_[static_cast<std::size_t>(v)];
    return vertices >= kDimension;
  }

  // Adds those that the simplex shares with the one that they are named by.
  void add_shared(std::span<const Index, kVertices> simplex, std::size_t s,
                  std::vector<SharedFacet>& shared) const {
    fast::for_each_facet_of<kVertices>(simplex, [&](std::uint64_t hash, std::size_t place) {
      if (!has_hash_[hash & (has_hash_.size() - 1)]) return;
      const auto facet = fast::facet_of(simplex, place);
      const auto found =
          std::lower_bound(entries_.begin(), entries_.end(), facet,
                           [](const Entry& entry, const auto& key) { return entry.facet < key; });
      if (found == entries_.end() || found->facet != facet || found->simplex == s) return;
      shared.push_back({{facet.begin(), facet.end()}, found->simplex, simplex[place]});
    });
  }

 private:
  std::vector<Entry> entries_;
  std::vector<unsigned char> has_facet_;  // of each point: is it a vertex of one of them?
  std::vector<bool> has_hash_;
};

}  // namespace

template <std::size_t kDimension, typename Index>
std::vector<SharedFacet> shared_facets(const fast::MeshView<kDimension, Index>& mesh,
                                       std::span<const fast::FacetId> facets) {
  const FacetTable<kDimension, Index> table(mesh, facets);
  std::vector<SharedFacet> shared;
  for (std::size_t s = 0; s < mesh.size(); ++s) {
    const auto simplex = mesh.row(s);
    if (table.may_have(simplex)) table.add_shared(simplex, s, shared);
  }
  if (shared.size() != facets.size()) {
    throw std::logic_error("a facet was taken for one of two simplices, and is not");
  }
  return shared;
}

template std::vector<SharedFacet> shared_facets(const fast::MeshView<2, std::int32_t>&,
                                                std::span<const fast::FacetId>);
template std::vector<SharedFacet> shared_facets(const fast::MeshView<2, std::int64_t>&,
                                                std::span<const fast::FacetId>);
template std::vector<SharedFacet> shared_facets(const fast::MeshView<3, std::int32_t>&,
                                                std::span<const fast::FacetId>);
template std::vector<SharedFacet> shared_facets(const fast::MeshView<3, std::int64_t>&,
                                                std::span<const fast::FacetId>);

namespace {

template <std::size_t kDimension, typename Index>
Verdict not_local(Claim claim, const fast::MeshView<kDimension, Index>& mesh,
                  const fast::Facts& facts, const Options& options) {
  std::vector<SharedFacet> facets = shared_facets(mesh, facts.not_local);
  std::vector<std::size_t> simplices, apexes;
  for (const SharedFacet& shared : facets) {
    simplices.push_back(shared.simplex);
    apexes.push_back(static_cast<std::size_t>(shared.apex));
  }
  const Part<kDimension, Index> part(mesh, std::move(simplices), apexes);
  for (SharedFacet& shared : facets) {
    for (Vertex& v : shared.facet) v = part.place_of(v);
    shared.simplex = part.place_of_simplex(shared.simplex);
    shared.apex = part.place_of(shared.apex);
  }
  const bool weighted = claim == Claim::kWeightedDelaunay && !mesh.weights.empty();
  Verdict verdict = not_locally_delaunay(claim, part.mesh(weighted), std::move(facets), options);
  verdict.name_in_whole(part.vertices(), part.simplices());
  return verdict;
}

}  // namespace

template <std::size_t kDimension, typename Index>
Verdict verdict_of_facts(Claim claim, const fast::MeshView<kDimension, Index>& mesh,
                         const fast::Facts& facts, const Options& options) {
  Verdict verdict(claim, options.max_violations);
  if (facts.holds()) {
    if (claim != Claim::kTriangulation) {
      verdict.unique = facts.unique;
      verdict.canonical = facts.canonical;
    }
  } else {
    verdict = not_local(claim, mesh, facts, options);
  }
  verdict.points = mesh.points();
  verdict.simplices = mesh.size();
  verdict.dimension = static_cast<int>(kDimension);
  return verdict;
}

template Verdict verdict_of_facts(Claim, const fast::MeshView<2, std::int32_t>&, const fast::Facts&,
                                  const Options&);
template Verdict verdict_of_facts(Claim, const fast::MeshView<2, std::int64_t>&, const fast::Facts&,
                                  const Options&);
template Verdict verdict_of_facts(Claim, const fast::MeshView<3, std::int32_t>&, const fast::Facts&,
                                  const Options&);
template Verdict verdict_of_facts(Claim, const fast::MeshView<3, std::int64_t>&, const fast::Facts&,
                                  const Options&);

namespace {

// A neighbour that is listed, and what is across the facet.
struct WrongLink {
  fast::FacetId facet;
  Vertex listed;                      // counted from 0; −1: none
  std::optional<std::size_t> across;  // a simplex, if there is one
};

// Nothing if the mesh lists them in another form.
template <std::size_t kVertices>
std::optional<std::vector<WrongLink>> wrong_links(const ListedNeighbors& neighbors,
                                                  const fast::OwnedLinks& links) {
  const IndexLists& listed = neighbors.rows;
  if (neighbors.are_as_listed || listed.size() * kVertices != links.count) return std::nullopt;
  return listed.visit(
      [&]<class Lists>(const Lists& lists) -> std::optional<std::vector<WrongLink>> {
        if constexpr (std::is_same_v<Lists, std::vector<Simplex>>) {
          return std::nullopt;
        } else {
          if (lists.columns() != kVertices) return std::nullopt;
          std::vector<WrongLink> wrong;
          const auto values = lists.values();
          for (std::size_t i = 0; i < links.count; ++i) {
            if (values[i] == links.links[i]) continue;
            const fast::FacetId facet(i / kVertices, i % kVertices);
            wrong.push_back({facet, static_cast<Vertex>(values[i]), {}});
            if (links.links[i] >= 0) wrong.back().across = static_cast<std::size_t>(links.links[i]);
          }
          return wrong;
        }
      });
}

// The exact checkers in their order, each of which looks at the places that are at fault.
template <std::size_t kDimension, typename Index>
class Retold {
 public:
  Retold(Claim claim, const fast::MeshView<kDimension, Index>& whole, const fast::Faults& faults,
         const FurtherRidges& further, const std::vector<WrongLink>& wrong, Vertex first_index,
         const Options& options)
      : claim_(claim),
        faults_(faults),
        further_(further),
        wrong_(wrong),
        first_index_(first_index),
        options_(options),
        ridges_(whole, faults.ridges, further, options.max_violations),
        part_(whole, simplices(), further_points()),
        mesh_(part_.mesh(claim == Claim::kWeightedDelaunay && !whole.weights.empty())),
        verdict_(claim, options.max_violations) {}

  Verdict verdict() {
    judge_simplices(mesh_, options_.oriented, verdict_, faults_.orientation_of_most);
    if (all_are_vertices()) judge_vertex_set(mesh_, verdict_);
    if (faults_.simplices_are_sound()) judge_complex();
    verdict_.name_in_whole(part_.vertices(), part_.simplices());
    return std::move(verdict_);
  }

 private:
  bool all_are_vertices() const { return claim_ != Claim::kWeightedDelaunay; }

  // With the first one, which has the sample point, one that is oriented as most are, and a sound
  // one, which spans space.
  std::vector<std::size_t> simplices() const {
    std::vector<std::size_t> all = {0, faults_.first_of_most, faults_.sound_simplex};
    const auto take = [&all](const std::vector<std::size_t>& some) {
      all.insert(all.end(), some.begin(), some.end());
    };
    const auto take_facets = [&all](const std::vector<fast::FacetId>& facets) {
      for (const fast::FacetId facet : facets) all.push_back(facet.simplex());
    };
    const auto take_pairs = [&all](const std::vector<fast::FacetPair>& pairs) {
      for (const auto& [first, second] : pairs) {
        all.insert(all.end(), {first.simplex(), second.simplex()});
      }
    };
    take(faults_.unsound);
    take(faults_.duplicates);
    if (options_.oriented) take(faults_.turned);
    for (const auto& facets : faults_.overused) take_facets(facets);
    take_pairs(faults_.same_side);
    for (const fast::FaultyRidge* const ridge : ridges_.shown) take_facets(ridge->facets);
    take_facets(faults_.beyond);
    take(faults_.covering);
    for (const WrongLink& link : wrong_) {
      all.push_back(link.facet.simplex());
      if (link.across) all.push_back(*link.across);
    }
    take_pairs(faults_.not_local);
    for (const auto& [point, simplex] : faults_.submerged) {
      if (simplex) all.push_back(*simplex);
    }
    return all;
  }

  std::vector<std::size_t> further_points() const {
    std::vector<std::size_t> points;
    if (all_are_vertices()) points = faults_.unused;
    for (const auto& [point, simplex] : faults_.submerged) points.push_back(point);
    return points;
  }

  // As facet_uses() has them.
  std::vector<FacetUse> uses_of(const std::vector<fast::FacetId>& facets) const {
    std::vector<FacetUse> uses;
    uses.reserve(facets.size());
    for (const fast::FacetId facet : facets) uses.push_back(part_.use_of(facet));
    std::sort(uses.begin(), uses.end(), [](const FacetUse& a, const FacetUse& b) {
      return std::tie(a.facet, a.simplex) < std::tie(b.facet, b.simplex);
    });
    return uses;
  }
  static std::vector<fast::FacetId> both(const std::vector<fast::FacetPair>& pairs) {
    std::vector<fast::FacetId> facets;
    for (const auto& [first, second] : pairs) facets.insert(facets.end(), {first, second});
    return facets;
  }

  void judge_complex() {
    std::vector<fast::FacetId> facets = both(faults_.same_side);
    for (const auto& group : faults_.overused) {
      facets.insert(facets.end(), group.begin(), group.end());
    }
    if (!judge_facet_matching(mesh_, uses_of(facets), verdict_)) return;
    judge_boundary();
    add_wrong_neighbors();
    Ambiguity ambiguity;  // of no interest where a claim does not hold
    judge_facets_locally_delaunay(mesh_, uses_of(both(faults_.not_local)), verdict_, ambiguity);
    for (const auto& [point, simplex] : faults_.submerged) {
      std::optional<std::size_t> place;
      if (simplex) place = part_.place_of_simplex(*simplex);
      judge_submerged_point(mesh_, part_.place_of(static_cast<Vertex>(point)), place, verdict_,
                            ambiguity);
    }
  }

  void judge_boundary() {
    std::vector<fast::FacetId> facets = faults_.beyond;
    std::set<Simplex> faulty;
    for (const fast::FaultyRidge* const ridge : ridges_.shown) {
      facets.insert(facets.end(), ridge->facets.begin(), ridge->facets.end());
      Simplex vertices;
      for (const std::int64_t v : ridge->vertices) vertices.push_back(part_.place_of(v));
      faulty.insert(std::move(vertices));
    }
    keep_each_once(facets);
    std::vector<BoundaryFacet> boundary;
    std::vector<Simplex> vertices_of_facets;
    for (const FacetUse& use : uses_of(facets)) {
      vertices_of_facets.push_back(use.facet);
      boundary.push_back(boundary_facet(mesh_, use));
    }
    std::vector<FacetUse> ridges = facet_uses(vertices_of_facets);
    std::erase_if(ridges, [&](const FacetUse& use) { return !faulty.contains(use.facet); });
    if (judge_ridges(mesh_, boundary, ridges, verdict_)) {
      judge_sample_point(mesh_, boundary, verdict_);
    }
    for (const auto& ridge : ridges_.counted) count(ridge);
    for (const auto& [kind, count] : further_) {
      for (std::size_t i = 0; i < count; ++i) verdict_.count(rule_of(kind));
    }
  }

  // Others have named what is in all of them: so what is not in the part cannot be.
  void count(const RidgeFault<kDimension, Index>& ridge) {
    const auto tally = verdict_.tallies().find(ridge.rule());
    Simplex named;
    if (tally != verdict_.tallies().end() && !tally->second.in_all.empty()) {
      for (const Vertex v : ridge.named()) {
        if (const Vertex own = part_.place_of(v); own >= 0) named.push_back(own);
      }
    }
    verdict_.count(ridge.rule(), std::nullopt, named);
  }

  void add_wrong_neighbors() {
    std::vector<std::pair<FacetUse, const WrongLink*>> wrong;
    wrong.reserve(wrong_.size());
    for (const WrongLink& link : wrong_) wrong.emplace_back(part_.use_of(link.facet), &link);
    std::sort(wrong.begin(), wrong.end(), [](const auto& a, const auto& b) {
      return std::tie(a.first.facet, a.first.simplex) < std::tie(b.first.facet, b.first.simplex);
    });
    for (const auto& [use, link] : wrong) {
      const Simplex* across = nullptr;
      Vertex expected = -1;
      if (link->across) {
        across = &mesh_.simplices[part_.place_of_simplex(*link->across)];
        expected = index_of_place(static_cast<Vertex>(*link->across), first_index_);
      }
      const Vertex listed =
          link->listed == -1 ? Vertex{-1} : index_of_place(link->listed, first_index_);
      add_wrong_neighbor(mesh_, use, across, listed, expected, verdict_);
    }
  }

  Claim claim_;
  const fast::Faults& faults_;
  const FurtherRidges& further_;
  const std::vector<WrongLink>& wrong_;
  Vertex first_index_;  // of the simplices
  const Options& options_;
  RidgesRetold<kDimension, Index> ridges_;
  Part<kDimension, Index> part_;
  ExactMesh mesh_;
  Verdict verdict_;
};

}  // namespace

template <std::size_t kDimension, typename Index>
std::optional<Verdict> verdict_of_faults(Claim claim, const fast::MeshView<kDimension, Index>& mesh,
                                         const ListedNeighbors* neighbors,
                                         const fast::Faults& faults, const Options& options,
                                         const FurtherRidges& further) {
  std::vector<WrongLink> wrong;
  if (neighbors != nullptr && faults.facets_match()) {
    auto found = wrong_links<kDimension + 1>(*neighbors, faults.links);
    if (!found) return std::nullopt;
    wrong = std::move(*found);
  }
  const bool is_turned = options.oriented && !faults.turned.empty();
  if (claim == Claim::kWeightedDelaunay && !faults.unused.empty() && faults.is_triangulation() &&
      wrong.empty() && !is_turned) {
    return std::nullopt;
  }
  const Vertex first_index = neighbors != nullptr ? neighbors->first_index : 0;
  Verdict verdict =
      Retold<kDimension, Index>(claim, mesh, faults, further, wrong, first_index, options)
          .verdict();
  if (verdict.holds()) return std::nullopt;
  verdict.points = mesh.points();
  verdict.simplices = mesh.size();
  verdict.dimension = static_cast<int>(kDimension);
  return verdict;
}

template std::optional<Verdict> verdict_of_faults(Claim, const fast::MeshView<2, std::int32_t>&,
                                                  const ListedNeighbors*, const fast::Faults&,
                                                  const Options&, const FurtherRidges&);
template std::optional<Verdict> verdict_of_faults(Claim, const fast::MeshView<2, std::int64_t>&,
                                                  const ListedNeighbors*, const fast::Faults&,
                                                  const Options&, const FurtherRidges&);
template std::optional<Verdict> verdict_of_faults(Claim, const fast::MeshView<3, std::int32_t>&,
                                                  const ListedNeighbors*, const fast::Faults&,
                                                  const Options&, const FurtherRidges&);
template std::optional<Verdict> verdict_of_faults(Claim, const fast::MeshView<3, std::int64_t>&,
                                                  const ListedNeighbors*, const fast::Faults&,
                                                  const Options&, const FurtherRidges&);

}  // namespace circumspect::check
