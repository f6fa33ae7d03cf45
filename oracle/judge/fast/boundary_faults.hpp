// The places where the boundary facets of a mesh do not bound a convex set that is covered once.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include "oracle/judge/conditions/conditions.hpp"
#include "oracle/judge/fast/boundary.hpp"
#include "oracle/judge/fast/faults.hpp"
#include "oracle/judge/fast/list_in_chunks.hpp"
#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/judge/fast/predicates/predicates.hpp"
#include "oracle/judge/fast/sample_point.hpp"

namespace circumspect::fast {

template <std::size_t kDimension, typename Index>
class BoundaryFaults {
 public:
  // Adds to these faults. Requires: the simplices are sound, these are their orientations, and
  // their facets match.
  BoundaryFaults(const MeshView<kDimension, Index>& mesh,
                 const std::vector<std::int8_t>& orientations, unsigned threads, Faults& faults)
      : mesh_(mesh), orientations_(orientations), threads_(threads), faults_(faults) {}

  void judge(const std::vector<FacetId>& boundary) {
    judge_ridges(ridge_uses(boundary));
    if (faults_.ridges.empty()) judge_sample_point(boundary);
  }

 private:
  static constexpr std::size_t kVertices = kDimension + 1;

  struct RidgeUse {
    std::array<Index, kDimension - 1> ridge;  // ascending
    FacetId facet;
    Index far;  // the vertex of the facet off the ridge
  };

  std::vector<RidgeUse> ridge_uses(const std::vector<FacetId>& boundary) const {
    std::vector<RidgeUse> uses;
    uses.reserve(boundary.size() * kDimension);
    for (const FacetId facet : boundary) {
      const auto row = mesh_.row(facet.simplex());
      for (std::size_t off = 0; off < kVertices; ++off) {
        if (off == facet.place()) continue;
        RidgeUse use{{}, facet, row[off]};
        std::size_t size = 0;
        for (std::size_t i = 0; i < kVertices; ++i) {
          if (i != off && i != facet.place()) use.ridge[size++] = row[i];
        }
        std::sort(use.ridge.begin(), use.ridge.end());
        uses.push_back(use);
      }
    }
    std::sort(uses.begin(), uses.end(), [](const RidgeUse& a, const RidgeUse& b) {
      return std::tie(a.ridge, a.facet) < std::tie(b.ridge, b.facet);
    });
    return uses;
  }

  // As at_hinge() requires: ridge, facet's vertex off it, simplex's vertex off the
  // facet.
  SiteRow<kDimension> hinge_of(const RidgeUse& use) const {
    SiteRow<kDimension> row;
    for (std::size_t i = 0; i + 1 < kDimension; ++i) {
      row[i] = mesh_.template site<false>(use.ridge[i]);
    }
    row[kDimension - 1] = mesh_.template site<false>(use.far);
    row[kDimension] = mesh_.template site<false>(mesh_.row(use.facet.simplex())[use.facet.place()]);
    return row;
  }

  void judge_ridges(const std::vector<RidgeUse>& uses) {
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i < uses.size(); ++i) {
      if (i == 0 || uses[i].ridge != uses[i - 1].ridge) starts.push_back(i);
    }
    starts.push_back(uses.size());
    struct Faulty {
      std::size_t group;
      conditions::AtRidge kind;
    };
    const auto faulty = list_in_chunks<Faulty>(
        starts.size() - 1, threads_, faults_.stages,
        [&](std::size_t group, std::vector<Faulty>& found, Stages& stages) {
          const std::size_t first = starts[group], count = starts[group + 1] - first;
          const auto kind = count == 2 ? at_hinge<kDimension>(hinge_of(uses[first]),
                                                              hinge_of(uses[first + 1]), stages)
                                       : conditions::AtRidge::kNotClosed;
          if (kind != conditions::AtRidge::kGood) found.push_back({group, kind});
        });
    for (const auto& [group, kind] : faulty) {
      FaultyRidge& ridge = faults_.ridges.emplace_back();
      const auto& vertices = uses[starts[group]].ridge;
      ridge.vertices.assign(vertices.begin(), vertices.end());
      for (std::size_t i = starts[group]; i < starts[group + 1]; ++i) {
        ridge.facets.push_back(uses[i].facet);
      }
      ridge.kind = kind;
    }
  }

  void judge_sample_point(const std::vector<FacetId>& boundary) {
    const SamplePoint<kDimension> sample =
        barycentre_of<kDimension>(mesh_.template sites<false>(0), 0);
    faults_.beyond = list_in_chunks<FacetId>(
        boundary.size(), threads_, faults_.stages,
        [&](std::size_t i, std::vector<FacetId>& found, Stages& stages) {
          const FacetId facet = boundary[i];
          const int side = orientation_with(mesh_.template sites<false>(facet.simplex()),
                                            facet.place(), sample, stages) *
                           orientations_[facet.simplex()];
          if (!conditions::is_strictly_inside(side)) found.push_back(facet);
        });
    if (!faults_.beyond.empty()) return;
    faults_.covering = list_in_chunks<std::size_t>(
        mesh_.size(), threads_, faults_.stages,
        [&](std::size_t s, std::vector<std::size_t>& found, Stages& stages) {
          if (s > 0 && covers(mesh_.template sites<false>(s), orientations_[s], sample, stages)) {
            found.push_back(s);
          }
        });
  }

  const MeshView<kDimension, Index>& mesh_;
  const std::vector<std::int8_t>& orientations_;
  unsigned threads_;
  Faults& faults_;
};

}  // namespace circumspect::fast
