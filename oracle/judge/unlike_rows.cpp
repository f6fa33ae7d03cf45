#include "oracle/judge/unlike_rows.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <type_traits>

#include "kernel/complex/vertex_sets.hpp"
#include "kernel/exact/interruption.hpp"
#include "oracle/judge/counted_sets.hpp"

namespace circumspect::check {
namespace {

// The rows of a mesh as sets of points of one of the two; a vertex that is none of these is
// negative.
template <std::size_t kSize, class List, class Image>
class RowSets {
 public:
  using Set = typename CountedSets<kSize>::Set;

  RowSets(const List& rows, const Image& image) : rows_(rows), image_(image) {}

  std::size_t size() const { return rows_.rows(); }
  Set operator[](std::size_t i) const {
    Set set;
    const auto row = rows_.row(i);
    for (std::size_t k = 0; k < kSize; ++k) set[k] = image_(static_cast<Vertex>(row[k]));
    return set;
  }

 private:
  const List& rows_;
  const Image& image_;
};

template <class Set>
bool is_whole(const Set& set) {
  std::int32_t signs = 0;
  for (const std::int32_t v : set) signs |= v;
  return signs >= 0;
}

// Do they have the same vertices, in any order?
template <class Set>
bool are_alike(Set a, Set b) {
  if (a == b) return true;
  const auto sum = [](const Set& set) { return std::reduce(set.begin(), set.end(), Vertex{0}); };
  if (sum(a) != sum(b)) return false;
  sort_vertices(a);
  sort_vertices(b);
  return a == b;
}

// Rows that both meshes list in the same place: all of them, but where they are few.
template <class SetsOfA, class SetsOfB>
std::vector<bool> rows_alike(const SetsOfA& a, const SetsOfB& b) {
  constexpr std::size_t kSome = 4096;
  std::vector<bool> alike(std::max(a.size(), b.size()), false);
  std::size_t found = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (i % kSome == 0 && found < i / 4) break;  // looking up is faster
    const auto of_a = a[i];
    alike[i] = is_whole(of_a) && are_alike(of_a, b[i]);
    found += alike[i] ? 1 : 0;
  }
  return alike;
}

// Calls visit(place, counted, set) for the other rows; calls apart(place) for those that name no
// point of the mesh. Sets are looked up some at a time, so that the memory is asked for them all
// before the first is needed.
template <std::size_t kSize, class Sets, class Visit, class Apart>
void for_each_counted(CountedSets<kSize>& counts, const Sets& sets, const std::vector<bool>& alike,
                      const Visit& visit, const Apart& apart) {
  struct Sought {
    typename Sets::Set set;
    std::size_t place;
    std::size_t home;
  };
  std::array<Sought, 64> some;
  std::size_t size = 0;
  const auto look_up = [&] {
    end_if_interrupted();
    for (std::size_t k = 0; k < size; ++k) {
      visit(some[k].place, counts.at(some[k].set, some[k].home), some[k].set);
    }
    size = 0;
  };
  for (std::size_t i = 0; i < sets.size() && !counts.is_crowded(); ++i) {
    if (alike[i]) continue;
    auto set = sets[i];
    if (!is_whole(set)) {
      apart(i);
      continue;
    }
    sort_vertices(set);
    const std::size_t home = counts.home(set);
    counts.prefetch(home);
    some[size++] = {set, i, home};
    if (size == some.size()) look_up();
  }
  look_up();
}

// Those of the other rows that the other mesh lists more or less often; none if hashes collide too
// often.
template <std::size_t kSize, class SetsOfA, class SetsOfB>
std::optional<UnlikeRows> compare(const SetsOfA& a, const SetsOfB& b,
                                  const std::vector<bool>& alike) {
  UnlikeRows unlike;
  const auto to_a = [&](std::size_t i) { unlike.of_a.push_back(i); };
  const auto to_b = [&](std::size_t i) { unlike.of_b.push_back(i); };
  const auto nothing = [](std::size_t) {};
  const auto known = static_cast<std::size_t>(std::count(alike.begin(), alike.end(), true));
  CountedSets<kSize> counts(b.size() - known);
  const auto add = [](std::size_t, auto& counted, const auto& set) {
    counted.set = set;
    ++counted.more;
  };
  const auto take = [&](std::size_t i, auto& counted, const auto&) {
    if (counts.is_free(counted)) {
      to_a(i);
    } else {
      --counted.more;
    }
  };
  for_each_counted(counts, b, alike, add, to_b);
  for_each_counted(counts, a, alike, take, to_a);
  if (counts.is_crowded()) return std::nullopt;
  if (counts.is_even()) return unlike;
  const auto if_uneven = [](const auto& to) {
    return [&to](std::size_t i, const auto& counted, const auto&) {
      if (counted.more != 0) to(i);
    };
  };
  for_each_counted(counts, a, alike, if_uneven(to_a), nothing);
  for_each_counted(counts, b, alike, if_uneven(to_b), nothing);
  if (counts.is_crowded()) return std::nullopt;
  return unlike;
}

// Adds the rows in the same place that are like others which one mesh has more often.
template <class SetsOfA, class SetsOfB>
void add_alike(const SetsOfA& a, const SetsOfB& b, const std::vector<bool>& alike,
               UnlikeRows& unlike) {
  std::vector<typename SetsOfB::Set> unlike_sets;
  const auto take = [&](auto set) {
    sort_vertices(set);
    if (set.front() >= 0) unlike_sets.push_back(set);
  };
  for (const std::size_t i : unlike.of_a) take(a[i]);
  for (const std::size_t i : unlike.of_b) take(b[i]);
  if (unlike_sets.empty()) return;
  std::sort(unlike_sets.begin(), unlike_sets.end());
  for (std::size_t i = 0; i < alike.size(); ++i) {
    if (!alike[i]) continue;
    auto set = b[i];
    sort_vertices(set);
    if (!std::binary_search(unlike_sets.begin(), unlike_sets.end(), set)) continue;
    unlike.of_a.push_back(i);
    unlike.of_b.push_back(i);
  }
}

template <std::size_t kSize, class RowsOfA, class RowsOfB>
std::optional<UnlikeRows> unlike_of(const RowsOfA& a, const RowsOfB& b,
                                    const std::vector<Vertex>& place_in_b,
                                    std::size_t points_of_b) {
  const auto image = [&](Vertex v) -> std::int32_t {
    const bool names = v >= 0 && static_cast<std::size_t>(v) < place_in_b.size();
    return names ? static_cast<std::int32_t>(place_in_b[static_cast<std::size_t>(v)]) : -1;
  };
  const auto own = [&](Vertex v) -> std::int32_t {
    return v >= 0 && static_cast<std::size_t>(v) < points_of_b ? static_cast<std::int32_t>(v) : -1;
  };
  const RowSets<kSize, RowsOfA, decltype(image)> sets_of_a(a, image);
  const RowSets<kSize, RowsOfB, decltype(own)> sets_of_b(b, own);
  const std::vector<bool> alike = rows_alike(sets_of_a, sets_of_b);
  auto unlike = compare<kSize>(sets_of_a, sets_of_b, alike);
  if (!unlike) return std::nullopt;
  add_alike(sets_of_a, sets_of_b, alike, *unlike);
  std::sort(unlike->of_a.begin(), unlike->of_a.end());
  std::sort(unlike->of_b.begin(), unlike->of_b.end());
  return unlike;
}

}  // namespace

std::optional<UnlikeRows> unlike_rows(const IndexLists& a, const IndexLists& b,
                                      const std::vector<Vertex>& place_in_b,
                                      std::size_t points_of_b) {
  constexpr std::size_t kMost = std::numeric_limits<std::int32_t>::max();
  if (a.size() > kMost || b.size() > kMost || points_of_b > kMost) return std::nullopt;
  if (a.columns() != b.columns()) return std::nullopt;
  using Unlike = std::optional<UnlikeRows>;
  return a.visit([&]<class ListsOfA>(const ListsOfA& of_a) -> Unlike {
    if constexpr (!std::is_same_v<ListsOfA, std::vector<Simplex>>) {
      return b.visit([&]<class ListsOfB>(const ListsOfB& of_b) -> Unlike {
        if constexpr (!std::is_same_v<ListsOfB, std::vector<Simplex>>) {
          if (of_a.columns() == 3) return unlike_of<3>(of_a, of_b, place_in_b, points_of_b);
          if (of_a.columns() == 4) return unlike_of<4>(of_a, of_b, place_in_b, points_of_b);
        }
        return std::nullopt;
      });
    }
    return std::nullopt;
  });
}

}  // namespace circumspect::check
