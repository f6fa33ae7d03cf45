#include "reference/piecewise_linear/validity.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>

#include "reference/piecewise_linear/breaches.hpp"
#include "reference/piecewise_linear/lines.hpp"

namespace circumspect {
namespace {

// What is in `a` and not in `b`, both ascending.
template <typename A, typename B>
std::vector<typename A::value_type> difference(const A& a, const B& b) {
  std::vector<typename A::value_type> result;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

}  // namespace

tl::expected<PiecewiseLinearComplex, std::vector<Breach>> validated(
    const PiecewiseLinearInput& input, std::size_t limit) {
  BreachList found(limit);
  const auto breaches = [&] { return tl::make_unexpected(found.breaches()); };
  find_list_breaches(input, found);
  if (!found.empty()) return breaches();
  {
    const PointSet points(input.points);
    find_plane_breaches(input, points, found);
    find_segment_breaches(points, segments_of(input), found);
    if (!found.empty()) return breaches();
  }
  PiecewiseLinearComplex complex = assemble(input);
  find_area_breaches(input, complex, found);
  if (!found.empty()) return breaches();
  find_piercing_segments(complex, found);
  if (!found.empty()) return breaches();
  find_polygon_pair_breaches(complex, found);
  find_hole_seed_breaches(complex, found);
  if (!found.empty()) return breaches();
  return complex;
}

std::vector<Adoption> adoptions(const PiecewiseLinearInput& input,
                                const PiecewiseLinearComplex& complex) {
  assert(input.polygons.size() == complex.polygons.size());
  std::vector<Adoption> result;
  for (std::size_t i = 0; i < input.polygons.size(); ++i) {
    const Polygon& polygon = complex.polygons[i];
    const std::vector<Vertex> vertices = vertices_of(input.polygons[i]);
    const std::set<Simplex> segments = edges_of(input.polygons[i]);
    const Adoption adoption = {
        i, difference(polygon.vertices, vertices), difference(polygon.segments, segments),
        difference(vertices, polygon.vertices), difference(segments, polygon.segments)};
    const bool differs = polygon.vertices != vertices || !adoption.segments.empty() ||
                         !adoption.left_segments.empty();
    if (differs) result.push_back(adoption);
  }
  return result;
}

}  // namespace circumspect
