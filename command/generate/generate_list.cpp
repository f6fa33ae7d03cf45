#include "command/generate/generate_list.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "command/options/nearest_word.hpp"
#include "inputs/families.hpp"
#include "inputs/family_faults.hpp"
#include "inputs/triangulated/domain_families.hpp"
#include "oracle/formats/point_file.hpp"

namespace circumspect::cli {
namespace {

std::vector<std::size_t> dimensions(const generators::Family& family) {
  std::vector<std::size_t> found;
  for (std::size_t d = 1; d <= formats::kLargestDimension; ++d) {
    if (family.exists_in(d)) found.push_back(d);
  }
  return found;
}

std::string line(const std::string& name, const std::string& where, const std::string& about) {
  return fmt::format("  {:<28}{:<14}{}\n", name, where, about);
}

std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const auto& family : generators::families()) names.push_back(family.name);
  for (const auto& family : properties::domain_families()) names.push_back(family.name);
  return names;
}

template <class Modifier>
std::string modifier_names(const std::vector<Modifier>& modifiers) {
  std::string names;
  for (const Modifier& modifier : modifiers) {
    names += (names.empty() ? "+" : ", +") + modifier.name;
  }
  return names;
}

}  // namespace

std::string families_text() {
  std::string text = "Points, in dimension:\n";
  for (const auto& family : generators::families()) {
    text += line(family.name, generators::dimensions_text(family), family.about);
  }
  text += "With any of these, as in sphere+ulp:\n";
  for (const auto& modifier : generators::family_modifiers()) {
    text += line("+" + modifier.name, "", modifier.about);
  }
  text += "Domains, in dimension:\n";
  for (const auto& family : properties::domain_families()) {
    text += line(family.name, std::to_string(family.dimension), family.about);
  }
  text += "With any of these, as in planar-grid+rotated:\n";
  for (const auto& modifier : generators::complex_modifiers()) {
    text += line("+" + modifier.name, "", modifier.about);
  }
  return text;
}

report::Json families_json() {
  report::Json points = report::Json::array();
  for (const auto& family : generators::families()) {
    points.push_back({{"name", family.name},
                      {"about", family.about},
                      {"dimensions", dimensions(family)},
                      {"weighted", family.weighted},
                      {"repeats_points", family.repeats_points}});
  }
  report::Json modifiers = report::Json::array();
  for (const auto& modifier : generators::family_modifiers()) {
    modifiers.push_back({{"name", modifier.name}, {"about", modifier.about}});
  }
  report::Json domains = report::Json::array();
  for (const auto& family : properties::domain_families()) {
    domains.push_back(
        {{"name", family.name}, {"about", family.about}, {"dimension", family.dimension}});
  }
  report::Json domain_modifiers = report::Json::array();
  for (const auto& modifier : generators::complex_modifiers()) {
    domain_modifiers.push_back({{"name", modifier.name}, {"about", modifier.about}});
  }
  return {{"points", points},
          {"modifiers", modifiers},
          {"domains", domains},
          {"domain_modifiers", domain_modifiers}};
}

std::string unknown_family(const std::string& name) {
  const std::string base = name.substr(0, name.find('+'));
  if (base != name) {
    if (generators::find_family(base) != nullptr) {
      return fmt::format("expected modifiers after {}, of {}; found '{}'", base,
                         modifier_names(generators::family_modifiers()), name.substr(base.size()));
    }
    if (properties::find_domain_family(base) != nullptr) {
      return fmt::format("expected modifiers after {}, of {}; found '{}'", base,
                         modifier_names(generators::complex_modifiers()), name.substr(base.size()));
    }
  }
  std::vector<std::string> names = all_names();
  std::stable_sort(names.begin(), names.end(), [&base](const auto& a, const auto& b) {
    return edit_distance(a, base) < edit_distance(b, base);
  });
  return generators::unknown_family_text(
      "", name, fmt::format("; the nearest are {}, {} and {}", names[0], names[1], names[2]));
}

}  // namespace circumspect::cli
