// It triangulates polygons with points inside: the polygon is the hull, with every point on it, by
// CGAL's exact predicates.
#include <algorithm>
#include <memory>
#include <numeric>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <poly2tri/poly2tri.h>

#include "lines.hpp"

namespace {

using K = CGAL::Exact_predicates_inexact_constructions_kernel;

void add_half(std::vector<std::size_t>& hull, const lines::Points& points,
              const std::vector<std::size_t>& order) {
  const std::size_t start = hull.size();
  const auto at = [&](std::size_t i) { return K::Point_2(points[i][0], points[i][1]); };
  for (const std::size_t i : order) {
    while (hull.size() > start + 1 &&
           CGAL::orientation(at(hull.end()[-2]), at(hull.back()), at(i)) == CGAL::RIGHT_TURN)
      hull.pop_back();
    hull.push_back(i);
  }
  hull.pop_back();
}

}  // namespace

int main() {
  return lines::serve([](const lines::Points& points) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](auto i, auto j) { return points[i] < points[j]; });
    std::vector<std::size_t> hull;
    add_half(hull, points, order);
    std::reverse(order.begin(), order.end());
    add_half(hull, points, order);
    std::vector<p2t::Point> own;
    for (const auto& p : points) own.emplace_back(p[0], p[1]);
    std::vector<p2t::Point*> polygon;
    for (const std::size_t i : hull) polygon.push_back(&own[i]);
    p2t::CDT cdt(polygon);
    for (p2t::Point& p : own)
      if (std::find(polygon.begin(), polygon.end(), &p) == polygon.end()) cdt.AddPoint(&p);
    cdt.Triangulate();
    lines::Simplices made;
    for (p2t::Triangle* t : cdt.GetTriangles())
      made.push_back(
          {t->GetPoint(0) - own.data(), t->GetPoint(1) - own.data(), t->GetPoint(2) - own.data()});
    return made;
  });
}
