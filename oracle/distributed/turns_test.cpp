#include "oracle/distributed/turns.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory_resource>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <doctest/doctest.h>
#include <sys/mman.h>
#include <sys/resource.h>

namespace circumspect::distributed {
namespace {

// Two megabytes: an array that large is kept in a file.
constexpr std::size_t kMany = std::size_t{1} << 18;

std::uint64_t number(std::size_t part, std::size_t i) { return 1000 * (part + 1) + i; }

std::pmr::vector<std::uint64_t> large_array(std::size_t part) {
  std::pmr::vector<std::uint64_t> array(kMany);
  for (std::size_t i = 0; i < kMany; ++i) array[i] = number(part, i);
  return array;
}

// The files of a folder that this process has mapped, and how much of them is in memory.
struct Mapped {
  std::size_t files = 0, kilobytes = 0;
};
Mapped mapped(const std::string& folder) {
  std::ifstream maps("/proc/self/smaps");
  Mapped all;
  bool is_of_folder = false;
  for (std::string line; std::getline(maps, line);) {
    if (line.find('-') < line.find(':')) {  // the line of addresses, before those about them
      is_of_folder = line.find(" " + folder + "/") != std::string::npos;
      all.files += is_of_folder ? 1 : 0;
    } else if (is_of_folder && line.starts_with("Rss:")) {
      all.kilobytes += std::stoul(line.substr(4));
    }
  }
  return all;
}

std::size_t open_files() {
  return static_cast<std::size_t>(
      std::distance(std::filesystem::directory_iterator("/proc/self/fd"), {}));
}

std::string failure_of(const Turns& turns, const std::function<void(Ranks&)>& work) {
  try {
    in_turns(turns, work);
  } catch (const std::runtime_error& failure) {
    return failure.what();
  }
  return "none";
}

// While this object lives, a file that would grow beyond so many bytes has no room for them.
class FilesOfAtMost {
 public:
  explicit FilesOfAtMost(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit = {bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FilesOfAtMost() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FilesOfAtMost(const FilesOfAtMost&) = delete;
  FilesOfAtMost& operator=(const FilesOfAtMost&) = delete;

 private:
  rlimit before_ = {};
  void (*handler_)(int);
};

TEST_CASE("turns: every part hears what the others say, however few are at work at once") {
  constexpr std::size_t kParts = 5;
  for (const std::size_t at_once : {std::size_t{1}, std::size_t{2}, kParts}) {
    CAPTURE(at_once);
    std::vector<std::vector<std::uint64_t>> heard(kParts);
    in_turns({.parts = kParts, .at_once = at_once, .folder = "/tmp"}, [&](Ranks& ranks) {
      const std::uint64_t own = std::array{12, 14, 10, 13, 11}[ranks.rank()];
      std::vector<std::uint64_t>& here = heard[ranks.rank()];
      here = {ranks.size(), ranks.sum(own), ranks.most(own), ranks.least(own)};
      here.push_back(ranks.first_with(ranks.rank() >= 3));
      here.push_back(ranks.first_with(false));
      here.push_back(ranks.of_rank(3, own));
      std::ranges::copy(ranks.of_each(own), std::back_inserter(here));
    });
    const std::vector<std::uint64_t> expected = {5, 60, 14, 10, 3, 5, 13, 12, 14, 10, 13, 11};
    for (std::size_t part = 0; part < kParts; ++part) CHECK(heard[part] == expected);
  }
}

TEST_CASE("turns: items reach the part that they are for, in the order of those who send them") {
  constexpr std::size_t kParts = 4;
  in_turns({.parts = kParts, .folder = "/tmp"}, [](Ranks& ranks) {
    const std::size_t own = ranks.rank();
    std::vector<std::vector<std::uint64_t>> out(kParts);
    for (std::size_t to = 0; to < kParts; ++to) out[to].assign(own * to, 10 * own + to);
    std::vector<std::uint64_t> from;
    const auto received = ranks.exchanged(std::move(out), &from);
    std::vector<std::uint64_t> expected, expected_from;
    for (std::size_t sender = 0; sender < kParts; ++sender) {
      expected_from.push_back(sender * own);
      expected.insert(expected.end(), sender * own, 10 * sender + own);
    }
    CHECK(received == expected);
    CHECK(from == expected_from);
  });
}

TEST_CASE("turns: no more parts are at work than are asked for") {
  for (const std::size_t at_once : {1, 2, 3}) {
    CAPTURE(at_once);
    std::atomic<std::size_t> at_work = 0, most = 0;
    in_turns({.parts = 6, .at_once = at_once, .folder = "/tmp"}, [&](Ranks& ranks) {
      for (int round = 0; round < 5; ++round) {
        const std::size_t now = ++at_work;
        std::size_t before = most;
        while (before < now && !most.compare_exchange_weak(before, now)) {
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        --at_work;
        ranks.any(false);
      }
    });
    CHECK(most <= at_once);
  }
}

TEST_CASE("turns: large arrays of parts that wait are only in files, which nobody else sees") {
  const std::string folder = std::filesystem::canonical("/tmp").string();
  const std::size_t open_before = open_files();
  in_turns({.parts = 3, .folder = folder}, [&](Ranks& ranks) {
    const auto array = large_array(ranks.rank());
    ranks.any(false);
    CHECK(mapped(folder).files == 3);
    CHECK(mapped(folder).kilobytes == 0);
    CHECK(open_files() == open_before);
    ranks.any(false);
    bool is_same = true;
    for (std::size_t i = 0; i < kMany; ++i) is_same &= array[i] == number(ranks.rank(), i);
    CHECK(is_same);
  });
  CHECK(mapped(folder).files == 0);
  CHECK(open_files() == open_before);
}

TEST_CASE("turns: parts that never wait for a turn, and small arrays, stay in memory") {
  const std::string folder = std::filesystem::canonical("/tmp").string();
  const auto files = [&](const Turns& turns, std::size_t size) {
    std::size_t most = 0;
    in_turns(turns, [&](Ranks& ranks) {
      const std::pmr::vector<char> array(size);
      ranks.any(false);
      if (ranks.is_first()) most = mapped(folder).files;
      ranks.any(false);
    });
    return most;
  };
  CHECK(files({.parts = 2, .at_once = 2, .folder = folder}, 1 << 20) == 0);
  CHECK(files({.parts = 2, .at_once = 1, .folder = folder}, (1 << 18) - 1) == 0);
  CHECK(files({.parts = 2, .at_once = 1, .folder = folder}, 1 << 18) == 2);
}

TEST_CASE("turns: what comes to be where an array was is not put away") {
  in_turns({.parts = 2, .folder = "/tmp"}, [](Ranks& ranks) {
    auto array = large_array(ranks.rank());
    void* place = array.data();
    array.clear();
    array.shrink_to_fit();
    const std::size_t bytes = kMany * sizeof(std::uint64_t);
    void* memory = mmap(place, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    REQUIRE(memory == place);
    std::fill_n(static_cast<char*>(memory), bytes, 'm');
    ranks.any(false);
    CHECK(std::count(static_cast<char*>(memory), static_cast<char*>(memory) + bytes, 'm') == bytes);
    munmap(memory, bytes);
  });
}

TEST_CASE("turns: a folder without room is an error that names it, and what to do") {
  const auto work = [](Ranks& ranks) { large_array(ranks.rank()); };
  CHECK(
      failure_of({.parts = 2, .folder = "/no/such folder"}, work) ==
      "expected room for 2097152 bytes more in /no/such folder, where --memory keeps what it puts "
      "away, found none: No such file or directory; TMPDIR names another folder");
  const FilesOfAtMost limit(1 << 20);
  CHECK(failure_of({.parts = 2, .folder = "/tmp"}, work) ==
        "expected room for 2097152 bytes more in /tmp, where --memory keeps what it puts away, "
        "found none: File too large; TMPDIR names another folder");
}

TEST_CASE("turns: what one part throws ends those that wait for it, and is thrown") {
  std::atomic<std::size_t> ended = 0;
  const auto work = [&](Ranks& ranks) {
    if (ranks.rank() == 2) throw std::runtime_error("the third part's");
    ranks.any(false);
    ++ended;
  };
  CHECK(failure_of({.parts = 4, .folder = "/tmp"}, work) == "the third part's");
  CHECK(failure_of({.parts = 4, .at_once = 4, .folder = "/tmp"}, work) == "the third part's");
  CHECK(ended == 0);
  CHECK(std::pmr::get_default_resource() == std::pmr::new_delete_resource());
}

}  // namespace
}  // namespace circumspect::distributed
