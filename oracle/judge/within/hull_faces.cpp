#include "oracle/judge/within/hull_faces.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "kernel/piecewise_linear/polygon_triangles.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/place.hpp"
#include "oracle/judge/within/point_tree.hpp"

namespace circumspect::check {
namespace {

// Gift wrapping: from each face across each of its edges to the next, turning a plane about the
// edge until no point is above it.
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

  // The plane through the first two points that has none above it. Requires: some plane through
  // these has all points on one side, and the third is off it.
  Three turned(Three plane) const {
    while (const auto higher = tree_.above(plane)) plane[2] = *higher;
    return plane;
  }

  // An upright plane with all points on one side, through the first of them in lexicographic order.
  // Where all its points are on a line, it is turned about this.
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

  // The face in a plane that has no point above it: its edges are open, but for those to which it
  // is the next.
  void add(const Three& plane) {
    std::vector<Vertex> on = tree_.on(plane);
    const auto axes = axes_of_plane(points_.configuration(), plane);
    const int turn = orientation(points_.configuration(), axes, plane);
    std::vector<Simplex> triangles = {on};
    if (on.size() > 3) triangles = triangulate_by_sweep(points_, axes, on, {});
    for (const auto uses : ByFacet(facet_uses(triangles))) {
      if (uses.size() > 1) continue;
      const FacetUse& use = uses.front();
      Edge edge = {use.facet[0], use.facet[1]};
      const Vertex apex = triangles[use.simplex][use.opposite];
      if (side_of_facet(points_.configuration(), axes, use.facet, apex) != turn)
        std::swap(edge.first, edge.second);
      if (open_.erase({edge.second, edge.first}) == 0) open_.emplace(edge, plane);
    }
    faces_.push_back(std::move(on));
  }

  const PointSet& points_;
  PointTree tree_;
  // Edges with a face on one side only, directed as they turn counterclockwise about it, and its
  // plane.
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

}  // namespace circumspect::check
