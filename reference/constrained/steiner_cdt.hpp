// A Steiner CDT of any complex, whose segments are recovered first. Book: Sections 4.5.2 and
// 4.5.3.
#pragma once

#include <vector>

#include <tl/expected.hpp>

#include "kernel/complex/star_index.hpp"
#include "kernel/exact/progress.hpp"
#include "reference/constrained/plc_triangulation.hpp"
#include "reference/constrained/split_segments.hpp"

namespace circumspect::constrained {

// Making a complex edge-protected by adding vertices on its segments.
// Book: Section 4.5.3 and Exercise 6 of Chapter 4.

struct RecoveredSegments {
  PiecewiseLinearComplex complex;              // the original points first, then the Steiner points
  std::vector<PointOnSegment> steiner_points;  // in the order of their indices
};

// Adds vertices on the segments of any valid complex, in the plane or in space, until every
// subsegment is strongly Delaunay: the resulting complex is edge-protected in both readings, and so
// has a CDT (Theorem 4.9). A complex that is edge-protected is returned unchanged.
//
// Round after round, every subsegment that is not strongly Delaunay is split, and no other. That
// wastes nothing: more vertices never make a subsegment strongly Delaunay, so each of them must be
// split sooner or later, whatever else is done.
//
// It ends, however small the angles. An end is acute in the sense of ProtectingShells. At an acute
// end a of a segment let 2^k be the radius of the least shell of a, and m ≤ (9/8)² its bound. Call
// a subsegment short if it begins at a and its squared length is at most m 4^k.
//
// 1. A segment ab that is acute at a has no vertex but a nearer to a than 2^k. Points at shells of
//    a have been chosen so. Points in the middle half of a subsegment are further away than an end
//    of that subsegment, or, if it is ab itself, a quarter of ab or more, and 2^k is no more. As
//    for points at shells of b, the nearest to a was split off from a subsegment that begins at b.
//    If that was ab itself, of length l, the point is no further from b than 9/8 · 2l/3 or 9/8 ·
//    l/4, since b's least shell is at most l/4; so it is l/4 or further from a, and 2^k ≤ l/4. If
//    not, the subsegment has another vertex for its end, which is nearer to a.
// 2. A short subsegment ap is strongly Delaunay, by its diametral ball. That ball is in the closed
//    ball about a with radius √m 2^k ≤ 9/8 · 2^k, which is smaller than the distance of a from all
//    other original vertices and all segments that do not end at a. A vertex q on a segment that
//    makes an angle θ ≥ 90° with ap is outside, whatever its distance from a. If θ < 90°, q would
//    have to be within |ap| cos θ ≤ 2^k √m cos θ < 2^k of a, against 1. So short subsegments are
//    never split.
// 3. A subsegment at one acute end that is not short is split so that the rest of it at that end is
//    at most 3/4 as long, or short. This cannot go on for ever.
// 4. So from some time on only others are split, each within its middle half. Then none gets
//    shorter than some ℓ: let 4ℓ be at most the length of every subsegment at that time, and at
//    most the distance of the part of any segment s that is at least 2^k away from its acute ends
//    from every original vertex and every segment other than s, save those that meet s in an end b
//    that is not acute. A subsegment xy of s that is shorter than 4ℓ has nothing in its closed
//    diametral ball that is so far away. Segments that meet s in b at an angle of 90° or more have
//    no point in it apart from b: they are on the other side of the plane through b orthogonal to
//    s, or in it. Let a vertex p be on one with an angle θ < 90°: cos θ ≤ 1/4, since b is not
//    narrow, and |bp| ≥ ℓ, since no subsegment is shorter. If x = b, p is in the ball only if |bp|
//    ≤ |by| cos θ < ℓ. If not, |bx| ≥ ℓ, and with t = |bp| cos θ, where h = |bp| sin θ is at least
//    t √15, p is in the ball only if h² ≤ (t − |bx|)(|by| − t); so |bx| < t and |by| > t + 15 t >
//    16 |bx|, and xy is longer than 15ℓ. So xy is strongly Delaunay, and is not split; a longer one
//    has parts that are ℓ or longer.
//
// Therefore, unlike conforming_delaunay.hpp, it has no limit on Steiner points; but there may be
// many of them: for two parallel segments, in proportion to the ratio of their length to their
// distance. Requires: the complex is valid.
RecoveredSegments recover_segments(const PiecewiseLinearComplex& complex);

// The same, but gives up after the round that exceeds this number of Steiner points.
tl::expected<RecoveredSegments, SteinerLimitReached> recover_segments(
    const PiecewiseLinearComplex& complex, std::size_t most_steiner_points,
    const Progress& progress = {});

// The condition on a subsegment: to be strongly Delaunay, or only to be so under the canonical
// perturbation, that is, an edge of the canonical Delaunay triangulation. Everything above holds
// for either.
enum class SubsegmentCondition { kStronglyDelaunay, kInCanonical };

// One round: the points at which subsegments that do not satisfy the condition must be split. They
// get the next numbers after those of `points`, which are all points so far.
std::vector<PointOnSegment> points_for_unprotected_subsegments(const PointSet& points,
                                                               const StarIndex& canonical_delaunay,
                                                               const SplitSegments& segments,
                                                               SubsegmentCondition condition);

enum class CdtAlgorithm { kGiftWrapping, kPolygonFlips, kPolygonCavities };

// The canonical CDT of a complex that has one by Theorem 4.9, or because it is planar.
// Requires: in space, that the complex is edge-protected in either reading; the complex is valid.
// Throws std::logic_error if it turns out to have no CDT, and hence was not edge-protected.
PlcTriangulation cdt_of_edge_protected(const PiecewiseLinearComplex& complex,
                                       CdtAlgorithm algorithm = CdtAlgorithm::kPolygonFlips,
                                       const Progress& progress = {});

struct SteinerCdt {
  PiecewiseLinearComplex complex;  // the augmented complex: the original points come first
  PlcTriangulation triangulation;  // its canonical CDT
  std::vector<PointOnSegment> steiner_points;  // in the order of their indices
};

// "The augmented PLC has a CDT, which is a Steiner CDT of the original PLC." A complex that is
// edge-protected gets no Steiner points; nor does one in the plane, where every complex has a CDT.
// Subsegments become as short as necessary, and the process ends (see above). Requires: the complex
// is valid. Throws std::logic_error if the augmented complex has no CDT, which would refute Theorem
// 4.9.
SteinerCdt steiner_cdt(const PiecewiseLinearComplex& complex,
                       CdtAlgorithm algorithm = CdtAlgorithm::kPolygonFlips);

// The same, unless more than so many Steiner points are needed.
tl::expected<SteinerCdt, SteinerLimitReached> steiner_cdt(const PiecewiseLinearComplex& complex,
                                                          CdtAlgorithm algorithm,
                                                          std::size_t most_steiner_points,
                                                          const Progress& progress = {});

}  // namespace circumspect::constrained
