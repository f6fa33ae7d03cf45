#include "reference/kernel/exact/number.hpp"

#include <cassert>
#include <cmath>

namespace circumspect {

Rational exact_value(double value) {
  assert(std::isfinite(value));
  return Rational(value);  // GMP documents this conversion as exact.
}

std::size_t bit_length(const Integer& value) {
  return sign(value) == 0 ? 0 : mpz_sizeinbase(value.get_mpz_t(), 2);
}

Integer least_common_multiple(const Integer& a, const Integer& b) {
  Integer result;
  mpz_lcm(result.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
  return result;
}

void add_product(Integer& sum, const Integer& a, const Integer& b) {
  mpz_addmul(sum.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
}

void subtract_product(Integer& sum, const Integer& a, const Integer& b) {
  mpz_submul(sum.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
}

Integer exact_quotient(const Integer& dividend, const Integer& divisor) {
  Integer result;
  mpz_divexact(result.get_mpz_t(), dividend.get_mpz_t(), divisor.get_mpz_t());
  return result;
}

}  // namespace circumspect
