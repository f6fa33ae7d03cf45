#include "oracle/judge/shared_facets.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace circumspect::check {
namespace {

// The vertices of the facet of a simplex opposite one of them, ascending.
template <std::size_t kVertices, typename Index>
std::array<Index, kVertices - 1> vertices_of(std::span<const Index, kVertices> simplex,
                                             std::size_t opposite) {
  std::array<Index, kVertices - 1> facet;
  std::size_t size = 0;
  for (std::size_t i = 0; i < kVertices; ++i) {
    if (i != opposite) facet[size++] = simplex[i];
  }
  std::sort(facet.begin(), facet.end());
  return facet;
}

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
      : has_facet_(mesh.points(), 0) {
    entries_.reserve(facets.size());
    for (const fast::FacetId facet : facets) {
      const std::size_t simplex = facet.simplex();
      entries_.push_back({vertices_of(mesh.row(simplex), facet.place()), simplex});
      for (const Index v : entries_.back().facet) has_facet_[static_cast<std::size_t>(v)] = 1;
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

  const Entry* find(const std::array<Index, kDimension>& facet) const {
    const auto found =
        std::lower_bound(entries_.begin(), entries_.end(), facet,
                         [](const Entry& entry, const auto& key) { return entry.facet < key; });
    return found != entries_.end() && found->facet == facet ? &*found : nullptr;
  }

 private:
  std::vector<Entry> entries_;
  std::vector<unsigned char> has_facet_;  // of each point: is it a vertex of one of them?
};

}  // namespace

template <std::size_t kDimension, typename Index>
std::vector<SharedFacet> shared_facets(const fast::MeshView<kDimension, Index>& mesh,
                                       std::span<const fast::FacetId> facets) {
  const FacetTable<kDimension, Index> table(mesh, facets);
  std::vector<SharedFacet> shared;
  for (std::size_t s = 0; s < mesh.size(); ++s) {
    const auto simplex = mesh.row(s);
    if (!table.may_have(simplex)) continue;
    for (std::size_t place = 0; place < simplex.size(); ++place) {
      const auto facet = vertices_of(simplex, place);
      const auto* const entry = table.find(facet);
      if (entry == nullptr || entry->simplex == s) continue;
      shared.push_back({{facet.begin(), facet.end()}, entry->simplex, simplex[place]});
    }
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

}  // namespace circumspect::check
