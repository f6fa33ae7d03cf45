// build cdt, inspect and check agree on random domains whose vertices are cospherical, many of
// which have a CDT that is not the canonical one. Book: Proposition 4.12 says of generic ones that
// they have no second.
#include <array>
#include <cstdint>
#include <random>

#include <doctest/doctest.h>

#include "command/run_command_test.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::cli {
namespace {

using Corners = std::vector<std::size_t>;

// A row of unit cubes; of each wall of a cube either the square is listed or two triangles; then
// segments between corners of cubes, across a cube or a square.
class RandomDomain {
 public:
  explicit RandomDomain(std::uint64_t seed) : random_(seed), cubes_(1 + random_() % 2) {
    for (std::size_t i = 0; i < cubes_; ++i) add_walls(i);
    for (std::size_t i = 0; i < cubes_; ++i) {
      if (random_() % 2 == 0) add_diagonal(i);
    }
  }

  std::string poly() const {
    const std::size_t size = 4 * (cubes_ + 1);
    std::string text = std::to_string(size) + " 3\n";
    for (std::size_t v = 0; v < size; ++v) {
      text += std::to_string(v) + " " + std::to_string(v / 4) + " " + std::to_string(v / 2 % 2) +
              " " + std::to_string(v % 2) + "\n";
    }
    text += std::to_string(facets_.size()) + "\n";
    for (const Corners& facet : facets_) {
      text += "1\n" + std::to_string(facet.size());
      for (const std::size_t v : facet) text += " " + std::to_string(v);
      text += "\n";
    }
    return text + "0\n";
  }

 private:
  // The corners of a square in order.
  void add_square(const std::array<std::size_t, 4>& corner) {
    switch (random_() % 6) {
      case 0:
        facets_.push_back({corner[0], corner[1], corner[2]});
        facets_.push_back({corner[0], corner[2], corner[3]});
        return;
      case 1:
        facets_.push_back({corner[0], corner[1], corner[3]});
        facets_.push_back({corner[1], corner[2], corner[3]});
        return;
      default:
        facets_.push_back({corner[0], corner[1], corner[2], corner[3]});
    }
  }

  void add_walls(std::size_t cube) {
    const std::size_t a = 4 * cube;
    if (cube == 0) add_square({a, a + 1, a + 3, a + 2});
    if (cube + 1 == cubes_ || random_() % 2 == 0) add_square({a + 4, a + 5, a + 7, a + 6});
    for (const auto& [p, q] : {std::pair<std::size_t, std::size_t>{0, 1}, {1, 3}, {3, 2}, {2, 0}}) {
      add_square({a + p, a + q, a + q + 4, a + p + 4});
    }
  }

  void add_diagonal(std::size_t cube) {
    const std::size_t corner = random_() % 4;
    facets_.push_back({4 * cube + corner, 4 * cube + 7 - corner});
  }

  std::mt19937_64 random_;
  std::size_t cubes_;
  std::vector<Corners> facets_;
};

struct Answers {
  int canonical = 0;
  int another = 0;
  int none = 0;
};

void hold_against_each_other(const std::string& domain, const std::string& mesh, Answers& answers) {
  const Run inspected = run({"inspect", domain});
  const Run built = run({"build", "cdt", domain, "-o", mesh});
  CAPTURE(inspected.out);
  CAPTURE(built.out);
  REQUIRE(inspected.exit_code == 0);
  if (has(inspected.out, " cdt none\n")) {
    ++answers.none;
    CHECK(built.exit_code == 1);
    CHECK(begins_with(built.out, "impossible: cdt " + domain + ": none (proved); "));
    return;
  }
  const bool is_canonical = has(inspected.out, " cdt canonical\n");
  ++(is_canonical ? answers.canonical : answers.another);
  CHECK(has(inspected.out, is_canonical ? " canonical (proved)\n" : " another (proved)\n"));
  CHECK(built.exit_code == 0);
  CHECK(has(built.out, is_canonical ? " canonical\n" : " not-canonical\n"));
  CHECK(has(built.out, "note: there is no canonical CDT") == !is_canonical);
  for (const std::string by : {"lemma", "definition"}) {
    const Run checked = run({"check", mesh, "--domain", domain, "--claim", "cdt", "--by", by});
    CHECK_MESSAGE(checked.exit_code == 0, checked.out);
    if (by == "lemma") CHECK(has(checked.out, " not-canonical\n") == !is_canonical);
  }
}

}  // namespace

TEST_CASE("build cdt, inspect and check agree on cubes with diagonals") {
  const ScratchFolder folder;
  Answers answers;
  const std::uint64_t inputs = properties::one_input_in() > 1 ? 28 : 150;
  for (std::uint64_t seed = 0; seed < inputs; ++seed) {
    CAPTURE(seed);
    const std::string domain = folder.write("cubes.poly", RandomDomain(seed).poly());
    hold_against_each_other(domain, folder.path("cubes.1.ele"), answers);
  }
  MESSAGE(answers.canonical << " canonical, " << answers.another << " another, " << answers.none
                            << " none");
  CHECK(answers.canonical >= 3);
  CHECK(answers.another >= 3);
  CHECK(answers.none >= 3);
}

}  // namespace circumspect::cli
