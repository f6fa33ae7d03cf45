// The named families of point sets, from which `circumspect generate`, campaigns and harnesses
// draw. Everything that is drawn follows from a family's name, a dimension, a number of points and
// a seed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "inputs/modifiers.hpp"
#include "inputs/point_sets.hpp"

namespace circumspect::generators {

struct Family {
  std::string name;   // lower-case words joined by hyphens, then "+modifier" if there is one
  std::string about;  // one line: what the sets are, and the notion of the book that they stress
  std::function<bool(std::size_t dimension)> exists_in;
  // Sets of as many points as `count` says, exact. Requires: exists_in(dimension).
  std::function<PointsCase(Dice& dice, std::size_t dimension, Count count)> draw;
  bool weighted = false;
  bool repeats_points = false;  // the only families whose sets may have equal points
};

// A change that can be made to the sets of any family: "sphere+ulp" is the family sphere with the
// modifier ulp. It returns sets of doubles if it was given sets of doubles.
struct FamilyModifier {
  std::string name;
  std::string about;
  PointsCase (*modified)(Dice& dice, const PointsCase& set, bool may_repeat_points);
};

// The families without modifiers, and the modifiers, each in the order of the table that
// `circumspect generate --list` prints.
const std::vector<Family>& families();
const std::vector<FamilyModifier>& family_modifiers();

// Every family, without and with each one of the modifiers: those without come first.
const std::vector<Family>& modified_families();

// A family by its name, which may have several modifiers, one applied after the other:
// "grid+moved+ulp"; null if there is none. It lives as long as the program.
const Family* find_family(std::string_view name);

// How many points a campaign asks for by default: few points show most faults and are judged
// quickly. One set in 32 has 64 to 2000, for faults of blocks, counters and buckets. Those of more
// than three dimensions never do.
constexpr std::size_t kFewPoints = 20;
Count count_of_a_campaign(std::size_t dimension, std::uint64_t seed);

// The set that a seed stands for, the same on every machine. The set of a modified family is made
// of the unmodified set with the same seed. Requires: the family exists in the dimension.
PointsCase drawn(const Family& family, std::size_t dimension, Count count, std::uint64_t seed);

// The only place that lists the families of point sets: a new family is a function, and a line
// here.

std::vector<Family> family_table();

}  // namespace circumspect::generators
