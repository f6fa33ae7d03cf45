#include "oracle/model/rule.hpp"

#include <algorithm>
#include <array>

namespace circumspect {
namespace {

constexpr std::array kRules = {
    RuleEntry{Rule::kUnknownVertex, "triangulation.unknown-vertex",
              "a simplex has an index that names no point"},
    RuleEntry{
        Rule::kWrongDimension, "simplex.wrong-dimension",
        "the number of vertices of a simplex is not one more than the dimension of the points' "
        "affine hull"},
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
    RuleEntry{Rule::kDomainVertexMissing, "domain.vertex-missing",
              "a vertex of the domain is not a vertex of the simplices of the mesh around it"},
    RuleEntry{Rule::kSteinerForbidden, "domain.steiner-forbidden",
              "a vertex of the mesh is not a vertex of the domain, and the claim allows none"},
    RuleEntry{Rule::kVertexInEdge, "domain.vertex-in-edge",
              "a vertex of the mesh lies on a segment of the domain inside an edge of the mesh"},
    RuleEntry{Rule::kSegmentMissing, "domain.segment-missing",
              "a segment of the domain is not a union of edges of the mesh"},
    RuleEntry{Rule::kPolygonNotTiled, "domain.polygon-not-tiled",
              "a polygon of the domain is not a union of triangles of the mesh"},
    RuleEntry{Rule::kImagesMeet, "domain.images-meet",
              "under --within, the images of two cells of the domain share faces of the mesh that "
              "are not the image of a common face, or the polygons around a segment are in another "
              "order"},
    RuleEntry{Rule::kUncovered, "domain.uncovered",
              "part of the domain is covered by no simplex of the mesh"},
    RuleEntry{Rule::kOutside, "domain.outside",
              "a simplex of the mesh lies, at least in part, outside the domain"},
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
    RuleEntry{Rule::kNoEmptyBall, "delaunay.no-empty-ball",
              "every open circumball of a dangling simplex contains a vertex"},
    RuleEntry{Rule::kConstrainedFacetNotLocal, "cdt.facet-not-local",
              "a facet that lies in no wall of the domain is not locally Delaunay: the apex on one "
              "side lies strictly inside the circumball on the other"},
    RuleEntry{Rule::kVisibleVertexInBall, "cdt.visible-vertex-in-ball",
              "a vertex that is visible from a simplex lies strictly inside its circumball"},
    RuleEntry{Rule::kDanglingNotDelaunay, "cdt.dangling-not-delaunay",
              "a vertex that is visible from a dangling triangle, in their plane, lies strictly "
              "inside its circumdisk"},
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
