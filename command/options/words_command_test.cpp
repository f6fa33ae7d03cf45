// Words and values of options that mean nothing: they are named, with the nearest right one.
#include <doctest/doctest.h>

#include "command/run_command_test.hpp"

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
  CHECK(
      said({"chek", "x.ele"}) ==
      "circumspect: expected check|certify|build|inspect|replay|campaign|adapter|minimize|generate|"
      "compare|rule|help, found chek; the nearest is check");
  CHECK(has(said({"frobnicate"}), "|compare|rule|help, found frobnicate"));
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

TEST_CASE("an option without its value does not take the next option for it") {
  const ScratchFolder folder;
  CHECK(has(said({"check", "m.ele", "--html", "--color"}),
            "--html: expected FILE, found the option --color"));
  CHECK(has(said({"check", "m.ele", "--domain", "-q"}), "found the option -q"));
  CHECK(has(said({"build", "cdt", "x.poly", "-o", "--format"}), "found the option --format"));
  CHECK(has(said({"campaign", "--output", "--time", "1s", "--", "true"}),
            "--output: expected FOLDER, found the option --time"));
  // A name that is no option of this command is one that a file may have.
  CHECK(run({"check", "m.ele", "--html", "--no-such-option"}).exit_code == 3);
}

TEST_CASE("options of another command") {
  CHECK(
      said({"compare", "a.ele", "b.ele", "--neighbors"})
          .find("circumspect compare: expected one of its options, found --neighbors, an option of "
                "circumspect ") == 0);
  CHECK(has(said({"--claim", "delaunay", "check", "x.ele"}),
            "found --claim, an option of circumspect check"));
}

TEST_CASE(
    "an option that may be given several times takes one word, and leaves -- to the program") {
  const std::vector<std::vector<std::string>> options = {
      {"--families", "all"},
      {"--exclude", "uniform"},
      {"--metamorphic", "order"},
      {"--refusal-exit-code", "9"},
      {"--refusal-text", "no"},
      {"--dimension", "2", "--domain", "x.poly", "--untidy", "crossing"},
      {"--worker", "--updates", "insert"}};
  for (const std::vector<std::string>& own : options) {
    CAPTURE(own.back());
    std::vector<std::string> words = {"campaign"};
    words.insert(words.end(), own.begin(), own.end());
    words.insert(words.end(), {"--", "./no-such-program", "-x"});
    if (own.front() == "--dimension") words.insert(words.end(), {"{domain}", "{mesh}"});
    if (own.front() != "--worker" && own.size() == 2)
      words.insert(words.end(), {"{points}", "{mesh}"});
    const Run result = run(words);
    CHECK(result.exit_code == 3);
    CHECK(has(result.err, "no-such-program"));
  }
  // The words behind it are arguments.
  CHECK(said({"compare", "--keep-label", "1", "2", "a.ele", "b.ele"}) ==
        "circumspect compare: expected no further argument, found b.ele");
}

TEST_CASE("arguments and options that are missing") {
  CHECK(said({"compare", "a.ele"}) == "circumspect compare: expected the argument b, found none");
  CHECK(said({"check"}) == "circumspect check: expected the argument mesh, found none");
  CHECK(said({"build", "cdt"}) ==
        "circumspect build cdt: expected the argument domain, found none");
  CHECK(said({"minimize", "x.node"}) ==
        "circumspect minimize: expected the option --output, found none");
}

TEST_CASE("an option without its value: what was expected after it") {
  CHECK(said({"check", "x.ele", "--domain"}) ==
        "circumspect check: expected FILE after --domain, found none");
  CHECK(said({"check", "--domain"}) ==
        "circumspect check: expected FILE after --domain, found none");
  CHECK(said({"check", "x.ele", "--fill"}) ==
        "circumspect check: expected enclosed|even-odd|winding|hull after --fill, found none");
  CHECK(said({"check", "x.ele", "--within"}) ==
        "circumspect check: expected DISTANCE after --within, found none");
  CHECK(said({"build", "cdt", "x.poly", "-o"}) ==
        "circumspect build cdt: expected OUT.ele after --output, found none");
  const std::string help = run({"help", "check"}).out;
  CHECK(!has(help, " TEXT"));
  CHECK(!has(help, " UINT"));
}

TEST_CASE("a flag with a value: none was expected") {
  CHECK(said({"check", "x.ele", "--neighbors=no"}) ==
        "circumspect check: expected no value for --neighbors, found one");
  CHECK(said({"check", "x.ele", "--oriented=no"}) ==
        "--oriented: expected same|positive|negative, found no");
  CHECK(said({"check", "x.ele", "--quiet=3"}) ==
        "circumspect check: expected no value for --quiet, found one");
  CHECK(said({"check", "--help=check"}) ==
        "circumspect check: expected no value for --help, found one");
}

TEST_CASE("the short names of options that other programs have, too") {
  const std::string mesh = CIRCUMSPECT_CORPUS_DIR "/peers/tetgen/random-3d-500.1.ele";
  const Run quiet = run({"check", "-q", mesh});
  CHECK(quiet.exit_code == 0);
  CHECK((quiet.out + quiet.err).empty());
}

TEST_CASE("arguments that are too many") {
  CHECK(said({"campaign", "--time", "5", "s", "--", "tetgen"}) ==
        "circumspect campaign: expected no further argument, found tetgen");
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

// What is not a value of an option is answered with those that are, not in the words of CLI11.

TEST_CASE("counts and words that are none: what was expected, and what was found") {
  const std::vector<std::string> steiner = {"build", "conforming-delaunay", "x.poly", "-o",
                                            "y.ele"};
  const auto said = [](std::vector<std::string> arguments, const std::string& option,
                       const std::string& value) {
    arguments.insert(arguments.end(), {option, value});
    // Versions of CLI11 differ in what they look at first, a value or an argument that is missing.
    if (arguments.front() == "campaign") {
      arguments.insert(arguments.end(), {"--", "true", "{points}", "{mesh}"});
    }
    const Run result = run(arguments);
    CHECK(result.exit_code == 2);
    CHECK(result.out.empty());
    return result.err.substr(0, result.err.find('\n'));
  };
  const std::string any = ": expected a whole number from 0 to 2^64 - 1, found ";
  CHECK(said({"inspect", "x.node"}, "--subsets", "-1") == "--subsets" + any + "-1");
  CHECK(said({"inspect", "x.node"}, "--subsets", "1e3") == "--subsets" + any + "1e3");
  CHECK(said({"inspect", "x.poly"}, "--max-errors", "foo") == "--max-errors" + any + "foo");
  CHECK(said({"inspect", "x.poly"}, "--search-vertices", "-1") == "--search-vertices" + any + "-1");
  CHECK(said({"inspect", "x.poly"}, "--search-conflicts", "") == "--search-conflicts" + any);
  CHECK(said(steiner, "--steiner-points", "-1") == "--steiner-points" + any + "-1");
  CHECK(said({"build", "all-triangulations", "x"}, "--max-points", "-1") ==
        "--max-points" + any + "-1");
  CHECK(said({"build", "delaunay", "x", "-o", "-"}, "--seed", "foo") == "--seed" + any + "foo");
  CHECK(said({"build", "delaunay-subdivision", "x"}, "--algorithm", "magic") ==
        "--algorithm: expected by-definition|gift-wrapping-cells|lifted-hull, found magic");
  CHECK(said({"check", "x.ele"}, "--limit", "soon") ==
        "--limit: expected a time such as 500ms, 90s, 15m or 1h, found soon");
  CHECK(said({"campaign"}, "--limit-time", "soon") ==
        "--limit-time: expected a time such as 500ms, 90s, 15m or 1h, found soon");
  CHECK(said({"campaign"}, "--limit-memory", "much") ==
        "--limit-memory: expected a size such as 64k, 512M or 2G, found much");
  CHECK(begins_with(said({"campaign"}, "--exponents", "few"), "--exponents: expected "));
  CHECK(said({"generate", "integers"}, "--points", "0") ==
        "--points: expected a whole number from 1 to 1000000, found 0");
  CHECK(said({"generate", "integers"}, "--coordinates", "float") ==
        "--coordinates: expected double|exact, found float");
  CHECK(said({"campaign"}, "--jobs", "0") ==
        "--jobs: expected a whole number from 1 to 256, found 0");
  CHECK(said({"campaign"}, "--first-index", "2") ==
        "--first-index: expected a whole number from 0 to 1, found 2");
  CHECK(said({"campaign"}, "--dimension", "9") ==
        "--dimension: expected a whole number from 1 to 8, found 9");
}

}  // namespace

}  // namespace circumspect::cli
