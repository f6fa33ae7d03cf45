// One pass over the simplices that looks at every simplex and every facet once, and notes
// orientations, used points, and simplices at the boundary.
#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "oracle/judge/fast/block.hpp"
#include "oracle/judge/fast/in_chunks.hpp"
#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/judge/fast/predicates/lattice.hpp"
#include "oracle/judge/fast/predicates/predicates.hpp"
#include "oracle/judge/fast/predicates/site.hpp"
#include "oracle/judge/fast/sample_point.hpp"
#include "oracle/judge/fast/undecided.hpp"

namespace circumspect::fast {

// The orientations of all simplices: one for all, as most programs write them, or one bit each.
class Orientations {
 public:
  explicit Orientations(int all) : all_(all) {}
  // Bit s of `negative` says that simplex s is negatively oriented.
  explicit Orientations(std::vector<std::uint64_t> negative)
      : all_(0), negative_(std::move(negative)) {}

  bool are_equal() const { return all_ != 0; }
  int of(std::size_t s) const {
    if (all_ != 0) return all_;
    return (negative_[s / 64] >> (s % 64) & 1) != 0 ? -1 : 1;
  }
  // How many of so many simplices are positively oriented.
  std::size_t positive(std::size_t size) const {
    std::size_t count = 0;
    for (std::size_t s = 0; s < size; ++s) count += of(s) > 0 ? 1 : 0;
    return count;
  }

 private:
  int all_;
  std::vector<std::uint64_t> negative_;
};

// Which points are vertices: one bit each, set by any number of threads.
class UsedPoints {
 public:
  explicit UsedPoints(std::size_t points) : points_(points), words_((points + 63) / 64) {}

  // Requires: v < the number of points.
  void mark(std::size_t v) {
    std::atomic<std::uint64_t>& word = words_[v / 64];
    const std::uint64_t bit = std::uint64_t{1} << (v % 64);
    // Most points are marked before, and reading a shared word is cheap.
    if ((word.load(std::memory_order_relaxed) & bit) == 0) {
      word.fetch_or(bit, std::memory_order_relaxed);
    }
  }

  // The points that are not marked, ascending.
  std::vector<std::size_t> missing() const {
    std::vector<std::size_t> unused;
    for (std::size_t place = 0; place < words_.size(); ++place) {
      const std::uint64_t word = words_[place].load(std::memory_order_relaxed);
      if (word == ~std::uint64_t{0}) continue;
      for (std::size_t v = place * 64; v < points_ && v < (place + 1) * 64; ++v) {
        if ((word >> (v % 64) & 1) == 0) unused.push_back(v);
      }
    }
    return unused;
  }

 private:
  std::size_t points_;
  std::vector<std::atomic<std::uint64_t>> words_;
};

// Which simplices have a facet without a link: a bit each, set by any number of threads, block by
// block.
class BoundarySimplices {
 public:
  explicit BoundarySimplices(std::size_t simplices) : blocks_(chunks_of(simplices, kBlock)) {}

  // Bit i of `bits`: simplex `block` · kBlock + i.
  void set(std::size_t block, std::uint32_t bits) { blocks_[block] = bits; }

  // Their facets without a link in simplices `first` to `last` − 1, ascending. Requires: first is a
  // multiple of kBlock.
  template <std::size_t kVertices, typename Link>
  std::vector<FacetId> facets(Links<Link> links, std::size_t first, std::size_t last) const {
    std::vector<FacetId> facets;
    for (std::size_t block = first / kBlock; block * kBlock < last; ++block) {
      for (std::uint32_t bits = blocks_[block]; bits != 0; bits &= bits - 1) {
        const std::size_t s = block * kBlock + static_cast<std::size_t>(std::countr_zero(bits));
        for (std::size_t place = 0; place < kVertices; ++place) {
          if (links[s * kVertices + place] < 0) facets.emplace_back(s, place);
        }
      }
    }
    return facets;
  }

 private:
  static_assert(kBlock == 32);
  std::vector<std::uint32_t> blocks_;
};

// One pass over the simplices that looks at every simplex and every facet once: conditions 0 and 1
// of docs/theory/points.md, what condition 3 says of simplices, the links, and Lemma 4.1.

template <std::size_t kDimension, typename Index, typename Link>
struct SweepTask {
  const MeshView<kDimension, Index>& mesh;
  Links<Link> links;
  const Orientations& orientations;       // if equal for all: that of one simplex
  const SamplePoint<kDimension>* sample;  // none: what the simplices cover does not matter
  bool balls;                             // are facets to be locally Delaunay?
  bool weighted;                          // in the weighted sense? Requires weights.
  bool ties;                              // list the facets whose apex is on the sphere?
  bool past_doubts = false;               // continue to the end, even if some are wrong?
  Lattice lattice;  // one that contains all points, and their weights if those count
  UsedPoints& used;
  BoundarySimplices& boundary;
  const BlockKernels<kDimension>* kernels = nullptr;  // none: the widest of this machine
};

inline Stages sum(const Stages& a, const Stages& b) {
  return {a.filtered + b.filtered, a.narrow + b.narrow, a.fixed + b.fixed, a.wide + b.wide,
          a.unbounded + b.unbounded};
}

// The result of the pass over some of the simplices.
struct Swept {
  std::optional<Undecided> undecided = {};
  bool mixed = false;      // not all simplices are oriented alike; nothing else is known
  bool unique = true;      // no apex is on the sphere of the simplex across
  bool canonical = true;   // every facet is locally Delaunay under the canonical perturbation
  std::uint64_t up = 0;    // links to a later simplex, each verified from both ends
  std::uint64_t down = 0;  // links to an earlier one: all verified iff there are as many in all
  // Facets of two simplices, in ascending order.
  std::vector<FacetId> not_local = {};      // the other apex is strictly inside the ball
  std::vector<FacetId> ties = {};           // it is on the sphere; listed if asked for
  std::vector<FacetId> not_canonical = {};  // those of them that the perturbation makes not local
  // If the sweep continues past doubts: the first simplices of the blocks in which something is
  // wrong, ascending, and the first reason. Nothing else is known about these blocks except the
  // number of links. Simplices of other blocks are sound, and so are their links to later ones.
  std::vector<std::size_t> doubtful = {};
  std::optional<Undecided> doubt = {};
  Stages stages = {};

  bool goes_on() const { return !undecided && !mixed; }
  // Adds the results for the simplices that follow.
  void append(const Swept& later);
};

// Sweeps simplices `first` to `last` − 1, where `first` is a multiple of kBlock; ends at the first
// fault. A facet of two of them is tested from the simplex that comes first.
template <std::size_t kDimension, typename Index, typename Link>
Swept sweep(const SweepTask<kDimension, Index, Link>& task, std::size_t first, std::size_t last);

// The sweep of all simplices of a mesh, by all threads; if not all of them are oriented alike,
// those for which this matters are swept again.

// What a sweep has to check (SweepTask explains each).
template <std::size_t kDimension>
struct SweepQuestions {
  const SamplePoint<kDimension>* sample = nullptr;  // its simplex may be in another part of a mesh
  bool balls = false;
  bool weighted = false;
  bool ties = false;
  bool past_doubts = false;
};

template <std::size_t kDimension, typename Index, typename Link>
class WholeSweep {
 public:
  // How many simplices one thread processes at a time.
  static constexpr std::size_t kChunk = std::size_t{1} << 12;
  static_assert(kChunk % kBlock == 0);

  WholeSweep(const MeshView<kDimension, Index>& mesh, Links<Link> links, unsigned threads)
      : mesh_(mesh),
        links_(links),
        threads_(threads),
        used_(mesh.points()),
        boundary_(mesh.size()) {}

  // Undecided, or all conditions that `sweep` checks hold, and every link is verified. Requires: at
  // least one simplex; finite coordinates, and weights if they count.
  Swept run(const SweepQuestions<kDimension>& questions) {
    Stages stages;
    const bool has_sample = questions.sample != nullptr && questions.sample->simplex < mesh_.size();
    const auto first = orientation_of(has_sample ? questions.sample->simplex : 0, stages);
    if (!first) return {.undecided = first.error()};
    orientations_ = Orientations(*first);
    lattice_ = lattice_of_all(mesh_.coordinates,
                              questions.weighted ? mesh_.weights : std::span<const double>());
    std::vector<Swept> parts(chunks_of(mesh_.size(), kChunk));
    std::vector<std::size_t> chunks(parts.size());
    std::iota(chunks.begin(), chunks.end(), std::size_t{0});
    sweep_chunks(chunks, questions, parts);
    if (std::any_of(parts.begin(), parts.end(), [](const Swept& part) { return part.mixed; })) {
      const auto again = tell_orientations_apart(*first, questions.past_doubts, parts);
      if (!again) return {.undecided = again.error()};
      sweep_chunks(*again, questions, parts);
    }
    Swept swept;
    for (const Swept& part : parts) swept.append(part);
    // Signs are exact, so a second pass finds only expected orientations.
    if (!swept.undecided && (swept.mixed || (swept.up != swept.down && !swept.doubt))) {
      swept.undecided = Undecided::kUnmatchedNeighbor;
    }
    return swept;
  }

  // After run: …
  const Orientations& orientations() const { return orientations_; }
  // … which simplices have boundary facets …
  const BoundarySimplices& boundary() const { return boundary_; }
  // … a lattice that contains all points, or none …
  Lattice lattice() const { return lattice_; }
  // … and points that are not vertices, ascending.
  std::vector<std::size_t> unused() const { return used_.missing(); }

 private:
  static constexpr std::size_t kVertices = kDimension + 1;
  static constexpr std::size_t kBits = 64;  // of a word of Orientations

  tl::expected<int, Undecided> orientation_of(std::size_t s, Stages& stages) const {
    SiteRow<kDimension> row;
    for (std::size_t i = 0; i < kVertices; ++i) {
      const Index v = mesh_.row(s)[i];
      if (!mesh_.names_point(v)) return tl::unexpected(Undecided::kUnknownVertex);
      row[i] = mesh_.template site<false>(v);
    }
    const int sign = orientation<kDimension>(row, stages);
    if (sign == 0) return tl::unexpected(Undecided::kFlatSimplex);
    return sign;
  }

  // Writes bit s of `negative` for simplices `begin` to `end` − 1: is s negatively oriented? When
  // continuing past doubts, a flat simplex counts as positive: the second pass finds it. Requires:
  // their words are 0, and no other thread writes them.
  std::optional<Undecided> orient(std::size_t begin, std::size_t end, bool past_doubts,
                                  std::vector<std::uint64_t>& negative) const {
    Stages stages;  // every sign is computed again
    for (std::size_t s = begin; s < end; ++s) {
      auto sign = orientation_of(s, stages);
      if (!sign) {
        if (!past_doubts || sign.error() != Undecided::kFlatSimplex) return sign.error();
        sign = 1;
      }
      // A branch on which of the two it is may be unpredictable.
      negative[s / kBits] |= std::uint64_t{*sign < 0} << (s % kBits);
    }
    return std::nullopt;
  }

  // Stores orientations as one bit each, given that the sweep `parts` expected `first` of all, and
  // returns the chunks whose sweep they would change, ascending: those in which something is wrong,
  // and those with a link to a simplex that is not oriented like the first. In all other chunks,
  // every simplex is oriented like the first.
  tl::expected<std::vector<std::size_t>, Undecided> tell_orientations_apart(
      int first, bool past_doubts, const std::vector<Swept>& parts) {
    static_assert(kChunk % kBits == 0);
    const std::uint64_t as_first = first < 0 ? ~std::uint64_t{0} : 0;
    std::vector<std::uint64_t> negative(chunks_of(mesh_.size(), kBits), as_first);
    std::vector<std::optional<Undecided>> found(parts.size());
    std::vector<std::atomic<bool>> again(parts.size());
    const auto is_sound = [](const Swept& part) { return part.goes_on() && part.doubtful.empty(); };
    const bool all_again = std::none_of(parts.begin(), parts.end(), is_sound);
    in_chunks(mesh_.size(), kChunk, threads_,
              [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                if (is_sound(parts[chunk])) return;
                again[chunk].store(true, std::memory_order_relaxed);
                std::fill(negative.begin() + static_cast<std::ptrdiff_t>(begin / kBits),
                          negative.begin() + static_cast<std::ptrdiff_t>(chunks_of(end, kBits)), 0);
                found[chunk] = orient(begin, end, past_doubts, negative);
                if (found[chunk] || all_again) return;
                for (std::size_t s = begin; s < end; ++s) {
                  const std::uint64_t others = (negative[s / kBits] ^ as_first) >> (s % kBits);
                  if ((others & 1) == 0) continue;
                  for (const Link beyond : links_.subspan(s * kVertices, kVertices)) {
                    const auto other = static_cast<std::size_t>(beyond);
                    if (beyond < 0 || other >= mesh_.size()) continue;
                    again[other / kChunk].store(true, std::memory_order_relaxed);
                  }
                }
              });
    for (const std::optional<Undecided>& reason : found) {
      if (reason) return tl::unexpected(*reason);
    }
    orientations_ = Orientations(std::move(negative));
    std::vector<std::size_t> chunks;
    for (std::size_t chunk = 0; chunk < parts.size(); ++chunk) {
      if (again[chunk].load(std::memory_order_relaxed)) chunks.push_back(chunk);
    }
    return chunks;
  }

  void sweep_chunks(const std::vector<std::size_t>& chunks,
                    const SweepQuestions<kDimension>& questions, std::vector<Swept>& parts) {
    const SweepTask<kDimension, Index, Link> task{.mesh = mesh_,
                                                  .links = links_,
                                                  .orientations = orientations_,
                                                  .sample = questions.sample,
                                                  .balls = questions.balls,
                                                  .weighted = questions.weighted,
                                                  .ties = questions.ties,
                                                  .past_doubts = questions.past_doubts,
                                                  .lattice = lattice_,
                                                  .used = used_,
                                                  .boundary = boundary_};
    in_chunks(chunks.size(), 1, threads_, [&](std::size_t i, std::size_t, std::size_t) {
      const std::size_t begin = chunks[i] * kChunk;
      parts[chunks[i]] = sweep(task, begin, std::min(begin + kChunk, mesh_.size()));
    });
  }

  const MeshView<kDimension, Index>& mesh_;
  Links<Link> links_;
  unsigned threads_;
  Orientations orientations_{1};
  UsedPoints used_;
  BoundarySimplices boundary_;
  Lattice lattice_ = {};
};

}  // namespace circumspect::fast
