#include "oracle/formats/base64.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace circumspect::formats {

namespace {

constexpr std::string_view kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

// The value of each character; digits have six bits.
constexpr std::uint8_t kNoDigit = 255;
constexpr std::uint8_t kPadding = 64;
constexpr auto kValues = [] {
  std::array<std::uint8_t, 256> values = {};
  values.fill(kNoDigit);
  for (std::size_t i = 0; i < kDigits.size(); ++i) {
    values[static_cast<unsigned char>(kDigits[i])] = static_cast<std::uint8_t>(i);
  }
  values['='] = kPadding;
  return values;
}();

// Decodes whole groups of four digits, as long as nothing else comes, into as many bytes as there
// is room for; returns how many groups.
std::size_t decode_groups(std::string_view text, std::span<char> to) {
  const std::size_t most = std::min(text.size() / 4, to.size() / 3);
  const char* from = text.data();
  char* at = to.data();
  for (std::size_t done = 0; done < most; ++done, from += 4, at += 3) {
    const auto value = [&](std::size_t i) -> std::uint32_t {
      return kValues[static_cast<unsigned char>(from[i])];
    };
    const std::uint32_t a = value(0), b = value(1), c = value(2), d = value(3);
    if (((a | b | c | d) & 0xC0U) != 0) return done;
    at[0] = static_cast<char>(a << 2U | b >> 4U);
    at[1] = static_cast<char>(b << 4U | c >> 2U);
    at[2] = static_cast<char>(c << 6U | d);
  }
  return most;
}

}  // namespace

std::optional<std::string> decode_base64(std::string_view text, std::size_t count) {
  std::string bytes(std::min(count, text.size() / 4 * 3 + 3), '\0');
  std::size_t size = 0;
  std::uint32_t group = 0;
  int digits = 0;
  int padding = 0;
  for (std::size_t at = 0; at < text.size() && size < count; ++at) {
    if (digits == 0) {
      const std::size_t groups = decode_groups(text.substr(at), std::span(bytes).subspan(size));
      at += 4 * groups;
      size += 3 * groups;
    }
    if (at == text.size() || size >= count) break;
    const char c = text[at];
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
    const std::uint8_t value = kValues[static_cast<unsigned char>(c)];
    if (value == kNoDigit || (c != '=' && padding > 0)) return std::nullopt;
    if (c == '=') ++padding;
    group = group << 6U | (c == '=' ? 0U : value);
    if (++digits < 4) continue;
    if (padding > 2) return std::nullopt;
    for (int i = 0; i < 3 - padding && size < count; ++i) {
      bytes[size++] = static_cast<char>(
          static_cast<unsigned char>(group >> (16U - 8U * static_cast<unsigned>(i))));
    }
    group = 0;
    digits = 0;
    padding = 0;
  }
  if (size < count && digits != 0) return std::nullopt;
  bytes.resize(size);
  return bytes;
}

}  // namespace circumspect::formats
