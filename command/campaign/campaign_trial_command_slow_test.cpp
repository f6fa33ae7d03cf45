// Commands that are wrong: a campaign says so first, and keeps nothing.
#include <cstdlib>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "command/campaign/program_test.hpp"

namespace circumspect::cli {
namespace {

constexpr const char* kCannotStart = "echo 'mesher: libmesh.so: cannot be opened' >&2; exit 127\n";

// Builds the mesh of what `before` makes of the points, and writes what `after` makes of its lines.
std::string with_awk(const std::string& before, const std::string& after) {
  return "CIRCUMSPECT=" CIRCUMSPECT_COMMAND "\nawk '" + before +
         "' \"$1\" > own.node\n"
         "\"$CIRCUMSPECT\" build delaunay --quiet --duplicates merge own.node -o whole.ele || exit "
         "9\nawk '" +
         after + "' whole.ele > \"$2\"\n";
}

TEST_CASE("campaign: a program that cannot start is said to be one, and nothing is made small") {
  const Program program(kCannotStart);
  const Arguments options = {"--cases", "30", "--max-points", "8"};
  const Run first = run(program.campaign(options));
  CHECK(first.exit_code == 3);
  CHECK(first.out.empty());
  CHECK(has(first.err, "the program fails on every input (10 until now): is the command right? "));
  CHECK(has(first.err, "exit code 127: \"mesher: libmesh.so: cannot be opened\""));
  CHECK(has(first.err, "--go-on"));
  CHECK(program.signatures().empty());
  // The same command again begins anew, and so does another one: nothing was kept.
  Arguments others = options;
  others.insert(others.end(), {"--seed", "5", "--format", "json"});
  const Run again = run(program.campaign(others));
  CHECK(again.exit_code == 3);
  CHECK(has(nlohmann::json::parse(again.out)["results"][0]["error"], "is the command right?"));
  program.folder.write("program", std::string("#!/bin/sh\n") + kRight);
  const Run mended = run(program.campaign(options));
  CHECK(mended.exit_code == 0);
  CHECK(has(last_line(mended.out), "holds: campaign program 30 cases"));
}

TEST_CASE("campaign: --go-on keeps the failures all the same, and a few cases are kept, too") {
  const Program program(kCannotStart);
  const Arguments few = {"--cases", "12", "--max-points", "8", "--minimize-runs", "5", "--go-on"};
  const Run all = run(program.campaign(few));
  CHECK(all.exit_code == 1);
  CHECK(begins_with(all.out, "note: the program fails on every input (10 until now): is the "));
  CHECK(has(last_line(all.out), "fails: campaign program 12 cases "));
  CHECK(program.signatures().count("exit-code-127") == 1);
  const Run three = run(program.campaign({"--cases", "3", "--minimize-runs", "5"}, "three"));
  CHECK(three.exit_code == 1);
  CHECK(begins_with(three.out, "note: the program fails on every input (3 until now): "));
  CHECK(!program.signatures("three").empty());
}

TEST_CASE("campaign: a worker that dies at its start is quoted") {
  const Program program("echo 'adapter: no module named mesh' >&2; exit 1\n");
  const Run result = run({"campaign", "--output", program.output(), "--limit-memory", "0",
                          "--cases", "40", "--worker", "--dimension", "2", "--", program.path});
  CHECK(result.exit_code == 3);
  CHECK(has(result.err, "is the command right?"));
  CHECK(has(result.err, "adapter: no module named mesh"));
  CHECK(program.signatures().empty());
}

TEST_CASE("campaign: indices from another number, and another dimension, are seen in the meshes") {
  const Arguments options = {"--cases", "60", "--max-points", "9", "--exclude", "duplicates"};
  const auto said = [&](const std::string& script, const Arguments& more) {
    const Program program(script);
    Arguments all = options;
    all.insert(all.end(), more.begin(), more.end());
    const Run result = run(program.campaign(all));
    CHECK(result.exit_code == 3);
    CHECK(program.signatures().empty());
    return result.err;
  };
  const std::string moved = "NR > 1 && !/^#/ { for (i = 2; i <= NF; i++) $i += BY } { print }";
  std::string up = moved, down = moved;
  up.replace(up.find("BY"), 2, "1");
  down.replace(down.find("BY"), 2, "-1");
  CHECK(has(said(with_awk("{ print }", up), {}),
            "its indices seem to begin at 1, and not at 0, for so its meshes are right; should it "
            "be --first-index 1? (10 of the 10 inputs"));
  CHECK(has(said(with_awk("{ print }", down), {"--first-index", "1"}),
            "its indices seem to begin at 0, and not at 1"));
  CHECK(has(said(with_awk("NR == 1 { $2 = 2; print; next } { print $1, $2, $3 }", "{ print }"), {}),
            "the inputs are in space, the program answers in the plane"));
  CHECK(has(said(with_awk("NR == 1 { $2 = 3; print; next } { print $1, $2, $3, NR * NR * NR }",
                          "{ print }"),
                 {"--dimension", "2"}),
            "the inputs are in the plane, the program answers in space"));
}

TEST_CASE("minimize: a program that cannot start fails without points, too") {
  const Program program(kCannotStart);
  const std::string input =
      program.folder.write("a.node", "4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n");
  const Run result = run({"minimize", input, "-o", program.folder.path("b.node"), "--limit-memory",
                          "0", "--", program.path, "{points}", "{mesh}"});
  CHECK(result.exit_code == 0);
  CHECK(has(result.out + result.err, "where there are no points: is the command right?"));
}

TEST_CASE("campaign: a pipe among the findings holds up neither a page nor the next call") {
  const Program program(forgetful());
  const Arguments options = {"--cases",      "12", "--families",      "integers",
                             "--max-points", "9",  "--minimize-runs", "20"};
  REQUIRE(run(program.campaign(options)).exit_code == 1);
  for (const std::string& signature : program.signatures()) {
    for (const std::string name : {"minimal.node", "verdict.json", "output/x.ele"}) {
      const std::string path = program.output() + "/findings/" + signature + "/" + name;
      fs::remove(path);
      REQUIRE(mkfifo(path.c_str(), 0600) == 0);
    }
  }
  std::string line = "timeout 60 " CIRCUMSPECT_COMMAND;
  Arguments words = options;
  words.insert(words.end(), {"--html", program.output("page.html")});
  for (const std::string& word : program.campaign(words)) line += " '" + word + "'";
  CHECK(WEXITSTATUS(std::system((line + " > /dev/null 2>&1").c_str())) == 1);
  CHECK(has(contents(program.output("page.html")), *program.signatures().begin()));
}

}  // namespace
}  // namespace circumspect::cli
