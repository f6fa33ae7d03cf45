#include "fuzz/harness/cases.hpp"

#include <stdexcept>

#include "inputs/dice.hpp"
#include "inputs/in_doubles.hpp"

namespace circumspect::harness {
namespace {

const generators::Family& existing_family(const std::string& name, std::size_t dimension) {
  const generators::Family* family = generators::find_family(name);
  if (family == nullptr) {
    throw std::invalid_argument(
        "expected the name of a family (`circumspect generate --list`), "
        "found '" +
        name + "'");
  }
  if (!family->exists_in(dimension)) {
    throw std::invalid_argument("the family '" + name + "' does not exist in dimension " +
                                std::to_string(dimension));
  }
  return *family;
}

}  // namespace

std::vector<const generators::Family*> chosen_families(const std::vector<std::string>& names,
                                                       std::size_t dimension, bool weighted) {
  std::vector<const generators::Family*> chosen;
  for (const std::string& name : names) chosen.push_back(&existing_family(name, dimension));
  if (!names.empty()) return chosen;
  for (const generators::Family& family : generators::modified_families()) {
    if (family.exists_in(dimension) && !family.repeats_points && family.weighted == weighted) {
      chosen.push_back(&family);
    }
  }
  return chosen;
}

DrawnCase drawn_case(const std::vector<const generators::Family*>& families, std::size_t dimension,
                     std::size_t max_points, std::uint64_t run_seed, std::uint64_t index) {
  const generators::Family& family = *families[index % families.size()];
  const std::uint64_t seed = mixed_seed(run_seed, index);
  return {family.name, seed,
          generators::in_doubles(generators::drawn(family, dimension, {max_points}, seed),
                                 family.repeats_points)};
}

std::uint64_t mixed_seed(std::uint64_t run_seed, std::uint64_t index) {
  return generators::mixed(run_seed + index * generators::kMixingStep);
}

}  // namespace circumspect::harness
