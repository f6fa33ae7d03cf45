// How --help is laid out, what --version says, and what is printed in colour.
#include <algorithm>
#include <regex>

#include <doctest/doctest.h>

#include "command/run_command_test.hpp"

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

TEST_CASE("help: lines end where COLUMNS says, in a pipe after 80 characters, and lose no word") {
  const auto check_lines = [](const std::string& text, std::size_t longest) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      CAPTURE(line);
      // Words that name the values of an option, and examples, stay whole.
      const bool is_whole =
          std::regex_search(line, std::regex("^  (-|circum|tetgen)|^     +-- ")) ||
          !has(line.substr(std::min<std::size_t>(30, line.size())), " ");
      CHECK((line.size() <= longest || is_whole));
    }
  };
  for (const auto& command : kCommands) {
    const std::string piped = help_of(command);
    check_lines(piped, 80);
    const Columns columns("110");
    const std::string wide = help_of(command);
    check_lines(wide, 110);
    CHECK(unbroken(wide) == unbroken(piped));
    CHECK(wide != piped);
  }
  const Columns narrow("1");
  CHECK(unbroken(help_of({"check"})).size() > 1000);
}

TEST_CASE("help: a terminal says itself how wide it is") {
  const auto lines = [](const std::string& text) {
    return std::count(text.begin(), text.end(), '\n');
  };
  const std::string piped = help_of({"check"});
  const auto usual = lines(piped);
  // A terminal of `script` without input has no width: then it is as in a pipe.
  const std::string without_width = on_terminal("stty cols 0;", "check --help");
  CHECK(has(std::regex_replace(without_width, std::regex("\r"), ""), piped));
  const std::string narrow = on_terminal("stty cols 60;", "check --help");
  REQUIRE(!narrow.empty());
  CHECK(lines(narrow) > usual + 30);
  CHECK(lines(on_terminal("stty cols 200;", "check --help")) < usual - 30);
}

TEST_CASE("help: the subcommand says what --help says") {
  CHECK(run({"help"}).out == run({"--help"}).out);
  for (std::vector<std::string> command : kCommands) {
    CAPTURE(command.back());
    const std::string of_option = help_of(command);
    command.insert(command.begin(), "help");
    const Run said = run(command);
    CHECK(said.exit_code == 0);
    CHECK(said.err.empty());
    CHECK(said.out == of_option);
  }
  const Run mistyped = run({"help", "chek"});
  CHECK(mistyped.exit_code == 2);
  CHECK(mistyped.out.empty());
  CHECK(has(mistyped.err, "circumspect: expected check|certify|"));
  CHECK(has(mistyped.err, "found chek; the nearest is check\n"));
  CHECK(has(run({"help", "build", "cdtt"}).err, "circumspect build: expected delaunay|"));
  CHECK(has(run({"help", "check", "cdt"}).err,
            "circumspect check: expected no further argument, found cdt\n"));
}

TEST_CASE("version: this program, its libraries and the commit") {
  const Run version = run({"--version"});
  CHECK(version.exit_code == 0);
  CHECK(run({"-V"}).out == version.out);
  CHECK(std::regex_match(
      version.out,
      std::regex("circumspect \\d+\\.\\d+\\.\\d+ \\(GMP [\\d.]+, MPFR [\\d.]+, CGAL [\\d.]+, "
                 "(oneTBB [\\d.]+|plain threads), CaDiCaL \\S+, \\{fmt\\} [\\d.]+, CLI11 [\\d.]+, "
                 "nlohmann/json [\\d.]+, pugixml [\\d.]+, zlib [\\d.]+(, zstd [\\d.]+)?(, liblzma "
                 "[\\d.]+)?\\), "
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

}  // namespace circumspect::cli
