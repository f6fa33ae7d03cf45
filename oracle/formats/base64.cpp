#include "oracle/formats/base64.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace circumspect::formats {

namespace {

constexpr std::string_view kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

// The value of each character; kNoDigit if it is none.
constexpr std::uint8_t kNoDigit = 255;
constexpr auto kValues = [] {
  std::array<std::uint8_t, 256> values = {};
  values.fill(kNoDigit);
  for (std::size_t i = 0; i < kDigits.size(); ++i) {
    values[static_cast<unsigned char>(kDigits[i])] = static_cast<std::uint8_t>(i);
  }
  values['='] = 0;
  return values;
}();

// Decodes whole groups of four digits, as long as nothing else comes, up to `count` bytes in all;
// returns how many characters that took.
std::size_t decode_groups(std::string_view text, std::size_t count, std::string& bytes) {
  std::size_t at = 0;
  for (; at + 4 <= text.size() && bytes.size() + 3 <= count; at += 4) {
    std::uint32_t group = 0;
    std::uint8_t all = 0;
    for (std::size_t i = at; i < at + 4; ++i) {
      const std::uint8_t value =
          text[i] == '=' ? kNoDigit : kValues[static_cast<unsigned char>(text[i])];
      all |= value;
      group = group << 6U | value;
    }
    if ((all & 0xC0U) != 0) break;  // digits have six bits
    const std::array<char, 3> three = {static_cast<char>(group >> 16U & 0xFFU),
                                       static_cast<char>(group >> 8U & 0xFFU),
                                       static_cast<char>(group & 0xFFU)};
    bytes.append(three.data(), three.size());
  }
  return at;
}

}  // namespace

std::optional<std::string> decode_base64(std::string_view text, std::size_t count) {
  std::string bytes;
  bytes.reserve(std::min(count, text.size() / 4 * 3 + 3));
  std::uint32_t group = 0;
  int digits = 0;
  int padding = 0;
  for (std::size_t at = 0; at < text.size() && bytes.size() < count; ++at) {
    if (digits == 0) at += decode_groups(text.substr(at), count, bytes);
    if (at == text.size() || bytes.size() >= count) break;
    const char c = text[at];
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
    const std::uint8_t value = kValues[static_cast<unsigned char>(c)];
    if (value == kNoDigit || (c != '=' && padding > 0)) return std::nullopt;
    if (c == '=') ++padding;
    group = group << 6U | value;
    if (++digits < 4) continue;
    if (padding > 2) return std::nullopt;
    for (int i = 0; i < 3 - padding; ++i) {
      bytes += static_cast<char>(
          static_cast<unsigned char>(group >> (16U - 8U * static_cast<unsigned>(i))));
    }
    group = 0;
    digits = 0;
    padding = 0;
  }
  if (bytes.size() < count && digits != 0) return std::nullopt;
  if (bytes.size() > count) bytes.resize(count);
  return bytes;
}

}  // namespace circumspect::formats
