// The named families of point sets: what `circumspect generate`, campaigns and harnesses draw from.
// Everything that is drawn follows from a family's name, a dimension, a number of points and a seed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <rapidcheck.h>

#include "inputs/modifiers.hpp"
#include "inputs/points_case.hpp"

namespace circumspect::generators {

struct Family {
  std::string name;   // lower-case words joined by hyphens, then "+modifier" if there is one
  std::string about;  // one line: what the sets are, and the notion of the book that they stress
  std::function<bool(std::size_t dimension)> exists_in;
  // Sets of 0 to `max_points` points, exact. Requires: exists_in(dimension).
  std::function<rc::Gen<PointsCase>(std::size_t dimension, std::size_t max_points)> cases;
  bool weighted = false;
  bool repeats_points = false;  // the only families whose sets may have equal points
};

// A change that can be made to the sets of any family: "sphere+ulp" is the family sphere with the
// modifier ulp. It returns sets of doubles if it was given such.
struct FamilyModifier {
  std::string name;
  std::string about;
  std::function<rc::Gen<PointsCase>(const rc::Gen<PointsCase>& cases, const ModifierScope& scope)>
      modified;
};

// The families without modifiers, and the modifiers, each in the order of the table that
// `circumspect generate --list` prints.
const std::vector<Family>& families();
const std::vector<FamilyModifier>& family_modifiers();

// Every family, without and with each one of the modifiers: those without come first.
const std::vector<Family>& modified_families();

// One of the modified families, by its name; null if there is none. It lives as long as the program.
const Family* find_family(std::string_view name);

// RapidCheck's size that asks for as many points as there may be; with all sizes up to
// rc::kNominalSize every number of points is equally likely.
inline constexpr int kFullSize = 2 * rc::kNominalSize;

// The set that a seed stands for, the same on every machine.
PointsCase drawn(const rc::Gen<PointsCase>& cases, std::uint64_t seed, int size = rc::kNominalSize);

}  // namespace circumspect::generators
