#include "oracle/judge/quality/region_bounds.hpp"

#include <algorithm>
#include <map>

#include "kernel/exact/number_text.hpp"

namespace circumspect::quality {

std::string fault_of_region_bounds(const Requirement& requirement, const Mesh& mesh,
                                   const Domain* domain, bool is_moved) {
  const std::string asked = "'" + requirement.text + "'";
  if (domain == nullptr || domain->region_bounds.empty()) {
    return "expected a domain whose regions have bounds, as the last list of a .poly file, for " +
           asked + ", found " + (domain == nullptr ? "no domain" : "none in it");
  }
  if (is_moved) {
    return "expected the domain as it stands for " + asked +
           ", found a distance: an element may then be in two regions";
  }
  const bool fits = exists_for(requirement.measure, static_cast<int>(mesh.dimension()));
  if (!fits && mesh.points() > 0) {
    return "expected area:regions in the plane and volume:regions in space, found " + asked +
           " in dimension " + std::to_string(mesh.dimension());
  }
  const Regions regions = domain->regions();
  std::map<std::size_t, const RegionBound*> known;
  for (const RegionBound& one : domain->region_bounds) {
    const auto region = regions.region_at(one.seed);
    if (!region) {
      return "expected points in regions of the domain, which give them bounds for " + asked +
             ", found " + point_text(one.seed) + ", which is on a " +
             (one.seed.size() == 2 ? "segment" : "polygon");
    }
    const auto [other, is_new] = known.emplace(*region, &one);
    if (is_new || other->second->most == one.most) continue;
    return "expected one bound for each region, for " + asked + ", found " +
           value_text(other->second->most) + " at " + point_text(other->second->seed) + " and " +
           value_text(one.most) + " at " + point_text(one.seed) + ", which are in the same region";
  }
  return "";
}

std::vector<RegionRequirement> by_region(const Requirement& requirement, const Domain& domain,
                                         const Regions& regions) {
  std::vector<RegionRequirement> all;
  for (const RegionBound& one : domain.region_bounds) {
    const std::size_t region = regions.region_at(one.seed).value();
    const bool is_known = std::any_of(all.begin(), all.end(), [&](const RegionRequirement& other) {
      return other.region == region;
    });
    if (is_known) continue;
    const std::string text = std::string(entry(requirement.measure).name) +
                             " <= " + to_text_of_double_or_fraction(one.most) +
                             " in the region of " + point_text(one.seed);
    all.push_back({{requirement.measure, one.most * one.most, text}, region});
  }
  return all;
}

std::optional<std::size_t> RegionOfSimplex::operator()(const Simplex& simplex) {
  std::vector<Point> corners;
  for (const Vertex v : simplex) corners.push_back(mesh_.point(v));
  Point centre = barycentre(corners);
  if (region_of_last_) {
    const auto between = regions_.walls().crossings(last_, centre);
    if (between && between->empty()) {
      last_ = std::move(centre);
      return region_of_last_;
    }
  }
  region_of_last_ = regions_.region_at(centre);
  last_ = std::move(centre);
  return region_of_last_;
}

}  // namespace circumspect::quality
