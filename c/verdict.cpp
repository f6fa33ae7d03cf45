// The contents of a verdict.
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

#include "c/guard.hpp"
#include "c/kept_verdict.hpp"
#include "kernel/exact/number_text.hpp"
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

int said(const std::optional<bool>& fact) { return fact ? (*fact ? 1 : 0) : -1; }

}  // namespace

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
