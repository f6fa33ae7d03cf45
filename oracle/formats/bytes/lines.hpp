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
#include "kernel/exact/point.hpp"
#include "kernel/predicates/configuration.hpp"
#include "oracle/formats/bytes/plain_number.hpp"
#include "oracle/formats/bytes/point_rows.hpp"
#include "oracle/formats/bytes/source.hpp"

namespace circumspect::formats {

// Is the token this word, in letters of any case? Requires: the word is in small letters.
bool is_word(std::string_view token, std::string_view word);

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

// The form that the files of Triangle and TetGen share: a header that begins with a count, then
// that many lines, each beginning with its index. Indices go up by one from whatever the first is.
// Some files hold several such lists.
class NumberedLines {
 public:
  // `one` and `many` name the content of a line: "point", "points". Requires: as for Lines.
  NumberedLines(const Source& source, std::string one, std::string many);

  // Reads the header and its count, and checks how many numbers it has. `layout` describes it in
  // errors.
  Status read_header(const std::string& layout, std::size_t fewest, std::size_t most);
  // A further number of the header; 0 if it was left out. Requires: no line was read yet.
  Result<std::size_t> header_count(std::size_t column, std::string_view what) const;

  // The same where another list may follow or be missing: false if the text ends before a header.
  Result<bool> read_optional_header(const std::string& layout, std::size_t fewest,
                                    std::size_t most);
  // Goes on to the next list of the same file, whose header is still to be read.
  void begin_list(std::string one, std::string many);
  // Nothing refers to the indices of this list, so any integers are allowed.
  void allow_any_index() { any_index_ = true; }

  // How many columns every line has, its index among them; `meaning` explains them in errors.
  void expect_columns(std::size_t columns, std::string meaning);

  // The number of columns is not known yet: the first line may have any.
  void allow_any_columns() { columns_ = 0; }

  // Goes to the next line and checks its index and its number of columns. False after the last
  // one, when nothing follows it. Too few lines and too many are errors.
  Result<bool> next();
  // The same if something may follow the last line.
  Result<bool> next_in_list();
  // Requires that nothing follows.
  Status expect_end();

  const Lines& lines() const { return lines_; }
  Lines& lines() { return lines_; }
  // The count in the header.
  std::size_t count() const { return count_; }
  // The index of the first line; 0 if there is none.
  Vertex first_index() const { return first_index_; }
  // How many lines are still to come, as far as the header and the size of the text agree: safe to
  // reserve memory for.
  std::size_t lines_at_most() const;

 private:
  Status read_count(const std::string& layout, std::size_t fewest, std::size_t most);
  Status check_index();

  Lines lines_;
  std::string one_;
  std::string many_;
  std::string meaning_;
  std::size_t columns_ = 1;
  std::size_t count_ = 0;
  std::size_t done_ = 0;
  Vertex first_index_ = 0;
  bool any_index_ = false;
};

// One line a row: its index, counted from `first_index`, and its numbers.
void write_numbered(std::ostream& out, Vertex first_index,
                    const std::vector<std::vector<Vertex>>& rows);

}  // namespace circumspect::formats
