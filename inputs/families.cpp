#include "inputs/families.hpp"

#include <algorithm>
#include <utility>

#include "inputs/family_table.hpp"

namespace circumspect::generators {
namespace {

std::vector<FamilyModifier> modifier_table() {
  return {
      {"ulp", "rounded to doubles, then half of the coordinates moved by one ulp", one_ulp_away},
      {"scaled", "times 2^k, k from -300 to 300, weights times 4^k", scaled_by_power_of_two},
      {"moved", "moved by 2^20 to 2^50 times its size, then rounded to doubles", far_from_origin},
  };
}

std::vector<Family> with_every_modifier() {
  std::vector<Family> all = families();
  for (const FamilyModifier& modifier : family_modifiers()) {
    for (Family family : families()) {
      family.name += "+" + modifier.name;
      family.about += "; " + modifier.about;
      family.draw = [modified = modifier.modified, draw = family.draw,
                     repeats = family.repeats_points](Dice& dice, std::size_t dimension,
                                                      Count count) {
        const PointsCase set = draw(dice, dimension, count);
        return modified(dice, set, repeats);
      };
      all.push_back(std::move(family));
    }
  }
  return all;
}

}  // namespace

const std::vector<Family>& families() {
  static const std::vector<Family> all = family_table();
  return all;
}

const std::vector<FamilyModifier>& family_modifiers() {
  static const std::vector<FamilyModifier> all = modifier_table();
  return all;
}

const std::vector<Family>& modified_families() {
  static const std::vector<Family> all = with_every_modifier();
  return all;
}

const Family* find_family(std::string_view name) {
  const std::vector<Family>& all = modified_families();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [name](const Family& family) { return family.name == name; });
  return found == all.end() ? nullptr : &*found;
}

PointsCase drawn(const Family& family, std::size_t dimension, Count count, std::uint64_t seed) {
  // Mixed, lest the throws of one seed be those of another, some throws later.
  Dice dice(mixed(seed));
  return family.draw(dice, dimension, count);
}

}  // namespace circumspect::generators
