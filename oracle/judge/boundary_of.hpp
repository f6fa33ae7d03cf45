// The boundary of a mesh of doubles: what docs/theory/complex.md asks of it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "kernel/boxes/interval.hpp"
#include "kernel/exact/each_once.hpp"
#include "kernel/exact/triple.hpp"
#include "oracle/judge/complex/adjacency.hpp"
#include "oracle/judge/complex/by_boundary.hpp"
#include "oracle/judge/fast/box_tree.hpp"
#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/judge/fast/triangle_complex.hpp"

namespace circumspect::check {

// Its vertices have numbers of their own. Facets are named by their places in the list.
template <std::size_t kDimension, typename Index>
class BoundaryOf {
 public:
  using View = fast::MeshView<kDimension, Index>;
  using Places = std::vector<std::size_t>;

  // Requires: each of these facets is in no other simplex; both arguments outlive it.
  BoundaryOf(const View& mesh, const std::vector<fast::FacetId>& facets)
      : mesh_(mesh), ids_(facets) {
    std::vector<Index> corners;
    corners.reserve(facets.size() * kDimension);
    for (const fast::FacetId id : facets) {
      const auto facet = fast::facet_of<kDimension + 1, Index>(mesh.row(id.simplex()), id.place());
      corners.insert(corners.end(), facet.begin(), facet.end());
    }
    vertices_ = corners;
    keep_each_once(vertices_);
    facets_.reserve(facets.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (i % kDimension == 0) facets_.emplace_back().reserve(kDimension);
      const auto place = std::lower_bound(vertices_.begin(), vertices_.end(), corners[i]);
      facets_.back().push_back(place - vertices_.begin());
    }
    coordinates_.reserve(vertices_.size() * kDimension);
    for (const Index v : vertices_) {
      const auto at = coordinates(v);
      coordinates_.insert(coordinates_.end(), at.begin(), at.end());
    }
  }

  // Inside of a complex no two vertices are equal.
  bool has_equal_points() const {
    std::vector<std::array<double, kDimension>> all;
    all.reserve(vertices_.size());
    for (const Index v : vertices_) {
      auto& point = all.emplace_back();
      const auto at = coordinates(v);
      std::copy(at.begin(), at.end(), point.begin());
    }
    std::sort(all.begin(), all.end());  // −0 and 0 are equal
    return std::adjacent_find(all.begin(), all.end()) != all.end();
  }

  // Those that do not meet another as they should, ascending. Requires: no equal points.
  Places improper() const {
    if constexpr (kDimension == 3) {
      std::vector<std::array<std::int32_t, 3>> triangles;
      triangles.reserve(facets_.size());
      for (const Simplex& facet : facets_) {
        auto& triangle = triangles.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) triangle[i] = static_cast<std::int32_t>(facet[i]);
      }
      if (auto found = fast::improper_triangles(coordinates_, triangles)) return *std::move(found);
    }
    Places found = repeated();
    if (!found.empty()) return found;
    std::vector<Point> points;
    for (const Index v : vertices_) points.push_back(exact(v));
    return improper_facets(Configuration(points), points, facets_);
  }

  // How many classes of facets there are that a ridge of two joins, and one facet of each for which
  // it must be asked what is just outside. Nothing is beyond the last of all vertices, in the order
  // of the coordinates: so if all facets at it are of one class, nothing is just outside of that.
  struct Classes {
    std::size_t count = 0;
    Places unsettled = {};
  };
  Classes classes() const {
    const Places class_of = class_of_each(facets_);
    std::size_t last = 0;
    for (std::size_t v = 1; v < vertices_.size(); ++v) {
      const auto a = coordinates(vertices_[last]), b = coordinates(vertices_[v]);
      if (std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end())) last = v;
    }
    std::set<std::size_t> at_last;
    for (std::size_t i = 0; i < facets_.size(); ++i) {
      if (contains(facets_[i], static_cast<Vertex>(last))) at_last.insert(class_of[i]);
    }
    Classes found;
    for (std::size_t i = 0; i < facets_.size(); ++i) {
      if (class_of[i] != i) continue;
      ++found.count;
      if (at_last.size() != 1 || !at_last.contains(i)) found.unsettled.push_back(i);
    }
    return found;
  }

  // The simplices just outside of one of these facets, each with the simplex of that facet: they
  // have its barycentre.
  Places just_outside(const Places& facets) const {
    if (facets.empty()) return {};
    std::vector<Enclosed> middles;
    std::vector<fast::AxisBox> boxes;
    for (const std::size_t facet : facets) {
      middles.push_back(middle_of(corners(facet)));
      boxes.push_back(box_of(middles.back()));
    }
    const fast::BoxTree tree(boxes);
    Places found;
    for (std::size_t s = 0; s < mesh_.size(); ++s) {
      const fast::AxisBox own = box_of(mesh_.row(s));
      if (facets.size() == 1 && !own.meets(boxes[0])) continue;
      std::size_t steps = ~std::size_t{0};
      tree.all_near(
          steps, [&](const fast::AxisBox& box) { return !box.meets(own); },
          [&](std::uint32_t one) {
            const fast::FacetId id = ids_[facets[one]];
            if (s == id.simplex() || is_certainly_outside(mesh_.row(s), middles[one])) return true;
            const Point apex = exact(mesh_.row(id.simplex())[id.place()]);
            if (has_just_outside(exact(mesh_.row(s)), exact(corners(facets[one])), apex)) {
              found.insert(found.end(), {s, id.simplex()});
            }
            return true;
          });
    }
    return found;
  }

  // If the simplices form a complex, are they a manifold with boundary? Then all that can be wrong
  // is where boundary facets meet: a vertex whose link has one circle for a boundary, or none, has
  // one of the two parts of a sphere for a link, or all of it.
  bool is_manifold() const {
    const std::vector<FacetUse> uses = facet_uses(facets_);
    if (!open_facets(uses).empty()) return false;
    const definition::NotManifold found = not_manifold(facets_, uses);
    return found.facets.empty() && found.ridges.empty() && found.vertices.empty();
  }

 private:
  // Those with the vertices of another, ascending.
  Places repeated() const {
    std::map<Simplex, std::size_t> first;
    Places found;
    for (std::size_t i = 0; i < facets_.size(); ++i) {
      const auto [at, is_new] = first.emplace(facets_[i], i);
      if (!is_new) found.insert(found.end(), {at->second, i});
    }
    keep_each_once(found);
    return found;
  }

  std::vector<Index> corners(std::size_t facet) const {
    std::vector<Index> corners;
    for (const Vertex v : facets_[facet]) corners.push_back(vertices_[static_cast<std::size_t>(v)]);
    return corners;
  }
  std::span<const double> coordinates(Index v) const {
    return mesh_.coordinates.subspan(static_cast<std::size_t>(v) * kDimension, kDimension);
  }
  Point exact(Index v) const {
    Point point;
    for (const double x : coordinates(v)) point.push_back(exact_value(x));
    return point;
  }
  std::vector<Point> exact(std::span<const Index> vertices) const {
    std::vector<Point> points;
    for (const Index v : vertices) points.push_back(exact(v));
    return points;
  }
  fast::AxisBox box_of(std::span<const Index> vertices) const {
    return fast::box_of_points<kDimension>(mesh_.coordinates, vertices);
  }

  // In the plane, the third coordinate is 0.
  using Enclosed = Triple<Interval>;
  Enclosed enclosed(Index v) const {
    Enclosed point = {};
    const auto at = coordinates(v);
    std::transform(at.begin(), at.end(), point.begin(), exactly);
    return point;
  }
  Enclosed middle_of(std::span<const Index> facet) const {
    Enclosed middle = enclosed(facet[0]);
    for (std::size_t i = 1; i < facet.size(); ++i) {
      const Enclosed point = enclosed(facet[i]);
      for (std::size_t axis = 0; axis < kDimension; ++axis) {
        middle[axis] = middle[axis] + point[axis];
      }
    }
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      middle[axis] = middle[axis] / exactly(static_cast<double>(kDimension));
    }
    return middle;
  }
  static fast::AxisBox box_of(const Enclosed& point) {
    fast::AxisBox box{};
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      box.low[axis] = point[axis].low;
      box.high[axis] = point[axis].high;
    }
    return box;
  }

  // Is the point beyond a facet of the simplex, as far as doubles tell? In the plane the boxes are
  // all that is asked.
  bool is_certainly_outside(std::span<const Index> row, const Enclosed& point) const {
    if constexpr (kDimension == 3) {
      for (std::size_t place = 0; place < row.size(); ++place) {
        std::array<Enclosed, 3> facet = {};
        for (std::size_t i = 0; i < 3; ++i) facet[i] = enclosed(row[i < place ? i : i + 1]);
        const Enclosed normal = cross_product(difference(facet[1], facet[0]),  //
                                              difference(facet[2], facet[0]));
        const auto side = [&](const Enclosed& of) {
          return certain_sign(inner_product(normal, difference(of, facet[0])));
        };
        if (side(enclosed(row[place])) * side(point) < 0) return true;
      }
    }
    return false;
  }

  const View& mesh_;
  const std::vector<fast::FacetId>& ids_;
  std::vector<Index> vertices_;  // ascending
  std::vector<Simplex> facets_;  // by places among these
  std::vector<double> coordinates_;
};

}  // namespace circumspect::check
