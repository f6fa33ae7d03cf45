// The tokens of a text, line by line, and numbers on a line as all text formats write them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "kernel/exact/point.hpp"
#include "kernel/predicates/configuration.hpp"
#include "oracle/formats/bytes/plain_number.hpp"
#include "oracle/formats/bytes/point_rows.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/model/words.hpp"

namespace circumspect::formats {

// The whole token as an integer: std::errc() if it is one and fits, result_out_of_range if it is
// one and does not fit 64 bits, invalid_argument otherwise.
std::errc parse_integer(std::string_view token, Vertex& value);

// A count that a file states. If std::size_t has 32 bits, a count above 2^31 − 1 is replaced by
// 2^31 − 1, so that a little may be added to it without overflow: no such file exists, and the
// reader finds that it ends too early. Requires: value >= 0.
constexpr std::size_t count_of(Vertex value) {
  return static_cast<std::size_t>(std::min<std::uint64_t>(
      static_cast<std::uint64_t>(value), std::numeric_limits<std::size_t>::max() / 2));
}

// The whole token as a number, refusing more than kLongestNumber characters.
tl::expected<Rational, NumberError> parse_number(std::string_view token, NumberReading reading);

// Walks over the lines that have tokens on them. Blanks separate tokens, '#' starts a comment, a
// carriage return is a blank, the last line needs no end, a byte order mark is skipped. All other
// bytes belong to tokens. `end`: the character that ends a line; if that is a carriage return, it
// is not a blank. `comment`: what starts a comment instead of '#'. Requires: the source outlives
// this object and the tokens.
class Lines {
 public:
  explicit Lines(const Source& source, char end = '\n', char comment = '#');

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
  // The same for a token of a column that is not what was expected.
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

  // Nothing unless the token is a plain integer (plain_number.hpp).
  std::optional<Vertex> plain_integer(std::size_t column) const;

  // The same without memory of their own: integers replace what is in a list, and coordinates are
  // added to points.
  Status integers(std::size_t first, std::size_t count, std::string_view what, Simplex& to) const;
  Status add_numbers(std::size_t first, std::size_t count, NumberReading reading,
                     PointRows& to) const;
  // The columns are numbers.
  Status check_numbers(std::size_t first, std::size_t count, NumberReading reading) const;

 private:
  const Source& source_;
  std::string_view rest_;
  char end_;
  char comment_;
  std::size_t line_ = 0;
  std::vector<std::string_view> tokens_;
};

// Writes rows separated by blanks; reading the numbers as doubles gives the same numbers.
std::string joined(const std::vector<Rational>& numbers);
std::string joined(const std::vector<Vertex>& indices);

}  // namespace circumspect::formats
