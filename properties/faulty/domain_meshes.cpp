#include "properties/faulty/domain_meshes.hpp"

#include <utility>

#include "reference/constrained/conforming_delaunay.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/constrained/planar_cdt.hpp"
#include "reference/constrained/steiner_cdt.hpp"
#include "reference/kernel/piecewise_linear/validity.hpp"

namespace circumspect::faulty {
namespace {

ExactMesh mesh_of(const PointSet& points, const constrained::PlcTriangulation& triangulation) {
  ExactMesh mesh{points, triangulation.simplices};
  for (const Simplex& simplex : triangulation.dangling) {
    if (simplex.size() > 1) mesh.faces.push_back(simplex);
  }
  return mesh;
}

}  // namespace

std::optional<ExactMesh> cdt_mesh(const PiecewiseLinearComplex& complex) {
  if (complex.ambient_dimension() == 2) {
    return mesh_of(complex.points, constrained::planar_cdt(complex));
  }
  const auto cdt = constrained::gift_wrapping_cdt(complex);
  if (!cdt) return std::nullopt;
  return mesh_of(complex.points, *cdt);
}

std::optional<ExactMesh> cdt_of(const PiecewiseLinearInput& input) {
  const auto complex = validated(input, 1);
  return complex ? cdt_mesh(*complex) : std::nullopt;
}

SteinerMesh steiner_mesh(const PiecewiseLinearComplex& complex) {
  constrained::RecoveredSegments recovered = constrained::recover_segments(complex);
  const constrained::PlcTriangulation cdt = constrained::cdt_of_edge_protected(recovered.complex);
  return {mesh_of(recovered.complex.points, cdt), std::move(recovered.steiner_points)};
}

std::optional<ExactMesh> conforming_mesh(const PiecewiseLinearComplex& complex,
                                         std::size_t most_steiner_points) {
  const auto conforming = constrained::conforming_delaunay(complex, most_steiner_points);
  if (!conforming) return std::nullopt;
  return mesh_of(conforming->complex.points, conforming->triangulation);
}

}  // namespace circumspect::faulty
