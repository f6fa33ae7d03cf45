#include "oracle/judge/definition/quality.hpp"

#include <algorithm>

#include "kernel/complex/circumball.hpp"
#include "kernel/complex/point_set.hpp"

namespace circumspect::definition {
namespace {

using Corners = std::vector<Point>;

// What is left of a vector without its part along another.
Point across(const Point& vector, const Point& along) {
  const Rational part = inner_product(vector, along) / squared_length(along);
  return vector - part * along;
}

std::vector<Rational> squared_edges(const Corners& corners) {
  std::vector<Rational> all;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) all.push_back(squared_distance(corners[i], corners[j]));
  }
  return all;
}

std::vector<Rational> angles(const Corners& corners) {
  std::vector<Rational> all;
  for (const Point& a : corners) {
    for (const Point& b : corners) {
      for (const Point& c : corners) {
        if (a != b && a != c && b != c) all.push_back(signed_square_at({a}, b, c));
      }
    }
  }
  return all;
}

std::vector<Rational> dihedral_angles(const Corners& corners) {
  std::vector<Rational> all;
  Corners turned = corners;  // every edge comes first in some order
  std::sort(turned.begin(), turned.end());
  do {
    all.push_back(signed_square_at({turned[0], turned[1]}, turned[2], turned[3]));
  } while (std::next_permutation(turned.begin(), turned.end()));
  return all;
}

// The square of the distance of the first corner from the flat through the others.
Rational squared_height(const Corners& corners) {
  Point height = corners[0] - corners[1];
  std::vector<Point> flat;  // orthogonal
  for (std::size_t i = 2; i < corners.size(); ++i) {
    Point direction = corners[i] - corners[1];
    for (const Point& other : flat) direction = across(direction, other);
    flat.push_back(direction);
    height = across(height, direction);
  }
  return squared_length(height);
}

Rational least_squared_height(const Corners& corners) {
  Rational least = squared_height(corners);
  for (std::size_t i = 1; i < corners.size(); ++i) {
    Corners other = corners;
    std::swap(other[0], other[i]);
    least = std::min(least, squared_height(other));
  }
  return least;
}

// The square of length, area or volume.
Rational squared_size(const Corners& corners) {
  if (corners.size() == 1) return 1;
  const Corners base(corners.begin() + 1, corners.end());
  const Rational dimension(static_cast<long>(base.size()));
  return squared_size(base) * squared_height(corners) / (dimension * dimension);
}

Rational squared_circumradius(const Corners& corners) {
  Simplex all;
  for (std::size_t i = 0; i < corners.size(); ++i) all.push_back(static_cast<Vertex>(i));
  return circumball(PointSet(corners), all).squared_radius;
}

Rational least(std::vector<Rational> values) {
  return *std::min_element(values.begin(), values.end());
}
Rational most(std::vector<Rational> values) {
  return *std::max_element(values.begin(), values.end());
}

}  // namespace

Rational signed_square_at(const std::vector<Point>& ridge, const Point& a, const Point& b) {
  Point u = a - ridge.front(), v = b - ridge.front();
  if (ridge.size() == 2) {
    const Point along = ridge.back() - ridge.front();
    u = across(u, along);
    v = across(v, along);
  }
  const Rational inner = inner_product(u, v);
  return inner * abs(inner) / (squared_length(u) * squared_length(v));
}

std::optional<Rational> measured(Measure measure, const std::vector<Point>& corners) {
  if (affine_hull(corners).basis.size() < corners.size()) return std::nullopt;
  switch (measure) {
    case Measure::kMinAngle:
      return most(angles(corners));
    case Measure::kMaxAngle:
      return least(angles(corners));
    case Measure::kMinDihedral:
      return most(dihedral_angles(corners));
    case Measure::kMaxDihedral:
      return least(dihedral_angles(corners));
    case Measure::kRadiusEdge:
      return squared_circumradius(corners) / least(squared_edges(corners));
    case Measure::kAspectRatio:
      return most(squared_edges(corners)) / least_squared_height(corners);
    case Measure::kVolume:
    case Measure::kArea:
      return squared_size(corners);
    case Measure::kEdge:
      return most(squared_edges(corners));
    case Measure::kMinEdge:
      return least(squared_edges(corners));
  }
  return std::nullopt;
}

std::vector<std::size_t> not_keeping(const Requirement& requirement,
                                     const std::vector<Point>& points,
                                     const std::vector<Simplex>& simplices) {
  std::size_t size = 0;
  for (const Simplex& simplex : simplices) size = std::max(size, simplex.size());
  std::vector<std::size_t> found;
  for (std::size_t s = 0; s < simplices.size(); ++s) {
    Corners corners;
    for (const Vertex v : simplices[s]) {
      if (v >= 0 && v < static_cast<Vertex>(points.size())) {
        corners.push_back(points[static_cast<std::size_t>(v)]);
      }
    }
    if (corners.size() != size || simplices[s].size() != size) continue;
    const auto value = measured(requirement.measure, corners);
    if (value && !keeps(requirement, *value)) found.push_back(s);
  }
  return found;
}

}  // namespace circumspect::definition
