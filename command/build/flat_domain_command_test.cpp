// A domain in a plane of space: what is built of it has points as the domain has them.
#include <doctest/doctest.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {
namespace {

// Two flat triangles at the height 5, on both sides of a segment that is not Delaunay.
constexpr const char* kAtFive =
    "4 3 0 0\n1 0 0 5\n2 8 0 5\n3 4 1 5\n4 4 -1 5\n2 0\n1\n3 1 2 3\n1\n3 1 2 4\n0\n";

}  // namespace

TEST_CASE("build: a mesh of a domain at z = 5 is written there, in every format and on stdout") {
  const ScratchFolder folder;
  const std::string domain = folder.write("d.poly", kAtFive);
  for (const std::string what : {"planar-cdt", "cdt", "steiner-cdt", "conforming-delaunay"}) {
    for (const std::string end : {".ele", ".mesh", ".msh", ".vtu", ".json"}) {
      const std::string mesh = folder.path("m" + end);
      const Run built = run({"build", what, domain, "-o", mesh});
      CHECK_MESSAGE(built.exit_code == 0, built.err);
      const std::string points = contents(folder.path(end == ".ele" ? "m.node" : "m" + end));
      if (end == ".ele") CHECK(has(points, " 3 0"));
      // The last point, in the words of each format.
      const std::string last = end == ".json" ? "[4,-1,5]" : "4 -1 5";
      std::string plain;
      for (const char c : points) {
        if (end != ".json" || (c != ' ' && c != '"' && c != '\n')) plain += c;
      }
      CHECK_MESSAGE(has(plain, last), (what + end + ": " + points));
      const Run checked = run({"check", mesh, "--domain", domain});
      CHECK_MESSAGE(checked.exit_code == 0, (checked.out + checked.err));
    }
  }
  const Run steiner = run({"build", "conforming-delaunay", domain, "-o", folder.path("s.ele")});
  CHECK_MESSAGE(has(steiner.out, ", 5)\n"), steiner.out);
}

TEST_CASE("build: points of the plane stay points of the plane") {
  const ScratchFolder folder;
  const std::string domain =
      folder.write("d.poly", "3 2 0 0\n1 0 0\n2 8 0\n3 8 8\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n");
  CHECK(run({"build", "cdt", domain, "-o", folder.path("m.ele")}).exit_code == 0);
  CHECK(contents(folder.path("m.node")).starts_with("3 2 0"));
}

}  // namespace circumspect::cli
