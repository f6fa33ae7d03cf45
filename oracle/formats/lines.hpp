// The tokens of a text, line by line, and numbers on a line as all text formats write them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "oracle/formats/source.hpp"
#include "reference/kernel/exact/number.hpp"
#include "reference/kernel/exact/point.hpp"
#include "reference/kernel/predicates/configuration.hpp"

namespace circumspect::formats {

// ---- Lines ----
// The tokens of a text, line by line.

// A number of more characters is refused: exact arithmetic on it would outlast any patience. Every
// double has an exact decimal of fewer.
inline constexpr std::size_t kLongestNumber = 10000;

// The whole token as an integer: std::errc() if it is one and fits, result_out_of_range if it is
// one and does not fit 64 bits, invalid_argument otherwise.
std::errc parse_integer(std::string_view token, Vertex& value);

// The whole token as a number, refusing more than kLongestNumber characters.
tl::expected<Rational, NumberError> parse_number(std::string_view token, NumberReading reading);

// Walks over the lines that have tokens on them. Blanks separate tokens, '#' starts a comment, a
// carriage return is a blank, the last line needs no end, a byte order mark is skipped. All other
// bytes belong to tokens.
// Requires: the source outlives this object and the tokens.
class Lines {
 public:
  explicit Lines(const Source& source);

  // Goes to the next line with a token; false, with no tokens, if there is none.
  bool next();

  // The number of the current line, from 1; after the last, of the last line of the text.
  std::size_t line() const { return line_; }
  const std::vector<std::string_view>& tokens() const { return tokens_; }
  std::size_t size() const { return tokens_.size(); }
  // How many bytes follow the current line.
  std::size_t bytes_left() const { return rest_.size(); }
  const std::string& file() const { return source_.name; }

  // An error that names the file and the current line.
  tl::unexpected<FormatError> fail(std::string expected, std::string found) const;
  // The same where the token of a column is not what was expected.
  tl::unexpected<FormatError> fail_at(std::size_t column, std::string expected) const;

  // The token of a column, converted; `what` names it in the error. Requires: column < size().
  Result<Vertex> integer(std::size_t column, std::string_view what) const;
  Result<std::size_t> count(std::size_t column, std::string_view what) const;
  Result<Rational> number(std::size_t column, NumberReading reading) const;

  // `count` columns from column `first`. Requires: first + count <= size().
  Result<std::vector<Vertex>> integers(std::size_t first, std::size_t count,
                                       std::string_view what) const;
  Result<std::vector<Rational>> numbers(std::size_t first, std::size_t count,
                                        NumberReading reading) const;

 private:
  const Source& source_;
  std::string_view rest_;
  std::size_t line_ = 0;
  std::vector<std::string_view> tokens_;
};

// ---- Rows ----
// Numbers on a line, as all text formats write them.

// With blanks between them; numbers so that reading them as doubles gives the same ones.
std::string joined(const std::vector<Rational>& numbers);
std::string joined(const std::vector<Vertex>& indices);

}  // namespace circumspect::formats
