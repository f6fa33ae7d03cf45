#include "oracle/judge/fast/facet_matching.hpp"

#include <algorithm>
#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <numeric>
#include <set>
#include <utility>

#include "oracle/judge/fast/facet_records.hpp"
#include "oracle/judge/fast/in_chunks.hpp"

namespace circumspect::fast {
namespace {

constexpr std::size_t kFacetsInPile = 16384;  // and tables of the rest of them, within a cache
constexpr std::size_t kMostPiles = std::size_t{1} << 14;
constexpr std::uint64_t kMostSimplices = std::uint64_t{1} << 29;
constexpr std::size_t kSlices =
    32;  // whatever the number of threads, so a likely proposal does not depend on it either
constexpr std::size_t kRecordsForTables = std::size_t{3} << 16;  // that take about as much memory
constexpr std::size_t kLeastSlice = std::size_t{1} << 14;

template <std::size_t kDimension, typename Index>
class Matching {
 public:
  Matching(const MeshView<kDimension, Index>& mesh, Proposal proposal, unsigned threads)
      : mesh_(mesh), proposal_(proposal), threads_(threads), layout_(mesh.simplices.size()) {
    slice_ = std::max(chunks_of(mesh.size(), kSlices), kLeastSlice);
    const std::size_t wanted = chunks_of(mesh.simplices.size(), kFacetsInPile);
    piles_ = std::min(std::bit_ceil(wanted), kMostPiles);
  }

  tl::expected<OwnedLinks, Undecided> run() {
    if (mesh_.size() > kMostSimplices) return tl::unexpected(Undecided::kTooLarge);
    links_ = large_array<std::int32_t>(mesh_.simplices.size());
    if (!count()) return tl::unexpected(Undecided::kUnknownVertex);
    in_rounds(most_at_a_time(), [this](std::size_t first, std::size_t last) {
      fill(first, last, [](std::int32_t link, std::size_t) { return link < 0; });
      match(first, last, [this](auto pile, auto& table) { match_pile(pile, table); });
    });
    return owned_links();
  }

  // Implements complete() of facet_matching.hpp. Compares one facet of each pair, and every facet
  // without a link.
  std::vector<std::uint64_t> complete(OwnedLinks& links) {
    links_ = std::move(links.links);
    const auto stands_for_its_pair = [](std::int32_t link, std::size_t s) {
      return (static_cast<std::int64_t>(link) >= static_cast<std::int64_t>(s)) | (link < 0);
    };
    counts_.assign(slices() * piles_, 0);
    in_slices([&](std::size_t slice, std::size_t first, std::size_t last) {
      const std::span<std::uint32_t> counts = counts_of(slice);
      for (std::size_t s = first; s < last; ++s) {
        const std::int32_t* const own = &links_[s * kVertices];
        for_each_facet_of<kVertices, Index>(mesh_.row(s), [&](std::uint64_t hash,
                                                              std::size_t place) {
          counts[pile_of(hash)] += static_cast<std::uint32_t>(stands_for_its_pair(own[place], s));
        });
      }
    });
    in_rounds(mesh_.simplices.size() * 5 / 8, [&](std::size_t first, std::size_t last) {
      fill(first, last, stands_for_its_pair);
      match(first, last, [this](auto pile, auto& table) { separate(pile, table); });
    });
    links = owned_links();
    std::sort(matched_again_.begin(), matched_again_.end());
    return std::move(matched_again_);
  }

 private:
  static constexpr std::size_t kVertices = kDimension + 1;
  static constexpr std::size_t kWordsInLine = 8;  // of a cache

  std::size_t most_at_a_time() const {
    // Takes so many piles at a time that they have records for not quite half of the facets; fewer
    // for a small mesh, where tables matter more.
    const std::size_t facets = mesh_.simplices.size();
    return std::max(facets * 7 / 16 - std::min(facets * 7 / 16, kRecordsForTables), facets / 4);
  }

  // Calls work(first pile, last pile) for all piles, each time for several with at most so many
  // records, or for one.
  template <class Work>
  void in_rounds(std::size_t most_records, const Work& work) {
    std::vector<std::size_t> sizes;
    for (std::size_t pile = 0; pile < piles_; ++pile) sizes.push_back(size_of(pile));
    const std::size_t all = std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
    most_records_ =
        std::max(std::min(most_records, all), *std::max_element(sizes.begin(), sizes.end()));
    records_ = large_array<std::uint64_t>(most_records_ + slices() * kWordsInLine);
    for (std::size_t first = 0; first < piles_;) {
      std::size_t last = first;
      std::size_t records = 0;
      while (last < piles_ && records + sizes[last] <= most_records_) records += sizes[last++];
      work(first, last);
      first = last;
    }
    records_.reset();
  }

  OwnedLinks owned_links() {
    for (auto& facets : overused_) std::sort(facets.begin(), facets.end());
    std::sort(overused_.begin(), overused_.end());  // which thread was first is chance
    return OwnedLinks{std::move(links_), mesh_.simplices.size(), std::move(overused_)};
  }

  template <class Work>
  void in_slices(const Work& work) {
    in_chunks(mesh_.size(), slice_, threads_, work);
  }

  // The last bits of a hash determine the pile of a facet, and its record has the others.
  std::size_t pile_of(std::uint64_t hash) const { return hash & (piles_ - 1); }
  std::uint64_t record(std::uint64_t hash, std::uint64_t facet) const {
    return layout_.record(hash >> bits_of(piles_ - 1), facet);
  }

  std::size_t slices() const { return chunks_of(mesh_.size(), slice_); }
  std::span<std::uint32_t> counts_of(std::size_t slice) {
    return {&counts_[slice * piles_], piles_};
  }
  std::size_t size_of(std::size_t pile) {
    std::size_t size = 0;
    for (std::size_t slice = 0; slice < slices(); ++slice) size += counts_of(slice)[pile];
    return size;
  }

  // Links nearby facets, if a likely proposal suffices, and counts the others by slice and pile.
  // False if an index names no point.
  bool count() {
    counts_.assign(slices() * piles_, 0);
    std::atomic<bool> known = true;
    in_slices([&](std::size_t slice, std::size_t first, std::size_t last) {
      const bool all_known = proposal_ == Proposal::kLikely ? count_with_nearby(slice, first, last)
                                                            : count_all(slice, first, last);
      if (!all_known) known.store(false);
    });
    return known.load();
  }

  bool names_points(std::size_t s) const {
    bool all = true;
    for (const Index v : mesh_.row(s)) all &= mesh_.names_point(v);
    return all;
  }

  bool count_with_nearby(std::size_t slice, std::size_t first, std::size_t last) {
    NearbyFacets<kDimension, Index> nearby(layout_, last - first, links_.get(), counts_of(slice));
    for (std::size_t s = first; s < last; ++s) {
      if (!names_points(s)) return false;
      nearby.add(mesh_.row(s), s);
    }
    nearby.finish();
    return true;
  }

  bool count_all(std::size_t slice, std::size_t first, std::size_t last) {
    std::fill(&links_[first * kVertices], links_.get() + last * kVertices, -1);
    const std::span<std::uint32_t> counts = counts_of(slice);
    for (std::size_t s = first; s < last; ++s) {
      if (!names_points(s)) return false;
      for_each_facet_of<kVertices, Index>(
          mesh_.row(s), [&](std::uint64_t hash, std::size_t) { ++counts[pile_of(hash)]; });
    }
    return true;
  }

  // Writes the records of these piles, pile by pile, in the order of simplices, for the facets that
  // are wanted; is_wanted(link, simplex) tells without a branch.
  template <class IsWanted>
  void fill(std::size_t first_pile, std::size_t last_pile, const IsWanted& is_wanted) {
    begins_.assign(1, 0);
    std::size_t begin = 0;
    for (std::size_t pile = first_pile; pile < last_pile; ++pile) {
      for (std::size_t slice = 0; slice < slices(); ++slice) {
        // From here on, the place of the slice's next record.
        begin += std::exchange(counts_of(slice)[pile], static_cast<std::uint32_t>(begin));
      }
      begins_.push_back(begin);
    }
    in_slices([&](std::size_t slice, std::size_t first, std::size_t last) {
      fill_from(slice, first, last, first_pile, last_pile, is_wanted);
    });
  }

  template <class IsWanted>
  void fill_from(std::size_t slice, std::size_t first, std::size_t last, std::size_t first_pile,
                 std::size_t last_pile, const IsWanted& is_wanted) {
    const std::span<std::uint32_t> next = counts_of(slice);
    std::uint64_t* const records = records_.get();
    const std::size_t nowhere = most_records_ + slice * kWordsInLine;
    for (std::size_t s = first; s < last; ++s) {
      const std::int32_t* const links = &links_[s * kVertices];
      for_each_facet_of<kVertices, Index>(mesh_.row(s), [&](std::uint64_t hash, std::size_t place) {
        const std::size_t pile = pile_of(hash);
        // A branch on whether the record is wanted would be unpredictable.
        const auto wanted = static_cast<std::size_t>(is_wanted(links[place], s)) &
                            static_cast<std::size_t>(pile - first_pile < last_pile - first_pile);
        const std::size_t to = nowhere ^ ((nowhere ^ next[pile]) & -wanted);
        records[to] = record(hash, s * kVertices + place);
        next[pile] += static_cast<std::uint32_t>(wanted);
      });
    }
  }

  // Calls match_one(records of a pile, a table) for each pile.
  template <class MatchOne>
  void match(std::size_t first_pile, std::size_t last_pile, const MatchOne& match_one) {
    constexpr std::size_t kPilesInChunk = 8;
    in_chunks(last_pile - first_pile, kPilesInChunk, threads_,
              [&](std::size_t, std::size_t first, std::size_t last) {
                std::vector<std::uint64_t> table;
                for (std::size_t pile = first; pile < last; ++pile) {
                  const std::size_t begin = begins_[pile], count = begins_[pile + 1] - begin;
                  match_one(std::span(&records_[begin], count), table);
                }
              });
  }

  void match_pile(std::span<std::uint64_t> pile, std::vector<std::uint64_t>& table) {
    if (proposal_ == Proposal::kLikely) {
      const auto link_pair = [&](std::uint64_t record, std::uint64_t other, bool is_pair) {
        const auto beyond = static_cast<std::int32_t>(layout_.facet(other) / kVertices);
        links_[layout_.facet(record)] = beyond | (static_cast<std::int32_t>(is_pair) - 1);
      };
      const int skipped = bits_of(pile.size());
      pile = pile.first(pair_by_sums(layout_, pile, 0, table, link_pair));
      // Most of the others that have a partner shared a slot with other facets.
      pile = pile.first(pair_by_sums(layout_, pile, skipped, table, link_pair));
    }
    match_one_by_one(pile, table);
  }

  // Pairs records of the same hash in a table with open addressing; at most half of it is used if
  // all facets have two simplices.
  void match_one_by_one(std::span<const std::uint64_t> pile, std::vector<std::uint64_t>& table) {
    constexpr std::uint64_t kFree = ~std::uint64_t{0};
    const int bits = bits_of(pile.size());
    table.assign(std::size_t{1} << bits, kFree);
    const std::size_t mask = table.size() - 1;
    std::vector<std::uint64_t> thrice;
    for (const std::uint64_t record : pile) {
      auto place = static_cast<std::size_t>(record >> (64 - bits));
      while (table[place] != kFree && !layout_.same_hash(table[place], record)) {
        place = (place + 1) & mask;
      }
      if (table[place] == kFree) {
        table[place] = record;
      } else if (layout_.facet(table[place]) == layout_.no_facet()) {
        thrice.push_back(record);
      } else {
        link(layout_.facet(table[place]), layout_.facet(record));
        table[place] |= layout_.no_facet();
      }
    }
    if (!thrice.empty()) match_by_vertices(pile, thrice);
  }

  // Matches the facets again whose hash two facets share that are not a pair.
  void separate(std::span<const std::uint64_t> pile, std::vector<std::uint64_t>& bits) {
    // One bit each, within the nearest cache; few records find another's bit set, most of them by
    // accident.
    const int shift = 64 - bits_of(pile.size()) - 3;
    const std::size_t words = (std::size_t{1} << (64 - shift)) / 64 + 1;
    bits.assign(2 * words, 0);
    std::uint64_t* const seen = bits.data();
    std::uint64_t* const again = seen + words;
    for (const std::uint64_t record : pile) {
      const std::uint64_t place = record >> shift, bit = std::uint64_t{1} << (place % 64);
      again[place / 64] |= seen[place / 64] & bit;
      seen[place / 64] |= bit;
    }
    std::vector<std::uint64_t> doubtful;
    for (const std::uint64_t record : pile) {
      const std::uint64_t place = record >> shift;
      if ((again[place / 64] >> (place % 64) & 1) != 0) doubtful.push_back(record);
    }
    std::sort(doubtful.begin(), doubtful.end());
    std::vector<std::uint64_t> twice;
    for (std::size_t i = 1; i < doubtful.size(); ++i) {
      if (layout_.same_hash(doubtful[i - 1], doubtful[i])) twice.push_back(doubtful[i]);
    }
    if (!twice.empty()) match_by_vertices(with_partners(doubtful, twice), twice);
  }

  // The records whose hash is among those of `some`, and those of the facets that they are linked
  // to.
  std::vector<std::uint64_t> with_partners(std::span<const std::uint64_t> pile,
                                           const std::vector<std::uint64_t>& some) {
    std::set<std::uint64_t> hashes, facets;
    for (const std::uint64_t record : some) hashes.insert(layout_.hash(record));
    std::vector<std::uint64_t> all;
    for (const std::uint64_t record : pile) {
      if (!hashes.contains(layout_.hash(record))) continue;
      const std::uint64_t facet = layout_.facet(record);
      if (facets.insert(facet).second) all.push_back(record);
      if (links_[facet] < 0) continue;
      const auto vertices = vertices_of(facet);
      for (std::size_t place = 0; place < kVertices; ++place) {
        const std::uint64_t other = static_cast<std::uint64_t>(links_[facet]) * kVertices + place;
        if (vertices_of(other) == vertices && facets.insert(other).second) {
          all.push_back((record & ~layout_.no_facet()) | other);
        }
      }
    }
    const std::lock_guard lock(mutex_);
    matched_again_.insert(matched_again_.end(), facets.begin(), facets.end());
    return all;
  }

  void link(std::uint64_t a, std::uint64_t b) {
    links_[a] = static_cast<std::int32_t>(b / kVertices);
    links_[b] = static_cast<std::int32_t>(a / kVertices);
  }

  // The facets whose hash three or more have.
  void match_by_vertices(std::span<const std::uint64_t> pile, std::vector<std::uint64_t>& thrice) {
    for (std::uint64_t& record : thrice) record = layout_.hash(record);
    std::sort(thrice.begin(), thrice.end());
    std::map<std::array<Index, kDimension>, std::vector<std::uint64_t>> uses;
    for (const std::uint64_t record : pile) {
      if (!std::binary_search(thrice.begin(), thrice.end(), layout_.hash(record))) continue;
      const std::uint64_t facet = layout_.facet(record);
      links_[facet] = -1;
      uses[vertices_of(facet)].push_back(facet);
    }
    for (const auto& [vertices, facets] : uses) {
      if (facets.size() > 2) {
        const std::lock_guard lock(mutex_);
        overused_.push_back(facets);
      }
      if (facets.size() == 2) link(facets[0], facets[1]);
    }
  }

  std::array<Index, kDimension> vertices_of(std::uint64_t facet) const {
    return facet_of(mesh_.row(facet / kVertices), facet % kVertices);
  }

  const MeshView<kDimension, Index>& mesh_;
  Proposal proposal_;
  unsigned threads_;
  RecordLayout layout_;
  std::size_t slice_ = 1;
  std::size_t piles_ = 1;  // a power of two
  // The number of facets for each slice of simplices and each pile; once a pile is filled, the
  // place where the slice's records end.
  std::vector<std::uint32_t> counts_;
  std::size_t most_records_ = 0;       // at a time
  LargeArray<std::uint64_t> records_;  // and a place for each slice to write unwanted records
  std::vector<std::size_t> begins_;    // of the piles in records_
  LargeArray<std::int32_t> links_;
  std::mutex mutex_;  // of:
  std::vector<std::vector<std::uint64_t>> overused_;
  std::vector<std::uint64_t> matched_again_;
};

}  // namespace

template <std::size_t kDimension, typename Index>
tl::expected<OwnedLinks, Undecided> matched_facets(const MeshView<kDimension, Index>& mesh,
                                                   unsigned threads, Proposal proposal) {
  return Matching<kDimension, Index>(mesh, proposal, threads).run();
}

template <std::size_t kDimension, typename Index>
std::vector<std::uint64_t> complete(const MeshView<kDimension, Index>& mesh, OwnedLinks& links,
                                    unsigned threads) {
  return Matching<kDimension, Index>(mesh, Proposal::kComplete, threads).complete(links);
}

template tl::expected<OwnedLinks, Undecided> matched_facets(const MeshView<2, std::int32_t>&,
                                                            unsigned, Proposal);
template tl::expected<OwnedLinks, Undecided> matched_facets(const MeshView<2, std::int64_t>&,
                                                            unsigned, Proposal);
template tl::expected<OwnedLinks, Undecided> matched_facets(const MeshView<3, std::int32_t>&,
                                                            unsigned, Proposal);
template tl::expected<OwnedLinks, Undecided> matched_facets(const MeshView<3, std::int64_t>&,
                                                            unsigned, Proposal);
template std::vector<std::uint64_t> complete(const MeshView<2, std::int32_t>&, OwnedLinks&,
                                             unsigned);
template std::vector<std::uint64_t> complete(const MeshView<2, std::int64_t>&, OwnedLinks&,
                                             unsigned);
template std::vector<std::uint64_t> complete(const MeshView<3, std::int32_t>&, OwnedLinks&,
                                             unsigned);
template std::vector<std::uint64_t> complete(const MeshView<3, std::int64_t>&, OwnedLinks&,
                                             unsigned);

}  // namespace circumspect::fast
