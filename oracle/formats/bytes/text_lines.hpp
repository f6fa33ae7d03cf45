// A text line by line, where the place of a character on its line matters: columns, empty fields.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "oracle/formats/bytes/source.hpp"
#include "oracle/model/words.hpp"

namespace circumspect::formats {

class TextLines {
 public:
  // A byte order mark is skipped. Requires: the source outlives this object and the lines.
  explicit TextLines(const Source& source);

  // Goes to the next line; false at the end.
  bool next();
  // Without its end; empty before the first line and after the last.
  std::string_view text() const { return text_; }
  // From 1; after the last, the number of the last.
  std::size_t line() const { return line_; }
  std::size_t bytes_left() const { return rest_.size(); }
  const std::string& file() const { return source_.name; }

  // An error that names the file and the current line.
  tl::unexpected<FormatError> fail(std::string expected, std::string found) const;

 private:
  const Source& source_;
  std::string_view rest_;
  std::string_view text_;
  std::size_t line_ = 0;
};

}  // namespace circumspect::formats
