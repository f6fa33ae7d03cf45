// The nearest vertex is what a look at each vertex finds.
#include "oracle/judge/domain/vertex_search.hpp"

#include <doctest/doctest.h>

#include "inputs/dice.hpp"
#include "kernel/exact/each_once.hpp"
#include "oracle/judge/definition/distance.hpp"

namespace circumspect::check {
namespace {

using generators::Dice;

Point drawn_point(std::size_t dimension, Dice& dice) {
  const long scale = dice.below(4) == 0 ? 1000 : 1;
  Point point;
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    point.push_back(Rational(scale * dice.within(-4L, 4L)));
  }
  return point;
}

std::optional<NearestVertex> nearest_of_all(const ExactMesh& mesh, const std::vector<bool>& used,
                                            const std::vector<Point>& target) {
  std::optional<NearestVertex> best;
  for (Vertex v = 0; mesh.points.names(v); ++v) {
    if (!used[static_cast<std::size_t>(v)]) continue;
    const Rational squared = definition::squared_distance_between({mesh.points[v]}, target);
    if (target.size() > 1 && squared == 0) continue;
    if (!best || squared < best->squared_distance) best = {v, squared};
  }
  return best;
}

bool are_equal(const std::optional<NearestVertex>& a, const std::optional<NearestVertex>& b) {
  if (!a || !b) return !a && !b;
  return a->vertex == b->vertex && a->squared_distance == b->squared_distance;
}

TEST_CASE(
    "the nearest vertex to a point or a segment, wherever it is, and ties to the lower index") {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    Dice dice(seed);
    const std::size_t dimension = 2 + dice.below(2);
    std::vector<Point> points;
    for (std::size_t more = 1 + dice.below(12); more > 0; --more) {
      points.push_back(drawn_point(dimension, dice));
    }
    keep_each_once(points);
    const ExactMesh mesh{PointSet(points), {}};
    std::vector<bool> used;
    for (std::size_t v = 0; v < points.size(); ++v) used.push_back(dice.below(5) > 0);
    VertexSearch search(mesh, used);
    for (int question = 0; question < 3; ++question) {
      const Point a = drawn_point(dimension, dice), b = drawn_point(dimension, dice);
      CHECK(are_equal(search.to_point(a), nearest_of_all(mesh, used, {a})));
      if (a == b) continue;
      CHECK(are_equal(search.to_segment(a, b), nearest_of_all(mesh, used, {a, b})));
    }
  }
}

}  // namespace
}  // namespace circumspect::check
