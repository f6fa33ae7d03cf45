// For tests: tuples of points that are hard for predicates, and the answers of kernel/predicates.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "oracle/judge/fast/predicates/site.hpp"

namespace circumspect::fast {

// The kinds of numbers that a tuple may have.
enum class Kind {
  kUniform,      // 53 random bits below 1
  kGrid,         // a small grid, at any scale at which it has no rounding
  kGridUlp,      // the same, with some numbers an ulp off
  kFarCluster,   // a few ulps apart, far from the origin
  kSphere,       // the unit sphere, rounded
  kSpread,       // exponents within 40 of each other
  kMixed,        // between 1e-300 and 1e300
  kDenormal,     // multiples of the least denormal
  kOverflowing,  // near the largest double, of both signs
  kSmallScales,  // around the least scale at which filters work
  kIntegers,     // random bit lengths up to 53, for the weights too, up to 2^140
  kHeavy,        // small integers with weights near the largest double
  kLast = kHeavy
};

class Tuples {
 public:
  explicit Tuples(std::uint64_t seed) : random_(seed) {}

  template <std::size_t kDimension, std::size_t kCount>
  std::array<Site<kDimension>, kCount> draw(Kind kind) {
    scale_ = static_cast<int>(below(6)) != 0 ? 0 : static_cast<int>(below(2020)) - 1070;
    bits_ = 1 + below(53);
    std::array<Site<kDimension>, kCount> sites;
    for (auto& site : sites) {
      double squares = 0;
      for (double& x : site.at) {
        x = number(kind);
        squares += x * x;
      }
      if (kind == Kind::kSphere) {
        for (double& x : site.at) x /= std::sqrt(squares);
      }
      site.weight = weight(kind, squares);
    }
    if (below(4) == 0) sites[below(kCount)].at = sites[below(kCount)].at;  // perhaps a point twice
    return sites;
  }

 private:
  std::uint64_t below(std::uint64_t count) { return random_() % count; }
  double whole(std::uint64_t bound) {
    return static_cast<double>(below(2 * bound + 1)) - static_cast<double>(bound);
  }
  double shifted(double value) { return std::ldexp(value, value == 0 ? 0 : scale_); }

  double number(Kind kind) {
    const double huge = std::numeric_limits<double>::max();
    switch (kind) {
      case Kind::kUniform:
        return static_cast<double>(random_() >> 11) * 0x1p-53;
      case Kind::kGrid:
        return below(8) == 0 ? shifted(whole(1 << 20)) : shifted(whole(3));
      case Kind::kGridUlp: {
        const double x = shifted(1 + static_cast<double>(below(4)));
        return below(3) == 0 ? std::nextafter(x, below(2) == 0 ? 0 : huge) : x;
      }
      case Kind::kFarCluster:
        return 0x1p20 + whole(3) * 0x1p-32;
      case Kind::kSphere:
        return whole(1 << 30) + 0.5;
      case Kind::kSpread:
        return std::ldexp(whole(1L << 53), static_cast<int>(below(40)) - 70);
      case Kind::kMixed:
        return std::ldexp(whole(1L << 53), static_cast<int>(below(1996)) - 1050);
      case Kind::kDenormal:
        return std::ldexp(whole(below(2) == 0 ? 3 : 1L << 50), -1074);
      case Kind::kOverflowing:
        return whole(1) * (huge - static_cast<double>(below(3)) * 0x1p971);
      case Kind::kSmallScales:
        return std::ldexp(below(2) == 0 ? whole(2) : whole(1L << 53) * 0x1p-53,
                          -188 - static_cast<int>(below(4)));
      case Kind::kIntegers:
        return whole(std::uint64_t{1} << bits_);
      case Kind::kHeavy:
        return whole(4);
    }
    return 0;
  }

  // Often the square of the point's length, rounded: then the heights nearly cancel.
  double weight(Kind kind, double squares) {
    if (kind == Kind::kHeavy) return std::ldexp(whole(1L << 53), 969 - static_cast<int>(below(4)));
    if (below(3) == 0) {
      const bool heavy = kind == Kind::kIntegers && below(2) == 0;
      return std::ldexp(number(kind), heavy ? static_cast<int>(below(90)) : 0);
    }
    return std::isfinite(squares) && below(2) == 0 ? squares : 0;
  }

  std::mt19937_64 random_;
  int scale_ = 0;
  std::uint64_t bits_ = 1;
};

// The answers of kernel/predicates for sites.

using Vertices = std::vector<std::ptrdiff_t>;

// Sites, taken exactly.
class ReferenceSigns {
 public:
  // Each as its coordinates; weights: none or one each.
  ReferenceSigns(const std::vector<std::vector<double>>& points,
                 const std::vector<double>& weights);
  ~ReferenceSigns();

  int orientation(const Vertices& simplex) const;
  // The sign of the ball's polynomial, for a simplex and a query: in_ball times the orientation. It
  // is antisymmetric, so another simplex of these sites defines it if the first is degenerate; zero
  // if all are.
  int ball(const Vertices& vertices) const;
  // For a simplex and a query that is not one of its vertices. Requires: not degenerate.
  int perturbed_ball(const Vertices& vertices) const;

 private:
  struct Exact;
  std::unique_ptr<const Exact> exact_;
};

template <typename SomeSites>
ReferenceSigns reference_signs(const SomeSites& sites, bool weighted) {
  std::vector<std::vector<double>> points;
  std::vector<double> weights;
  for (const auto& site : sites) {
    points.emplace_back(site.at.begin(), site.at.end());
    if (weighted) weights.push_back(site.weight);
  }
  return {points, weights};
}

}  // namespace circumspect::fast
