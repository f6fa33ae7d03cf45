// Processes ranges of a list with one thread or several. The answer does not depend on which thread
// does what.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

namespace circumspect::fast {

inline std::size_t chunks_of(std::size_t count, std::size_t size) {
  return (count + size - 1) / size;
}

// The work on a chunk, given its number, its first item and the one after its last. It is a
// std::function, because oneTBB's templates for each piece of work make compilation a sixth longer,
// and chunks are so large that the call costs nothing.
using ChunkWork = std::function<void(std::size_t chunk, std::size_t first, std::size_t last)>;

// Calls work(chunk, first, last) for each chunk of `size` items, the last one shorter.
// Requires: threads ≥ 1; calls for different chunks are independent. If one of them throws, this
// throws the same exception, and other chunks may not have been processed.
void in_chunks(std::size_t count, std::size_t size, unsigned threads, const ChunkWork& work);

// Are numbers finite?
bool are_finite(std::span<const double> numbers, unsigned threads);

}  // namespace circumspect::fast
