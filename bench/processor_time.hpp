// Processor time: other programs on the machine do not count.
#pragma once

#include <ctime>

namespace circumspect::bench {

template <typename Work>
double seconds(const Work& work) {
  const std::clock_t begin = std::clock();
  work();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

}  // namespace circumspect::bench
