#include "inputs/triangulated/domain_families.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>

#include "inputs/triangulated/protected_complexes.hpp"

namespace circumspect::properties {
namespace {

using generators::ComplexFamily;
using generators::integer_vertices;

std::vector<ComplexFamily> table() {
  std::vector<ComplexFamily> all = generators::complex_families();
  all.push_back({"protected-polygons",
                 "polygons and segments of Delaunay edges: there is a CDT (Book: Theorem 4.9)", 3,
                 [](generators::Dice& dice, std::size_t max_points) {
                   return protected_polygons(dice, integer_vertices(dice, 3, max_points));
                 }});
  all.push_back({"strongly-protected-polygons",
                 "the same of strongly Delaunay edges, unperturbed (Book: Theorem 4.9)", 3,
                 [](generators::Dice& dice, std::size_t max_points) {
                   return protected_polygons(dice, integer_vertices(dice, 3, max_points),
                                             Protection::kStrong);
                 }});
  all.push_back({"protected-solids",
                 "polyhedra with Delaunay edges, dangling polygons: there is a CDT (Book: Theorem "
                 "4.9)",
                 3, [](generators::Dice& dice, std::size_t max_points) {
                   return protected_solid(dice, integer_vertices(dice, 3, max_points));
                 }});
  all.push_back({"delaunay-polyhedra",
                 "unions of Delaunay tetrahedra, with cavities, pinched, not convex (Book: "
                 "Theorem 4.9)",
                 3, [](generators::Dice& dice, std::size_t max_points) {
                   return delaunay_polyhedron(dice, integer_vertices(dice, 3, max_points));
                 }});
  return all;
}

}  // namespace

const std::vector<ComplexFamily>& domain_families() {
  static const std::vector<ComplexFamily> all = table();
  return all;
}

const std::vector<ComplexFamily>& modified_domain_families() {
  static const std::vector<ComplexFamily> all = [] {
    std::vector<ComplexFamily> with_modifiers = domain_families();
    for (const auto& modifier : generators::complex_modifiers()) {
      for (const ComplexFamily& family : domain_families()) {
        with_modifiers.push_back(generators::modified(family, modifier));
      }
    }
    return with_modifiers;
  }();
  return all;
}

namespace {

// "planar-grid+rotated": the family planar-grid, turned.
std::optional<ComplexFamily> composed(std::string_view name) {
  const std::size_t end = name.rfind('+');
  const auto named = [](std::string_view wanted) {
    return [wanted](const auto& one) { return one.name == wanted; };
  };
  if (end == std::string_view::npos) {
    const auto& all = domain_families();
    const auto found = std::find_if(all.begin(), all.end(), named(name));
    return found == all.end() ? std::nullopt : std::optional(*found);
  }
  const auto& modifiers = generators::complex_modifiers();
  const auto modifier =
      std::find_if(modifiers.begin(), modifiers.end(), named(name.substr(end + 1)));
  const auto plain = composed(name.substr(0, end));
  if (!plain || modifier == modifiers.end()) return std::nullopt;
  return generators::modified(*plain, *modifier);
}

}  // namespace

const ComplexFamily* find_domain_family(std::string_view name) {
  static std::mutex mutex;
  static std::map<std::string, ComplexFamily, std::less<>> asked_for;
  const std::lock_guard lock(mutex);
  if (const auto found = asked_for.find(name); found != asked_for.end()) return &found->second;
  std::optional<ComplexFamily> family = composed(name);
  if (!family) return nullptr;
  return &asked_for.emplace(std::string(name), std::move(*family)).first->second;
}

}  // namespace circumspect::properties
