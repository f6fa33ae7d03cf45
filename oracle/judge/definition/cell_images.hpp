// What in a mesh M are the moved cells of a complex P? docs/theory/within.md, Definition 2 to 5.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include <tl/expected.hpp>

#include "kernel/piecewise_linear/linear_cell.hpp"
#include "kernel/piecewise_linear/regions.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::definition {

// P, M and what belongs to them. `used`: which points of M are vertices of it. `triangles_meant`:
// for each polygon triangles (ascending) that are to be its image if they can, or none.
struct MovedDomain {
  const PiecewiseLinearComplex& complex;
  const Regions& regions;
  const ExactMesh& mesh;
  const std::vector<bool>& used;
  std::vector<std::vector<Simplex>> triangles_meant;
};

// The cell that carries each point of M, if one does (Definition 1).
using Carriers = std::vector<std::optional<LinearCell>>;

// The triangles of M whose vertices have the polygon or faces of it for carriers.
std::vector<Simplex> triangles_near(const MovedDomain& moved, const Carriers& carriers,
                                    std::size_t polygon);

// Of each vertex of P a vertex of M, of each segment the edges of its path, from its first end to
// its second, of each polygon triangles, counterclockwise seen from the side to which its normal
// with a positive first nonzero coordinate points.
using CellImages = std::map<LinearCell, std::vector<Simplex>>;

// The images of all cells, or what is wrong with one. All sets of triangles near a polygon are
// tried.
// Requires: simplices and listed faces of M that are sound each by itself.
tl::expected<CellImages, Violation> cell_images(const MovedDomain& moved, const Carriers& carriers);

}  // namespace circumspect::definition
