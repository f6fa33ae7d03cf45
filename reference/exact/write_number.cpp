#include "reference/exact/write_number.hpp"

#include <cassert>
#include <charconv>
#include <cmath>
#include <vector>

#include <mpfr.h>

namespace circumspect {
namespace {

constexpr mpfr_prec_t kDoublePrecision = 53;

// An MPFR number that frees itself.
class Float {
 public:
  explicit Float(mpfr_prec_t precision) { mpfr_init2(value_, precision); }
  ~Float() { mpfr_clear(value_); }
  Float(const Float&) = delete;
  Float& operator=(const Float&) = delete;
  mpfr_ptr get() { return value_; }

 private:
  mpfr_t value_;
};

std::string shortest(double value) {
  char buffer[64];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  assert(error == std::errc());
  return std::string(buffer, end);
}

// Requires: value has 53 bits, so within the range of normal doubles its conversion is exact.
std::string print(Float& value) {
  const double nearest = mpfr_get_d(value.get(), MPFR_RNDN);
  const bool is_normal_or_zero = std::isnormal(nearest) || mpfr_zero_p(value.get()) != 0;
  if (is_normal_or_zero) return shortest(nearest);
  char buffer[64];
  mpfr_snprintf(buffer, sizeof buffer, "%.16Re", value.get());
  return buffer;
}

bool is_square(const Integer& value) { return mpz_perfect_square_p(value.get_mpz_t()) != 0; }

// One end of an enclosure of sqrt(value), computed with the given precision and rounded to 53 bits.
void rounded_root(Float& result, const Rational& value, mpfr_prec_t precision, mpfr_rnd_t toward) {
  Float wide(precision);
  mpfr_set_q(wide.get(), value.get_mpq_t(), toward);
  mpfr_sqrt(wide.get(), wide.get(), toward);
  mpfr_set(result.get(), wide.get(), MPFR_RNDN);
}

}  // namespace

std::string to_string(const Integer& value) { return value.get_str(); }
std::string to_string(const Rational& value) { return value.get_str(); }

std::string to_text_of_double_or_fraction(const Rational& value) {
  const double candidate = value.get_d();
  const bool is_double = std::isfinite(candidate) && exact_value(candidate) == value;
  if (is_double) return shortest(candidate);
  // A denominator keeps an integer that is no double from being read as the nearest one.
  return value.get_den() == 1 ? value.get_str() + "/1" : value.get_str();
}

std::string to_decimal(const Rational& value) {
  Float nearest(kDoublePrecision);
  mpfr_set_q(nearest.get(), value.get_mpq_t(), MPFR_RNDN);
  return print(nearest);
}

std::string square_root_to_decimal(const Rational& value) {
  assert(sign(value) >= 0);
  if (is_square(value.get_num()) && is_square(value.get_den())) {
    const Rational root(sqrt(value.get_num()), sqrt(value.get_den()));
    return to_decimal(root);
  }
  // The root is irrational, so it is no midpoint of two doubles: widening the precision makes both
  // ends of the enclosure round to the same double.
  for (mpfr_prec_t precision = 2 * kDoublePrecision;; precision *= 2) {
    Float low(kDoublePrecision);
    Float high(kDoublePrecision);
    rounded_root(low, value, precision, MPFR_RNDD);
    rounded_root(high, value, precision, MPFR_RNDU);
    if (mpfr_equal_p(low.get(), high.get()) != 0) return print(low);
  }
}

std::string number_libraries() {
  return std::string("GMP ") + gmp_version + ", MPFR " + mpfr_get_version();
}

}  // namespace circumspect
