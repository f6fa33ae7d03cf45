#include "oracle/formats/base64.hpp"

#include <cstdint>

namespace circumspect::formats {
namespace {

constexpr std::string_view kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

}  // namespace

std::optional<std::string> decode_base64(std::string_view text, std::size_t count) {
  std::string bytes;
  std::uint32_t group = 0;
  int digits = 0;
  int padding = 0;
  for (const char c : text) {
    if (bytes.size() >= count) break;
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
    const std::size_t value = c == '=' ? 0 : kDigits.find(c);
    if (value == std::string_view::npos || (c != '=' && padding > 0)) return std::nullopt;
    if (c == '=') ++padding;
    group = group << 6U | static_cast<std::uint32_t>(value);
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
