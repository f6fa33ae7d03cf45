// The arithmetic of the machine, integers of fixed width, and lattices.
#include "oracle/judge/fast/predicates/fixed_width.hpp"

#include <cfenv>
#include <cstdint>
#include <initializer_list>
#include <random>
#include <vector>

#include <doctest/doctest.h>

#include "kernel/exact/number.hpp"
#include "oracle/judge/fast/predicates/arithmetic.hpp"
#include "oracle/judge/fast/predicates/lattice.hpp"

namespace circumspect::fast {

namespace {

TEST_CASE("F3: this build and machine compute as the bounds suppose") {
  CHECK(arithmetic_is_as_proved());
}

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
__attribute__((noinline, target("fma"), optimize("O2,fp-contract=fast"))) bool contracted(
    double a, double b, double rounded_product) {
  return !rounds_products(a, b, rounded_product);
}

TEST_CASE("F3: a contracted product is noticed") {
  if (!__builtin_cpu_supports("fma")) return;
  CHECK(contracted(1 + 0x1p-30, 1 + 0x1p-30, 1 + 0x1p-29));
}
#endif

TEST_CASE("F3: another rounding mode is noticed") {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const bool as_proved = arithmetic_is_as_proved();
    std::fesetround(FE_TONEAREST);
    CHECK_FALSE(as_proved);
  }
}

#ifdef __SSE2__
TEST_CASE("F3: denormal numbers that are flushed to zero are noticed") {
  const unsigned int before = __builtin_ia32_stmxcsr();
  for (const unsigned int flag : {0x8000u, 0x0040u}) {  // flush to zero, denormals are zero
    __builtin_ia32_ldmxcsr(before | flag);
    const bool as_proved = arithmetic_is_as_proved();
    __builtin_ia32_ldmxcsr(before);
    CHECK_FALSE(as_proved);
  }
}
#endif

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

double unit_of_all(const std::vector<double>& coordinates,
                   const std::vector<double>& weights = {}) {
  return lattice_of_all(coordinates, weights).unit;
}

TEST_CASE("the coarsest lattice of all points, unless it is too fine") {
  CHECK(unit_of_all({0, 4, -12, 8}) == 4);
  CHECK(unit_of_all({0, 4, -12, 8}, {16, 32}) == 4);
  CHECK(unit_of_all({0, 4, -12, 8}, {16, 8}) == 2);  // its square divides them
  CHECK(unit_of_all({0, 4, -12, 8}, {16, 2}) == 1);
  CHECK(unit_of_all({1, 0x1p-39}) == 0x1p-39);
  CHECK(unit_of_all({1, 0x1p-40}) == 0);
  CHECK(unit_of_all({0.1, 0.2}) == 0);
  CHECK(unit_of_all({0x1p-199}) == 0x1p-199);
  CHECK(unit_of_all({0x1p-200}) == 0);
  CHECK(unit_of_all({0x1p200}) == 0x1p190);  // finer is right as well
  CHECK(unit_of_all({0x1p-1074, 1e300}) == 0);
}

}  // namespace

}  // namespace circumspect::fast
