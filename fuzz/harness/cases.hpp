// The inputs of a run in process: which case comes how, and from which family.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "inputs/families.hpp"

namespace circumspect::harness {

// The families with these names; of none, all those of the dimension that have distinct points, and
// weights if they are claimed. Throws std::invalid_argument: a name that is unknown, or a family that
// does not exist in the dimension.
std::vector<const generators::Family*> chosen_families(const std::vector<std::string>& names,
                                                       std::size_t dimension, bool weighted);

struct DrawnCase {
  std::string family;
  std::uint64_t seed = 0;
  generators::PointsCase set;  // of doubles
};

// Case number `index` of a run, the families in turn.
DrawnCase drawn_case(const std::vector<const generators::Family*>& families, std::size_t dimension,
                     std::size_t max_points, std::uint64_t run_seed, std::uint64_t index);

// A number made of two that is unlike those of their neighbours.
std::uint64_t mixed_seed(std::uint64_t run_seed, std::uint64_t index);

}  // namespace circumspect::harness
