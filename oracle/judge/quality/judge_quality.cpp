#include "oracle/judge/quality/judge_quality.hpp"

#include <algorithm>

#include "kernel/exact/number_text.hpp"
#include "oracle/judge/definition/quality.hpp"
#include "oracle/judge/quality/exact_measure.hpp"
#include "oracle/judge/quality/filtered.hpp"
#include "oracle/judge/quality/region_bounds.hpp"
#include "oracle/judge/quality/sharp_angles.hpp"

namespace circumspect::check {
namespace {

using Places = std::vector<std::vector<std::size_t>>;

Places violators_by_definition(const Mesh& mesh, const std::vector<Requirement>& requirements) {
  Places all;
  const std::vector<Point> points = mesh.exact_points();
  for (const Requirement& one : requirements) {
    all.push_back(definition::not_keeping(one, points, mesh.simplices.lists()));
  }
  return all;
}

Places violators(const Mesh& mesh, const std::vector<quality::RegionRequirement>& asked,
                 const Options& options) {
  std::vector<Requirement> requirements;
  for (const auto& one : asked) requirements.push_back(one.requirement);
  if (options.by == By::kDefinition) return violators_by_definition(mesh, requirements);
  return quality::violators(mesh, requirements, threads_of(options));
}

void add_violation(const Requirement& requirement, const Mesh& mesh, std::size_t place,
                   int dimension, Verdict& verdict) {
  const MeasureEntry& of = entry(requirement.measure);
  if (!verdict.keeps_more()) return verdict.count(of.rule);
  const Simplex simplex = mesh.simplices[place];
  const auto found = quality::measured(requirement.measure, mesh, simplex, dimension);
  Witness witness = quality::witness_of(requirement.measure, found.value(), simplex, place);
  witness.measured = {requirement.measure, found->value, requirement.text};
  verdict.add(of.rule, witness);
}

}  // namespace

std::string fault_of_quality(const Mesh& mesh, const QualityDemands& demands, const Domain* domain,
                             bool is_moved) {
  for (const Requirement& one : demands.requirements) {
    if (!one.of_regions) continue;
    std::string fault = quality::fault_of_region_bounds(one, mesh, domain, is_moved);
    if (!fault.empty()) return fault;
  }
  if (demands.empty() || mesh.simplices.empty()) return "";
  return fault_for_dimension(demands.requirements, quality::dimension_of_simplices(mesh));
}

void judge_quality(const Mesh& mesh, const Domain* domain, const Rational& squared_reach,
                   const Options& options, Verdict& verdict) {
  const QualityDemands& demands = options.quality;
  if (demands.empty()) return;
  QualityFacts facts;
  for (const Requirement& one : demands.requirements) facts.required.push_back(one.word());
  std::vector<bool> is_set_aside(mesh.simplices.size(), false);
  if (demands.except_sharp) {
    const quality::SharpAngles sharp(mesh, domain, *demands.except_sharp, squared_reach);
    is_set_aside = sharp.touched();
    facts.except_sharp = to_text_of_double_or_fraction(*demands.except_sharp) + "deg";
    facts.set_aside =
        static_cast<std::size_t>(std::count(is_set_aside.begin(), is_set_aside.end(), true));
  }
  verdict.quality = std::move(facts);
  std::vector<quality::RegionRequirement> asked;
  std::optional<Regions> regions;
  for (const Requirement& one : demands.requirements) {
    if (!one.of_regions) {
      asked.push_back({one});
      continue;
    }
    regions = domain->regions();
    for (auto& each : quality::by_region(one, *domain, *regions)) asked.push_back(std::move(each));
  }
  const Places all = violators(mesh, asked, options);
  const int dimension = quality::dimension_of_simplices(mesh);
  for (std::size_t r = 0; r < all.size(); ++r) {
    const auto& [requirement, region] = asked[r];
    std::optional<quality::RegionOfSimplex> region_of;
    if (region) region_of.emplace(mesh, *regions);
    for (const std::size_t place : all[r]) {
      if (is_set_aside[place]) continue;
      if (region && (*region_of)(mesh.simplices[place]) != region) continue;
      add_violation(requirement, mesh, place, dimension, verdict);
    }
  }
}

}  // namespace circumspect::check
