// The orientations of all simplices: one for all, as most programs write them, or one bit each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace circumspect::fast {

class Orientations {
 public:
  explicit Orientations(int all) : all_(all) {}
  // Bit s of `negative` says that simplex s is negatively oriented.
  explicit Orientations(std::vector<std::uint64_t> negative)
      : all_(0), negative_(std::move(negative)) {}

  bool are_equal() const { return all_ != 0; }
  int of(std::size_t s) const {
    if (all_ != 0) return all_;
    return (negative_[s / 64] >> (s % 64) & 1) != 0 ? -1 : 1;
  }

 private:
  int all_;
  std::vector<std::uint64_t> negative_;
};

}  // namespace circumspect::fast
