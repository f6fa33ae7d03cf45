#include "command/web/libcxx.hpp"

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace std {
namespace {

to_chars_result copied(string_view text, char* first, char* last) {
  if (text.size() > static_cast<size_t>(last - first)) return {last, errc::value_too_large};
  memcpy(first, text.data(), text.size());
  return {first + text.size(), errc()};
}

const char* behind_digits(const char* at, const char* last) {
  while (at != last && *at >= '0' && *at <= '9') ++at;
  return at;
}

// As "1e+20", from the shortest digits and the exponent of the first.
string in_scientific(const string& digits, int exponent) {
  const string mantissa = digits.substr(0, 1) + (digits.size() > 1 ? "." + digits.substr(1) : "");
  return fmt::format("{}e{:+03d}", mantissa, exponent);
}

}  // namespace

// The shorter of the two notations, and without an exponent if they are equally long.
to_chars_result to_chars(char* first, char* last, double value) {
  const string text = fmt::format("{}", value);  // all digits that identify the value, and no more
  if (text.find_first_of("in") != string::npos) return copied(text, first, last);  // inf, nan
  const string sign = text.front() == '-' ? "-" : "";
  const size_t mark = min(text.find('e'), text.size());
  string digits = text.substr(sign.size(), mark - sign.size());
  const size_t point = min(digits.find('.'), digits.size());
  if (point < digits.size()) digits.erase(point, 1);
  int exponent = static_cast<int>(point) - 1 + (mark < text.size() ? atoi(&text[mark + 1]) : 0);
  const size_t zeros = min(digits.find_first_not_of('0'), digits.size() - 1);
  digits.erase(0, zeros);
  exponent -= static_cast<int>(zeros);
  while (digits.size() > 1 && digits.back() == '0') digits.pop_back();
  const int count = static_cast<int>(digits.size());
  const string scientific = in_scientific(digits, exponent);
  string fixed;
  if (value == 0) {
    fixed = "0";
  } else if (exponent < 0) {
    fixed = "0." + string(static_cast<size_t>(-exponent - 1), '0') + digits;
  } else if (exponent + 1 >= count) {
    fixed = fmt::format("{:.0f}",
                        value < 0 ? -value : value);  // with the digits of the value behind those
  } else {
    fixed = digits.substr(0, static_cast<size_t>(exponent) + 1) + "." +
            digits.substr(static_cast<size_t>(exponent) + 1);
  }
  return copied(sign + (fixed.size() <= scientific.size() ? fixed : scientific), first, last);
}

// [-]digits[.digits][e[+-]digits]. Infinities and what is not a number, which no reader takes, are
// refused as well.
from_chars_result from_chars(const char* first, const char* last, double& value) {
  const char* at = first;
  if (at != last && *at == '-') ++at;
  const char* const whole = at;
  at = behind_digits(at, last);
  auto count = at - whole;
  if (at != last && *at == '.') {
    const char* const fraction = at + 1;
    const char* const end = behind_digits(fraction, last);
    count += end - fraction;
    if (count > 0) at = end;
  }
  if (count == 0) return {first, errc::invalid_argument};
  if (at != last && (*at == 'e' || *at == 'E')) {
    const char* exponent = at + 1;
    if (exponent != last && (*exponent == '+' || *exponent == '-')) ++exponent;
    const char* const end = behind_digits(exponent, last);
    if (end != exponent) at = end;
  }
  // strtod wants a zero behind the number, and here may see nothing else of the text: "0x" is 0 and
  // an x.
  char buffer[64];
  const auto size = static_cast<size_t>(at - first);
  const string copy = size < sizeof buffer ? string() : string(first, at);
  if (copy.empty()) {
    memcpy(buffer, first, size);
    buffer[size] = '\0';
  }
  const int before = exchange(errno, 0);
  const double read = strtod(copy.empty() ? buffer : copy.c_str(), nullptr);
  const bool in_range =
      errno != ERANGE || (read != 0 && read != HUGE_VAL && read != -HUGE_VAL);  // or subnormal
  errno = before;
  if (!in_range) return {at, errc::result_out_of_range};
  value = read;
  return {at, errc()};
}

}  // namespace std
