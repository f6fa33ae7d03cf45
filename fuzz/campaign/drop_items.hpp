// Delta debugging of a list.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace circumspect::campaign {

// A sublist of `items` that `accepts` still takes, from which no single item can be left out (unless
// the budget behind `accepts` is spent: then it answers no to everything). Chunks are halved until
// they are single items; those at the end go first. Returns whether anything was dropped.
template <class Item>
bool drop_items(std::vector<Item>& items,
                const std::function<bool(const std::vector<Item>&)>& accepts) {
  const std::size_t before = items.size();
  std::size_t chunk = std::max<std::size_t>(items.size() / 2, 1);
  while (!items.empty()) {
    bool dropped = false;
    for (std::size_t end = items.size(); end > 0;) {
      const std::size_t begin = end > chunk ? end - chunk : 0;
      std::vector<Item> rest(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(begin));
      rest.insert(rest.end(), items.begin() + static_cast<std::ptrdiff_t>(end), items.end());
      if (accepts(rest)) {
        items = std::move(rest);
        dropped = true;
      }
      end = begin;
    }
    if (chunk == 1 && !dropped) break;
    chunk = std::max<std::size_t>(std::min(chunk / 2, items.size() / 2), 1);
  }
  return items.size() < before;
}

}  // namespace circumspect::campaign
