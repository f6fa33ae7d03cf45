// What is asked of a mesh, and its judgement.
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <circumspect/circumspect.h>
#include <fmt/format.h>

#include "c/demands.hpp"
#include "c/guard.hpp"
#include "c/input.hpp"
#include "c/kept_verdict.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/judge/cause/causes.hpp"
#include "oracle/judge/default_claim.hpp"
#include "oracle/judge/fault_of_claim.hpp"
#include "oracle/judge/judge.hpp"
#include "oracle/judge/known_mesh.hpp"
#include "oracle/judge/periodic/unfolded.hpp"
#include "oracle/judge/quality/judge_quality.hpp"
#include "oracle/judge/within/judge_within.hpp"
#include "oracle/model/claim.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::c {
namespace {

Verdict judged_within(const char* within, Claim claim, const Mesh& mesh, const Domain& domain,
                      const check::Options& options) {
  const Rational distance = distance_of(within);
  const check::KnownMesh asked(claim, mesh, domain.complex.kind, options);
  auto verdict = check::judge_within(claim, asked.exact(), domain, distance * distance, options,
                                     asked.beside(options));
  if (verdict) {
    check::judge_quality(mesh, &domain, distance * distance, options, *verdict);
    return std::move(*verdict);
  }
  const auto& [reason, is_input_fault] = verdict.error();
  throw Refusal{is_input_fault ? CIRCUMSPECT_INPUT_FAULT : CIRCUMSPECT_UNDECIDED, reason};
}

// Equal points are refused, or merged with a note.
void settle_equal_points(const std::vector<Duplicate>& repeated, bool are_merged, Mesh& mesh,
                         std::vector<std::string>& notes) {
  if (repeated.empty()) return;
  if (!are_merged) refuse_equal_points(repeated, kMergeEqualPoints);
  merge_equal_points(mesh);
  notes.push_back(report::note_of_merged_points(repeated));
}

// What is meant where no claim is named. The points decide, so equal ones are settled before.
Claim default_claim(Mesh& mesh, const Domain* domain, const circumspect_options& asked,
                    std::vector<std::string>& notes) {
  if (domain != nullptr) {
    settle_equal_points(equal_points(mesh), asked.merge_equal_points != 0, mesh, notes);
  }
  return check::default_claim(mesh, domain, asked.within != nullptr);
}

Verdict judged(Claim claim, Mesh& mesh, const Domain* domain, const circumspect_options& asked,
               const check::Options& options, std::vector<std::string>& notes) {
  const bool are_merged = asked.merge_equal_points != 0;
  if (asked.within != nullptr) {
    if (domain == nullptr) refuse_call("expected a domain beside `within`, found none");
    settle_equal_points(equal_points(mesh), are_merged, mesh, notes);
    return judged_within(asked.within, claim, mesh, *domain, options);
  }
  const std::string fault = check::fault_of_claim(claim, mesh, options);
  if (!fault.empty()) refuse_input(fault);
  // Otherwise equal points break a rule of this claim.
  if (claim == Claim::kComplex && are_merged) {
    settle_equal_points(equal_points(mesh), are_merged, mesh, notes);
  }
  auto verdict = check::judge(claim, mesh, domain, options);
  if (verdict) return std::move(*verdict);
  settle_equal_points(verdict.error().repeated, are_merged, mesh, notes);
  return check::judge(claim, mesh, domain, options).value();
}

std::vector<Cause> causes_of(const Verdict& verdict, const Mesh& mesh, const Domain* domain,
                             check::Options options) {
  options.max_violations = 1;
  const auto again = [&](const Mesh& mended) -> std::optional<Verdict> {
    auto judged = check::judge(verdict.claim(), mended, domain, options);
    if (!judged) return std::nullopt;
    return std::move(*judged);
  };
  return check::causes(verdict, mesh, again).found;
}

// The mesh that the lattice repeats, with a point for each corner.
Mesh unfolded(const Mesh& listed, const circumspect_options& asked) {
  if (asked.lattice == nullptr || asked.offsets == nullptr) {
    refuse_call(
        "expected lattice and offsets beside the claim periodic-delaunay, found NULL: say how the "
        "mesh repeats");
  }
  const auto d = static_cast<std::int64_t>(listed.dimension());
  Periodic periodic{exact_points(d, d, asked.lattice, nullptr), {}};
  const std::int64_t* next = asked.offsets;
  for (const Simplex& simplex : listed.simplices.lists()) {
    const std::int64_t* const end = next + std::ssize(simplex) * d;
    periodic.offsets.emplace_back(next, end);
    next = end;
  }
  const std::string fault = check::fault_of_periodic(listed, periodic);
  if (!fault.empty()) refuse_input(fault);
  return check::unfolded(listed, periodic);
}

QualityDemands quality_of(const circumspect_options& asked) {
  QualityDemands demands;
  if (asked.require_count < 0) {
    refuse_call(fmt::format("expected a number of requirements, found {}", asked.require_count));
  }
  for (std::int64_t i = 0; i < asked.require_count; ++i) {
    const char* const text = required(required(asked.require, "requirements")[i], "a requirement");
    auto requirement = read_requirement(text);
    if (!requirement) refuse_call(on_one_line(requirement.error()));
    demands.requirements.push_back(std::move(*requirement));
  }
  if (asked.except_sharp != nullptr) {
    const auto degrees = read_degrees(asked.except_sharp);
    if (!degrees) refuse_call(on_one_line(degrees.error()));
    if (demands.empty()) refuse_call("expected requirements beside `except_sharp`, found none");
    demands.except_sharp = *degrees;
  }
  const std::string fault = contradiction(demands.requirements);
  if (!fault.empty()) refuse_call(on_one_line(fault));
  return demands;
}

}  // namespace

circumspect_options asked_of(const circumspect_options* options) {
  const circumspect_options defaults = CIRCUMSPECT_OPTIONS;
  if (options == nullptr) return defaults;
  return of_any_version<circumspect_options>(
      *options, defaults,
      {offsetof(circumspect_options, with_pictures),
       offsetof(circumspect_options, merge_equal_points), offsetof(circumspect_options, demands),
       offsetof(circumspect_options, require_count), offsetof(circumspect_options, lattice)},
      "CIRCUMSPECT_OPTIONS");
}

check::Options options_of(const circumspect_options& asked) {
  if (asked.threads < 0 || asked.threads > 4096) {
    refuse_call(fmt::format("expected 0 to 4096 threads, found {}", asked.threads));
  }
  if (asked.max_violations < 0) {
    refuse_call(fmt::format("expected a number of witnesses, found {}", asked.max_violations));
  }
  return {.by = asked.by_definition != 0 ? check::By::kDefinition : check::By::kLemma,
          .oriented = asked.oriented != 0,
          .complex = {.oriented = asked.oriented != 0 ? Orientations::kSame : Orientations::kAny},
          .quality = quality_of(asked),
          .max_violations = static_cast<std::size_t>(asked.max_violations),
          .threads = static_cast<unsigned>(asked.threads)};
}

Rational distance_of(const char* within) {
  const auto distance = read_number(within, NumberReading::kDecimal);
  if (!distance || sign(*distance) < 0) {
    refuse_call(fmt::format("expected a distance of at least 0 for `within`, found '{}'",
                            on_one_line(within)));
  }
  return *distance;
}

}  // namespace circumspect::c

using namespace circumspect;

circumspect_status circumspect_check(const char* claim, const circumspect_mesh* mesh,
                                     const circumspect_domain* domain,
                                     const circumspect_options* options,
                                     circumspect_verdict** verdict) {
  if (verdict != nullptr) *verdict = nullptr;
  return c::guarded([&] {
    c::required(verdict, "a place for the verdict");
    std::optional<Claim> named;
    if (claim != nullptr) named = c::claim_of(claim, domain != nullptr);
    const circumspect_options asked = c::asked_of(options);
    check::Options own = c::options_of(asked);
    Mesh judged = c::mesh_of(*c::required(mesh, "a mesh"), named == Claim::kWeightedDelaunay);
    const bool has_neighbors = judged.neighbors.has_value();
    if (asked.allow_empty == 0) c::refuse_empty(judged, c::kAllowEmpty);
    if (named == Claim::kPeriodicDelaunay) judged = c::unfolded(judged, asked);
    std::optional<Domain> about;
    if (domain != nullptr) {
      about.emplace(c::domain_of(*domain, asked.merge_equal_points != 0));
      if (judged.points() > 0 && judged.dimension() != about->complex.ambient_dimension()) {
        c::refuse_input(
            fmt::format("expected points of dimension {}, as those of the domain, found {}",
                        about->complex.ambient_dimension(), judged.dimension()));
      }
    }
    const Domain* const filled = about ? &*about : nullptr;
    const std::string unmeasured =
        check::fault_of_quality(judged, own.quality, filled, asked.within != nullptr);
    if (!unmeasured.empty()) c::refuse_call(unmeasured);
    std::vector<std::string> notes;
    const Claim known = named ? *named : c::default_claim(judged, filled, asked, notes);
    if (has_neighbors && is_about_a_list(known)) {
      c::refuse_call(
          fmt::format("expected no neighbors beside the claim {}, found some: they are judged of "
                      "triangulations",
                      name(known)));
    }
    c::set_demands(asked.demands, known, own);
    Verdict found = c::judged(known, judged, filled, asked, own, notes);
    if (asked.within == nullptr) found.causes = c::causes_of(found, judged, filled, own);
    *verdict = c::kept_verdict(found, judged, filled, asked, own.by, std::move(notes));
  });
}
