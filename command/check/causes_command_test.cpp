// check: lines `cause:`, which stand after the rules and before notes, in JSON and on the page.
#include <array>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {
namespace {

// A square of 3 × 3 points, cut into eight triangles, and what its mesher was given.
struct Square {
  ScratchFolder folder;
  std::string points = folder.write(
      "square.node", "9 2 0 0\n0 0 0\n1 1 0\n2 2 0\n3 0 1\n4 1 1\n5 2 1\n6 0 2\n7 1 2\n8 2 2\n");
  std::string domain = folder.write(
      "domain.poly", "4 2 0 0\n0 0 0\n1 2 0\n2 2 2\n3 0 2\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n");

  std::string without_one() { return written(7, 0); }
  // The first triangles; triangle 4 5 8 is the last. `shift`: is added to each index.
  std::string written(std::size_t most, int shift) {
    std::vector<std::array<int, 3>> triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4},
                                                 {3, 4, 7}, {3, 7, 6}, {4, 8, 7}, {4, 5, 8}};
    triangles.resize(most);
    std::string rows;
    int count = 0;
    for (const auto& [a, b, c] : triangles) {
      rows += std::to_string(count++) + " " + std::to_string(a + shift) + " " +
              std::to_string(b + shift) + " " + std::to_string(c + shift) + "\n";
    }
    return folder.write("square.ele", std::to_string(count) + " 3 0\n" + rows);
  }
};

}  // namespace

TEST_CASE("check: the cause stands after the rules, in text, in JSON and on the page") {
  Square square;
  const std::string mesh = square.without_one();
  const std::string page = square.folder.path("page.html");
  const Run text = run({"check", mesh, "--html", page});
  CHECK(text.exit_code == 1);
  const std::string line = "cause: 1 triangle is missing: 4 5 8 fills the hole (explains ";
  CHECK(has(text.out, line));
  CHECK(text.out.find(line) > text.out.find("triangulation.hull-not-convex: "));
  CHECK(text.out.find(line) < text.out.find("\nnote: "));
  const Run json = run({"check", mesh, "--format", "json"});
  CHECK(has(json.out, "\"cause\": \"missing-simplex\""));
  CHECK(has(json.out, "\"text\": \"1 triangle is missing: 4 5 8 fills the hole\""));
  CHECK(has(contents(page), "1 triangle is missing: 4 5 8 fills the hole"));
}

TEST_CASE("check --domain: a triangle that is missing, also where the domain may be moved") {
  Square square;
  const std::string mesh = square.without_one();
  const std::vector<std::string> asked = {"check", mesh, "--domain", square.domain};
  for (const std::vector<std::string>& more :
       std::vector<std::vector<std::string>>{{}, {"--within", "1e-9"}}) {
    std::vector<std::string> words = asked;
    words.insert(words.end(), more.begin(), more.end());
    const Run failed = run(words);
    CHECK(failed.exit_code == 1);
    CHECK(has(failed.out, "cause: 1 triangle is missing: 4 5 8 fills the hole"));
  }
}

TEST_CASE("check: the cause is told by the indices of the file") {
  Square square;
  const Run failed = run({"check", square.written(8, 1), "--max-errors", "1"});
  CHECK(failed.exit_code == 1);
  CHECK(has(failed.out,
            "cause: indices seem to begin at 1, not at 0: so read, the claim holds "
            "(explains all "));
}

TEST_CASE("check: a flat triangle does not silence what else is wrong") {
  Square square;
  const std::string mesh =
      square.folder.write("square.ele", "4 3 0\n0 0 1 2\n1 0 1 4\n2 3 4 7\n3 0 4 7\n");
  const Run failed = run({"check", mesh});
  CHECK(failed.exit_code == 1);
  CHECK(has(failed.out, "simplex.degenerate 1"));
  CHECK(has(failed.out,
            "1 triangle is set apart: flat, listed twice, or no simplices; the others "
            "do not form a complex: complex.overlap 1"));
}

}  // namespace circumspect::cli
