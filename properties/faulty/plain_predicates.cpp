#include "properties/faulty/plain_predicates.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <set>

#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/orientation.hpp"
#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::faulty {

namespace {

std::vector<Point> exact_coordinates(const PointArray& points) {
  std::vector<Point> exact(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t axis = 0; axis < points.dimension; ++axis) {
      exact[i].push_back(exact_value(points.point(i)[axis]));
    }
  }
  return exact;
}

}  // namespace

PointSet exact_points(const PointArray& points) {
  std::vector<Rational> weights;
  for (const double weight : points.weights) weights.push_back(exact_value(weight));
  return PointSet(exact_coordinates(points), std::move(weights));
}

SimplexArray right_answer(const PointArray& points) {
  const std::vector<Point> all = exact_coordinates(points);
  std::set<Point> seen;
  std::vector<Vertex> first;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (seen.insert(all[i]).second) first.push_back(static_cast<Vertex>(i));
  }
  const Triangulation canonical = delaunay::bowyer_watson(exact_points(selection(points, first)));
  SimplexArray simplices;
  for (const Simplex& simplex : canonical.simplices()) {
    simplices.emplace_back(simplex.begin(), simplex.end());
  }
  return renumbered(std::move(simplices), first);
}

PointArray selection(const PointArray& points, const std::vector<Vertex>& kept) {
  PointArray some{points.dimension};
  for (const Vertex v : kept) {
    const auto i = static_cast<std::size_t>(v);
    some.coordinates.insert(some.coordinates.end(), points.point(i),
                            points.point(i) + points.dimension);
    if (!points.weights.empty()) some.weights.push_back(points.weights[i]);
  }
  return some;
}

SimplexArray renumbered(SimplexArray simplices, const std::vector<Vertex>& kept) {
  for (auto& simplex : simplices) {
    for (auto& v : simplex) v = kept[static_cast<std::size_t>(v)];
  }
  return simplices;
}

std::pair<double, double> extent(const PointArray& points, std::size_t axis) {
  double low = points.point(0)[axis], high = low;
  for (std::size_t i = 1; i < points.size(); ++i) {
    low = std::min(low, points.point(i)[axis]);
    high = std::max(high, points.point(i)[axis]);
  }
  return {low, high};
}

std::vector<Vertex> every_index(const PointArray& points) {
  std::vector<Vertex> all(points.size());
  std::iota(all.begin(), all.end(), Vertex{0});
  return all;
}

namespace {

template <typename Number>
using Matrix = std::vector<std::vector<Number>>;

// An integer of 64 bits that wraps round. Requires: x is an integer that fits.
struct Wrapping {
  std::uint64_t bits = 0;
  Wrapping(int x) : bits(static_cast<std::uint64_t>(x)) {}
  explicit Wrapping(double x) : bits(static_cast<std::uint64_t>(static_cast<std::int64_t>(x))) {}
  friend Wrapping operator+(Wrapping a, Wrapping b) { return of(a.bits + b.bits); }
  friend Wrapping operator-(Wrapping a, Wrapping b) { return of(a.bits - b.bits); }
  friend Wrapping operator*(Wrapping a, Wrapping b) { return of(a.bits * b.bits); }
  Wrapping& operator+=(Wrapping other) { return *this = *this + other; }
  explicit operator long double() const {
    return static_cast<long double>(static_cast<std::int64_t>(bits));
  }

 private:
  static Wrapping of(std::uint64_t bits) {
    Wrapping number(0);
    number.bits = bits;
    return number;
  }
};

// By expansion along the first row.
template <typename Number>
Number determinant(const Matrix<Number>& rows) {
  if (rows.empty()) return 1;
  Number sum = 0;
  for (std::size_t column = 0; column < rows.size(); ++column) {
    Matrix<Number> minor;
    for (std::size_t row = 1; row < rows.size(); ++row) {
      minor.push_back(rows[row]);
      minor.back().erase(minor.back().begin() + static_cast<std::ptrdiff_t>(column));
    }
    const Number term = rows[0][column] * determinant(minor);
    sum = column % 2 == 0 ? sum + term : sum - term;
  }
  return sum;
}

int sign_beyond(long double value, long double tolerance) {
  if (value > tolerance) return 1;
  return value < -tolerance ? -1 : 0;
}

// Is the number large enough to be believed? One that overflowed is believed too.
bool is_trusted(long double value, double beyond) { return !(std::abs(value) <= beyond); }

}  // namespace

template <typename Number>
Number PlainPredicates::orientation_of(std::span<const std::size_t> axes,
                                       std::span<const Vertex> simplex) const {
  const double* last = points_.point(static_cast<std::size_t>(simplex.back()));
  Matrix<Number> rows;
  for (const Vertex v : simplex.first(simplex.size() - 1)) {
    const double* p = points_.point(static_cast<std::size_t>(v));
    rows.emplace_back();
    for (const std::size_t axis : axes) {
      rows.back().push_back(static_cast<Number>(p[axis]) - static_cast<Number>(last[axis]));
    }
  }
  return determinant(rows);
}

template <typename Number>
Number PlainPredicates::in_ball_of(std::span<const std::size_t> axes,
                                   std::span<const Vertex> simplex, Vertex q) const {
  const auto weight = [this](Vertex v) {
    return points_.weights.empty() ? Number(0)
                                   : Number(points_.weights[static_cast<std::size_t>(v)]);
  };
  const double* centre = points_.point(static_cast<std::size_t>(q));
  const std::size_t heights = points_.dimension - (arithmetic_.forgets_last_axis ? 1u : 0u);
  Matrix<Number> rows;
  for (const Vertex v : simplex) {
    const double* p = points_.point(static_cast<std::size_t>(v));
    Number height = weight(q) - weight(v);
    for (std::size_t axis = 0; axis < heights; ++axis) {
      const auto here = static_cast<Number>(p[axis]), there = static_cast<Number>(centre[axis]);
      const Number x = here - there;
      height += arithmetic_.heights_from_the_origin ? here * here - there * there : x * x;
    }
    rows.emplace_back();
    for (const std::size_t axis : axes) {
      rows.back().push_back(static_cast<Number>(p[axis]) - static_cast<Number>(centre[axis]));
    }
    rows.back().push_back(height);
  }
  return determinant(rows);
}

long double PlainPredicates::in_numbers(bool is_orientation, std::span<const std::size_t> axes,
                                        std::span<const Vertex> simplex, Vertex q) const {
  const auto value = [&]<typename Number>(Number) {
    return static_cast<long double>(is_orientation ? orientation_of<Number>(axes, simplex)
                                                   : in_ball_of<Number>(axes, simplex, q));
  };
  switch (arithmetic_.numbers) {
    case Numbers::kFloat:
      return value(0.0F);
    case Numbers::kLongDouble:
      return value(0.0L);
    case Numbers::kWrapping:
      return value(Wrapping(0));
    default:
      return value(0.0);
  }
}

int PlainPredicates::orientation(std::span<const std::size_t> axes,
                                 std::span<const Vertex> simplex) const {
  if (arithmetic_.numbers != Numbers::kExact || arithmetic_.orientation_tolerance > 0) {
    const long double value = in_numbers(true, axes, simplex, 0);
    if (is_trusted(value, arithmetic_.trusted_beyond) || arithmetic_.trusted_beyond == 0) {
      return sign_beyond(value, arithmetic_.orientation_tolerance);
    }
  }
  return circumspect::orientation(exact_.configuration(), axes, simplex);
}

int PlainPredicates::in_ball(std::span<const std::size_t> axes, std::span<const Vertex> simplex,
                             Vertex q) const {
  if (arithmetic_.by_circumcentre) return in_computed_ball(axes, simplex, q);
  if (arithmetic_.numbers != Numbers::kExact || arithmetic_.in_ball_tolerance > 0 ||
      arithmetic_.forgets_last_axis) {
    const long double value = in_numbers(false, axes, simplex, q);
    if (is_trusted(value, arithmetic_.trusted_beyond) || arithmetic_.trusted_beyond == 0) {
      return orientation(axes, simplex) * sign_beyond(value, arithmetic_.in_ball_tolerance);
    }
  }
  if (circumspect::orientation(exact_.configuration(), axes, simplex) == 0) return 0;
  return circumspect::in_ball(exact_.configuration(), axes, simplex, q);
}

// The centre by Cramer's rule, then the signs of r² − |q − o|².
int PlainPredicates::in_computed_ball(std::span<const std::size_t> axes,
                                      std::span<const Vertex> simplex, Vertex q) const {
  const double* base = points_.point(static_cast<std::size_t>(simplex.back()));
  Matrix<double> rows;
  std::vector<double> right;
  for (const Vertex v : simplex.first(simplex.size() - 1)) {
    const double* p = points_.point(static_cast<std::size_t>(v));
    rows.emplace_back();
    right.push_back(0);
    for (const std::size_t axis : axes) {
      rows.back().push_back(p[axis] - base[axis]);
      right.back() += (p[axis] - base[axis]) * (p[axis] - base[axis]) / 2;
    }
  }
  const double volume = determinant(rows);
  const double* p = points_.point(static_cast<std::size_t>(q));
  double squared_radius = 0, squared_distance = 0;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    Matrix<double> replaced = rows;
    for (std::size_t row = 0; row < rows.size(); ++row) replaced[row][i] = right[row];
    const double exactly = determinant(replaced) / volume;
    const double centre =
        arithmetic_.circumballs_in_floats ? double{static_cast<float>(exactly)} : exactly;
    const double x = p[axes[i]] - base[axes[i]] - centre;
    squared_radius += centre * centre;
    squared_distance += x * x;
  }
  return sign_beyond(arithmetic_.circumballs_in_floats
                         ? static_cast<float>(squared_radius) - squared_distance
                         : squared_radius - squared_distance,
                     0);
}

}  // namespace circumspect::faulty
