#include "command/check/within_option.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::cli {
namespace {

// Empty, or what is wrong with the text.
std::string read_distance(const std::string& text, Distance& distance) {
  distance.relative = !text.empty() && text.back() == 'x';
  const std::string number = distance.relative ? text.substr(0, text.size() - 1) : text;
  const auto value = read_number(number, NumberReading::kDecimal);
  if (!value || sign(*value) < 0) {
    return fmt::format(
        "expected a distance of at least 0, such as 1e-9 or 1/3, or 1e-12x, which is 1e-12 "
        "times the longest side of the domain's bounding box, found {}",
        text);
  }
  distance.number = *value;
  return "";
}

Rational longest_side(const std::vector<Point>& points) {
  Rational longest = 0;
  for (std::size_t axis = 0; !points.empty() && axis < points.front().size(); ++axis) {
    const auto [low, high] =
        std::minmax_element(points.begin(), points.end(),
                            [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; });
    longest = std::max(longest, Rational((*high)[axis] - (*low)[axis]));
  }
  return longest;
}

}  // namespace

Rational Distance::squared(const PiecewiseLinearComplex& complex) const {
  return squared(complex.points.points());
}

Rational Distance::squared(const std::vector<Point>& points) const {
  const Rational distance = relative ? number * longest_side(points) : number;
  return distance * distance;
}

const char* const kWithinOfDomains =
    "Allow for rounded coordinates: judge exactly whether the claim holds for the domain when its "
    "vertices, segments and polygons may move by at most DISTANCE. This is a number, or a multiple "
    "of the longest side of the domain's bounding box: 1e-12x is 1e-12 times that side. The "
    "verdict ends with the distance that was needed. With the claim voronoi: how far a cell may be "
    "from the exact one";

void add_within_option(CLI::App& command, std::optional<Distance>& distance,
                       const std::string& meaning) {
  const auto read = [&distance](const CLI::results_t& texts) {
    Distance found;
    if (const std::string fault = read_distance(texts.front(), found); !fault.empty()) {
      throw CLI::ValidationError("--within", fault);
    }
    distance = found;
    return true;
  };
  command.add_option("--within", read, meaning)->option_text("DISTANCE");
}

bool may_be_rounded(const Verdict& verdict, DomainKind kind) {
  const auto is_missing = [&](const auto& tally) {
    // Nobody lists the faces of a convex hull. Where a point of one was rounded, the mesh has a
    // dent or a bump there.
    const bool is_off_hull = kind == DomainKind::kHull &&
                             (tally.first == Rule::kHullNotConvex || tally.first == Rule::kOutside);
    return is_off_hull || tally.first == Rule::kDomainVertexMissing ||
           tally.first == Rule::kSegmentMissing || tally.first == Rule::kPolygonNotTiled;
  };
  const auto& tallies = verdict.tallies();
  return std::any_of(tallies.begin(), tallies.end(), is_missing) &&
         std::all_of(tallies.begin(), tallies.end(), [&](const auto& tally) {
           return is_missing(tally) || tally.first == Rule::kSteinerForbidden;
         });
}

namespace {

// What cells of the domain are missing.
std::string missing_cells(const Verdict& verdict) {
  std::string missing;
  for (const auto& [rule, tally] : verdict.tallies()) {
    if (rule == Rule::kSteinerForbidden) continue;  // a vertex that is not where the domain has it
    missing += fmt::format("{}{} {}", missing.empty() ? "" : ", ", identifier(rule), tally.count);
  }
  return missing;
}

std::string all_breaches(const Verdict& verdict) {
  std::string left;
  for (const auto& [rule, tally] : verdict.tallies()) {
    left += fmt::format("{}{} {}", left.empty() ? "" : ", ", identifier(rule), tally.count);
  }
  return left;
}

// What may be the cause, and the verdict with options that allow for it.
std::string note(std::string_view cause, const Verdict& exact, const Verdict& other,
                 const std::string& options) {
  const std::string missing = missing_cells(exact);
  if (other.holds()) {
    return fmt::format("{} ({}): with {} the claim holds", cause, missing, options);
  }
  return fmt::format("{} ({}), but that is not all: with {} the mesh still breaks {}", cause,
                     missing, options, all_breaches(other));
}

}  // namespace

std::string rounding_note(const Verdict& exact, const Verdict& moved) {
  return note("the coordinates may have been rounded", exact, moved,
              "--within " + report::square_root_rounded_up(moved.within->squared_reach));
}

std::string merging_note(const Verdict& exact, const Verdict& merged) {
  const bool has_moved = merged.within && merged.within->squared_reach > 0;
  const std::string options = has_moved
                                  ? "--merge-coplanar --within " +
                                        report::square_root_rounded_up(merged.within->squared_reach)
                                  : "--merge-coplanar";
  return note("the program that made the mesh may have joined polygons of one plane", exact, merged,
              options);
}

std::string bending_note(const Verdict& exact, const Verdict& bent,
                         const Rational& squared_height) {
  const Rational squared =
      bent.within ? std::max(bent.within->squared_reach, squared_height) : squared_height;
  return note("the program that made the mesh may have joined polygons of nearly one plane", exact,
              bent, "--merge-coplanar 0.1deg --within " + report::square_root_rounded_up(squared));
}

}  // namespace circumspect::cli
