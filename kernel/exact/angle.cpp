#include "kernel/exact/angle.hpp"

#include <array>
#include <cassert>
#include <optional>

#include "kernel/exact/float.hpp"

namespace circumspect {
namespace {

constexpr mpfr_prec_t kFirstPrecision = 106;

struct RationalAngle {
  int degrees;
  Rational squared_cosine;
};

const std::array<RationalAngle, 5>& rational_angles() {
  static const std::array<RationalAngle, 5> all = {{{0, Rational(1)},
                                                    {30, Rational(3, 4)},
                                                    {45, Rational(1, 2)},
                                                    {60, Rational(1, 4)},
                                                    {90, Rational(0)}}};
  return all;
}

std::optional<Rational> rational_squared_cosine(const Rational& degrees) {
  for (const RationalAngle& angle : rational_angles()) {
    if (degrees == angle.degrees) return angle.squared_cosine;
  }
  return std::nullopt;
}

// One end of an enclosure of cos². Requires: from 0 to 90 degrees.
void squared_cosine(Float& end, const Rational& degrees, mpfr_rnd_t toward) {
  const mpfr_rnd_t against = toward == MPFR_RNDD ? MPFR_RNDU : MPFR_RNDD;  // cosines fall
  Float pi(mpfr_get_prec(end.get()));
  mpfr_const_pi(pi.get(), against);
  mpfr_mul_q(pi.get(), pi.get(), degrees.get_mpq_t(), against);
  mpfr_div_ui(pi.get(), pi.get(), 180, against);
  mpfr_cos(end.get(), pi.get(), toward);
  if (mpfr_sgn(end.get()) < 0) mpfr_set_zero(end.get(), 1);
  mpfr_sqr(end.get(), end.get(), toward);
}

// The sign of cos² of the degrees minus the value. Requires: from 0 to 90 degrees.
int compare_squared_cosine(const Rational& degrees, const Rational& value) {
  if (const auto exact = rational_squared_cosine(degrees)) return sign(Rational(*exact - value));
  for (mpfr_prec_t precision = kFirstPrecision;; precision *= 2) {
    Float end(precision);
    squared_cosine(end, degrees, MPFR_RNDD);
    if (mpfr_cmp_q(end.get(), value.get_mpq_t()) > 0) return 1;
    squared_cosine(end, degrees, MPFR_RNDU);
    if (mpfr_cmp_q(end.get(), value.get_mpq_t()) < 0) return -1;
  }
}

// One end of an enclosure of the angle, rounded to 53 bits.
void rounded_degrees(Float& result, const Rational& signed_square, mpfr_prec_t precision,
                     mpfr_rnd_t toward) {
  const bool is_acute = sign(signed_square) > 0;
  const mpfr_rnd_t against = toward == MPFR_RNDD ? MPFR_RNDU : MPFR_RNDD;
  // The cosine is rounded against the angle, and its size with the sign.
  const mpfr_rnd_t of_size = is_acute ? against : toward;
  Float wide(precision);
  mpfr_set_q(wide.get(), Rational(abs(signed_square)).get_mpq_t(), of_size);
  mpfr_sqrt(wide.get(), wide.get(), of_size);
  if (mpfr_cmp_ui(wide.get(), 1) > 0) mpfr_set_ui(wide.get(), 1, MPFR_RNDN);
  if (!is_acute) mpfr_neg(wide.get(), wide.get(), MPFR_RNDN);
  mpfr_acos(wide.get(), wide.get(), toward);
  mpfr_mul_ui(wide.get(), wide.get(), 180, toward);
  Float pi(precision);
  mpfr_const_pi(pi.get(), against);
  mpfr_div(wide.get(), wide.get(), pi.get(), toward);
  mpfr_set(result.get(), wide.get(), MPFR_RNDN);
}

}  // namespace

int compare_angle(const Rational& signed_square, const Rational& degrees) {
  assert(sign(degrees) >= 0 && degrees <= 180);
  if (degrees > 90) return -compare_angle(-signed_square, 180 - degrees);
  if (degrees < 90 && sign(signed_square) <= 0) return 1;
  return compare_squared_cosine(degrees, signed_square);
}

DoubleRange signed_square_of_degrees(const Rational& degrees) {
  if (degrees > 90) {
    const auto [low, high] = signed_square_of_degrees(180 - degrees);
    return {-high, -low};
  }
  Float low(kFirstPrecision), high(kFirstPrecision);
  squared_cosine(low, degrees, MPFR_RNDD);
  squared_cosine(high, degrees, MPFR_RNDU);
  return {mpfr_get_d(low.get(), MPFR_RNDD), mpfr_get_d(high.get(), MPFR_RNDU)};
}

std::string degrees_to_decimal(const Rational& signed_square) {
  for (const RationalAngle& angle : rational_angles()) {
    if (abs(signed_square) != angle.squared_cosine) continue;
    return to_decimal(sign(signed_square) < 0 ? 180 - angle.degrees : angle.degrees);
  }
  // The angle is no rational number of degrees, so it is not a midpoint of two doubles.
  for (mpfr_prec_t precision = kFirstPrecision;; precision *= 2) {
    Float low(53), high(53);
    rounded_degrees(low, signed_square, precision, MPFR_RNDD);
    rounded_degrees(high, signed_square, precision, MPFR_RNDU);
    if (mpfr_equal_p(low.get(), high.get()) == 0) continue;
    Rational nearest;
    mpfr_get_q(nearest.get_mpq_t(), low.get());
    return to_decimal(nearest);
  }
}

}  // namespace circumspect
