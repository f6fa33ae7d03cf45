// By how much must the cells of a complex P be moved to be unions of faces of a mesh M?
// docs/theory/within.md, Definition 1 and "The reach".
#pragma once

#include <optional>

#include <tl/expected.hpp>

#include "oracle/judge/definition/cell_images.hpp"

namespace circumspect::definition {

struct LeastReach {
  Rational squared_reach;
  CellImages images;
  Carriers carriers;
};

// The least reach up to a limit that is not ambiguous and at which all cells have images; or what
// is wrong at the largest; or neither, if there were ambiguous reaches, which were passed over.
// Carriers, and with them images, change only at distances between a vertex and a cell, so these
// are all tried.
// Requires: as cell_images.
tl::expected<LeastReach, std::optional<Violation>> least_reach(const MovedDomain& moved,
                                                               const Rational& squared_limit);

// The greatest number of triangles near one polygon at that reach: all sets of them are tried.
std::size_t most_triangles_near(const MovedDomain& moved, const Rational& squared_reach);

}  // namespace circumspect::definition
