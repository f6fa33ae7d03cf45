#include "inputs/triangulated/domain_families.hpp"

#include <algorithm>

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

const ComplexFamily* find_domain_family(std::string_view name) {
  const std::vector<ComplexFamily>& all = domain_families();
  const auto found = std::find_if(
      all.begin(), all.end(), [name](const ComplexFamily& family) { return family.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace circumspect::properties
