// Condition 2 of docs/theory/points.md for the boundary facets of a mesh spread over several ranks.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "oracle/distributed/conditions.hpp"
#include "oracle/distributed/local_mesh.hpp"
#include "oracle/distributed/ranks.hpp"
#include "oracle/judge/conditions/conditions.hpp"
#include "oracle/judge/fast/boundary.hpp"

namespace circumspect::distributed {

// As fast::FaultyRidge.
template <std::size_t kDimension>
struct FaultyRidgeName {
  std::array<std::int64_t, kDimension - 1> vertices = {};
  FacetNames facets = {};
  conditions::AtRidge kind = conditions::AtRidge::kNotClosed;
};

// Of each kind, the first so many by their vertices, and how many more there are. 0: all.
template <std::size_t kDimension>
class FaultyRidges {
 public:
  using Name = FaultyRidgeName<kDimension>;

  explicit FaultyRidges(std::size_t most) : most_(most) {}

  // facets() are those of the ridge, if they are asked for.
  template <class Facets>
  void add(conditions::AtRidge kind, const std::array<std::int64_t, kDimension - 1>& vertices,
           const Facets& facets) {
    std::vector<Name>& first = first_[kind];
    if (most_ > 0 && first.size() == most_) {
      ++further_[kind];
      if (!(vertices < first.front().vertices)) return;
      std::pop_heap(first.begin(), first.end(), is_before);
      first.pop_back();
    }
    first.push_back({vertices, facets(), kind});
    if (most_ > 0) std::push_heap(first.begin(), first.end(), is_before);
  }

  bool empty() const { return first_.empty(); }
  std::vector<Name> first() const {
    std::vector<Name> all;
    for (const auto& [kind, ridges] : first_) append(all, ridges);
    return all;
  }
  std::size_t further(conditions::AtRidge kind) const {
    const auto found = further_.find(kind);
    return found == further_.end() ? 0 : found->second;
  }

 private:
  static bool is_before(const Name& a, const Name& b) { return a.vertices < b.vertices; }

  std::size_t most_;
  std::map<conditions::AtRidge, std::vector<Name>> first_ = {};  // the last of them in front
  std::map<conditions::AtRidge, std::size_t> further_ = {};
};

template <std::size_t kDimension>
class RidgeMeeting {
 public:
  // Requires: `boundary` are this rank's boundary facets. `most`: as for FaultyRidges.
  RidgeMeeting(Ranks& ranks, const LocalMesh<kDimension>& mesh,
               std::span<const std::uint32_t> boundary, std::size_t most, fast::Stages& stages)
      : ranks_(ranks), mesh_(mesh), boundary_(boundary), stages_(stages), faulty_(most) {}

  // The faulty ridges that meet at this rank: those that its hash names, and those with a vertex
  // that is_shared(v) says no other rank names. Called by all ranks.
  template <class IsShared>
  FaultyRidges<kDimension> run(const IsShared& is_shared) {
    std::vector<Use> own;
    std::vector<std::uint32_t> others;  // numbers of uses
    for (std::size_t i = 0; i < boundary_.size() * kDimension; ++i) {
      const Places places = places_of(i);
      const auto row = mesh_.view().row(boundary_[i / kDimension] / kVertices);
      if (std::all_of(places.begin(), places.begin() + kRidge,
                      [&](std::size_t place) { return is_shared(row[place]); })) {
        others.push_back(static_cast<std::uint32_t>(i));
      } else {
        own.push_back({named(i, places), i});
      }
    }
    judge_own(own);
    meet(
        ranks_, others.size(), [&](std::size_t i) { return sent(others[i]); },
        [&](const std::vector<Sent>& uses, std::span<const std::uint32_t> group) {
          judge<Sent>(uses, group, [](const Sent& one) { return one.hinge; });
        });
    return std::move(faulty_);
  }

 private:
  static constexpr std::size_t kVertices = kDimension + 1;
  static constexpr std::size_t kRidge = kDimension - 1;
  using Hinge = fast::SiteRow<kDimension>;  // as fast::at_hinge requires it

  struct Named {
    std::array<std::int64_t, kRidge> ridge;  // ascending
    FacetName facet;

    std::uint64_t hash() const { return hash_of(ridge); }
    bool same(const Named& other) const { return ridge == other.ridge; }
  };
  struct Use : Named {
    std::size_t number;  // boundary facet · d + which of its ridges
  };
  struct Sent : Named {
    Hinge hinge;
  };

  // The places, in the simplex, of a ridge's vertices in ascending order, of the facet's other
  // vertex, and of the apex.
  using Places = std::array<std::size_t, kVertices>;
  Places places_of(std::size_t number) const {
    const std::uint32_t facet = boundary_[number / kDimension];
    const std::size_t place = facet % kVertices;
    const auto row = mesh_.view().row(facet / kVertices);
    Places places = {};
    places[kRidge] = fast::kFacetPlaces<kVertices>[place][number % kDimension];
    places[kDimension] = place;
    std::size_t size = 0;
    for (std::size_t k = 0; k < kVertices; ++k) {
      if (k != place && k != places[kRidge]) places[size++] = k;
    }
    std::sort(places.begin(), places.begin() + kRidge,
              [&](std::size_t a, std::size_t b) { return row[a] < row[b]; });
    return places;
  }

  Named named(std::size_t number, const Places& places) const {
    const std::uint32_t facet = boundary_[number / kDimension];
    const auto row = mesh_.view().row(facet / kVertices);
    Named one{{}, {static_cast<std::int32_t>(ranks_.rank()), facet}};
    for (std::size_t k = 0; k < kRidge; ++k) one.ridge[k] = mesh_.global(row[places[k]]);
    return one;
  }

  Hinge hinge(std::size_t number, const Places& places) const {
    const Hinge sites = mesh_.sites(boundary_[number / kDimension] / kVertices);
    Hinge row;
    for (std::size_t k = 0; k < kVertices; ++k) row[k] = sites[places[k]];
    return row;
  }

  Sent sent(std::size_t number) const {
    const Places places = places_of(number);
    return {named(number, places), hinge(number, places)};
  }

  void judge_own(const std::vector<Use>& uses) {
    for_each_group(
        std::span<const Use>(uses), [](const Use& one) { return one.hash(); },
        [](const Use& a, const Use& b) { return a.same(b); },
        [&](std::span<const std::uint32_t> group) {
          judge<Use>(uses, group,
                     [this](const Use& one) { return hinge(one.number, places_of(one.number)); });
        });
  }

  template <class Item, class HingeOf>
  void judge(std::span<const Item> uses, std::span<const std::uint32_t> group,
             const HingeOf& hinge_of) {
    const auto kind = group.size() == 2
                          ? fast::at_hinge<kDimension>(hinge_of(uses[group[0]]),
                                                       hinge_of(uses[group[1]]), stages_)
                          : conditions::AtRidge::kNotClosed;
    if (kind == conditions::AtRidge::kGood) return;
    faulty_.add(kind, uses[group[0]].ridge, [&] {
      FacetNames facets;
      for (const std::uint32_t i : group) facets.push_back(uses[i].facet);
      return facets;
    });
  }

  Ranks& ranks_;
  const LocalMesh<kDimension>& mesh_;
  std::span<const std::uint32_t> boundary_;
  fast::Stages& stages_;
  FaultyRidges<kDimension> faulty_;
};

}  // namespace circumspect::distributed
