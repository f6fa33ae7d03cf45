// The tokens of text as programs write it: plain integers and decimals. For anything else every
// function returns false, and reading the text again with Lines gives the message or the value. A
// token that is accepted here has exactly the value that Lines gives it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "oracle/formats/bytes/plain_number.hpp"

namespace circumspect::formats {

// Walks over whole lines; bytes have the same meaning as for Lines.
class PlainTokens {
 public:
  // Requires: the text is empty or its last byte is '\n'.
  PlainTokens(const char* begin, const char* end) : at_(begin), end_(end) {}

  bool at_end() const { return at_ == end_; }
  const char* at() const { return at_; }

  // Goes past the end of this line if only blanks and a comment remain on it.
  bool skip_line_end() {
    skip_blanks();
    if (*at_ == '#') at_ = static_cast<const char*>(std::memchr(at_, '\n', bytes_left()));
    if (*at_ != '\n') return false;
    ++at_;
    return true;
  }

  // Plain ones (plain_number.hpp).
  bool integer(std::int64_t& value) {
    skip_blanks();
    return ends_at(read_plain_integer(at_, end_, value));
  }
  bool number(double& value) {
    skip_blanks();
    return ends_at(read_plain_decimal(at_, end_, value));
  }

 private:
  static bool is_blank(char c) { return is_space(c) && c != '\n'; }
  static bool ends_token(char c) { return is_space(c) || c == '#'; }

  std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - at_); }

  void skip_blanks() {
    while (is_blank(*at_)) ++at_;
  }

  // Goes there, if a token ends there.
  bool ends_at(const char* stop) {
    if (stop == nullptr || !ends_token(*stop)) return false;
    at_ = stop;
    return true;
  }

  const char* at_;
  const char* end_;
};

}  // namespace circumspect::formats
