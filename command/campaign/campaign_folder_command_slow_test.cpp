// circumspect campaign with programs, names and folders that would lead it astray.
#include <cstdlib>

#include <doctest/doctest.h>
#include <sys/stat.h>

#include "command/campaign/program_test.hpp"

namespace circumspect::cli {
namespace {

TEST_CASE("campaign: whatever stands in the folder of findings, nobody's files are touched") {
  const Program program("echo nonsense > \"$2\"\n");
  const Arguments options = {"--cases", "2", "--families", "integers", "--minimize-runs", "1"};
  const std::string findings = program.output() + "/findings";
  const std::string mine = program.folder.path("mine");
  fs::create_directories(mine + "/output");
  const std::string precious = program.folder.write("mine/output/precious", "precious");
  const auto refused = [&](const char* part) {
    const Run result = run(program.campaign(options));
    CHECK(result.exit_code == 3);
    CHECK(is_error_line(result.err));
    CHECK(has(result.err, part));
    CHECK(contents(precious) == "precious");
    fs::remove(program.output() + "/journal.tsv");
  };
  // A link in place of the findings, or of one; a folder that no campaign began.
  fs::create_directory(program.output());
  fs::create_directory_symlink(mine, findings);
  refused("Not a directory");
  fs::remove(findings);
  fs::create_directory(findings);
  fs::create_directory_symlink(mine, findings + "/unreadable-mesh");
  refused("Not a directory");
  fs::remove(findings + "/unreadable-mesh");
  fs::rename(mine, findings + "/unreadable-mesh");
  const Run result = run(program.campaign(options));
  CHECK(result.exit_code == 3);
  CHECK(has(result.err, "expected no folder of this name, for the journal does not name it"));
  CHECK(contents(findings + "/unreadable-mesh/output/precious") == "precious");
}

TEST_CASE("campaign: a verdict.json that somebody has changed harms no report") {
  const Program program("echo nonsense > \"$2\"\n");
  const Arguments options = {"--cases", "1", "--families", "integers", "--minimize-runs", "1"};
  CHECK(run(program.campaign(options)).exit_code == 1);
  const std::string verdict = program.output() + "/findings/unreadable-mesh/verdict.json";
  const std::string deep(100'000, '[');
  for (const std::string& text :
       {std::string("{}"), std::string(R"({"results": {"0": 1}})"), deep,
        std::string(R"({"results": [{"text": 5, "points": "x", "minimal_points": -1}]})"),
        std::string(
            R"({"results": [{"text": "a\u001b[2Jb", "points": 5, "minimal_points": 4}]})")}) {
    CAPTURE(text.substr(0, 80));
    std::ofstream(verdict) << text;
    for (const char* const format : {"text", "json"}) {
      Arguments again = options;
      again.insert(again.end(), {"--format", format});
      const Run result = run(program.campaign(again));
      CHECK(result.exit_code == 1);
      CHECK(!has(result.out, "\x1b"));
    }
  }
  fs::remove(verdict);
  REQUIRE(mkfifo(verdict.c_str(), 0600) == 0);
  CHECK(run(program.campaign(options)).exit_code == 1);
}

TEST_CASE("campaign: a word that is also a file's name stays a word, and a path is a path") {
  const Program program("echo \"$3 $4\" >&2; cat \"$4\" >&2; exit 3\n");
  program.folder.write("i", "found");
  const std::string out = program.output("text");
  const std::string line = "cd " + program.folder.path("") +
                           " && " CIRCUMSPECT_COMMAND
                           " campaign --cases 1 --families integers --limit-memory 0 "
                           "--minimize-runs 1 -- ./program '{points}' '{mesh}' i ./i > " +
                           out + " 2>&1";
  CHECK(WEXITSTATUS(std::system(line.c_str())) == 1);
  CHECK(has(contents(out), "note: the argument i is given as it is; the file is ./i\n"));
  CHECK(has(contents(program.folder.path("campaign/findings/exit-code-3/said.txt")), "i "));
  CHECK(has(contents(program.folder.path("campaign/findings/exit-code-3/said.txt")), "found"));
  CHECK(has(contents(program.folder.path("campaign/findings/exit-code-3/reproduce.sh")), " i "));
}

TEST_CASE("campaign: a name of the points that begins with a dash, and an empty TMPDIR") {
  const Program program(forgetful());
  const std::string line = "TMPDIR= " CIRCUMSPECT_COMMAND " campaign --output " + program.output() +
                           " --cases 4 --families integers --limit-memory 0 --full-dimension "
                           "--points=-x.node -- " +
                           program.path + " '{points}' '{mesh}' > /dev/null";
  CHECK(WEXITSTATUS(std::system(line.c_str())) == 1);
  REQUIRE(!program.signatures().empty());
  const std::string signature = *program.signatures().begin();
  const std::string script = program.output() + "/findings/" + signature + "/reproduce.sh";
  const std::string again =
      "CIRCUMSPECT=" CIRCUMSPECT_COMMAND " " + script + " > " + program.output("again") + " 2>&1";
  CHECK(WEXITSTATUS(std::system(again.c_str())) == 1);
  CHECK(has(contents(program.output("again")), "fails: delaunay x.ele " + signature));
}

TEST_CASE(
    "campaign: reports for code scanning and for GitHub, and a folder that is called findings") {
  const Program program("kill -SEGV $$\n");
  const std::string report = program.output("report.sarif");
  const Run result =
      run(program.campaign({"--cases", "1", "--families", "integers", "--minimize-runs", "1",
                            "--sarif", report, "--annotations"},
                           "findings"));
  CHECK(result.exit_code == 1);
  const std::string found = program.output("findings") + "/crash-SIGSEGV";
  CHECK(fs::exists(found + "/minimal.node"));
  CHECK(!fs::exists(program.output("findings") + "/findings"));
  CHECK(has(result.out,
            "::error file=" + found + "/README.txt,title=program%3A crash-SIGSEGV::crash-SIGSEGV"));
  const auto sarif = nlohmann::json::parse(contents(report));
  CHECK(sarif["version"] == "2.1.0");
  const auto first = sarif["runs"][0]["results"][0];
  CHECK(first["ruleId"] == "crash-SIGSEGV");
  CHECK(first["locations"][0]["physicalLocation"]["artifactLocation"]["uri"] ==
        "file://" + found + "/README.txt");
}

TEST_CASE("campaign: says what kept the programs together") {
  const Program program(kRight);
  const Run result =
      run(program.campaign({"--cases", "1", "--containment", "supervisor", "--format", "json"}));
  CHECK(document(result)["results"][0]["containment"] == "supervisor");
  const Run text = run(program.campaign({"--cases", "1", "--containment", "supervisor"}));
  CHECK(has(text.out, "note: a supervisor contained the programs"));
}

}  // namespace
}  // namespace circumspect::cli
