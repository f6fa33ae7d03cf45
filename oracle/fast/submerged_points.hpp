// Condition 4w of oracle/check/README.md: points of a weighted set that are not vertices.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "oracle/fast/mesh_view.hpp"
#include "oracle/fast/orientations.hpp"
#include "oracle/fast/row_predicates.hpp"
#include "oracle/fast/sweep.hpp"
#include "oracle/fast/undecided.hpp"

namespace circumspect::fast {

template <std::size_t kDimension, typename Index, typename Link>
class SubmergedPoints {
 public:
  // Requires: weights; conditions 0–3 hold, and all facets are locally Delaunay.
  SubmergedPoints(const MeshView<kDimension, Index>& mesh, Links<Link> links,
                  const Orientations& orientations)
      : mesh_(mesh), links_(links), orientations_(orientations) {}

  // Each of the points must lie in a simplex, on or above its witness plane, and equal no other point.
  // Adds to `swept` what that says about other triangulations.
  std::optional<Undecided> judge(const std::vector<std::size_t>& unused, Swept& swept) const {
    if (any_equal(unused)) return Undecided::kEqualPoints;
    std::size_t place = 0;
    for (const std::size_t q : unused) {
      const Site<kDimension> site = mesh_.template site<true>(static_cast<Index>(q));
      const std::optional<std::size_t> found = locate(place, site, swept.stages);
      if (!found) return Undecided::kUnusedPoint;
      place = *found;
      const SiteRow<kDimension> row = row_of(place);
      for (const Site<kDimension>& vertex : row) {
        if (vertex.at == site.at) return Undecided::kEqualPoints;
      }
      const int own = orientations_.of(place);
      const int side = ball_of<kDimension, true>(row).contains(site, swept.stages) * own;
      if (side > 0) return Undecided::kPointBelowPlane;
      if (side < 0) continue;
      swept.unique = false;
      if (swept.canonical) {
        swept.canonical = perturbed_sign_of_zero<kDimension>(row, own, site, swept.stages) < 0;
      }
    }
    return std::nullopt;
  }

 private:
  static constexpr std::size_t kVertices = kDimension + 1;

  SiteRow<kDimension> row_of(std::size_t s) const {
    SiteRow<kDimension> row;
    for (std::size_t i = 0; i < kVertices; ++i) {
      row[i] = mesh_.template site<true>(mesh_.row(s)[i]);
    }
    return row;
  }

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

  // The simplex that contains the point, by a walk (Book: Section 5.5), which comes to no simplex twice
  // in a weighted Delaunay triangulation; none beyond the hull.
  std::optional<std::size_t> locate(std::size_t start, const Site<kDimension>& site,
                                    Stages& stages) const {
    std::size_t s = start;
    for (std::size_t steps = 0; steps <= mesh_.size(); ++steps) {
      const SiteRow<kDimension> row = row_of(s);
      std::size_t place = 0;
      while (place < kVertices &&
             orientation_with<kDimension>(row, place, site, stages) * orientations_.of(s) >= 0) {
        ++place;
      }
      if (place == kVertices) return s;
      const Link beyond = links_[s * kVertices + place];
      if (beyond < 0) return std::nullopt;
      s = static_cast<std::size_t>(beyond);
    }
    return std::nullopt;
  }

  const MeshView<kDimension, Index>& mesh_;
  Links<Link> links_;
  const Orientations& orientations_;
};

}  // namespace circumspect::fast
