// Points, weights, simplices and faces in our own JSON; docs/formats.md has the schema.
#pragma once

#include <ostream>
#include <vector>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/point_file.hpp"

namespace circumspect::formats {

// The version of the schema that is read and written.
inline constexpr int kJsonSchemaVersion = 1;

struct JsonFile {
  PointFile points;
  std::vector<Rational> weights = {};  // empty, or one a point
  bool has_simplices = false;          // a list may be there and empty
  SimplexFile simplices = {};          // indices of points and of simplices begin at first_index
  // Faces listed beside the simplices, with at most as many vertices as there are coordinates: for
  // a mesh of a domain, those that are faces of no simplex.
  SimplexFile faces = {};
};

// Numbers are read exactly as written, with or without quotes; without quotes JSON has no
// fractions, and numbers beyond the range of double are refused. Keys that the schema does not know
// are errors, so that a misspelt one does not go unnoticed.
Result<JsonFile> read_json(const Source& source, NumberReading reading);

// Coordinates and weights are numbers if they are doubles, else strings. Attributes and markers are
// not written. Requires: all points have `dimension` coordinates, from 1 to kLargestDimension;
// weights are empty or one a point; no face has more than `dimension` vertices.
void write_json(std::ostream& out, const JsonFile& file);

}  // namespace circumspect::formats
