#include "kernel/exact/angle.hpp"

#include <array>
#include <cassert>
#include <optional>

#include "kernel/exact/float.hpp"
#include "kernel/exact/number_text.hpp"

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

mpfr_rnd_t against(mpfr_rnd_t toward) { return toward == MPFR_RNDD ? MPFR_RNDU : MPFR_RNDD; }

// One end of an enclosure of cos². Requires: from 0 to 90 degrees.
void squared_cosine(Float& end, const Rational& degrees, mpfr_rnd_t toward) {
  const mpfr_rnd_t of_angle = against(toward);  // cosines fall
  Float pi(mpfr_get_prec(end.get()));
  mpfr_const_pi(pi.get(), of_angle);
  mpfr_mul_q(pi.get(), pi.get(), degrees.get_mpq_t(), of_angle);
  mpfr_div_ui(pi.get(), pi.get(), 180, of_angle);
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

// One end of an enclosure of the angle, in radians. It falls as the cosine grows, and the size of a
// cosine below zero grows as the cosine falls.
void angle(Float& end, const Rational& signed_square, mpfr_rnd_t toward) {
  const bool is_acute = sign(signed_square) > 0;
  const mpfr_rnd_t of_size = is_acute ? against(toward) : toward;
  mpfr_set_q(end.get(), Rational(abs(signed_square)).get_mpq_t(), of_size);
  mpfr_sqrt(end.get(), end.get(), of_size);
  if (mpfr_cmp_ui(end.get(), 1) > 0) mpfr_set_ui(end.get(), 1, MPFR_RNDN);
  if (!is_acute) mpfr_neg(end.get(), end.get(), MPFR_RNDN);
  mpfr_acos(end.get(), end.get(), toward);
}

// One end of an enclosure of radians in degrees, rounded to a double.
double in_degrees(Float& radians, mpfr_rnd_t toward) {
  mpfr_mul_ui(radians.get(), radians.get(), 180, toward);
  const bool is_positive = mpfr_sgn(radians.get()) > 0;
  Float pi(mpfr_get_prec(radians.get()));
  mpfr_const_pi(pi.get(), is_positive ? against(toward) : toward);
  mpfr_div(radians.get(), radians.get(), pi.get(), toward);
  return mpfr_get_d(radians.get(), MPFR_RNDN);
}

// The double in which both ends of an enclosure agree, once its precision suffices.
// `end(precision, toward)`: one end, rounded to a double.
template <class End>
std::string where_ends_agree(const End& end) {
  for (mpfr_prec_t precision = kFirstPrecision;; precision *= 2) {
    const double low = end(precision, MPFR_RNDD);
    if (low == end(precision, MPFR_RNDU)) return to_decimal(exact_value(low));
  }
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
  // The angle is not a rational number of degrees, so it is not a midpoint of two doubles.
  return where_ends_agree([&](mpfr_prec_t precision, mpfr_rnd_t toward) {
    Float end(precision);
    angle(end, signed_square, toward);
    return in_degrees(end, toward);
  });
}

// The ends come to agree: a sum that is a rational number of degrees has a cosine of degree 4 at
// most over the rationals, so it is a multiple of 12, 15, 18 or 22.5, and halfway between no two
// doubles.
std::string excess_in_degrees(const Rational& alpha, const Rational& beta) {
  if (alpha == -beta) return "0";
  return where_ends_agree([&](mpfr_prec_t precision, mpfr_rnd_t toward) {
    Float sum(precision), other(precision);
    angle(sum, alpha, toward);
    angle(other, beta, toward);
    mpfr_add(sum.get(), sum.get(), other.get(), toward);
    mpfr_const_pi(other.get(), against(toward));
    mpfr_sub(sum.get(), sum.get(), other.get(), toward);
    return in_degrees(sum, toward);
  });
}

}  // namespace circumspect
