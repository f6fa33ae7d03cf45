// What lies around witnesses: the few simplices and facets of a mesh that a picture of one needs beside it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "oracle/model/domain.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::picture {

struct Surroundings {
  // Of simplices and listed faces those that share most vertices with the witness, then those whose box
  // holds one of its places; none that is the witness's own. As many as have room.
  std::vector<Simplex> near = {};
  std::size_t left_out = 0;  // how many more there are
};

// Of each witness, in their order. It takes the mesh once from end to end, however many there are. Places
// are compared in doubles: what is near decides nothing.
std::vector<Surroundings> surroundings(std::span<const Witness> witnesses, const Mesh& mesh,
                                       const Domain* domain, std::size_t room);

// The facets that belong to one simplex alone. Simplices with indices that name no point are left out.
std::vector<Simplex> boundary(const Mesh& mesh);

}  // namespace circumspect::picture
