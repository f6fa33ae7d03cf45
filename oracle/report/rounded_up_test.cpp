#include "oracle/report/rounded_up.hpp"

#include <doctest/doctest.h>

#include "reference/kernel/exact/number.hpp"

namespace circumspect::report {

TEST_CASE("square roots are rounded up to two digits") {
  CHECK(square_root_rounded_up(0) == "0");
  CHECK(square_root_rounded_up(1) == "1.0e+00");
  CHECK(square_root_rounded_up(2) == "1.5e+00");
  CHECK(square_root_rounded_up(Rational(9801, 100)) == "9.9e+00");
  CHECK(square_root_rounded_up(Rational(9802, 100)) == "1.0e+01");
  CHECK(square_root_rounded_up(100) == "1.0e+01");
  CHECK(square_root_rounded_up(Rational(1, 1'000'000)) == "1.0e-03");
  CHECK(square_root_rounded_up(Rational(1, 999'999)) == "1.1e-03");
}

TEST_CASE("what is printed is no less than the root, and a tenth more at most") {
  Rational squared(7, 3);
  for (int i = 0; i < 60; ++i, squared *= Rational(31, 977)) {
    const auto printed = read_number(square_root_rounded_up(squared), NumberReading::kDecimal);
    REQUIRE(printed);
    CHECK(*printed * *printed >= squared);
    CHECK(*printed * *printed <= squared * Rational(121, 100));
  }
}

}  // namespace circumspect::report
