#include "oracle/judge/fast/fixed_width.hpp"

#include <cstdint>
#include <random>

#include <doctest/doctest.h>

#include "oracle/judge/fast/dyadic.hpp"
#include "reference/kernel/exact/number.hpp"

namespace circumspect::fast {
namespace {

template <std::size_t kLimbs>
Integer value_of(const Fixed<kLimbs>& number) {
  Integer value = number.is_negative() ? -1 : 0;
  for (std::size_t i = kLimbs; i-- > 0;) {
    value <<= 64;
    value += Integer(static_cast<unsigned long>(number.limbs[i]));
  }
  return value;
}

// Limbs of all ones and all zeros among random ones, and two spare bits on top.
template <std::size_t kLimbs>
Fixed<kLimbs> drawn(std::mt19937_64& random) {
  Fixed<kLimbs> number;
  for (std::uint64_t& limb : number.limbs) {
    const std::uint64_t kind = random() % 4;
    limb = kind == 0 ? 0 : kind == 1 ? ~std::uint64_t{0} : random();
  }
  std::uint64_t& top = number.limbs[kLimbs - 1];
  top = static_cast<std::uint64_t>(static_cast<std::int64_t>(top) >> 2);
  return number;
}

template <std::size_t kLeft, std::size_t kRight>
void hold_to_integers(std::mt19937_64& random) {
  for (int i = 0; i < 2000; ++i) {
    const auto a = drawn<kLeft>(random), b = drawn<kLeft>(random);
    const auto c = drawn<kRight>(random);
    REQUIRE(value_of(a + b) == value_of(a) + value_of(b));
    REQUIRE(value_of(a - b) == value_of(a) - value_of(b));
    REQUIRE(value_of(a * c) == value_of(a) * value_of(c));
    REQUIRE(a.sign() == circumspect::sign(value_of(a)));
  }
}

TEST_CASE("Fixed: sums, differences, products and signs are those of integers") {
  std::mt19937_64 random(1);
  hold_to_integers<1, 1>(random);
  hold_to_integers<1, 2>(random);
  hold_to_integers<2, 3>(random);
  hold_to_integers<1, 4>(random);
  hold_to_integers<2, 2>(random);
  hold_to_integers<4, 6>(random);
}

TEST_CASE("Dyadic: the least and the largest double, and both zeros") {
  CHECK(dyadic(0).mantissa == 0);
  CHECK(dyadic(-0.0).mantissa == 0);
  CHECK(dyadic(-0x1p-1074).mantissa == -1);
  CHECK(dyadic(-0x1p-1074).exponent == -1074);
  CHECK(dyadic(0x1.fffffffffffffp1023).mantissa == (std::int64_t{1} << 53) - 1);
  CHECK(dyadic(0x1.fffffffffffffp1023).exponent == 971);
  CHECK(dyadic(0x1.fffffffffffffp1023).bits_above(-1074) == 1024 + 1074);
  CHECK(dyadic(12).mantissa == 3);
  CHECK(dyadic(12).exponent == 2);
}

}  // namespace
}  // namespace circumspect::fast
