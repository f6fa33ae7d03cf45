// Judging, and the contents of a verdict.
#include <charconv>
#include <cstddef>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <circumspect/circumspect.h>
#include <fmt/format.h>

#include "c/demands.hpp"
#include "c/guard.hpp"
#include "c/input.hpp"
#include "c/kept_verdict.hpp"
#include "kernel/exact/number.hpp"
#include "oracle/judge/cause/causes.hpp"
#include "oracle/judge/default_claim.hpp"
#include "oracle/judge/fault_of_claim.hpp"
#include "oracle/judge/judge.hpp"
#include "oracle/judge/known_mesh.hpp"
#include "oracle/judge/periodic/unfolded.hpp"
#include "oracle/judge/quality/judge_quality.hpp"
#include "oracle/judge/within/judge_within.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/picture/page.hpp"
#include "oracle/report/json.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::c {

// The texts and indices that the pointers of a circumspect_violation point to.
struct KeptViolation {
  std::vector<std::string> texts = {};
  std::vector<std::int64_t> simplex_starts = {0};
  std::vector<std::int64_t> simplices = {};
  Simplex face = {};
  Simplex vertices = {};
  std::vector<circumspect_value> point = {};
  std::vector<circumspect_value> centre = {};
  std::vector<circumspect_value> squared_radius = {};
  std::vector<circumspect_value> values = {};
  circumspect_violation shown = {};
};

namespace {

double nearest_double(const Rational& value) {
  const std::string decimal = to_decimal(value);
  double nearest = 0;
  const auto read = std::from_chars(decimal.data(), decimal.data() + decimal.size(), nearest);
  if (read.ec != std::errc::result_out_of_range) return nearest;
  if (abs(value) < 1) return sign(value) * 0.0;
  return sign(value) * std::numeric_limits<double>::infinity();
}

circumspect_value value_of(KeptViolation& kept, const std::string& name, const Rational& value) {
  kept.texts.push_back(name);
  const char* const shown_name = kept.texts.back().c_str();
  kept.texts.push_back(to_string(value));
  return {shown_name, kept.texts.back().c_str(), nearest_double(value)};
}

std::vector<circumspect_value> values_of(KeptViolation& kept, const Point& point) {
  std::vector<circumspect_value> values;
  for (std::size_t axis = 0; axis < point.size(); ++axis) {
    values.push_back(value_of(kept, std::to_string(axis), point[axis]));
  }
  return values;
}

template <class Value>
const Value* start(const std::vector<Value>& values) {
  return values.empty() ? nullptr : values.data();
}

std::unique_ptr<KeptViolation> kept_violation(const Violation& violation, const Mesh& mesh) {
  auto kept = std::make_unique<KeptViolation>();
  const Witness& witness = violation.witness;
  const report::NamedCells named = report::named_cells(witness, mesh);
  for (const Simplex& simplex : named.simplices) {
    kept->simplices.insert(kept->simplices.end(), simplex.begin(), simplex.end());
    kept->simplex_starts.push_back(static_cast<std::int64_t>(kept->simplices.size()));
  }
  if (named.face) kept->face = *named.face;
  for (const Vertex v : witness.vertices) kept->vertices.push_back(mesh.label(v));
  // The texts must not move, because callers hold pointers into them.
  const std::size_t coordinates = (witness.point ? witness.point->size() : 0) +
                                  (witness.ball ? witness.ball->centre.size() + 1 : 0);
  kept->texts.reserve(2 * (coordinates + witness.values.size()));
  if (witness.point) kept->point = values_of(*kept, *witness.point);
  if (witness.ball) {
    kept->centre = values_of(*kept, witness.ball->centre);
    kept->squared_radius = {value_of(*kept, "squared radius", witness.ball->squared_radius)};
  }
  for (const NamedValue& value : witness.values) {
    kept->values.push_back(value_of(*kept, value.name, value.value));
  }
  const auto size = [](const auto& list) { return static_cast<std::int64_t>(list.size()); };
  static_assert(sizeof(Vertex) == sizeof(std::int64_t));
  const auto indices = [](const Simplex& list) {
    return reinterpret_cast<const std::int64_t*>(start(list));
  };
  kept->shown = {.rule = identifier(violation.rule).data(),
                 .meaning = meaning(violation.rule).data(),
                 .simplex_count = size(named.simplices),
                 .simplex_starts = start(kept->simplex_starts),
                 .simplices = start(kept->simplices),
                 .face_size = size(kept->face),
                 .face = indices(kept->face),
                 .vertex_count = size(kept->vertices),
                 .vertices = indices(kept->vertices),
                 .point_size = size(kept->point),
                 .point = start(kept->point),
                 .centre_size = size(kept->centre),
                 .centre = start(kept->centre),
                 .squared_radius = start(kept->squared_radius),
                 .value_count = size(kept->values),
                 .values = start(kept->values)};
  return kept;
}

Verdict judged_within(const char* within, Claim claim, const Mesh& mesh, const Domain& domain,
                      const check::Options& options) {
  const Rational distance = distance_of(within);
  const check::KnownMesh asked(claim, mesh, domain.complex.kind, options);
  auto verdict =
      check::judge_within(claim, asked.exact, domain, distance * distance, options, asked.known());
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
  if (!are_merged) {
    refuse_equal_points(repeated, "set merge_equal_points");
  }
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
    if (domain == nullptr) refuse_call("expected a domain beside `within`, found NULL");
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

int said(const std::optional<bool>& fact) { return fact ? (*fact ? 1 : 0) : -1; }

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

struct circumspect_verdict {
  bool holds = false;
  int unique = -1;
  int canonical = -1;
  const char* claim = "";
  std::string text;
  std::string json;
  std::vector<std::pair<const char*, std::int64_t>> rules = {};
  std::vector<std::unique_ptr<c::KeptViolation>> violations = {};
  std::optional<picture::Page> page = {};
  std::vector<std::string> notes = {};
};

circumspect_verdict* c::kept_verdict(const Verdict& found, const Mesh& mesh, const Domain* domain,
                                     const circumspect_options& asked, check::By by,
                                     std::vector<std::string> notes) {
  auto made = std::make_unique<circumspect_verdict>();
  made->notes = std::move(notes);
  const std::string shown = asked.mesh_name != nullptr ? on_one_line(asked.mesh_name) : "mesh";
  made->holds = found.holds();
  made->unique = said(found.unique);
  made->canonical = said(found.canonical);
  made->claim = name(found.claim()).data();
  made->text = report::explanation(found, mesh, domain) +
               report::verdict_line(found, mesh, shown, domain) + "\n";
  if (asked.without_json == 0 || asked.with_pictures != 0) {
    require_memory_for_json();
    report::Json result = report::verdict(found, mesh, shown, by, domain);
    if (!made->notes.empty()) result["notes"] = made->notes;
    if (asked.without_json == 0) {
      made->json = report::document_text({{"circumspect", 1}, {"results", {result}}});
    }
    if (asked.with_pictures != 0) {
      made->page.emplace().add(found, mesh, shown, std::move(result), domain, made->notes);
    }
  }
  for (const auto& [rule, tally] : found.tallies()) {
    made->rules.emplace_back(identifier(rule).data(), static_cast<std::int64_t>(tally.count));
  }
  for (const Violation& violation : found.violations()) {
    made->violations.push_back(kept_violation(violation, mesh));
  }
  return made.release();
}

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
    if (asked.allow_empty == 0) {
      c::refuse_empty(judged, "; to judge an empty mesh, set allow_empty");
    }
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
    const std::string unmeasured = check::fault_of_quality(judged, own.quality);
    if (!unmeasured.empty()) c::refuse_call(unmeasured);
    const Domain* const filled = about ? &*about : nullptr;
    std::vector<std::string> notes;
    const Claim known = named ? *named : c::default_claim(judged, filled, asked, notes);
    c::set_demands(asked.demands, known, own);
    Verdict found = c::judged(known, judged, filled, asked, own, notes);
    if (asked.within == nullptr) found.causes = c::causes_of(found, judged, filled, own);
    *verdict = c::kept_verdict(found, judged, filled, asked, own.by, std::move(notes));
  });
}

void circumspect_verdict_free(circumspect_verdict* verdict) { delete verdict; }

int circumspect_verdict_holds(const circumspect_verdict* verdict) {
  return verdict == nullptr ? -1 : (verdict->holds ? 1 : 0);
}

int circumspect_verdict_unique(const circumspect_verdict* verdict) {
  return verdict == nullptr ? -1 : verdict->unique;
}

int circumspect_verdict_canonical(const circumspect_verdict* verdict) {
  return verdict == nullptr ? -1 : verdict->canonical;
}

const char* circumspect_verdict_claim(const circumspect_verdict* verdict) {
  return verdict == nullptr ? "" : verdict->claim;
}

const char* circumspect_verdict_text(const circumspect_verdict* verdict) {
  return verdict == nullptr ? "" : verdict->text.c_str();
}

const char* circumspect_verdict_json(const circumspect_verdict* verdict) {
  return verdict == nullptr ? "" : verdict->json.c_str();
}

int64_t circumspect_verdict_note_count(const circumspect_verdict* verdict) {
  return verdict == nullptr ? 0 : static_cast<int64_t>(verdict->notes.size());
}

const char* circumspect_verdict_note(const circumspect_verdict* verdict, int64_t index) {
  if (index < 0 || index >= circumspect_verdict_note_count(verdict)) return nullptr;
  return verdict->notes[static_cast<std::size_t>(index)].c_str();
}

circumspect_status circumspect_verdict_page(const circumspect_verdict* verdict,
                                            circumspect_document** page) {
  if (page != nullptr) *page = nullptr;
  return c::guarded([&] {
    c::required(page, "a place for the page");
    const auto& kept = c::required(verdict, "a verdict")->page;
    if (!kept) {
      throw c::Refusal{CIRCUMSPECT_NONE,
                       "expected a verdict that was asked for with_pictures, found one without"};
    }
    c::require_memory_for_json();
    std::ostringstream text;
    kept->write(text);
    if (!text) throw std::bad_alloc();  // how streams report that memory ran out
    *page = new circumspect_document{text.str()};
  });
}

int64_t circumspect_verdict_rule_count(const circumspect_verdict* verdict) {
  return verdict == nullptr ? 0 : static_cast<int64_t>(verdict->rules.size());
}

const char* circumspect_verdict_rule(const circumspect_verdict* verdict, int64_t index,
                                     int64_t* count) {
  if (count != nullptr) *count = 0;
  if (index < 0 || index >= circumspect_verdict_rule_count(verdict)) return nullptr;
  const auto& [rule, times] = verdict->rules[static_cast<std::size_t>(index)];
  if (count != nullptr) *count = times;
  return rule;
}

int64_t circumspect_verdict_violation_count(const circumspect_verdict* verdict) {
  return verdict == nullptr ? 0 : static_cast<int64_t>(verdict->violations.size());
}

circumspect_status circumspect_verdict_violation(const circumspect_verdict* verdict, int64_t index,
                                                 circumspect_violation* violation, size_t size) {
  return c::guarded([&] {
    c::required(violation, "a place for the violation");
    if (size != sizeof(circumspect_violation)) {
      c::refuse_call(fmt::format("expected a place of {} bytes, found {}",
                                 sizeof(circumspect_violation), size));
    }
    *violation = {};
    const int64_t count = circumspect_verdict_violation_count(verdict);
    if (index < 0 || index >= count) {
      c::refuse_call(fmt::format("expected the index of one of {}, found {}",
                                 report::counted(static_cast<std::size_t>(count), "violation"),
                                 index));
    }
    *violation = verdict->violations[static_cast<std::size_t>(index)]->shown;
  });
}
