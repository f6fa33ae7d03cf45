// The form that the files of Triangle and TetGen share: a header that begins with a count, then
// that many lines, each beginning with its index. Indices go up by one from whatever the first is.
// Some files hold several such lists.
#pragma once

#include <cstddef>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/predicates/configuration.hpp"
#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/bytes/source.hpp"

namespace circumspect::formats {

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
