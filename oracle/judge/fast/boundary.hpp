// Condition 2, and the part of condition 3 about boundary facets (docs/theory/points.md).
// docs/theory/fast.md says what must be verified first.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "oracle/judge/conditions/conditions.hpp"
#include "oracle/judge/fast/facet_records.hpp"
#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/judge/fast/predicates/predicates.hpp"
#include "oracle/judge/fast/sample_point.hpp"
#include "oracle/judge/fast/sweep.hpp"
#include "oracle/judge/fast/undecided.hpp"

namespace circumspect::fast {

// Do two boundary facets at a ridge make a reflex angle, or are they folded? Each is given as a row
// of its simplex: the vertices of the ridge, in the same order for both, then the facet's vertex
// off the ridge, then the simplex's vertex off the facet. Requires: no row is flat.
template <std::size_t kDimension>
conditions::AtRidge at_hinge(const SiteRow<kDimension>& a, const SiteRow<kDimension>& b,
                             Stages& stages) {
  constexpr std::size_t kFar = kDimension - 1, kApex = kDimension;
  // On which side of the facet of a row is the far vertex of the other row? 1: on the side of its
  // simplex.
  const auto side = [&stages](const SiteRow<kDimension>& row, const SiteRow<kDimension>& other) {
    return orientation_with<kDimension>(row, kApex, other[kFar], stages) *
           orientation<kDimension>(row, stages);
  };
  // In one hyperplane, the hyperplane through the ridge and the simplex's vertex must separate the
  // far vertices.
  const auto are_folded = [&] {
    return orientation<kDimension>(a, stages) ==
           orientation_with<kDimension>(a, kFar, b[kFar], stages);
  };
  return conditions::at_ridge(
      2, [&] { return side(a, b); }, [&] { return side(b, a); }, are_folded);
}

template <std::size_t kDimension, typename Index, typename Link>
class Boundary {
 public:
  // `lattice`: one that contains all vertices, if such a lattice is known.
  Boundary(const MeshView<kDimension, Index>& mesh, Links<Link> links,
           const Orientations& orientations, const SamplePoint<kDimension>& sample,
           Lattice lattice = {})
      : mesh_(mesh),
        links_(links),
        orientations_(orientations),
        sample_(sample),
        lattice_(lattice) {}

  // Facets without a link, each as simplex · (d + 1) + place of the vertex opposite: is the sample
  // point strictly on their inner sides, and does the boundary have no reflex angle at their
  // ridges? Only one of the two facets at a ridge asks.
  std::optional<Undecided> judge(std::span<const FacetId> facets, Stages& stages) const {
    constexpr std::size_t kFacets = 64;
    std::optional<Undecided> found;
    for (std::size_t first = 0; first < facets.size() && !found; first += kFacets) {
      found = judge_some(facets.subspan(first, std::min(kFacets, facets.size() - first)), stages);
    }
    return found;
  }

 private:
  static constexpr std::size_t kVertices = kDimension + 1;

  // A turn around a ridge of a boundary facet through the mesh, from link to link, away from that
  // facet.
  struct Turn {
    FacetId facet;        // where it began
    std::size_t simplex;  // its current place
    Index leaves;         // the vertex opposite the facet through which it continues
    Index ridge;          // the vertices of the ridge, xor
    Index far = 0;        // at its end: the vertex off the ridge of the other boundary facet
  };

  std::optional<Undecided> judge_some(std::span<const FacetId> facets, Stages& stages) const {
    std::vector<Turn> turns;
    turns.reserve(facets.size() * kDimension);
    for (const FacetId facet : facets) {
      const std::size_t s = facet.simplex(), apex = facet.place();
      const int side = orientation_with(mesh_.template sites<false>(s), apex, sample_, stages) *
                       orientations_.of(s);
      if (!conditions::is_strictly_inside(side)) return Undecided::kBeyondHullFacet;
      list_turns(facet, turns);
    }
    finish(turns);
    for (const Turn& turn : turns) {
      const std::size_t s = turn.facet.simplex(), apex = turn.facet.place();
      if (turn.far == mesh_.row(s)[apex]) continue;  // both facets are of this simplex
      const Site<kDimension> far = mesh_.template site<false>(turn.far);
      if (orientation_with<kDimension>(mesh_.template sites<false>(s), apex, far, stages,
                                       lattice_) *
              orientations_.of(s) <
          0) {
        return Undecided::kHullNotConvex;
      }
    }
    return std::nullopt;
  }

  // Facets of the boundary are oriented alike, so that one runs through a ridge forwards and the
  // other backwards. Forwards: from the lesser vertex to the greater; in the plane, towards the
  // vertex.
  void list_turns(FacetId facet, std::vector<Turn>& turns) const {
    const std::size_t s = facet.simplex();
    const auto row = mesh_.row(s);
    const bool positive = orientations_.of(s) > 0;
    // The apex, `off` and the ridge's vertices are an even permutation of the row; in the plane,
    // this alternates.
    const auto& places = kFacetPlaces<kVertices>[facet.place()];
    for (std::size_t k = 0; k < kDimension; ++k) {
      const Index off = row[places[k]];
      if constexpr (kDimension == 2) {
        if (positive == (k == 0)) turns.push_back({facet, s, off, row[places[1 - k]]});
      } else {
        const Index from = row[places[(k + 1) % 3]], to = row[places[(k + 2) % 3]];
        if (positive != (from > to)) {
          turns.push_back({facet, s, off, static_cast<Index>(from ^ to)});
        }
      }
    }
  }

  // Advances all of them in turn, so that what one prefetches arrives while the others proceed.
  // They end, because links lead back: no simplex is entered twice through the same facet, and the
  // first was not entered.
  void finish(std::vector<Turn>& turns) const {
    std::array<std::uint16_t, 64 * kDimension> going;
    std::size_t count = turns.size();
    for (std::size_t i = 0; i < count; ++i) going[i] = static_cast<std::uint16_t>(i);
    while (count > 0) {
      std::size_t kept = 0;
      for (std::size_t i = 0; i < count; ++i) {
        going[kept] = going[i];
        kept += static_cast<std::size_t>(goes_on(turns[going[i]]));
      }
      count = kept;
    }
  }

  // One step: the simplex has the vertices of the ridge, the one opposite the next facet, and
  // another, which is opposite the facet after that.
  bool goes_on(Turn& turn) const {
    const auto row = mesh_.row(turn.simplex);
    Index other = turn.ridge ^ turn.leaves;
    std::size_t place = 0;
    for (std::size_t i = 0; i < kVertices; ++i) {
      other ^= row[i];
      place = row[i] == turn.leaves ? i : place;
    }
    const Link beyond = links_[turn.simplex * kVertices + place];
    turn.far = other;
    if (beyond < 0) {
      __builtin_prefetch(&mesh_.coordinates[static_cast<std::size_t>(other) * kDimension]);
      return false;
    }
    turn.leaves = other;
    turn.simplex = static_cast<std::size_t>(beyond);
    __builtin_prefetch(&mesh_.simplices[turn.simplex * kVertices]);
    __builtin_prefetch(&links_[turn.simplex * kVertices]);
    return true;
  }

  const MeshView<kDimension, Index>& mesh_;
  Links<Link> links_;
  const Orientations& orientations_;
  const SamplePoint<kDimension>& sample_;
  Lattice lattice_;
};

}  // namespace circumspect::fast
