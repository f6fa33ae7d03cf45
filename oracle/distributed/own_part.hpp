// What a rank can tell about its own part, so that only what other ranks may have as well has to
// meet: everything with a vertex that no other rank names is in this part alone.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory_resource>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "oracle/distributed/conditions.hpp"
#include "oracle/distributed/local_mesh.hpp"
#include "oracle/distributed/ranks.hpp"
#include "oracle/judge/fast/faults.hpp"

namespace circumspect::distributed {

// Which of its points other ranks name, too. An index that names no point counts as shared.
template <std::size_t kDimension>
class SharedPoints {
 public:
  // Called by all ranks.
  SharedPoints(Ranks& ranks, const LocalMesh<kDimension>& mesh)
      : are_shared_(mesh.view().points(), false) {
    struct Item {
      std::int64_t point;
      std::int32_t rank, own;  // as that rank counts

      std::uint64_t hash() const { return hash_of(std::array{point}); }
      bool same(const Item& other) const { return point == other.point; }
    };
    const auto item = [&](std::size_t i) {
      const auto own = static_cast<std::int32_t>(i);
      return Item{mesh.global(own), static_cast<std::int32_t>(ranks.rank()), own};
    };
    meet<std::int32_t>(
        ranks, are_shared_.size(), [&](std::size_t i) { return item(i).hash(); }, item,
        [](const std::vector<Item>& items, std::span<const std::uint32_t> group,
           Post<std::int32_t>& post) {
          if (group.size() == 1) return;
          for (const std::uint32_t i : group) {
            post[static_cast<std::size_t>(items[i].rank)].push_back(items[i].own);
          }
        },
        [&](std::int32_t own) { are_shared_[static_cast<std::size_t>(own)] = true; });
  }

  bool contains(std::int32_t v) const { return v < 0 || are_shared_[static_cast<std::size_t>(v)]; }

 private:
  std::vector<bool> are_shared_;
};

// The faults of simplices, facets and ridges that are in this part alone. What other parts have as
// well is listed, to be judged with them.
struct OwnFaults {
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  std::size_t first = kNone, sound = kNone;  // simplices: the first in the whole, the first sound
  FacetNames unsound = {}, duplicates = {};
  std::vector<FacetNames> overused = {}, same_side = {}, not_local = {};
  std::vector<std::uint32_t> boundary = {};
  fast::Orientations orientations{1};           // if all are sound
  std::pmr::vector<std::uint32_t> facets = {};  // that other ranks may have as well; likewise
  std::pmr::vector<std::uint32_t> simplices = {};
};

template <std::size_t kDimension>
class OwnPart {
 public:
  OwnPart(std::size_t rank, const LocalMesh<kDimension>& mesh,
          const SharedPoints<kDimension>& shared)
      : rank_(static_cast<std::int32_t>(rank)), mesh_(mesh), shared_(shared) {}

  // Called once; so is all().
  OwnFaults run(fast::Question question, unsigned threads) {
    if (mesh_.size() > 0 && mesh_.names_points_alone()) {
      if (const auto faults = fast::faults_of_part(mesh_.view(), question, threads)) {
        take(*faults);
        return std::move(found_);
      }
    }
    return all();
  }

  // The same without a search in this part: all simplices and facets are listed.
  OwnFaults all() {
    judge_simplices();
    list_all();
    return std::move(found_);
  }

 private:
  static constexpr std::size_t kVertices = kDimension + 1;

  FacetName own_name(std::size_t s, std::size_t place = 0) const {
    return {rank_, static_cast<std::uint32_t>(s * kVertices + place)};
  }
  FacetName own_name(fast::FacetId facet) const { return own_name(facet.simplex(), facet.place()); }

  bool is_shared(std::size_t s) const {
    const auto row = mesh_.view().row(s);
    return std::all_of(row.begin(), row.end(),
                       [this](std::int32_t v) { return shared_.contains(v); });
  }
  bool is_shared(std::size_t s, std::size_t place) const {
    const auto row = mesh_.view().row(s);
    for (const std::size_t k : fast::kFacetPlaces<kVertices>[place]) {
      if (!shared_.contains(row[k])) return false;
    }
    return true;
  }
  bool is_shared(fast::FacetId facet) const { return is_shared(facet.simplex(), facet.place()); }

  void note(std::size_t s, bool is_sound) {
    const auto note_first = [&](std::size_t& first) {
      if (first == OwnFaults::kNone || mesh_.place(s) < mesh_.place(first)) first = s;
    };
    note_first(found_.first);
    if (is_sound) {
      note_first(found_.sound);
    } else {
      found_.unsound.push_back(own_name(s));
    }
  }

  void take(const fast::Faults& faults) {
    auto unsound = faults.unsound.begin();
    for (std::size_t s = 0; s < mesh_.size(); ++s) {
      const bool is_sound = unsound == faults.unsound.end() || *unsound != s;
      if (!is_sound) ++unsound;
      note(s, is_sound);
      if (is_shared(s)) found_.simplices.push_back(static_cast<std::uint32_t>(s));
    }
    for (const std::size_t s : faults.duplicates) {
      if (!is_shared(s)) found_.duplicates.push_back(own_name(s));
    }
    if (faults.simplices_are_sound()) take_facets(faults);
  }

  void take_facets(const fast::Faults& faults) {
    const std::uint64_t most = faults.orientation_of_most < 0 ? ~std::uint64_t{0} : 0;
    std::vector<std::uint64_t> negative((mesh_.size() + 63) / 64, most);
    for (const std::size_t s : faults.turned) negative[s / 64] ^= std::uint64_t{1} << (s % 64);
    found_.orientations = fast::Orientations(std::move(negative));
    for (const std::vector<fast::FacetId>& group : faults.overused) {
      if (is_shared(group.front())) continue;
      FacetNames& names = found_.overused.emplace_back();
      for (const fast::FacetId facet : group) names.push_back(own_name(facet));
    }
    take_pairs(faults.same_side, found_.same_side);
    take_pairs(faults.not_local, found_.not_local);
    // If facets do not match, nobody asks what the boundary is.
    const bool has_links = faults.facets_match();
    for (std::size_t s = 0; s < mesh_.size(); ++s) {
      for (std::size_t place = 0; place < kVertices; ++place) {
        const auto facet = static_cast<std::uint32_t>(s * kVertices + place);
        if (is_shared(s, place)) {
          found_.facets.push_back(facet);
        } else if (has_links && faults.links.links[facet] < 0) {
          found_.boundary.push_back(facet);
        }
      }
    }
  }

  void take_pairs(const std::vector<fast::FacetPair>& pairs, std::vector<FacetNames>& to) const {
    for (const auto& [first, second] : pairs) {
      if (!is_shared(first)) to.push_back({own_name(first), own_name(second)});
    }
  }

  void judge_simplices() {
    std::vector<std::uint64_t> negative((mesh_.size() + 63) / 64, 0);
    fast::Stages stages;
    for (std::size_t s = 0; s < mesh_.size(); ++s) {
      const auto row = mesh_.view().row(s);
      int sign = 0;
      if (std::all_of(row.begin(), row.end(), [](std::int32_t v) { return v >= 0; })) {
        sign = fast::orientation<kDimension>(mesh_.sites(s), stages);
      }
      note(s, sign != 0);
      if (sign < 0) negative[s / 64] |= std::uint64_t{1} << (s % 64);
    }
    found_.orientations = fast::Orientations(std::move(negative));
  }

  void list_all() {
    found_.simplices.resize(mesh_.size());
    std::iota(found_.simplices.begin(), found_.simplices.end(), 0U);
    found_.facets.resize(mesh_.size() * kVertices);
    std::iota(found_.facets.begin(), found_.facets.end(), 0U);
  }

  std::int32_t rank_;
  const LocalMesh<kDimension>& mesh_;
  const SharedPoints<kDimension>& shared_;
  OwnFaults found_;
};

}  // namespace circumspect::distributed
