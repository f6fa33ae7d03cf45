#include "reference/constrained/clear_apex.hpp"

#include <algorithm>
#include <utility>

#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/perturbation.hpp"

namespace circumspect::constrained {

namespace {

// A point of the facet by its barycentric coordinates; an affine function on the facet by its
// values at the vertices.
using OnFacet = Point;

// The part of a convex polygon where the function is not negative. (A segment is a polygon with two
// corners; both of its sides are clipped, to the same.)
std::vector<OnFacet> clip(const std::vector<OnFacet>& polygon, const OnFacet& function) {
  std::vector<OnFacet> part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const OnFacet& p = polygon[i];
    const OnFacet& q = polygon[(i + 1) % polygon.size()];
    const Rational at_p = inner_product(function, p);
    const Rational at_q = inner_product(function, q);
    if (sign(at_p) >= 0) part.push_back(p);
    if (sign(at_p) * sign(at_q) < 0) {
      const Rational share = at_p / (at_p - at_q);
      part.push_back(p + share * (q - p));
    }
  }
  return part;
}

std::vector<OnFacet> corners(std::size_t count) {
  std::vector<OnFacet> units(count, OnFacet(count, Rational(0)));
  for (std::size_t i = 0; i < count; ++i) units[i][i] = 1;
  return units;
}

bool is_all_on_one_side(const std::vector<int>& sides) {
  return std::all_of(sides.begin(), sides.end(), [](int side) { return side <= 0; }) ||
         std::all_of(sides.begin(), sides.end(), [](int side) { return side >= 0; });
}

// Does a hyperplane through a facet of the simplex, or through the facet itself, separate them?
// Mostly one does, and signs are cheaper than numbers.
bool is_apart(const Configuration& configuration, std::span<const std::size_t> axes,
              const Simplex& simplex, int own, const Simplex& facet) {
  for (std::size_t place = 0; place < simplex.size(); ++place) {
    const bool is_beyond = std::all_of(facet.begin(), facet.end(), [&](Vertex v) {
      if (contains(simplex, v)) return v != simplex[place];
      return own * orientation(configuration, axes, with_vertex_replaced(simplex, place, v)) <= 0;
    });
    if (is_beyond) return true;
  }
  if (facet.size() < axes.size()) return false;
  if (facet.size() < simplex.size() - 1) return false;  // It does not span a hyperplane.
  std::vector<int> sides;
  for (const Vertex v : simplex) {
    sides.push_back(contains(facet, v) ? 0 : side_of_facet(configuration, axes, facet, v));
  }
  return is_all_on_one_side(sides);
}

}  // namespace

bool meets_interior(const PointSet& points, std::span<const std::size_t> axes,
                    const Simplex& simplex, const Simplex& facet) {
  const Configuration& configuration = points.configuration();
  const int own = orientation(configuration, axes, simplex);
  if (is_apart(configuration, axes, simplex, own, facet)) return false;
  std::vector<OnFacet> halfspaces;  // positive on the side of the simplex's vertex at a place
  for (std::size_t place = 0; place < simplex.size(); ++place) {
    OnFacet function;
    for (const Vertex v : facet) {
      const bool is_on = contains(simplex, v) && v != simplex[place];
      function.push_back(
          is_on ? Rational(0)
                : own * orientation_determinant(configuration, axes,
                                                with_vertex_replaced(simplex, place, v)));
    }
    halfspaces.push_back(function);
  }

  std::vector<OnFacet> part = corners(facet.size());
  for (const OnFacet& function : halfspaces) part = clip(part, function);
  if (part.empty()) return false;
  const OnFacet inside = barycentre(part);
  return std::all_of(halfspaces.begin(), halfspaces.end(), [&](const OnFacet& function) {
    return sign(inner_product(function, inside)) > 0;
  });
}

Obstacles::Obstacles(const PointSet& points, std::vector<std::size_t> axes,
                     std::vector<Simplex> obstacles)
    : points_(points),
      axes_(std::move(axes)),
      obstacles_(std::move(obstacles)),
      boxes_(points),
      index_(boxes_.index_of(obstacles_)) {}

std::optional<Simplex> Obstacles::inside(const Simplex& simplex) const {
  for (const std::size_t i : index_.meeting(boxes_.of(simplex))) {
    if (meets_interior(points_, axes_, simplex, obstacles_[i])) return obstacles_[i];
  }
  return std::nullopt;
}

InFront first_clear_apex(const PointSet& points, const std::vector<std::size_t>& axes,
                         const OrientedFacet& facet, const std::vector<Vertex>& candidates,
                         const std::function<bool(const Simplex&)>& is_clear) {
  std::vector<Vertex> in_front;
  for (const Vertex q : candidates) {
    if (contains(facet.vertices, q)) continue;
    if (orientation(points.configuration(), axes, join(facet, q)) > 0) in_front.push_back(q);
  }
  // A heap whose top is the first in the pencil: a comes later than b iff b is in the ball of a.
  const auto comes_later = [&](Vertex a, Vertex b) {
    return a != b && perturbed_in_ball(points.configuration(), axes, join(facet, a), b) > 0;
  };
  InFront result{!in_front.empty(), std::nullopt};
  std::make_heap(in_front.begin(), in_front.end(), comes_later);
  while (!in_front.empty() && !result.apex) {
    std::pop_heap(in_front.begin(), in_front.end(), comes_later);
    if (is_clear(join(facet, in_front.back()))) result.apex = in_front.back();
    in_front.pop_back();
  }
  return result;
}

}  // namespace circumspect::constrained
