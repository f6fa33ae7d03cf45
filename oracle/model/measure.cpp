#include "oracle/model/measure.hpp"

#include <algorithm>
#include <array>

#include "kernel/exact/angle.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/model/words.hpp"

namespace circumspect {
namespace {

using Fault = tl::unexpected<std::string>;

constexpr std::array<MeasureEntry, 10> kMeasures = {{
    {Measure::kMinAngle, "min-angle", true, true, 2, 3, Rule::kQualityMinAngle},
    {Measure::kMaxAngle, "max-angle", true, false, 2, 3, Rule::kQualityMaxAngle},
    {Measure::kMinDihedral, "min-dihedral", true, true, 3, 3, Rule::kQualityMinDihedral},
    {Measure::kMaxDihedral, "max-dihedral", true, false, 3, 3, Rule::kQualityMaxDihedral},
    {Measure::kRadiusEdge, "radius-edge", false, false, 2, 3, Rule::kQualityRadiusEdge},
    {Measure::kAspectRatio, "aspect-ratio", false, false, 2, 3, Rule::kQualityAspectRatio},
    {Measure::kVolume, "volume", false, false, 3, 3, Rule::kQualityVolume},
    {Measure::kArea, "area", false, false, 2, 2, Rule::kQualityArea},
    {Measure::kEdge, "edge", false, false, 1, 3, Rule::kQualityEdge},
    {Measure::kMinEdge, "min-edge", false, true, 1, 3, Rule::kQualityMinEdge},
}};

std::string known_measures() {
  std::string all;
  for (const MeasureEntry& one : kMeasures) {
    all += (all.empty() ? "" : ", ") + std::string(one.name);
  }
  return all;
}

std::string example_of(const MeasureEntry& measure) {
  return std::string(measure.name) + (measure.is_angle
                                          ? measure.is_at_least ? ":20.7deg" : ":150deg"
                                      : measure.measure == Measure::kRadiusEdge ? ":sqrt(2)"
                                                                                : ":0.5");
}

// What follows the name: where the bound begins. `found` is the whole text, for messages.
tl::expected<std::string_view, std::string> after_relation(const MeasureEntry& measure,
                                                           std::string_view rest,
                                                           std::string_view found) {
  const std::string_view wanted = measure.is_at_least ? ">=" : "<=";
  if (rest.empty()) {
    return Fault("expected a bound, as in " + example_of(measure) + ", found " +
                 std::string(found) + " alone: the shell takes " + std::string(wanted) +
                 " for the name of a file unless it is quoted");
  }
  if (rest.starts_with(':')) return rest.substr(1);
  if (rest.starts_with(wanted)) return rest.substr(2);
  return Fault("expected '" + std::string(measure.name) + " " + std::string(wanted) + " …' or " +
               example_of(measure) + ": " + std::string(measure.name) + " is to be at " +
               (measure.is_at_least ? "least" : "most") + " its bound, found '" +
               std::string(found) + "'");
}

// The square of a number, which may be written as a root.
std::optional<Rational> read_squared(std::string_view text) {
  constexpr std::string_view kRoot = "sqrt(";
  const bool is_root = text.starts_with(kRoot) && text.ends_with(')');
  if (is_root) text = without_blanks(text.substr(kRoot.size(), text.size() - kRoot.size() - 1));
  const auto number = read_number(text, NumberReading::kDecimal);
  if (!number || sign(*number) < 0) return std::nullopt;
  return is_root ? *number : Rational(*number * *number);
}

// The value of the regular simplex, which no simplex exceeds in the measure: docs/theory/quality.md
// proves it. None if all values occur, or if nothing is proved.
std::optional<Rational> best_value(Measure measure, int dimension) {
  switch (measure) {
    case Measure::kMinAngle:
    case Measure::kMaxAngle:
      return Rational(1, 4);
    case Measure::kMinDihedral:
    case Measure::kMaxDihedral:
      return Rational(1, 9);
    case Measure::kRadiusEdge:
      return dimension == 2 ? Rational(1, 3) : Rational(3, 8);
    case Measure::kAspectRatio:
      return dimension == 2 ? Rational(4, 3) : Rational(1);
    default:
      return std::nullopt;
  }
}

std::string noun(int dimension) {
  switch (dimension) {
    case 1:
      return "edges";
    case 2:
      return "triangles";
    case 3:
      return "tetrahedra";
    default:
      return "simplices of dimension " + std::to_string(dimension);
  }
}

}  // namespace

std::span<const MeasureEntry> measures() { return kMeasures; }

const MeasureEntry& entry(Measure measure) { return kMeasures[static_cast<std::size_t>(measure)]; }

bool exists_for(Measure measure, int dimension) {
  return entry(measure).least <= dimension && dimension <= entry(measure).most;
}

std::string measure_text(Measure measure, const Rational& value) {
  return entry(measure).is_angle ? degrees_to_decimal(value) + "deg"
                                 : square_root_to_decimal(value);
}

bool is_worse(Measure measure, const Rational& value, const Rational& than) {
  const MeasureEntry& of = entry(measure);
  const bool larger_is_worse =
      of.is_angle == of.is_at_least;  // the signed square falls with the angle
  return larger_is_worse ? than < value : value < than;
}

std::string Requirement::word() const {
  const std::size_t relation = text.find(' ');
  return text.substr(0, relation) + ":" + text.substr(relation + 4);
}

int compare(Measure measure, const Rational& value, const Rational& bound) {
  return entry(measure).is_angle ? compare_angle(value, bound) : sign(Rational(value - bound));
}

bool keeps(const Requirement& requirement, const Rational& value) {
  const int side = compare(requirement.measure, value, requirement.bound);
  return entry(requirement.measure).is_at_least ? side >= 0 : side <= 0;
}

tl::expected<Rational, std::string> read_degrees(std::string_view text) {
  constexpr std::string_view kUnit = "deg";
  const bool has_unit = text.ends_with(kUnit);
  const std::string_view number =
      has_unit ? without_blanks(text.substr(0, text.size() - kUnit.size())) : text;
  const auto degrees = read_number(number, NumberReading::kDecimal);
  if (!has_unit || !degrees || sign(*degrees) < 0) {
    return Fault("expected an angle in degrees such as 20.7deg, found '" + std::string(text) + "'");
  }
  if (*degrees > 180) {
    return Fault("expected an angle of at most 180deg, found " + std::string(text));
  }
  return *degrees;
}

tl::expected<Requirement, std::string> read_requirement(std::string_view text) {
  text = without_blanks(text);
  const std::size_t end =
      std::min(text.find_first_not_of("abcdefghijklmnopqrstuvwxyz-"), text.size());
  const auto* const found = std::find_if(kMeasures.begin(), kMeasures.end(), [&](const auto& one) {
    return one.name == text.substr(0, end);
  });
  if (found == kMeasures.end()) {
    return Fault("expected a requirement such as min-angle:20.7deg of one of " + known_measures() +
                 ", found '" + std::string(text) + "'");
  }
  const auto rest = after_relation(*found, without_blanks(text.substr(end)), text);
  if (!rest) return Fault(rest.error());
  std::string bound(*rest);
  std::erase_if(bound, [](char c) { return c == ' ' || c == '\t'; });
  Requirement requirement{
      found->measure, 0, std::string(found->name) + (found->is_at_least ? " >= " : " <= ") + bound};
  if (found->is_angle) {
    const auto degrees = read_degrees(bound);
    if (!degrees) return Fault(std::string(found->name) + ": " + degrees.error());
    requirement.bound = *degrees;
    return requirement;
  }
  const bool is_size = found->measure == Measure::kArea || found->measure == Measure::kVolume;
  if (is_size && bound == "regions") {
    requirement.of_regions = true;
    return requirement;
  }
  const auto squared = read_squared(bound);
  if (!squared) {
    return Fault(std::string(found->name) +
                 ": expected a number of at least 0, such as 0.5, 1/3 or sqrt(2)" +
                 (is_size ? ", or the word regions" : "") + ", found '" + bound + "'");
  }
  requirement.bound = *squared;
  return requirement;
}

std::string contradiction(const std::vector<Requirement>& requirements) {
  constexpr std::pair<Measure, Measure> kExtremes[] = {
      {Measure::kMinAngle, Measure::kMaxAngle},
      {Measure::kMinDihedral, Measure::kMaxDihedral},
      {Measure::kMinEdge, Measure::kEdge}};
  for (const auto& [least, most] : kExtremes) {
    for (const Requirement& low : requirements) {
      for (const Requirement& high : requirements) {
        if (low.measure != least || high.measure != most || low.bound <= high.bound) continue;
        return "expected requirements that a simplex can keep, found '" + low.text + "' and '" +
               high.text + "', which contradict each other";
      }
    }
  }
  return "";
}

std::string fault_for_dimension(const std::vector<Requirement>& requirements, int dimension) {
  for (const Requirement& one : requirements) {
    if (!exists_for(one.measure, dimension)) {
      std::string those;
      for (const MeasureEntry& other : kMeasures) {
        if (!exists_for(other.measure, dimension)) continue;
        those += (those.empty() ? "" : ", ") + std::string(other.name);
      }
      return "expected a measure of " + noun(dimension) +
             (those.empty() ? ", which has none" : " (" + those + ")") + ", found '" + one.text +
             "'";
    }
    const auto best = best_value(one.measure, dimension);
    if (!best || keeps(one, *best)) continue;
    return "expected a requirement that " + noun(dimension) + " can keep, found '" + one.text +
           "': no " + std::string(entry(one.measure).name) + " is " +
           (entry(one.measure).is_at_least ? "above " : "below ") +
           measure_text(one.measure, *best);
  }
  return "";
}

}  // namespace circumspect
