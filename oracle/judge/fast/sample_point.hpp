// The sample point of condition 3: doubles, or else the barycentre of a simplex, exactly.
#pragma once

#include <cstddef>
#include <optional>

#include <tl/expected.hpp>

#include "oracle/judge/conditions/conditions.hpp"
#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/judge/fast/predicates/predicates.hpp"
#include "oracle/judge/fast/undecided.hpp"

namespace circumspect::fast {

template <std::size_t kDimension>
struct SamplePoint {
  std::size_t simplex = 0;  // in whose interior it is
  // Doubles below and above each coordinate; if there are no corners, both are the coordinate
  // itself.
  Site<kDimension> low = {}, high = {};
  std::optional<SiteRow<kDimension>> corners = {};  // whose barycentre it is
};

// The orientation of a row with the barycentre of another row in place of one of its sites, by
// integers of any size.
template <std::size_t kDimension>
int orientation_with_barycentre(const SiteRow<kDimension>& row, std::size_t place,
                                const SiteRow<kDimension>& corners, Stages& stages);

extern template int orientation_with_barycentre<2>(const SiteRow<2>&, std::size_t,
                                                   const SiteRow<2>&, Stages&);
extern template int orientation_with_barycentre<3>(const SiteRow<3>&, std::size_t,
                                                   const SiteRow<3>&, Stages&);

// The orientation of the row with the sample point in place of one of its own sites.
template <std::size_t kDimension>
int orientation_with(const SiteRow<kDimension>& row, std::size_t place,
                     const SamplePoint<kDimension>& point, Stages& stages) {
  return point.corners ? orientation_with_barycentre<kDimension>(row, place, *point.corners, stages)
                       : orientation_with<kDimension>(row, place, point.low, stages);
}

// Is the point in the closed simplex, whose orientation is `own`? For most simplices the box
// excludes it.
template <std::size_t kDimension>
bool covers(const SiteRow<kDimension>& row, int own, const SamplePoint<kDimension>& point,
            Stages& stages) {
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    bool any_below = false, any_above = false;
    for (const Site<kDimension>& site : row) {
      any_below |= site.at[axis] <= point.high.at[axis];
      any_above |= site.at[axis] >= point.low.at[axis];
    }
    if (!any_below || !any_above) return false;
  }
  return conditions::covers(kDimension + 1, [&](std::size_t place) {
    return orientation_with(row, place, point, stages) * own;
  });
}

// The exact barycentre of this row, which is that of the simplex. Requires: not flat.
template <std::size_t kDimension>
SamplePoint<kDimension> barycentre_of(const SiteRow<kDimension>& row, std::size_t simplex);

extern template SamplePoint<2> barycentre_of(const SiteRow<2>&, std::size_t);
extern template SamplePoint<3> barycentre_of(const SiteRow<3>&, std::size_t);

// docs/theory/points.md allows any point that is strictly inside some simplex. Tries some simplices
// from all over the list, and takes the rounded barycentre of one that contains it in its interior;
// if all of them are too thin for that, the exact barycentre of one. Undecided: a simplex that has
// an index that names no point, or is flat. Requires: at least one simplex.
template <std::size_t kDimension, typename Index>
tl::expected<SamplePoint<kDimension>, Undecided> sample_point(
    const MeshView<kDimension, Index>& mesh, Stages& stages) {
  constexpr std::size_t kTries = 64;
  const std::size_t step = mesh.size() / kTries + 1;
  SiteRow<kDimension> row;
  for (std::size_t s = 0; s < mesh.size(); s += step) {
    Site<kDimension> centre{};
    for (std::size_t i = 0; i <= kDimension; ++i) {
      const Index v = mesh.row(s)[i];
      if (!mesh.names_point(v)) return tl::unexpected(Undecided::kUnknownVertex);
      row[i] = mesh.template site<false>(v);
      for (std::size_t axis = 0; axis < kDimension; ++axis) {
        centre.at[axis] += row[i].at[axis] / (kDimension + 1);
      }
    }
    const int own = orientation<kDimension>(row, stages);
    if (own == 0) return tl::unexpected(Undecided::kFlatSimplex);
    bool inside = true;
    for (std::size_t place = 0; place <= kDimension && inside; ++place) {
      inside = orientation_with<kDimension>(row, place, centre, stages) * own > 0;
    }
    if (inside) return SamplePoint<kDimension>{s, centre, centre};
  }
  return barycentre_of<kDimension>(row, (mesh.size() - 1) / step * step);
}

}  // namespace circumspect::fast
