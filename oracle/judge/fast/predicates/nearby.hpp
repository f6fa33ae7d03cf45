// Orientations of simplices with a vertex of which only a small box is known, by doubles.
#pragma once

#include <array>

#include "oracle/judge/fast/predicates/filter.hpp"
#include "oracle/judge/fast/predicates/polynomials.hpp"
#include "oracle/judge/fast/predicates/site.hpp"

namespace circumspect::fast {

// Bounds on the error as in filter.hpp, for differences that are off by twice this part of the
// largest in their column: once for rounding, and once for the vertex.
inline constexpr double kNearby = 0x1p-31;
inline constexpr double kOrientation2Nearby = 0x1.001p-28;  // orientation_2_nearby.gappa
inline constexpr double kOrientation3Nearby = 0x1.201p-26;  // orientation_3_nearby.gappa

// The orientation for every point of a box in place of one vertex of the row, which is the least
// corner of the box, or kUncertain. The lengths are those of the box along the axes, rounded.
inline int orientation_nearby(const SiteRow<2>& row, const std::array<double, 2>& lengths) {
  const FilterRow2 a = row_from<false>(row[2], row[0]), b = row_from<false>(row[2], row[1]);
  const Scale2 scale = larger(a.scale, b.scale);
  if (!(lengths[0] <= kNearby * scale.x && lengths[1] <= kNearby * scale.y)) return kUncertain;
  const double value = minor(a.row.x, a.row.y, b.row.x, b.row.y);
  return certain_sign<int>(value, kOrientation2Nearby, scale, {});
}
inline int orientation_nearby(const SiteRow<3>& row, const std::array<double, 3>& lengths) {
  const FilterRow3 a = row_from<false>(row[3], row[0]), b = row_from<false>(row[3], row[1]),
                   c = row_from<false>(row[3], row[2]);
  const Scale3 scale = larger(larger(a.scale, b.scale), c.scale);
  if (!(lengths[0] <= kNearby * scale.x && lengths[1] <= kNearby * scale.y &&
        lengths[2] <= kNearby * scale.z)) {
    return kUncertain;
  }
  return certain_sign<int>(volume(a.row, b.row, c.row), kOrientation3Nearby, scale, {});
}

}  // namespace circumspect::fast
