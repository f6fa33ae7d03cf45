#include "oracle/judge/complex/findings.hpp"

#include <algorithm>
#include <numeric>
#include <set>

#include "kernel/complex/point_set.hpp"
#include "kernel/predicates/orientation.hpp"
#include "oracle/judge/complex/adjacency.hpp"
#include "oracle/judge/complex/by_boundary.hpp"
#include "oracle/judge/complex/improper_pairs.hpp"

namespace circumspect::check {
namespace {

using definition::ListedComplex;
using definition::SetApart;

std::size_t dimension(const ListedComplex& listed) {
  return listed.points.empty() ? 0 : listed.points.front().size();
}

std::vector<Simplex> compared(const SetApart& apart) {
  std::vector<Simplex> simplices;
  simplices.reserve(apart.compared.size());
  for (const std::size_t s : apart.compared) simplices.push_back(apart.merged[s]);
  return simplices;
}

bool is_flat(const Configuration& points, const Simplex& simplex) {
  if (simplex.size() != points.ambient_dimension() + 1) {
    return axes_of(points, simplex).size() + 1 < simplex.size();
  }
  return points.dimension() + 1 < static_cast<int>(simplex.size()) ||
         orientation(points, simplex) == 0;
}

std::vector<int> signs(const Configuration& points, const std::vector<Simplex>& simplices) {
  std::vector<std::size_t> axes(points.ambient_dimension());
  std::iota(axes.begin(), axes.end(), std::size_t{0});
  // From the last vertex to the first, the determinant changes its sign in odd dimensions.
  const int from_first = axes.size() % 2 == 0 ? 1 : -1;
  std::vector<int> signs;
  signs.reserve(simplices.size());
  for (const Simplex& simplex : simplices) {
    signs.push_back(from_first * orientation(points, axes, simplex));
  }
  return signs;
}

void take_signs(std::vector<int> signs, Findings& found) {
  found.signs = std::move(signs);
  found.positive = static_cast<std::size_t>(std::count(found.signs.begin(), found.signs.end(), 1));
  found.negative = found.signs.size() - found.positive;
}

}  // namespace

SetApart sorted_apart(const ListedComplex& listed, const Configuration& points, std::size_t size) {
  SetApart apart;
  apart.equal_points = duplicates(listed.points);
  std::vector<Vertex> first(listed.points.size());
  std::iota(first.begin(), first.end(), Vertex{0});
  for (const auto& [kept, again] : apart.equal_points)
    first[static_cast<std::size_t>(again)] = kept;
  std::vector<bool> is_used(listed.points.size(), false);
  std::set<Simplex> known;
  for (std::size_t s = 0; s < listed.simplices.size(); ++s) {
    Simplex simplex = listed.simplices[s];
    bool names_points = true;
    for (Vertex& v : simplex) {
      const bool is_point = v >= 0 && v < std::ssize(first);
      names_points &= is_point;
      if (!is_point) continue;
      is_used[static_cast<std::size_t>(v)] = true;
      v = first[static_cast<std::size_t>(v)];
    }
    apart.merged.push_back(simplex);
    if (!names_points || simplex.size() != size || simplex.empty()) {
      apart.not_simplices.push_back(s);
    } else if (has_repeated_vertex(simplex)) {
      apart.repeating.push_back(s);
    } else if (is_flat(points, simplex)) {
      apart.flat.push_back(s);
    } else if (!known.insert(sorted(simplex)).second) {
      apart.doubled.push_back(s);
    } else {
      apart.compared.push_back(s);
    }
  }
  for (std::size_t v = 0; v < is_used.size(); ++v) {
    if (!is_used[v]) apart.unused_points.push_back(static_cast<Vertex>(v));
  }
  return apart;
}

std::size_t size_of_simplices(const ListedComplex& listed) {
  std::size_t size = 0;
  for (const Simplex& simplex : listed.simplices) {
    if (simplex.size() <= dimension(listed) + 1) size = std::max(size, simplex.size());
  }
  return size;
}

Findings findings_by_definition(const ListedComplex& listed, const ComplexDemands& demands) {
  Findings found;
  const std::size_t size = size_of_simplices(listed);
  found.apart = definition::set_apart(listed, size);
  found.improper = definition::improper_pairs(listed, found.apart);
  const std::vector<Simplex> simplices = compared(found.apart);
  found.open_facets = definition::open_facets(simplices);
  found.boundary_facets = found.open_facets.size();
  found.parts = definition::parts(simplices);
  found.part_of = part_of_each(simplices, facet_uses(simplices));
  if (size == dimension(listed) + 1) {
    take_signs(definition::orientation_signs(listed.points, simplices), found);
  } else {
    found.inconsistent = definition::inconsistent_facets(simplices);
  }
  if (demands.manifold) found.not_manifold = definition::not_manifold(simplices);
  return found;
}

Findings findings_by_lemma(const ListedComplex& listed, const ComplexDemands& demands,
                           const ImproperAmong& improper_among) {
  Findings found;
  const std::size_t size = size_of_simplices(listed);
  const Configuration points(listed.points);
  found.apart = sorted_apart(listed, points, size);
  const std::vector<Simplex> simplices = compared(found.apart);
  const std::vector<FacetUse> uses = facet_uses(simplices);
  const bool is_full = size == dimension(listed) + 1;
  std::vector<std::size_t> among(simplices.size());
  std::iota(among.begin(), among.end(), std::size_t{0});
  if (is_full) {
    among = left_out_of_complex(points, listed.points, simplices);
  } else if (improper_among) {
    if (auto known = improper_among(simplices)) among = *std::move(known);
  }
  if (!among.empty()) found.improper = improper_pairs(points, listed, found.apart, among);
  found.open_facets = open_facets(uses);
  found.boundary_facets = found.open_facets.size();
  found.part_of = part_of_each(simplices, uses);
  found.parts = std::set<std::size_t>(found.part_of.begin(), found.part_of.end()).size();
  if (is_full) {
    take_signs(signs(points, simplices), found);
  } else {
    found.inconsistent = inconsistent_facets(simplices, uses);
  }
  if (demands.manifold) found.not_manifold = not_manifold(simplices, uses);
  return found;
}

Findings findings_of_part(const ListedComplex& part, const std::vector<bool>& may_be_improper) {
  Findings found;
  const Configuration points(part.points);
  found.apart = sorted_apart(part, points, dimension(part) + 1);
  std::vector<std::size_t> among;
  for (std::size_t i = 0; i < found.apart.compared.size(); ++i) {
    if (may_be_improper[found.apart.compared[i]]) among.push_back(i);
  }
  if (!among.empty()) found.improper = improper_pairs(points, part, found.apart, among);
  take_signs(signs(points, compared(found.apart)), found);
  return found;
}

}  // namespace circumspect::check
