// Plain integers and decimals at the front of a text, as programs write them. What is not plain has
// no answer here: parse_integer and parse_number (lines.hpp) then read it, or say what is wrong. A
// number that is accepted here has exactly the value that they give it.
#pragma once

#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace circumspect::formats {

// What separates tokens: a space, or one of tab, line feed, vertical tab, form feed and carriage
// return, which are consecutive.
constexpr bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

// Numbers of more characters are refused, because exact arithmetic on them would take too long.
// Every double has a shorter exact decimal.
inline constexpr std::size_t kLongestNumber = 10000;

// Reads up to eight digits at once, without a branch on their number: the digits are shifted to the
// upper end of a word, and the zeros shifted in act as leading zeros. Requires: eight bytes.
inline std::size_t read_eight_digits(const char* at, std::int64_t& value) {
  std::uint64_t word = 0;
  std::memcpy(&word, at, sizeof word);
  word ^= 0x3030303030303030U;  // a digit becomes its value, anything else more than 9
  // The lowest byte above 9 has its high bit set; a carry affects only later bytes.
  const std::uint64_t others = ((word + 0x7676767676767676U) | word) & 0x8080808080808080U;
  const auto count = static_cast<unsigned>(std::countr_zero(others)) / 8;
  if (count == 0) return 0;
  word <<= 64 - 8 * count;
  word = 10 * word + (word >> 8U);  // pairs of digits, in every other byte
  const std::uint64_t upper = (word & 0x000000FF000000FFU) * 0x000F424000000064U;
  const std::uint64_t lower = (word >> 16U & 0x000000FF000000FFU) * 0x0000271000000001U;
  value = static_cast<std::int64_t>((upper + lower) >> 32U);
  return count;
}

// An integer of at most 18 digits: [-]digits. Returns its end; null if there is none.
inline const char* read_plain_integer(const char* at, const char* end, std::int64_t& value) {
  const bool negative = at != end && *at == '-';
  if (negative) ++at;
  const char* const first = at;
  std::int64_t magnitude = 0;
  if constexpr (std::endian::native == std::endian::little) {
    if (end - at >= 8) at += read_eight_digits(at, magnitude);
  }
  for (; at != end && at - first < 18; ++at) {
    const unsigned digit = static_cast<unsigned char>(*at) - static_cast<unsigned>('0');
    if (digit > 9) break;
    magnitude = 10 * magnitude + static_cast<std::int64_t>(digit);
  }
  value = negative ? -magnitude : magnitude;
  return at == first ? nullptr : at;
}

// A decimal: [-]digits[.digits][e[+-]digits], one of the two runs of digits perhaps empty. Its
// value is the nearest double, as from strtod, but 0 for −0. Returns its end; null if there is
// none, also for numbers that overflow or underflow. ("inf" and "nan", which from_chars reads, are
// none.)
inline const char* read_plain_decimal(const char* at, const char* end, double& value) {
  const auto [stop, error] = std::from_chars(at, end, value);
  if (error != std::errc() || !std::isfinite(value)) return nullptr;
  if (static_cast<std::size_t>(stop - at) > kLongestNumber) return nullptr;
  value += 0.0;  // −0 becomes 0: equal points have equal bits
  return stop;
}

}  // namespace circumspect::formats
