#include "oracle/judge/fast/sweep.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "oracle/judge/fast/block.hpp"
#include "oracle/judge/fast/facet_records.hpp"
#include "oracle/judge/fast/predicates/exact_ball.hpp"
#include "oracle/judge/fast/predicates/predicates.hpp"

namespace circumspect::fast {
namespace {

void prefetch(const void* from, std::size_t bytes) {
  const char* const begin = static_cast<const char*>(from);
  __builtin_prefetch(begin);
  if (bytes > sizeof(double)) __builtin_prefetch(begin + bytes - 1);
}

template <std::size_t kDimension, bool kWeighted, typename Index, typename Link>
class BlockSweep {
 public:
  BlockSweep(const SweepTask<kDimension, Index, Link>& task, Swept& swept)
      : task_(task),
        mesh_(task.mesh),
        swept_(swept),
        kernels_(task.kernels != nullptr ? *task.kernels : block_kernels<kDimension>().front()) {
    block_.low.fill(std::numeric_limits<double>::infinity());  // apart from every box
    block_.high = block_.low;
    if (task.sample != nullptr) {
      block_.low = task.sample->low.at;
      block_.high = task.sample->high.at;
    }
  }

  // Rows are read, and what they name is prefetched, a block ahead.
  void run(std::size_t first, std::size_t last) {
    read(rows_[0], first, last);
    for (std::size_t turn = 0; swept_.goes_on(); ++turn) {
      Rows& now = rows_[turn % 2];
      const std::size_t next = now.first + kBlock;
      if (next < last) read(rows_[(turn + 1) % 2], next, last);
      is_doubtful_ = false;
      if (goes_on()) look_across(now);
      if (goes_on()) look_at_simplices(now);
      if (goes_on() && task_.balls) look_at_balls(now);
      if (is_doubtful_) swept_.doubtful.push_back(now.first);
      if (next >= last) return;
    }
  }

 private:
  static constexpr std::size_t kVertices = kDimension + 1;

  // A facet of one of the simplices, with what is across it.
  struct Facet {
    std::uint32_t lane;   // of the simplex in the block
    std::uint32_t place;  // of its apex
    std::size_t beyond;   // the simplex across
  };

  // Consecutive simplices, and their facets that are shared with later ones.
  struct Rows {
    std::size_t first = 0;
    std::size_t count = 0;
    RowBlock<kVertices, Index> lanes;
    std::array<Facet, kBlock * kVertices + 1> facets;  // one more, which is written but not kept
    std::size_t facet_count = 0;

    std::span<const Facet> looked_at() const { return std::span(facets).first(facet_count); }
  };

  // Neither of these is called in a mesh that holds: they are kept apart from the hot path.
  [[gnu::cold, gnu::noinline]] void give_up(Undecided reason) {
    if (!swept_.undecided) swept_.undecided = reason;
  }

  // Of the current block.
  [[gnu::cold, gnu::noinline]] void doubt(Undecided reason) {
    if (!task_.past_doubts) return give_up(reason);
    if (!swept_.doubt) swept_.doubt = reason;
    is_doubtful_ = true;
  }
  bool goes_on() const { return swept_.goes_on() && !is_doubtful_; }

  void prefetch_site(Index v) const {
    const auto place = static_cast<std::size_t>(v);
    prefetch(mesh_.coordinates.data() + place * kDimension, kDimension * sizeof(double));
    if constexpr (kWeighted) prefetch(mesh_.weights.data() + place, sizeof(double));
  }

  // The indices are valid, and what they name has been prefetched.
  void read(Rows& rows, std::size_t first, std::size_t last) {
    rows.first = first;
    rows.count = std::min(kBlock, last - first);
    bool names_points = true;
    for (std::size_t lane = 0; lane < rows.count; ++lane) {
      const auto row = mesh_.row(first + lane);
      for (std::size_t i = 0; i < kVertices; ++i) {
        rows.lanes.rows[i][lane] = row[i];
        names_points &= mesh_.names_point(row[i]);
      }
    }
    if (!names_points) return give_up(Undecided::kUnknownVertex);
    for (std::size_t lane = 0; lane < rows.count; ++lane) {
      for (const Index v : mesh_.row(first + lane)) {
        prefetch_site(v);
        task_.used.mark(static_cast<std::size_t>(v));
      }
    }
    list_facets(rows);
  }

  void list_facets(Rows& rows) {
    const auto size = static_cast<std::int64_t>(mesh_.size());
    bool leads_somewhere = true;
    std::uint32_t boundary = 0;
    std::size_t shared = 0;
    rows.facet_count = 0;
    for (std::size_t lane = 0; lane < rows.count; ++lane) {
      const std::size_t s = rows.first + lane;
      const Link* const links = task_.links.data() + s * kVertices;
      for (std::size_t place = 0; place < kVertices; ++place) {
        const auto beyond = static_cast<std::int64_t>(links[place]);
        leads_somewhere &= (beyond >= -1) & (beyond < size);
        boundary |= static_cast<std::uint32_t>(beyond < 0) << lane;
        shared += static_cast<std::size_t>(beyond >= 0);
        // A branch on which of the two comes first would be unpredictable.
        rows.facets[rows.facet_count] = {static_cast<std::uint32_t>(lane),
                                         static_cast<std::uint32_t>(place),
                                         static_cast<std::size_t>(beyond)};
        rows.facet_count += static_cast<std::size_t>(beyond > static_cast<std::int64_t>(s));
      }
    }
    if (!leads_somewhere) return give_up(Undecided::kUnmatchedNeighbor);
    swept_.up += rows.facet_count;
    swept_.down += shared - rows.facet_count;
    task_.boundary.set(rows.first / kBlock, boundary);
    for (const Facet& facet : rows.looked_at()) {
      __builtin_prefetch(mesh_.simplices.data() + facet.beyond * kVertices);
      __builtin_prefetch(task_.links.data() + facet.beyond * kVertices);
    }
  }

  // The simplices across share the facet, are linked back, and lie on its other side.
  void look_across(Rows& rows) {
    auto& lanes = rows.lanes;
    for (const Facet& facet : rows.looked_at()) {
      const auto row = mesh_.row(facet.beyond);
      for (std::size_t i = 0; i < kVertices; ++i) {
        lanes.beyond[facet.place][i][facet.lane] = row[i];
      }
    }
    kernels_.fit(lanes);
    for (const Facet& facet : rows.looked_at()) {
      const Index fit = lanes.fits[facet.place][facet.lane];
      if (fit < 0) return doubt(Undecided::kUnmatchedNeighbor);
      constexpr Index kOdd = RowBlock<kVertices, Index>::kOdd;
      const auto place = static_cast<std::size_t>(fit % kOdd);
      const std::size_t s = rows.first + facet.lane;
      const Link back = task_.links[facet.beyond * kVertices + place];
      if (static_cast<std::int64_t>(back) != static_cast<std::int64_t>(s)) {
        return doubt(Undecided::kUnmatchedNeighbor);
      }
      const int product = task_.orientations.are_equal()
                              ? 1
                              : task_.orientations.of(s) * task_.orientations.of(facet.beyond);
      if ((product > 0) != (fit >= kOdd)) {
        // Unless just one of the two is oriented as expected.
        if (!task_.orientations.are_equal()) return doubt(Undecided::kSameSide);
        swept_.mixed = true;
        return;
      }
      const Index apex = lanes.apex[facet.place][facet.lane];
      if (!mesh_.names_point(apex)) return give_up(Undecided::kUnknownVertex);
      prefetch_site(apex);
    }
  }

  [[gnu::always_inline]] void load(SiteLanes<kDimension>& sites, std::size_t lane, Index v) const {
    const double* const at = mesh_.coordinates.data() + static_cast<std::size_t>(v) * kDimension;
    for (std::size_t axis = 0; axis < kDimension; ++axis) sites.at[axis][lane] = at[axis];
    if constexpr (kWeighted) sites.weight[lane] = mesh_.weights[static_cast<std::size_t>(v)];
  }

  void look_at_simplices(const Rows& rows) {
    for (std::size_t lane = 0; lane < rows.count; ++lane) {
      for (std::size_t i = 0; i < kVertices; ++i) {
        load(block_.vertices[i], lane, rows.lanes.rows[i][lane]);
      }
      block_.own[lane] = task_.orientations.of(rows.first + lane);
    }
    kernels_.simplices(block_, kWeighted, task_.lattice);
    if (block_.as_expected) {
      swept_.stages.filtered += rows.count;
      return;
    }
    for (std::size_t lane = 0; lane < rows.count && goes_on(); ++lane) {
      look_at_simplex(lane, rows.first + lane);
    }
  }

  void look_at_simplex(std::size_t lane, std::size_t s) {
    auto own = static_cast<int>(block_.orientation[lane]);
    if (own == kUncertain) {
      own = exact_orientation(block_.row(lane), swept_.stages);
    } else {
      ++swept_.stages.filtered;
    }
    if (own != block_.own[lane]) {
      if (own == 0) return doubt(Undecided::kFlatSimplex);
      swept_.mixed = true;
      return;
    }
    if (block_.apart[lane] == 0 && s != task_.sample->simplex &&
        covers<kDimension>(block_.row(lane), own, *task_.sample, swept_.stages)) {
      doubt(Undecided::kCoveredTwice);
    }
  }

  void look_at_balls(const Rows& rows) {
    for (const Facet& facet : rows.looked_at()) {
      load(block_.apexes[facet.place], facet.lane, rows.lanes.apex[facet.place][facet.lane]);
    }
    kernels_.balls(block_, kWeighted, task_.lattice);
    std::optional<ExactBall<kDimension>> ball;
    std::size_t lane_of_ball = kBlock;
    for (const Facet& facet : rows.looked_at()) {
      const auto own = static_cast<int>(block_.own[facet.lane]);
      auto side = static_cast<int>(block_.inside[facet.place][facet.lane]);
      if (side == kUncertain) {
        const Site<kDimension> apex = block_.apexes[facet.place].site(facet.lane);
        if constexpr (kWeighted) {
          side = exact_ball_sign(block_.row(facet.lane), apex, true, swept_.stages);
        } else {
          if (facet.lane != lane_of_ball) ball.emplace(block_.row(facet.lane));
          lane_of_ball = facet.lane;
          side = ball->contains(apex, swept_.stages);
        }
      } else {
        ++swept_.stages.filtered;
      }
      side *= own;
      if (side < 0) continue;
      const FacetId name(rows.first + facet.lane, facet.place);
      if (side > 0) {
        swept_.not_local.push_back(name);
      } else {
        look_at_tie(facet, name, own);
      }
    }
  }

  void look_at_tie(const Facet& facet, FacetId name, int own) {
    swept_.unique = false;
    if (task_.ties) swept_.ties.push_back(name);
    if (!swept_.canonical && !task_.ties) return;
    const Site<kDimension> apex = block_.apexes[facet.place].site(facet.lane);
    if (perturbed_sign_of_zero<kDimension>(block_.row(facet.lane), own, apex, swept_.stages,
                                           task_.lattice, facet.place) < 0) {
      return;
    }
    swept_.canonical = false;
    if (task_.ties) swept_.not_canonical.push_back(name);
  }

  const SweepTask<kDimension, Index, Link>& task_;
  const MeshView<kDimension, Index>& mesh_;
  Swept& swept_;
  const BlockKernels<kDimension>& kernels_;
  std::array<Rows, 2> rows_;
  bool is_doubtful_ = false;
  SimplexBlock<kDimension> block_;
};

template <bool kWeighted, std::size_t kDimension, typename Index, typename Link>
Swept swept_in_blocks(const SweepTask<kDimension, Index, Link>& task, std::size_t first,
                      std::size_t last) {
  Swept swept;
  BlockSweep<kDimension, kWeighted, Index, Link> blocks(task, swept);
  blocks.run(first, last);
  return swept;
}

}  // namespace

void Swept::append(const Swept& later) {
  if (!undecided) undecided = later.undecided;
  mixed |= later.mixed;
  if (!doubt) doubt = later.doubt;
  doubtful.insert(doubtful.end(), later.doubtful.begin(), later.doubtful.end());
  unique &= later.unique;
  canonical &= later.canonical;
  up += later.up;
  down += later.down;
  stages = sum(stages, later.stages);
  const auto append_to = [](std::vector<FacetId>& facets, const auto& more) {
    facets.insert(facets.end(), more.begin(), more.end());
  };
  append_to(not_local, later.not_local);
  append_to(ties, later.ties);
  append_to(not_canonical, later.not_canonical);
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
