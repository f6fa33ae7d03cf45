// The exact stages: signs of the polynomials by integers, for cases that the filter leaves open.
#pragma once

#include <array>
#include <cstddef>

#include "oracle/judge/fast/predicates/site.hpp"

namespace circumspect::fast {

// The vertices of a simplex, then (for tests of a ball) the query.
template <std::size_t kDimension, std::size_t kCount>
using Sites = std::array<const Site<kDimension>*, kCount>;

// Coordinates are multiples of a power of two, hence integers in that unit; the width depends on
// the differences without their common power of two. The first stage that suffices is used:
// `narrow`, `fixed`, `wide`, `unbounded`.
//
// kCount == kDimension + 1: the orientation, as `orientation` in predicates.hpp.
// kCount == kDimension + 2: the ball test, as `in_ball` there, with weights if `weighted`.
// Requires: finite coordinates (and weights, if weighted). It assumes nothing about rounding except
// that products with a power of two are exact if the result is a double.
template <std::size_t kDimension, std::size_t kCount>
int exact_sign(const Sites<kDimension, kCount>& sites, bool weighted, Stages& stages);

extern template int exact_sign(const Sites<2, 3>&, bool, Stages&);
extern template int exact_sign(const Sites<2, 4>&, bool, Stages&);
extern template int exact_sign(const Sites<3, 4>&, bool, Stages&);
extern template int exact_sign(const Sites<3, 5>&, bool, Stages&);

// The same for a row of sites.
template <std::size_t kDimension>
int exact_orientation(const SiteRow<kDimension>& row, Stages& stages) {
  Sites<kDimension, kDimension + 1> sites;
  for (std::size_t i = 0; i <= kDimension; ++i) sites[i] = &row[i];
  return exact_sign<kDimension, kDimension + 1>(sites, false, stages);
}
template <std::size_t kDimension>
int exact_ball_sign(const SiteRow<kDimension>& row, const Site<kDimension>& query, bool weighted,
                    Stages& stages) {
  Sites<kDimension, kDimension + 2> sites;
  for (std::size_t i = 0; i <= kDimension; ++i) sites[i] = &row[i];
  sites[kDimension + 1] = &query;
  return exact_sign<kDimension, kDimension + 2>(sites, weighted, stages);
}

}  // namespace circumspect::fast
