#include "oracle/model/printable.hpp"

#include <algorithm>

namespace circumspect {
namespace {

// The payload bits of a continuation byte; nothing if the byte begins a character.
bool continues(char byte, char32_t& code) {
  const auto bits = static_cast<unsigned char>(byte);
  code = code << 6 | (bits & 0x3FU);
  return (bits & 0xC0U) == 0x80U;
}

std::string printable(std::string_view text, bool keeps_lines) {
  std::string shown;
  shown.reserve(text.size());
  while (!text.empty()) {
    const Character character = first_character(text);
    const std::size_t size = character.size == 0 ? 1 : character.size;
    const bool stays = keeps_lines && (text.front() == '\n' || text.front() == '\t');
    if (stays || (character.size != 0 && is_printable(character.code))) {
      shown += text.substr(0, size);
    } else {
      for (const char byte : text.substr(0, size)) append_escaped(shown, byte);
    }
    text.remove_prefix(size);
  }
  return shown;
}

}  // namespace

void append_escaped(std::string& text, char byte) {
  constexpr char kDigits[] = "0123456789abcdef";
  const auto bits = static_cast<unsigned char>(byte);
  text += "\\x";
  text += kDigits[bits / 16];
  text += kDigits[bits % 16];
}

// The Unicode Standard, Table 3-7: well-formed UTF-8 byte sequences, none longer than it need be,
// no surrogates.
Character first_character(std::string_view text) {
  if (text.empty()) return {};
  const auto first = static_cast<unsigned char>(text.front());
  if (first < 0x80) return {1, first};
  const std::size_t size = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < size) return {};
  char32_t code = first & (0x7FU >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if (!continues(text[i], code)) return {};
  }
  constexpr char32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < kLeast[size] || code > 0x10FFFF || is_surrogate) return {};
  return {size, code};
}

bool is_printable(char32_t code) {
  const auto is_between = [code](char32_t least, char32_t most) {
    return least <= code && code <= most;
  };
  const bool is_control = code < 0x20 || is_between(0x7F, 0x9F);
  const bool turns_text = code == 0x061C || is_between(0x200E, 0x200F) ||
                          is_between(0x202A, 0x202E) || is_between(0x2066, 0x2069);
  return !is_control && !turns_text && !is_between(0x2028, 0x2029) && !is_between(0xFFFE, 0xFFFF);
}

std::string on_one_line(std::string_view text) { return printable(text, false); }

std::string on_lines(std::string_view text) { return printable(text, true); }

std::string indented(std::string_view text) {
  std::string lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines += "  " + on_lines(text.substr(0, end)) + "\n";
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

}  // namespace circumspect
