// Ranks within one process that cannot hold the whole mesh in memory: the process works on one part after the other,
// and keeps the data of the others in files.
#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>

#include "oracle/distributed/ranks.hpp"

namespace circumspect::distributed {

struct Turns {
  std::size_t parts = 1;
  std::size_t at_once = 1;  // threads; so many parts are in memory
  std::size_t room =
      0;  // bytes that all parts together may have on their way; 0: as many as they like
  std::string folder = "/";                // in it the files are, which have no names
  std::size_t few = std::size_t{1} << 15;  // as in Ranks
};

// The parts' arrays do not fit the folder.
struct NoRoomOnDisk : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Calls work(ranks) for each part, on a thread of its own. A part goes on until it has to hear from the others; only
// then is it the next one's turn. Meanwhile its large arrays, those that std::pmr::get_default_resource() has
// the memory for, are in files alone. Returns when all parts have ended; if one of them throws, all end, and
// this throws the same. Throws NoRoomOnDisk. Requires: parts ≥ 1, at_once ≥ 1; nobody else calls this meanwhile, or
// sets the default resource.
void in_turns(const Turns& turns, const std::function<void(Ranks&)>& work);

}  // namespace circumspect::distributed
