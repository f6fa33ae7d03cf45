// Numbered rows of plain numbers, as programs write them below the header of a file of Triangle or
// TetGen, read by several threads. Anything that is not exactly of that form is left to
// NumberedLines, which reads it or says what is wrong with it: here that is not an error, but there
// is no answer.
//
// There are two readers of rows and not one because they keep different things. This one has a
// block of the file at a time, in each thread, and no line numbers: a message needs the line of the
// first fault of the file, so all blocks before it. That one keeps the whole text, exact numbers,
// labels and the line of each row, which takes several times the memory and the time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "kernel/predicates/configuration.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/plain_tokens.hpp"

namespace circumspect::formats {

// The whole lines at the beginning of a file, among them its header. Nothing if the file no longer
// has them.
std::optional<Source> beginning_of(const RandomAccess& file);

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

}  // namespace circumspect::formats
