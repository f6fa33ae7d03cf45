// Which of many boxes may a line segment meet?
#pragma once

#include <algorithm>
#include <vector>

#include "reference/exact/box_index.hpp"

namespace circumspect {

// The places of all boxes that have a point in common with the segment, and some that are near it,
// ascending. A long segment has a box around it that is much larger than itself, so if too many are
// found it is halved.
inline std::vector<std::size_t> near_line(const BoxIndex& index, const Point& from, const Point& to,
                                          int halvings = 6) {
  std::vector<std::size_t> found = index.meeting(box_around(box_around(from), box_around(to)));
  constexpr std::size_t kFew = 12;
  if (halvings == 0 || found.size() <= kFew) return found;
  const Point middle = Rational(1, 2) * (from + to);
  found = near_line(index, from, middle, halvings - 1);
  const std::vector<std::size_t> rest = near_line(index, middle, to, halvings - 1);
  found.insert(found.end(), rest.begin(), rest.end());
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace circumspect
