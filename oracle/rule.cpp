#include "oracle/rule.hpp"

#include <algorithm>
#include <array>

namespace circumspect {
namespace {

constexpr std::array kRules = {
    RuleEntry{Rule::kUnknownVertex, "triangulation.unknown-vertex",
              "a simplex has an index that names no point"},
    RuleEntry{Rule::kWrongDimension, "simplex.wrong-dimension",
              "a simplex has not one vertex more than the dimension of the points' affine hull"},
    RuleEntry{Rule::kRepeatedVertex, "simplex.repeated-vertex",
              "a simplex names the same vertex twice"},
    RuleEntry{Rule::kDegenerateSimplex, "simplex.degenerate",
              "the vertices of a simplex are affinely dependent: it is flat"},
    RuleEntry{Rule::kOrientation, "simplex.orientation",
              "two simplices list their vertices with opposite orientations"},
    RuleEntry{Rule::kDuplicateSimplex, "complex.duplicate-simplex",
              "two simplices have the same vertices"},
    RuleEntry{Rule::kFacetOverused, "complex.facet-overused",
              "a facet belongs to more than two simplices"},
    RuleEntry{Rule::kOverlap, "complex.overlap", "two simplices meet in more than a common face"},
    RuleEntry{Rule::kWrongNeighbor, "complex.wrong-neighbor",
              "the neighbour listed for a facet is not the simplex across it"},
    RuleEntry{Rule::kUnusedPoint, "triangulation.unused-point",
              "a point is a vertex of no simplex"},
    RuleEntry{Rule::kHullNotClosed, "triangulation.hull-not-closed",
              "a ridge of the boundary is not shared by exactly two boundary facets"},
    RuleEntry{Rule::kHullNotConvex, "triangulation.hull-not-convex",
              "a point lies beyond a boundary facet: part of the convex hull is not covered"},
    RuleEntry{Rule::kCoveredTwice, "triangulation.covered-twice",
              "a point of the interior of one simplex lies in another as well"},
    RuleEntry{Rule::kFacetNotLocal, "delaunay.facet-not-local",
              "a facet is not locally Delaunay: the apex on one side lies strictly inside the "
              "circumball on the other"},
    RuleEntry{Rule::kVertexInBall, "delaunay.vertex-in-ball",
              "a point lies strictly inside the circumball of a simplex"},
    RuleEntry{Rule::kVertexSubmerged, "weighted.vertex-submerged",
              "a vertex lies strictly above the lower hull of the lifted points: it must not be a "
              "vertex"},
    RuleEntry{Rule::kPointBelowPlane, "weighted.point-below-plane",
              "a lifted point lies strictly below the witness plane of a simplex"},
};

const RuleEntry& entry(Rule rule) {
  return *std::find_if(kRules.begin(), kRules.end(),
                       [rule](const RuleEntry& candidate) { return candidate.rule == rule; });
}

}  // namespace

std::span<const RuleEntry> rules() { return kRules; }
std::string_view identifier(Rule rule) { return entry(rule).identifier; }
std::string_view meaning(Rule rule) { return entry(rule).meaning; }

}  // namespace circumspect
