// What is measured of a simplex, and what can be required of it. docs/theory/quality.md defines it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "kernel/exact/number.hpp"
#include "oracle/model/rule.hpp"

namespace circumspect {

enum class Measure {
  kMinAngle,  // of a triangle, or of the faces of a tetrahedron
  kMaxAngle,
  kMinDihedral,  // of a tetrahedron
  kMaxDihedral,
  kRadiusEdge,   // circumradius over shortest edge
  kAspectRatio,  // longest edge over least height
  kVolume,       // of a tetrahedron
  kArea,         // of a triangle
  kEdge,         // the longest
  kMinEdge,      // the shortest
};

struct MeasureEntry {
  Measure measure;
  std::string_view name;  // "min-angle"
  bool is_angle;          // in degrees
  bool is_at_least;       // a requirement bounds it from below
  int least, most;        // of which dimensions of simplices it exists
  Rule rule;              // broken by a simplex that does not keep a requirement
};

std::span<const MeasureEntry> measures();
const MeasureEntry& entry(Measure measure);
bool exists_for(Measure measure, int dimension);

// What was measured is held as a rational number, its value: of an angle the signed square
// (kernel/exact/angle.hpp), of all else the square.

// "18.434948822922010deg", "1.4142135623730951": correctly rounded.
std::string measure_text(Measure measure, const Rational& value);

// Is the first value further than the second towards what the measure is the extreme of: smaller
// for an angle, a dihedral angle or an edge that is to be at least something, larger for all else?
bool is_worse(Measure measure, const Rational& value, const Rational& than);

// A simplex is required to have at least, or at most, so much.
struct Requirement {
  Measure measure;
  Rational bound;           // degrees, or the square of the number
  std::string text;         // "min-angle >= 20.7deg"
  bool of_regions = false;  // "area <= regions": the domain gives a bound for each of its regions

  // "min-angle:20.7deg", a word of the line of a verdict.
  std::string word() const;
};

bool keeps(const Requirement& requirement, const Rational& value);
// The sign of what was measured minus a bound as above.
int compare(Measure measure, const Rational& value, const Rational& bound);

// From "min-angle >= 20.7deg", "min-angle:20.7deg", "radius-edge <= sqrt(2)", "area:regions";
// numbers are decimals or fractions, and mean exactly what is written. Else one line: what was
// expected, and what was found.
tl::expected<Requirement, std::string> read_requirement(std::string_view text);

// From "60deg", up to 180deg.
tl::expected<Rational, std::string> read_degrees(std::string_view text);

// Why no simplex of this dimension can keep them all, or why one of them makes no sense of it; one
// line, empty if nothing is wrong. Of any dimension, without the second part: contradiction.
std::string contradiction(const std::vector<Requirement>& requirements);
std::string fault_for_dimension(const std::vector<Requirement>& requirements, int dimension);

// What is demanded of the simplices of a mesh beside a claim.
struct QualityDemands {
  std::vector<Requirement> requirements = {};
  // Simplices that touch both sides of an angle of less than so many degrees are set aside.
  std::optional<Rational> except_sharp = {};

  bool empty() const { return requirements.empty(); }
};

}  // namespace circumspect
