#include "inputs/complexes.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "inputs/named_complexes.hpp"
#include "inputs/scalars.hpp"
#include "reference/kernel/complex/point_set.hpp"
#include "reference/kernel/piecewise_linear/validity.hpp"
#include "reference/kernel/predicates/orientation.hpp"

namespace circumspect::generators {
namespace {

// Within rc::gen::exec: uniform in [0, count), yes or no, some distinct vertices in random order.
std::size_t pick(std::size_t count) {
  return static_cast<std::size_t>(*below(static_cast<long>(count)));
}
bool toss() { return pick(2) == 0; }
std::vector<Vertex> pick_vertices(std::size_t count, std::vector<Vertex> from) {
  std::vector<Vertex> picked;
  while (picked.size() < count && !from.empty()) {
    const auto place = from.begin() + static_cast<std::ptrdiff_t>(pick(from.size()));
    picked.push_back(*place);
    from.erase(place);
  }
  return picked;
}

std::vector<Vertex> vertices_of(const PiecewiseLinearInput& input) {
  std::vector<Vertex> vertices(input.points.size());
  std::iota(vertices.begin(), vertices.end(), Vertex{0});
  return vertices;
}

DomainKind any_kind() { return toss() ? DomainKind::kHull : DomainKind::kEnclosed; }

// The other vertices in the plane of a triangle.
std::vector<Vertex> coplanar_with(const PiecewiseLinearInput& input,
                                  const std::vector<Vertex>& triangle) {
  const PointSet points(input.points);
  std::vector<Vertex> coplanar;
  for (const Vertex v : vertices_of(input)) {
    std::vector<Vertex> with_v = triangle;
    with_v.push_back(v);
    if (contains(triangle, v)) continue;
    if (flat_through(points, with_v).dimension() <= 2) coplanar.push_back(v);
  }
  return coplanar;
}

// A few tries to add a random triangle or quadrilateral, or a segment.
void add_random_polygons(PiecewiseLinearInput& input, std::size_t tries) {
  for (std::size_t i = 0; i < tries; ++i) {
    std::vector<Vertex> line = pick_vertices(3, vertices_of(input));
    if (line.size() < 3) return;
    if (toss()) {
      const std::vector<Vertex> more = pick_vertices(1 + pick(2), coplanar_with(input, line));
      line.insert(line.end(), more.begin(), more.end());
    }
    add_if_valid(input, {{}, {polygon_along(line)}});
  }
}
void add_random_segments(PiecewiseLinearInput& input, std::size_t tries) {
  for (std::size_t i = 0; i < tries; ++i) {
    const std::vector<Vertex> ends = pick_vertices(2, vertices_of(input));
    if (ends.size() < 2) return;
    add_if_valid(input, {{ends}, {}});
  }
}

// On which side of a facet is a vertex?
int side(const PointSet& points, Simplex facet, Vertex v) {
  facet.push_back(v);
  return orientation(points.configuration(), std::vector<std::size_t>{0, 1, 2}, facet);
}

// Does the closed tetrahedron contain the vertex? Requires: it is not degenerate.
bool lies_in(const PointSet& points, const Simplex& tetrahedron, Vertex v) {
  for (std::size_t i = 0; i < 4; ++i) {
    const Simplex facet = facet_opposite(tetrahedron, i);
    if (side(points, facet, v) == -side(points, facet, tetrahedron[i])) return false;
  }
  return true;
}

// Tetrahedra glued facet to facet: the vertices opposite to each facet, one or two.
using Glued = std::map<Simplex, std::vector<Vertex>>;

// May the tetrahedron be added, as far as the facets that are there already and the vertices tell?
bool fits(const PointSet& points, const Glued& glued, const Simplex& tetrahedron) {
  if (has_repeated_vertex(tetrahedron)) return false;
  if (flat_through(points, tetrahedron).dimension() != 3) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    const Simplex facet = facet_opposite(tetrahedron, i);
    const auto there = glued.find(facet);
    if (there == glued.end()) continue;
    if (there->second.size() == 2) return false;
    if (side(points, facet, there->second[0]) == side(points, facet, tetrahedron[i])) return false;
  }
  const std::vector<Vertex> all = all_vertices(points);
  return std::none_of(all.begin(), all.end(), [&](Vertex v) {
    return !contains(tetrahedron, v) && lies_in(points, tetrahedron, v);
  });
}

// A random tetrahedron, glued to those there are if there are any. None of its facets crosses any
// that is there, and those that are there lie on its outside: then so do the others' interiors, which
// are connected through facets.
void glue_one(PiecewiseLinearInput& input, const PointSet& points, Glued& glued) {
  std::vector<Vertex> vertices;
  if (glued.empty()) {
    vertices = pick_vertices(4, all_vertices(points));
  } else {
    vertices = std::next(glued.begin(), static_cast<std::ptrdiff_t>(pick(glued.size())))->first;
    vertices.push_back(static_cast<Vertex>(pick(points.size())));
  }
  const Simplex tetrahedron = sorted(vertices);
  if (!fits(points, glued, tetrahedron)) return;
  Cells cells;
  for (std::size_t i = 0; i < 4; ++i) {
    const Simplex facet = facet_opposite(tetrahedron, i);
    if (!glued.contains(facet)) cells.polygons.push_back(polygon_along(facet));
  }
  if (!add_if_valid(input, cells)) return;
  for (std::size_t i = 0; i < 4; ++i) {
    glued[facet_opposite(tetrahedron, i)].push_back(tetrahedron[i]);
  }
}

// A square in one of the faces of the cube of side 6.
std::vector<Point> square_in_face(std::size_t axis, const Rational& height, const Rational& low,
                                  const Rational& high) {
  std::vector<Point> corners;
  for (const auto& [x, y] : {std::pair{low, low}, {high, low}, {high, high}, {low, high}}) {
    Point corner(3);
    corner[axis] = height;
    corner[(axis + 1) % 3] = x;
    corner[(axis + 2) % 3] = y;
    corners.push_back(corner);
  }
  return corners;
}

// A square in a face, of which it makes a hole, a polygon within the polygon, or a closed slit.
void add_square_to_face(PiecewiseLinearInput& input) {
  const std::size_t axis = pick(3);
  const Rational height = toss() ? 0 : 6, low = 1 + pick(2), high = 3 + pick(2);
  const auto first = static_cast<Vertex>(input.points.size());
  PiecewiseLinearInput changed = input;
  for (const Point& corner : square_in_face(axis, height, low, high)) {
    changed.points.push_back(corner);
  }
  const std::vector<Vertex> line = {first, first + 1, first + 2, first + 3};
  for (PolygonLines& face : changed.polygons) {
    const auto in_plane = [&](Vertex v) {
      return changed.points[static_cast<std::size_t>(v)][axis] == height;
    };
    const auto& outline = face.lines.front();
    if (!std::all_of(outline.begin(), outline.end(), in_plane)) continue;
    face.lines.push_back(line);
    if (toss()) face.hole_seeds.push_back(square_in_face(axis, height, low + Rational(1, 2), 4)[0]);
    if (!face.hole_seeds.empty() && toss()) changed.polygons.push_back(polygon_along(line));
    break;
  }
  if (validated(changed, 1)) input = changed;
}

void add_inner_box(PiecewiseLinearInput& input) {
  const long low = 1 + static_cast<long>(pick(3));
  PiecewiseLinearInput changed = both(input, box(low, low + 1 + static_cast<long>(pick(2))));
  if (toss()) changed.hole_seeds.push_back(Point(3, low + Rational(1, 3)));
  if (validated(changed, 1)) input = changed;
}

void add_point_if_valid(PiecewiseLinearInput& input, const Point& point) {
  input.points.push_back(point);
  if (!validated(input, 1)) input.points.pop_back();
}

}  // namespace

PointSets rather_large(const PointSets& sets, std::size_t dimension) {
  return rc::gen::map(rc::gen::container<std::vector<std::vector<Point>>>(3, sets),
                      [dimension](const std::vector<std::vector<Point>>& three) {
                        const auto largest = std::max_element(
                            three.begin(), three.end(),
                            [](const auto& a, const auto& b) { return a.size() < b.size(); });
                        return largest->empty() ? std::vector<Point>{Point(dimension)} : *largest;
                      });
}

Complexes scattered_cells(const PointSets& sets) {
  return shrinking(rc::gen::exec([=] {
    ComplexCase made{"scattered cells", {*sets, {}, {}, {}, any_kind()}};
    add_random_polygons(made.input, pick(10));
    add_random_segments(made.input, pick(8));
    return made;
  }));
}

Complexes glued_tetrahedra(const PointSets& sets) {
  return shrinking(rc::gen::exec([=] {
    ComplexCase made{"glued tetrahedra", {*sets, {}, {}, {}, DomainKind::kEnclosed}};
    Glued glued;
    const PointSet points(made.input.points);
    const std::size_t tries = points.size() < 4 ? 0 : 4 + pick(16);
    for (std::size_t i = 0; i < tries; ++i) glue_one(made.input, points, glued);
    made.input.polygons.clear();
    for (const auto& [facet, apexes] : glued) {
      if (apexes.size() == 1 || pick(3) == 0) made.input.polygons.push_back(polygon_along(facet));
    }
    return made;
  }));
}

Complexes furnished_boxes() {
  return shrinking(rc::gen::exec([] {
    ComplexCase made{"furnished box", box(0, 6)};
    made.input.kind = any_kind();
    for (std::size_t i = pick(2); i > 0; --i) add_square_to_face(made.input);
    if (pick(3) == 0) add_inner_box(made.input);
    for (std::size_t i = pick(4); i > 0; --i) {
      Point point;
      for (std::size_t axis = 0; axis < 3; ++axis) point.push_back(pick(7));
      add_point_if_valid(made.input, point);
    }
    add_random_polygons(made.input, pick(6));
    add_random_segments(made.input, pick(6));
    return made;
  }));
}

Complexes twisted_prisms() {
  return shrinking(rc::gen::exec([] {
    ComplexCase made{"twisted prism", schonhardt()};
    PiecewiseLinearInput& input = made.input;
    if (toss()) {
      input.points = {{8, 0, 0}, {0, 8, 0},  {-8, 0, 0},  {0, -8, 0},
                      {6, 5, 9}, {-5, 6, 9}, {-6, -5, 9}, {5, -6, 9}};
      input.polygons = {polygon_along({0, 1, 2, 3}), polygon_along({4, 5, 6, 7})};
      for (Vertex i = 0; i < 4; ++i) {
        const Vertex next = (i + 1) % 4;
        input.polygons.push_back(polygon_along({i, next, next + 4}));
        input.polygons.push_back(polygon_along({i, next + 4, i + 4}));
      }
    }
    for (Point& corner : input.points) {
      PiecewiseLinearInput changed = input;
      Point& moved = changed.points[static_cast<std::size_t>(&corner - input.points.data())];
      for (std::size_t axis = 0; axis < 3; ++axis) moved[axis] += *integer_within(2);
      if (validated(changed, 1)) corner = moved;
    }
    if (pick(3) == 0) add_point_if_valid(input, {*integer_number(2), *integer_number(2), 5});
    input.kind = any_kind();
    return made;
  }));
}

Complexes any_complex(std::size_t max_points) {
  const PointSets sets =
      rather_large(rc::gen::oneOf(integer_points(3, max_points), grid_points(3, max_points),
                                  integer_points(3, max_points), any_point_set(3, max_points),
                                  integer_sphere_points(3, max_points)),
                   3);
  return rc::gen::oneOf(scattered_cells(sets), glued_tetrahedra(sets), furnished_boxes(),
                        twisted_prisms());
}

Complexes planar_complexes(std::size_t max_points) {
  return planar_complexes(
      rather_large(rc::gen::oneOf(integer_points(2, max_points), grid_points(2, max_points),
                                  any_point_set(2, max_points)),
                   2));
}

Complexes planar_complexes(const PointSets& sets) {
  return shrinking(rc::gen::exec([=] {
    ComplexCase made{"planar", {*sets, {}, {}, {}, any_kind()}};
    PiecewiseLinearInput& input = made.input;
    for (std::size_t i = pick(5); i > 0 && input.points.size() > 2; --i) {
      const std::vector<Vertex> v = pick_vertices(3, vertices_of(input));
      add_if_valid(input, {{{v[0], v[1]}, {v[1], v[2]}, {v[2], v[0]}}, {}});
    }
    add_random_segments(input, pick(12));
    for (std::size_t i = pick(3); i > 0 && input.points.size() > 2; --i) {
      const std::vector<Vertex> v = pick_vertices(3, vertices_of(input));
      PiecewiseLinearInput changed = input;
      changed.hole_seeds.push_back(barycentre(coordinates(PointSet(input.points), v)));
      if (validated(changed, 1)) input = changed;
    }
    return made;
  }));
}

}  // namespace circumspect::generators
