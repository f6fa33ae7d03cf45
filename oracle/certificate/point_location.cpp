#include "oracle/certificate/point_location.hpp"

#include <cassert>

#include "oracle/certificate/sidedness.hpp"

namespace circumspect::certificate {
namespace {

std::span<const Vertex> vertices_of(const Certificate& certificate, std::size_t simplex) {
  const std::size_t size = certificate.points.dimension + 1;
  return std::span<const Vertex>(certificate.simplices[simplex].vertices).first(size);
}

}  // namespace

std::uint32_t simplex_that_contains(const Certificate& certificate, Vertex point,
                                    std::uint32_t start) {
  Sidedness sidedness(certificate.points);
  const HomogeneousPoint q = barycentre(certificate.points, {point});
  // Where the claim is about balls, the walk ends in the simplex that contains the point; in other
  // triangulations it could go round in circles.
  std::uint32_t current = start;
  for (std::size_t steps = 0; steps <= certificate.simplices.size(); ++steps) {
    const auto place = sidedness.separating_place(vertices_of(certificate, current), 1, q);
    if (!place) return current;
    const Across& across = certificate.simplices[current].across[*place];
    assert(across.place != Across::kHull);
    current = across.cell;
  }
  for (current = 0; current < certificate.simplices.size(); ++current) {
    if (!sidedness.separating_place(vertices_of(certificate, current), 1, q)) return current;
  }
  assert(false);
  return start;
}

}  // namespace circumspect::certificate
