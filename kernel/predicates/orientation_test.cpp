// Configurations of points, their orientations, and where affine hulls meet.
#include "kernel/predicates/orientation.hpp"

#include <algorithm>
#include <utility>

#include <doctest/doctest.h>

#include "inputs/plain_algebra.hpp"
#include "kernel/predicates/configuration.hpp"
#include "kernel/predicates/intersection.hpp"
#include "properties/arguments/generated.hpp"
#include "properties/arguments/laws.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect {

// A configuration represents its points exactly, whatever integers they are scaled to.

namespace {

using generators::PointsCase;
using generators::Scaling;

TEST_CASE("configuration: numerators and heights over their denominators are the points") {
  CHECK(generators::holds_for_sets(1, 4, [](const PointsCase& set, Scaling scaling) {
    const Configuration points = generators::configuration(set, scaling);
    for (std::size_t i = 0; i < set.points.size(); ++i) {
      const auto v = static_cast<Vertex>(i);
      const Rational denominator = points.denominator(v);
      RC_ASSERT(sign(denominator) > 0);
      for (std::size_t axis = 0; axis < points.ambient_dimension(); ++axis) {
        RC_ASSERT(points.numerator(v, axis) / denominator == set.points[i][axis]);
      }
      Rational height = squared_length(set.points[i]);
      if (!set.weights.empty()) height -= set.weights[i];
      RC_ASSERT(points.height(v) / (denominator * denominator) == height);
    }
  }));
}

TEST_CASE("configuration: ranks are the lexicographic order of the coordinates") {
  CHECK(generators::holds_for_sets(1, 4, [](const PointsCase& set, Scaling scaling) {
    const Configuration points = generators::configuration(set, scaling);
    for (std::size_t i = 0; i < set.points.size(); ++i) {
      for (std::size_t j = 0; j < set.points.size(); ++j) {
        RC_ASSERT((points.rank(static_cast<Vertex>(i)) < points.rank(static_cast<Vertex>(j))) ==
                  (set.points[i] < set.points[j]));
      }
    }
  }));
}

TEST_CASE("configuration: doubles always share a denominator, unrelated fractions do not") {
  CHECK(Configuration(std::vector<Point>{{exact_value(0x1p-1074)}, {exact_value(0x1p1023)}})
            .has_common_denominator());
  CHECK(properties::holds([] {
    const std::vector<Point> doubles = *generators::sets_of(generators::extreme_points, 3, 8);
    RC_ASSERT(Configuration(doubles).has_common_denominator());
  }));
  std::vector<Point> fractions;
  for (const unsigned long exponent : {907, 911, 919}) {
    fractions.push_back({Rational(Integer(1), Integer((Integer(1) << exponent) - 1))});
  }
  CHECK_FALSE(Configuration(fractions).has_common_denominator());
}

TEST_CASE("configuration: of no point, of one, and of a flat set") {
  CHECK(Configuration({}).dimension() == -1);
  CHECK(Configuration({}).size() == 0);
  CHECK(Configuration({}).ambient_dimension() == 0);
  CHECK(Configuration(std::vector<Point>{{1, 2}}).dimension() == 0);
  const Configuration flat({{0, 0, 5}, {1, 0, 5}, {0, 1, 5}, {1, 1, 5}});
  CHECK(flat.dimension() == 2);
  CHECK(flat.ambient_dimension() == 3);
  CHECK(std::vector<std::size_t>(flat.axes().begin(), flat.axes().end()) ==
        std::vector<std::size_t>{0, 1});
}

// The laws of kernel/predicates/orientation.hpp, under their numbers.

using generators::configuration;
using generators::first_vertices;
using generators::holds_for_sets;
using generators::PointsCase;
using generators::Scaling;

using Axes = std::vector<std::size_t>;
using Vertices = std::vector<Vertex>;

// Calls visit(axes, simplex) for the first k+1 points of the set and all k-sets of axes, k >= 1.
template <typename Visit>
void for_all_axes(const PointsCase& set, const Visit& visit) {
  if (set.points.empty()) return;
  const std::size_t dimension = set.points.front().size();
  for (std::size_t k = 1; k <= dimension && k < set.points.size(); ++k) {
    for (const Axes& axes : generators::subsets(dimension, k)) visit(axes, first_vertices(k + 1));
  }
}

// The determinant of the definition.
Rational plain_determinant(const PointsCase& set, const Axes& axes, const Vertices& simplex) {
  std::vector<Point> rows;
  for (std::size_t i = 0; i + 1 < simplex.size(); ++i) {
    rows.push_back(set.points[static_cast<std::size_t>(simplex[i])] -
                   set.points[static_cast<std::size_t>(simplex.back())]);
  }
  return generators::leibniz_determinant(generators::projected(rows, axes));
}

TEST_CASE("orientation: a counterclockwise triangle and a tetrahedron of the book are positive") {
  const Configuration plane({{0, 0}, {1, 0}, {0, 1}});
  CHECK(orientation(plane, Vertices{0, 1, 2}) == 1);
  CHECK(orientation(plane, Vertices{0, 2, 1}) == -1);
  const Configuration space({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}});
  CHECK(orientation(space, Vertices{0, 1, 2, 3}) == 1);
  const Configuration line(std::vector<Point>{{3}, {1}});
  CHECK(orientation(line, Vertices{0, 1}) == 1);
}

TEST_CASE("O1 swapping two vertices negates the orientation") {
  CHECK(holds_for_sets(1, 5, [](const PointsCase& set, Scaling scaling) {
    const Configuration points = configuration(set, scaling);
    for_all_axes(set, [&](const Axes& axes, const Vertices& simplex) {
      const int expected = -orientation(points, axes, simplex);
      for (std::size_t i = 0; i < simplex.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          Vertices swapped = simplex;
          std::swap(swapped[i], swapped[j]);
          RC_ASSERT(orientation(points, axes, swapped) == expected);
        }
      }
    });
  }));
}

TEST_CASE("O2 the orientation is zero iff the projected points are affinely dependent") {
  CHECK(holds_for_sets(1, 4, [](const PointsCase& set, Scaling scaling) {
    const Configuration points = configuration(set, scaling);
    for_all_axes(set, [&](const Axes& axes, const Vertices& simplex) {
      std::vector<Point> vertices(set.points.begin(),
                                  set.points.begin() + static_cast<Vertex>(simplex.size()));
      const int dimension = generators::dimension_by_minors(generators::projected(vertices, axes));
      const bool dependent = dimension < static_cast<int>(axes.size());
      RC_ASSERT((orientation(points, axes, simplex) == 0) == dependent);
    });
  }));
}

TEST_CASE("O3 translation and positive scaling keep the orientation, a reflection negates it") {
  CHECK(holds_for_sets(1, 5, [](const PointsCase& set, Scaling scaling) {
    if (set.points.empty()) return;
    const std::size_t dimension = set.points.front().size();
    const Rational factor = abs(*generators::small_rational()) + Rational(1, 7);
    const Point translation = *rc::gen::container<Point>(dimension, generators::small_rational());
    const PointsCase image = generators::scaled_and_moved(set, factor, translation);
    PointsCase mirrored = set;
    const auto mirror = static_cast<std::size_t>(*generators::below(static_cast<long>(dimension)));
    for (Point& point : mirrored.points) point[mirror] = -point[mirror];
    const Configuration points = configuration(set, scaling);
    const Configuration image_points = configuration(image, scaling);
    const Configuration mirrored_points = configuration(mirrored, scaling);
    for_all_axes(set, [&](const Axes& axes, const Vertices& simplex) {
      const int side = orientation(points, axes, simplex);
      RC_ASSERT(orientation(image_points, axes, simplex) == side);
      const bool seen = std::find(axes.begin(), axes.end(), mirror) != axes.end();
      RC_ASSERT(orientation(mirrored_points, axes, simplex) == (seen ? -side : side));
    });
  }));
}

TEST_CASE("O4 the determinants of k+2 points satisfy the Plücker relation") {
  CHECK(holds_for_sets(1, 5, [](const PointsCase& set, Scaling scaling) {
    const Configuration points = configuration(set, scaling);
    for_all_axes(set, [&](const Axes& axes, const Vertices& simplex) {
      if (set.points.size() < simplex.size() + 1) return;
      const Vertices all = first_vertices(simplex.size() + 1);
      Rational sum = 0;
      for (std::size_t i = 0; i < all.size(); ++i) {
        Vertices rest = all;
        rest.erase(rest.begin() + static_cast<Vertex>(i));
        sum += (i % 2 == 0 ? 1 : -1) * orientation_determinant(points, axes, rest);
      }
      RC_ASSERT(sign(sum) == 0);
    });
  }));
}

TEST_CASE("O4 the determinants of two simplices satisfy the exchange relation") {
  CHECK(holds_for_sets(1, 5, [](const PointsCase& set, Scaling scaling) {
    const Configuration points = configuration(set, scaling);
    for_all_axes(set, [&](const Axes& axes, const Vertices& first) {
      // The last k+1 points, which may overlap the first.
      Vertices second = first;
      for (Vertex& v : second) v = static_cast<Vertex>(set.points.size()) - 1 - v;
      const auto determinant = [&](const Vertices& simplex) {
        return orientation_determinant(points, axes, simplex);
      };
      Rational sum = 0;
      for (std::size_t j = 0; j < second.size(); ++j) {
        Vertices one = first;
        Vertices other = second;
        std::swap(one[0], other[j]);
        sum += determinant(one) * determinant(other);
      }
      RC_ASSERT(sum == determinant(first) * determinant(second));
    });
  }));
}

TEST_CASE("O6 the orientation is the sign of the rational determinant, however it is scaled") {
  CHECK(holds_for_sets(1, 4, [](const PointsCase& set, Scaling scaling) {
    const Configuration points = configuration(set, scaling);
    for_all_axes(set, [&](const Axes& axes, const Vertices& simplex) {
      RC_ASSERT(orientation_determinant(points, axes, simplex) ==
                plain_determinant(set, axes, simplex));
      RC_ASSERT(orientation(points, axes, simplex) == sign(plain_determinant(set, axes, simplex)));
    });
  }));
}

TEST_CASE("O6 a set without a common scale has its points scaled one by one") {
  CHECK(properties::holds([] {
    const PointsCase set = *rc::gen::suchThat(
        generators::unweighted(generators::sets_of(generators::unrelated_denominator_points, 3, 8)),
        [](const PointsCase& some) { return some.points.size() >= 4; });
    const Configuration points = configuration(set, Scaling::kCommon);
    RC_PRE(!points.has_common_denominator());
    for_all_axes(set, [&](const Axes& axes, const Vertices& simplex) {
      RC_ASSERT(orientation(points, axes, simplex) == sign(plain_determinant(set, axes, simplex)));
    });
  }));
}

TEST_CASE("axes_of finds axes on which a simplex keeps its dimension") {
  CHECK(holds_for_sets(1, 4, [](const PointsCase& set, Scaling scaling) {
    const Configuration points = configuration(set, scaling);
    for (std::size_t count = 1; count <= set.points.size(); ++count) {
      const Vertices simplex = first_vertices(count);
      const std::vector<Point> vertices(set.points.begin(),
                                        set.points.begin() + static_cast<Vertex>(count));
      const Axes axes = axes_of(points, simplex);
      RC_ASSERT(static_cast<int>(axes.size()) == generators::dimension_by_minors(vertices));
      RC_ASSERT(std::is_sorted(axes.begin(), axes.end()));
      if (axes.size() + 1 == count) RC_ASSERT(orientation(points, axes, simplex) != 0);
    }
  }));
}

TEST_CASE("the orientation within the hull of all points is taken on the hull's axes") {
  CHECK(properties::holds([] {
    const PointsCase set = *generators::simplex_and_queries(3);
    const generators::Scene scene = generators::scene(set, Scaling::kCommon);
    RC_ASSERT(orientation(scene.points, scene.simplex) ==
              orientation(scene.points, scene.axes, scene.simplex));
    RC_ASSERT(orientation(scene.points, scene.simplex) != 0);
  }));
}

// What vertices, segments and triangles have in common.

using Corners = std::vector<Point>;

Corners sorted_corners(Corners corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

TEST_CASE("intersection: a segment and a vertex against a triangle in space") {
  const Corners triangle = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  CHECK(intersection(triangle, {{1, 1, -1}, {1, 1, 1}}) == Corners{{1, 1, 0}});
  CHECK(intersection(triangle, {{1, 1, 1}, {1, 1, 2}}).empty());
  CHECK(sorted_corners(intersection(triangle, {{-1, 1, 0}, {9, 1, 0}})) ==
        Corners{{0, 1, 0}, {3, 1, 0}});
  CHECK(intersection({{2, 2, 0}}, triangle) == Corners{{2, 2, 0}});
  CHECK(intersection({{2, 2, Rational(1, 1000)}}, triangle).empty());
}

TEST_CASE("intersection: two triangles, crossing, coplanar and touching") {
  const Corners triangle = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  CHECK(sorted_corners(intersection(triangle, {{1, 1, -1}, {1, 1, 1}, {9, 1, 0}})) ==
        Corners{{1, 1, 0}, {3, 1, 0}});
  CHECK(intersection(triangle, {{1, 1, 0}, {5, 1, 0}, {1, 5, 0}}).size() == 3);
  CHECK(intersection(triangle, {{-1, -1, 0}, {3, 1, 0}, {1, 3, 0}}).size() >= 3);
  CHECK(intersection(triangle, {{4, 0, 0}, {5, 0, 1}, {5, 1, 0}}) == Corners{{4, 0, 0}});
}

TEST_CASE("intersection: in the plane") {
  const Corners triangle = {{0, 0}, {4, 0}, {0, 4}};
  CHECK(sorted_corners(intersection(triangle, {{1, 1}, {5, 1}})) == Corners{{1, 1}, {3, 1}});
  CHECK(intersection({{0, 0}, {4, 0}}, {{1, 0}}) == Corners{{1, 0}});
  CHECK(intersection({{0, 0}, {4, 0}}, {{2, -1}, {2, 1}}) == Corners{{2, 0}});
  CHECK(intersection({{1, 2}}, {{1, 2}}) == Corners{{1, 2}});
  CHECK(intersection({{1, 2}}, {{2, 1}}).empty());
}

}  // namespace

}  // namespace circumspect
