#include "oracle/fast/sweep.hpp"

#include <algorithm>
#include <array>

#include "oracle/fast/facet_across.hpp"
#include "oracle/fast/row_predicates.hpp"

namespace circumspect::fast {
namespace {

// Simplices that are looked at together: what one phase asks the caches for is there in the next.
constexpr std::size_t kBlock = 32;

void prefetch(const void* from, std::size_t bytes) {
  const char* const begin = static_cast<const char*>(from);
  __builtin_prefetch(begin);
  if (bytes > sizeof(double)) __builtin_prefetch(begin + bytes - 1);
}

template <std::size_t kDimension, bool kWeighted, typename Index, typename Link>
class BlockSweep {
 public:
  BlockSweep(const SweepTask<kDimension, Index, Link>& task, Swept& swept)
      : task_(task), mesh_(task.mesh), swept_(swept) {
    balls_.reserve(kBlock);
  }

  void run(std::size_t first, std::size_t last) {
    first_ = first;
    count_ = last - first;
    look_at_rows();
    if (swept_.goes_on()) look_across();
    if (swept_.goes_on()) look_at_simplices();
    if (swept_.goes_on() && task_.balls) look_at_balls();
  }

 private:
  static constexpr std::size_t kVertices = kDimension + 1;

  // A facet of one of the simplices, with what is across it.
  struct Facet {
    std::uint32_t in_block;  // which simplex
    std::uint32_t place;     // of its apex
    std::size_t beyond;      // the simplex across
    Index apex = 0;          // of that
  };

  void give_up(Undecided reason) {
    if (!swept_.undecided) swept_.undecided = reason;
  }

  void prefetch_site(Index v) const {
    const auto place = static_cast<std::size_t>(v);
    prefetch(mesh_.coordinates.data() + place * kDimension, kDimension * sizeof(double));
    if constexpr (kWeighted) prefetch(mesh_.weights.data() + place, sizeof(double));
  }

  // Indices name something; what they name is on its way.
  void look_at_rows() {
    facet_count_ = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const std::size_t s = first_ + i;
      for (const Index v : mesh_.row(s)) {
        if (!mesh_.names_point(v)) return give_up(Undecided::kUnknownVertex);
        prefetch_site(v);
        task_.used.mark(static_cast<std::size_t>(v));
      }
      list_facets(i);
    }
  }

  void list_facets(std::size_t i) {
    const std::size_t s = first_ + i;
    const Link* const links = task_.links.data() + s * kVertices;
    const std::size_t before = facet_count_;
    std::size_t boundary = 0;
    for (std::size_t place = 0; place < kVertices; ++place) {
      const auto beyond = static_cast<std::int64_t>(links[place]);
      if (beyond < 0) {
        if (beyond != -1) return give_up(Undecided::kUnmatchedNeighbor);
        swept_.boundary.push_back(s * kVertices + place);
        ++boundary;
        continue;
      }
      const auto t = static_cast<std::size_t>(beyond);
      if (t >= mesh_.size()) return give_up(Undecided::kUnmatchedNeighbor);
      facets_[facet_count_] = {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(place), t};
      // Which of the two comes first is a coin toss: no branch.
      facet_count_ += static_cast<std::size_t>(t > s);
      __builtin_prefetch(mesh_.simplices.data() + t * kVertices);
      __builtin_prefetch(task_.links.data() + t * kVertices);
    }
    const std::size_t up = facet_count_ - before;
    swept_.up += up;
    swept_.down += kVertices - boundary - up;
  }

  // The simplices across share the facet, are linked back, and lie on its other side.
  void look_across() {
    for (std::size_t i = 0; i < facet_count_; ++i) {
      Facet& facet = facets_[i];
      const std::size_t s = first_ + facet.in_block;
      const auto row = mesh_.row(facet.beyond);
      const Across found = across<kVertices, Index>(mesh_.row(s), facet.place, row);
      if (!found.matches) return give_up(Undecided::kUnmatchedNeighbor);
      const Link back = task_.links[facet.beyond * kVertices + found.place];
      if (back < 0 || static_cast<std::size_t>(back) != s) {
        return give_up(Undecided::kUnmatchedNeighbor);
      }
      const int product = task_.orientations.are_equal()
                              ? 1
                              : task_.orientations.of(s) * task_.orientations.of(facet.beyond);
      if ((product > 0) != found.odd) {
        // Unless the one of them is oriented as expected and the other is not.
        if (!task_.orientations.are_equal()) return give_up(Undecided::kSameSide);
        swept_.mixed = true;
        return;
      }
      facet.apex = row[found.place];
      if (!mesh_.names_point(facet.apex)) return give_up(Undecided::kUnknownVertex);
      prefetch_site(facet.apex);
    }
  }

  void look_at_simplices() {
    balls_.clear();
    for (std::size_t i = 0; i < count_; ++i) {
      const std::size_t s = first_ + i;
      SiteRow<kDimension> row;
      for (std::size_t place = 0; place < kVertices; ++place) {
        row[place] = mesh_.template site<kWeighted>(mesh_.row(s)[place]);
      }
      balls_.push_back(ball_of<kDimension, kWeighted>(row));
      const int own = balls_.back().orientation(swept_.stages);
      if (own != task_.orientations.of(s)) {
        if (own == 0) return give_up(Undecided::kFlatSimplex);
        swept_.mixed = true;
        return;
      }
      if (covers<kDimension>(row, own, task_.sample.site, swept_.stages) &&
          s != task_.sample.simplex) {
        return give_up(Undecided::kCoveredTwice);
      }
    }
  }

  void look_at_balls() {
    for (std::size_t i = 0; i < facet_count_; ++i) {
      const Facet& facet = facets_[i];
      const Site<kDimension> apex = mesh_.template site<kWeighted>(facet.apex);
      const int own = task_.orientations.of(first_ + facet.in_block);
      const int side = balls_[facet.in_block].contains(apex, swept_.stages) * own;
      if (side < 0) continue;
      if (side > 0) return give_up(Undecided::kFacetNotLocal);
      swept_.unique = false;
      if (swept_.canonical) swept_.canonical = is_canonical(facet, apex, own);
    }
  }

  bool is_canonical(const Facet& facet, const Site<kDimension>& apex, int own) {
    SiteRow<kDimension> row;
    for (std::size_t place = 0; place < kVertices; ++place) {
      row[place] = mesh_.template site<false>(mesh_.row(first_ + facet.in_block)[place]);
    }
    return perturbed_sign_of_zero<kDimension>(row, own, apex, swept_.stages) < 0;
  }

  const SweepTask<kDimension, Index, Link>& task_;
  const MeshView<kDimension, Index>& mesh_;
  Swept& swept_;
  std::size_t first_ = 0;
  std::size_t count_ = 0;
  std::array<Facet, kBlock * kVertices + 1> facets_;  // one more, which is written and not kept
  std::size_t facet_count_ = 0;
  std::vector<Ball<kDimension, kWeighted>> balls_;
};

template <bool kWeighted, std::size_t kDimension, typename Index, typename Link>
Swept swept_in_blocks(const SweepTask<kDimension, Index, Link>& task, std::size_t first,
                      std::size_t last) {
  Swept swept;
  BlockSweep<kDimension, kWeighted, Index, Link> blocks(task, swept);
  for (std::size_t block = first; block < last && swept.goes_on(); block += kBlock) {
    blocks.run(block, std::min(block + kBlock, last));
  }
  return swept;
}

}  // namespace

void Swept::append(const Swept& later) {
  if (!undecided) undecided = later.undecided;
  mixed |= later.mixed;
  unique &= later.unique;
  canonical &= later.canonical;
  up += later.up;
  down += later.down;
  stages = sum(stages, later.stages);
}

template <std::size_t kDimension, typename Index, typename Link>
Swept sweep(const SweepTask<kDimension, Index, Link>& task, std::size_t first, std::size_t last) {
  return task.weighted ? swept_in_blocks<true>(task, first, last)
                       : swept_in_blocks<false>(task, first, last);
}

template Swept sweep(const SweepTask<2, std::int32_t, std::int32_t>&, std::size_t, std::size_t);
template Swept sweep(const SweepTask<2, std::int64_t, std::int64_t>&, std::size_t, std::size_t);
template Swept sweep(const SweepTask<2, std::int64_t, std::int32_t>&, std::size_t, std::size_t);
template Swept sweep(const SweepTask<3, std::int32_t, std::int32_t>&, std::size_t, std::size_t);
template Swept sweep(const SweepTask<3, std::int64_t, std::int64_t>&, std::size_t, std::size_t);
template Swept sweep(const SweepTask<3, std::int64_t, std::int32_t>&, std::size_t, std::size_t);

}  // namespace circumspect::fast
