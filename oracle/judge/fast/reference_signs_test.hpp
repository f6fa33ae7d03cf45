// What reference/kernel/predicates says of sites.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "oracle/judge/fast/site.hpp"

namespace circumspect::fast {

using Vertices = std::vector<std::ptrdiff_t>;

// Sites, taken exactly.
class ReferenceSigns {
 public:
  // Each as its coordinates; weights: none or one each.
  ReferenceSigns(const std::vector<std::vector<double>>& points,
                 const std::vector<double>& weights);
  ~ReferenceSigns();

  int orientation(const Vertices& simplex) const;
  // The sign of the ball's polynomial, for a simplex and a query: in_ball times the orientation. It is
  // antisymmetric, and so defined by another simplex of these if the first is degenerate; zero if all
  // are.
  int ball(const Vertices& vertices) const;
  // For a simplex and a query that is none of its vertices. Requires: not degenerate.
  int perturbed_ball(const Vertices& vertices) const;

 private:
  struct Exact;
  std::unique_ptr<const Exact> exact_;
};

template <typename SomeSites>
ReferenceSigns reference_signs(const SomeSites& sites, bool weighted) {
  std::vector<std::vector<double>> points;
  std::vector<double> weights;
  for (const auto& site : sites) {
    points.emplace_back(site.at.begin(), site.at.end());
    if (weighted) weights.push_back(site.weight);
  }
  return {points, weights};
}

}  // namespace circumspect::fast
