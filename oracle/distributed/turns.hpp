// Ranks within one process that cannot hold the whole mesh in memory: the process works on one part
// after the other, and keeps the data of waiting parts in files.
#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>

#include "oracle/distributed/ranks.hpp"

namespace circumspect::distributed {

struct Turns {
  std::size_t parts = 1;
  std::size_t at_once = 1;   // threads; so many parts are in memory
  std::size_t room = 0;      // bytes that all parts together may have in transit; 0: no limit
  std::string folder = "/";  // the folder of the anonymous files
  std::size_t few = std::size_t{1} << 15;  // as in Ranks
};

// Thrown if the parts' arrays do not fit the folder's disk.
struct NoRoomOnDisk : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Calls work(ranks) for each part, on a thread of its own. A part runs until it needs something
// from the others; then it is the next part's turn. While a part waits, its large arrays, those
// with memory from std::pmr::get_default_resource(), are only in files. Returns when all parts have
// ended; if one of them throws, all end, and this throws the same exception. Throws NoRoomOnDisk.
// Requires: parts ≥ 1, at_once ≥ 1; no other thread calls this or sets the default resource
// meanwhile.
void in_turns(const Turns& turns, const std::function<void(Ranks&)>& work);

}  // namespace circumspect::distributed
