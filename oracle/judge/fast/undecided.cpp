#include "oracle/judge/fast/undecided.hpp"

namespace circumspect::fast {

std::string_view description(Undecided reason) {
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
