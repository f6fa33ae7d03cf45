#include "oracle/formats/format_error.hpp"

#include "oracle/model/printable.hpp"

namespace circumspect::formats {

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
