// How --help is laid out, what --version says, and what is printed in colour.
#include <algorithm>
#include <regex>

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "command/options/nearest_word.hpp"
#include "command/run_command.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::cli {

namespace {

const std::vector<std::vector<std::string>> kCommands = {{"check"},
                                                         {"certify"},
                                                         {"inspect"},
                                                         {"replay"},
                                                         {"campaign"},
                                                         {"minimize"},
                                                         {"generate"},
                                                         {"compare"},
                                                         {"build", "delaunay"},
                                                         {"build", "weighted-delaunay"},
                                                         {"build", "delaunay-subdivision"},
                                                         {"build", "all-triangulations"},
                                                         {"build", "planar-cdt"},
                                                         {"build", "cdt"},
                                                         {"build", "steiner-cdt"},
                                                         {"build", "conforming-delaunay"}};

std::string help_of(std::vector<std::string> command) {
  command.push_back("--help");
  const Run result = run(command);
  CHECK(result.exit_code == 0);
  return result.out;
}

// The command, run by a shell on a terminal of its own.
std::string on_terminal(const std::string& variables, const std::string& arguments) {
  const ScratchFolder folder;
  const std::string said = folder.path("said");
  const std::string command = variables + " " CIRCUMSPECT_COMMAND " " + arguments;
  const std::string line =
      "script --quiet --return --command '" + command + "' " + said + " >/dev/null </dev/null";
  if (std::system(line.c_str()) != 0) return "";
  return contents(said);
}

struct Columns {
  explicit Columns(const char* count) { setenv("COLUMNS", count, 1); }
  Columns(const Columns&) = delete;
  Columns& operator=(const Columns&) = delete;
  ~Columns() { unsetenv("COLUMNS"); }
};

}  // namespace

TEST_CASE("help: every option but --help and --version is in a group") {
  for (const auto& command : kCommands) {
    const std::string help = help_of(command);
    CAPTURE(help);
    CHECK(has(help, "\nOutput:\n"));
    const std::size_t begin = help.find("\nOptions:\n");
    REQUIRE(begin != std::string::npos);
    const std::string own = help.substr(begin + 1, help.find("\n\n", begin) - begin - 1);
    CHECK(own == "Options:\n  -h,--help                   Print this help message and exit");
  }
}

TEST_CASE("help: lines end where the terminal does, and lose no word") {
  const auto words = [](const std::string& text) {
    return std::regex_replace(text, std::regex("\\s+"), " ");
  };
  for (const auto& command : kCommands) {
    const std::string whole = help_of(command);
    const Columns columns("90");
    const std::string broken = help_of(command);
    CHECK(words(broken) == words(whole));
    std::istringstream lines(broken);
    for (std::string line; std::getline(lines, line);) {
      CAPTURE(line);
      // Words that name the values of an option, and examples, stay whole.
      const bool is_whole =
          std::regex_search(line, std::regex("^  (-|circum|tetgen)|^     +-- ")) ||
          !has(line.substr(std::min<std::size_t>(30, line.size())), " ");
      CHECK((line.size() <= 90 || is_whole));
    }
  }
  const Columns narrow("1");
  CHECK(words(help_of({"check"})).size() > 1000);
}

TEST_CASE("help: a terminal says itself how wide it is") {
  // A terminal of `script` without input has no width: then nothing is broken.
  const std::string whole = on_terminal("stty cols 0;", "check --help");
  const std::string broken = on_terminal("stty cols 70;", "check --help");
  REQUIRE(!broken.empty());
  const auto lines = [](const std::string& text) {
    return std::count(text.begin(), text.end(), '\n');
  };
  CHECK(lines(broken) > lines(whole) + 30);
}

TEST_CASE("version: this program, its libraries and the commit") {
  const Run version = run({"--version"});
  CHECK(version.exit_code == 0);
  CHECK(std::regex_match(
      version.out,
      std::regex("circumspect \\d+\\.\\d+\\.\\d+ \\(GMP [\\d.]+, MPFR [\\d.]+, CGAL [\\d.]+, "
                 "(oneTBB [\\d.]+|plain threads), CaDiCaL \\S+, \\{fmt\\} [\\d.]+, CLI11 [\\d.]+, "
                 "nlohmann/json [\\d.]+, pugixml [\\d.]+, zlib [\\d.]+\\), "
                 "commit ([0-9a-f]{7,40}(-modified)?|unknown)\n")));
}

TEST_CASE("colour: on a terminal, unless NO_COLOR is set, or as --color says") {
  const std::string mesh = CIRCUMSPECT_CORPUS_DIR "/peers/tetgen/random-3d-500.1.ele";
  const std::string green = "\x1b[1;32mholds\x1b[0m: delaunay ";
  CHECK(begins_with(run({"check", mesh}).out, "holds: "));
  CHECK(begins_with(run({"check", mesh, "--color", "always"}).out, green));
  CHECK(has(on_terminal("TERM=xterm", "check " + mesh), green));
  for (const std::string plain : {"TERM=xterm NO_COLOR=1", "TERM=dumb"}) {
    const std::string said = on_terminal(plain, "check " + mesh);
    CHECK(has(said, "holds: delaunay "));
    CHECK(!has(said, "\x1b[1;32m"));
  }
  CHECK(has(on_terminal("TERM=xterm NO_COLOR=", "check " + mesh), green));
  CHECK(!has(on_terminal("TERM=xterm", "check --color never " + mesh), green));
  CHECK(has(on_terminal("NO_COLOR=1", "check --color always " + mesh), green));
  CHECK(run({"check", mesh, "--color", "red"}).exit_code == 2);
}

TEST_CASE("colour: the verdict and the rule, and nothing that a reader of lines would miss") {
  const std::string mesh =
      CIRCUMSPECT_CORPUS_DIR "/peers/tetgen/hunted-tetgen-covered-twice-3d.1.ele";
  const Run plain = run({"check", mesh});
  const Run coloured = run({"check", mesh, "--color", "always"});
  CHECK(coloured.exit_code == 1);
  CHECK(begins_with(coloured.out, "\x1b[1mtriangulation.covered-twice\x1b[0m: "));
  CHECK(has(coloured.out, "\n\x1b[1;31mfails\x1b[0m: delaunay "));
  CHECK(std::regex_replace(coloured.out, std::regex("\x1b\\[[0-9;]*m"), "") == plain.out);
  CHECK(run({"check", mesh, "--color", "always", "--format", "json"}).out ==
        run({"check", mesh, "--format", "json"}).out);
}

// ---- Unknown words ----
// Words and values of options that mean nothing.

// ---- Unknown words ----
// Mistyped subcommands, options and values are named, with the nearest right one.

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
      "compare|rule, found chek; the nearest is check");
  CHECK(has(said({"frobnicate"}), "|rule, found frobnicate"));
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

// ---- Option values ----
// What is no value of an option is answered with those that are, not in the words of CLI11.

TEST_CASE("counts and words that are none: what was expected, and what was found") {
  const std::vector<std::string> steiner = {"build", "conforming-delaunay", "x.poly", "-o",
                                            "y.ele"};
  const auto said = [](std::vector<std::string> arguments, const std::string& option,
                       const std::string& value) {
    arguments.insert(arguments.end(), {option, value});
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

// ---- Nearest words ----
namespace {

TEST_CASE("edit distance: letters put in, left out, replaced, and neighbours exchanged") {
  CHECK(edit_distance("", "") == 0);
  CHECK(edit_distance("check", "") == 5);
  CHECK(edit_distance("chek", "check") == 1);
  CHECK(edit_distance("checkk", "check") == 1);
  CHECK(edit_distance("chack", "check") == 1);
  CHECK(edit_distance("chekc", "check") == 1);
  CHECK(edit_distance("kitten", "sitting") == 3);
  CHECK(edit_distance("ca", "abc") == 3);  // no part is edited twice
}

// Words of few letters, so that they have letters in common.
std::string word(const std::vector<int>& numbers) {
  std::string letters;
  for (const int number : numbers) letters += static_cast<char>('a' + (number % 3 + 3) % 3);
  return letters;
}

TEST_CASE("edit distance: symmetric, nought for equal words alone, between bounds of lengths") {
  CHECK(properties::holds([] {
    const auto first = *rc::gen::arbitrary<std::vector<int>>();
    const auto second = *rc::gen::arbitrary<std::vector<int>>();
    const std::string a = word(first);
    const std::string b = word(second);
    const std::size_t distance = edit_distance(a, b);
    RC_ASSERT(distance == edit_distance(b, a));
    RC_ASSERT((distance == 0) == (a == b));
    RC_ASSERT(distance <= std::max(a.size(), b.size()));
    RC_ASSERT(distance >= std::max(a.size(), b.size()) - std::min(a.size(), b.size()));
  }));
}

TEST_CASE("edit distance: one exchange of neighbours is one step") {
  CHECK(properties::holds([] {
    const auto numbers = *rc::gen::arbitrary<std::vector<int>>();
    auto place = *rc::gen::arbitrary<std::size_t>();
    std::string a = word(numbers);
    RC_PRE(a.size() >= 2);
    std::string b = a;
    place %= a.size() - 1;
    std::swap(b[place], b[place + 1]);
    RC_ASSERT(edit_distance(a, b) == (a == b ? 0U : 1U));
  }));
}

TEST_CASE("the nearest word, or none where none is near") {
  const std::vector<std::string> words = {"check", "certify", "campaign", "compare", "--version"};
  CHECK(nearest_word("chek", words) == "check");
  CHECK(nearest_word("CHECK", words) == "check");
  CHECK(nearest_word("--verison", words) == "--version");
  CHECK(nearest_word("camp", words) == "campaign");
  CHECK(nearest_word("frobnicate", words).empty());
  CHECK(nearest_word("-c", words).empty());
  CHECK(nearest_word("", words).empty());
  CHECK(nearest_text("chek", words) == "; the nearest is check");
  CHECK(nearest_text("frobnicate", words).empty());
}

}  // namespace

}  // namespace circumspect::cli
