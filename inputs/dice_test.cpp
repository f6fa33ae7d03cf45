// The guarantees of a seed: the same numbers on every machine, all equally likely.
#include "inputs/dice.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <doctest/doctest.h>

#include "inputs/cases.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "properties/arguments/generated.hpp"

namespace circumspect::generators {
namespace {

TEST_CASE("dice: splitmix64, by the numbers that its authors' program prints") {
  Dice dice(1234567);
  for (const std::uint64_t bits : {6457827717110365317U, 3203168211198807973U, 9817491932198370423U,
                                   4593380528125082431U, 16408922859458223821U}) {
    CHECK(dice.bits() == bits);
  }
}

TEST_CASE("dice: all numbers of a range, all equally often, whatever its length") {
  Dice dice(7);
  std::array<int, 11> often{};
  for (int i = 0; i < 11'000; ++i) ++often[static_cast<std::size_t>(dice.within(-5, 5) + 5)];
  for (const int times : often) CHECK(std::abs(times - 1000) < 150);
  // For a count of three quarters of 2^64, remainders would make the lowest third twice as likely.
  const std::size_t count = std::size_t{3} << 62;
  int low = 0;
  for (int i = 0; i < 9'000; ++i) low += dice.below(count) < (std::size_t{1} << 62) ? 1 : 0;
  CHECK(std::abs(low - 3000) < 200);
  CHECK(dice.below(1) == 0);
  CHECK(dice.within(3L, 3L) == 3);
}

// As `long` is on Windows: the ends may be farther apart than the largest of them.
TEST_CASE("dice: numbers of 32 bits are those that more bits would be") {
  for (const std::int32_t bound :
       {std::int32_t{1} << 30, std::numeric_limits<std::int32_t>::max()}) {
    Dice narrow(5), wide(5);
    for (int i = 0; i < 100; ++i) {
      CHECK(narrow.within(-bound, bound) == wide.within(-std::int64_t{bound}, std::int64_t{bound}));
    }
  }
}

}  // namespace
}  // namespace circumspect::generators
