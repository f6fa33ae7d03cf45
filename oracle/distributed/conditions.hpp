// The conditions of docs/theory/points.md for a mesh whose simplices are spread over several ranks;
// docs/theory/distributed.md restates them.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>
#include <utility>
#include <vector>

#include "oracle/distributed/local_mesh.hpp"
#include "oracle/distributed/ranks.hpp"
#include "oracle/judge/fast/boundary.hpp"
#include "oracle/judge/fast/facet_records.hpp"
#include "oracle/judge/fast/predicates/predicates.hpp"
#include "oracle/judge/fast/sample_point.hpp"
#include "oracle/judge/fast/sweep.hpp"

namespace circumspect::distributed {

// Names of several simplices, or of their facets.
using FacetNames = std::vector<FacetName>;

template <class Item>
void append(std::vector<Item>& list, const std::vector<Item>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

// Gathers groups of names of all ranks at the first one. They are sent in one list, each after its
// size.
inline std::vector<FacetNames> groups_at_first(Ranks& ranks, const std::vector<FacetNames>& own) {
  FacetNames list;
  for (const FacetNames& group : own) {
    list.push_back({-1, static_cast<std::uint32_t>(group.size())});
    append(list, group);
  }
  list = ranks.at_first(std::move(list));
  std::vector<FacetNames> groups;
  for (auto next = list.begin(); next != list.end();) {
    const auto end = next + 1 + static_cast<std::ptrdiff_t>(next->facet);
    groups.emplace_back(next + 1, end);
    next = end;
  }
  return groups;
}

// The same for any order of them.
template <std::size_t kSize>
std::uint64_t hash_of(const std::array<std::int64_t, kSize>& indices) {
  std::uint64_t hash = 0;
  for (const std::int64_t v : indices) hash += fast::mixed_vertex(static_cast<std::uint64_t>(v));
  return fast::mixed_vertex(hash);
}

// What is across the facets of this rank's simplices, and what is wrong there.
struct FacetFindings {
  std::vector<FacetNames> overused = {};     // of three and more simplices
  std::vector<FacetNames> same_side = {};    // of two, on the same side
  std::vector<FacetNames> not_local = {};    // of two, not locally Delaunay
  std::vector<std::uint32_t> boundary = {};  // this rank's, which no other simplex has
  bool unique = true;                        // as in fast::Swept
  bool canonical = true;
  fast::Stages stages = {};

  bool match() const { return overused.empty() && same_side.empty(); }
};

// The question about balls.
struct BallQuestions {
  bool asked = false;
  fast::Lattice lattice = {};  // one that contains the points of all ranks
};

template <std::size_t kDimension>
class FacetMeeting {
 public:
  // Requires: all simplices are sound, and these are their orientations.
  FacetMeeting(Ranks& ranks, const LocalMesh<kDimension>& mesh,
               const fast::Orientations& orientations, const BallQuestions& balls)
      : ranks_(ranks), mesh_(mesh), orientations_(orientations), balls_(balls) {}

  // `facets`: those of this rank that have to meet. Called by all ranks.
  FacetFindings run(std::span<const std::uint32_t> facets) {
    std::pmr::vector<Pair> pairs;  // the first of each is a facet of this rank
    meet<Pair>(
        ranks_, facets.size(), [&](std::size_t i) { return hash_of(vertices_of(facets[i])); },
        [&](std::size_t i) { return item(facets[i]); },
        [&](const std::vector<Item>& items, std::span<const std::uint32_t> group,
            Post<Pair>& post) { visit(items, group, post); },
        [&](const Pair& pair) {
          if (pair.other.rank < 0) {
            found_.boundary.push_back(pair.facet);
          } else if (pair.other.rank == own_rank()) {
            look_at_ball({pair.other.facet, {own_rank(), pair.facet}, apex_of(pair.facet)});
          } else {
            pairs.push_back(pair);
          }
        });
    // Exchanges the apexes of pairs on two ranks, in batches.
    const std::size_t some = ranks_.some(3 * sizeof(Apex));
    const std::uint64_t rounds = ranks_.most((pairs.size() + some - 1) / some);
    for (std::uint64_t round = 0; round < rounds; ++round) {
      std::vector<std::vector<Apex>> out(ranks_.size());
      const std::size_t last = std::min<std::size_t>(pairs.size(), (round + 1) * some);
      for (std::size_t i = round * some; i < last; ++i) {
        const auto& [facet, other] = pairs[i];
        out[static_cast<std::size_t>(other.rank)].push_back(
            {other.facet, {own_rank(), facet}, apex_of(facet)});
      }
      for (const Apex& apex : ranks_.exchanged(std::move(out))) look_at_ball(apex);
    }
    return std::move(found_);
  }

 private:
  static constexpr std::size_t kVertices = kDimension + 1;
  using Site = fast::Site<kDimension>;

  struct Item {
    std::array<std::int64_t, kDimension> vertices;  // ascending
    std::uint32_t facet;
    std::int32_t rank_and_side;  // 2 · rank, and 1 if apex and vertices are positively oriented

    FacetName name() const { return {rank_and_side / 2, facet}; }
    bool is_positive() const { return rank_and_side % 2 != 0; }
    std::uint64_t hash() const { return hash_of(vertices); }
    bool same(const Item& other) const { return vertices == other.vertices; }
  };
  // Two equal facets. If `other` names no rank, there is no second one.
  struct Pair {
    std::uint32_t facet;  // of whom it is posted to
    FacetName other;
  };
  // The question to the owner of a facet about the ball of its simplex.
  struct Apex {
    std::uint32_t facet;  // of whom it is posted to
    FacetName other;      // across it
    Site site;            // opposite the other
  };

  std::int32_t own_rank() const { return static_cast<std::int32_t>(ranks_.rank()); }
  Site apex_of(std::uint32_t facet) const {
    return mesh_.site(mesh_.view().row(facet / kVertices)[facet % kVertices]);
  }

  // In any order.
  std::array<std::int64_t, kDimension> vertices_of(std::uint32_t facet) const {
    const auto row = mesh_.view().row(facet / kVertices);
    std::array<std::int64_t, kDimension> vertices;
    for (std::size_t k = 0; k < kDimension; ++k) {
      vertices[k] = mesh_.global(row[fast::kFacetPlaces<kVertices>[facet % kVertices][k]]);
    }
    return vertices;
  }

  Item item(std::uint32_t facet) const {
    const std::size_t s = facet / kVertices, place = facet % kVertices;
    const auto row = mesh_.view().row(s);
    std::array<std::int32_t, kDimension> others;
    int side = orientations_.of(s);
    for (std::size_t k = 0; k < kDimension; ++k) {
      others[k] = row[fast::kFacetPlaces<kVertices>[place][k]];
      for (std::size_t j = k; j > 0 && others[j - 1] > others[j]; --j) {
        std::swap(others[j - 1], others[j]);
        side = -side;
      }
    }
    Item item{{}, facet, 2 * own_rank() + (side > 0 ? 1 : 0)};
    for (std::size_t k = 0; k < kDimension; ++k) item.vertices[k] = mesh_.global(others[k]);
    return item;
  }

  void visit(const std::vector<Item>& items, std::span<const std::uint32_t> group,
             Post<Pair>& post) {
    const auto tell = [&](const Item& to, FacetName other) {
      post[static_cast<std::size_t>(to.name().rank)].push_back({to.facet, other});
    };
    const Item& a = items[group.front()];
    if (group.size() == 1) return tell(a, {});
    const Item& b = items[group.back()];
    const auto fault =
        conditions::at_facet(group.size(), [&] { return a.is_positive() == b.is_positive(); });
    if (fault == conditions::AtFacet::kOverused) {
      FacetNames& names = found_.overused.emplace_back();
      for (const std::uint32_t i : group) names.push_back(items[i].name());
    } else if (fault == conditions::AtFacet::kSameSide) {
      found_.same_side.push_back({a.name(), b.name()});
    } else if (balls_.asked) {
      // Either side may ask, so each takes half of the work.
      const bool first = (a.hash() >> 40 & 1) != 0;
      tell(first ? a : b, first ? b.name() : a.name());
    }
  }

  void look_at_ball(const Apex& apex) {
    if (mesh_.is_weighted()) {
      look_at_ball_of<true>(apex);
    } else {
      look_at_ball_of<false>(apex);
    }
  }

  // As the sweep looks at facets within one mesh.
  template <bool kWeighted>
  void look_at_ball_of(const Apex& apex) {
    const std::size_t s = apex.facet / kVertices, place = apex.facet % kVertices;
    const fast::SiteRow<kDimension> row = mesh_.sites(s);
    const int own = orientations_.of(s);
    const int side = fast::ball_of<kDimension, kWeighted>(row, balls_.lattice)
                         .contains(apex.site, found_.stages) *
                     own;
    if (side < 0) return;
    if (side > 0) {
      found_.not_local.push_back({{own_rank(), apex.facet}, apex.other});
      return;
    }
    found_.unique = false;
    if (!found_.canonical) return;
    found_.canonical = fast::perturbed_sign_of_zero<kDimension>(row, own, apex.site, found_.stages,
                                                                balls_.lattice, place) < 0;
  }

  Ranks& ranks_;
  const LocalMesh<kDimension>& mesh_;
  const fast::Orientations& orientations_;
  const BallQuestions& balls_;
  FacetFindings found_;
};

// This rank's boundary facets that do not have the sample point strictly on their inner sides.
template <std::size_t kDimension>
FacetNames beyond(const Ranks& ranks, const LocalMesh<kDimension>& mesh,
                  const std::vector<std::uint32_t>& boundary,
                  const fast::SamplePoint<kDimension>& sample,
                  const fast::Orientations& orientations, fast::Stages& stages) {
  FacetNames names;
  for (const std::uint32_t facet : boundary) {
    const std::size_t s = facet / (kDimension + 1), place = facet % (kDimension + 1);
    const int side =
        fast::orientation_with(mesh.sites(s), place, sample, stages) * orientations.of(s);
    if (!conditions::is_strictly_inside(side))
      names.push_back({static_cast<std::int32_t>(ranks.rank()), facet});
  }
  return names;
}

// Simplices that have the same vertices as another, whether these are points or not, group by
// group, of those that each rank lists. Called by all ranks.
template <std::size_t kDimension>
std::vector<FacetNames> equal_simplices(Ranks& ranks, const LocalMesh<kDimension>& mesh,
                                        std::span<const std::uint32_t> listed) {
  constexpr std::size_t kVertices = kDimension + 1;
  struct Item {
    std::array<std::int64_t, kVertices> vertices;  // ascending
    FacetName name;

    std::uint64_t hash() const { return hash_of(vertices); }
    bool same(const Item& other) const { return vertices == other.vertices; }
  };
  const auto item = [&](std::size_t i) {
    const std::size_t s = listed[i];
    Item one{{},
             {static_cast<std::int32_t>(ranks.rank()), static_cast<std::uint32_t>(s * kVertices)}};
    for (std::size_t k = 0; k < kVertices; ++k) one.vertices[k] = mesh.vertex(s, k);
    std::sort(one.vertices.begin(), one.vertices.end());
    return one;
  };
  std::vector<FacetNames> equal;
  meet(ranks, listed.size(), item,
       [&](const std::vector<Item>& items, std::span<const std::uint32_t> group) {
         if (group.size() == 1) return;
         FacetNames& names = equal.emplace_back();
         for (const std::uint32_t i : group) names.push_back(items[i].name);
       });
  return equal;
}

// The number of points that are equal to an earlier one, and the first of them with the point that
// it repeats.
struct EqualPoints {
  std::uint64_t count = 0;
  std::uint64_t kept = 0;
  std::uint64_t again = 0;
};

// Called by all ranks, and the answer is the same for all.
template <std::size_t kDimension>
EqualPoints equal_points(Ranks& ranks, const LocalMesh<kDimension>& mesh) {
  struct Item {
    std::array<double, kDimension> at;
    std::uint64_t index;

    std::uint64_t hash() const {
      std::array<std::int64_t, kDimension> bits;
      for (std::size_t axis = 0; axis < kDimension; ++axis) {
        // Each axis gets its own hash, because a sum of equal hashes would not depend on the order
        // of the axes.
        bits[axis] = static_cast<std::int64_t>(
            std::bit_cast<std::uint64_t>(at[axis] + 0.0) * (2 * axis + 1) + axis);
      }
      return hash_of(bits);
    }
    bool same(const Item& other) const { return at == other.at; }
  };
  EqualPoints own{0, 0, std::numeric_limits<std::uint64_t>::max()};
  meet(
      ranks, mesh.owned(),
      [&](std::size_t i) {
        const auto [index, site] = mesh.owned_point(i);
        return Item{site.at, index};
      },
      [&](const std::vector<Item>& items, std::span<const std::uint32_t> group) {
        if (group.size() == 1) return;
        own.count += group.size() - 1;
        std::array<std::uint64_t, 2> least = {items[group[0]].index, items[group[1]].index};
        std::sort(least.begin(), least.end());
        for (const std::uint32_t i : group.subspan(2)) {
          const std::uint64_t index = items[i].index;
          if (index < least[0]) {
            least = {index, least[0]};
          } else if (index < least[1]) {
            least[1] = index;
          }
        }
        if (least[1] < own.again) own = {own.count, least[0], least[1]};
      });
  EqualPoints all = own;
  all.count = 0;
  for (const EqualPoints& some : ranks.of_each(own)) {
    all.count += some.count;
    if (some.again < all.again) all = {all.count, some.kept, some.again};
  }
  return all;
}

}  // namespace circumspect::distributed
