// Integers of fixed width for the exact stages. Nothing is checked: callers know from the sizes of
// the factors that nothing overflows.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace circumspect::fast {

__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 UInt128;

// A form of some degree in numbers of 30 bits or, up to degree five, of 23 bits. It fits in 64 bits
// up to degree two, and in 128 bits beyond.
template <int kDegree>
struct Narrow {
  using Word = std::conditional_t<(kDegree <= 2), std::int64_t, Int128>;
  Word value;

  int sign() const { return (value > 0) - (value < 0); }
  friend Narrow operator+(Narrow a, Narrow b) { return {a.value + b.value}; }
  friend Narrow operator-(Narrow a, Narrow b) { return {a.value - b.value}; }
};

template <int kLeft, int kRight>
Narrow<kLeft + kRight> operator*(Narrow<kLeft> a, Narrow<kRight> b) {
  using Word = typename Narrow<kLeft + kRight>::Word;
  return {static_cast<Word>(a.value) * static_cast<Word>(b.value)};
}

// Sum and difference of limbs, with the carry or borrow into the next. Compilers emit the right
// instructions only for these intrinsics.
inline std::uint64_t add_with_carry(std::uint64_t a, std::uint64_t b, unsigned char& carry) {
#ifdef __x86_64__
  unsigned long long sum;
  carry = _addcarry_u64(carry, a, b, &sum);
  return sum;
#else
  const UInt128 sum = static_cast<UInt128>(a) + b + carry;
  carry = static_cast<unsigned char>(sum >> 64);
  return static_cast<std::uint64_t>(sum);
#endif
}
inline std::uint64_t subtract_with_borrow(std::uint64_t a, std::uint64_t b, unsigned char& borrow) {
#ifdef __x86_64__
  unsigned long long difference;
  borrow = _subborrow_u64(borrow, a, b, &difference);
  return difference;
#else
  const UInt128 difference = static_cast<UInt128>(a) - b - borrow;
  borrow = static_cast<unsigned char>(difference >> 64 & 1);
  return static_cast<std::uint64_t>(difference);
#endif
}

// An integer in two's complement, least significant limb first.
template <std::size_t kLimbs>
struct Fixed {
  std::array<std::uint64_t, kLimbs> limbs;

  bool is_negative() const { return static_cast<std::int64_t>(limbs[kLimbs - 1]) < 0; }
  int sign() const {
    if (is_negative()) return -1;
    std::uint64_t any = 0;
    for (const std::uint64_t limb : limbs) any |= limb;
    return any != 0;
  }

  friend Fixed operator+(const Fixed& a, const Fixed& b) {
    Fixed sum;
    unsigned char carry = 0;
    for (std::size_t i = 0; i < kLimbs; ++i) {
      sum.limbs[i] = add_with_carry(a.limbs[i], b.limbs[i], carry);
    }
    return sum;
  }
  friend Fixed operator-(const Fixed& a, const Fixed& b) {
    Fixed difference;
    unsigned char borrow = 0;
    for (std::size_t i = 0; i < kLimbs; ++i) {
      difference.limbs[i] = subtract_with_borrow(a.limbs[i], b.limbs[i], borrow);
    }
    return difference;
  }
};

// The full product: that of the limbs as unsigned numbers, minus the excess from counting the sign
// bits as positive.
template <std::size_t kLeft, std::size_t kRight>
Fixed<kLeft + kRight> operator*(const Fixed<kLeft>& a, const Fixed<kRight>& b) {
  Fixed<kLeft + kRight> product{};
  for (std::size_t i = 0; i < kLeft; ++i) {
    std::uint64_t carry = 0;
    for (std::size_t j = 0; j < kRight; ++j) {
      const UInt128 sum =
          static_cast<UInt128>(a.limbs[i]) * b.limbs[j] + product.limbs[i + j] + carry;
      product.limbs[i + j] = static_cast<std::uint64_t>(sum);
      carry = static_cast<std::uint64_t>(sum >> 64);
    }
    product.limbs[i + kRight] = carry;
  }
  const auto subtract_above = [&product](const auto& factor, std::size_t from, bool subtracted) {
    const std::uint64_t mask = subtracted ? ~std::uint64_t{0} : 0;
    unsigned char borrow = 0;
    for (std::size_t i = 0; from + i < kLeft + kRight; ++i) {
      std::uint64_t& limb = product.limbs[from + i];
      limb = subtract_with_borrow(limb, factor.limbs[i] & mask, borrow);
    }
  };
  subtract_above(a, kRight, b.is_negative());
  subtract_above(b, kLeft, a.is_negative());
  return product;
}

// Both factors fit in one limb, and their product in the two of an Int128.
inline Fixed<2> operator*(const Fixed<1>& a, const Fixed<1>& b) {
  const Int128 product = static_cast<Int128>(static_cast<std::int64_t>(a.limbs[0])) *
                         static_cast<std::int64_t>(b.limbs[0]);
  return {{static_cast<std::uint64_t>(product),
           static_cast<std::uint64_t>(static_cast<UInt128>(product) >> 64)}};
}

}  // namespace circumspect::fast
