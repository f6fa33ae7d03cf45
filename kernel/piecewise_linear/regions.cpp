#include "kernel/piecewise_linear/regions.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <functional>
#include <map>
#include <numeric>
#include <optional>

#include "kernel/complex/simplex.hpp"
#include "kernel/exact/linear_algebra.hpp"
#include "kernel/piecewise_linear/disjoint_sets.hpp"
#include "kernel/predicates/orientation.hpp"

namespace circumspect {
namespace {

// The regions are the components of the complement of all walls. Number 0 is the unbounded one, the
// others are numbered in the order in which they first appear here.
struct WallSides {
  std::vector<std::size_t> region;  // in front of wall i at place 2i, behind it at 2i + 1
  std::size_t regions = 1;
};

using Crossings = std::vector<Crossing>;
// The walls that a straight segment crosses; nothing if it is not generic.
using CrossingsOf = std::function<std::optional<Crossings>(const Point&, const Point&)>;

// Sides are numbered as in WallSides.
std::size_t side_met(const Crossing& c) { return 2 * c.wall + (c.from_front ? 0 : 1); }
std::size_t side_left(const Crossing& c) { return 2 * c.wall + (c.from_front ? 1 : 0); }

// The walls crossed by a path that goes straight from one point to a point off all walls, and
// straight on to another.
std::optional<Crossings> on_path(const CrossingsOf& crossings_of, const Point& from,
                                 const Point& by, const Point& to) {
  auto first = crossings_of(from, by);
  if (!first) return std::nullopt;
  const auto second = crossings_of(by, to);
  if (!second) return std::nullopt;
  first->insert(first->end(), second->begin(), second->end());
  return first;
}

// Points near a straight path, for a bend in it. The points for t = 1, 2, … lie on a moment curve;
// `scale` says how far they are from `origin`.
Point on_moment_curve(const Point& origin, const Rational& scale, int t) {
  // The factors keep the curve off the symmetry planes of symmetric inputs.
  const Rational factors[] = {Rational(1, 57), Rational(1, 83), Rational(1, 109)};
  Point point = origin;
  Rational power = scale;
  for (std::size_t axis = 0; axis < point.size(); ++axis) {
    power *= t;
    point[axis] += power * factors[axis];
  }
  return point;
}

// The path between two points, bent at the t-th of some points near its middle, which lie on moment
// curves as well.
Point bend(const Point& from, const Point& to, int t) {
  Rational length = 0;
  for (std::size_t axis = 0; axis < from.size(); ++axis) length += abs(to[axis] - from[axis]);
  return on_moment_curve(Rational(1, 2) * (from + to), length == 0 ? Rational(1) : length, t);
}

// Joins the sides of walls that face each other, in three ways.
//
// 1. Around a ridge (in space an edge, in the plane a vertex) the walls are sorted in rotary order;
//    the near sides of two that follow each other bound one wedge of the complement. A ridge with
//    one wall joins its two sides.
// 2. (Space only.) Walls at a vertex x, cut by a small sphere about x, are arcs; a component of
//    what they leave of the sphere is a cone of the complement at x. Step 1 has joined the sides of
//    arcs that share ends. If the arcs are connected, no more is needed; else a path on the sphere
//    is drawn from an arc of each connected set of arcs to one of the next, and wherever it crosses
//    two arcs in succession, the sides between are joined.
// 3. Likewise a path is drawn from one connected set of walls to the next, all of them in a row.
//
// Nothing false is joined: two crossings in succession face each other through one region. And
// everything is. Take a region U and make it smaller by a thin layer along all walls, so that its
// boundary is a closed surface (3: in space; 2: on the sphere about x, a curve), along which one
// can walk from wall side to wall side around ridges and, on a surface, corners. The complement of
// U (infinity included, so that U lies on a sphere of some dimension) falls into connected pieces
// D_1, D_2, …; the boundary of one is connected, for the sphere is unicoherent: if two connected
// closed sets D_i and the closure of the rest cover it, they meet in a connected set. So all sides
// that face U from one D_i are joined by walking along the surface: by step 1 and, at corners, by
// step 2. Every D_i that U has a wall in common with contains with one wall all that is connected
// to it, so the path visits every D_i. Between its stay in one D_i and the next in D_j it goes
// through U alone, and the last wall it has left and the next one it meets join the sides of D_i
// with those of D_j. As it visits all of them, all are joined.
//
// Paths are made of straight segments that meet walls in interior points only, out of the walls'
// own planes; a bend in each makes that possible. For all but finitely many points of a moment
// curve (t, t², t³), which meets no plane more than three times, it is so.
class Joining {
 public:
  Joining(const PointSet& points, const WallSet& walls)
      : points_(points), walls_(walls), sides_(2 * walls.size()), first_at_(points.size(), kNone) {
    axes_.resize(points.ambient_dimension());
    std::iota(axes_.begin(), axes_.end(), std::size_t{0});
  }

  void around_ridges() {
    std::vector<Apex> apexes;
    apexes.reserve(walls_.size() * axes_.size());
    for (std::size_t i = 0; i < walls_.size(); ++i) {
      for (std::size_t place = 0; place < axes_.size(); ++place) {
        Apex apex = {{-1, -1}, i, place};
        for (std::size_t j = 0; j + 1 < axes_.size(); ++j) {
          apex.ridge[j] = wall(i)[j < place ? j : j + 1];
        }
        apexes.push_back(apex);
      }
    }
    std::stable_sort(apexes.begin(), apexes.end(),
                     [](const Apex& a, const Apex& b) { return a.ridge < b.ridge; });
    for (auto first = apexes.begin(); first != apexes.end();) {
      const auto end =
          std::find_if(first, apexes.end(), [&](const Apex& a) { return a.ridge != first->ridge; });
      around_ridge({first, end});
      first = end;
    }
  }

  void around_corners() {
    std::vector<std::vector<std::size_t>> stars(points_.size());
    for (std::size_t i = 0; i < walls_.size(); ++i) {
      for (const Vertex v : wall(i)) stars[static_cast<std::size_t>(v)].push_back(i);
    }
    for (std::size_t v = 0; v < stars.size(); ++v) {
      const auto x = static_cast<Vertex>(v);
      const auto crossings_of = [&](const Point& from, const Point& to) {
        return walls_.cone_crossings(x, stars[v], from, to);
      };
      join_one_by_one(one_of_each_component(stars[v], x), crossings_of);
    }
  }

  void across_space() {
    std::vector<std::size_t> all(walls_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    join_one_by_one(one_of_each_component(all, std::nullopt), crossings_of_walls());
  }

  WallSides result() {
    WallSides result;
    result.region.resize(2 * walls_.size());
    std::map<std::size_t, std::size_t> number = {{sides_.find(unbounded_side()), 0}};
    for (std::size_t side = 0; side < result.region.size(); ++side) {
      result.region[side] = number.try_emplace(sides_.find(side), number.size()).first->second;
    }
    result.regions = number.size();
    return result;
  }

 private:
  const Simplex& wall(std::size_t i) const { return walls_.simplices()[i]; }

  // A wall at a ridge, which lacks the vertex at one of its places.
  struct Apex {
    std::array<Vertex, 2> ridge;  // ascending; in the plane one vertex, and −1
    std::size_t wall;
    std::size_t place;
  };
  Vertex vertex_at(const Apex& apex) const { return wall(apex.wall)[apex.place]; }

  // The side of a wall towards which it turns about the ridge, positively or negatively. Moving the
  // apex behind the ridge takes one transposition for each vertex after it.
  std::size_t side_towards(const Apex& apex, bool positive) const {
    const bool is_odd = (wall(apex.wall).size() - 1 - apex.place) % 2 == 1;
    return 2 * apex.wall + (is_odd == positive ? 1 : 0);
  }

  void around_ridge(std::span<const Apex> apexes) {
    if (apexes.size() <= 2) {  // each is next to the other
      join_in_turn(apexes);
      return;
    }
    const auto turn = [&](const Apex& a, const Apex& b) {
      const auto& ridge = a.ridge;
      Simplex simplex(ridge.begin(), ridge.begin() + static_cast<std::ptrdiff_t>(axes_.size() - 1));
      simplex.insert(simplex.end(), {vertex_at(a), vertex_at(b)});
      return orientation(points_.configuration(), axes_, simplex);
    };
    // At most half a turn from the first wall, or more? Two walls that meet only in the ridge are
    // in one hyperplane only if they are half a turn apart.
    std::vector<std::pair<int, Apex>> order;
    for (const Apex& apex : apexes) {
      const bool is_first = &apex == &apexes.front();
      const int side = is_first ? 0 : turn(apexes.front(), apex);
      order.emplace_back(is_first ? 0 : side > 0 ? 1 : side == 0 ? 2 : 3, apex);
    }
    std::sort(order.begin(), order.end(), [&](const auto& a, const auto& b) {
      if (a.first != b.first) return a.first < b.first;
      return a.second.wall != b.second.wall && turn(a.second, b.second) > 0;
    });
    std::vector<Apex> in_turn;
    for (const auto& [half, apex] : order) in_turn.push_back(apex);
    join_in_turn(in_turn);
  }

  void join_in_turn(std::span<const Apex> apexes) {
    for (std::size_t i = 0; i < apexes.size(); ++i) {
      const Apex& next = apexes[(i + 1) % apexes.size()];
      sides_.unite(side_towards(apexes[i], true), side_towards(next, false));
    }
  }

  // One of each set of walls that are connected by vertices, other than `apart`, in lexicographic
  // order of their centres; none if all are connected.
  std::vector<std::size_t> one_of_each_component(const std::vector<std::size_t>& walls,
                                                 std::optional<Vertex> apart) {
    DisjointSets components(walls.size());
    for (std::size_t i = 0; i < walls.size(); ++i) {
      for (const Vertex v : wall(walls[i])) {
        if (v == apart) continue;
        std::size_t& first = first_at_[static_cast<std::size_t>(v)];
        if (first == kNone) first = i;
        components.unite(i, first);
      }
    }
    for (const std::size_t i : walls) {
      for (const Vertex v : wall(i)) first_at_[static_cast<std::size_t>(v)] = kNone;
    }
    std::vector<bool> has_one(walls.size(), false);
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < walls.size(); ++i) {
      const std::size_t set = components.find(i);
      if (!has_one[set]) found.push_back(walls[i]);
      has_one[set] = true;
    }
    if (found.size() <= 1) return {};
    std::vector<std::pair<Point, std::size_t>> by_centre;
    for (const std::size_t place : found) by_centre.emplace_back(walls_.centre(place), place);
    std::sort(by_centre.begin(), by_centre.end());
    for (std::size_t i = 0; i < found.size(); ++i) found[i] = by_centre[i].second;
    return found;
  }

  void join_one_by_one(const std::vector<std::size_t>& walls, const CrossingsOf& crossings_of) {
    for (std::size_t i = 0; i + 1 < walls.size(); ++i) {
      const Point from = walls_.centre(walls[i]), to = walls_.centre(walls[i + 1]);
      std::optional<Crossings> crossed;
      for (int t = 1; !crossed; ++t) crossed = on_path(crossings_of, from, bend(from, to, t), to);
      for (std::size_t j = 0; j + 1 < crossed->size(); ++j) {
        sides_.unite(side_left((*crossed)[j]), side_met((*crossed)[j + 1]));
      }
    }
  }

  CrossingsOf crossings_of_walls() const {
    return [this](const Point& from, const Point& to) { return walls_.crossings(from, to); };
  }

  // A side that faces the unbounded region: the last one that is left on a path to a point with a
  // greater first coordinate than any wall.
  std::size_t unbounded_side() const {
    std::size_t last = 0;
    Vertex extreme = wall(0)[0];
    for (std::size_t i = 0; i < walls_.size(); ++i) {
      for (const Vertex v : wall(i)) {
        if (points_.configuration().rank(v) > points_.configuration().rank(extreme)) {
          last = i;
          extreme = v;
        }
      }
    }
    const Point from = walls_.centre(last);
    const Rational farther = walls_.point(extreme)[0] - from[0] + 1;
    Point beyond = from;
    beyond[0] += farther;
    for (int t = 1;; ++t) {
      const auto crossed = walls_.crossings(from, on_moment_curve(beyond, farther, t));
      if (crossed) return side_left(crossed->back());
    }
  }

  const PointSet& points_;
  const WallSet& walls_;
  std::vector<std::size_t> axes_;
  DisjointSets sides_;
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> first_at_;  // all kNone, but while one_of_each_component runs
};

WallSides wall_sides(const PointSet& points, const WallSet& walls) {
  if (walls.size() == 0) return {};
  Joining joining(points, walls);
  joining.around_ridges();
  if (points.ambient_dimension() == 3) joining.around_corners();
  joining.across_space();
  return joining.result();
}

}  // namespace

Regions::Regions(const PointSet& points, const std::vector<Simplex>& walls,
                 const std::vector<Point>& hole_seeds, DomainKind kind)
    : Regions(points, walls, {}, hole_seeds, kind) {}

Regions::Regions(const PiecewiseLinearComplex& complex, const std::vector<Point>& hole_seeds,
                 DomainKind kind)
    : Regions(complex.points, circumspect::walls(complex), complex.segments, hole_seeds, kind) {}

Regions::Regions(const PointSet& points, const std::vector<Simplex>& walls,
                 const std::vector<Simplex>& segments, const std::vector<Point>& hole_seeds,
                 DomainKind kind)
    : kind_(kind),
      walls_(std::make_shared<const WallSet>(points, walls)),
      cells_(std::make_shared<const NearbyCells>(points, segments)) {
  WallSides sides = wall_sides(points, *walls_);
  region_of_side_ = std::move(sides.region);
  where_.assign(sides.regions, Where::kInside);
  if (kind == DomainKind::kEnclosed) {
    where_[kUnbounded] = Where::kOutside;
    make_holes(hole_seeds);
    return;
  }
  hull_of_ = std::make_shared<const std::vector<Point>>(points.points());
  if (points.dimension() < static_cast<int>(points.ambient_dimension())) {
    where_[kUnbounded] = Where::kOutside;
  }
  for (std::size_t i = 0; i < hole_seeds.size(); ++i) ignored_seeds_.push_back(i);
}

void Regions::make_holes(const std::vector<Point>& hole_seeds) {
  for (std::size_t i = 0; i < hole_seeds.size(); ++i) {
    const auto region = region_at(hole_seeds[i]);
    assert(region);
    if (*region == kUnbounded) {
      ignored_seeds_.push_back(i);
    } else {
      where_[*region] = Where::kHole;
    }
  }
}

std::size_t Regions::in_front_of(const OrientedFacet& wall) const {
  return beside(walls_->place_of(wall.vertices))[wall.reversed ? 0 : 1];
}

std::optional<std::size_t> Regions::region_at(const Point& point) const {
  if (walls_->size() == 0) return kUnbounded;
  if (!walls_->at(point).empty()) return std::nullopt;
  // On a path to a wall, with a bend as above, the first wall that is met faces the point.
  const Point target = walls_->centre(walls_->not_far_from(point));
  for (int t = 1;; ++t) {
    const Point by = bend(point, target, t);
    auto crossed = walls_->crossings(point, by);
    if (crossed && crossed->empty()) crossed = walls_->crossings(by, target);
    if (!crossed) continue;
    const Crossing& first = crossed->front();
    return region_of_side_[2 * first.wall + (first.from_front ? 0 : 1)];
  }
}

Where Regions::locate(const Point& point) const {
  const auto region = region_at(point);
  if (!region) return Where::kOnWall;
  if (kind_ == DomainKind::kHull && *region == kUnbounded && !is_in_hull(point)) {
    return Where::kOutside;
  }
  return where_[*region];
}

// Is it a convex combination of the points?
bool Regions::is_in_hull(const Point& point) const {
  RationalMatrix rows(point.size() + 1);
  for (const Point& p : *hull_of_) {
    for (std::size_t axis = 0; axis < p.size(); ++axis) rows[axis].push_back(p[axis]);
    rows.back().emplace_back(1);
  }
  std::vector<Rational> right = point;
  right.emplace_back(1);
  return is_solvable(std::move(rows), std::move(right));
}

}  // namespace circumspect
