// Points as files hold them, and which of their numbers are weights.
#pragma once

#include <string>
#include <vector>

#include "kernel/exact/number.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/point_file.hpp"

namespace circumspect::formats {

struct RawPoints {
  PointFile points;
  std::vector<Rational> weights = {};  // empty, or one a point
  std::string name = {};               // of the file, for messages
};

// Which weights the points of a file have.
enum class Weights {
  kNone,      // none, whatever the file has
  kListed,    // what the file names weights: the key "weights" of JSON
  kDemanded,  // these, or the first attributes of .node, as with TetGen's option -w; it is an error
              // if there are none
};

// One weight a point, or none at all.
Result<std::vector<Rational>> weights_of(RawPoints& points, Weights which);

}  // namespace circumspect::formats
