// Parts that share a process take the place of ranks: each looks at a file of its own.
#include "oracle/distributed/shared_file.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "inputs/scratch_folder_test.hpp"
#include "oracle/distributed/turns.hpp"

namespace circumspect::distributed {
namespace {

// Three blocks and a bit: what a digest takes at a time is one.
std::string some_bytes() {
  std::string bytes(3 * 4096 + 5, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * i / 7);
  return bytes;
}

class Copies {
 public:
  std::string write(const std::string& bytes) {
    return folder_.write(std::to_string(++count_), bytes);
  }

 private:
  formats::ScratchFolder folder_;
  int count_ = 0;
};

// What the ranks say if rank i sees paths[i], and has counted rows[i]; they all say the same.
std::string said(const std::vector<std::string>& paths, std::vector<std::uint64_t> rows = {}) {
  rows.resize(paths.size(), 7);
  std::set<std::string> all;
  in_turns({.parts = paths.size(), .folder = "/tmp"}, [&](Ranks& ranks) {
    const std::size_t own = ranks.rank();
    const auto status = check_shared(ranks, paths[own], {rows[own], 3, 1});
    all.insert(status ? "shared" : status.error().expected + ", " + status.error().found);
  });
  CHECK(all.size() == 1);
  return *all.begin();
}

const std::string kExpected =
    "the same file at all ranks, as rank 0 has it (7 rows of 3 in 12293 bytes), ";

std::string other_bytes_at(std::size_t rank) {
  return kExpected + "another one at rank " + std::to_string(rank) +
         " (as large, with other bytes)";
}

TEST_CASE("shared file: one file, and copies of it, are the same at however many ranks") {
  Copies copies;
  const std::string a = copies.write(some_bytes()), b = copies.write(some_bytes());
  for (const std::vector<std::string>& paths : std::vector<std::vector<std::string>>{
           {a}, {a, a, a}, {a, b}, {a, b, b}, {a, b, a, b, b, b, b}}) {
    CAPTURE(paths.size());
    CHECK(said(paths) == "shared");
  }
}

TEST_CASE("shared file: a copy with any byte changed is another one, and its first rank is named") {
  Copies copies;
  const std::string a = copies.write(some_bytes());
  std::vector<std::size_t> places = {4095, 4096, 8191, 3 * 4096, 3 * 4096 + 4};
  for (std::size_t at = 0; at < 20; ++at) places.push_back(at);
  for (const std::size_t at : places) {
    CAPTURE(at);
    std::string bytes = some_bytes();
    bytes[at] ^= 1;
    const std::string b = copies.write(bytes);
    CHECK(said({a, b, a}) == other_bytes_at(1));
    CHECK(said({a, a, b}) == other_bytes_at(2));
    CHECK(said({a, a, b, b, a}) == other_bytes_at(2));
    CHECK(said({a, b, b, b}) == other_bytes_at(1));
  }
}

TEST_CASE("shared file: a copy with blocks or words in another order is another one") {
  Copies copies;
  const std::string a = copies.write(some_bytes());
  std::string blocks = some_bytes(), words = some_bytes();
  std::swap_ranges(blocks.begin(), blocks.begin() + 4096, blocks.begin() + 8192);
  std::swap_ranges(words.begin(), words.begin() + 8, words.begin() + 8);
  CHECK(said({a, copies.write(blocks)}) == other_bytes_at(1));
  CHECK(said({a, copies.write(words)}) == other_bytes_at(1));
}

TEST_CASE("shared file: other sizes and other counts are told without a look at the bytes") {
  Copies copies;
  const std::string a = copies.write(some_bytes()), b = copies.write(some_bytes() + "b");
  CHECK(said({a, a, b}) == kExpected + "another one at rank 2 (7 rows of 3 in 12294 bytes)");
  CHECK(said({a, a, a}, {7, 8, 9}) ==
        kExpected + "another one at rank 1 (8 rows of 3 in 12293 bytes)");
  CHECK(said({a, a + ".gone"}) == kExpected + "another one at rank 1 (7 rows of 3 in 0 bytes)");
}

}  // namespace
}  // namespace circumspect::distributed
