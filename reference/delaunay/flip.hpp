// Bistellar flips in any dimension. Book: Section 4.4, Figures 4.6 and 4.7.
#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/star_index.hpp"

namespace circumspect::delaunay {

// A basic flip of dimension j: the two triangulations of j+2 points of a j-flat, no j+1 of which
// lie in a flat of lower dimension. There are no others. Simplices are ascending, in lexicographic
// order.
//
// Why two: those points have one affine dependence (up to a factor), which divides them into the
// points with a positive and those with a negative coefficient; the convex hulls of the two parts
// meet in one point (Radon). A triangulation has one part as a face, and then consists of the
// simplices that omit one point of the other part, or the other way round. For any heights, one of
// the two is the lower and one the upper side of the lifted points, the W-simplex of the book.
struct BasicFlip {
  std::vector<Simplex> deleted;  // T_D
  std::vector<Simplex> created;  // T_C

  BasicFlip reverse() const { return {created, deleted}; }
};

// The flip among the k+2 points W = simplex ∪ {apex} that deletes the simplex; or if some vertices
// of W take no part in the affine dependence (the W-simplex has vertical facets, whatever the
// heights), the flip of dimension j < k that deletes a face of the simplex.
// - Apex beyond a facet f of the simplex: removes f, and the simplex f * apex too.
// - Apex inside the simplex: inserts it. The j-face that holds it is divided into j+1 j-simplices.
// Requires: the simplex is a k-simplex, k the dimension of the set; the apex is not its vertex.
BasicFlip basic_flip(const PointSet& points, const Simplex& simplex, Vertex apex);

// The effect of a basic flip on a triangulation: it exchanges T_D * Z for T_C * Z, where Z is the
// set of the (k−j−1)-simplices that join T_D to the rest. For a flip with j = k, Z holds only the
// empty simplex.
struct ExtendedFlip {
  std::vector<Simplex> deleted;  // T_D * Z
  std::vector<Simplex> created;  // T_C * Z

  // "2-3" and so on: the numbers of simplices deleted and created.
  std::string name() const;
};

// The members of T_D * Z that the triangulation lacks; never empty.
struct BlockedFlip {
  std::vector<Simplex> missing;
};

// The flip in a triangulation T, or what blocks it. A suitable Z must hold every ζ such that τ * ζ
// is in T for some τ in T_D, because T_D * Z has to contain every simplex of T with a face in T_D;
// and no other, because T_D * Z has to be part of T. So Z is the union of the links of T_D, and the
// flip is possible iff these are all equal. Requires: at least one simplex of T_D is a face of T.
tl::expected<ExtendedFlip, BlockedFlip> extended_flip(const StarIndex& triangulation,
                                                      const BasicFlip& flip);

// The flip that removes a facet: W are the vertices of the two simplices that share it. Whether the
// facet is locally Delaunay plays no part.
// Requires: the facet is in the triangulation, and not on the hull.
BasicFlip flip_of_facet(const PointSet& points, const StarIndex& triangulation,
                        const Simplex& facet);

// The procedure of Figure 4.8, FLIP(T, uvw), for tetrahedra: performs the flip that removes the
// triangle uvw. Where the book assumes that uvw can be flipped, a blocked flip changes nothing and
// returns what is missing. Does the same as extended_flip(T, flip_of_facet(points, T, uvw)), which
// serves any dimension.
// Requires: points.dimension() == 3; uvw is in the triangulation, and not on the hull.
tl::expected<ExtendedFlip, BlockedFlip> flip(const PointSet& points, StarIndex& triangulation,
                                             Vertex u, Vertex v, Vertex w);

}  // namespace circumspect::delaunay
