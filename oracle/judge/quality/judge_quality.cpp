#include "oracle/judge/quality/judge_quality.hpp"

#include <algorithm>

#include "kernel/exact/number_text.hpp"
#include "oracle/judge/definition/quality.hpp"
#include "oracle/judge/quality/exact_measure.hpp"
#include "oracle/judge/quality/filtered.hpp"
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

Places violators(const Mesh& mesh, const Options& options) {
  const std::vector<Requirement>& requirements = options.quality.requirements;
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

std::string fault_of_quality(const Mesh& mesh, const QualityDemands& demands) {
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
  const Places all = violators(mesh, options);
  const int dimension = quality::dimension_of_simplices(mesh);
  for (std::size_t r = 0; r < all.size(); ++r) {
    for (const std::size_t place : all[r]) {
      if (is_set_aside[place]) continue;
      add_violation(demands.requirements[r], mesh, place, dimension, verdict);
    }
  }
}

}  // namespace circumspect::check
