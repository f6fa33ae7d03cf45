#include "oracle/judge/unlike_rows.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <type_traits>

#include "kernel/complex/vertex_sets.hpp"

namespace circumspect::check {
namespace {

// The rows of a mesh as sets of points of one of the two; a vertex that is none of these is
// negative.
template <std::size_t kSize, class List, class Image>
class RowSets {
 public:
  using Set = typename VertexSets<kSize>::Set;

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
  return std::all_of(set.begin(), set.end(), [](std::int32_t v) { return v >= 0; });
}

// Do they have the same vertices, in any order?
template <class Set>
bool are_alike(Set a, Set b) {
  if (a == b) return true;
  const auto sum = [](const Set& set) { return std::reduce(set.begin(), set.end(), Vertex{0}); };
  if (sum(a) != sum(b)) return false;
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  return a == b;
}

// Rows that both meshes list in the same place: all of them, but where they are few.
template <class SetsOfA, class SetsOfB>
std::vector<bool> rows_alike(const SetsOfA& a, const SetsOfB& b) {
  constexpr std::size_t kSome = 4096;
  std::vector<bool> alike(std::max(a.size(), b.size()), false);
  std::size_t found = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (i % kSome == 0 && found < i / 4) break;  // sorting is faster
    const auto of_a = a[i];
    alike[i] = is_whole(of_a) && are_alike(of_a, b[i]);
    found += alike[i] ? 1 : 0;
  }
  return alike;
}

// The sets of the other rows; those that name no point of the mesh stay apart.
template <std::size_t kSize, class Sets>
VertexSets<kSize> sets_of(const Sets& sets, const std::vector<bool>& alike, std::size_t points,
                          std::vector<std::size_t>& apart) {
  return VertexSets<kSize>(points, [&](const auto& visit) {
    apart.clear();
    for (std::size_t i = 0; i < sets.size(); ++i) {
      if (alike[i]) continue;
      const auto set = sets[i];
      if (is_whole(set)) {
        visit(set, static_cast<std::int32_t>(i));
      } else {
        apart.push_back(i);
      }
    }
  });
}

// Adds to either list what the other has more or less often.
template <std::size_t kSize>
void compare(const VertexSets<kSize>& a, const VertexSets<kSize>& b, UnlikeRows& unlike) {
  const auto add = [](auto group, std::vector<std::size_t>& places) {
    for (const auto& entry : group) places.push_back(static_cast<std::size_t>(entry.origin));
  };
  for (std::size_t v = 0; v < a.points(); ++v) {
    auto of_a = a.with_least(v), of_b = b.with_least(v);
    while (!of_a.empty() || !of_b.empty()) {
      const auto group_of = [](auto entries, auto others) {
        const bool is_later =
            entries.empty() || (!others.empty() && others[0].others < entries[0].others);
        return is_later ? entries.first(0) : VertexSets<kSize>::first_group(entries);
      };
      const auto in_a = group_of(of_a, of_b), in_b = group_of(of_b, of_a);
      if (in_a.size() != in_b.size()) {
        add(in_a, unlike.of_a);
        add(in_b, unlike.of_b);
      }
      of_a = of_a.subspan(in_a.size());
      of_b = of_b.subspan(in_b.size());
    }
  }
}

// Adds the rows in the same place that are like others which one mesh has more often.
template <class SetsOfA, class SetsOfB>
void add_alike(const SetsOfA& a, const SetsOfB& b, const std::vector<bool>& alike,
               UnlikeRows& unlike) {
  std::vector<typename SetsOfB::Set> unlike_sets;
  const auto take = [&](auto set) {
    std::sort(set.begin(), set.end());
    if (set.front() >= 0) unlike_sets.push_back(set);
  };
  for (const std::size_t i : unlike.of_a) take(a[i]);
  for (const std::size_t i : unlike.of_b) take(b[i]);
  if (unlike_sets.empty()) return;
  std::sort(unlike_sets.begin(), unlike_sets.end());
  for (std::size_t i = 0; i < alike.size(); ++i) {
    if (!alike[i]) continue;
    auto set = b[i];
    std::sort(set.begin(), set.end());
    if (!std::binary_search(unlike_sets.begin(), unlike_sets.end(), set)) continue;
    unlike.of_a.push_back(i);
    unlike.of_b.push_back(i);
  }
}

template <std::size_t kSize, class RowsOfA, class RowsOfB>
UnlikeRows unlike_of(const RowsOfA& a, const RowsOfB& b, const std::vector<Vertex>& place_in_b,
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
  UnlikeRows unlike;
  const auto of_a = sets_of<kSize>(sets_of_a, alike, points_of_b, unlike.of_a);
  const auto of_b = sets_of<kSize>(sets_of_b, alike, points_of_b, unlike.of_b);
  compare<kSize>(of_a, of_b, unlike);
  add_alike(sets_of_a, sets_of_b, alike, unlike);
  std::sort(unlike.of_a.begin(), unlike.of_a.end());
  std::sort(unlike.of_b.begin(), unlike.of_b.end());
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
