#include "inputs/round_sets.hpp"

#include <array>
#include <cassert>

#include "inputs/named_complexes.hpp"
#include "inputs/set_parts.hpp"

namespace circumspect::generators {

namespace {

// A point of the unit circle, out of a few, so that rings above each other have points above each
// other.
Point circle_point(Dice& dice) {
  const long numerator = dice.within(-6L, 6L);
  return from_stereographic({Rational(numerator) / dice.within(1, 2)});
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

// A few spheres with many integer points. In the plane the squared radii are products of primes 4k
// + 1: 12, 48 and 96 points.
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

// The first, integer coordinates of one vertex of each polytope; the rest are 0.
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
Point polytope_vertex(std::size_t dimension, std::size_t polytope, std::size_t code) {
  const Point& first = first_vertices_of_polytopes(dimension)[polytope];
  if (polytope == kIcosahedron) {
    // Odd permutations are left out: they would be the vertices of a second icosahedron.
    Point vertex(3);
    for (std::size_t i = 0; i < 3; ++i) {
      vertex[(i + code) % 3] = (code / 3 >> i) % 2 == 0 ? first[i] : Rational(-first[i]);
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

std::vector<Point> circle_points(Dice& dice, std::size_t dimension, Count count) {
  const auto points = set_of(dice, count, [&] {
    if (dimension > 2 && dice.below(4) == 3) {
      Point on_axis = integer_point(dice, dimension - 2, 3);
      on_axis.insert(on_axis.begin(), 2, Rational(0));
      return on_axis;
    }
    return from_stereographic({small_rational(dice)});
  });
  return carried(dice, points, dimension);
}

std::vector<Point> cylinder_points(Dice& dice, std::size_t dimension, Count count) {
  const auto points = set_of(dice, count, [&] {
    Point point = circle_point(dice);
    const Point heights = integer_point(dice, dimension - 2, 2);
    point.insert(point.end(), heights.begin(), heights.end());
    return point;
  });
  return carried(dice, points, dimension);
}

std::vector<Point> pythagorean_points(Dice& dice, std::size_t dimension, Count count) {
  const Spheres& spheres = spheres_of_integer_points(dimension);
  const auto& sphere = spheres[dice.below(spheres.size())];
  const Point centre = integer_point(dice, dimension, 3);
  const auto exponent = static_cast<unsigned long>(dice.below(41));
  const Rational scale = Rational(Integer(1) << exponent) / (1 << 20);
  return set_of(dice, count, [&] {
    const auto& x = sphere[dice.below(sphere.size())];
    return scale * (Point(x.begin(), x.end()) + centre);
  });
}

std::vector<Point> polytope_points(Dice& dice, std::size_t dimension, Count count) {
  const std::size_t polytope = dice.below(first_vertices_of_polytopes(dimension).size());
  const bool with_centre = dice.below(2) == 1;
  std::vector<Point> points = several(count.drawn(dice), [&] {
    return polytope_vertex(dimension, polytope, dice.below(cube_symmetries(dimension)));
  });
  if (with_centre && !points.empty()) points.back() = Point(dimension);
  return distinct(points);
}

std::vector<Point> twisted_prism_points(Dice& dice, [[maybe_unused]] std::size_t dimension,
                                        Count count) {
  assert(dimension == 3);
  if (dice.below(3) == 0) {
    return set_of(dice, count, [&] {
      const std::size_t corner = dice.below(7);
      return corner < 6 ? schonhardt().points[corner] : Point{0, 0, 5};
    });
  }
  const Point turn = from_stereographic({small_rational(dice)});
  const long height = dice.within(-2L, 2L);
  std::vector<Point> points;
  for (const Point& p :
       several(Count{count.most / 2, count.full}.drawn(dice), [&] { return circle_point(dice); })) {
    points.push_back({p[0], p[1], Rational(0)});
    points.push_back({turn[0] * p[0] - turn[1] * p[1], turn[1] * p[0] + turn[0] * p[1],
                      Rational(height == 0 ? 1 : height)});
  }
  return distinct(points);
}

std::vector<Point> cubic_lattice_points(Dice& dice, std::size_t dimension, Count count) {
  return set_of(dice, count, [&] { return integer_point(dice, dimension, 3); });
}

std::vector<Point> body_centred_lattice_points(Dice& dice, std::size_t dimension, Count count) {
  return set_of(dice, count, [&] {
    Point x = integer_point(dice, dimension, 3);
    const Rational offset = Rational(dice.within(0, 1)) / 2;
    for (Rational& c : x) c += offset;
    return x;
  });
}

std::vector<Point> face_centred_lattice_points(Dice& dice, std::size_t dimension, Count count) {
  return set_of(dice, count, [&] {
    Point x = integer_point(dice, dimension, 3);
    Rational sum = 0;
    for (const Rational& c : x) sum += c;
    if (Rational(sum / 2).get_den() != 1) x.back() += sign(x.back()) < 0 ? 1 : -1;
    return x;
  });
}

std::vector<Point> hexagonal_lattice_points(Dice& dice, std::size_t dimension, Count count) {
  return set_of(dice, count, [&] {
    const double half_of_root_three = 0x1.bb67ae8584caap-1;
    Point x = integer_point(dice, dimension, 3);
    const Rational row = x[1];
    x[0] += row / 2;
    x[1] = exact_value(row.get_d() * half_of_root_three);
    return x;
  });
}

}  // namespace circumspect::generators
