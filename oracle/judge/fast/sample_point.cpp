#include "oracle/judge/fast/sample_point.hpp"

#include <algorithm>

#include "kernel/boxes/box_index.hpp"
#include "kernel/exact/linear_algebra.hpp"
#include "kernel/exact/number.hpp"
#include "oracle/judge/fast/predicates/lattice.hpp"

namespace circumspect::fast {
namespace {

// value / 2^unit. Requires: an integer.
Integer in_units(double value, int unit) {
  const Dyadic parts = dyadic(value);
  if (parts.mantissa == 0) return 0;
  return to_integer(parts.mantissa) << static_cast<unsigned long>(parts.exponent - unit);
}

// The exponent of a power of two that divides all coordinates.
template <std::size_t kDimension>
int unit_of(const SiteRow<kDimension>& row, const SiteRow<kDimension>& others) {
  int unit = 2000;
  for (const auto& sites : {row, others}) {
    for (const Site<kDimension>& site : sites) {
      for (const double x : site.at) {
        if (x != 0) unit = std::min(unit, dyadic(x).exponent);
      }
    }
  }
  return unit;
}

}  // namespace

template <std::size_t kDimension>
int orientation_with_barycentre(const SiteRow<kDimension>& row, std::size_t place,
                                const SiteRow<kDimension>& corners, Stages& stages) {
  ++stages.unbounded;
  const int unit = unit_of<kDimension>(row, corners);
  // Everything is multiplied by kDimension + 1, which changes no sign.
  const auto scaled = [&](std::size_t i, std::size_t axis) -> Integer {
    if (i != place) return in_units(row[i].at[axis], unit) * int{kDimension + 1};
    Integer sum = 0;
    for (const Site<kDimension>& corner : corners) sum += in_units(corner.at[axis], unit);
    return sum;
  };
  SquareMatrix rows(kDimension);
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    const Integer last = scaled(kDimension, axis);
    for (std::size_t i = 0; i < kDimension; ++i) rows(i, axis) = scaled(i, axis) - last;
  }
  return sign(determinant(std::move(rows)));
}

template <std::size_t kDimension>
SamplePoint<kDimension> barycentre_of(const SiteRow<kDimension>& row, std::size_t simplex) {
  SamplePoint<kDimension> point{.simplex = simplex, .corners = row};
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    Rational sum;
    for (const Site<kDimension>& site : row) sum += exact_value(site.at[axis]);
    const Rational mean = sum / static_cast<int>(row.size());
    point.low.at[axis] = lower_double(mean);
    point.high.at[axis] = upper_double(mean);
  }
  return point;
}

template int orientation_with_barycentre<2>(const SiteRow<2>&, std::size_t, const SiteRow<2>&,
                                            Stages&);
template int orientation_with_barycentre<3>(const SiteRow<3>&, std::size_t, const SiteRow<3>&,
                                            Stages&);
template SamplePoint<2> barycentre_of(const SiteRow<2>&, std::size_t);
template SamplePoint<3> barycentre_of(const SiteRow<3>&, std::size_t);

}  // namespace circumspect::fast
