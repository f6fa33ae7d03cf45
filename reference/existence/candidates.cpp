#include "reference/existence/candidates.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "reference/kernel/predicates/in_ball.hpp"
#include "reference/kernel/predicates/orientation.hpp"

namespace circumspect::existence {
namespace {

bool is_degenerate(const PiecewiseLinearComplex& complex, const Simplex& simplex) {
  return axes_of(complex.points.configuration(), simplex).size() + 1 < simplex.size();
}

// The simplices of one dimension more whose facets are all among these, and which respect the
// complex. A face of a simplex that respects a complex does so too, and the domain is closed.
std::vector<Simplex> grown(const PiecewiseLinearComplex& complex, const Regions& regions,
                           const std::vector<Simplex>& simplices) {
  const std::set<Simplex> faces(simplices.begin(), simplices.end());
  std::vector<Simplex> larger;
  for (const Simplex& simplex : simplices) {
    for (Vertex v = simplex.back() + 1; complex.points.names(v); ++v) {
      Simplex candidate = simplex;
      candidate.push_back(v);
      bool has_facets = true;
      for (std::size_t place = 0; place < candidate.size() && has_facets; ++place) {
        has_facets = faces.contains(facet_opposite(candidate, place));
      }
      if (has_facets && !is_degenerate(complex, candidate) &&
          respects(complex, regions, candidate)) {
        larger.push_back(candidate);
      }
    }
  }
  return larger;
}

bool is_constrained_delaunay(const PiecewiseLinearComplex& complex, const Regions& regions,
                             const Simplex& tetrahedron) {
  for (Vertex v = 0; complex.points.names(v); ++v) {
    if (!contains(tetrahedron, v) &&
        in_ball(complex.points.configuration(), kSpace, tetrahedron, v) > 0 &&
        is_visible(complex, regions, v, tetrahedron)) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::vector<Simplex> respecting_tetrahedra(const PiecewiseLinearComplex& complex,
                                           const Regions& regions) {
  std::vector<Simplex> simplices;
  for (Vertex v = 0; complex.points.names(v); ++v) simplices.push_back({v});
  for (int dimension = 1; dimension <= 3; ++dimension) {
    simplices = grown(complex, regions, simplices);
  }
  return simplices;
}

std::vector<Simplex> constrained_delaunay_tetrahedra(const PiecewiseLinearComplex& complex,
                                                     const Regions& regions) {
  std::vector<Simplex> tetrahedra = respecting_tetrahedra(complex, regions);
  std::erase_if(tetrahedra, [&](const Simplex& tetrahedron) {
    return !is_constrained_delaunay(complex, regions, tetrahedron);
  });
  return tetrahedra;
}

}  // namespace circumspect::existence
