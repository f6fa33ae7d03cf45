// Orientation and ball tests of points given by doubles: exact, and as fast as doubles where those
// suffice. Book: Section 3.1 (Orient2D, Orient3D, InCircle, InSphere); Section 5.2 for weighted points.
//
// Laws (held by predicates_test.cpp, and by predicates_soak_test.cpp on a million tuples of every
// family, under these numbers):
//  F1 each sign is the sign of reference/predicates, whatever the stage that decides: for numbers from
//     the least denormal to the largest double, one ulp apart, far from the origin, with exact zeros.
//  F2 coordinates (and weights, where they count) are finite; other input is a breach of contract.
//  F3 the arithmetic is as oracle/fast/arithmetic.hpp says; `arithmetic_is_as_proved` tests it.
//  F4 each call adds one to exactly one of the stages.
//  F5 a filter's bound is the one that a script in proofs/filters proves for its operations
//     (gappa_scripts_test.cpp).
//  F6 a lattice that all points lie on changes no sign.
#pragma once

#include <array>
#include <cstddef>

#include "oracle/fast/exact_sign.hpp"
#include "oracle/fast/filter.hpp"
#include "oracle/fast/site.hpp"

namespace circumspect::fast {

// Positive for counterclockwise triangles.
int orientation(const Site<2>& a, const Site<2>& b, const Site<2>& c, Stages& stages);
// Positive for the book's positively oriented tetrahedra (reference/predicates/orientation.hpp).
int orientation(const Site<3>& a, const Site<3>& b, const Site<3>& c, const Site<3>& d,
                Stages& stages);

// A simplex whose ball, or witness plane if weighted, is asked for several queries: what depends on the
// simplex alone is computed once, and gives its orientation on the way.
template <std::size_t kDimension, bool kWeighted = false>
class Ball;

template <bool kWeighted>
class Ball<2, kWeighted> {
 public:
  // `lattice` is one that all vertices and queries lie on, if that is known.
  Ball(const Site<2>& a, const Site<2>& b, const Site<2>& c, Lattice lattice = {});

  int orientation(Stages& stages) const;
  // For a positively oriented simplex: positive iff the query is inside the open ball (weighted:
  // strictly below the witness plane), zero iff on its boundary. Negated if negatively oriented; what
  // it says of a degenerate simplex is the sign of the polynomial.
  int contains(const Site<2>& query, Stages& stages) const;

 private:
  std::array<Site<2>, 3> vertices_;
  Lattice lattice_;
  Scale2 scale_;
  TriangleCofactors<double, double> cofactors_;
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
  std::array<Site<3>, 4> vertices_;
  Lattice lattice_;
  Scale3 scale_;
  TetrahedronCofactors<double, double, double> cofactors_;
};

// ── Inline, for loops over all tetrahedra ────────────────────────────────────────────────────────

inline int orientation(const Site<2>& a, const Site<2>& b, const Site<2>& c, Stages& stages) {
  const FilterRow2 from_a = row_from<false>(c, a), from_b = row_from<false>(c, b);
  const double value = minor(from_a.row.x, from_a.row.y, from_b.row.x, from_b.row.y);
  const int sign = certain_sign(value, kOrientation2, larger(from_a.scale, from_b.scale), {});
  if (sign == kUncertain) return exact_sign<2, 3>({&a, &b, &c}, false, stages);
  ++stages.filtered;
  return sign;
}

inline int orientation(const Site<3>& a, const Site<3>& b, const Site<3>& c, const Site<3>& d,
                       Stages& stages) {
  const FilterRow3 from_a = row_from<false>(d, a), from_b = row_from<false>(d, b),
                   from_c = row_from<false>(d, c);
  const int sign = certain_sign(volume(from_a.row, from_b.row, from_c.row), kOrientation3,
                                larger(larger(from_a.scale, from_b.scale), from_c.scale), {});
  if (sign == kUncertain) return exact_sign<3, 4>({&a, &b, &c, &d}, false, stages);
  ++stages.filtered;
  return sign;
}

template <bool kWeighted>
Ball<2, kWeighted>::Ball(const Site<2>& a, const Site<2>& b, const Site<2>& c, Lattice lattice)
    : vertices_{a, b, c}, lattice_(lattice) {
  const FilterRow2 from_a = row_from<kWeighted>(c, a), from_b = row_from<kWeighted>(c, b);
  scale_ = larger(from_a.scale, from_b.scale);
  cofactors_ = cofactors(from_a.row, from_b.row);
}

template <bool kWeighted>
int Ball<2, kWeighted>::orientation(Stages& stages) const {
  const int sign = certain_sign(cofactors_.xy, kOrientation2, scale_, lattice_);
  if (sign == kUncertain) {
    return exact_sign<2, 3>({&vertices_[0], &vertices_[1], &vertices_[2]}, false, stages);
  }
  ++stages.filtered;
  return sign;
}

template <bool kWeighted>
int Ball<2, kWeighted>::contains(const Site<2>& query, Stages& stages) const {
  const FilterRow2 from = row_from<kWeighted>(vertices_[2], query);
  const int sign = certain_lifted_sign(in_circle(cofactors_, from.row),
                                       kWeighted ? kInCircleWeighted : kInCircle,
                                       larger(scale_, from.scale), lattice_);
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
    : vertices_{a, b, c, d}, lattice_(lattice) {
  const FilterRow3 from_a = row_from<kWeighted>(d, a), from_b = row_from<kWeighted>(d, b),
                   from_c = row_from<kWeighted>(d, c);
  scale_ = larger(larger(from_a.scale, from_b.scale), from_c.scale);
  cofactors_ = cofactors(from_a.row, from_b.row, from_c.row);
}

template <bool kWeighted>
int Ball<3, kWeighted>::orientation(Stages& stages) const {
  const int sign = certain_sign(cofactors_.xyz, kOrientation3, scale_, lattice_);
  if (sign == kUncertain) {
    return exact_sign<3, 4>({&vertices_[0], &vertices_[1], &vertices_[2], &vertices_[3]}, false,
                            stages);
  }
  ++stages.filtered;
  return sign;
}

template <bool kWeighted>
int Ball<3, kWeighted>::contains(const Site<3>& query, Stages& stages) const {
  const FilterRow3 from = row_from<kWeighted>(vertices_[3], query);
  const int sign = certain_lifted_sign(in_sphere(cofactors_, from.row),
                                       kWeighted ? kInSphereWeighted : kInSphere,
                                       larger(scale_, from.scale), lattice_);
  if (sign == kUncertain) {
    return exact_sign<3, 5>({&vertices_[0], &vertices_[1], &vertices_[2], &vertices_[3], &query},
                            kWeighted, stages);
  }
  ++stages.filtered;
  return sign;
}

}  // namespace circumspect::fast
