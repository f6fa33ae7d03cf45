// The header of a PLY file: which elements there are, how many, and of what they are made.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "oracle/formats/lines.hpp"
#include "oracle/formats/mixed_text.hpp"

namespace circumspect::formats {

// char, uchar, short, ushort, int, uint, float and double, or int8 … float64.
struct PlyType {
  enum class Kind { kSigned, kUnsigned, kFloating } kind = Kind::kSigned;
  std::size_t size = 0;  // in bytes
};

struct PlyProperty {
  std::string name;
  PlyType type;                       // of the value, or of each value of a list
  std::optional<PlyType> count = {};  // a list: of the number of its values, an integer
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties = {};
  // The place of a property of that name, list or not.
  std::optional<std::size_t> find(std::string_view property, bool is_list) const;
};

struct PlyHeader {
  std::optional<ByteOrder> binary = {};  // none: text
  std::vector<PlyElement> elements = {};
};

// Reads the header, so that the next line is the first behind it. Errors: among others, elements
// without properties, of which no file would tell how many there are.
Result<PlyHeader> read_ply_header(Lines& lines);

}  // namespace circumspect::formats
