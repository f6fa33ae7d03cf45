// The tokens of text that is as programs write it: plain integers and decimals. Anything else is not
// judged here: every function answers false, and who reads the text again with Lines gets the message
// or the value. What is taken here has exactly the value that Lines gives it.
#pragma once

#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "oracle/formats/lines.hpp"

namespace circumspect::formats {

// Walks over whole lines, whose bytes mean what they mean to Lines.
class PlainTokens {
 public:
  // Bytes behind the text that are read but never looked at.
  static constexpr std::size_t kPadding = 8;

  // Requires: the text is empty or its last byte is '\n'; kPadding bytes behind it may be read.
  PlainTokens(const char* begin, const char* end) : at_(begin), end_(end) {}

  bool at_end() const { return at_ == end_; }
  const char* at() const { return at_; }

  // Goes behind the end of this line if nothing but blanks and a comment precede it.
  bool skip_line_end() {
    skip_blanks();
    if (*at_ == '#') at_ = static_cast<const char*>(std::memchr(at_, '\n', bytes_left()));
    if (*at_ != '\n') return false;
    ++at_;
    return true;
  }

  // An integer of at most 18 digits: [-]digits.
  bool integer(std::int64_t& value) {
    skip_blanks();
    const bool negative = *at_ == '-';
    if (negative) ++at_;
    std::int64_t magnitude = 0;
    if (!digits(magnitude)) return false;
    value = negative ? -magnitude : magnitude;
    return ends_token(*at_);
  }

  // A decimal: [-]digits[.digits][e[+-]digits], one of the two runs of digits perhaps empty. Its value
  // is the nearest double, as from strtod, but 0 for -0. What overflows is refused. Of the numbers that
  // from_chars knows beyond these, "inf" and "nan" are not finite; hexadecimal floats and fractions go
  // on where from_chars stops.
  bool number(double& value) {
    skip_blanks();
    const auto [stop, error] = std::from_chars(at_, end_, value);
    if (error != std::errc() || !std::isfinite(value) || !ends_token(*stop)) return false;
    if (static_cast<std::size_t>(stop - at_) > kLongestNumber) return false;
    value += 0.0;  // -0 becomes 0: equal points have equal bits
    at_ = stop;
    return true;
  }

 private:
  // Tab, line feed, vertical tab, form feed, carriage return follow each other.
  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  static bool is_blank(char c) { return is_space(c) && c != '\n'; }
  static bool ends_token(char c) { return is_space(c) || c == '#'; }

  std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - at_); }

  void skip_blanks() {
    while (is_blank(*at_)) ++at_;
  }

  // 1 to 18 digits.
  bool digits(std::int64_t& value) {
    const char* const first = at_;
    if constexpr (std::endian::native == std::endian::little) eight_digits(value);
    while (true) {
      const unsigned digit = static_cast<unsigned char>(*at_) - static_cast<unsigned>('0');
      if (digit > 9 || at_ - first == 18) break;
      value = 10 * value + static_cast<std::int64_t>(digit);
      ++at_;
    }
    return at_ != first;
  }

  // Up to eight digits at once, without a branch on how many there are: the digits are moved to the
  // upper end of a word, zeros come in below, which stand for leading zeros.
  void eight_digits(std::int64_t& value) {
    std::uint64_t word = 0;
    std::memcpy(&word, at_, sizeof word);
    word ^= 0x3030303030303030U;  // a digit becomes its value, all else more than 9
    // The lowest byte above 9 has its high bit set; a carry spoils only those behind it.
    const std::uint64_t others = ((word + 0x7676767676767676U) | word) & 0x8080808080808080U;
    const auto count = static_cast<unsigned>(std::countr_zero(others)) / 8;
    if (count == 0) return;
    word <<= 64 - 8 * count;
    word = 10 * word + (word >> 8U);  // pairs of digits, in every other byte
    const std::uint64_t upper = (word & 0x000000FF000000FFU) * 0x000F424000000064U;
    const std::uint64_t lower = (word >> 16U & 0x000000FF000000FFU) * 0x0000271000000001U;
    value = static_cast<std::int64_t>((upper + lower) >> 32U);
    at_ += count;
  }

  const char* at_;
  const char* end_;
};

}  // namespace circumspect::formats
