#include "oracle/judge/within/hull_walls.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/exact/each_once.hpp"
#include "kernel/piecewise_linear/disjoint_sets.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "kernel/piecewise_linear/polygon_triangles.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/place.hpp"

namespace circumspect::check {
namespace {

class Walls {
 public:
  explicit Walls(const PiecewiseLinearComplex& complex)
      : given_(complex), result_(complex), configuration_(complex.points.configuration()) {
    result_.kind = DomainKind::kEnclosed;
    result_.hole_seeds.clear();
    for (const Simplex& segment : given_.segments) {
      later_ends_[segment[0]].push_back(segment[1]);
    }
  }

  PiecewiseLinearComplex result(const std::vector<std::vector<Vertex>>& faces) {
    for (const std::vector<Vertex>& face : faces) {
      if (given_.ambient_dimension() == 2) {
        add_line(face);
      } else {
        add_face(face);
      }
    }
    std::vector<Simplex>& segments = result_.segments;
    keep_each_once(segments);
    return std::move(result_);
  }

 private:
  void add_line(std::vector<Vertex> line) {
    std::sort(line.begin(), line.end(),
              [&](Vertex a, Vertex b) { return configuration_.rank(a) < configuration_.rank(b); });
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      result_.segments.push_back(sorted({line[i], line[i + 1]}));
    }
  }

  void add_face(const std::vector<Vertex>& face) {
    const auto axes = axes_of_plane(configuration_, flat_through(given_.points, face).basis);
    std::set<Simplex> segments = segments_between(face);
    const std::vector<Simplex> triangles =
        triangulate_by_sweep(given_.points, axes, face, {segments.begin(), segments.end()});
    const std::vector<FacetUse> uses = facet_uses(triangles);
    for (const auto at_edge : ByFacet(uses)) {
      if (at_edge.size() == 1) segments.insert(at_edge.front().facet);
    }
    result_.segments.insert(result_.segments.end(), segments.begin(), segments.end());
    DisjointSets parts(triangles.size());
    for (const auto at_edge : ByFacet(uses)) {
      if (segments.contains(at_edge.front().facet)) continue;
      parts.unite(at_edge[0].simplex, at_edge[1].simplex);
    }
    const std::set<EdgeSide> covered = sides_of_polygons(face, axes);
    std::map<std::size_t, std::vector<Simplex>> bare;
    std::set<std::size_t> not_bare;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      bare[parts.find(t)].push_back(triangles[t]);
      for (const EdgeSide& side : edge_sides(triangles[t], axes)) {
        if (segments.contains(side.first) && covered.contains(side)) not_bare.insert(parts.find(t));
      }
    }
    for (auto& [part, own] : bare) {
      if (!not_bare.contains(part))
        result_.polygons.push_back(polygon(std::move(own), axes, segments));
    }
  }

  std::set<Simplex> segments_between(const std::vector<Vertex>& face) const {
    std::set<Simplex> found;
    for (const Vertex v : face) {
      const auto ends = later_ends_.find(v);
      if (ends == later_ends_.end()) continue;
      for (const Vertex w : ends->second) {
        if (std::binary_search(face.begin(), face.end(), w)) found.insert({v, w});
      }
    }
    return found;
  }

  // An edge of a triangle, and on which side of it the triangle lies in its plane.
  using EdgeSide = std::pair<Simplex, int>;
  std::vector<EdgeSide> edge_sides(const Simplex& triangle,
                                   const std::vector<std::size_t>& axes) const {
    std::vector<EdgeSide> sides;
    for (std::size_t place = 0; place < 3; ++place) {
      const Simplex edge = facet_opposite(triangle, place);
      sides.emplace_back(edge, side_of_facet(configuration_, axes, edge, triangle[place]));
    }
    return sides;
  }

  // What is between segments is in a polygon if a polygon is beside one of these segments on that
  // side.
  std::set<EdgeSide> sides_of_polygons(const std::vector<Vertex>& face,
                                       const std::vector<std::size_t>& axes) {
    if (polygons_at_.empty()) {
      for (std::size_t p = 0; p < given_.polygons.size(); ++p) {
        for (const Vertex v : given_.polygons[p].triangles.front()) polygons_at_[v].push_back(p);
      }
    }
    std::set<std::size_t> near;
    for (const Vertex v : face) {
      const auto at = polygons_at_.find(v);
      if (at != polygons_at_.end()) near.insert(at->second.begin(), at->second.end());
    }
    std::set<EdgeSide> covered;
    for (const std::size_t p : near) {
      const Simplex& some = given_.polygons[p].triangles.front();
      if (!std::includes(face.begin(), face.end(), some.begin(), some.end())) continue;
      for (const Simplex& triangle : given_.polygons[p].triangles) {
        for (EdgeSide& side : edge_sides(triangle, axes)) covered.insert(std::move(side));
      }
    }
    return covered;
  }

  static Polygon polygon(std::vector<Simplex> triangles, const std::vector<std::size_t>& axes,
                         const std::set<Simplex>& segments) {
    std::set<Vertex> vertices;
    std::set<Simplex> inside;
    for (const Simplex& triangle : triangles) {
      vertices.insert(triangle.begin(), triangle.end());
      for (std::size_t place = 0; place < 3; ++place) {
        Simplex edge = facet_opposite(triangle, place);
        if (segments.contains(edge)) inside.insert(std::move(edge));
      }
    }
    return {{vertices.begin(), vertices.end()},
            {inside.begin(), inside.end()},
            {},
            axes,
            std::move(triangles)};
  }

  const PiecewiseLinearComplex& given_;
  PiecewiseLinearComplex result_;
  const Configuration& configuration_;
  std::map<Vertex, std::vector<Vertex>> later_ends_;  // of segments, by their first
  std::map<Vertex, std::vector<std::size_t>>
      polygons_at_;  // by the corners of their first triangles
};

}  // namespace

PiecewiseLinearComplex with_hull_walls(const PiecewiseLinearComplex& complex,
                                       const std::vector<std::vector<Vertex>>& faces) {
  return Walls(complex).result(faces);
}

}  // namespace circumspect::check
