// The note about rounding where finding out takes long.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {

TEST_CASE(
    "check: where the search for a distance takes much longer than the check, a note proposes it") {
  // A strip of triangles with so many vertices on its two long sides, nearly all of them rounded.
  constexpr int kLength = 40'000;
  const auto x = [](int i) { return i + 0.1; };
  const auto low = [&](int i) { return x(i) / 3; };
  std::string nodes = fmt::format("{} 2 0 0\n", 2 * (kLength + 1));
  std::string triangles = fmt::format("{} 3 0\n", 2 * kLength);
  for (int i = 0; i <= kLength; ++i) {
    nodes += fmt::format("{} {} {}\n{} {} {}\n", 2 * i, x(i), low(i), 2 * i + 1, x(i), low(i) + 1);
  }
  for (int i = 0; i < kLength; ++i) {
    triangles += fmt::format("{} {} {} {}\n{} {} {} {}\n", 2 * i, 2 * i, 2 * i + 2, 2 * i + 1,
                             2 * i + 1, 2 * i + 1, 2 * i + 2, 2 * i + 3);
  }
  ScratchFolder folder;
  folder.write("m.node", nodes);
  const std::string mesh = folder.write("m.ele", triangles);
  const std::string domain = folder.write(
      "d.poly", fmt::format("4 2 0 0\n0 {} {}\n1 {} {}\n2 {} {}\n3 {} {}\n4 0\n0 0 1\n1 1 2\n2 2 "
                            "3\n3 3 0\n0\n",
                            x(0), low(0), x(kLength), low(kLength), x(kLength), low(kLength) + 1,
                            x(0), low(0) + 1));
  const std::string claim = "steiner-triangulation";
  const Run plain = run({"check", mesh, "--domain", domain, "--claim", claim, "--max-errors", "1"});
  CHECK(plain.exit_code == 1);
  CHECK(has(plain.out, "--within 1e-9x tells whether that is all that is wrong"));
  const Run found = run({"check", mesh, "--domain", domain, "--claim", claim, "--within", "1e-9x"});
  CHECK(found.exit_code == 0);
  CHECK(has(found.out, "within ~ "));
}

}  // namespace circumspect::cli
