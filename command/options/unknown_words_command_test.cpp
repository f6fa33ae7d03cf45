// Mistyped subcommands, options and values are named, with the nearest right one.
#include <doctest/doctest.h>

#include "command/run_command.hpp"

namespace circumspect::cli {
namespace {

// The first line of what is said to a call that is a matter of usage.
std::string said(const std::vector<std::string>& arguments) {
  const Run result = run(arguments);
  CHECK(result.exit_code == 2);
  CHECK(result.out.empty());
  return result.err.substr(0, result.err.find('\n'));
}

TEST_CASE("subcommands") {
  CHECK(said({"chek", "x.ele"}) ==
        "circumspect: expected check|certify|build|inspect|replay|campaign|minimize|generate|"
        "compare, found chek; the nearest is check");
  CHECK(has(said({"frobnicate"}), "|compare, found frobnicate"));
  CHECK_FALSE(has(said({"frobnicate"}), "nearest"));
  const std::string build = said({"build", "delunay", "x.node", "-o", "y.ele"});
  CHECK(begins_with(build, "circumspect build: expected delaunay|weighted-delaunay|"));
  CHECK(has(build, ", found delunay; the nearest is delaunay"));
  CHECK(has(said({"build", "delaunnay-subdivison"}), "the nearest is delaunay-subdivision"));
  // With nothing mistyped, what is missing.
  CHECK(has(said({}), "expected check|certify|"));
  CHECK(has(said({"build"}), "circumspect build: expected delaunay|"));
}

TEST_CASE("options") {
  CHECK(said({"--verison"}) ==
        "circumspect: expected one of its options, found --verison; the nearest is --version");
  CHECK(said({"check", "--domian", "x.poly", "m.ele"}) ==
        "circumspect check: expected one of its options, found --domian; the nearest is --domain");
  CHECK(
      has(said({"check", "--domian=x.poly", "m.ele"}), "found --domian; the nearest is --domain"));
  CHECK(has(said({"check", "--hepl"}), "found --hepl; the nearest is --help"));
  CHECK(has(said({"check", "-x", "m.ele"}),
            "circumspect check: expected one of its options, found -x"));
  CHECK(has(said({"build", "cdt", "x.poly", "--ouptut", "y.ele"}),
            "circumspect build cdt: expected one of its options, found --ouptut; the nearest is "
            "--output"));
  CHECK(has(said({"campaign", "--tiem", "5s", "--", "true", "{points}", "{mesh}"}),
            "found --tiem; the nearest is --time"));
}

TEST_CASE("options of another command") {
  CHECK(
      said({"compare", "a.ele", "b.ele", "--neighbors"})
          .find("circumspect compare: expected one of its options, found --neighbors, an option of "
                "circumspect ") == 0);
  CHECK(has(said({"--claim", "delaunay", "check", "x.ele"}),
            "found --claim, an option of circumspect check"));
}

TEST_CASE("arguments that are too many") {
  CHECK(said({"compare", "a.ele", "b.ele", "c.ele"}) ==
        "circumspect compare: expected no further argument, found c.ele");
  CHECK(said({"replay", "a", "b", "c", "d"}) ==
        "circumspect replay: expected no further argument, found c");
}

TEST_CASE("values of options") {
  CHECK(said({"check", "x.ele", "--format", "jsno"}) ==
        "--format: expected json|text, found jsno; the nearest is json");
  CHECK(has(said({"check", "x.ele", "--claim", "delauny"}),
            ", found delauny; the nearest is delaunay"));
  CHECK(has(said({"build", "delaunay", "x.node", "--algorithm", "boyer-watson"}),
            "found boyer-watson; the nearest is bowyer-watson"));
  CHECK(has(said({"campaign", "--families", "unifrom", "--", "true", "{points}", "{mesh}"}),
            "found 'unifrom'; the nearest are uniform, "));
}

TEST_CASE("a file of a kind that is not read: the kinds that are") {
  const ScratchFolder folder;
  const std::string object = folder.write("x.surf", "# a surface\nvertex 0 0 0\nvertex 1 0 0\n");
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"inspect", object}, {"build", "delaunay", object, "-o", "-"}}) {
    const Run result = run(command);
    CHECK(result.exit_code == 3);
    CHECK(is_error_line(result.err));
    for (const char* kind : {".node", ".json", ".off", ".mesh", ".msh", ".vtk", ".vtu", ".obj",
                             ".xyz", ".csv", ".npy", ".qhull", ".poly", ".smesh", ".stl", ".ply"}) {
      CAPTURE(kind);
      CHECK(has(result.err, kind));
    }
    CHECK(has(result.err, "x.surf:2: expected "));
    CHECK(has(result.err, "found \"vertex\""));
  }
  // Points whose name says nothing are read as before.
  CHECK(run({"inspect", folder.write("points", "3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n")}).exit_code == 0);
  CHECK(run({"inspect", folder.write("points.txt", "2\n3\n0 0\n1 0\n0 1\n")}).exit_code == 0);
}

}  // namespace
}  // namespace circumspect::cli
