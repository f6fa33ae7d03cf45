#include "inputs/round_sets.hpp"

#include <array>
#include <map>
#include <numeric>
#include <utility>

#include "inputs/named_complexes.hpp"
#include "inputs/scalars.hpp"
#include "inputs/set_parts.hpp"

namespace circumspect::generators {
namespace {

// A point of the unit circle, few of them, so that rings above each other have points above each
// other.
rc::Gen<Point> circle_point() {
  return rc::gen::map(rc::gen::pair(integer_within(6), below(2)),
                      [](const std::pair<long, long>& parts) {
                        return from_stereographic({Rational(parts.first) / (parts.second + 1)});
                      });
}

// All integer points of the sphere of this squared radius around the origin.
void append_integer_points(std::vector<long>& prefix, std::size_t dimension, long left,
                           std::vector<std::vector<long>>& points) {
  if (prefix.size() == dimension) {
    if (left == 0) points.push_back(prefix);
    return;
  }
  long bound = 0;
  while ((bound + 1) * (bound + 1) <= left) ++bound;
  for (long x = -bound; x <= bound; ++x) {
    if (prefix.size() + 1 == dimension && x * x != left) continue;
    prefix.push_back(x);
    append_integer_points(prefix, dimension, left - x * x, points);
    prefix.pop_back();
  }
}
std::vector<std::vector<long>> integer_points_of_sphere(std::size_t dimension, long square) {
  std::vector<long> prefix;
  std::vector<std::vector<long>> points;
  append_integer_points(prefix, dimension, square, points);
  return points;
}

using Spheres = std::vector<std::vector<std::vector<long>>>;

// A few spheres with many integer points. In the plane the squared radii are products of primes 4k + 1:
// 12, 48 and 96 points.
const Spheres& spheres_of_integer_points(std::size_t dimension) {
  static const std::array<Spheres, 7> all = [] {
    const std::array<std::vector<long>, 7> squares = {
        {{}, {}, {25, 5525, 160225}, {9, 81, 1001}, {4, 12, 30}, {4, 8, 10}, {4, 6}}};
    std::array<Spheres, 7> spheres;
    for (std::size_t d = 2; d < squares.size(); ++d) {
      for (const long square : squares[d])
        spheres[d].push_back(integer_points_of_sphere(d, square));
    }
    return spheres;
  }();
  return all[dimension];
}

// Integer coordinates of one vertex of each polytope, the first ones of a point; the rest are 0.
const std::vector<Point>& first_vertices_of_polytopes(std::size_t dimension) {
  static const std::array<std::vector<Point>, 17> all = [] {
    std::array<std::vector<Point>, 17> vertices;
    for (std::size_t d = 2; d < vertices.size(); ++d) {
      vertices[d] = {Point(d, Rational(1)), Point(d, Rational(1)), {1}, {1, 1}, {1, 2}};
      if (d == 3) vertices[d].push_back({0, 13, 21});
      for (Point& vertex : vertices[d]) vertex.resize(d);
    }
    return vertices;
  }();
  return all[dimension];
}
constexpr std::size_t kHalfCube = 0, kIcosahedron = 5;

// Vertex number `code` of a polytope.
Point polytope_vertex(std::size_t dimension, std::size_t polytope, long code) {
  const Point& first = first_vertices_of_polytopes(dimension)[polytope];
  if (polytope == kIcosahedron) {
    // No odd permutations: those would be the vertices of a second icosahedron.
    Point vertex(3);
    for (std::size_t i = 0; i < 3; ++i) {
      vertex[(i + static_cast<std::size_t>(code)) % 3] =
          (code / 3 >> i) % 2 == 0 ? first[i] : Rational(-first[i]);
    }
    return vertex;
  }
  Point vertex = symmetric_image(first, code);
  if (polytope != kHalfCube) return vertex;
  int product = 1;
  for (const Rational& x : vertex) product *= sign(x);
  if (product < 0) vertex[0] = -vertex[0];
  return vertex;
}

}  // namespace

PointSets circle_points(std::size_t dimension, std::size_t max_points) {
  const auto on_circle = rc::gen::map(
      small_rational(), [](const Rational& image) { return from_stereographic({image}); });
  if (dimension == 2) return carried(sets_of(on_circle, max_points), dimension);
  const auto on_axis =
      rc::gen::map(point_of(dimension - 2, integer_number(3)), [](const Point& heights) {
        Point point = {0, 0};
        point.insert(point.end(), heights.begin(), heights.end());
        return point;
      });
  const auto point = rc::gen::map(rc::gen::tuple(below(4), on_circle, on_axis),
                                  [dimension](const std::tuple<long, Point, Point>& parts) {
                                    if (std::get<0>(parts) == 3) return std::get<2>(parts);
                                    Point result = std::get<1>(parts);
                                    result.resize(dimension);
                                    return result;
                                  });
  return carried(sets_of(point, max_points), dimension);
}

PointSets cylinder_points(std::size_t dimension, std::size_t max_points) {
  const auto heights = point_of(dimension - 2, integer_number(2));
  const auto point = rc::gen::map(
      rc::gen::pair(circle_point(), heights), [](const std::pair<Point, Point>& parts) {
        Point result = parts.first;
        result.insert(result.end(), parts.second.begin(), parts.second.end());
        return result;
      });
  return carried(sets_of(point, max_points), dimension);
}

PointSets pythagorean_points(std::size_t dimension, std::size_t max_points) {
  const auto codes = up_to<long>(max_points, below(1L << 40));
  const auto centre = point_of(dimension, integer_number(3));
  return rc::gen::map(
      rc::gen::tuple(below(60), codes, centre, below(41)),
      [dimension](const std::tuple<long, std::vector<long>, Point, long>& parts) {
        const auto& [choice, chosen, translation, exponent] = parts;
        const Spheres& spheres = spheres_of_integer_points(dimension);
        const auto& sphere = spheres[static_cast<std::size_t>(choice) % spheres.size()];
        const Rational scale =
            Rational(Integer(1) << static_cast<unsigned long>(exponent)) / (1 << 20);
        std::vector<Point> points;
        for (const long code : chosen) {
          const auto& x = sphere[static_cast<std::size_t>(code) % sphere.size()];
          points.push_back(scale * (Point(x.begin(), x.end()) + translation));
        }
        return distinct(points);
      });
}

PointSets polytope_points(std::size_t dimension, std::size_t max_points) {
  const auto codes = up_to<long>(max_points, below(cube_symmetries(dimension)));
  return rc::gen::map(rc::gen::tuple(below(60), codes, below(2)),
                      [dimension](const std::tuple<long, std::vector<long>, long>& parts) {
                        const auto& [choice, chosen, with_centre] = parts;
                        const std::size_t polytope = static_cast<std::size_t>(choice) %
                                                     first_vertices_of_polytopes(dimension).size();
                        std::vector<Point> points;
                        for (const long code : chosen) {
                          points.push_back(polytope_vertex(dimension, polytope, code));
                        }
                        if (with_centre == 1 && !points.empty()) points.back() = Point(dimension);
                        return distinct(points);
                      });
}

PointSets twisted_prism_points(std::size_t dimension, std::size_t max_points) {
  RC_ASSERT(dimension == 3);
  const auto columns = up_to(max_points / 2, circle_point());
  const auto prism = rc::gen::map(
      rc::gen::tuple(columns, small_rational(), integer_within(2)),
      [](const std::tuple<std::vector<Point>, Rational, long>& parts) {
        const auto& [ring, image, height] = parts;
        const Point turn = from_stereographic({image});
        std::vector<Point> points;
        for (const Point& p : ring) {
          points.push_back({p[0], p[1], Rational(0)});
          points.push_back({turn[0] * p[0] - turn[1] * p[1], turn[1] * p[0] + turn[0] * p[1],
                            Rational(height == 0 ? 1 : height)});
        }
        return distinct(points);
      });
  const auto corner = rc::gen::map(below(7), [](long code) {
    return code < 6 ? schonhardt().points[static_cast<std::size_t>(code)] : Point{0, 0, 5};
  });
  return rc::gen::oneOf(prism, prism, sets_of(corner, max_points));
}

}  // namespace circumspect::generators
