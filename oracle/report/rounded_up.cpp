#include "oracle/report/rounded_up.hpp"

#include <fmt/format.h>

namespace circumspect::report {

std::string square_root_rounded_up(const Rational& squared) {
  if (sign(squared) == 0) return "0";
  int exponent = 0;
  Rational power = 1;  // of ten, squared
  for (; power > squared; power /= 100) --exponent;
  for (; Rational(100 * power) <= squared; power *= 100) ++exponent;
  long digits = 10;
  while (Rational(digits * digits) * power < 100 * squared) ++digits;
  if (digits == 100) {
    digits = 10;
    ++exponent;
  }
  return fmt::format("{}.{}e{:+03d}", digits / 10, digits % 10, exponent);
}

}  // namespace circumspect::report
