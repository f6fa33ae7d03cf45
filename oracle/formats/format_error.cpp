#include "oracle/formats/format_error.hpp"

namespace circumspect::formats {
namespace {

void append_escaped(std::string& text, char c) {
  constexpr char kDigits[] = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(c);
  text += "\\x";
  text += kDigits[byte / 16];
  text += kDigits[byte % 16];
}

bool is_control(char c) { return (c >= 0 && c < ' ') || c == '\x7f'; }

// Names of files may be in any language, so only what breaks a line or a terminal is escaped.
std::string on_one_line(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) {
    if (is_control(c)) {
      append_escaped(text, c);
    } else {
      text += c;
    }
  }
  return text;
}

}  // namespace

std::string FormatError::to_string() const {
  const std::string place = line == 0 ? file : file + ":" + std::to_string(line);
  return on_one_line(place + ": expected " + expected + ", found " + found);
}

std::string quote(std::string_view bytes) {
  std::string text = "\"";
  for (const char c : bytes.substr(0, kLongestQuote)) {
    if (c >= ' ' && c <= '~') {
      text += c;
    } else {
      append_escaped(text, c);
    }
  }
  if (bytes.size() > kLongestQuote) text += "...";
  return text + "\"";
}

}  // namespace circumspect::formats
