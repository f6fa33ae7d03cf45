#include "oracle/certificate/scaled_points.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "oracle/judge/fast/predicates/lattice.hpp"
#include "oracle/judge/fast/predicates/nearby.hpp"
#include "oracle/judge/fast/predicates/predicates.hpp"

namespace circumspect::certificate {

namespace {

// The least common multiple of all denominators, or 0 if the points would take too many bits.
Integer least_common_denominator(const PointSet& points, double most_bits) {
  Integer scale = 1;
  const auto numbers = static_cast<double>(points.size() * points.ambient_dimension());
  for (const Point& point : points.points()) {
    scale = common_denominator(point, scale);
    if (static_cast<double>(bit_length(scale)) * numbers > most_bits) return 0;
  }
  return scale;
}

// Divides the coordinates by what they have in common, and sets the scale. The denominator is the
// least, so that it has no factor in common with all of them.
void divide_out(const Integer& denominator, ScaledPoints& scaled) {
  Integer common = 0;
  for (const Integer& x : scaled.coordinates) {
    common = gcd(common, x);
    if (common == 1) break;
  }
  scaled.scale_denominator = denominator;
  if (common <= 1) return;
  for (Integer& x : scaled.coordinates) x /= common;
  scaled.scale_numerator = common;
}

// Sets coordinates and scale. `denominator` is a common one.
void scale_coordinates(const PointSet& points, const Integer& denominator, ScaledPoints& scaled) {
  scaled.coordinates.reserve(points.size() * scaled.dimension);
  for (const Point& point : points.points()) {
    for (const Rational& x : point) scaled.coordinates.push_back(numerator_over(denominator, x));
  }
  divide_out(denominator, scaled);
}

// A small k whose square is a multiple of n: the least if n has at most one prime factor above the
// bound that makes it no square.
Integer root_of_square_multiple(Integer n) {
  constexpr unsigned kLargestTrial = 1000;
  Integer root = 1;
  for (unsigned prime = 2; prime <= kLargestTrial; ++prime) {
    std::size_t exponent = 0;
    for (; n % prime == 0; ++exponent) n /= prime;
    for (std::size_t i = 0; i < (exponent + 1) / 2; ++i) root *= prime;
  }
  const Integer rest = sqrt(n);
  return root * (rest * rest == n ? rest : n);
}

// Makes the scale so fine that the weights are integers over its square too.
void scale_weights(const PointSet& points, ScaledPoints& scaled) {
  const Rational scale = Rational(scaled.scale_numerator) / scaled.scale_denominator;
  std::vector<Rational> weights;
  for (Vertex v = 0; points.names(v); ++v) {
    weights.push_back(points.weight(v) / (scale * scale));
  }
  const Integer finer = root_of_square_multiple(common_denominator(weights));
  if (finer != 1) {
    for (Integer& x : scaled.coordinates) x *= finer;
  }
  for (const Rational& weight : weights) {
    scaled.weights.push_back(numerator_over(finer * finer, weight));
  }
  const Rational finest = scale / finer;
  scaled.scale_numerator = finest.get_num();
  scaled.scale_denominator = finest.get_den();
}

constexpr std::string_view kTooLarge =
    "a certificate lists all points as integers over one denominator, and the denominators of "
    "these have so little in common that it would take gigabytes";

}  // namespace

tl::expected<ScaledPoints, std::string> scaled_to_integers(const PointSet& points,
                                                           double most_bits) {
  ScaledPoints scaled;
  scaled.dimension = points.ambient_dimension();
  const Integer denominator = least_common_denominator(points, most_bits);
  if (denominator == 0) return tl::unexpected(std::string(kTooLarge));
  scale_coordinates(points, denominator, scaled);
  if (points.is_weighted()) scale_weights(points, scaled);
  return scaled;
}

tl::expected<ScaledPoints, std::string> scaled_to_integers(const Rows<double>& points,
                                                           double most_bits) {
  int finest = 0;  // the exponent of the unit
  for (const double x : points.values()) finest = std::min(finest, fast::dyadic(x).exponent);
  const Integer denominator = Integer(1) << static_cast<unsigned long>(-finest);
  if (static_cast<double>(bit_length(denominator)) * static_cast<double>(points.values().size()) >
      most_bits) {
    return tl::unexpected(std::string(kTooLarge));
  }
  ScaledPoints scaled;
  scaled.dimension = points.columns();
  scaled.coordinates.reserve(points.values().size());
  for (const double x : points.values()) {
    const fast::Dyadic parts = fast::dyadic(x);
    scaled.coordinates.push_back(to_integer(parts.mantissa)
                                 << static_cast<unsigned long>(parts.exponent - finest));
  }
  divide_out(denominator, scaled);
  return scaled;
}

HomogeneousPoint homogeneous(const Point& point) {
  HomogeneousPoint q{{}, common_denominator(point)};
  for (const Rational& x : point) q.numerators.push_back(numerator_over(q.denominator, x));
  return q;
}

Point ordinary(const HomogeneousPoint& q) {
  Point point;
  for (const Integer& x : q.numerators) {
    Rational ratio(x, q.denominator);
    ratio.canonicalize();
    point.push_back(ratio);
  }
  return point;
}

HomogeneousPoint in_lowest_terms(HomogeneousPoint point) {
  Integer factor = point.denominator;
  for (const Integer& x : point.numerators) factor = gcd(factor, x);
  if (factor == 1) return point;
  for (Integer& x : point.numerators) x /= factor;
  point.denominator /= factor;
  return point;
}

HomogeneousPoint scaled(const ScaledPoints& points, const Point& point) {
  const Rational factor = Rational(points.scale_denominator) / points.scale_numerator;
  return homogeneous(factor * point);
}

ScaledPoints in_scale_of(const ScaledPoints& points, const PointSet& those) {
  ScaledPoints made{points.dimension, points.scale_numerator, points.scale_denominator};
  for (const Point& point : those.points()) {
    const HomogeneousPoint there = scaled(points, point);
    for (const Integer& x : there.numerators) made.coordinates.push_back(x / there.denominator);
  }
  return made;
}

HomogeneousPoint barycentre(const ScaledPoints& points, const Simplex& vertices) {
  HomogeneousPoint sum{std::vector<Integer>(points.dimension, Integer(0)),
                       to_integer(vertices.size())};
  for (const Vertex v : vertices) {
    for (std::size_t axis = 0; axis < points.dimension; ++axis) {
      sum.numerators[axis] += points.coordinate(v, axis);
    }
  }
  return in_lowest_terms(std::move(sum));
}

int Sidedness::sign_of_determinant() {
  const auto& [a, b, c] = rows_;
  if (points_.dimension == 2) {
    determinant_ = a[0] * b[1];
    subtract_product(determinant_, a[1], b[0]);
    return sign(determinant_);
  }
  determinant_ = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    minor_ = b[j] * c[k];
    subtract_product(minor_, b[k], c[j]);
    add_product(determinant_, a[i], minor_);
  }
  return sign(determinant_);
}

bool Sidedness::has_enclosed_points() {
  constexpr std::size_t kCostOfCall = 16;  // so many points are enclosed in its time, about
  if (!enclosed_.empty() || ++calls_ <= 1 + points_.size() / kCostOfCall) return !enclosed_.empty();
  enclosed_.reserve(points_.coordinates.size());
  for (const Integer& x : points_.coordinates) {
    const double rounded = x.get_d();
    const bool is_double = std::isfinite(rounded) && x == rounded;
    enclosed_.push_back(is_double ? exactly(rounded) : enclosing(Rational(x)));
  }
  const bool are_doubles =
      std::all_of(enclosed_.begin(), enclosed_.end(), [](Interval x) { return x.low == x.high; });
  if (are_doubles) {
    doubles_.reserve(enclosed_.size());
    for (const Interval x : enclosed_) doubles_.push_back(x.low);
  }
  return !enclosed_.empty();
}

template <std::size_t kDimension>
fast::SiteRow<kDimension> Sidedness::row_of_doubles(std::span<const Vertex> simplex) const {
  fast::SiteRow<kDimension> row;
  for (std::size_t i = 0; i <= kDimension; ++i) {
    const double* const at = &doubles_[static_cast<std::size_t>(simplex[i]) * kDimension];
    std::copy_n(at, kDimension, row[i].at.begin());
  }
  return row;
}

template <std::size_t kDimension>
int Sidedness::certain_orientation_with(std::span<const Vertex> simplex, std::size_t place) const {
  fast::SiteRow<kDimension> row = row_of_doubles<kDimension>(simplex);
  std::array<double, kDimension> lengths;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    row[place].at[axis] = enclosed_moved_[axis].low;
    lengths[axis] = enclosed_moved_[axis].high - enclosed_moved_[axis].low;
  }
  const int sign = fast::orientation_nearby(row, lengths);
  return sign == fast::kUncertain ? 0 : sign;
}

void Sidedness::enclose(const HomogeneousPoint& q) {
  if (moved_to_.denominator == q.denominator && moved_to_.numerators == q.numerators) return;
  moved_to_ = q;
  for (std::size_t axis = 0; axis < points_.dimension; ++axis) {
    Rational x(q.numerators[axis], q.denominator);
    x.canonicalize();
    enclosed_moved_[axis] = enclosing(x);
  }
}

// 0: doubles do not tell.
int Sidedness::certain_sign_of_determinant() const {
  const auto& [a, b, c] = enclosed_rows_;
  if (points_.dimension == 2) return certain_sign(cross_product(a, b)[2]);
  return certain_sign(inner_product(a, cross_product(b, c)));
}

int Sidedness::orientation(std::span<const Vertex> simplex) {
  const std::size_t d = points_.dimension;
  assert(simplex.size() == d + 1);
  if (has_enclosed_points()) {
    if (!doubles_.empty()) {
      return d == 2 ? fast::orientation<2>(row_of_doubles<2>(simplex), stages_)
                    : fast::orientation<3>(row_of_doubles<3>(simplex), stages_);
    }
    for (std::size_t i = 0; i < d; ++i) {
      for (std::size_t axis = 0; axis < d; ++axis) {
        enclosed_rows_[i][axis] = enclosed(simplex[i], axis) - enclosed(simplex[d], axis);
      }
    }
    if (const int sign = certain_sign_of_determinant(); sign != 0) return sign;
  }
  for (std::size_t i = 0; i < d; ++i) {
    for (std::size_t axis = 0; axis < d; ++axis) {
      rows_[i][axis] = points_.coordinate(simplex[i], axis) - points_.coordinate(simplex[d], axis);
    }
  }
  return sign_of_determinant();
}

int Sidedness::orientation_with(std::span<const Vertex> simplex, std::size_t place,
                                const HomogeneousPoint& q) {
  const std::size_t d = points_.dimension;
  assert(simplex.size() == d + 1);
  if (has_enclosed_points()) {
    enclose(q);
    if (!doubles_.empty()) {
      const int sign = d == 2 ? certain_orientation_with<2>(simplex, place)
                              : certain_orientation_with<3>(simplex, place);
      if (sign != 0) return sign;
    }
    const auto at = [&](std::size_t i, std::size_t axis) {
      return i == place ? enclosed_moved_[axis] : enclosed(simplex[i], axis);
    };
    for (std::size_t i = 0; i < d; ++i) {
      for (std::size_t axis = 0; axis < d; ++axis) {
        enclosed_rows_[i][axis] = at(i, axis) - at(d, axis);
      }
    }
    if (const int sign = certain_sign_of_determinant(); sign != 0) return sign;
  }
  for (std::size_t i = 0; i < d; ++i) {
    for (std::size_t axis = 0; axis < d; ++axis) {
      Integer& entry = rows_[i][axis];
      const Integer& last = points_.coordinate(simplex[d], axis);
      if (i == place) {  // a row times the positive denominator
        entry = q.numerators[axis];
        subtract_product(entry, q.denominator, last);
      } else if (place == d) {
        entry = q.denominator * points_.coordinate(simplex[i], axis);
        entry -= q.numerators[axis];
      } else {
        entry = points_.coordinate(simplex[i], axis) - last;
      }
    }
  }
  return sign_of_determinant();
}

std::optional<std::size_t> Sidedness::separating_place(std::span<const Vertex> simplex, int own,
                                                       const HomogeneousPoint& q,
                                                       std::size_t first) {
  for (std::size_t i = 0; i < simplex.size(); ++i) {
    const std::size_t place = (first + i) % simplex.size();
    if (orientation_with(simplex, place, q) * own < 0) return place;
  }
  return std::nullopt;
}

}  // namespace circumspect::certificate
