#include "oracle/fast/facet_matching.hpp"

#include <algorithm>
#include <atomic>
#include <map>
#include <memory>
#include <numeric>
#include <optional>

#include "oracle/fast/facet_records.hpp"
#include "oracle/fast/in_chunks.hpp"

namespace circumspect::fast {
namespace {

constexpr std::size_t kFacetsInPile = 8192;  // and their table, within a second-level cache
constexpr std::size_t kMostPiles = std::size_t{1} << 14;
constexpr std::uint64_t kMostSimplices = std::uint64_t{1} << 29;

template <std::size_t kDimension, typename Index>
class Matching {
 public:
  Matching(const MeshView<kDimension, Index>& mesh, unsigned threads)
      : mesh_(mesh), threads_(threads), layout_(mesh.simplices.size()) {
    // A slice of simplices for each thread: within a pile their order stays.
    slice_ = chunks_of(mesh.size(), threads);
    const std::size_t wanted = chunks_of(mesh.simplices.size(), kFacetsInPile);
    piles_.count = std::min(std::bit_ceil(std::max(wanted, std::size_t{2})), kMostPiles);
    const int bits = bits_of(mesh.points() == 0 ? 0 : mesh.points() - 1);
    piles_.shift = std::max(0, bits - bits_of(piles_.count) + 1);
  }

  tl::expected<OwnedLinks, Undecided> run() {
    if (mesh_.size() > kMostSimplices) return tl::unexpected(Undecided::kTooLarge);
    if (!count()) return tl::unexpected(Undecided::kUnknownVertex);
    if (largest_pile() > std::max(mesh_.simplices.size() / 8, 4 * kFacetsInPile)) {
      piles_.by_hash = true;
      piles_.shift = 64 - bits_of(piles_.count) + 1;
      if (!count()) return tl::unexpected(Undecided::kUnknownVertex);
    }
    // The memory is touched for the first time by all threads.
    links_ = std::make_unique_for_overwrite<std::int32_t[]>(mesh_.simplices.size());
    in_chunks(mesh_.simplices.size(), slice_ * kVertices, threads_,
              [&](std::size_t, std::size_t first, std::size_t last) {
                std::fill(&links_[first], &links_[0] + last, -1);
              });
    // As many piles at a time as have records for not quite half of the facets.
    const std::size_t most = std::max(mesh_.simplices.size() * 7 / 16, largest_pile());
    records_ = std::make_unique_for_overwrite<std::uint64_t[]>(most);
    for (std::size_t first = 0; first < piles_.count;) {
      std::size_t last = first;
      std::size_t records = 0;
      while (last < piles_.count && records + size_of(last) <= most) records += size_of(last++);
      fill(first, last);
      match(first, last);
      if (overused_.load()) return tl::unexpected(Undecided::kFacetOverused);
      first = last;
    }
    return OwnedLinks{std::move(links_), mesh_.simplices.size()};
  }

 private:
  static constexpr std::size_t kVertices = kDimension + 1;

  std::size_t slices() const { return chunks_of(mesh_.size(), slice_); }
  std::uint32_t& counted(std::size_t slice, std::size_t pile) {
    return counts_[slice * piles_.count + pile];
  }
  std::size_t size_of(std::size_t pile) {
    std::size_t size = 0;
    for (std::size_t slice = 0; slice < slices(); ++slice) size += counted(slice, pile);
    return size;
  }
  std::size_t largest_pile() {
    std::size_t largest = 0;
    for (std::size_t pile = 0; pile < piles_.count; ++pile) {
      largest = std::max(largest, size_of(pile));
    }
    return largest;
  }

  // How many facets each slice has for each pile; false if an index names no point.
  bool count() {
    counts_.assign(slices() * piles_.count, 0);
    std::atomic<bool> known = true;
    in_chunks(mesh_.size(), slice_, threads_,
              [&](std::size_t slice, std::size_t first, std::size_t last) {
                std::uint32_t* const counts = &counted(slice, 0);
                bool all_known = true;
                for (std::size_t s = first; s < last && all_known; ++s) {
                  for (const Index v : mesh_.row(s)) all_known &= mesh_.names_point(v);
                  if (!all_known) break;
                  for_each_facet_of<kVertices, Index>(
                      mesh_.row(s), [&](std::uint64_t least, std::uint64_t hash, std::size_t) {
                        ++counts[piles_.of(least, hash)];
                      });
                }
                if (!all_known) known.store(false);
              });
    return known.load();
  }

  // Writes the records of these piles, pile by pile.
  void fill(std::size_t first_pile, std::size_t last_pile) {
    std::vector<std::size_t> next(slices() * piles_.count);
    begins_.assign(1, 0);
    std::size_t begin = 0;
    for (std::size_t pile = first_pile; pile < last_pile; ++pile) {
      for (std::size_t slice = 0; slice < slices(); ++slice) {
        next[slice * piles_.count + pile] = begin;
        begin += counted(slice, pile);
      }
      begins_.push_back(begin);
    }
    in_chunks(mesh_.size(), slice_, threads_,
              [&](std::size_t slice, std::size_t first, std::size_t last) {
                std::size_t* const places = &next[slice * piles_.count];
                for (std::size_t s = first; s < last; ++s) {
                  for_each_facet_of<kVertices, Index>(
                      mesh_.row(s),
                      [&](std::uint64_t least, std::uint64_t hash, std::size_t place) {
                        const std::size_t pile = piles_.of(least, hash);
                        if (pile - first_pile >= last_pile - first_pile) return;
                        records_[places[pile]++] = layout_.record(hash, s * kVertices + place);
                      });
                }
              });
  }

  void match(std::size_t first_pile, std::size_t last_pile) {
    constexpr std::size_t kPilesInChunk = 8;
    in_chunks(last_pile - first_pile, kPilesInChunk, threads_,
              [&](std::size_t, std::size_t first, std::size_t last) {
                std::vector<std::uint64_t> table;
                for (std::size_t pile = first; pile < last; ++pile) {
                  match_pile({&records_[begins_[pile]], begins_[pile + 1] - begins_[pile]}, table);
                }
              });
  }

  // Pairs records of the same hash in a table with open addressing, of which at most half is used if all facets have
  // two simplices.
  void match_pile(std::span<const std::uint64_t> pile, std::vector<std::uint64_t>& table) {
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

  void link(std::uint64_t a, std::uint64_t b) {
    links_[a] = static_cast<std::int32_t>(b / kVertices);
    links_[b] = static_cast<std::int32_t>(a / kVertices);
  }

  // Facets of which three or more have the same hash.
  void match_by_vertices(std::span<const std::uint64_t> pile,
                         const std::vector<std::uint64_t>& thrice) {
    std::map<std::array<Index, kDimension>, std::vector<std::uint64_t>> uses;
    for (const std::uint64_t record : pile) {
      const bool among_them = std::any_of(thrice.begin(), thrice.end(), [&](std::uint64_t other) {
        return layout_.same_hash(record, other);
      });
      if (!among_them) continue;
      const std::uint64_t facet = layout_.facet(record);
      links_[facet] = -1;
      uses[vertices_of(facet)].push_back(facet);
    }
    for (const auto& [vertices, facets] : uses) {
      if (facets.size() > 2) overused_.store(true);
      if (facets.size() == 2) link(facets[0], facets[1]);
    }
  }

  std::array<Index, kDimension> vertices_of(std::uint64_t facet) const {
    std::array<Index, kDimension> vertices;
    std::size_t next = 0;
    for (std::size_t i = 0; i < kVertices; ++i) {
      if (i != facet % kVertices) vertices[next++] = mesh_.row(facet / kVertices)[i];
    }
    std::sort(vertices.begin(), vertices.end());
    return vertices;
  }

  const MeshView<kDimension, Index>& mesh_;
  unsigned threads_;
  RecordLayout layout_;
  std::size_t slice_ = 1;
  Piles piles_;
  std::vector<std::uint32_t>
      counts_;  // a slice of simplices after the other, a pile after the other
  std::unique_ptr<std::uint64_t[]> records_;
  std::vector<std::size_t> begins_;  // of the piles in records_
  std::unique_ptr<std::int32_t[]> links_;
  std::atomic<bool> overused_ = false;
};

}  // namespace

template <std::size_t kDimension, typename Index>
tl::expected<OwnedLinks, Undecided> matched_facets(const MeshView<kDimension, Index>& mesh,
                                                   unsigned threads) {
  return Matching<kDimension, Index>(mesh, threads).run();
}

template tl::expected<OwnedLinks, Undecided> matched_facets(const MeshView<2, std::int32_t>&,
                                                            unsigned);
template tl::expected<OwnedLinks, Undecided> matched_facets(const MeshView<2, std::int64_t>&,
                                                            unsigned);
template tl::expected<OwnedLinks, Undecided> matched_facets(const MeshView<3, std::int32_t>&,
                                                            unsigned);
template tl::expected<OwnedLinks, Undecided> matched_facets(const MeshView<3, std::int64_t>&,
                                                            unsigned);

}  // namespace circumspect::fast
