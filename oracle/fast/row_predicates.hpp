// The predicates for rows of sites, whatever the dimension.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>

#include "oracle/fast/predicates.hpp"

namespace circumspect::fast {

template <std::size_t kDimension>
using SiteRow = std::array<Site<kDimension>, kDimension + 1>;

template <std::size_t kDimension>
int orientation(const SiteRow<kDimension>& row, Stages& stages) {
  return std::apply([&](const auto&... sites) { return fast::orientation(sites..., stages); }, row);
}

// The orientation of the row with another site in place of one of its own.
template <std::size_t kDimension>
int orientation_with(SiteRow<kDimension> row, std::size_t place, const Site<kDimension>& site,
                     Stages& stages) {
  row[place] = site;
  return orientation<kDimension>(row, stages);
}

template <std::size_t kDimension, bool kWeighted>
Ball<kDimension, kWeighted> ball_of(const SiteRow<kDimension>& row) {
  return std::apply([](const auto&... sites) { return Ball<kDimension, kWeighted>(sites...); },
                    row);
}

// in_ball under the canonical perturbation (reference/predicates/perturbation.hpp), where in_ball is
// zero: the point that comes first in lexicographic order decides, unless its coefficient is zero.
// `own` is the orientation of the simplex. Requires: different points. Book: Section 5.6.
template <std::size_t kDimension>
int perturbed_sign_of_zero(const SiteRow<kDimension>& simplex, int own,
                           const Site<kDimension>& query, Stages& stages) {
  std::array<std::size_t, kDimension + 1> places;
  for (std::size_t i = 0; i <= kDimension; ++i) places[i] = i;
  std::sort(places.begin(), places.end(),
            [&](std::size_t a, std::size_t b) { return simplex[a].at < simplex[b].at; });
  for (const std::size_t place : places) {
    if (query.at < simplex[place].at) return 1;
    const int barycentric = orientation_with<kDimension>(simplex, place, query, stages) * own;
    if (barycentric != 0) return -barycentric;
  }
  return 1;
}

}  // namespace circumspect::fast
