// Lists as sets.
#pragma once

#include <algorithm>

namespace circumspect {

// Sorts a list, and keeps one of each item.
template <class List>
void keep_each_once(List& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

}  // namespace circumspect
