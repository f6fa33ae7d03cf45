// What a reader answers when a file is not what it should be: an error for people, in one line.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace circumspect::formats {

struct FormatError {
  std::string file;
  std::size_t line = 0;  // from 1; 0: the file as a whole
  std::string expected;
  std::string found;

  // "file:line: expected X, found Y": always one line, whatever bytes the parts hold.
  std::string to_string() const;
};

template <class T>
using Result = tl::expected<T, FormatError>;

// Success, or what is wrong.
using Status = Result<void>;

// Bytes of a file as a message may show them: in quotes, cut after kLongestQuote characters, and
// everything that is not printable ASCII written as \xNN.
inline constexpr std::size_t kLongestQuote = 40;
std::string quote(std::string_view bytes);

}  // namespace circumspect::formats
