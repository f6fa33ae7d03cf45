// The reason why the fast judge left a mesh to the checkers of oracle/judge/points.
#pragma once

#include <string_view>

namespace circumspect::fast {

// The first condition that was not met, or what the fast judge does not handle. It is not a
// verdict: oracle/judge/points says what is wrong, if anything.
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

// In words, as Course::why_not_fast gives it (verdict.hpp).
inline std::string_view description(Undecided reason) {
  switch (reason) {
    case Undecided::kEmpty:
      return "no simplices";
    case Undecided::kTooLarge:
      return "too many simplices";
    case Undecided::kNotFinite:
      return "a number that is not finite";
    case Undecided::kUnknownVertex:
      return "an index that names no point";
    case Undecided::kFlatSimplex:
      return "a flat simplex";
    case Undecided::kFacetOverused:
      return "a facet of more than two simplices";
    case Undecided::kUnmatchedNeighbor:
      return "a neighbour that does not match";
    case Undecided::kSameSide:
      return "two simplices on the same side of a facet";
    case Undecided::kFacetNotLocal:
      return "a facet that is not locally Delaunay";
    case Undecided::kCoveredTwice:
      return "a sample point that is covered twice";
    case Undecided::kBeyondHullFacet:
      return "a sample point beyond a boundary facet";
    case Undecided::kHullNotConvex:
      return "a boundary that is not convex";
    case Undecided::kUnusedPoint:
      return "a point that is not a vertex";
    case Undecided::kEqualPoints:
      return "equal points";
    case Undecided::kPointBelowPlane:
      return "a point below a witness plane";
  }
  return "";
}

}  // namespace circumspect::fast
