#include "reference/constrained/event_time.hpp"

#include <algorithm>
#include <array>

#include "reference/predicates/orientation.hpp"
#include "reference/predicates/space_axes.hpp"

namespace circumspect::constrained {
namespace {

std::strong_ordering ordering(const Rational& a, const Rational& b) {
  const int order = cmp(a, b);
  return order <=> 0;
}

// c_v for each of the five vertices: with the apex at −1 for the apex itself, the others are its
// barycentric coordinates in the tetrahedron. Multiplied by |det(tetrahedron)|.
std::vector<std::pair<Vertex, Rational>> affine_dependence(const PointSet& points,
                                                           const Simplex& tetrahedron,
                                                           Vertex apex) {
  const Configuration& configuration = points.configuration();
  const Rational own = orientation_determinant(configuration, kSpace, tetrahedron);
  std::vector<std::pair<Vertex, Rational>> dependence = {{apex, -abs(own)}};
  for (std::size_t place = 0; place < tetrahedron.size(); ++place) {
    const Simplex replaced = with_vertex_replaced(tetrahedron, place, apex);
    const Rational value = orientation_determinant(configuration, kSpace, replaced);
    dependence.emplace_back(tetrahedron[place], sign(own) * value);
  }
  return dependence;
}

}  // namespace

std::strong_ordering operator<=>(const EventTime& a, const EventTime& b) {
  if (const auto order = ordering(a.standard, b.standard); order != 0) return order;
  auto x = a.infinitesimal.begin();
  auto y = b.infinitesimal.begin();
  while (x != a.infinitesimal.end() || y != b.infinitesimal.end()) {
    const bool only_x =
        y == b.infinitesimal.end() || (x != a.infinitesimal.end() && x->first < y->first);
    if (only_x) return ordering(x->second, Rational(0));
    const bool only_y = x == a.infinitesimal.end() || y->first < x->first;
    if (only_y) return ordering(Rational(0), y->second);
    if (const auto order = ordering(x->second, y->second); order != 0) return order;
    ++x;
    ++y;
  }
  return std::strong_ordering::equal;
}

std::optional<EventTime> event_time(const PolygonInSpace& polygon, const Simplex& tetrahedron,
                                    Vertex apex) {
  const PointSet& points = polygon.points();
  const auto dependence = affine_dependence(points, tetrahedron, apex);
  Rational slope = 0;
  for (const auto& [v, c] : dependence) {
    if (polygon.side(v) > 0) slope += c * polygon.distance(v);
  }
  if (sign(slope) <= 0) return std::nullopt;
  EventTime time;
  for (const auto& [v, c] : dependence) {
    if (sign(c) == 0) continue;
    time.standard -= c * squared_length(points[v]);
    time.infinitesimal.emplace_back(points.configuration().rank(v), c / slope);
  }
  time.standard /= slope;
  std::sort(time.infinitesimal.begin(), time.infinitesimal.end());
  return time;
}

}  // namespace circumspect::constrained
