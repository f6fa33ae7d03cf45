// P′: the complex that a domain became in a mesh. docs/theory/within.md, 5.
#pragma once

#include <optional>
#include <vector>

#include <tl/expected.hpp>

#include "kernel/piecewise_linear/regions.hpp"
#include "oracle/judge/within/image_set.hpp"
#include "oracle/model/domain.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

struct ImageComplex {
  // A valid complex whose points are points of the mesh. Its hole seeds say what is not inside;
  // they follow from the sides of the polygons of the domain. Its regions are known, unless sides
  // differ.
  Domain domain;
  std::vector<Vertex> in_mesh;  // the point of the mesh that each of its vertices is
  std::vector<std::size_t>
      polygons;  // the polygon of the domain that each of its polygons is part of
  // The polygons of the domain that have no inside beside them and no flat image: their triangles
  // are not held against each other.
  std::size_t not_flat_and_dangling = 0;
  // A wall, by its vertices in the complex, with a region on one side that has inside and outside
  // on its walls, if there is one; then the complex has no seeds.
  std::optional<Simplex> sides_differ = {};
};

// complex.overlap if images intersect: then the mesh is not a complex either. `regions` are those
// of the domain's complex. `moved`: of each point of the mesh that is in an image, may it be off
// the cell that carries it?
tl::expected<ImageComplex, Violation> image_complex(const ImageSet& images,
                                                    const std::vector<bool>& moved,
                                                    const ExactMesh& mesh, const Cells& cells,
                                                    const Regions& regions);

}  // namespace circumspect::check
