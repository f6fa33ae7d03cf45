#include "oracle/domain/filling.hpp"

#include <algorithm>
#include <map>

#include "kernel/exact/point.hpp"

namespace circumspect {
namespace {

// The two regions at a wall.
struct Beside {
  std::size_t front;
  std::size_t back;
};

std::vector<Beside> regions_beside_walls(const Regions& regions) {
  std::vector<Beside> beside;
  for (const Simplex& wall : regions.walls().simplices()) {
    const OrientedFacet front{wall, false};
    beside.push_back({regions.in_front_of(front), regions.in_front_of(front.reverse())});
  }
  return beside;
}

// The walls at each region, without those that have it on both sides.
std::vector<std::vector<std::size_t>> walls_of_regions(const std::vector<Beside>& beside,
                                                       std::size_t regions) {
  std::vector<std::vector<std::size_t>> walls(regions);
  for (std::size_t wall = 0; wall < beside.size(); ++wall) {
    if (beside[wall].front == beside[wall].back) continue;
    walls[beside[wall].front].push_back(wall);
    walls[beside[wall].back].push_back(wall);
  }
  return walls;
}

// Calls `visit(from, to, wall)` the first time that a region is come to, nearest regions first.
template <class Visit>
void visit_from_outside(const std::vector<Beside>& beside, std::size_t regions,
                        const Visit& visit) {
  const auto walls = walls_of_regions(beside, regions);
  std::vector<bool> is_visited(regions, false);
  std::vector<std::size_t> queue = {Regions::kUnbounded};
  is_visited[Regions::kUnbounded] = true;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const std::size_t from = queue[next];
    for (const std::size_t wall : walls[from]) {
      const std::size_t to = beside[wall].front == from ? beside[wall].back : beside[wall].front;
      if (is_visited[to]) continue;
      is_visited[to] = true;
      visit(from, to, wall);
      queue.push_back(to);
    }
  }
}

// Twice the area that a line encloses, along the normal about which it turns counterclockwise. (M.
// Newell's formula: the sum of cross products of corners that follow each other.)
Point area_of(const std::vector<Vertex>& line, const PointSet& points) {
  Point area = {0, 0, 0};
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    area = area +
           cross_product(points[line[i]] - points[line[0]], points[line[i + 1]] - points[line[0]]);
  }
  return area;
}

Point normal_of(const PolygonLines& lines, const PointSet& points) {
  Point normal = {0, 0, 0};
  for (const auto& line : lines.lines) {
    Point area = area_of(line, points);
    if (squared_length(area) > squared_length(normal)) normal = std::move(area);
  }
  return normal;
}

// A point before a wall with no wall in between.
Point point_before(const Regions& regions, const OrientedFacet& side) {
  const WallSet& walls = regions.walls();
  const std::vector<Point> corners = walls.corners(walls.place_of(side.vertices));
  const Point centre = barycentre(corners);
  const Point u = corners[1] - corners[0];
  Point step = {-u[1], u[0]};  // on the left, where the front of an edge is
  if (corners.size() == 3) step = cross_product(corners[2] - corners[0], u);
  if (side.reversed) step = Rational(-1) * step;
  // The plane of another wall may hold this way, however short it is; but only two at most of those
  // aside: they lie on a parabola, and its plane does not go through the centre.
  for (int t = 0;; ++t) {
    const Rational aside = t == 0 ? Rational(0) : Rational(1, t);
    Point way = step + aside * u;
    if (corners.size() == 3) way = way + aside * aside * (corners[2] - corners[0]);
    if (const auto part = walls.free_part(centre, way)) return centre + *part * way;
  }
}

}  // namespace

std::string_view name(Fill fill) {
  switch (fill) {
    case Fill::kEvenOdd:
      return "even-odd";
    case Fill::kWinding:
      return "winding";
    case Fill::kHull:
      return "hull";
    default:
      return "enclosed";
  }
}

NestingLevels nesting_levels(const Regions& regions) {
  const std::vector<Beside> beside = regions_beside_walls(regions);
  NestingLevels levels{std::vector<std::size_t>(regions.size(), 0), {}};
  visit_from_outside(beside, regions.size(), [&](std::size_t from, std::size_t to, std::size_t) {
    levels.of_region[to] = levels.of_region[from] + 1;
  });
  for (std::size_t wall = 0; wall < beside.size() && !levels.wall_of_no_parity; ++wall) {
    const auto& [front, back] = beside[wall];
    const bool differ = levels.of_region[front] % 2 != levels.of_region[back] % 2;
    if (front != back && !differ) levels.wall_of_no_parity = wall;
  }
  return levels;
}

std::vector<int> listed_directions(const PiecewiseLinearInput& input,
                                   const PiecewiseLinearComplex& complex, const Regions& regions) {
  const WallSet& walls = regions.walls();
  std::vector<int> directions(walls.size(), 0);
  if (complex.ambient_dimension() == 2) {
    for (const auto& segment : input.segments) {
      // The front of a wall with its vertices ascending is on its left.
      directions[walls.place_of(sorted(segment))] += segment[0] < segment[1] ? 1 : -1;
    }
    return directions;
  }
  for (std::size_t p = 0; p < complex.polygons.size(); ++p) {
    const Point normal = normal_of(input.polygons[p], complex.points);
    for (const Simplex& triangle : complex.polygons[p].triangles) {
      const std::size_t wall = walls.place_of(triangle);
      directions[wall] = -walls.side_of(wall, walls.point(triangle[0]) + normal);
    }
  }
  return directions;
}

tl::expected<std::vector<int>, std::size_t> winding_numbers(const Regions& regions,
                                                            const std::vector<int>& directions) {
  const std::vector<Beside> beside = regions_beside_walls(regions);
  std::vector<int> numbers(regions.size(), 0);
  visit_from_outside(beside, regions.size(),
                     [&](std::size_t from, std::size_t to, std::size_t wall) {
                       const bool to_front = beside[wall].front == to;
                       numbers[to] = numbers[from] + (to_front ? 1 : -1) * directions[wall];
                     });
  for (std::size_t wall = 0; wall < beside.size(); ++wall) {
    const auto& [front, back] = beside[wall];
    if (front != back && numbers[front] != numbers[back] + directions[wall]) {
      return tl::unexpected(wall);
    }
  }
  return numbers;
}

tl::expected<std::vector<Point>, std::size_t> seeds_of_unfilled(
    Fill fill, const PiecewiseLinearInput& input, const PiecewiseLinearComplex& complex,
    const Regions& regions) {
  std::vector<bool> is_filled(regions.size(), true);
  if (fill == Fill::kEvenOdd) {
    const NestingLevels levels = nesting_levels(regions);
    for (std::size_t r = 0; r < regions.size(); ++r) is_filled[r] = levels.of_region[r] % 2 == 1;
  } else if (fill == Fill::kWinding) {
    const auto numbers = winding_numbers(regions, listed_directions(input, complex, regions));
    if (!numbers) return tl::unexpected(numbers.error());
    for (std::size_t r = 0; r < regions.size(); ++r) is_filled[r] = (*numbers)[r] != 0;
  }
  const std::vector<Point> points = points_of_regions(regions);
  std::vector<Point> seeds;
  for (std::size_t r = 0; r < regions.size(); ++r) {
    if (r != Regions::kUnbounded && !is_filled[r]) seeds.push_back(points[r]);
  }
  return seeds;
}

std::vector<Point> points_of_regions(const Regions& regions) {
  std::vector<Point> points(regions.size());
  for (const Simplex& wall : regions.walls().simplices()) {
    for (const bool reversed : {false, true}) {
      const OrientedFacet side{wall, reversed};
      const std::size_t region = regions.in_front_of(side);
      if (region != Regions::kUnbounded && points[region].empty()) {
        points[region] = point_before(regions, side);
      }
    }
  }
  return points;
}

tl::expected<std::vector<Point>, std::size_t> seeds_of_unnamed(const std::vector<Point>& named,
                                                               const Regions& regions) {
  std::vector<bool> is_named(regions.size(), false);
  for (std::size_t place = 0; place < named.size(); ++place) {
    const auto region = regions.region_at(named[place]);
    if (!region || *region == Regions::kUnbounded) return tl::unexpected(place);
    is_named[*region] = true;
  }
  const std::vector<Point> points = points_of_regions(regions);
  std::vector<Point> seeds;
  for (std::size_t r = 0; r < regions.size(); ++r) {
    if (r != Regions::kUnbounded && !is_named[r]) seeds.push_back(points[r]);
  }
  return seeds;
}

}  // namespace circumspect
