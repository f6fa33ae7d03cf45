// The segments of a complex, split at more and more vertices.
// Book: Section 4.5.3 ("One can make it edge-protected by adding vertices on its segments").
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "reference/constrained/protecting_shells.hpp"

namespace circumspect::constrained {

// A part of a segment between successive vertices on it.
struct Subsegment {
  std::size_t segment = 0;  // its place in the original complex
  std::size_t place = 0;    // how many vertices of the segment's interior come before it
  Simplex edge;             // its ends, ascending
};

// A vertex that was added to a segment: (1 − parameter) · first end + parameter · second end.
struct PointOnSegment {
  Vertex vertex;
  std::size_t segment;  // its place in the original complex
  Rational parameter;   // strictly between 0 and 1

  bool operator==(const PointOnSegment&) const = default;
};

// A vertex that was added in the relative interior of a polygon.
struct PointInPolygon {
  Vertex vertex;
  std::size_t polygon;

  bool operator==(const PointInPolygon&) const = default;
};

// So many Steiner points did not suffice. That says nothing about whether more would.
struct SteinerLimitReached {
  std::size_t on_segments = 0;
  std::size_t in_polygons = 0;
};

// How subsegments are split so that it comes to an end: a subsegment one end of which is an acute
// end of its segment at a shell (see ProtectingShells); every other in its middle half, beside the
// nearest point that is in the way, or else in its middle. (J. R. Shewchuk, H. Si: segments that run
// closely along each other then get their vertices side by side, where those in the middle would not
// match, and would be in each other's way again and again. At acute ends this was tried as well: it
// takes fewer points in Chazelle's polyhedra, and more where many segments end in one vertex.)
class SplitSegments {
 public:
  // Refers to the complex. Requires: it is valid.
  explicit SplitSegments(const PiecewiseLinearComplex& complex);

  // Segment by segment, each from its first end to its second.
  std::vector<Subsegment> subsegments() const;

  // The parameter, on the whole segment, at which the subsegment should be split next: beside the
  // nearest to it of these points, or where it would be split without them.
  Rational where_to_split(const Subsegment& subsegment,
                          const std::vector<Point>& in_the_way = {}) const;
  Point point_at(std::size_t segment, const Rational& parameter) const;

  // Is the subsegment one that recovery never needs to split, because it has an acute end of its
  // segment for an end and is as short as the least shell there? (Points off the segments may need
  // it.)
  bool is_protected(const Subsegment& subsegment) const;

  // A vertex is now at this parameter of the segment. Requires: none was.
  void add(const PointOnSegment& point);
  // In the order in which they were added.
  const std::vector<PointOnSegment>& added() const { return added_; }

  // The complex whose segments are the subsegments: `points` are the original ones and all that
  // were added. Its polygons have what was added to their segments, and their own added points.
  PiecewiseLinearComplex augmented(const PointSet& points,
                                   const std::vector<PointInPolygon>& in_polygons = {}) const;

 private:
  struct Stop {
    Rational parameter;
    Vertex vertex;
  };
  std::vector<Simplex> edges_of(std::size_t segment) const;
  // Puts the subsegments in the place of its segments, and adds the vertices between them,
  // unsorted.
  void split_segments_of(Polygon& polygon) const;
  Rational squared_length_of(const Subsegment& subsegment) const;
  // An open interval of parameters.
  struct Interval {
    Rational low;
    Rational high;
  };
  // The part of its middle half in which a split keeps the nearest of the points out of the
  // diametral balls of both parts; nothing if none has its like there.
  std::optional<Interval> beside_nearest(const Subsegment& subsegment,
                                         const std::vector<Point>& in_the_way) const;

  const PiecewiseLinearComplex& complex_;
  ProtectingShells shells_;
  std::vector<std::vector<Stop>> stops_;  // by segment, ends included, in order
  std::vector<PointOnSegment> added_;
};

}  // namespace circumspect::constrained
