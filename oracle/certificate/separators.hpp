// Planes, in the plane lines, that part a way from convex sets; and where such a way may begin.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "kernel/exact/point.hpp"

namespace circumspect::certificate {

// What of u is perpendicular to v, times a positive number; u itself if v is 0.
Point perpendicular(const Point& u, const Point& v);

// So many planes <normal, p> = offset; each is a space, the normal, and the offset, all of them
// integers.
struct Separators {
  std::size_t count = 0;
  std::string words = "";
};

// For each part, the convex hull of one to three integer points, a plane with the part on one side,
// or in it, and the way from a to b strictly on the other; b may be in it unless `with_end`.
// Nothing if none was found: with `with_end` the way then meets a part.
std::optional<Separators> separators(const std::vector<std::vector<Point>>& parts, const Point& a,
                                     const Point& b, bool with_end);

// Some points of what has these corners, none of them a corner.
std::vector<Point> samples(const std::vector<Point>& corners);
// Integers: the axes, and what is perpendicular to the facets of a simplex, or leads from its
// corners to the point.
std::vector<Point> directions_from(const std::vector<Point>& simplex, const Point& start);

}  // namespace circumspect::certificate
