// Joins polygons that lie nearly in one plane, so that only their union needs an image.
// docs/theory/within.md has the definition, and what it implies, under "Polygons that are not
// flat".
#pragma once

#include <optional>
#include <vector>

#include "oracle/domain/coplanar_polygons.hpp"

namespace circumspect::check {

// How flat joined polygons have to be.
struct Flatness {
  Rational squared_slope;     // the square of the tangent of the angle of two that share a segment
  Rational squared_distance;  // of each vertex from the plane of all
};

// A complex some of whose polygons are not flat: the plane of such a polygon is that of its first
// triangle. Of it `judge_within` alone knows what to make.
struct NearlyJoined {
  PiecewiseLinearComplex complex;
  std::vector<std::vector<std::size_t>> members;  // of each polygon, ascending
  std::size_t removed_segments = 0;
  Rational squared_height = 0;  // how far at most a vertex is from the plane of a polygon it is in
  std::size_t refused = 0;      // sets of polygons that are flat enough and yet were not joined
  // Images keep apart what is apart if no vertex moves farther than this; none: whatever
  // `judge_within` allows.
  std::optional<Rational> squared_limit = {};
};

// From the largest polygon to the smallest, each that is still alone takes in those beside it, and
// those beside these, across segments that two polygons have and nothing else, as long as the angle
// there is small enough, as TetGen asks it, and they are flat enough for its own plane, with which
// none makes more than 5 degrees. Such a set is not joined if two of its polygons are before each
// other, seen along the normal of the plane, or if a cell that has no vertex in common with it is
// nearer to it than 8 times the distance of its own vertices from the plane. Up to 100 times that
// distance, such a cell limits how far vertices may be moved.
// Requires: a valid complex in space; `listed`: as `listed_segments` says.
NearlyJoined nearly_coplanar_polygons_joined(const PiecewiseLinearComplex& complex,
                                             const std::vector<Simplex>& listed,
                                             const Flatness& flatness);

// Tells of segments that they stay, whichever polygons are joined, those of one plane first and
// then those of nearly one, at such an angle.
class StayingSegments {
 public:
  // The complex must outlive this. Requires: it is valid, and in space.
  StayingSegments(const PiecewiseLinearComplex& complex, Rational squared_slope);

  // Is the segment in fewer than two polygons, or in two, and no way leads from one of these to the
  // other across segments at which the angle is small enough? False says nothing: few polygons are
  // looked at.
  bool certainly(const Simplex& segment) const;

 private:
  std::vector<std::size_t> at(const Simplex& segment) const;

  const PiecewiseLinearComplex& complex_;
  Rational squared_slope_;
  std::vector<std::vector<std::size_t>> at_vertex_;  // polygons
};

}  // namespace circumspect::check
