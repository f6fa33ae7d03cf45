// The sample point of condition 3, with doubles for coordinates.
#pragma once

#include <cstddef>
#include <optional>

#include "oracle/fast/mesh_view.hpp"
#include "oracle/fast/row_predicates.hpp"

namespace circumspect::fast {

template <std::size_t kDimension>
struct SamplePoint {
  Site<kDimension> site;
  std::size_t simplex = 0;  // in whose interior it is
};

// Is the point in the closed simplex, whose orientation is `own`? Most boxes say no.
template <std::size_t kDimension>
bool covers(const SiteRow<kDimension>& row, int own, const Site<kDimension>& point,
            Stages& stages) {
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    bool any_below = false, any_above = false;
    for (const Site<kDimension>& site : row) {
      any_below |= site.at[axis] <= point.at[axis];
      any_above |= site.at[axis] >= point.at[axis];
    }
    if (!any_below || !any_above) return false;
  }
  for (std::size_t place = 0; place <= kDimension; ++place) {
    if (orientation_with<kDimension>(row, place, point, stages) * own < 0) return false;
  }
  return true;
}

// The rounded barycentre of a simplex in whose interior it is: any point that is strictly inside some
// simplex serves oracle/check/README.md. Tries some simplices from all over the list; none if all of
// them are too thin to have a double inside, or flat, or name no points.
template <std::size_t kDimension, typename Index>
std::optional<SamplePoint<kDimension>> sample_point(const MeshView<kDimension, Index>& mesh,
                                                    Stages& stages) {
  constexpr std::size_t kTries = 64;
  const std::size_t step = mesh.size() / kTries + 1;
  for (std::size_t s = 0; s < mesh.size(); s += step) {
    SiteRow<kDimension> row;
    Site<kDimension> centre{};
    bool names_points = true;
    for (std::size_t i = 0; i <= kDimension && names_points; ++i) {
      names_points = mesh.names_point(mesh.row(s)[i]);
      if (!names_points) break;
      row[i] = mesh.template site<false>(mesh.row(s)[i]);
      for (std::size_t axis = 0; axis < kDimension; ++axis) {
        centre.at[axis] += row[i].at[axis] / (kDimension + 1);
      }
    }
    if (!names_points) continue;
    const int own = orientation<kDimension>(row, stages);
    bool inside = own != 0;
    for (std::size_t place = 0; place <= kDimension && inside; ++place) {
      inside = orientation_with<kDimension>(row, place, centre, stages) * own > 0;
    }
    if (inside) return SamplePoint<kDimension>{centre, s};
  }
  return std::nullopt;
}

}  // namespace circumspect::fast
