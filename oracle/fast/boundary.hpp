// Condition 2 and what condition 3 says of boundary facets (oracle/check/README.md), for links of which
// oracle/fast/README.md says what must be verified before.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "oracle/fast/mesh_view.hpp"
#include "oracle/fast/orientations.hpp"
#include "oracle/fast/row_predicates.hpp"
#include "oracle/fast/undecided.hpp"

namespace circumspect::fast {

template <std::size_t kDimension, typename Index, typename Link>
class Boundary {
 public:
  Boundary(const MeshView<kDimension, Index>& mesh, Links<Link> links,
           const Orientations& orientations, const Site<kDimension>& sample)
      : mesh_(mesh), links_(links), orientations_(orientations), sample_(sample) {}

  // The facet opposite vertex `apex` of simplex s: is the sample point strictly on its inner side, and
  // does the boundary make no reflex angle at its ridges? Of the two facets at a ridge one asks.
  std::optional<Undecided> judge(std::size_t s, std::size_t apex, Stages& stages) const {
    SiteRow<kDimension> row;
    for (std::size_t i = 0; i < kVertices; ++i) {
      row[i] = mesh_.template site<false>(mesh_.row(s)[i]);
    }
    const int own = orientations_.of(s);
    if (orientation_with<kDimension>(row, apex, sample_, stages) * own <= 0) {
      return Undecided::kBeyondHullFacet;
    }
    for (std::size_t off = 0; off < kVertices; ++off) {
      if (off == apex || !asks(s, apex, off)) continue;
      const Index far = far_vertex(s, apex, off);
      if (far == mesh_.row(s)[apex]) continue;  // both facets are of this simplex
      const Site<kDimension> site = mesh_.template site<false>(far);
      if (orientation_with<kDimension>(row, apex, site, stages) * own < 0) {
        return Undecided::kHullNotConvex;
      }
    }
    return std::nullopt;
  }

 private:
  static constexpr std::size_t kVertices = kDimension + 1;

  // Facets of the boundary are oriented alike, so that one runs through a ridge forwards and the other
  // backwards. Forwards: from the lesser vertex to the greater; in the plane, towards the vertex.
  bool asks(std::size_t s, std::size_t apex, std::size_t off) const {
    std::array<std::size_t, kVertices> places{apex, off};
    std::size_t next = 2;
    for (std::size_t i = 0; i < kVertices; ++i) {
      if (i != apex && i != off) places[next++] = i;
    }
    bool forwards = orientations_.of(s) > 0;
    for (std::size_t i = 0; i < kVertices; ++i) {
      for (std::size_t k = i + 1; k < kVertices; ++k) forwards ^= places[i] > places[k];
    }
    if constexpr (kDimension == 3) {
      forwards ^= mesh_.row(s)[places[2]] > mesh_.row(s)[places[3]];
    }
    return forwards;
  }

  std::size_t place_of(Index v, std::size_t s) const {
    const auto row = mesh_.row(s);
    return static_cast<std::size_t>(std::find(row.begin(), row.end(), v) - row.begin());
  }

  // The ridge is the simplex without its vertices `apex` and `off`. Turns around it through the mesh,
  // away from the facet opposite the apex, to the other boundary facet there; the vertex of that off
  // the ridge. Ends, because links lead back: no simplex is entered twice through the same facet, and
  // the first was not entered.
  Index far_vertex(std::size_t s, std::size_t apex, std::size_t off) const {
    while (true) {
      const Link beyond = links_[s * kVertices + off];
      if (beyond < 0) return mesh_.row(s)[apex];
      const auto t = static_cast<std::size_t>(beyond);
      const Index behind = mesh_.row(s)[apex];
      std::size_t entered = 0;  // the place of t's own vertex, opposite the facet of entry
      while (place_of(mesh_.row(t)[entered], s) < kVertices) ++entered;
      s = t;
      apex = entered;
      off = place_of(behind, t);
    }
  }

  const MeshView<kDimension, Index>& mesh_;
  Links<Link> links_;
  const Orientations& orientations_;
  const Site<kDimension>& sample_;
};

}  // namespace circumspect::fast
