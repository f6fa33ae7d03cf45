// The faulty ridges of a mesh in arrays: which of them a verdict shows, and what the others count.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "kernel/exact/each_once.hpp"
#include "oracle/judge/conditions/conditions.hpp"
#include "oracle/judge/fast/boundary.hpp"
#include "oracle/judge/fast/faults.hpp"
#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/model/rule.hpp"

namespace circumspect::check {

// Of each kind, how many faulty ridges are not listed because no verdict shows them. Those that are
// listed then include the first of each kind, by their vertices.
using FurtherRidges = std::map<conditions::AtRidge, std::size_t>;

inline Rule rule_of(conditions::AtRidge kind) {
  switch (kind) {
    case conditions::AtRidge::kNotClosed:
      return Rule::kHullNotClosed;
    case conditions::AtRidge::kFolded:
      return Rule::kOverlap;
    default:
      return Rule::kHullNotConvex;
  }
}

// What oracle/judge/points finds at a faulty ridge, found by the signs of the fast judge instead.
template <std::size_t kDimension, typename Index>
class RidgeFault {
 public:
  RidgeFault(const fast::MeshView<kDimension, Index>& mesh, const fast::FaultyRidge& ridge)
      : mesh_(mesh), ridge_(ridge) {}

  Rule rule() const { return rule_of(ridge_.kind); }

  // The vertices that the witness names, ascending.
  Simplex named() const {
    const std::vector<fast::FacetId> facets = facets_in_order();
    Simplex all;
    const auto add_simplex = [&](fast::FacetId facet) {
      const auto row = mesh_.row(facet.simplex());
      all.insert(all.end(), row.begin(), row.end());
    };
    switch (kind_of(facets)) {
      case conditions::AtRidge::kNotClosed:
        for (const fast::FacetId facet : facets) {
          const auto vertices = vertices_of(facet);
          all.insert(all.end(), vertices.begin(), vertices.end());
        }
        break;
      case conditions::AtRidge::kFirstBeyond:
        add_simplex(facets[1]);
        all.push_back(off_ridge(facets[0]));
        break;
      case conditions::AtRidge::kSecondBeyond:
        add_simplex(facets[0]);
        all.push_back(off_ridge(facets[1]));
        break;
      default:
        add_simplex(facets[0]);
        add_simplex(facets[1]);
    }
    keep_each_once(all);
    return all;
  }

 private:
  // That of the exact checkers: by their vertices, then by their simplices.
  std::vector<fast::FacetId> facets_in_order() const {
    std::vector<fast::FacetId> facets = ridge_.facets;
    std::sort(facets.begin(), facets.end(), [&](fast::FacetId a, fast::FacetId b) {
      return std::pair(vertices_of(a), a.simplex()) < std::pair(vertices_of(b), b.simplex());
    });
    return facets;
  }
  conditions::AtRidge kind_of(const std::vector<fast::FacetId>& facets) const {
    fast::Stages stages;
    return facets.size() == 2
               ? fast::at_hinge<kDimension>(hinge(facets[0]), hinge(facets[1]), stages)
               : conditions::AtRidge::kNotClosed;
  }
  auto vertices_of(fast::FacetId facet) const {
    return fast::facet_of(mesh_.row(facet.simplex()), facet.place());
  }
  // The vertex of a facet that the ridge leaves out.
  Vertex off_ridge(fast::FacetId facet) const {
    const auto vertices = vertices_of(facet);
    return static_cast<Vertex>(*std::find_if(vertices.begin(), vertices.end(), [&](Index v) {
      return std::find(ridge_.vertices.begin(), ridge_.vertices.end(),
                       static_cast<std::int64_t>(v)) == ridge_.vertices.end();
    }));
  }
  fast::SiteRow<kDimension> hinge(fast::FacetId facet) const {
    fast::SiteRow<kDimension> row;
    const auto site = [&](auto v) { return mesh_.template site<false>(static_cast<Index>(v)); };
    for (std::size_t i = 0; i + 1 < kDimension; ++i) row[i] = site(ridge_.vertices[i]);
    row[kDimension - 1] = site(off_ridge(facet));
    row[kDimension] = site(mesh_.row(facet.simplex())[facet.place()]);
    return row;
  }

  const fast::MeshView<kDimension, Index>& mesh_;
  const fast::FaultyRidge& ridge_;
};

// The faulty ridges in order, divided into those that the exact checkers look at again, and those
// that are counted alone: at most `shown` are shown, but each rule by one at least. 0: all.
template <std::size_t kDimension, typename Index>
struct RidgesRetold {
  std::vector<const fast::FaultyRidge*> shown = {};
  std::vector<RidgeFault<kDimension, Index>> counted = {};

  RidgesRetold(const fast::MeshView<kDimension, Index>& mesh,
               const std::vector<fast::FaultyRidge>& ridges, const FurtherRidges& further,
               std::size_t most) {
    std::vector<const fast::FaultyRidge*> all;
    for (const fast::FaultyRidge& ridge : ridges) all.push_back(&ridge);
    const bool all_are_shown = most == 0 || (all.size() <= most && further.empty());
    std::sort(all.begin(), all.end(),
              [](const auto* a, const auto* b) { return a->vertices < b->vertices; });
    std::vector<Rule> rules;
    for (const fast::FaultyRidge* const ridge : all) {
      if (all_are_shown) {
        shown.push_back(ridge);
        continue;
      }
      RidgeFault<kDimension, Index> fault(mesh, *ridge);
      const bool is_first = std::find(rules.begin(), rules.end(), fault.rule()) == rules.end();
      if (is_first) rules.push_back(fault.rule());
      if (is_first || shown.size() < most) {
        shown.push_back(ridge);
      } else {
        counted.push_back(std::move(fault));
      }
    }
  }
};

}  // namespace circumspect::check
