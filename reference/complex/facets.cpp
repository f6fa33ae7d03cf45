#include "reference/complex/facets.hpp"

#include <algorithm>

namespace circumspect {

std::vector<FacetUse> facet_uses(const std::vector<Simplex>& simplices) {
  std::vector<FacetUse> uses;
  uses.reserve(simplices.empty() ? 0 : simplices.size() * simplices.front().size());
  for (std::size_t s = 0; s < simplices.size(); ++s) {
    for (std::size_t place = 0; place < simplices[s].size(); ++place) {
      uses.push_back({sorted(facet_opposite(simplices[s], place)), s, place});
    }
  }
  std::stable_sort(uses.begin(), uses.end(),
                   [](const FacetUse& a, const FacetUse& b) { return a.facet < b.facet; });
  return uses;
}

void for_each_facet(const std::vector<FacetUse>& uses,
                    const std::function<void(std::span<const FacetUse>)>& visit) {
  for (auto first = uses.begin(); first != uses.end();) {
    const auto last = std::find_if(first, uses.end(),
                                   [&](const FacetUse& use) { return use.facet != first->facet; });
    visit({first, last});
    first = last;
  }
}

}  // namespace circumspect
