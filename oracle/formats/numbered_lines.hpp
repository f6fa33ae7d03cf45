// What the files of Triangle and TetGen have in common: a header that begins with a count, then
// that many lines, each beginning with its index. Indices go up by one from whatever the first is.
#pragma once

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

#include "oracle/formats/lines.hpp"

namespace circumspect::formats {

class NumberedLines {
 public:
  // `one` and `many` name what stands on a line: "point", "points". Requires: as for Lines.
  NumberedLines(const Source& source, std::string one, std::string many);

  // Reads the header and its count, and checks how many numbers stand in it. `layout` describes it
  // in errors.
  Status read_header(const std::string& layout, std::size_t fewest, std::size_t most);
  // A further number of the header; 0 if it was left out. Requires: no line was read yet.
  Result<std::size_t> header_count(std::size_t column, std::string_view what) const;

  // How many columns every line has, its index among them; `meaning` explains them in errors.
  void expect_columns(std::size_t columns, std::string meaning);

  // Goes to the next line and checks its index and its number of columns. False after the last
  // one, when nothing follows it. Too few lines and too many are errors.
  Result<bool> next();

  const Lines& lines() const { return lines_; }
  // The index of the first line; 0 if there is none.
  Vertex first_index() const { return first_index_; }
  // How many lines are still to come, as far as the header and the size of the text agree: safe to
  // reserve memory for.
  std::size_t lines_at_most() const;

 private:
  Status check_index();

  Lines lines_;
  std::string one_;
  std::string many_;
  std::string meaning_;
  std::size_t columns_ = 1;
  std::size_t count_ = 0;
  std::size_t done_ = 0;
  Vertex first_index_ = 0;
};

// One line a row: its index, counted from `first_index`, and its numbers.
void write_numbered(std::ostream& out, Vertex first_index,
                    const std::vector<std::vector<Vertex>>& rows);

}  // namespace circumspect::formats
