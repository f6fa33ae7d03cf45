// The predicates for rows of sites, whatever the dimension.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>

#include "oracle/judge/fast/predicates.hpp"

namespace circumspect::fast {

template <std::size_t kDimension>
int orientation(const SiteRow<kDimension>& row, Stages& stages, Lattice lattice = {}) {
  return std::apply(
      [&](const auto&... sites) { return fast::orientation(sites..., stages, lattice); }, row);
}

// The orientation of the row with another site in place of one of its own.
template <std::size_t kDimension>
int orientation_with(SiteRow<kDimension> row, std::size_t place, const Site<kDimension>& site,
                     Stages& stages, Lattice lattice = {}) {
  row[place] = site;
  return orientation<kDimension>(row, stages, lattice);
}

template <std::size_t kDimension, bool kWeighted>
Ball<kDimension, kWeighted> ball_of(const SiteRow<kDimension>& row, Lattice lattice = {}) {
  return std::apply(
      [&](const auto&... sites) { return Ball<kDimension, kWeighted>(sites..., lattice); }, row);
}

// in_ball under the canonical perturbation (reference/kernel/predicates/perturbation.hpp), where in_ball
// is zero: the point that comes first in lexicographic order decides, unless its coefficient is
// zero. `own` is the orientation of the simplex. Requires: different points. Book: Section 5.6.
// `crossed`: a vertex such that the query is strictly beyond the facet opposite, if that is known.
template <std::size_t kDimension>
int perturbed_sign_of_zero(const SiteRow<kDimension>& simplex, int own,
                           const Site<kDimension>& query, Stages& stages, Lattice lattice = {},
                           std::size_t crossed = kDimension + 1) {
  std::array<bool, kDimension + 1> has_no_say{};
  while (true) {
    std::size_t first = kDimension + 1;
    for (std::size_t i = 0; i <= kDimension; ++i) {
      if (has_no_say[i]) continue;
      if (simplex[i].at < (first > kDimension ? query : simplex[first]).at) first = i;
    }
    // The coefficient of the vertex opposite a facet that the query is beyond is negative.
    if (first > kDimension || first == crossed) return 1;
    const int barycentric =
        orientation_with<kDimension>(simplex, first, query, stages, lattice) * own;
    if (barycentric != 0) return -barycentric;
    has_no_say[first] = true;
  }
}

}  // namespace circumspect::fast
