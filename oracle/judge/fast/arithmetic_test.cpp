#include "oracle/judge/fast/arithmetic.hpp"

#include <cfenv>
#include <initializer_list>

#include <doctest/doctest.h>

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

}  // namespace
}  // namespace circumspect::fast
