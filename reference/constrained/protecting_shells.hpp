// Where to split a segment near a vertex at which segments meet in an acute angle.
// Book: Section 4.5.3, Exercise 6 of Chapter 4.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "reference/kernel/exact/box_index.hpp"
#include "reference/kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect::constrained {

// A vertex v is narrow if two of its segments make an angle there with a cosine above 1/4; where there
// is no narrower one, halving does as well (see segment_recovery.hpp). At a narrow vertex, two
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
  // Of all pairs of segments at the apex: the time is quadratic in their number.
  void measure_angles(Vertex apex, Apex& around) const;
  Rational squared_distance_to_others(Vertex apex) const;

  const PiecewiseLinearComplex& complex_;
  std::vector<std::vector<std::size_t>> segments_at_;  // by vertex
  BoxIndex boxes_;                                     // of the segments, then of the vertices
  mutable std::map<Vertex, Apex> apexes_;              // as far as anybody asked
};

}  // namespace circumspect::constrained
