// Files of Triangle and TetGen as programs write them, read at the speed of memory: tokens, rows,
// and whole files.
#pragma once

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <vector>

#include "kernel/predicates/configuration.hpp"
#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/model/index_lists.hpp"

namespace circumspect::formats {

// ---- Plain tokens ----
// The tokens of text as programs write it: plain integers and decimals. For anything else every
// function returns false, and reading the text again with Lines gives the message or the value. A
// token that is accepted here has exactly the value that Lines gives it.

// Walks over whole lines; bytes have the same meaning as for Lines.
class PlainTokens {
 public:
  // Bytes after the text that are loaded but never used.
  static constexpr std::size_t kPadding = 8;

  // Requires: the text is empty or its last byte is '\n'; kPadding bytes after it may be read.
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

  // An integer of at most 18 digits: [-]digits.
  bool integer(std::int64_t& value) {
    skip_blanks();
    const bool negative = *at_ == '-';
    if (negative) ++at_;
    std::int64_t magnitude = 0;
    if (!digits(magnitude)) return false;
    value = negative ? -magnitude : magnitude;
    return ends_token(*at_);
  }

  // A decimal: [-]digits[.digits][e[+-]digits], one of the two runs of digits perhaps empty. Its
  // value is the nearest double, as from strtod, but 0 for -0. Numbers that overflow are refused.
  // from_chars also accepts "inf" and "nan", which are not finite, and it stops within hexadecimal
  // floats and fractions, so these are refused too.
  bool number(double& value) {
    skip_blanks();
    const auto [stop, error] = std::from_chars(at_, end_, value);
    if (error != std::errc() || !std::isfinite(value) || !ends_token(*stop)) return false;
    if (static_cast<std::size_t>(stop - at_) > kLongestNumber) return false;
    value += 0.0;  // -0 becomes 0: equal points have equal bits
    at_ = stop;
    return true;
  }

 private:
  // Tab, line feed, vertical tab, form feed and carriage return are consecutive.
  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  static bool is_blank(char c) { return is_space(c) && c != '\n'; }
  static bool ends_token(char c) { return is_space(c) || c == '#'; }

  std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - at_); }

  void skip_blanks() {
    while (is_blank(*at_)) ++at_;
  }

  // 1 to 18 digits.
  bool digits(std::int64_t& value) {
    const char* const first = at_;
    if constexpr (std::endian::native == std::endian::little) eight_digits(value);
    while (true) {
      const unsigned digit = static_cast<unsigned char>(*at_) - static_cast<unsigned>('0');
      if (digit > 9 || at_ - first == 18) break;
      value = 10 * value + static_cast<std::int64_t>(digit);
      ++at_;
    }
    return at_ != first;
  }

  // Reads up to eight digits at once, without a branch on their number: the digits are shifted to
  // the upper end of a word, and the zeros shifted in act as leading zeros.
  void eight_digits(std::int64_t& value) {
    std::uint64_t word = 0;
    std::memcpy(&word, at_, sizeof word);
    word ^= 0x3030303030303030U;  // a digit becomes its value, anything else more than 9
    // The lowest byte above 9 has its high bit set; a carry affects only later bytes.
    const std::uint64_t others = ((word + 0x7676767676767676U) | word) & 0x8080808080808080U;
    const auto count = static_cast<unsigned>(std::countr_zero(others)) / 8;
    if (count == 0) return;
    word <<= 64 - 8 * count;
    word = 10 * word + (word >> 8U);  // pairs of digits, in every other byte
    const std::uint64_t upper = (word & 0x000000FF000000FFU) * 0x000F424000000064U;
    const std::uint64_t lower = (word >> 16U & 0x000000FF000000FFU) * 0x0000271000000001U;
    value = static_cast<std::int64_t>((upper + lower) >> 32U);
    at_ += count;
  }

  const char* at_;
  const char* end_;
};

// ---- Plain rows ----
// The files of Triangle and TetGen as programs write them: a header, then numbered rows, read by
// several threads. Anything that is not exactly of that form is left to NumberedLines, which reads
// it or says what is wrong with it: here that is not an error, but there is no answer.

// The numbers on the first line that has any.
struct PlainHeader {
  std::array<std::size_t, 4> numbers = {};  // those that are missing: 0
  std::size_t size = 0;                     // how many there are
  std::size_t end = 0;                      // where the next line begins
};
// Nothing unless there are 1 to 4 integers, 0 or more.
std::optional<PlainHeader> read_plain_header(const RandomAccess& file);

// A part of a file that one thread reads: whole lines, which hold the rows from `first` up to
// `last`.
struct PlainBlock {
  std::size_t begin = 0;  // bytes
  std::size_t end = 0;
  std::size_t first = 0;  // rows
  std::size_t last = 0;
};

// A mesh never has more columns.
inline constexpr std::size_t kMostPlainColumns = 1000;

// Small enough for a core's own cache, large enough that cutting costs nothing.
inline constexpr std::size_t kPlainBlock = std::size_t{1} << 18U;

struct PlainRows {
  Vertex first_index = 0;  // of the first row; 0 if there is none
  std::vector<PlainBlock> blocks = {};
};

// Divides the text after the header into blocks of about `block_size` bytes. The first row of a
// block is read from its first line, and is correct only if all blocks turn out to hold the rows
// that the plan says. Nothing if so few bytes cannot hold so many rows and columns: given a plan,
// it is safe to allocate memory for the count. Requires: columns, block_size > 0.
std::optional<PlainRows> plan_rows(const RandomAccess& file, std::size_t begin, std::size_t rows,
                                   std::size_t columns, std::size_t block_size);

// Calls `read_block` for each block with its text, from several threads (0: as many as the machine
// has), until one answers false. True if all of them answered true.
bool for_each_block(const RandomAccess& file, const PlainRows& rows, unsigned threads,
                    const std::function<bool(PlainTokens&, const PlainBlock&)>& read_block);

// Small enough for a core's own cache, large enough that cutting costs nothing.
inline constexpr std::size_t kBlockSize = std::size_t{1} << 18U;

// Reads the rows of a plan. `read_row(tokens, row)` reads the tokens after the index and returns
// false if they are not plain; it is called once for each row, from several threads. False if a row
// is not plain, not numbered one more than the row before, missing, or one too many: then some
// calls may be missing.
template <class ReadRow>
bool read_plain_rows(const RandomAccess& file, const PlainRows& rows, unsigned threads,
                     const ReadRow& read_row) {
  return for_each_block(file, rows, threads,
                        [&rows, &read_row](PlainTokens& tokens, const PlainBlock& block) {
                          std::size_t row = block.first;
                          while (!tokens.at_end()) {
                            if (tokens.skip_line_end()) continue;
                            std::int64_t index = 0;
                            if (row == block.last || !tokens.integer(index)) return false;
                            if (index != rows.first_index + static_cast<Vertex>(row)) return false;
                            if (!read_row(tokens, row) || !tokens.skip_line_end()) return false;
                            ++row;
                          }
                          return row == block.last;
                        });
}

// ---- Plain files ----
// .node, .ele and .neigh files as programs write them, read at the speed of memory into flat
// arrays. Files that are faulty or not of the plain form have no answer here: tetgen.hpp then reads
// them, or says what is wrong. An answer is always the same as that of tetgen.hpp with
// NumberReading::kDouble.

struct PlainReading {
  unsigned threads = 0;  // 0: as many as the machine has; the answer is the same for any number
  std::size_t block_size = kPlainBlock;
  PartOf part = {};  // of the rows; no others are read or checked
};

struct PlainPoints {
  Rows<double> coordinates = {};  // n × d, finite, without −0
  Rows<double> weights = {};      // n × 1, the first attributes; 0 × 0 if there are none
  Vertex first_index = 0;         // the user's index of the first point of the file
  std::size_t in_file = 0;        // how many points the file has
};

// Rows of indices: the vertices of simplices, or their neighbours.
template <class Index>
struct PlainIndices {
  Rows<Index> rows = {};    // m × (d + 1), counted from 0
  Vertex first_index = 0;   // the user's index of the first simplex of the file
  std::size_t in_file = 0;  // how many rows the file has
};

// As read_node.
std::optional<PlainPoints> read_plain_node(const RandomAccess& file,
                                           const PlainReading& reading = {});

// As read_ele, with `first_point`, the user's index of the first point, subtracted from each
// vertex. Some may name no point.
std::optional<PlainIndices<std::int32_t>> read_plain_ele(const RandomAccess& file,
                                                         Vertex first_point,
                                                         const PlainReading& reading = {});
// The same in 64 bits.
std::optional<PlainIndices<std::int64_t>> read_plain_wide_ele(const RandomAccess& file,
                                                              Vertex first_point,
                                                              const PlainReading& reading = {});

// As read_neigh, with the index of the first simplex subtracted from each; −1 stays −1, and no
// result is less.
std::optional<PlainIndices<std::int32_t>> read_plain_neigh(const RandomAccess& file,
                                                           const PlainReading& reading = {});

}  // namespace circumspect::formats
