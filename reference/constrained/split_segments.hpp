// The segments of a complex, split at more and more vertices, and the choice of these near acute
// angles. Book: Section 4.5.3, Exercise 6 of Chapter 4.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "kernel/boxes/box_index.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect::constrained {

// Where to split a segment near a vertex at which segments meet in an acute angle.
// Book: Section 4.5.3, Exercise 6 of Chapter 4.

// A vertex v is narrow if two of its segments make an angle there with a cosine above 1/4; if there
// is no such angle, halving works as well (see steiner_cdt.hpp). At a narrow vertex, two
// subsegments va and vb of segments that meet at an angle θ < 90° stay out of each other's
// diametral balls if they are equally long. (Those with θ ≥ 90° do at any length.) So segments are
// split on spheres about v, the shells, with radii 2^k. (J. Ruppert, "A Delaunay refinement
// algorithm for quality 2-dimensional mesh generation", J. Algorithms 18, 1995.)
//
// Equal lengths are irrational. But b is in the closed diametral ball of va iff |vb| ≤ |va| cos θ;
// so it is enough if the lengths lie between 2^k and 2^k √m, where m cos² θ < 1 for all acute
// angles θ at v. The squares of these bounds are rational. Segments are split at the fraction
// between them that has the least power of two for its denominator: coordinates that are doubles
// stay dyadic.
class ProtectingShells {
 public:
  // Refers to the complex. Requires: it is valid.
  explicit ProtectingShells(const PiecewiseLinearComplex& complex);

  // Is this end of the segment narrow, and does it make an acute angle with another there?
  bool is_acute(std::size_t segment, Vertex apex) const;

  // Where to split a subsegment that begins at the acute end v of a segment, as a fraction of the
  // whole segment as seen from v. The shell is the one with radius 2^k between a third and two
  // thirds of the length, but never smaller than the least shell of v, which is at most a quarter
  // as large as the distance of v from all vertices and all segments that do not end at v.
  // Requires: the subsegment is longer than √m times the least shell.
  Rational where_to_split(std::size_t segment, Vertex apex, const Rational& squared_length) const;

  // The squared radius of the least shell of a vertex; the bound m.
  Rational squared_least_shell(Vertex apex) const;
  Rational squared_width(Vertex apex) const { return around(apex).squared_width; }

 private:
  struct Apex {
    std::set<std::size_t> acute;  // the segments that make acute angles here
    Rational squared_width;       // m
    long least_shell = 0;         // its k
  };
  const Apex& around(Vertex apex) const;
  // Looks at all pairs of segments at the apex, in quadratic time.
  void measure_angles(Vertex apex, Apex& around) const;
  Rational squared_distance_to_others(Vertex apex) const;

  const PiecewiseLinearComplex& complex_;
  std::vector<std::vector<std::size_t>> segments_at_;  // by vertex
  BoxIndex boxes_;                                     // of the segments, then of the vertices
  mutable std::map<Vertex, Apex> apexes_;              // computed on demand
};

// The segments of a complex, split at more and more vertices.
// Book: Section 4.5.3 ("One can make it edge-protected by adding vertices on its segments").

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

// So many Steiner points did not suffice; more might.
struct SteinerLimitReached {
  std::size_t on_segments = 0;
  std::size_t in_polygons = 0;
};

// Where subsegments are split so that the process ends: a subsegment with an acute end of its
// segment is split at a shell (see ProtectingShells); every other one in its middle half, beside
// the nearest point that is in the way, or else in its middle. (J. R. Shewchuk, H. Si: segments
// that run closely along each other then get their vertices side by side, where those in the middle
// would not match, and would be in each other's way again and again. At acute ends this was tried
// as well: it takes fewer points in Chazelle's polyhedra, and more where many segments end in one
// vertex.)
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

  // Is the subsegment one that recovery never needs to split, because it begins at an acute end of
  // its segment and is as short as the least shell there? (Points off the segments may need it.)
  bool is_protected(const Subsegment& subsegment) const;

  // Records a new vertex at this parameter of the segment. Requires: there was none.
  void add(const PointOnSegment& point);
  // In the order in which they were added.
  const std::vector<PointOnSegment>& added() const { return added_; }

  // The complex whose segments are the subsegments: `points` are the original ones and all that
  // were added. Its polygons have the vertices added to their segments, and their own added points.
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
  // diametral balls of both parts; nothing if no point leaves such a part.
  std::optional<Interval> beside_nearest(const Subsegment& subsegment,
                                         const std::vector<Point>& in_the_way) const;

  const PiecewiseLinearComplex& complex_;
  ProtectingShells shells_;
  std::vector<std::vector<Stop>> stops_;  // by segment, ends included, in order
  std::vector<PointOnSegment> added_;
};

}  // namespace circumspect::constrained
