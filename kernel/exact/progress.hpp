// Reports the progress of long work to whoever waits for it.
#pragma once

#include <cstddef>
#include <functional>

namespace circumspect {

// Called now and then with what is being counted ("points inserted"), how many are done, and how
// many there will be; 0 if that is unknown. `what` is a string literal. The callback must be quick.
using Progress = std::function<void(const char* what, std::size_t done, std::size_t of)>;

// There may be no listener.
inline void tell(const Progress& progress, const char* what, std::size_t done, std::size_t of = 0) {
  if (progress) progress(what, done, of);
}

}  // namespace circumspect
