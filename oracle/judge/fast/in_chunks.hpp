// Works on ranges of a list with one thread or several. The answer does not depend on which thread does what.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

namespace circumspect::fast {

inline std::size_t chunks_of(std::size_t count, std::size_t size) {
  return (count + size - 1) / size;
}

// What is done with a chunk: its number, its first item and the one after its last.
// A std::function: with oneTBB's templates for each piece of work the compiler took a sixth longer, and a chunk is so
// large that the call takes no time.
using ChunkWork = std::function<void(std::size_t chunk, std::size_t first, std::size_t last)>;

// Calls work(chunk, first, last) for each chunk of `size` items, the last one shorter.
// Requires: threads ≥ 1; calls for different chunks do not disturb each other.
// What one of them throws is thrown here, and the other chunks may not have been worked on.
void in_chunks(std::size_t count, std::size_t size, unsigned threads, const ChunkWork& work);

// Are numbers finite?
bool are_finite(std::span<const double> numbers, unsigned threads);

}  // namespace circumspect::fast
