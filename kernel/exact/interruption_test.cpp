// Work ends when asked to, in the thread that is asked; later work is not affected.
#include "kernel/exact/interruption.hpp"

#include <chrono>
#include <thread>
#include <vector>

#include <doctest/doctest.h>

#include "kernel/exact/linear_algebra.hpp"

namespace circumspect {
namespace {

TEST_CASE("nothing is interrupted unless somebody asks") {
  CHECK_NOTHROW(end_if_interrupted());
  std::int32_t stop = 0;
  const Interruption by{&stop};
  const Interruptible interruptible(&by);
  CHECK_NOTHROW(end_if_interrupted());
  stop = 1;
  CHECK_THROWS_AS(end_if_interrupted(), Interrupted);
  {
    const Interruptible undisturbed(nullptr);
    CHECK_NOTHROW(end_if_interrupted());
  }
  CHECK_THROWS_AS(end_if_interrupted(), Interrupted);
  std::jthread([] { CHECK_NOTHROW(end_if_interrupted()); }).join();
}

TEST_CASE("determinants, systems of equations and linear programs ask") {
  const std::int32_t stop = 1;
  const Interruption by{&stop};
  const Interruptible interruptible(&by);
  CHECK_THROWS_AS(determinant(SquareMatrix(2)), Interrupted);
  CHECK_THROWS_AS(determinant(SquareMatrix(5)), Interrupted);
  const std::vector<Rational> one(1, Rational(1));
  const RationalMatrix matrix(1, one);
  CHECK_THROWS_AS(solve(matrix, one), Interrupted);
  CHECK_THROWS_AS(maximize({matrix, one, one}), Interrupted);
}

TEST_CASE("a deadline ends work soon after it, and says that it was late") {
  using Clock = std::chrono::steady_clock;
  const Interruption later{nullptr, Clock::now() + std::chrono::hours(1)};
  const Interruption past{nullptr, Clock::now() - std::chrono::hours(1)};
  const auto asks_often = [](const Interruption& by) {
    const Interruptible interruptible(&by);
    for (int i = 0; i < 1000; ++i) end_if_interrupted();
  };
  CHECK_NOTHROW(asks_often(later));
  try {
    asks_often(past);
    FAIL("it was not interrupted");
  } catch (const Interrupted& interrupted) {
    CHECK(interrupted.is_late);
  }
}

}  // namespace
}  // namespace circumspect
