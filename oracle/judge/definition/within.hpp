// By how much must the cells of a complex P be moved to be unions of faces of a mesh M?
// docs/theory/within.md, Definition 1 and "The reach".
#pragma once

#include <optional>

#include "oracle/judge/definition/cell_images.hpp"

namespace circumspect::definition {

struct LeastReach {
  // kNone: no reach up to the limit will do, and `breach` is what is wrong at the largest.
  // kAmbiguous: nor will one, but there were ambiguous reaches, which were passed over.
  enum class Kind { kFound, kNone, kAmbiguous };
  Kind kind = Kind::kNone;
  Rational squared_reach = 0;
  CellImages images = {};
  Carriers carriers = {};
  std::optional<Violation> breach = {};
};

// The least reach up to a limit that is not ambiguous and at which all cells have images. Carriers,
// and with them images, change only at distances between a vertex and a cell, so these are all
// tried.
// Requires: as cell_images.
LeastReach least_reach(const MovedDomain& moved, const Rational& squared_limit);

// The greatest number of triangles near one polygon at that reach: all sets of them are tried.
std::size_t most_triangles_near(const MovedDomain& moved, const Rational& squared_reach);

}  // namespace circumspect::definition
