// Condition 4w of docs/theory/points.md for a mesh spread over several ranks: points of a weighted
// set that are not vertices.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "oracle/distributed/local_mesh.hpp"
#include "oracle/distributed/ranks.hpp"
#include "oracle/judge/fast/predicates/predicates.hpp"
#include "oracle/judge/fast/sample_point.hpp"
#include "oracle/judge/fast/sweep.hpp"

namespace circumspect::distributed {

// Points, and a search for those in a box: the points are halved along one axis after the other.
template <std::size_t kDimension>
class PointTree {
 public:
  using Numbered = NumberedPoint<kDimension>;

  explicit PointTree(std::vector<Numbered> points) : points_(std::move(points)) {
    build(0, points_.size(), 0);
  }

  // Calls visit(point) for each point in the closed box of the row.
  template <class Visit>
  void for_each_in_box(const fast::SiteRow<kDimension>& row, const Visit& visit) const {
    std::array<double, kDimension> low = row[0].at, high = row[0].at;
    for (const auto& site : row) {
      for (std::size_t axis = 0; axis < kDimension; ++axis) {
        low[axis] = std::min(low[axis], site.at[axis]);
        high[axis] = std::max(high[axis], site.at[axis]);
      }
    }
    look(0, points_.size(), 0, low, high, visit);
  }

 private:
  using Corner = std::array<double, kDimension>;

  void build(std::size_t first, std::size_t last, std::size_t axis) {
    if (last - first <= 1) return;
    const std::size_t middle = first + (last - first) / 2;
    const auto at = [this](std::size_t i) {
      return points_.begin() + static_cast<std::ptrdiff_t>(i);
    };
    std::nth_element(at(first), at(middle), at(last), [axis](const Numbered& a, const Numbered& b) {
      return a.site.at[axis] < b.site.at[axis];
    });
    build(first, middle, (axis + 1) % kDimension);
    build(middle + 1, last, (axis + 1) % kDimension);
  }

  template <class Visit>
  void look(std::size_t first, std::size_t last, std::size_t axis, const Corner& low,
            const Corner& high, const Visit& visit) const {
    if (first == last) return;
    const std::size_t middle = first + (last - first) / 2;
    const Numbered& point = points_[middle];
    const double x = point.site.at[axis];
    bool inside = true;
    for (std::size_t i = 0; i < kDimension; ++i) {
      inside &= low[i] <= point.site.at[i] && point.site.at[i] <= high[i];
    }
    if (inside) visit(point);
    if (low[axis] <= x) look(first, middle, (axis + 1) % kDimension, low, high, visit);
    if (x <= high[axis]) look(middle + 1, last, (axis + 1) % kDimension, low, high, visit);
  }

  std::vector<Numbered> points_;
};

// A point that is in no simplex, or below the witness plane of the first simplex that contains it.
template <std::size_t kDimension>
struct FaultyPoint {
  NumberedPoint<kDimension> point = {};
  FacetName simplex = {};  // without a rank: none
};

template <std::size_t kDimension>
struct SubmergedFindings {
  std::vector<FaultyPoint<kDimension>> faulty = {};  // this rank's points
  // As in fast::Swept. A tie says nothing against the canonical triangulation: there a point that
  // is in a simplex and in its witness plane stays submerged (fast::SubmergedPoints).
  bool unique = true;
};

// Looks at the points that no simplex names, in batches: each rank looks for those of all ranks in
// its own simplices. Called by all ranks. Requires: conditions 0–3 hold; these are the orientations
// of the simplices.
template <std::size_t kDimension>
SubmergedFindings<kDimension> look_at_unused_points(Ranks& ranks, const LocalMesh<kDimension>& mesh,
                                                    const fast::Orientations& orientations,
                                                    fast::Stages& stages) {
  constexpr std::size_t kVertices = kDimension + 1;
  // A simplex that contains a point, and what it says about the point.
  struct Containing {
    std::uint64_t index;  // of the point
    std::uint64_t place;  // of the simplex, in the whole mesh
    FacetName simplex;
    std::int32_t side;  // of the witness plane: 1: below
  };
  SubmergedFindings<kDimension> found;
  const std::vector<std::size_t> unused = mesh.unused();
  const std::size_t some = std::max<std::size_t>(1, ranks.some(128) / ranks.size());
  const std::uint64_t rounds = ranks.most((unused.size() + some - 1) / some);
  for (std::size_t round = 0; round < rounds; ++round) {
    const std::size_t first = std::min(unused.size(), round * some);
    const std::size_t last = std::min(unused.size(), first + some);
    std::vector<NumberedPoint<kDimension>> own;
    for (std::size_t i = first; i < last; ++i) own.push_back(mesh.owned_point(unused[i]));
    const PointTree<kDimension> tree(
        ranks.exchanged(std::vector<std::vector<NumberedPoint<kDimension>>>(ranks.size(), own)));
    std::vector<std::vector<Containing>> out(ranks.size());
    for (std::size_t s = 0; s < mesh.size(); ++s) {
      const fast::SiteRow<kDimension> row = mesh.sites(s);
      const int sign = orientations.of(s);
      tree.for_each_in_box(row, [&](const NumberedPoint<kDimension>& point) {
        if (!fast::covers<kDimension>(row, sign, {.low = point.site, .high = point.site}, stages)) {
          return;
        }
        const int side = fast::ball_of<kDimension, true>(row).contains(point.site, stages) * sign;
        const FacetName name{static_cast<std::int32_t>(ranks.rank()),
                             static_cast<std::uint32_t>(s * kVertices)};
        out[mesh.owner_of(point.index)].push_back({point.index, mesh.place(s), name, side});
      });
    }
    std::vector<Containing> containing = ranks.exchanged(std::move(out));
    std::sort(containing.begin(), containing.end(), [](const Containing& a, const Containing& b) {
      return std::pair(a.index, a.place) < std::pair(b.index, b.place);
    });
    auto next = containing.begin();
    for (const NumberedPoint<kDimension>& point : own) {
      while (next != containing.end() && next->index < point.index) ++next;
      if (next == containing.end() || next->index != point.index) {
        found.faulty.push_back({point, {}});
      } else if (next->side > 0) {
        found.faulty.push_back({point, next->simplex});
      } else if (next->side == 0) {
        found.unique = false;
      }
    }
  }
  return found;
}

}  // namespace circumspect::distributed
