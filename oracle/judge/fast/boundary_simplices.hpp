// Which simplices have a facet without a link: a bit each, set by any number of threads, block by
// block.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "oracle/judge/fast/block.hpp"
#include "oracle/judge/fast/facet_id.hpp"
#include "oracle/judge/fast/in_chunks.hpp"
#include "oracle/judge/fast/mesh_view.hpp"

namespace circumspect::fast {

class BoundarySimplices {
 public:
  explicit BoundarySimplices(std::size_t simplices) : blocks_(chunks_of(simplices, kBlock)) {}

  // Bit i of `bits`: simplex `block` · kBlock + i.
  void set(std::size_t block, std::uint32_t bits) { blocks_[block] = bits; }

  // Their facets without a link in simplices `first` to `last` − 1, ascending. Requires: first is a multiple of kBlock.
  template <std::size_t kVertices, typename Link>
  std::vector<FacetId> facets(Links<Link> links, std::size_t first, std::size_t last) const {
    std::vector<FacetId> facets;
    for (std::size_t block = first / kBlock; block * kBlock < last; ++block) {
      for (std::uint32_t bits = blocks_[block]; bits != 0; bits &= bits - 1) {
        const std::size_t s = block * kBlock + static_cast<std::size_t>(std::countr_zero(bits));
        for (std::size_t place = 0; place < kVertices; ++place) {
          if (links[s * kVertices + place] < 0) facets.emplace_back(s, place);
        }
      }
    }
    return facets;
  }

 private:
  static_assert(kBlock == 32);
  std::vector<std::uint32_t> blocks_;
};

}  // namespace circumspect::fast
