// The whole mesh in one picture, and where on it the violations are.
#pragma once

#include <cstddef>

#include "oracle/model/domain.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/verdict.hpp"
#include "oracle/report/json.hpp"

namespace circumspect::picture {

// As JSON for the page, in the frame of the mesh's bounding box, whose longest side goes from
// −1 to 1:
//   mark         "whole", which tells it from the picture of a witness
//   dimension    of the points, 2 or 3
//   points       the places of violations first, `core` of them, then the corners of the skin
//   marks        of each place the violations there, counted from 0; places so near that their
//                marks would cover each other share one
//   skin         triangles, by their corners' places among `points`: all of a mesh of triangles,
//                else the boundary of the tetrahedra
//   coarser      true if the skin has too many triangles to be drawn one by one: corners in one
//                cell of a grid are then drawn as one
// Places are those of the first `shown` violations. Null where a picture of a witness shows the
// whole mesh anyway, and of meshes that have no skin, or whose box is beyond doubles.
report::Json overview(const Verdict& verdict, const Mesh& mesh, const Domain* domain,
                      std::size_t shown);

}  // namespace circumspect::picture
