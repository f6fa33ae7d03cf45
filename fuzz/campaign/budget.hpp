// How often and how long minimising may still ask.
#pragma once

#include "fuzz/campaign/minimise.hpp"

namespace circumspect::campaign {

class Budget {
 public:
  explicit Budget(const MinimiseLimits& limits) : limits_(limits) {}

  bool is_spent() const {
    return tries_ >= limits_.tries || std::chrono::steady_clock::now() - start_ >= limits_.time;
  }
  // Counts a try; false if there is none left.
  bool take() {
    if (is_spent()) return false;
    ++tries_;
    return true;
  }

 private:
  MinimiseLimits limits_;
  std::size_t tries_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace circumspect::campaign
