#include "reference/kernel/piecewise_linear/breach.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace circumspect {
namespace {

constexpr std::array<BreachEntry, 12> kKinds = {{
    {BreachKind::kIndexOutOfRange, "plc.index-out-of-range", "an index names no vertex"},
    {BreachKind::kDuplicateVertex, "plc.duplicate-vertex", "two vertices are the same point"},
    {BreachKind::kDegenerateSegment, "plc.degenerate-segment",
     "a segment does not have two different ends"},
    {BreachKind::kDegeneratePolygon, "plc.degenerate-polygon",
     "the lines of a polygon repeat a vertex at once or enclose no area"},
    {BreachKind::kPolygonNotPlanar, "plc.polygon-not-planar",
     "a vertex of a polygon is off the plane of the others"},
    {BreachKind::kVertexInSegment, "plc.vertex-in-segment",
     "a vertex lies in the interior of a segment"},
    {BreachKind::kCrossingSegments, "plc.crossing-segments",
     "two segments cross in a point that is no vertex"},
    {BreachKind::kPolygonHoleSeed, "plc.polygon-hole-seed",
     "a hole seed of a polygon is off its plane, on its lines or in none of its holes"},
    {BreachKind::kSegmentPiercesPolygon, "plc.segment-pierces-polygon",
     "a segment goes through a polygon"},
    {BreachKind::kPolygonsCross, "plc.polygons-cross",
     "two polygons cross where they share no segment"},
    {BreachKind::kPolygonsOverlap, "plc.polygons-overlap",
     "two polygons of one plane have interior points in common"},
    {BreachKind::kHoleSeedOnWall, "plc.hole-seed-on-wall",
     "a hole seed lies on a polygon, or in the plane on a segment"},
}};

const BreachEntry& entry(BreachKind kind) {
  const auto found = std::find_if(kKinds.begin(), kKinds.end(),
                                  [&](const BreachEntry& one) { return one.kind == kind; });
  assert(found != kKinds.end());
  return *found;
}

}  // namespace

std::span<const BreachEntry> breach_kinds() { return kKinds; }
std::string_view identifier(BreachKind kind) { return entry(kind).identifier; }
std::string_view meaning(BreachKind kind) { return entry(kind).meaning; }

Rational offset_from_plane(const std::vector<Point>& plane, const Point& q) {
  const Point u = plane[1] - plane[0];
  const Point v = plane[2] - plane[0];
  const Point normal = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                        u[0] * v[1] - u[1] * v[0]};
  std::size_t greatest = 0;
  for (const std::size_t axis : {1u, 2u}) {
    if (abs(normal[axis]) > abs(normal[greatest])) greatest = axis;
  }
  assert(sign(normal[greatest]) != 0);
  return inner_product(normal, q - plane[0]) / normal[greatest];
}

}  // namespace circumspect
