#include "kernel/exact/angle_sum.hpp"

#include <doctest/doctest.h>

namespace circumspect {
namespace {

TEST_CASE("excess in degrees: angles with rational degrees, and their sums, exactly") {
  const Rational half(1, 2), quarter(1, 4), three_quarters(3, 4);
  CHECK(excess_in_degrees(0, 0) == "0");
  CHECK(excess_in_degrees(-1, 0) == "90");                      // 180 + 90
  CHECK(excess_in_degrees(-half, -half) == "90");               // 135 + 135
  CHECK(excess_in_degrees(-quarter, -three_quarters) == "90");  // 120 + 150
  CHECK(excess_in_degrees(-quarter, half) == "-15");            // 120 + 45
  CHECK(excess_in_degrees(half, -half) == "0");
  CHECK(excess_in_degrees(1, 1) == "-180");
  CHECK(excess_in_degrees(-1, -1) == "180");
}

TEST_CASE("excess in degrees: tiny ones are not lost among the sum") {
  // cos² differ by 10^-40, at 90 degrees: the angle is about 10^-20 of a radian.
  const Rational tiny(1, Integer("10000000000000000000000000000000000000000"));
  CHECK(excess_in_degrees(0, -tiny) == "5.729577951308232e-19");
  CHECK(excess_in_degrees(tiny, 0) == "-5.729577951308232e-19");
}

}  // namespace
}  // namespace circumspect
