#include "kernel/exact/number.hpp"

#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>

#include <gmp.h>
#include <mpfr.h>

namespace circumspect {

Rational exact_value(double value) {
  assert(std::isfinite(value));
  return Rational(value);  // GMP documents this conversion as exact.
}

namespace {

// Is the number certainly a double, as it has few bits over a power of two that is not too small?
// This needs no other number, and recognizes most doubles; false says nothing.
bool is_surely_double(const Rational& value) {
  constexpr std::size_t kBits = std::numeric_limits<double>::digits;
  constexpr std::size_t kFarthest = 900;
  const std::size_t exponent = mpz_scan1(value.get_den().get_mpz_t(), 0);
  return bit_length(value.get_num()) <= kBits && exponent <= kFarthest &&
         bit_length(value.get_den()) == exponent + 1;
}

}  // namespace

std::optional<double> as_double(const Rational& value) {
  const double nearest = value.get_d();
  if (is_surely_double(value)) return nearest;
  if (!std::isfinite(nearest) || exact_value(nearest) != value) return std::nullopt;
  return nearest;
}

std::size_t bit_length(const Integer& value) {
  return sign(value) == 0 ? 0 : mpz_sizeinbase(value.get_mpz_t(), 2);
}

Integer least_common_multiple(const Integer& a, const Integer& b) {
  Integer result;
  mpz_lcm(result.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
  return result;
}

Integer common_denominator(std::span<const Rational> numbers, Integer of_others) {
  for (const Rational& number : numbers) {
    const Integer& own = number.get_den();
    if (mpz_divisible_p(of_others.get_mpz_t(), own.get_mpz_t()) != 0) continue;
    of_others = least_common_multiple(of_others, own);
  }
  return of_others;
}

Integer numerator_over(const Integer& denominator, const Rational& value) {
  return value.get_num() * Integer(denominator / value.get_den());
}

void add_product(Integer& sum, const Integer& a, const Integer& b) {
  mpz_addmul(sum.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
}

void subtract_product(Integer& sum, const Integer& a, const Integer& b) {
  mpz_submul(sum.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
}

std::string number_libraries() {
  return std::string("GMP ") + gmp_version + ", MPFR " + mpfr_get_version();
}

namespace {

void (*end_without_memory)() = std::abort;

void* or_end(void* block) {
  if (block == nullptr) end_without_memory();
  return block;
}

void* allocated(std::size_t size) { return or_end(std::malloc(size)); }
void* reallocated(void* block, std::size_t, std::size_t size) {
  return or_end(std::realloc(block, size));
}

}  // namespace

void end_where_numbers_exhaust_memory(void (*end)()) {
  end_without_memory = end;
  mp_set_memory_functions(allocated, reallocated, nullptr);
}

}  // namespace circumspect
