// perturbed_in_outer_halfspace, the conflict test of ghost simplices, against what it stands for.
#include <utility>

#include <doctest/doctest.h>

#include "properties/generators/laws.hpp"
#include "reference/predicates/in_ball.hpp"
#include "reference/predicates/orientation.hpp"
#include "reference/predicates/perturbation.hpp"

namespace circumspect {
namespace {

using generators::PointsCase;

using Vertices = std::vector<Vertex>;

// Calls visit(points, facet, apex, q) for each facet of the leading simplex of the set, the vertex
// opposite to it, and each other point q. Everything within the hull of the whole set.
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
    all = rc::check("dimension " + std::to_string(d),
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
