#include "oracle/judge/unlike_rows.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "kernel/complex/vertex_sets.hpp"

namespace circumspect::check {
namespace {

// The simplices of a mesh as sets of the points of one of the two; those that name none of them
// stay apart.
template <std::size_t kSize, class List, class Image>
VertexSets<kSize> sets_of(const List& rows, std::size_t points, const Image& image,
                          std::vector<std::size_t>& apart) {
  return VertexSets<kSize>(points, [&](const auto& visit) {
    apart.clear();
    for (std::size_t i = 0; i < rows.rows(); ++i) {
      typename VertexSets<kSize>::Set set;
      const auto row = rows.row(i);
      for (std::size_t k = 0; k < kSize; ++k) set[k] = image(static_cast<Vertex>(row[k]));
      if (std::all_of(set.begin(), set.end(), [](std::int32_t v) { return v >= 0; })) {
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
  UnlikeRows unlike;
  const auto of_a = sets_of<kSize>(a, points_of_b, image, unlike.of_a);
  const auto of_b = sets_of<kSize>(b, points_of_b, own, unlike.of_b);
  compare<kSize>(of_a, of_b, unlike);
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
