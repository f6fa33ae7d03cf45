#include "oracle/certificate/separators.hpp"

#include <algorithm>

namespace circumspect::certificate {

Point perpendicular(const Point& u, const Point& v) {
  const Rational length = squared_length(v);
  return sgn(length) == 0 ? u : length * u - inner_product(u, v) * v;
}

namespace {

struct Separator {
  Point normal;
  Rational offset;
};

// Of two disjoint convex sets the nearest points are on corners, edges or a triangle: one of these
// planes is between.
std::optional<Separator> separator(const std::vector<Point>& corners, const Point& a,
                                   const Point& b, const auto& condition) {
  std::vector<Point> directions = {b - a};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    directions.push_back(a - corners[i]);
    directions.push_back(b - corners[i]);
    for (std::size_t j = 0; j < i; ++j) directions.push_back(corners[i] - corners[j]);
  }
  std::vector<Point> normals = directions;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    for (std::size_t j = 0; j < directions.size(); ++j) {
      if (i != j) normals.push_back(perpendicular(directions[i], directions[j]));
      if (i < j && a.size() == 3) normals.push_back(cross_product(directions[i], directions[j]));
    }
  }
  for (const Point& normal : normals) {
    for (const int sign : {1, -1}) {
      Separator plane{Rational(sign) * normal, 0};
      plane.offset = inner_product(plane.normal, corners.front());
      for (const Point& corner : corners) {
        plane.offset = std::max(plane.offset, inner_product(plane.normal, corner));
      }
      if (condition(plane)) return plane;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<Separators> separators(const std::vector<std::vector<Point>>& parts, const Point& a,
                                     const Point& b, bool with_end) {
  std::vector<Separator> planes;
  Separators made;
  for (const std::vector<Point>& corners : parts) {
    const auto parts_it = [&](const Separator& plane) {
      const Rational at_b = inner_product(plane.normal, b);
      return inner_product(plane.normal, a) > plane.offset &&
             (with_end ? at_b > plane.offset : at_b >= plane.offset) &&
             std::all_of(corners.begin(), corners.end(), [&](const Point& corner) {
               return inner_product(plane.normal, corner) <= plane.offset;
             });
    };
    if (std::any_of(planes.begin(), planes.end(), parts_it)) continue;
    auto found = separator(corners, a, b, parts_it);
    if (!found) return std::nullopt;
    const Integer common = common_denominator(found->normal);
    found->normal = Rational(common) * found->normal;
    found->offset *= common;
    for (const Rational& x : found->normal) made.words += " " + x.get_str();
    made.words += " " + found->offset.get_str();
    ++made.count;
    planes.push_back(std::move(*found));
  }
  return made;
}

std::vector<Point> samples(const std::vector<Point>& corners) {
  constexpr int kMuch = 8;
  std::vector<Point> found;
  if (corners.size() < 2) return found;
  found.push_back(circumspect::barycentre(corners));
  for (const Point& corner : corners) {
    found.push_back(Rational(1, kMuch + 1) * (Rational(kMuch) * corner + found.front()));
  }
  return found;
}

std::vector<Point> directions_from(const std::vector<Point>& simplex, const Point& start) {
  const std::size_t dimension = start.size();
  std::vector<Point> found;
  for (std::size_t axis = 0; axis < dimension; ++axis)
    found.emplace_back(dimension, 0).at(axis) = 1;
  for (std::size_t place = 0; place < simplex.size() && simplex.size() == dimension + 1; ++place) {
    std::vector<Point> facet = simplex;
    facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(place));
    const Point edge = facet[1] - facet[0];
    found.push_back(dimension == 2 ? perpendicular(simplex[place] - facet[0], edge)
                                   : cross_product(edge, facet[2] - facet[0]));
    const Point away = start - simplex[place];
    found.push_back(Rational(common_denominator(away)) * away);
  }
  return found;
}

}  // namespace circumspect::certificate
