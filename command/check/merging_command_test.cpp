// Equal points that are merged: a note beside the verdict says which. Where they are refused, one
// message says so.
#include <doctest/doctest.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {
namespace {

// Four corners of a square, counted from 1. The fifth point is the first one again, and the sixth
// the third.
struct Torn {
  ScratchFolder folder;
  std::string node = folder.write("m.node", "6 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 0 0\n6 4 4\n");
  std::string mesh = folder.write("m.ele", "2 3 0\n1 1 2 3\n2 5 6 4\n");
  std::string note = "note: " + node +
                     ": points 1 and 5 are equal and count as one; in all, 2 points repeat an "
                     "earlier one\n";
  std::string domain = folder.write(
      "d.poly", "4 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");

  Run merged(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"--duplicates", "merge"});
    return run(arguments);
  }
};

}  // namespace

TEST_CASE("check --duplicates merge: which points count as one stands beside the verdict") {
  const Torn torn;
  const Run holds = torn.merged({"check", torn.mesh});
  CHECK(holds.exit_code == 0);
  CHECK(has(holds.out, torn.note + "holds: delaunay " + torn.mesh + " 4 points 2 triangles"));
  const std::string missing = torn.folder.write("n.ele", "1 3 0\n1 1 2 6\n");
  const Run fails = torn.merged({"check", missing, "--points", torn.node});
  CHECK(fails.exit_code == 1);
  CHECK(fails.out.find(torn.note) > fails.out.find("triangulation.unused-point: "));
  CHECK(has(fails.out, torn.note + "fails: "));
  CHECK(has(torn.merged({"check", torn.mesh, "--claim", "complex"}).out,
            torn.note + "holds: complex"));
  // Nothing is said of points that differ.
  const std::string whole = torn.folder.write("w.node", "4 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n");
  const std::string sound = torn.folder.write("w.ele", "2 3 0\n1 1 2 3\n2 1 3 4\n");
  CHECK(!has(torn.merged({"check", sound}).out, "note: "));
}

TEST_CASE("check --domain --duplicates merge: the same note, within a distance too") {
  const Torn torn;
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{}, {"--within", "0.1"}, {"--claim", "steiner-cdt"}}) {
    std::vector<std::string> arguments = {"check", torn.mesh, "--domain", torn.domain};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Run found = torn.merged(arguments);
    CHECK(found.exit_code == 0);
    CHECK_MESSAGE(has(found.out, torn.note + "holds: "), found.out);
    CHECK(found.out.find(torn.note) == found.out.rfind(torn.note));
  }
}

TEST_CASE("compare, certify and build say which points they took for one") {
  const Torn torn;
  const Run compared = torn.merged({"compare", torn.mesh, torn.mesh});
  CHECK(compared.exit_code == 0);
  CHECK(has(compared.out, torn.note));
  const Run certified = torn.merged({"certify", torn.mesh, "-o", torn.folder.path("c")});
  CHECK(certified.exit_code == 0);
  CHECK(has(certified.out, torn.note + "holds: "));
  for (const std::string what : {"delaunay", "delaunay-subdivision", "all-triangulations"}) {
    std::vector<std::string> arguments = {"build", what, torn.node};
    if (what == "delaunay") arguments.insert(arguments.end(), {"-o", torn.folder.path("b.ele")});
    const Run built = torn.merged(arguments);
    CHECK(built.exit_code == 0);
    CHECK(has(built.out, torn.note));
  }
  // inspect counts them in any case.
  CHECK(!has(torn.merged({"inspect", torn.node}).out, "count as one"));
}

TEST_CASE("equal points are refused in the same words by all, with what the user can do there") {
  const Torn torn;
  const std::string refused = torn.node +
                              ": expected distinct points, found points 1 and 5 equal and 1 more "
                              "duplicate; to take equal points for one, ";
  CHECK(has(run({"check", torn.mesh}).err, refused + "add --duplicates merge to the command\n"));
  CHECK(has(run({"check", torn.mesh, "--memory", "64M"}).err,
            refused + "leave out --memory and add --duplicates merge to the command\n"));
}

}  // namespace circumspect::cli
