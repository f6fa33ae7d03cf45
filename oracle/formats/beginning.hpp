// What the first lines of a file tell about its format.
#pragma once

#include <cstddef>
#include <string_view>

#include "oracle/formats/bytes/source.hpp"

namespace circumspect::formats {

// The file has to outlive this.
struct Beginning {
  explicit Beginning(const Source& source);

  // Is the first token a number? Also true for a file without tokens.
  bool is_number() const;
  // Is there a point on each line, from the first on, and no header?
  bool is_list() const;

  std::string_view text;  // of the whole file
  // Of the first two lines with tokens.
  std::string_view first_token = {};
  std::string_view second_token = {};
  std::size_t on_first_line = 0;
  std::size_t on_second_line = 0;
  // If the first line is the header of a .node file.
  std::size_t columns_announced = 0;
  // Does the user say which points a mesh is about? A list of simplices is one only then.
  bool has_points = false;
};

// Is the first character that is not a blank or a byte order mark this one?
bool begins_with(std::string_view text, char c);

}  // namespace circumspect::formats
