// A list that threads make chunk by chunk.
#pragma once

#include <cstddef>
#include <vector>

#include "oracle/judge/fast/in_chunks.hpp"
#include "oracle/judge/fast/sweep.hpp"

namespace circumspect::fast {

// Returns, in order, what look(i, list, stages) adds to the list for each i below `count`, and adds
// up the stages. The same for any number of threads.
template <class Item, class Look>
std::vector<Item> list_in_chunks(std::size_t count, unsigned threads, Stages& all_stages,
                                 const Look& look) {
  constexpr std::size_t kChunk = std::size_t{1} << 12;
  std::vector<std::vector<Item>> parts(chunks_of(count, kChunk));
  std::vector<Stages> stages(parts.size());
  in_chunks(count, kChunk, threads, [&](std::size_t chunk, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) look(i, parts[chunk], stages[chunk]);
  });
  std::vector<Item> all;
  for (std::size_t chunk = 0; chunk < parts.size(); ++chunk) {
    all.insert(all.end(), parts[chunk].begin(), parts[chunk].end());
    all_stages = sum(all_stages, stages[chunk]);
  }
  return all;
}

}  // namespace circumspect::fast
