// Which simplices of two large meshes are not worth comparing one by one: those that both list
// equally often.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "oracle/model/index_lists.hpp"

namespace circumspect::check {

// The places of the simplices of a and of b, ascending, whose sets of vertices the other mesh lists
// more or less often. A simplex of a with a vertex that is in no simplex of b is among them.
struct UnlikeRows {
  std::vector<std::size_t> of_a = {};
  std::vector<std::size_t> of_b = {};
};

// `place_in_b`: for each point of a the equal point of b, or −1. None if simplices are not in rows,
// or those of a have more vertices or fewer than those of b, or if there are more than 2^31 points
// or simplices, or if their hashes collide too often.
std::optional<UnlikeRows> unlike_rows(const IndexLists& a, const IndexLists& b,
                                      const std::vector<Vertex>& place_in_b,
                                      std::size_t points_of_b);

}  // namespace circumspect::check
