#include "kernel/exact/angle_sum.hpp"

#include "kernel/exact/float.hpp"

namespace circumspect {
namespace {

constexpr mpfr_prec_t kFirstSumPrecision = 106, kOfDouble = 53;

mpfr_rnd_t against(mpfr_rnd_t toward) { return toward == MPFR_RNDD ? MPFR_RNDU : MPFR_RNDD; }

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

// One end of an enclosure of α + β − π in degrees, rounded to a double.
double excess(const Rational& alpha, const Rational& beta, mpfr_prec_t precision,
              mpfr_rnd_t toward) {
  Float sum(precision), other(precision), pi(precision);
  angle(sum, alpha, toward);
  angle(other, beta, toward);
  mpfr_add(sum.get(), sum.get(), other.get(), toward);
  mpfr_const_pi(pi.get(), against(toward));
  mpfr_sub(sum.get(), sum.get(), pi.get(), toward);
  mpfr_mul_ui(sum.get(), sum.get(), 180, toward);
  const bool is_positive = mpfr_sgn(sum.get()) > 0;
  mpfr_const_pi(pi.get(), is_positive ? against(toward) : toward);
  mpfr_div(sum.get(), sum.get(), pi.get(), toward);
  Float rounded(kOfDouble);
  mpfr_set(rounded.get(), sum.get(), MPFR_RNDN);
  return mpfr_get_d(rounded.get(), MPFR_RNDN);
}

}  // namespace

// The ends come to agree: a sum that is a rational number of degrees has a cosine of degree 4 at
// most over the rationals, so it is a multiple of 12, 15, 18 or 22.5, and halfway between no two
// doubles.
std::string excess_in_degrees(const Rational& alpha, const Rational& beta) {
  if (alpha == -beta) return "0";
  for (mpfr_prec_t precision = kFirstSumPrecision;; precision *= 2) {
    const double low = excess(alpha, beta, precision, MPFR_RNDD);
    if (low == excess(alpha, beta, precision, MPFR_RNDU)) return to_decimal(exact_value(low));
  }
}

}  // namespace circumspect
