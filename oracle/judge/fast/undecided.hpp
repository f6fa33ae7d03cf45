// Why the fast judge left a mesh to the checkers of oracle/judge/points.
#pragma once

#include <string_view>

namespace circumspect::fast {

// The first condition that was not met, or what the fast judge does not handle. It is no verdict: what
// is wrong, if anything, is for oracle/judge/points to say.
enum class Undecided {
  kEmpty,              // no simplices
  kTooLarge,           // too many simplices to match their facets
  kNotFinite,          // coordinates or weights
  kUnknownVertex,      // an index that names no point
  kFlatSimplex,        // orientation zero: repeated vertices, or a set of a lower dimension
  kFacetOverused,      // three simplices with one facet
  kUnmatchedNeighbor,  // a link that leads nowhere, or is not returned, or to another facet
  kSameSide,           // two simplices on the same side of a facet
  kFacetNotLocal,      // a facet that is not locally Delaunay
  kCoveredTwice,       // the sample point is in a second simplex
  kBeyondHullFacet,    // it is not strictly on the inner side of a boundary facet
  kHullNotConvex,      // a reflex angle at a ridge of the boundary
  kUnusedPoint,        // a point that is not a vertex, and may not be so, or is not covered
  kEqualPoints,        // a point that is not a vertex equals another
  kPointBelowPlane,    // a point that is not a vertex is below the witness plane
};

std::string_view description(Undecided reason);

}  // namespace circumspect::fast
