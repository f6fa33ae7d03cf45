#include "inputs/complexes.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "inputs/named_complexes.hpp"
#include "inputs/set_parts.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/place.hpp"

namespace circumspect::generators {
namespace {

bool toss(Dice& dice) { return dice.below(2) == 0; }

// Some distinct vertices in random order.
std::vector<Vertex> pick_vertices(Dice& dice, std::size_t count, std::vector<Vertex> from) {
  std::vector<Vertex> picked;
  while (picked.size() < count && !from.empty()) {
    const auto place = from.begin() + static_cast<std::ptrdiff_t>(dice.below(from.size()));
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

DomainKind any_kind(Dice& dice) { return toss(dice) ? DomainKind::kHull : DomainKind::kEnclosed; }

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
void add_random_polygons(Dice& dice, PiecewiseLinearInput& input, std::size_t tries) {
  for (std::size_t i = 0; i < tries; ++i) {
    std::vector<Vertex> line = pick_vertices(dice, 3, vertices_of(input));
    if (line.size() < 3) return;
    if (toss(dice)) {
      const std::size_t most = 1 + dice.below(2);
      const std::vector<Vertex> more = pick_vertices(dice, most, coplanar_with(input, line));
      line.insert(line.end(), more.begin(), more.end());
    }
    add_if_valid(input, {{}, {polygon_along(line)}});
  }
}
void add_random_segments(Dice& dice, PiecewiseLinearInput& input, std::size_t tries) {
  for (std::size_t i = 0; i < tries; ++i) {
    const std::vector<Vertex> ends = pick_vertices(dice, 2, vertices_of(input));
    if (ends.size() < 2) return;
    add_if_valid(input, {{ends}, {}});
  }
}

// On which side of a facet is a vertex?
int side(const PointSet& points, const Simplex& facet, Vertex v) {
  return side_of_facet(points.configuration(), kSpace, facet, v);
}

// Tetrahedra glued facet to facet: the vertices opposite to each facet, one or two.
using Glued = std::map<Simplex, std::vector<Vertex>>;

// May the tetrahedron be added, judging by the existing facets and the vertices?
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
    return !contains(tetrahedron, v) && lies_in(points.configuration(), kSpace, tetrahedron, v);
  });
}

// A random tetrahedron, glued to the existing ones if there are any. Its facets cross no existing
// facet, and those lie outside of it: then the interiors of the existing tetrahedra, which are
// connected through facets, lie outside of it too.
void glue_one(Dice& dice, PiecewiseLinearInput& input, const PointSet& points, Glued& glued) {
  std::vector<Vertex> vertices;
  if (glued.empty()) {
    vertices = pick_vertices(dice, 4, all_vertices(points));
  } else {
    vertices =
        std::next(glued.begin(), static_cast<std::ptrdiff_t>(dice.below(glued.size())))->first;
    vertices.push_back(static_cast<Vertex>(dice.below(points.size())));
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

// A square in a face, which becomes a hole, a polygon within the polygon, or a closed slit.
void add_square_to_face(Dice& dice, PiecewiseLinearInput& input) {
  const std::size_t axis = dice.below(3);
  const Rational height = toss(dice) ? 0 : 6;
  const Rational low = dice.within(1, 2);
  const Rational high = dice.within(3, 4);
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
    if (toss(dice))
      face.hole_seeds.push_back(square_in_face(axis, height, low + Rational(1, 2), 4)[0]);
    if (!face.hole_seeds.empty() && toss(dice)) changed.polygons.push_back(polygon_along(line));
    break;
  }
  if (validated(changed, 1)) input = changed;
}

void add_inner_box(Dice& dice, PiecewiseLinearInput& input) {
  const long low = dice.within(1L, 3L);
  const long side = dice.within(1L, 2L);
  PiecewiseLinearInput changed = both(input, box(low, low + side));
  if (toss(dice)) changed.hole_seeds.push_back(Point(3, low + Rational(1, 3)));
  if (validated(changed, 1)) input = changed;
}

void add_point_if_valid(PiecewiseLinearInput& input, const Point& point) {
  input.points.push_back(point);
  if (!validated(input, 1)) input.points.pop_back();
}

}  // namespace

ComplexCase scattered_cells(Dice& dice, std::vector<Point> points) {
  ComplexCase made{"scattered cells", {std::move(points), {}, {}, {}, any_kind(dice)}};
  add_random_polygons(dice, made.input, dice.below(10));
  add_random_segments(dice, made.input, dice.below(8));
  return made;
}

ComplexCase glued_tetrahedra(Dice& dice, std::vector<Point> vertices) {
  ComplexCase made{"glued tetrahedra", {std::move(vertices), {}, {}, {}, DomainKind::kEnclosed}};
  Glued glued;
  const PointSet points(made.input.points);
  const std::size_t tries = points.size() < 4 ? 0 : 4 + dice.below(16);
  for (std::size_t i = 0; i < tries; ++i) glue_one(dice, made.input, points, glued);
  made.input.polygons.clear();
  for (const auto& [facet, apexes] : glued) {
    if (apexes.size() == 1 || dice.below(3) == 0) {
      made.input.polygons.push_back(polygon_along(facet));
    }
  }
  return made;
}

ComplexCase furnished_box(Dice& dice) {
  ComplexCase made{"furnished box", box(0, 6)};
  made.input.kind = any_kind(dice);
  for (std::size_t i = dice.below(2); i > 0; --i) add_square_to_face(dice, made.input);
  if (dice.below(3) == 0) add_inner_box(dice, made.input);
  for (std::size_t i = dice.below(4); i > 0; --i) {
    add_point_if_valid(made.input, several(3, [&] { return Rational(dice.within(0, 6)); }));
  }
  add_random_polygons(dice, made.input, dice.below(6));
  add_random_segments(dice, made.input, dice.below(6));
  return made;
}

ComplexCase twisted_prism(Dice& dice) {
  ComplexCase made{"twisted prism", schonhardt()};
  PiecewiseLinearInput& input = made.input;
  if (toss(dice)) {
    input.points = {{8, 0, 0}, {0, 8, 0},  {-8, 0, 0},  {0, -8, 0},
                    {6, 5, 9}, {-5, 6, 9}, {-6, -5, 9}, {5, -6, 9}};
    input.polygons = {polygon_along({0, 1, 2, 3}), polygon_along({4, 5, 6, 7})};
    for (Vertex i = 0; i < 4; ++i) {
      const Vertex next = (i + 1) % 4;
      input.polygons.push_back(polygon_along({i, next, next + 4}));
      input.polygons.push_back(polygon_along({i, next + 4, i + 4}));
    }
  }
  for (std::size_t v = 0; v < input.points.size(); ++v) {
    PiecewiseLinearInput changed = input;
    changed.points[v] = changed.points[v] + integer_point(dice, 3, 2);
    if (validated(changed, 1)) input = changed;
  }
  if (dice.below(3) == 0) {
    Point inside = integer_point(dice, 2, 2);
    inside.emplace_back(5);
    add_point_if_valid(input, inside);
  }
  input.kind = any_kind(dice);
  return made;
}

ComplexCase planar_complex(Dice& dice, std::vector<Point> points) {
  ComplexCase made{"planar", {std::move(points), {}, {}, {}, any_kind(dice)}};
  PiecewiseLinearInput& input = made.input;
  for (std::size_t i = dice.below(5); i > 0 && input.points.size() > 2; --i) {
    const std::vector<Vertex> v = pick_vertices(dice, 3, vertices_of(input));
    add_if_valid(input, {{{v[0], v[1]}, {v[1], v[2]}, {v[2], v[0]}}, {}});
  }
  add_random_segments(dice, input, dice.below(12));
  for (std::size_t i = dice.below(3); i > 0 && input.points.size() > 2; --i) {
    const std::vector<Vertex> v = pick_vertices(dice, 3, vertices_of(input));
    PiecewiseLinearInput changed = input;
    changed.hole_seeds.push_back(barycentre(PointSet(input.points), v));
    if (validated(changed, 1)) input = changed;
  }
  return made;
}

}  // namespace circumspect::generators
