#include "inputs/families.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

namespace circumspect::generators {
namespace {

std::vector<FamilyModifier> modifier_table() {
  return {
      {"ulp", "rounded to doubles, then half of the coordinates moved by one ulp", one_ulp_away},
      {"scaled", "times 2^k, k from -300 to 300, weights times 4^k", scaled_by_power_of_two},
      {"moved", "moved by 2^20 to 2^50 times its size, then rounded to doubles", far_from_origin},
  };
}

Family modified(Family family, const FamilyModifier& modifier) {
  family.name += "+" + modifier.name;
  family.about += "; " + modifier.about;
  family.draw = [modified = modifier.modified, draw = family.draw, repeats = family.repeats_points](
                    Dice& dice, std::size_t dimension, Count count) {
    const PointsCase set = draw(dice, dimension, count);
    return modified(dice, set, repeats);
  };
  return family;
}

std::vector<Family> with_every_modifier() {
  std::vector<Family> all = families();
  for (const FamilyModifier& modifier : family_modifiers()) {
    for (const Family& family : families()) all.push_back(modified(family, modifier));
  }
  return all;
}

template <class Named>
const Named* find_in(const std::vector<Named>& all, std::string_view name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [name](const Named& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

// "grid+moved+ulp": the family grid, moved, then with ulp.
std::optional<Family> composed(std::string_view name) {
  std::size_t end = name.find('+');
  const Family* const plain = find_in(families(), name.substr(0, end));
  if (plain == nullptr) return std::nullopt;
  Family family = *plain;
  while (end != std::string_view::npos) {
    name.remove_prefix(end + 1);
    end = name.find('+');
    const FamilyModifier* const modifier = find_in(family_modifiers(), name.substr(0, end));
    if (modifier == nullptr) return std::nullopt;
    family = modified(std::move(family), *modifier);
  }
  return family;
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
  if (const Family* const found = find_in(modified_families(), name)) return found;
  static std::mutex mutex;
  static std::map<std::string, Family, std::less<>> asked_for;
  const std::lock_guard lock(mutex);
  if (const auto found = asked_for.find(name); found != asked_for.end()) return &found->second;
  std::optional<Family> family = composed(name);
  if (!family) return nullptr;
  return &asked_for.emplace(std::string(name), std::move(*family)).first->second;
}

Count count_of_a_campaign(std::size_t dimension, std::uint64_t seed) {
  constexpr std::size_t kOneIn = 32;
  constexpr std::size_t kMost = 2000;
  Dice dice(mixed(~seed));
  if (dimension > 3 || dice.below(kOneIn) != 0) return {kFewPoints};
  const std::size_t least = std::size_t{64} << dice.below(5);
  return {std::min(kMost, least + dice.below(least)), true};
}

PointsCase drawn(const Family& family, std::size_t dimension, Count count, std::uint64_t seed) {
  // Mixed, because otherwise the throws of one seed would be those of another, some throws later.
  Dice dice(mixed(seed));
  return family.draw(dice, dimension, count);
}

}  // namespace circumspect::generators
