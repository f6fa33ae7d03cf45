// Programs under test end in many ways; each has its own outcome, and none ends the test.
#include "fuzz/harness/answer.hpp"

#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include <doctest/doctest.h>
#include <fcntl.h>
#include <unistd.h>

namespace circumspect::harness {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

const PointArray kPoints{2, {0, 0, 1, 0, 0, 1}, {}};

Answer isolated(const Triangulator& subject, std::chrono::milliseconds limit = 20'000ms) {
  return isolated_answer(subject, kPoints, limit);
}

[[noreturn]] void wait_for_ever() {
  while (true) std::this_thread::sleep_for(1s);
}

// Closes every end of a pipe that the process has beyond the standard streams.
void close_all() {
  for (int file = 3; file < 256; ++file) close(file);
}

TEST_CASE("what it returns arrives, rows of any length and indices of any size") {
  const SimplexArray rows = {{0, 1, 2}, {}, {-1}, {INT64_MIN, INT64_MAX, 7, 7}};
  const Triangulator subject = [&](const PointArray& points) {
    CHECK(points.size() == 3);
    return rows;
  };
  CHECK(answer(subject, kPoints).simplices == rows);
  CHECK(answer(subject, kPoints).failure.empty());
  const Answer given = isolated(subject);
  CHECK(given.simplices == rows);
  CHECK(given.failure.empty());
  CHECK(isolated([](const PointArray&) { return SimplexArray(); }).failure.empty());
  const SimplexArray many(100'000, {1, 2, 3, 4});
  CHECK(isolated([&](const PointArray&) { return many; }).simplices == many);
}

TEST_CASE("what it throws is a crash with its text") {
  const Triangulator throws = [](const PointArray&) -> SimplexArray {
    throw std::runtime_error("no seed triangle");
  };
  const Triangulator throws_a_number = [](const PointArray&) -> SimplexArray { throw 7; };
  for (const bool apart : {false, true}) {
    const Answer given = apart ? isolated(throws) : answer(throws, kPoints);
    CHECK(given.failure == "crash");
    CHECK(given.text == "no seed triangle");
    const Answer other = apart ? isolated(throws_a_number) : answer(throws_a_number, kPoints);
    CHECK(other.failure == "crash");
    CHECK(other.text.find("not a std::exception") != std::string::npos);
  }
}

TEST_CASE("a signal and an exit are named") {
  const Answer killed = isolated([](const PointArray&) -> SimplexArray {
    raise(SIGSEGV);
    return {};
  });
  CHECK(killed.failure == "signal 11");
  const Answer aborted = isolated([](const PointArray&) -> SimplexArray { std::abort(); });
  CHECK(aborted.failure == "signal 6");
  const Answer left = isolated([](const PointArray&) -> SimplexArray { std::exit(3); });
  CHECK(left.failure == "exit 3");
  const Answer quit = isolated([](const PointArray&) -> SimplexArray { _exit(0); });
  CHECK(quit.failure == "exit 0");
}

TEST_CASE("what never ends is a hang, and is killed") {
  const auto start = Clock::now();
  CHECK(isolated([](const PointArray&) -> SimplexArray { wait_for_ever(); }, 200ms).failure ==
        "hang");
  SUBCASE("also if it closes the pipe and lives on") {
    const Triangulator closes = [](const PointArray&) -> SimplexArray {
      close_all();
      wait_for_ever();
    };
    CHECK(isolated(closes, 200ms).failure == "hang");
  }
  SUBCASE("also if it ignores every signal that can be ignored") {
    const Triangulator deaf = [](const PointArray&) -> SimplexArray {
      for (int number = 1; number < 32; ++number) std::signal(number, SIG_IGN);
      wait_for_ever();
    };
    CHECK(isolated(deaf, 200ms).failure == "hang");
  }
  CHECK(Clock::now() - start < 30s);
}

TEST_CASE("processes that it leaves behind end with it") {
  const Triangulator forks = [](const PointArray&) -> SimplexArray {
    if (fork() == 0) {
      close_all();
      wait_for_ever();
    }
    return {{0, 1, 2}};
  };
  // The process left behind held no end of the pipe, so the answer counts.
  CHECK(isolated(forks).failure.empty());
  const Triangulator keeps_the_pipe = [](const PointArray&) -> SimplexArray {
    if (fork() == 0) wait_for_ever();
    _exit(0);
  };
  CHECK(isolated(keeps_the_pipe, 200ms).failure == "hang");
}

TEST_CASE("what sends too much is stopped") {
  const Triangulator endless = [](const PointArray&) -> SimplexArray {
    return {std::vector<std::int64_t>(9'000'000, 1)};
  };
  CHECK(isolated(endless).failure == "too-much-output");
}

TEST_CASE("no file and no process is left when many programs have run") {
  for (int i = 0; i < 120; ++i) {
    const Answer given = isolated([](const PointArray&) -> SimplexArray { _exit(1); });
    REQUIRE(given.failure == "exit 1");
  }
  const int file = open("/dev/null", O_RDONLY);
  CHECK(file < 100);
  close(file);
}

}  // namespace
}  // namespace circumspect::harness
