#include "oracle/judge/fast/predicates/arithmetic.hpp"

namespace circumspect::fast {

bool arithmetic_is_as_proved() {
  volatile double one = 1, half_ulp = 0x1p-53, least = 0x1p-1074;
  volatile double factor = 1 + 0x1p-30, rounded_square = 1 + 0x1p-29;  // exactly 1 + 2^-29 + 2^-60
  const double a = factor, square = rounded_square;
  return rounds_products(a, a, square) && rounds_to_nearest(one, half_ulp, least);
}

}  // namespace circumspect::fast
