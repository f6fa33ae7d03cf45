// The rules that a mesh can break: stable identifiers. The list grows; an identifier never changes
// its meaning.
#pragma once

#include <span>
#include <string_view>

namespace circumspect {

enum class Rule {
  kUnknownVertex,
  kWrongDimension,
  kRepeatedVertex,
  kDegenerateSimplex,
  kOrientation,
  kDuplicateSimplex,
  kFacetOverused,
  kOverlap,
  kWrongNeighbor,
  kUnusedPoint,
  kHullNotClosed,
  kHullNotConvex,
  kCoveredTwice,
  kDomainVertexMissing,
  kSteinerForbidden,
  kVertexInEdge,
  kSegmentMissing,
  kPolygonNotTiled,
  kImagesMeet,
  kUncovered,
  kOutside,
  kFacetNotLocal,
  kVertexInBall,
  kVertexSubmerged,
  kPointBelowPlane,
  kNoEmptyBall,
  kConstrainedFacetNotLocal,
  kVisibleVertexInBall,
  kDanglingNotDelaunay,
};

struct RuleEntry {
  Rule rule;
  std::string_view identifier;  // "delaunay.facet-not-local"
  std::string_view meaning;     // what is wrong when it is broken, one clause
};

// All rules, in the order in which they are judged.
std::span<const RuleEntry> rules();

std::string_view identifier(Rule rule);
std::string_view meaning(Rule rule);

}  // namespace circumspect
