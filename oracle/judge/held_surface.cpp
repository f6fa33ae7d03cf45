#include "oracle/judge/held_surface.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <variant>
#include <vector>

#include "oracle/judge/complex/adjacency.hpp"
#include "oracle/judge/fast/predicates/predicates.hpp"
#include "oracle/judge/fast/triangle_complex.hpp"

namespace circumspect::check {
namespace {

using Triangles = std::vector<std::array<std::int32_t, 3>>;
constexpr std::size_t kMostPoints = std::size_t{1} << 30;

// Nothing if one has not three different vertices, or if a point has no triangle.
std::optional<Triangles> triangles_of(const Mesh& mesh) {
  if (mesh.points() > kMostPoints) return std::nullopt;
  std::vector<bool> is_used(mesh.points(), false);
  Triangles triangles;
  triangles.reserve(mesh.simplices.size());
  const bool are_all = mesh.simplices.visit([&]<class Lists>(const Lists& lists) {
    if constexpr (std::is_same_v<Lists, std::vector<Simplex>>) {
      return false;
    } else {
      for (std::size_t s = 0; s < lists.rows(); ++s) {
        const auto row = lists.row(s);
        if (row[0] == row[1] || row[0] == row[2] || row[1] == row[2]) return false;
        auto& triangle = triangles.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
          if (!mesh.names(row[i])) return false;
          is_used[static_cast<std::size_t>(row[i])] = true;
          triangle[i] = static_cast<std::int32_t>(row[i]);
        }
      }
      return true;
    }
  });
  if (!are_all || std::find(is_used.begin(), is_used.end(), false) != is_used.end()) {
    return std::nullopt;
  }
  return triangles;
}

bool is_manifold(const std::vector<Simplex>& triangles, const std::vector<FacetUse>& uses) {
  const definition::NotManifold found = not_manifold(triangles, uses);
  return found.facets.empty() && found.ridges.empty() && found.vertices.empty();
}

// The triangle is not flat.
bool are_in_one_plane(std::span<const double> coordinates,
                      const std::array<std::int32_t, 3>& triangle) {
  const auto site = [&](std::size_t v) {
    return fast::Site<3>{{coordinates[3 * v], coordinates[3 * v + 1], coordinates[3 * v + 2]}};
  };
  fast::SiteRow<3> row;
  for (std::size_t i = 0; i < 3; ++i) row[i] = site(static_cast<std::size_t>(triangle[i]));
  fast::Stages stages;
  for (std::size_t v = 0; v < coordinates.size() / 3; ++v) {
    row[3] = site(v);
    if (fast::orientation<3>(row, stages) != 0) return false;
  }
  return true;
}

}  // namespace

std::optional<Verdict> held_surface(const Mesh& mesh, const ComplexDemands& demands,
                                    std::size_t max_violations) {
  const auto* const doubles = std::get_if<Rows<double>>(&mesh.coordinates);
  const bool is_signed =
      demands.oriented == Orientations::kPositive || demands.oriented == Orientations::kNegative;
  if (doubles == nullptr || mesh.dimension() != 3 || mesh.simplices.columns() != 3 || is_signed) {
    return std::nullopt;
  }
  const auto triangles = triangles_of(mesh);
  if (!triangles || !equal_points(mesh).empty() ||
      !fast::are_surely_a_complex(doubles->values(), *triangles)) {
    return std::nullopt;
  }
  std::vector<Simplex> simplices;
  simplices.reserve(triangles->size());
  for (const auto& triangle : *triangles) simplices.emplace_back(triangle.begin(), triangle.end());
  const std::vector<FacetUse> uses = facet_uses(simplices);
  const std::vector<std::size_t> parts = part_of_each(simplices, uses);
  ComplexFacts facts;
  facts.dimension = 2;
  facts.is_complex = true;
  facts.parts = std::set<std::size_t>(parts.begin(), parts.end()).size();
  facts.boundary_facets = open_facets(uses).size();
  const bool is_demanded =
      (!demands.connected || facts.parts == 1) && (!demands.closed || facts.boundary_facets == 0) &&
      (!demands.manifold || is_manifold(simplices, uses)) &&
      (demands.oriented == Orientations::kAny || inconsistent_facets(simplices, uses).empty());
  if (!is_demanded) return std::nullopt;
  Verdict verdict(Claim::kComplex, max_violations);
  verdict.points = mesh.points();
  verdict.simplices = mesh.simplices.size();
  verdict.dimension = are_in_one_plane(doubles->values(), triangles->front()) ? 2 : 3;
  verdict.complex = facts;
  verdict.course = {true, "", 0, 0};
  return verdict;
}

ImproperAmong improper_of_surface(const Mesh& mesh) {
  const auto* const doubles = std::get_if<Rows<double>>(&mesh.coordinates);
  if (doubles == nullptr || mesh.dimension() != 3 || mesh.points() > kMostPoints) return {};
  return
      [doubles](const std::vector<Simplex>& simplices) -> std::optional<std::vector<std::size_t>> {
        Triangles triangles;
        triangles.reserve(simplices.size());
        for (const Simplex& simplex : simplices) {
          if (simplex.size() != 3) return std::nullopt;
          auto& triangle = triangles.emplace_back();
          for (std::size_t i = 0; i < 3; ++i) triangle[i] = static_cast<std::int32_t>(simplex[i]);
        }
        return fast::improper_triangles(doubles->values(), triangles);
      };
}

}  // namespace circumspect::check
