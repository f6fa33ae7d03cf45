#include "oracle/distributed/local_mesh.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <memory>
#include <numeric>

#include "oracle/judge/fast/facet_records.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace circumspect::distributed {

// Some of many points, numbered in their order. It takes memory only for pages of the list that
// contain one of them.
class PointNumbers {
 public:
  explicit PointNumbers(std::uint64_t points) : pages_(points / kPage + 1) {}

  void mark(std::uint64_t v) {
    std::unique_ptr<Page>& page = pages_[v / kPage];
    if (page == nullptr) page = std::make_unique<Page>();
    page->words[v % kPage / 64] |= std::uint64_t{1} << (v % 64);
  }

  // Numbers the marked points; returns how many there are.
  std::size_t number() {
    std::size_t count = 0;
    for (const std::unique_ptr<Page>& page : pages_) {
      if (page == nullptr) continue;
      for (std::size_t i = 0; i < kWords; ++i) {
        page->before[i] = static_cast<std::int32_t>(count);
        count += static_cast<std::size_t>(std::popcount(page->words[i]));
      }
    }
    count_ = count;
    return count;
  }

  // The marked points, ascending. Requires: they have numbers.
  std::pmr::vector<std::uint64_t> numbered() const {
    std::pmr::vector<std::uint64_t> marked;
    marked.reserve(count_);
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
  std::size_t count_ = 0;
};

namespace {

// How many simplices are read at a time.
constexpr std::size_t kSomeRows = std::size_t{1} << 13;

// Spreads the lowest bits of a number, 31 in the plane and 20 in space, so that the bits of the
// other axes fit between.
template <std::size_t kDimension>
std::uint64_t spread(std::uint64_t bits) {
  if constexpr (kDimension == 2) {
    bits = (bits | bits << 16) & 0x0000ffff0000ffffU;
    bits = (bits | bits << 8) & 0x00ff00ff00ff00ffU;
    bits = (bits | bits << 4) & 0x0f0f0f0f0f0f0f0fU;
    bits = (bits | bits << 2) & 0x3333333333333333U;
    return (bits | bits << 1) & 0x5555555555555555U;
  } else {
    bits = (bits | bits << 32) & 0x001f00000000ffffU;
    bits = (bits | bits << 16) & 0x001f0000ff0000ffU;
    bits = (bits | bits << 8) & 0x100f00f00f00f00fU;
    bits = (bits | bits << 4) & 0x10c30c30c30c30c3U;
    return (bits | bits << 2) & 0x1249249249249249U;
  }
}

}  // namespace

template <std::size_t kDimension>
LocalMesh<kDimension>::LocalMesh(Ranks& ranks, Dealt dealt, bool weighted)
    : dealt_(std::move(dealt)),
      weighted_(weighted),
      ranks_(ranks.size()),
      slice_(PartOf{ranks.rank(), ranks.size()}.slice(dealt_.points)),
      used_(slice_.size(), false) {
  const auto marked = [&] {
    auto numbers = std::make_unique<PointNumbers>(dealt_.points);
    dealt_.lists.for_some(kSomeRows, [&](std::uint64_t, std::span<const std::int64_t> values) {
      for (const std::int64_t listed : values) {
        const std::int64_t v = place_of(listed);
        if (names_point(v)) numbers->mark(static_cast<std::uint64_t>(v));
      }
    });
    return numbers;
  };
  auto numbers = marked();
  // Points that several ranks name; there are few if each rank has its own part of space.
  std::uint64_t named = numbers->number();
  if (ranks.share_memory()) numbers = nullptr;
  named = ranks.sum(named);
  if (ranks.size() > 1 && named > dealt_.points + dealt_.points / 4) {
    numbers = nullptr;
    deal_by_place(ranks);
    ranks.end_phase("dealing by place");
  }
  if (numbers == nullptr) {
    numbers = marked();
    numbers->number();
  }
  number_points(*numbers);
  dealt_.lists = {};
  numbers = nullptr;
  ranks.end_phase("numbering points");
  fetch_points(ranks);
  ranks.end_phase("fetching points");
}

template <std::size_t kDimension>
void LocalMesh<kDimension>::number_points(const PointNumbers& numbers) {
  global_of_ = numbers.numbered();
  simplices_.reserve(dealt_.lists.size() * kVertices);
  dealt_.lists.for_some(kSomeRows, [&](std::uint64_t, std::span<const std::int64_t> values) {
    for (const std::int64_t listed : values) {
      const std::int64_t v = place_of(listed);
      const bool known = names_point(v);
      if (!known) unknown_.emplace_back(simplices_.size(), v);
      simplices_.push_back(known ? numbers.of(static_cast<std::uint64_t>(v)) : -1);
    }
  });
}

// Along Morton's curve of first vertices. Any dealing is right; no sign depends on where it cuts.

template <std::size_t kDimension>
typename LocalMesh<kDimension>::SiteBox LocalMesh<kDimension>::box_of_all(Ranks& ranks) const {
  SiteBox box;
  box.low.fill(std::numeric_limits<double>::max());
  box.high.fill(std::numeric_limits<double>::lowest());
  for (std::size_t i = 0; i < dealt_.coordinates.size(); ++i) {
    const double x = dealt_.coordinates[i];
    box.low[i % kDimension] = std::min(box.low[i % kDimension], x);
    box.high[i % kDimension] = std::max(box.high[i % kDimension], x);
  }
  for (const SiteBox& other : ranks.of_each(box)) {
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      box.low[axis] = std::min(box.low[axis], other.low[axis]);
      box.high[axis] = std::max(box.high[axis], other.high[axis]);
    }
  }
  return box;
}

// The places of points on the curve, which their owners compute. Called by all ranks.
template <std::size_t kDimension>
std::vector<std::uint64_t> LocalMesh<kDimension>::curve_places(
    Ranks& ranks, std::span<const std::uint64_t> points, const SiteBox& box) const {
  constexpr double kCells = kDimension == 2 ? 0x1p31 : 0x1p20;
  std::vector<std::vector<std::uint64_t>> asked(ranks.size());
  for (auto& some : asked) some.reserve(points.size() / ranks.size() * 9 / 8 + 8);
  for (const std::uint64_t v : points) asked[owner_of(v)].push_back(v);
  std::vector<std::uint64_t> from;
  const std::vector<std::uint64_t> wanted = ranks.exchanged(std::move(asked), &from);
  std::vector<std::vector<std::uint64_t>> answers(ranks.size());
  std::size_t i = 0;
  for (std::size_t rank = 0; rank < ranks.size(); ++rank) {
    answers[rank].reserve(from[rank]);
    for (const std::size_t end = i + from[rank]; i < end; ++i) {
      std::uint64_t key = 0;
      for (std::size_t axis = 0; axis < kDimension; ++axis) {
        // Halved first, so that no difference of doubles overflows.
        const double x = dealt_.coordinates[(wanted[i] - slice_.begin) * kDimension + axis];
        const double width = box.high[axis] / 2 - box.low[axis] / 2;
        const double part = width > 0 ? (x / 2 - box.low[axis] / 2) / width : 0;
        key |= spread<kDimension>(static_cast<std::uint64_t>(part * (kCells - 1))) << axis;
      }
      answers[rank].push_back(key);
    }
  }
  std::vector<std::uint64_t> counts;
  const std::vector<std::uint64_t> got = ranks.exchanged(std::move(answers), &counts);
  std::vector<std::uint64_t> next(ranks.size());
  std::exclusive_scan(counts.begin(), counts.end(), next.begin(), std::uint64_t{0});
  std::vector<std::uint64_t> places;
  places.reserve(points.size());
  for (const std::uint64_t v : points) places.push_back(got[next[owner_of(v)]++]);
  return places;
}

// Appends so many of its own simplices.
template <std::size_t kDimension>
void LocalMesh<kDimension>::append_moved(std::uint64_t first, std::size_t count,
                                         std::vector<Moved>& some) const {
  std::vector<std::int64_t> values(count * kVertices);
  if (count > 0) dealt_.lists.read(first, values);
  for (std::size_t i = 0; i < count; ++i) {
    Moved& moved = some.emplace_back();
    std::copy_n(values.data() + i * kVertices, kVertices, moved.row.begin());
    moved.place = place(static_cast<std::size_t>(first + i));
  }
}

template <std::size_t kDimension>
std::vector<typename LocalMesh<kDimension>::CurvePlace> LocalMesh<kDimension>::places_of(
    Ranks& ranks, const std::vector<Moved>& some, const SiteBox& box) const {
  std::vector<std::uint64_t> firsts;
  firsts.reserve(some.size());
  for (const Moved& moved : some) {
    const auto known = std::find_if(moved.row.begin(), moved.row.end(),
                                    [&](std::int64_t v) { return names_point(place_of(v)); });
    firsts.push_back(known == moved.row.end() ? 0 : static_cast<std::uint64_t>(place_of(*known)));
  }
  const std::vector<std::uint64_t> of_vertices = curve_places(ranks, firsts, box);
  std::vector<CurvePlace> places;
  places.reserve(some.size());
  for (std::size_t i = 0; i < some.size(); ++i) {
    places.push_back({of_vertices[i], fast::mixed_vertex(some[i].place)});
  }
  return places;
}

// Where all parts but the first begin: a sample determines it.
template <std::size_t kDimension>
std::vector<typename LocalMesh<kDimension>::CurvePlace> LocalMesh<kDimension>::beginnings(
    Ranks& ranks, const SiteBox& box) const {
  constexpr std::size_t kUsual = 512;
  const std::uint64_t own = dealt_.lists.size();
  const std::uint64_t wanted = std::min<std::uint64_t>(
      {own, 2 * kUsual, (own * ranks.size() * kUsual + dealt_.simplices - 1) / dealt_.simplices});
  std::vector<Moved> some;
  for (std::uint64_t i = 0; i < wanted; ++i) {
    append_moved(own / wanted * i + own % wanted * i / wanted, 1, some);
  }
  std::vector<CurvePlace> sampled = ranks.at_first(places_of(ranks, some, box));
  std::sort(sampled.begin(), sampled.end());
  std::vector<CurvePlace> begins;
  for (std::size_t part = 1; ranks.is_first() && part < ranks.size(); ++part) {
    begins.push_back(sampled[sampled.size() * part / ranks.size()]);
  }
  return ranks.of_rank(0, std::move(begins));
}

template <std::size_t kDimension>
void LocalMesh<kDimension>::deal_by_place(Ranks& ranks) {
  const std::uint64_t own = dealt_.lists.size();
  const SiteBox box = box_of_all(ranks);
  const std::vector<CurvePlace> begins = beginnings(ranks, box);
  // Rows and places of the simplices that come to this rank.
  auto rows = std::make_shared<std::pmr::vector<std::int64_t>>();
  std::pmr::vector<std::uint64_t> places;
  const auto expected = static_cast<std::size_t>(dealt_.simplices / ranks.size() * 9 / 8 + 64);
  rows->reserve(expected * kVertices);
  places.reserve(expected);
  const std::size_t at_a_time = std::min<std::size_t>(
      ranks.some(4 * sizeof(Moved) + 4 * sizeof(CurvePlace)), expected / 16 + 1);
  const std::uint64_t rounds = ranks.most((own + at_a_time - 1) / at_a_time);
  std::vector<Moved> some;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    const std::uint64_t first = std::min(own, round * at_a_time);
    some.clear();
    append_moved(first, static_cast<std::size_t>(std::min<std::uint64_t>(at_a_time, own - first)),
                 some);
    const std::vector<CurvePlace> keys = places_of(ranks, some, box);
    std::vector<std::vector<Moved>> out(ranks.size());
    for (auto& moved : out) moved.reserve(some.size() / ranks.size() * 9 / 8 + 8);
    for (std::size_t i = 0; i < some.size(); ++i) {
      const auto part = std::upper_bound(begins.begin(), begins.end(), keys[i]) - begins.begin();
      out[static_cast<std::size_t>(part)].push_back(some[i]);
    }
    for (const Moved& moved : ranks.exchanged(std::move(out))) {
      for (const std::int64_t v : moved.row) rows->push_back(v);
      places.push_back(moved.place);
    }
  }
  dealt_.places = std::move(places);
  dealt_.lists = ListedRows(dealt_.places.size(), kVertices,
                            [rows](std::uint64_t first, std::span<std::int64_t> to) {
                              std::copy_n(rows->data() + first * kVertices, to.size(), to.data());
                            });
}

template <std::size_t kDimension>
void LocalMesh<kDimension>::append_owned(std::uint64_t point, std::vector<double>& numbers) {
  const auto i = static_cast<std::size_t>(point - slice_.begin);
  used_[i] = true;
  const double* const at = dealt_.coordinates.data() + i * kDimension;
  numbers.insert(numbers.end(), at, at + kDimension);
  if (weighted_) numbers.push_back(dealt_.weights[i]);
}

// Asks each owner for points in batches.
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
    const auto number_from = [&](std::uint64_t v) {
      return static_cast<std::size_t>(std::lower_bound(global_of_.begin(), global_of_.end(), v) -
                                      global_of_.begin());
    };
    next[owner] = number_from(begin);
    last[owner] = number_from(end);
    if (owner != ranks.rank()) most = std::max<std::uint64_t>(most, last[owner] - next[owner]);
  }
  std::vector<double> numbers;
  for (std::size_t v = next[ranks.rank()]; v < last[ranks.rank()]; ++v) {
    numbers.clear();
    append_owned(global_of_[v], numbers);
    take(v, numbers.data());
  }
  next[ranks.rank()] = last[ranks.rank()];
  const std::size_t width = kDimension + (weighted_ ? 1 : 0);
  const std::size_t some =
      std::max<std::size_t>(1, ranks.some(2 * (width + 1) * sizeof(double)) / ranks.size());
  for (std::uint64_t rounds = ranks.most((most + some - 1) / some); rounds > 0; --rounds) {
    std::vector<std::vector<std::uint64_t>> asked(ranks.size());
    for (std::size_t owner = 0; owner < ranks.size(); ++owner) {
      const std::size_t end = std::min(last[owner], next[owner] + some);
      asked[owner].assign(global_of_.data() + next[owner], global_of_.data() + end);
    }
    std::vector<std::uint64_t> from;
    const std::vector<std::uint64_t> wanted = ranks.exchanged(std::move(asked), &from);
    std::vector<std::vector<double>> answers(ranks.size());
    std::size_t i = 0;
    for (std::size_t rank = 0; rank < ranks.size(); ++rank) {
      const auto end = i + from[rank];
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
  std::copy_n(dealt_.coordinates.data() + i * kDimension, kDimension, point.site.at.begin());
  if (weighted_) point.site.weight = dealt_.weights[i];
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
