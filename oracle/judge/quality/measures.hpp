// The measures of a simplex as polynomials in the squared lengths of its edges, each written once:
// evaluated with rational numbers, and with enclosed doubles before. docs/theory/quality.md derives
// them. They do not depend on the dimension of the space, and never on a square root.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "kernel/exact/number.hpp"
#include "oracle/judge/quality/enclosed.hpp"
#include "oracle/judge/quality/magnitude.hpp"
#include "oracle/model/measure.hpp"

namespace circumspect::quality {

inline Rational signed_square(const Rational& x) { return x * abs(x); }
inline Rational larger(const Rational& a, const Rational& b) { return a < b ? b : a; }
inline Rational smaller(const Rational& a, const Rational& b) { return b < a ? b : a; }

// Of a simplex with kDimension + 1 vertices, which are counted from 0.
template <std::size_t kDimension, class Number>
struct SquaredLengths {
  static constexpr std::size_t kVertices = kDimension + 1;
  static constexpr std::size_t kEdges = kVertices * kDimension / 2;

  static constexpr std::size_t place(std::size_t i, std::size_t j) {
    return i < j ? i * kVertices - i * (i + 1) / 2 + (j - i - 1) : place(j, i);
  }
  const Number& operator()(std::size_t i, std::size_t j) const { return squared[place(i, j)]; }

  std::array<Number, kEdges> squared;
};

// Where in a simplex something was measured: a corner of a triangle (the triangle with the corner
// first), an edge, or nowhere in particular. Vertices are counted from 0 in the simplex.
struct Place {
  std::array<std::uint8_t, 3> vertices = {};
  std::uint8_t size = 0;
};

// A value in two parts; the second is positive unless the simplex is flat.
template <class Number>
struct Quotient {
  Number above, below;
};

// Twice the inner product of b − a and c − a.
template <std::size_t k, class N>
[[gnu::always_inline]] inline N twice_inner(const SquaredLengths<k, N>& l, std::size_t a,
                                            std::size_t b, std::size_t c) {
  return l(a, b) + l(a, c) - l(b, c);
}

// The signed square of the angle at a.
template <std::size_t k, class N>
[[gnu::always_inline]] inline Quotient<N> angle(const SquaredLengths<k, N>& l, std::size_t a,
                                                std::size_t b, std::size_t c) {
  return {signed_square(N(twice_inner(l, a, b, c))), 4 * N(l(a, b) * l(a, c))};
}

// Sixteen times the square of the area of a face.
template <std::size_t k, class N>
[[gnu::always_inline]] inline N area_16(const SquaredLengths<k, N>& l, std::size_t a, std::size_t b,
                                        std::size_t c) {
  const N inner = twice_inner(l, a, b, c);
  return 4 * N(l(a, b) * l(a, c)) - inner * inner;
}

// The signed square of the dihedral angle at the edge ij, between the triangles with k and with l.
template <class N>
[[gnu::always_inline]] inline Quotient<N> dihedral(const SquaredLengths<3, N>& l, std::size_t i,
                                                   std::size_t j, std::size_t k, std::size_t m) {
  const N inner = twice_inner(l, i, k, m), along_k = twice_inner(l, i, j, k),
          along_m = twice_inner(l, i, j, m);
  return {signed_square(N(2 * N(inner * l(i, j)) - along_k * along_m)),
          area_16(l, i, j, k) * area_16(l, i, j, m)};
}

// 144 times the square of the volume.
template <class N>
[[gnu::always_inline]] inline N volume_144(const SquaredLengths<3, N>& l) {
  const N &u = l(0, 1), &v = l(0, 2), &w = l(0, 3);
  const N uv = twice_inner(l, 0, 1, 2), uw = twice_inner(l, 0, 1, 3), vw = twice_inner(l, 0, 2, 3);
  return 4 * N(u * v * w) + uv * uw * vw - u * vw * vw - v * uw * uw - w * uv * uv;
}

template <std::size_t k, class N>
N longest(const SquaredLengths<k, N>& l) {
  N most = l.squared[0];
  for (std::size_t e = 1; e < l.kEdges; ++e) most = larger(most, l.squared[e]);
  return most;
}
template <std::size_t k, class N>
N shortest(const SquaredLengths<k, N>& l) {
  N least = l.squared[0];
  for (std::size_t e = 1; e < l.kEdges; ++e) least = smaller(least, l.squared[e]);
  return least;
}

// (circumradius / shortest edge)².
template <class N>
Quotient<N> radius_edge(const SquaredLengths<2, N>& l) {
  return {l(0, 1) * l(0, 2) * l(1, 2), area_16(l, 0, 1, 2) * shortest(l)};
}
template <class N>
Quotient<N> radius_edge(const SquaredLengths<3, N>& l) {
  const N p = l(0, 1) * l(2, 3), q = l(0, 2) * l(1, 3), r = l(0, 3) * l(1, 2);
  const N mixed = p * q + q * r + r * p, pure = p * p + q * q + r * r;
  return {2 * mixed - pure, 4 * N(volume_144(l) * shortest(l))};
}

// (longest edge / least height)².
template <class N>
Quotient<N> aspect_ratio(const SquaredLengths<2, N>& l) {
  const N most = longest(l);
  return {4 * N(most * most), area_16(l, 0, 1, 2)};
}
template <class N>
Quotient<N> aspect_ratio(const SquaredLengths<3, N>& l) {
  const N largest_face = larger(N(larger(area_16(l, 0, 1, 2), area_16(l, 0, 1, 3))),
                                N(larger(area_16(l, 0, 2, 3), area_16(l, 1, 2, 3))));
  return {longest(l) * largest_face, volume_144(l)};
}

// Is the simplex not flat? The number is positive if it is not, and zero if it is.
template <class N>
N spread(const SquaredLengths<1, N>& l) {
  return l(0, 1);
}
template <class N>
N spread(const SquaredLengths<2, N>& l) {
  return area_16(l, 0, 1, 2);
}
template <class N>
N spread(const SquaredLengths<3, N>& l) {
  return volume_144(l);
}

// Calls visit(place, quotient) for every value that the measure is an extreme of. Requires: the
// measure exists for the dimension.
template <std::size_t k, class N, class Visit>
[[gnu::always_inline]] inline void each_value(Measure measure, const SquaredLengths<k, N>& l,
                                              const Visit& visit) {
  const auto each_edge = [&](const auto& found) {
    for (std::uint8_t i = 0; i < k; ++i) {
      for (std::uint8_t j = i + 1; j <= k; ++j) found(i, j);
    }
  };
  switch (measure) {
    case Measure::kMinAngle:
    case Measure::kMaxAngle:
      if constexpr (k >= 2) {
        for (std::uint8_t a = 0; a <= k; ++a) {
          each_edge([&](std::uint8_t b, std::uint8_t c) {
            if (b != a && c != a) visit(Place{{a, b, c}, 3}, angle(l, a, b, c));
          });
        }
      }
      return;
    case Measure::kMinDihedral:
    case Measure::kMaxDihedral:
      if constexpr (k == 3) {
        each_edge([&](std::uint8_t i, std::uint8_t j) {
          const auto other = static_cast<std::uint8_t>(i > 0 ? 0 : j > 1 ? 1 : 2);
          visit(Place{{i, j}, 2}, dihedral(l, i, j, other, std::size_t{6} - i - j - other));
        });
      }
      return;
    case Measure::kRadiusEdge:
      if constexpr (k >= 2) visit(Place{}, radius_edge(l));
      return;
    case Measure::kAspectRatio:
      if constexpr (k >= 2) visit(Place{}, aspect_ratio(l));
      return;
    case Measure::kVolume:
      if constexpr (k == 3) visit(Place{}, Quotient<N>{volume_144(l), N{144}});
      return;
    case Measure::kArea:
      if constexpr (k == 2) visit(Place{}, Quotient<N>{area_16(l, 0, 1, 2), N{16}});
      return;
    case Measure::kEdge:
    case Measure::kMinEdge:
      each_edge([&](std::uint8_t i, std::uint8_t j) {
        visit(Place{{i, j}, 2}, Quotient<N>{l(i, j), N{1}});
      });
  }
}

}  // namespace circumspect::quality
