// The arguments of the fast predicates, and their counters.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace circumspect::fast {

// A point of the plane or of space, with its weight for weighted tests (others ignore it). Every
// number that a test uses must be finite.
template <std::size_t kDimension>
struct Site {
  std::array<double, kDimension> at;
  double weight = 0;
};

// The vertices of a simplex.
template <std::size_t kDimension>
using SiteRow = std::array<Site<kDimension>, kDimension + 1>;

// How often each stage decided a sign. The caller of the predicates owns it, one for each thread.
struct Stages {
  std::uint64_t filtered = 0;   // by doubles: beyond the proved bound, or without rounding
  std::uint64_t narrow = 0;     // by integers of 128 bits: differences on a small grid
  std::uint64_t fixed = 0;      // by integers of at most 320 bits: differences of at most 62 bits
  std::uint64_t wide = 0;       // by integers of at most 640 bits: differences of at most 126 bits
  std::uint64_t unbounded = 0;  // by integers of any size

  std::uint64_t exact() const { return narrow + fixed + wide + unbounded; }
  Stages& operator+=(const Stages& others) {
    filtered += others.filtered;
    narrow += others.narrow;
    fixed += others.fixed;
    wide += others.wide;
    unbounded += others.unbounded;
    return *this;
  }
  friend bool operator==(const Stages&, const Stages&) = default;
};

}  // namespace circumspect::fast
