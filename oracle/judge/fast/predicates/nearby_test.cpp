// Orientations with a vertex in a box: the sign must be that of every corner of the box.
#include "oracle/judge/fast/predicates/nearby.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include <doctest/doctest.h>

#include "oracle/judge/fast/predicates/predicates.hpp"
#include "oracle/judge/fast/predicates/tuples_test.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::fast {
namespace {

struct Asked {
  std::size_t certain = 0, uncertain = 0;
};

template <std::size_t kDimension>
void ask(SiteRow<kDimension> row, std::mt19937_64& random, Asked& asked) {
  const auto part = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const std::size_t place = random() % (kDimension + 1);
  Site<kDimension>& moved = row[place];
  if (random() % 4 != 0) {  // near the hyperplane of the others
    const Site<kDimension> first = row[(place + 1) % (kDimension + 1)];
    moved = first;
    for (std::size_t i = 2; i <= kDimension; ++i) {
      const Site<kDimension>& other = row[(place + i) % (kDimension + 1)];
      const double share = part();
      for (std::size_t axis = 0; axis < kDimension; ++axis) {
        moved.at[axis] += share * (other.at[axis] - first.at[axis]);
      }
    }
  }
  SiteRow<kDimension> far = row;
  std::array<double, kDimension> lengths;
  const double small = std::ldexp(1, -static_cast<int>(random() % 58));
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    double extent = 0;
    for (const auto& site : row) {
      extent = std::max(extent, std::fabs(site.at[axis] - row[kDimension].at[axis]));
    }
    if (random() % 2 == 0) moved.at[axis] += extent * small * part();
    far[place].at[axis] = moved.at[axis] + extent * small * part();
    lengths[axis] = far[place].at[axis] - moved.at[axis];
    if (!std::isfinite(lengths[axis])) return;
  }
  const int sign = orientation_nearby(row, lengths);
  if (sign == kUncertain) {
    ++asked.uncertain;
    return;
  }
  ++asked.certain;
  Stages stages;
  for (std::size_t which = 0; which < std::size_t{1} << kDimension; ++which) {
    SiteRow<kDimension> corner = row;
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      if ((which >> axis & 1) != 0) corner[place].at[axis] = far[place].at[axis];
    }
    REQUIRE(orientation<kDimension>(corner, stages) == sign);
  }
}

TEST_CASE("F7: with a vertex in a box, a certain sign is that of every corner of the box") {
  Asked plane, space;
  for (int kind = 0; kind <= static_cast<int>(Kind::kLast); ++kind) {
    CAPTURE(kind);
    Tuples tuples(static_cast<std::uint64_t>(kind));
    std::mt19937_64 random(static_cast<std::uint64_t>(kind));
    for (int i = 0; i < 8000 / properties::kOneInputIn; ++i) {
      CAPTURE(i);
      ask<2>(tuples.draw<2, 3>(static_cast<Kind>(kind)), random, plane);
      ask<3>(tuples.draw<3, 4>(static_cast<Kind>(kind)), random, space);
    }
  }
  CHECK(plane.certain > plane.uncertain / 8);
  CHECK(space.certain > space.uncertain / 8);
  CHECK(plane.uncertain > 0);
  CHECK(space.uncertain > 0);
}

}  // namespace
}  // namespace circumspect::fast
