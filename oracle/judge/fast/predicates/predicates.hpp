// Orientation and ball tests of points given by doubles: exact, and as fast as doubles where those
// suffice. Book: Section 3.1 (Orient2D, Orient3D, InCircle, InSphere); Section 5.2 for weighted
// points.
//
// Laws (held by predicates_test.cpp, and by predicates_soak_test.cpp on a million tuples of every
// family, under these numbers):
//  F1 each sign is the sign of kernel/predicates, whatever the stage that decides: for numbers from
//     the least denormal to the largest double, one ulp apart, far from the origin, with exact
//     zeros.
//  F2 coordinates (and weights, where they count) are finite; other input is a breach of contract.
//  F3 the arithmetic is as oracle/judge/fast/predicates/arithmetic.hpp says;
//     `arithmetic_is_as_proved` tests it.
//  F4 each call adds one to exactly one of the stages.
//  F5 a filter's bound is the one that a script in proofs/filters proves for its operations
//     (gappa_scripts_test.cpp), which are the same for many simplices side by side
//     (block_test.cpp).
//  F6 a lattice that all points lie on changes no sign.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>

#include "oracle/judge/fast/predicates/exact_sign.hpp"
#include "oracle/judge/fast/predicates/filter.hpp"
#include "oracle/judge/fast/predicates/site.hpp"

namespace circumspect::fast {

// Positive for counterclockwise triangles. `lattice` contains all points, if such a lattice is
// known.
int orientation(const Site<2>& a, const Site<2>& b, const Site<2>& c, Stages& stages,
                Lattice lattice = {});
// Positive for the book's positively oriented tetrahedra (kernel/predicates/orientation.hpp).
int orientation(const Site<3>& a, const Site<3>& b, const Site<3>& c, const Site<3>& d,
                Stages& stages, Lattice lattice = {});

// A simplex whose ball, or witness plane if weighted, is compared with several queries: what
// depends on the simplex alone is computed once, which also gives its orientation.
template <std::size_t kDimension, bool kWeighted = false>
class Ball;

template <bool kWeighted>
class Ball<2, kWeighted> {
 public:
  // `lattice` contains all vertices and queries, if such a lattice is known.
  Ball(const Site<2>& a, const Site<2>& b, const Site<2>& c, Lattice lattice = {});

  int orientation(Stages& stages) const;
  // For a positively oriented simplex: positive iff the query is inside the open ball (weighted:
  // strictly below the witness plane), zero iff on its boundary. Negated if negatively oriented;
  // for a degenerate simplex it is the sign of the polynomial.
  int contains(const Site<2>& query, Stages& stages) const;

 private:
  SiteRow<2> vertices_;
  Lattice lattice_;
  SimplexFilter<2> filter_;
};

template <bool kWeighted>
class Ball<3, kWeighted> {
 public:
  Ball(const Site<3>& a, const Site<3>& b, const Site<3>& c, const Site<3>& d,
       Lattice lattice = {});

  int orientation(Stages& stages) const;
  // As in the plane.
  int contains(const Site<3>& query, Stages& stages) const;

 private:
  SiteRow<3> vertices_;
  Lattice lattice_;
  SimplexFilter<3> filter_;
};

inline int orientation(const Site<2>& a, const Site<2>& b, const Site<2>& c, Stages& stages,
                       Lattice lattice) {
  const FilterRow2 from_a = row_from<false>(c, a), from_b = row_from<false>(c, b);
  const double value = minor(from_a.row.x, from_a.row.y, from_b.row.x, from_b.row.y);
  const int sign =
      certain_sign<int>(value, kOrientation2, larger(from_a.scale, from_b.scale), lattice);
  if (sign == kUncertain) return exact_sign<2, 3>({&a, &b, &c}, false, stages);
  ++stages.filtered;
  return sign;
}

inline int orientation(const Site<3>& a, const Site<3>& b, const Site<3>& c, const Site<3>& d,
                       Stages& stages, Lattice lattice) {
  const FilterRow3 from_a = row_from<false>(d, a), from_b = row_from<false>(d, b),
                   from_c = row_from<false>(d, c);
  const int sign =
      certain_sign<int>(volume(from_a.row, from_b.row, from_c.row), kOrientation3,
                        larger(larger(from_a.scale, from_b.scale), from_c.scale), lattice);
  if (sign == kUncertain) return exact_sign<3, 4>({&a, &b, &c, &d}, false, stages);
  ++stages.filtered;
  return sign;
}

template <bool kWeighted>
Ball<2, kWeighted>::Ball(const Site<2>& a, const Site<2>& b, const Site<2>& c, Lattice lattice)
    : vertices_{a, b, c}, lattice_(lattice), filter_(simplex_filter<kWeighted>(a, b, c)) {}

template <bool kWeighted>
int Ball<2, kWeighted>::orientation(Stages& stages) const {
  const int sign = filtered_orientation<int>(filter_, lattice_);
  if (sign == kUncertain) {
    return exact_sign<2, 3>({&vertices_[0], &vertices_[1], &vertices_[2]}, false, stages);
  }
  ++stages.filtered;
  return sign;
}

template <bool kWeighted>
int Ball<2, kWeighted>::contains(const Site<2>& query, Stages& stages) const {
  const int sign = filtered_ball<kWeighted, int>(filter_, vertices_[2], query, lattice_);
  if (sign == kUncertain) {
    return exact_sign<2, 4>({&vertices_[0], &vertices_[1], &vertices_[2], &query}, kWeighted,
                            stages);
  }
  ++stages.filtered;
  return sign;
}

template <bool kWeighted>
Ball<3, kWeighted>::Ball(const Site<3>& a, const Site<3>& b, const Site<3>& c, const Site<3>& d,
                         Lattice lattice)
    : vertices_{a, b, c, d}, lattice_(lattice), filter_(simplex_filter<kWeighted>(a, b, c, d)) {}

template <bool kWeighted>
int Ball<3, kWeighted>::orientation(Stages& stages) const {
  const int sign = filtered_orientation<int>(filter_, lattice_);
  if (sign == kUncertain) {
    return exact_sign<3, 4>({&vertices_[0], &vertices_[1], &vertices_[2], &vertices_[3]}, false,
                            stages);
  }
  ++stages.filtered;
  return sign;
}

template <bool kWeighted>
int Ball<3, kWeighted>::contains(const Site<3>& query, Stages& stages) const {
  const int sign = filtered_ball<kWeighted, int>(filter_, vertices_[3], query, lattice_);
  if (sign == kUncertain) {
    return exact_sign<3, 5>({&vertices_[0], &vertices_[1], &vertices_[2], &vertices_[3], &query},
                            kWeighted, stages);
  }
  ++stages.filtered;
  return sign;
}

// The predicates for rows of sites, whatever the dimension.

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

// in_ball under the canonical perturbation (kernel/predicates/perturbation.hpp), where in_ball
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
