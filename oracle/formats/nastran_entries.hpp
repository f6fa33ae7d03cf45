// The entries of Nastran's bulk data, whichever way their fields are written.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "kernel/predicates/configuration.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/bytes/text_lines.hpp"

namespace circumspect::formats {

// One entry: "GRID", and what is in the fields behind its name, without blanks.
struct NastranEntry {
  struct Field {
    std::string text;  // empty if there is nothing
    std::size_t line = 0;
  };
  std::string name;  // in capitals, without the star
  std::vector<Field> fields;
  std::size_t line = 0;  // of the name
};

class NastranEntries {
 public:
  // Requires: as for TextLines.
  explicit NastranEntries(const Source& source);

  // Goes to the next entry; false at ENDDATA, or at the end.
  bool next();
  const NastranEntry& entry() const { return entry_; }

  // The field of the entry as an integer or as a number, such as 1.5-3; nothing if it is empty.
  Result<std::optional<Vertex>> integer(std::size_t place, std::string_view what) const;
  Result<std::optional<Rational>> number(std::size_t place, NumberReading reading) const;
  // An error at a field, or at the end of the file.
  tl::unexpected<FormatError> fail_at(std::size_t place, std::string expected) const;
  tl::unexpected<FormatError> fail_at_end(std::string expected) const;

 private:
  // Goes to the next line that is not a comment and not empty; false at the end.
  bool next_line();
  bool continues() const;
  // Adds the fields of the current line to the entry.
  void add_fields();

  TextLines lines_;
  std::string text_;       // the line without its comment; blanks in place of tabs
  bool is_there_ = false;  // has the line still to be read?
  NastranEntry entry_;
};

}  // namespace circumspect::formats
