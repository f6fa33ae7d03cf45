// Condition 4w of docs/theory/points.md: points of a weighted set that are not vertices.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "kernel/boxes/point_search.hpp"
#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/judge/fast/predicates/predicates.hpp"
#include "oracle/judge/fast/sweep.hpp"
#include "oracle/judge/fast/undecided.hpp"

namespace circumspect::fast {

template <std::size_t kDimension, typename Index, typename Link>
class SubmergedPoints {
 public:
  // Requires: weights; conditions 0–3 hold, and all facets are locally Delaunay.
  SubmergedPoints(const MeshView<kDimension, Index>& mesh, Links<Link> links,
                  const Orientations& orientations)
      : mesh_(mesh), links_(links), orientations_(orientations) {}

  // Each of the points must lie in a simplex, on or above its witness plane, and must not equal
  // another point. Adds to `swept` what this implies about other triangulations.
  std::optional<Undecided> judge(const std::vector<std::size_t>& unused, Swept& swept) const {
    if (any_equal(unused)) return Undecided::kEqualPoints;
    const Located located{*this, swept.stages};
    PointSearch search(located);
    const std::vector<std::size_t> simplices = search.simplices_with(unused);
    for (std::size_t i = 0; i < unused.size(); ++i) {
      const std::size_t place = simplices[i];
      if (place == kNoSimplex) return Undecided::kUnusedPoint;
      const Site<kDimension> site = mesh_.template site<true>(static_cast<Index>(unused[i]));
      const SiteRow<kDimension> row = mesh_.template sites<true>(place);
      for (const Site<kDimension>& vertex : row) {
        if (vertex.at == site.at) return Undecided::kEqualPoints;
      }
      const int own = orientations_.of(place);
      const int side = ball_of<kDimension, true>(row).contains(site, swept.stages) * own;
      if (side > 0) return Undecided::kPointBelowPlane;
      // A tie: another triangulation has the point for a vertex. The canonical one does not, since
      // of the vertices whose hull has the point in its interior the least comes before it.
      if (side == 0) swept.unique = false;
    }
    return std::nullopt;
  }

 private:
  static constexpr std::size_t kVertices = kDimension + 1;

  bool any_equal(const std::vector<std::size_t>& unused) const {
    const auto at = [&](std::size_t v) {
      return mesh_.template site<false>(static_cast<Index>(v)).at;
    };
    std::vector<std::size_t> order = unused;
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return at(a) < at(b); });
    return std::adjacent_find(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
             return at(a) == at(b);
           }) != order.end();
  }

  // Presents the mesh in the form that the point search needs.
  struct Located {
    const SubmergedPoints& mesh;
    Stages& stages;

    std::size_t size() const { return mesh.mesh_.size(); }
    std::size_t row_size() const { return kVertices; }
    std::size_t points() const { return mesh.mesh_.points(); }
    std::size_t vertex(std::size_t s, std::size_t place) const {
      return static_cast<std::size_t>(mesh.mesh_.row(s)[place]);
    }
    int side(std::size_t s, std::size_t place, std::size_t point) const {
      const Site<kDimension> site = mesh.mesh_.template site<true>(static_cast<Index>(point));
      return orientation_with<kDimension>(mesh.mesh_.template sites<true>(s), place, site, stages) *
             mesh.orientations_.of(s);
    }
    std::size_t across(std::size_t s, std::size_t place) const {
      const Link beyond = mesh.links_[s * kVertices + place];
      return beyond < 0 ? kNoSimplex : static_cast<std::size_t>(beyond);
    }
  };

  const MeshView<kDimension, Index>& mesh_;
  Links<Link> links_;
  const Orientations& orientations_;
};

}  // namespace circumspect::fast
