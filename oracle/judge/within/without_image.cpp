#include "oracle/judge/within/without_image.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "kernel/complex/by_facet.hpp"
#include "kernel/exact/each_once.hpp"
#include "kernel/piecewise_linear/disjoint_sets.hpp"

namespace circumspect::check {
namespace {

constexpr std::size_t kMostTriangles = 64;  // of a polygon

std::vector<RoundedPoint> rounded_points(const Mesh& mesh, const Rounding& rounding) {
  std::vector<RoundedPoint> points;
  points.reserve(mesh.points());
  const auto* const doubles = std::get_if<Rows<double>>(&mesh.coordinates);
  for (std::size_t v = 0; v < mesh.points(); ++v) {
    points.push_back(doubles != nullptr ? rounding.point(doubles->row(v))
                                        : rounding.point(mesh.point(static_cast<Vertex>(v))));
  }
  return points;
}

bool is_among(const std::vector<Vertex>& some, Vertex v) {
  return std::binary_search(some.begin(), some.end(), v);
}

// Calls visit(vertices) for each simplex and listed face that has two or more vertices among some,
// with these.
template <class Visit>
void for_each_among(const Mesh& mesh, const std::vector<Vertex>& some, const Visit& visit) {
  std::vector<bool> is_one(mesh.points(), false);
  for (const Vertex v : some) is_one[static_cast<std::size_t>(v)] = true;
  Simplex found;
  const auto look_at = [&](const auto& simplex) {
    found.clear();
    for (const auto v : simplex) {
      if (mesh.names(v) && is_one[static_cast<std::size_t>(v)]) found.push_back(v);
    }
    if (found.size() > 1) visit(found);
  };
  mesh.simplices.visit([&]<class Lists>(const Lists& lists) {
    if constexpr (std::is_same_v<Lists, std::vector<Simplex>>) {
      for (const Simplex& simplex : lists) look_at(simplex);
    } else {
      for (std::size_t i = 0; i < lists.rows(); ++i) look_at(lists.row(i));
    }
  });
  for (const Simplex& face : mesh.faces) look_at(face);
}

std::vector<Simplex> triangles_among(const Mesh& mesh, const std::vector<Vertex>& some) {
  std::vector<Simplex> triangles;
  for_each_among(mesh, some, [&](const Simplex& vertices) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      for (std::size_t j = i + 1; j < vertices.size(); ++j) {
        for (std::size_t k = j + 1; k < vertices.size(); ++k) {
          triangles.push_back(sorted(Simplex{vertices[i], vertices[j], vertices[k]}));
        }
      }
    }
  });
  keep_each_once(triangles);
  return triangles;
}

// Takes away triangles that have an edge alone, as long as there are any, but at edges that may
// end an image. Is none left?
template <class MayEnd>
bool vanish(const std::vector<Simplex>& triangles, const MayEnd& may_end) {
  std::vector<std::array<std::size_t, 3>> edges_of(triangles.size());
  std::vector<std::vector<std::size_t>> at_edge;
  std::vector<bool> is_end;
  for (const auto uses : ByFacet(facet_uses(triangles))) {
    for (const FacetUse& use : uses) edges_of[use.simplex][use.opposite] = at_edge.size();
    is_end.push_back(may_end(uses.front().facet));
    at_edge.emplace_back();
    for (const FacetUse& use : uses) at_edge.back().push_back(use.simplex);
  }
  std::vector<std::size_t> alone;
  const auto look_at = [&](std::size_t edge) {
    if (at_edge[edge].size() == 1 && !is_end[edge]) alone.push_back(edge);
  };
  for (std::size_t edge = 0; edge < at_edge.size(); ++edge) look_at(edge);
  std::size_t left = triangles.size();
  for (std::size_t next = 0; next < alone.size(); ++next) {
    if (at_edge[alone[next]].empty()) continue;
    const std::size_t triangle = at_edge[alone[next]].front();
    --left;
    for (const std::size_t edge : edges_of[triangle]) {
      std::erase(at_edge[edge], triangle);
      look_at(edge);
    }
  }
  return left == 0;
}

}  // namespace

WithoutImage::WithoutImage(const Mesh& mesh, const PiecewiseLinearComplex& complex,
                           const Rational& squared_distance)
    : mesh_(mesh),
      complex_(complex),
      rounding_(complex.points.points()),
      distance_(rounding_.distance(squared_distance)),
      points_(rounded_points(mesh, rounding_)) {}

bool WithoutImage::certainly(LinearCell cell) const {
  switch (cell.dimension) {
    case 0:
      return near({Simplex{static_cast<Vertex>(cell.place)}}).empty();
    case 1:
      return lacks_path(complex_.segments[cell.place]);
    default:
      return lacks_patch(complex_.polygons[cell.place]);
  }
}

std::vector<RoundedPoint> WithoutImage::corners(const Simplex& simplex) const {
  std::vector<RoundedPoint> corners;
  for (const Vertex v : simplex) corners.push_back(rounding_.point(complex_.points[v]));
  return corners;
}

std::vector<Vertex> WithoutImage::near(const std::vector<Simplex>& simplices) const {
  std::vector<Vertex> found;
  for (const Simplex& simplex : simplices) {
    const std::vector<RoundedPoint> own = corners(simplex);
    const Box box = box_about(own, distance_);
    for (std::size_t v = 0; v < points_.size(); ++v) {
      const RoundedPoint& at = points_[v];
      const auto is_beyond = [&](std::size_t axis) {
        return at[axis].high < box.low[axis] || box.high[axis] < at[axis].low;
      };
      if (is_beyond(0) || is_beyond(1) || is_beyond(2)) continue;
      if (certainly_apart(std::span(&at, 1), own, distance_)) continue;
      found.push_back(static_cast<Vertex>(v));
    }
  }
  keep_each_once(found);
  return found;
}

// A path leads from a vertex near one end to a vertex near the other, across edges of the mesh, and
// keeps near the segment.
bool WithoutImage::lacks_path(const Simplex& segment) const {
  const std::vector<Vertex> near_it = near({segment});
  const auto place_of = [&](Vertex v) {
    const auto at = std::lower_bound(near_it.begin(), near_it.end(), v);
    return static_cast<std::size_t>(at - near_it.begin());
  };
  DisjointSets joined(near_it.size());
  for_each_among(mesh_, near_it, [&](const Simplex& vertices) {
    for (const Vertex v : vertices) joined.unite(place_of(vertices.front()), place_of(v));
  });
  std::vector<bool> has_first(near_it.size(), false);
  for (const Vertex v : near({Simplex{segment[0]}})) {
    if (is_among(near_it, v)) has_first[joined.find(place_of(v))] = true;
  }
  const std::vector<Vertex> lasts = near({Simplex{segment[1]}});
  return std::none_of(lasts.begin(), lasts.end(), [&](Vertex v) {
    return is_among(near_it, v) && has_first[joined.find(place_of(v))];
  });
}

// The triangles of an image keep near the polygon. Each edge that is in no path of a segment is an
// edge of two of them at least.
bool WithoutImage::lacks_patch(const Polygon& polygon) const {
  if (polygon.triangles.size() > kMostTriangles) return false;
  const std::vector<Simplex> triangles = triangles_among(mesh_, near(polygon.triangles));
  if (triangles.empty()) return true;
  std::vector<std::vector<Vertex>> near_segments;
  for (const Simplex& segment : polygon.segments) near_segments.push_back(near({segment}));
  return vanish(triangles, [&](const Simplex& edge) {
    return std::any_of(near_segments.begin(), near_segments.end(),
                       [&](const std::vector<Vertex>& some) {
                         return is_among(some, edge[0]) && is_among(some, edge[1]);
                       });
  });
}

}  // namespace circumspect::check
