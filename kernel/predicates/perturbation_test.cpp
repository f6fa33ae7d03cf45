// The laws of kernel/predicates/perturbation.hpp, under their numbers; and
// perturbed_in_outer_halfspace, the conflict test of ghost simplices, compared with its meaning.
#include "kernel/predicates/perturbation.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include <doctest/doctest.h>

#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/orientation.hpp"
#include "properties/arguments/generated.hpp"
#include "properties/arguments/laws.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect {
namespace {

using generators::holds_for_simplices;
using generators::PointsCase;
using generators::Scaling;
using generators::Scene;

using Vertices = std::vector<Vertex>;

int answer(const Scene& scene, Vertex q) {
  return perturbed_in_ball(scene.points, scene.axes, scene.simplex, q);
}

TEST_CASE("perturbed_in_ball: the least vertex of a square is a vertex of both its triangles") {
  const Configuration points({{0, 0}, {1, 0}, {0, 1}, {1, 1}});
  CHECK(perturbed_in_ball(points, Vertices{0, 1, 3}, 2) == -1);
  CHECK(perturbed_in_ball(points, Vertices{0, 2, 3}, 1) == -1);
  CHECK(perturbed_in_ball(points, Vertices{0, 1, 2}, 3) == 1);
  CHECK(perturbed_in_ball(points, Vertices{1, 2, 3}, 0) == 1);
}

TEST_CASE("P1 perturbed_in_ball is never zero") {
  CHECK(holds_for_simplices(1, 5, [](const PointsCase& set, Scaling scaling) {
    const Scene scene = generators::scene(set, scaling);
    for (const Vertex q : scene.queries) RC_ASSERT(answer(scene, q) * answer(scene, q) == 1);
  }));
}

TEST_CASE("P2 perturbed_in_ball equals in_ball wherever that is not zero") {
  CHECK(holds_for_simplices(1, 5, [](const PointsCase& set, Scaling scaling) {
    const Scene scene = generators::scene(set, scaling);
    for (const Vertex q : scene.queries) {
      const int side = in_ball(scene.points, scene.axes, scene.simplex, q);
      if (side != 0) RC_ASSERT(answer(scene, q) == side);
    }
  }));
}

TEST_CASE("P3 renumbering the points renumbers the answers of perturbed_in_ball") {
  CHECK(holds_for_simplices(1, 5, [](const PointsCase& set, Scaling scaling) {
    const Scene scene = generators::scene(set, scaling);
    // Point number order[v] of the set becomes number v.
    const Vertices order = generators::shuffled(generators::first_vertices(set.points.size()));
    PointsCase renumbered;
    for (const Vertex v : order) {
      const auto i = static_cast<std::size_t>(v);
      renumbered.points.push_back(set.points[i]);
      if (!set.weights.empty()) renumbered.weights.push_back(set.weights[i]);
    }
    const auto new_number = [&](Vertex v) {
      return std::find(order.begin(), order.end(), v) - order.begin();
    };
    Vertices simplex;
    for (const Vertex v : scene.simplex) simplex.push_back(new_number(v));
    const Configuration points = generators::configuration(renumbered, scaling);
    for (const Vertex q : scene.queries) {
      RC_ASSERT(perturbed_in_ball(points, scene.axes, simplex, new_number(q)) == answer(scene, q));
    }
  }));
}

TEST_CASE("P4 translation and positive uniform scaling keep perturbed_in_ball") {
  CHECK(holds_for_simplices(1, 5, [](const PointsCase& set, Scaling scaling) {
    const std::size_t dimension = set.points.front().size();
    const Rational factor = abs(*generators::small_rational()) + Rational(1, 7);
    const Point translation = *rc::gen::container<Point>(dimension, generators::small_rational());
    const PointsCase image = generators::scaled_and_moved(set, factor, translation);
    const Scene before = generators::scene(set, scaling);
    const Scene after = generators::scene(image, scaling);
    for (const Vertex q : before.queries) RC_ASSERT(answer(before, q) == answer(after, q));
  }));
}

TEST_CASE("P5 no permutation of the simplex changes perturbed_in_ball") {
  CHECK(holds_for_simplices(1, 5, [](const PointsCase& set, Scaling scaling) {
    const Scene scene = generators::scene(set, scaling);
    const Vertices shuffled = generators::shuffled(scene.simplex);
    for (const Vertex q : scene.queries) {
      RC_ASSERT(perturbed_in_ball(scene.points, scene.axes, shuffled, q) == answer(scene, q));
    }
  }));
}

// The set with weight ε^i added to the point that is number i, from 1, in lexicographic order.
PointsCase with_actual_weights(PointsCase set, const Rational& epsilon) {
  std::vector<std::size_t> order(set.points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return set.points[a] < set.points[b]; });
  set.weights.resize(set.points.size());
  Rational power = 1;
  for (const std::size_t v : order) set.weights[v] += power *= epsilon;
  return set;
}

// P6 on sets whose barycentric coordinates and in-ball amounts, where not zero, are far above the
// ε that is used, and far below 1/ε: small integers and small rationals.
TEST_CASE("P6 perturbed_in_ball equals in_ball of the points with actual weights ε^i") {
  const auto law = [](const PointsCase& set, Scaling scaling) {
    const Scene scene = generators::scene(set, scaling);
    for (const unsigned long bits : {900UL, 1000UL}) {
      const Rational epsilon(Integer(1), Integer(Integer(1) << bits));
      const PointsCase heavier = with_actual_weights(set, epsilon);
      const Configuration actual(heavier.points, heavier.weights);
      for (const Vertex q : scene.queries) {
        RC_ASSERT(in_ball(actual, scene.axes, scene.simplex, q) == answer(scene, q));
      }
    }
  };
  for (std::size_t d = 1; d <= 4; ++d) {
    const std::size_t most = d + 4;
    const auto sets = rc::gen::oneOf(generators::degenerate_point_set(d, most),
                                     generators::degenerate_point_set(d, most),
                                     generators::sets_of(generators::integer_points, d, most),
                                     generators::sets_of(generators::rational_points, d, most));
    const auto cases = rc::gen::oneOf(generators::unweighted(sets), generators::weighted(sets));
    CHECK(
        generators::holds("dimension " + std::to_string(d), generators::simplex_first(cases), law));
  }
}

TEST_CASE("P7 of two simplices at a facet, both apexes are in the other's perturbed ball or none") {
  CHECK(holds_for_simplices(1, 5, [](const PointsCase& set, Scaling scaling) {
    const Scene scene = generators::scene(set, scaling);
    const Configuration& points = scene.points;
    for (const Vertex q : scene.queries) {
      for (std::size_t place = 0; place < scene.simplex.size(); ++place) {
        Vertices other = scene.simplex;
        const Vertex apex = std::exchange(other[place], q);
        const int opposite =
            orientation(points, scene.axes, other) * orientation(points, scene.axes, scene.simplex);
        if (opposite >= 0) continue;
        RC_ASSERT(perturbed_in_ball(points, scene.axes, other, apex) == answer(scene, q));
      }
    }
  }));
}

TEST_CASE("perturbed_in_ball within the hull of all points is taken on the hull's axes") {
  CHECK(properties::holds([] {
    const Scene scene = generators::scene(*generators::simplex_and_queries(3), Scaling::kCommon);
    for (const Vertex q : scene.queries) {
      RC_ASSERT(perturbed_in_ball(scene.points, scene.simplex, q) == answer(scene, q));
    }
  }));
}

// Calls visit(points, facet, apex, q) for each facet of the leading simplex of the set, the vertex
// opposite to it, and each other point q. Everything happens within the hull of the whole set.
template <typename Visit>
void for_all_facets(const PointsCase& set, const Visit& visit) {
  const generators::Scene scene = generators::scene(set, generators::Scaling::kCommon);
  for (std::size_t place = 0; place < scene.simplex.size(); ++place) {
    Vertices facet = scene.simplex;
    facet.erase(facet.begin() + static_cast<Vertex>(place));
    for (const Vertex q : scene.queries) visit(scene.points, facet, scene.simplex[place], q);
  }
}

template <typename Law>
bool holds_for_facets(std::size_t first, std::size_t last, const Law& law) {
  bool all = true;
  for (std::size_t d = first; d <= last; ++d) {
    all = properties::holds("dimension " + std::to_string(d),
                            [&] { law(*generators::simplex_and_queries(d)); }) &&
          all;
  }
  return all;
}

int side_of(const Configuration& points, Vertices facet, Vertex v) {
  facet.push_back(v);
  return orientation(points, facet);
}

TEST_CASE("outer halfspace: beyond an edge, on its line within and without it, and before it") {
  const Configuration points({{0, 0}, {4, 0}, {1, 3}, {2, -1}, {2, 0}, {5, 0}});
  const Vertices edge = {0, 1};
  const int outward = -side_of(points, edge, 2);
  CHECK(perturbed_in_outer_halfspace(points, edge, outward, 2) == -1);
  CHECK(perturbed_in_outer_halfspace(points, edge, outward, 3) == 1);
  CHECK(perturbed_in_outer_halfspace(points, edge, outward, 4) == 1);
  CHECK(perturbed_in_outer_halfspace(points, edge, outward, 5) == -1);
  CHECK(perturbed_in_outer_halfspace(points, edge, -outward, 3) == -1);
  CHECK(perturbed_in_outer_halfspace(points, edge, -outward, 4) == 1);
}

TEST_CASE("outer halfspace: never zero, and for one of the two sides of a facet unless coplanar") {
  CHECK(holds_for_facets(1, 5, [](const PointsCase& set) {
    for_all_facets(set, [](const Configuration& points, const Vertices& facet, Vertex, Vertex q) {
      const int one = perturbed_in_outer_halfspace(points, facet, 1, q);
      const int other = perturbed_in_outer_halfspace(points, facet, -1, q);
      RC_ASSERT(one * one == 1);
      RC_ASSERT(other == (side_of(points, facet, q) == 0 ? one : -one));
    });
  }));
}

TEST_CASE("outer halfspace: no permutation of the facet changes it") {
  CHECK(holds_for_facets(2, 5, [](const PointsCase& set) {
    for_all_facets(set,
                   [](const Configuration& points, const Vertices& facet, Vertex apex, Vertex q) {
                     const int outward = -side_of(points, facet, apex);
                     for (std::size_t i = 1; i < facet.size(); ++i) {
                       Vertices swapped = facet;
                       std::swap(swapped[0], swapped[i]);
                       RC_ASSERT(perturbed_in_outer_halfspace(points, swapped, -outward, q) ==
                                 perturbed_in_outer_halfspace(points, facet, outward, q));
                     }
                   });
  }));
}

// A coplanar query has barycentric coordinate zero at the apex of any simplex on the facet, and the
// ball of that simplex meets the plane in the facet's circumdisk: the apex cannot matter.
TEST_CASE("outer halfspace: for a coplanar point it is the ball of any simplex on the facet") {
  CHECK(holds_for_facets(2, 5, [](const PointsCase& set) {
    for_all_facets(set,
                   [](const Configuration& points, const Vertices& facet, Vertex apex, Vertex q) {
                     if (side_of(points, facet, q) != 0) return;
                     Vertices simplex = facet;
                     simplex.push_back(apex);
                     const int outward = -side_of(points, facet, apex);
                     RC_ASSERT(perturbed_in_outer_halfspace(points, facet, outward, q) ==
                               perturbed_in_ball(points, simplex, q));
                   });
  }));
}

TEST_CASE("outer halfspace: for a coplanar point it is the perturbed in-plane test on all axes") {
  CHECK(holds_for_facets(2, 4, [](const PointsCase& set) {
    for_all_facets(
        set, [](const Configuration& points, const Vertices& facet, Vertex apex, Vertex q) {
          if (side_of(points, facet, q) != 0) return;
          const int outward = -side_of(points, facet, apex);
          const int expected = perturbed_in_outer_halfspace(points, facet, outward, q);
          for (std::size_t dropped = 0; dropped < points.ambient_dimension(); ++dropped) {
            std::vector<std::size_t> axes;
            for (std::size_t axis = 0; axis < points.ambient_dimension(); ++axis) {
              if (axis != dropped) axes.push_back(axis);
            }
            if (axes.size() + 1 != facet.size() || orientation(points, axes, facet) == 0) continue;
            RC_ASSERT(perturbed_in_ball(points, axes, facet, q) == expected);
          }
        });
  }));
}

TEST_CASE("outer halfspace: for other points it is the ball of the facet and a very far point") {
  CHECK(holds_for_facets(1, 4, [](const PointsCase& set) {
    for_all_facets(set, [&set](const Configuration& points, const Vertices& facet, Vertex apex,
                               Vertex q) {
      if (side_of(points, facet, q) == 0) return;
      std::vector<Point> corners;
      for (const Vertex v : facet) corners.push_back(set.points[static_cast<std::size_t>(v)]);
      const Point middle = barycentre(corners);
      const Rational far(Integer(1) << 6000);
      PointsCase more = set;
      more.points.push_back(middle + far * (middle - set.points[static_cast<std::size_t>(apex)]));
      if (!set.weights.empty()) more.weights.push_back(0);
      Vertices simplex = facet;
      simplex.push_back(static_cast<Vertex>(set.points.size()));
      const Configuration with_far(more.points, more.weights);
      RC_ASSERT(perturbed_in_outer_halfspace(points, facet, -side_of(points, facet, apex), q) ==
                in_ball(with_far, points.axes(), simplex, q));
    });
  }));
}

}  // namespace
}  // namespace circumspect
