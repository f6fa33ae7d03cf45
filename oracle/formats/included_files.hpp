// Decks that are spread over files: each line that names a file is replaced by the lines of that
// file, and errors still name the file and the line where a fault is.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/bytes/text_lines.hpp"

namespace circumspect::formats {

// What a statement of a deck includes.
struct Inclusion {
  std::string path;       // as it is written, without quotes
  std::string rest = {};  // the line that remains in place of the statement, before the file
  std::size_t lines = 1;  // of the statement
};

// What the statement at the current line includes; nothing if it includes nothing.
using InclusionAt = std::optional<Inclusion> (*)(TextLines lines);

// A deck and all that it includes, as one text. A path is relative to the file that names it or,
// as programs that run in the folder of the deck read it, to the deck. What cannot be included is
// left in the text; if a reader comes to it, at_its_place says why it is there.
class Deck {
 public:
  // A text with a file in it twice is longer than its files are: from `most_repeated` bytes on,
  // none is included again. Requires: the source outlives this object.
  Deck(const Source& first, InclusionAt inclusion_at,
       std::size_t most_repeated = std::size_t{1} << 28);

  const Source& source() const { return has_included() ? all_ : first_; }
  bool has_included() const { return files_.size() > 1; }
  // The same error with the file and the line that stand at this line of source().
  FormatError at_its_place(FormatError error) const;

 private:
  // Lines of a file that follow one another in the text, too.
  struct Piece {
    std::size_t begin = 0;  // the first in the text, counted from 1
    std::size_t file = 0;
    std::size_t line = 0;  // the first in the file
  };
  struct Failure {
    std::size_t line = 0;  // in the text
    FormatError error;
  };

  // Appends a file, and what it includes, to the text.
  void append(const Source& source, InclusionAt inclusion_at);
  void append_line(std::string_view line);
  // The file that is meant, or why it cannot be included.
  Result<Source> load_included(const std::string& path, const TextLines& from) const;

  const Source& first_;
  std::size_t most_repeated_;
  Source all_;
  std::size_t lines_ = 0;  // of the text
  std::vector<std::string> files_;
  std::vector<Piece> pieces_;
  std::vector<Failure> failures_;  // in the order of their lines
  std::vector<std::string> open_;  // files that are being read, the innermost last
};

}  // namespace circumspect::formats
