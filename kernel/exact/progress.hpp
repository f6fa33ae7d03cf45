// How far long work has come, for whoever waits for it.
#pragma once

#include <cstddef>
#include <functional>

namespace circumspect {

// Called now and then with what is being counted ("points inserted"), how many of these are done, and how
// many there will be; 0 if nobody knows. `what` is a literal, and lives on. Who is called must be quick.
using Progress = std::function<void(const char* what, std::size_t done, std::size_t of)>;

// Nobody need be waiting.
inline void tell(const Progress& progress, const char* what, std::size_t done, std::size_t of = 0) {
  if (progress) progress(what, done, of);
}

}  // namespace circumspect
