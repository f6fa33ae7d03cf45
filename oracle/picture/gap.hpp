// Where a list of facets of a hull ends (rule hull.uncovered): the gap, to be hatched.
#pragma once

#include <vector>

#include "oracle/model/mesh.hpp"

namespace circumspect::picture {

// The corners of the gap at a ridge that one facet alone has. In space they are those of such
// ridges, one after the other around the gap. In the plane they lead from the ridge along the
// boundary of the hull to the next vertex of a facet. None if the list is broken in another way,
// too. Requires: points of two or three coordinates; `facet` has the ridge; `bare` are all such
// ridges.
Simplex gap_at(const Mesh& mesh, const Simplex& facet, const Simplex& ridge,
               const std::vector<Simplex>& bare);

}  // namespace circumspect::picture
