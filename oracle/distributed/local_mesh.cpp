#include "oracle/distributed/local_mesh.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <memory>
#include <type_traits>

#include "oracle/model/exact_mesh.hpp"

namespace circumspect::distributed {

namespace {

// Some of many points, numbered in their order. Memory for those pages of the list alone that have one of them.
class PointNumbers {
 public:
  explicit PointNumbers(std::uint64_t points) : pages_(points / kPage + 1) {}

  void mark(std::uint64_t v) {
    std::unique_ptr<Page>& page = pages_[v / kPage];
    if (page == nullptr) page = std::make_unique<Page>();
    page->words[v % kPage / 64] |= std::uint64_t{1} << (v % 64);
  }

  // Those that are marked, ascending; from now on they have numbers.
  std::vector<std::uint64_t> numbered() {
    std::size_t count = 0;
    for (const std::unique_ptr<Page>& page : pages_) {
      if (page == nullptr) continue;
      for (std::size_t i = 0; i < kWords; ++i) {
        page->before[i] = static_cast<std::int32_t>(count);
        count += static_cast<std::size_t>(std::popcount(page->words[i]));
      }
    }
    std::vector<std::uint64_t> marked;
    marked.reserve(count);
    for (std::size_t p = 0; p < pages_.size(); ++p) {
      if (pages_[p] == nullptr) continue;
      for (std::size_t i = 0; i < kWords; ++i) {
        for (std::uint64_t bits = pages_[p]->words[i]; bits != 0; bits &= bits - 1) {
          marked.push_back(p * kPage + i * 64 + static_cast<std::size_t>(std::countr_zero(bits)));
        }
      }
    }
    return marked;
  }

  // Requires: v is marked, and all have numbers.
  std::int32_t of(std::uint64_t v) const {
    const Page& page = *pages_[v / kPage];
    const std::size_t i = v % kPage / 64;
    const std::uint64_t below = (std::uint64_t{1} << (v % 64)) - 1;
    return page.before[i] + std::popcount(page.words[i] & below);
  }

 private:
  static constexpr std::size_t kWords = 64, kPage = 64 * kWords;
  struct Page {
    std::array<std::uint64_t, kWords> words = {};
    std::array<std::int32_t, kWords> before = {};
  };
  std::vector<std::unique_ptr<Page>> pages_;
};

}  // namespace

template <std::size_t kDimension>
LocalMesh<kDimension>::LocalMesh(Ranks& ranks, Dealt dealt, bool weighted)
    : dealt_(std::move(dealt)),
      weighted_(weighted),
      ranks_(ranks.size()),
      slice_(PartOf{ranks.rank(), ranks.size()}.slice(dealt_.points)),
      used_(slice_.size(), false) {
  number_points(dealt_.lists);
  dealt_.lists = {};
  ranks.end_phase("numbering points");
  fetch_points(ranks);
  ranks.end_phase("fetching points");
}

template <std::size_t kDimension>
void LocalMesh<kDimension>::number_points(const IndexLists& lists) {
  lists.visit([&]<class Lists>(const Lists& rows) {
    if constexpr (!std::is_same_v<Lists, std::vector<Simplex>>) {
      PointNumbers numbers(dealt_.points);
      const auto names_point = [&](std::int64_t v) {
        return static_cast<std::uint64_t>(v) < dealt_.points;
      };
      const auto values = rows.values();
      for (const std::int64_t listed : values) {
        const std::int64_t v = place_of_index(listed, dealt_.first_index);
        if (names_point(v)) numbers.mark(static_cast<std::uint64_t>(v));
      }
      global_of_ = numbers.numbered();
      simplices_.resize(values.size());
      for (std::size_t i = 0; i < values.size(); ++i) {
        const std::int64_t v = place_of_index(values[i], dealt_.first_index);
        const bool known = names_point(v);
        simplices_[i] = known ? numbers.of(static_cast<std::uint64_t>(v)) : -1;
        if (!known) unknown_.emplace_back(i, v);
      }
    }
  });
}

template <std::size_t kDimension>
void LocalMesh<kDimension>::append_owned(std::uint64_t point, std::vector<double>& numbers) {
  const auto i = static_cast<std::size_t>(point - slice_.begin);
  used_[i] = true;
  const auto row = std::as_const(dealt_.coordinates).row(i);
  numbers.insert(numbers.end(), row.begin(), row.end());
  if (weighted_) numbers.push_back(std::as_const(dealt_.weights).row(i)[0]);
}

// Some points at a time from each owner.
template <std::size_t kDimension>
void LocalMesh<kDimension>::fetch_points(Ranks& ranks) {
  coordinates_.resize(global_of_.size() * kDimension);
  if (weighted_) weights_.resize(global_of_.size());
  const auto take = [&](std::size_t v, const double* numbers) {
    std::copy_n(numbers, kDimension, &coordinates_[v * kDimension]);
    if (weighted_) weights_[v] = numbers[kDimension];
  };
  std::vector<std::size_t> next(ranks.size()), last(ranks.size());
  std::uint64_t most = 0;
  for (std::size_t owner = 0; owner < ranks.size(); ++owner) {
    const auto [begin, end] = PartOf{owner, ranks.size()}.slice(dealt_.points);
    const auto place_of = [&](std::uint64_t v) {
      return static_cast<std::size_t>(std::lower_bound(global_of_.begin(), global_of_.end(), v) -
                                      global_of_.begin());
    };
    next[owner] = place_of(begin);
    last[owner] = place_of(end);
    if (owner != ranks.rank()) most = std::max<std::uint64_t>(most, last[owner] - next[owner]);
  }
  std::vector<double> numbers;
  for (std::size_t v = next[ranks.rank()]; v < last[ranks.rank()]; ++v) {
    numbers.clear();
    append_owned(global_of_[v], numbers);
    take(v, numbers.data());
  }
  next[ranks.rank()] = last[ranks.rank()];
  const std::size_t some = std::max<std::size_t>(1, 4 * ranks.few() / ranks.size());
  const std::size_t width = kDimension + (weighted_ ? 1 : 0);
  for (std::uint64_t rounds = ranks.most((most + some - 1) / some); rounds > 0; --rounds) {
    std::vector<std::vector<std::uint64_t>> asked(ranks.size());
    for (std::size_t owner = 0; owner < ranks.size(); ++owner) {
      const std::size_t end = std::min(last[owner], next[owner] + some);
      asked[owner].assign(global_of_.data() + next[owner], global_of_.data() + end);
    }
    std::vector<int> from;
    const std::vector<std::uint64_t> wanted = ranks.exchanged(std::move(asked), &from);
    std::vector<std::vector<double>> answers(ranks.size());
    std::size_t i = 0;
    for (std::size_t rank = 0; rank < ranks.size(); ++rank) {
      const auto end = i + static_cast<std::size_t>(from[rank]);
      answers[rank].reserve((end - i) * width);
      for (; i < end; ++i) append_owned(wanted[i], answers[rank]);
    }
    const std::vector<double> got = ranks.exchanged(std::move(answers));
    const double* at = got.data();
    for (std::size_t owner = 0; owner < ranks.size(); ++owner) {
      const std::size_t end = std::min(last[owner], next[owner] + some);
      for (; next[owner] < end; ++next[owner], at += width) take(next[owner], at);
    }
  }
}

template <std::size_t kDimension>
std::int64_t LocalMesh<kDimension>::vertex(std::size_t s, std::size_t place) const {
  const std::size_t at = s * kVertices + place;
  if (simplices_[at] >= 0) return global(simplices_[at]);
  return std::lower_bound(unknown_.begin(), unknown_.end(),
                          std::pair{at, std::numeric_limits<std::int64_t>::min()})
      ->second;
}

template <std::size_t kDimension>
NumberedPoint<kDimension> LocalMesh<kDimension>::owned_point(std::size_t i) const {
  NumberedPoint<kDimension> point{slice_.begin + i};
  std::copy_n(dealt_.coordinates.row(i).begin(), kDimension, point.site.at.begin());
  if (weighted_) point.site.weight = dealt_.weights.row(i)[0];
  return point;
}

template <std::size_t kDimension>
std::vector<std::size_t> LocalMesh<kDimension>::unused() const {
  std::vector<std::size_t> unused;
  for (std::size_t i = 0; i < used_.size(); ++i) {
    if (!used_[i]) unused.push_back(i);
  }
  return unused;
}

template class LocalMesh<2>;
template class LocalMesh<3>;

}  // namespace circumspect::distributed
