#include "inputs/named_complexes.hpp"

namespace circumspect::generators {

PiecewiseLinearInput box(const Rational& low, const Rational& high) {
  PiecewiseLinearInput input;
  for (int corner = 0; corner < 8; ++corner) {
    Point point;
    for (int axis = 0; axis < 3; ++axis) point.push_back((corner >> axis) & 1 ? high : low);
    input.points.push_back(point);
  }
  for (const std::vector<Vertex>& square : {std::vector<Vertex>{0, 1, 3, 2},
                                            {4, 5, 7, 6},
                                            {0, 1, 5, 4},
                                            {2, 3, 7, 6},
                                            {0, 2, 6, 4},
                                            {1, 3, 7, 5}}) {
    input.polygons.push_back({{square}, {}});
  }
  return input;
}

PiecewiseLinearInput schonhardt() {
  PiecewiseLinearInput input;
  input.points = {{10, 0, 0}, {-5, 9, 0}, {-5, -9, 0}, {9, 5, 10}, {-9, 5, 10}, {0, -10, 10}};
  input.polygons = {{{{0, 1, 2}}, {}}, {{{3, 4, 5}}, {}}};
  for (Vertex i = 0; i < 3; ++i) {
    const Vertex next = (i + 1) % 3;
    input.polygons.push_back({{{i, next, next + 3}}, {}});
    input.polygons.push_back({{{i, next + 3, i + 3}}, {}});
  }
  return input;
}

PiecewiseLinearInput prism_on_a_sphere(bool with_floor) {
  PiecewiseLinearInput input;
  // Integer points at distance 65 from the origin.
  input.points = {{65, 0, 0},    {-33, 56, 0},  {-33, -56, 0}, {24, 7, 60},
                  {-20, 15, 60}, {-7, -24, 60}, {0, 0, -65}};
  input.polygons = {{{{3, 4, 5}}, {}}};
  for (Vertex i = 0; i < 3; ++i) {
    const Vertex next = (i + 1) % 3;
    input.polygons.push_back({{{i, next, next + 3}}, {}});
    input.polygons.push_back({{{i, next + 3, i + 3}}, {}});
    input.polygons.push_back({{{i, next, 6}}, {}});
  }
  if (with_floor) input.polygons.push_back({{{0, 1, 2}}, {}});
  return input;
}

PiecewiseLinearInput cube_with_three_segments(int without) {
  PiecewiseLinearInput input = box(0, 4);
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == without) continue;
    Point from(3);
    from[static_cast<std::size_t>(axis)] = 0;
    from[static_cast<std::size_t>((axis + 1) % 3)] = Rational(7, 4);
    from[static_cast<std::size_t>((axis + 2) % 3)] = Rational(9, 4);
    Point to = from;
    to[static_cast<std::size_t>(axis)] = 4;
    const auto end = static_cast<Vertex>(input.points.size());
    input.points.insert(input.points.end(), {from, to});
    input.segments.push_back({end, end + 1});
  }
  return input;
}

PiecewiseLinearInput encircled_segment() {
  PiecewiseLinearInput input;
  input.points = {{2, 0, 0}, {-1, 2, 0}, {-1, -2, 0}, {0, 0, 9}, {0, 0, -9}};
  for (Vertex i = 0; i < 3; ++i) {
    for (const Vertex apex : {3, 4}) input.polygons.push_back({{{i, (i + 1) % 3, apex}}, {}});
  }
  input.segments = {{3, 4}};
  return input;
}

namespace {

// One wedge: the points at either end where its two sides leave the box's floor (or ceiling), and
// its sharp edge.
struct Wedge {
  Vertex low[2], sharp[2], high[2];
};

// The rim of a face of the box that is cut by wedges, from the floor (or ceiling) corner `from` to
// the corner `to`.
std::vector<Vertex> notched(Vertex from, const std::vector<Wedge>& wedges, int end, Vertex to) {
  std::vector<Vertex> line = {from};
  for (const Wedge& wedge : wedges) {
    line.insert(line.end(), {wedge.low[end], wedge.sharp[end], wedge.high[end]});
  }
  line.push_back(to);
  return line;
}

void append(std::vector<Vertex>& line, std::vector<Vertex> more, bool backwards) {
  if (backwards) more = {more.rbegin(), more.rend()};
  line.insert(line.end(), more.begin(), more.end());
}

// Those cut into the floor, and those into the ceiling.
struct Wedges {
  std::vector<Wedge> below, above;
};

// Adds their points. The sides of a wedge are planes through its sharp edge: at a height h from the
// edge they are h / steepness away from it.
Wedges add_wedges(PiecewiseLinearInput& input, int notches, const Rational& floor,
                  const Rational& ceiling, const Rational& gap) {
  const int side = notches + 1;
  // A power of two, so that all coordinates are doubles.
  Rational steepness = 1;
  while (steepness < 4 * (side * side + 2)) steepness *= 2;
  const auto add = [&input](const Point& point) {
    input.points.push_back(point);
    return static_cast<Vertex>(input.points.size()) - 1;
  };
  Wedges wedges;
  for (int i = 1; i <= notches; ++i) {
    Wedge& cut = wedges.below.emplace_back();
    Wedge& dent = wedges.above.emplace_back();
    for (const int end : {0, 1}) {
      const Rational along = end * side, height = i * along;
      const Rational half_cut = (height - floor) / steepness;
      const Rational half_dent = (ceiling - height - gap) / steepness;
      cut.low[end] = add({i - half_cut, along, floor});
      cut.sharp[end] = add({i, along, height});
      cut.high[end] = add({i + half_cut, along, floor});
      dent.low[end] = add({along, i - half_dent, ceiling});
      dent.sharp[end] = add({along, i, height + gap});
      dent.high[end] = add({along, i + half_dent, ceiling});
    }
  }
  return wedges;
}

}  // namespace

PiecewiseLinearInput chazelle(int notches) {
  const int side = notches + 1;
  const Rational floor = -1, ceiling = side * side + 1, gap(1, 8);
  PiecewiseLinearInput input = box(0, 1);
  input.polygons.clear();
  for (Point& corner : input.points) {
    corner = {corner[0] * side, corner[1] * side, corner[2] == 0 ? floor : ceiling};
  }
  const Wedges wedges = add_wedges(input, notches, floor, ceiling, gap);
  const auto polygon = [&input](const std::vector<Vertex>& line) {
    input.polygons.push_back({{line}, {}});
  };
  // The floor's and the ceiling's strips between the wedges, and the wedges' sides. Corners are
  // numbered by x, y, z in binary: the floor's 0 1 2 3, the ceiling's 4 5 6 7.
  const auto strips = [&](const std::vector<Wedge>& row, Vertex a, Vertex b, Vertex c, Vertex d) {
    Vertex from[2] = {a, b};
    for (const Wedge& wedge : row) {
      polygon({from[0], from[1], wedge.low[1], wedge.low[0]});
      polygon({wedge.low[0], wedge.low[1], wedge.sharp[1], wedge.sharp[0]});
      polygon({wedge.high[0], wedge.high[1], wedge.sharp[1], wedge.sharp[0]});
      from[0] = wedge.high[0];
      from[1] = wedge.high[1];
    }
    polygon({from[0], from[1], d, c});
  };
  strips(wedges.below, 0, 2, 1, 3);
  strips(wedges.above, 4, 5, 6, 7);
  for (const int end : {0, 1}) {
    const Vertex y = 2 * end, x = end;
    std::vector<Vertex> front = notched(y, wedges.below, end, y + 1);
    append(front, {y + 4, y + 5}, true);
    polygon(front);
    std::vector<Vertex> left = notched(x + 4, wedges.above, end, x + 6);
    append(left, {x, x + 2}, true);
    polygon(left);
  }
  return input;
}

PiecewiseLinearInput both(PiecewiseLinearInput first, const PiecewiseLinearInput& second) {
  const auto shift = static_cast<Vertex>(first.points.size());
  const auto shifted = [shift](std::vector<Vertex> line) {
    for (Vertex& v : line) v += shift;
    return line;
  };
  first.points.insert(first.points.end(), second.points.begin(), second.points.end());
  for (const auto& segment : second.segments) first.segments.push_back(shifted(segment));
  for (PolygonLines polygon : second.polygons) {
    for (auto& line : polygon.lines) line = shifted(line);
    first.polygons.push_back(polygon);
  }
  first.hole_seeds.insert(first.hole_seeds.end(), second.hole_seeds.begin(),
                          second.hole_seeds.end());
  return first;
}

}  // namespace circumspect::generators
