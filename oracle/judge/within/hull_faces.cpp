#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "kernel/complex/simplex.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "kernel/piecewise_linear/polygon_triangles.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/place.hpp"
#include "oracle/judge/within/distance.hpp"
#include "oracle/judge/within/hull_walls.hpp"

namespace circumspect::check {
namespace {

using Three = std::array<Vertex, 3>;

// All points in a tree of boxes of doubles, each half as many as the one above. It answers which of them are above a
// plane, asking about few.
class PointTree {
 public:
  explicit PointTree(const PointSet& points)
      : points_(points),
        rounded_(Rounding(points.points()).points(points.points())),
        order_(all_vertices(points)) {
    for (const RoundedPoint& point : rounded_) error_ = std::max(error_, point.error);
    build(0, order_.size());
  }

  // A point above the plane through three, from where they turn counterclockwise, if there is one; of those that are
  // certainly there the highest.
  std::optional<Vertex> above(const Three& plane) const {
    Query query(*this, plane);
    visit(
        0, 0, order_.size(),
        [&](const Bounds& box) { return query.range(box.low, box.high).second > query.highest; },
        [&](Vertex v) {
          const RoundedPoint& at = rounded_[static_cast<std::size_t>(v)];
          const auto [least, most] = query.range(at.at, at.at);
          if (least > query.highest) {
            query.highest = least;
            query.found = v;
          } else if (most > 0 && !query.found && side(plane, v) > 0) {
            query.found = v;
          }
        });
    return query.found;
  }
  // All points of the plane, ascending.
  std::vector<Vertex> on(const Three& plane) const {
    const Query query(*this, plane);
    std::vector<Vertex> found;
    const auto may_hold = [&](const auto& low, const auto& high) {
      const auto [least, most] = query.range(low, high);
      return least <= 0 && most >= 0;
    };
    visit(
        0, 0, order_.size(), [&](const Bounds& box) { return may_hold(box.low, box.high); },
        [&](Vertex v) {
          const RoundedPoint& at = rounded_[static_cast<std::size_t>(v)];
          if (may_hold(at.at, at.at) && side(plane, v) == 0) found.push_back(v);
        });
    std::sort(found.begin(), found.end());
    return found;
  }
  // Positive above, zero in the plane.
  int side(const Three& plane, Vertex v) const {
    if (v == plane[0] || v == plane[1] || v == plane[2]) return 0;
    const std::array<Vertex, 4> four = {plane[0], plane[1], plane[2], v};
    return -orientation(points_.configuration(), kSpace, four);
  }

 private:
  using Coordinates = std::array<double, 3>;
  struct Bounds {
    Coordinates low, high;
  };
  static constexpr std::size_t kLeaf = 8;

  // Heights of points over a plane. As computed, a height is a sum of six products of three differences: the errors
  // of these are at most 2·error each, and all roundings together less than 10u of what each product may be.
  struct Query {
    Query(const PointTree& tree, const Three& plane) : error(2 * tree.error_) {
      const auto at = [&](std::size_t i) {
        return tree.rounded_[static_cast<std::size_t>(plane[i])].at;
      };
      from = at(0);
      const auto difference = [&](const Coordinates& a) {
        return Coordinates{a[0] - from[0], a[1] - from[1], a[2] - from[2]};
      };
      const Coordinates u = difference(at(1)), v = difference(at(2));
      normal = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
      first = largest(u);
      second = largest(v);
    }
    static double largest(const Coordinates& d) {
      return std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])});
    }
    // The least and the greatest height that a point between these may have.
    std::pair<double, double> range(const Coordinates& low, const Coordinates& high) const {
      double least = 0, most = 0, far = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const double one = low[i] - from[i], other = high[i] - from[i];
        far = std::max({far, std::abs(one), std::abs(other)});
        const double a = normal[i] * one, b = normal[i] * other;
        least += std::min(a, b);
        most += std::max(a, b);
      }
      const double size = (first + error) * (second + error) * (far + error);
      const double known = error == 0 ? size : first * second * far;
      const double bound = 2e-14 * size + 6.01 * (size - known) + 1e-200;
      constexpr double kInfinity = std::numeric_limits<double>::infinity();
      // Where numbers are infinite, or so large that products that vanish might count, nothing is known.
      if (!(size < 1e250 && std::max({first, second, far}) < 1e90)) return {-kInfinity, kInfinity};
      return {least - bound, most + bound};
    }

    double error;
    Coordinates from, normal;
    double first, second;
    double highest = 0;
    std::optional<Vertex> found = {};
  };

  // The subtree of the points from `first` up to `last` is numbered `node`, its halves 2·node + 1 and 2·node + 2.
  void build(std::size_t first, std::size_t last, std::size_t node = 0) {
    if (bounds_.size() <= node) bounds_.resize(node + 1);
    Bounds box{rounded_[static_cast<std::size_t>(order_[first])].at, {}};
    box.high = box.low;
    for (std::size_t i = first; i < last; ++i) {
      const Coordinates& at = rounded_[static_cast<std::size_t>(order_[i])].at;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        box.low[axis] = std::min(box.low[axis], at[axis]);
        box.high[axis] = std::max(box.high[axis], at[axis]);
      }
    }
    bounds_[node] = box;
    if (last - first <= kLeaf) return;
    std::size_t longest = 0;
    for (const std::size_t axis : {std::size_t{1}, std::size_t{2}}) {
      if (box.high[axis] - box.low[axis] > box.high[longest] - box.low[longest]) longest = axis;
    }
    const auto at = [&](std::size_t place) {
      return order_.begin() + static_cast<std::ptrdiff_t>(place);
    };
    const std::size_t middle = first + (last - first) / 2;
    std::nth_element(at(first), at(middle), at(last), [&](Vertex a, Vertex b) {
      return rounded_[static_cast<std::size_t>(a)].at[longest] <
             rounded_[static_cast<std::size_t>(b)].at[longest];
    });
    build(first, middle, 2 * node + 1);
    build(middle, last, 2 * node + 2);
  }

  template <class IsOfInterest, class Look>
  void visit(std::size_t node, std::size_t first, std::size_t last, const IsOfInterest& is_wanted,
             const Look& look) const {
    if (!is_wanted(bounds_[node])) return;
    if (last - first <= kLeaf) {
      for (std::size_t i = first; i < last; ++i) look(order_[i]);
      return;
    }
    const std::size_t middle = first + (last - first) / 2;
    visit(2 * node + 1, first, middle, is_wanted, look);
    visit(2 * node + 2, middle, last, is_wanted, look);
  }

  const PointSet& points_;
  std::vector<RoundedPoint> rounded_;
  double error_ = 0;
  std::vector<Vertex> order_;
  std::vector<Bounds> bounds_;
};

// Gift wrapping: from each face across each of its edges to the next, turning a plane about the edge until no
// point is above it.
class Wrapping {
 public:
  explicit Wrapping(const PointSet& points) : points_(points), tree_(points) {}

  std::vector<std::vector<Vertex>> faces() {
    add(first_plane());
    while (!open_.empty()) {
      const auto [edge, plane] = *open_.begin();
      // Some point off the plane of the face that is known, hence below it.
      const Vertex below = *tree_.above({plane[1], plane[0], plane[2]});
      add(turned({edge.second, edge.first, below}));
    }
    std::sort(faces_.begin(), faces_.end());
    return std::move(faces_);
  }

 private:
  using Edge = std::pair<Vertex, Vertex>;

  // The plane through the first two points that has none above it. Requires: some plane through these has all points
  // on one side, and the third is off it.
  Three turned(Three plane) const {
    while (const auto higher = tree_.above(plane)) plane[2] = *higher;
    return plane;
  }

  // An upright plane with all points on one side, through the first of them in lexicographic order. Where all its
  // points are on a line, it is turned about this.
  Three first_plane() const {
    const Configuration& points = points_.configuration();
    constexpr std::array<std::size_t, 2> kFloor = {0, 1};
    const std::vector<Vertex> all = all_vertices(points_);
    const Vertex first = *std::min_element(all.begin(), all.end(), [&](Vertex a, Vertex b) {
      return points.rank(a) < points.rank(b);
    });
    const auto turn = [&](Vertex a, Vertex b) {
      return orientation(points, kFloor, std::array<Vertex, 3>{first, a, b});
    };
    const auto is_above_first = [&](Vertex v) {
      return points_[v][0] == points_[first][0] && points_[v][1] == points_[first][1];
    };
    Vertex last = *std::find_if_not(all.begin(), all.end(), is_above_first);
    for (const Vertex v : all) {
      if (turn(last, v) < 0) last = v;
    }
    std::vector<Vertex> upright;
    for (const Vertex v : all) {
      if (turn(last, v) == 0) upright.push_back(v);
    }
    const Flat flat = flat_through(points_, upright);
    Three plane = {flat.basis[0], flat.basis[1], -1};
    if (flat.dimension() == 2) {
      plane[2] = flat.basis[2];
      if (tree_.above(plane)) std::swap(plane[0], plane[1]);
      return plane;
    }
    plane[2] = *std::find_if_not(all.begin(), all.end(), [&](Vertex v) {
      return std::binary_search(upright.begin(), upright.end(), v);
    });
    return turned(plane);
  }

  // The face in a plane that has no point above it: its edges are open, but for those to which it is the next.
  void add(const Three& plane) {
    std::vector<Vertex> on = tree_.on(plane);
    const auto axes = axes_of_plane(points_.configuration(), plane);
    const int turn = orientation(points_.configuration(), axes, plane);
    std::vector<Simplex> triangles = {on};
    if (on.size() > 3) triangles = triangulate_by_sweep(points_, axes, on, {});
    for_each_facet(facet_uses(triangles), [&](std::span<const FacetUse> uses) {
      if (uses.size() > 1) return;
      const FacetUse& use = uses.front();
      Simplex corners = use.facet;
      corners.push_back(triangles[use.simplex][use.opposite]);
      Edge edge = {corners[0], corners[1]};
      if (orientation(points_.configuration(), axes, corners) != turn)
        std::swap(edge.first, edge.second);
      if (open_.erase({edge.second, edge.first}) == 0) open_.emplace(edge, plane);
    });
    faces_.push_back(std::move(on));
  }

  const PointSet& points_;
  PointTree tree_;
  // Edges with a face on one side only, directed as they turn counterclockwise about it, and its plane.
  std::map<Edge, Three> open_;
  std::vector<std::vector<Vertex>> faces_;
};

// In the plane, after A. Andrew: the lower chain, then the upper one.
std::vector<std::vector<Vertex>> hull_lines(const PointSet& points) {
  const Configuration& configuration = points.configuration();
  std::vector<Vertex> order = all_vertices(points);
  std::sort(order.begin(), order.end(),
            [&](Vertex a, Vertex b) { return configuration.rank(a) < configuration.rank(b); });
  std::vector<std::vector<Vertex>> lines;
  for (const bool upper : {false, true}) {
    std::vector<Vertex> chain;
    for (const Vertex v : order) {
      while (chain.size() >= 2 &&
             orientation(configuration,
                         std::array<Vertex, 3>{chain[chain.size() - 2], chain.back(), v}) < 0) {
        chain.pop_back();
      }
      chain.push_back(v);
    }
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      const bool goes_on =
          i > 0 && orientation(configuration,
                               std::array<Vertex, 3>{chain[i - 1], chain[i], chain[i + 1]}) == 0;
      if (goes_on) {
        lines.back().push_back(chain[i + 1]);
      } else {
        lines.push_back({chain[i], chain[i + 1]});
      }
    }
    if (!upper) std::reverse(order.begin(), order.end());
  }
  for (auto& line : lines) std::sort(line.begin(), line.end());
  std::sort(lines.begin(), lines.end());
  return lines;
}

}  // namespace

std::vector<std::vector<Vertex>> hull_faces(const PointSet& points) {
  return points.ambient_dimension() == 2 ? hull_lines(points) : Wrapping(points).faces();
}

std::vector<std::vector<Vertex>> hull_faces_by_definition(const PointSet& points) {
  const std::size_t dimension = points.ambient_dimension();
  std::set<std::vector<Vertex>> faces;
  Simplex some = first_subset(dimension);
  do {
    if (flat_through(points, some).dimension() + 1 < dimension) continue;
    std::vector<Vertex> on;
    int side = 0;  // of those that are off the plane; 2: both
    for (Vertex v = 0; points.names(v) && side != 2; ++v) {
      Simplex simplex = some;
      simplex.push_back(v);
      const int other = contains(some, v) ? 0 : orientation(points.configuration(), simplex);
      if (other == 0) on.push_back(v);
      if (other != 0) side = side == 0 || side == other ? other : 2;
    }
    if (side != 2) faces.insert(on);
  } while (next_subset(some, points.size()));
  return {faces.begin(), faces.end()};
}

}  // namespace circumspect::check
