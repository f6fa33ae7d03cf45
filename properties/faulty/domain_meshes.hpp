// Right meshes of domains, to be spoilt.
#pragma once

#include <optional>

#include "oracle/model/exact_mesh.hpp"
#include "reference/constrained/split_segments.hpp"
#include "reference/kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect::faulty {

// A constrained Delaunay triangulation, with its dangling faces; nothing if there is none.
std::optional<ExactMesh> cdt_mesh(const PiecewiseLinearComplex& complex);

// The same of an input; nothing also if that is no domain of Definition 4.3.
std::optional<ExactMesh> cdt_of(const PiecewiseLinearInput& input);

// One of the complex with its segments split until they are strongly Delaunay.
struct SteinerMesh {
  ExactMesh mesh;
  std::vector<constrained::PointOnSegment> steiner_points;
};
SteinerMesh steiner_mesh(const PiecewiseLinearComplex& complex);

// A conforming Delaunay triangulation; nothing if so many Steiner points do not suffice.
std::optional<ExactMesh> conforming_mesh(const PiecewiseLinearComplex& complex,
                                         std::size_t most_steiner_points);

}  // namespace circumspect::faulty
