// Reports of `check` for CI, beside the text and the page of the same run.
#include <doctest/doctest.h>

#include "command/run_command_test.hpp"
#include "inputs/scratch_folder_test.hpp"

namespace circumspect::cli {
namespace {

const std::string kReportedNode = "4 2\n0 0 0\n1 4 0\n2 4 4\n3 0 4\n";

}  // namespace

TEST_CASE(
    "check: JUnit, SARIF and a page in one run, of meshes that hold, fail and cannot be read") {
  const ScratchFolder folder;
  folder.write("good & all.node", kReportedNode);
  folder.write("bad.node", kReportedNode);
  const std::string good = folder.write("good & all.ele", "2 3\n0 0 1 2\n1 0 2 3\n");
  const std::string bad = folder.write("bad.ele", "2 3\n0 0 1 2\n1 0 1 3\n");
  const std::string none = folder.path("none.ele");
  const std::string junit = folder.path("junit.xml");
  const std::string sarif = folder.path("report.sarif");
  const std::string page = folder.path("page.html");
  const Run all =
      run({"check", good, bad, none, "--junit", junit, "--sarif", sarif, "--html", page});
  CHECK(all.exit_code == 3);
  CHECK(has(all.out, "holds: delaunay "));
  CHECK(has(contents(page), "<html"));
  const std::string xml = contents(junit);
  CHECK(has(xml, "tests=\"3\" failures=\"1\" errors=\"1\""));
  CHECK(has(xml, "good &amp; all.ele\"/>"));
  CHECK(has(xml, "<error type=\"input\" message=\"input: " + none + ": expected a file"));
  const auto document = nlohmann::json::parse(contents(sarif));
  const auto& results = document["runs"][0]["results"];
  REQUIRE(results.size() >= 2);
  const auto rule = results[0]["ruleId"].get<std::string>();
  CHECK(has(all.out, "bad.ele " + rule + " "));
  CHECK(has(xml, "<failure type=\"" + rule + "\" message=\"" + rule + ": "));
  CHECK(has(results[0]["message"]["text"].get<std::string>(), "; simplex 0 1 "));
  CHECK(results.back()["ruleId"] == "input");
  CHECK(document["runs"][0]["tool"]["driver"]["rules"].size() >= 2);
  // The same whatever is printed.
  const std::string code = contents(sarif);
  for (const std::vector<std::string>& form : {std::vector<std::string>{"--quiet"},
                                               {"--format", "json"},
                                               {"--quiet", "--format", "json"}}) {
    std::vector<std::string> words = {"check", good, bad, none, "--junit", junit, "--sarif", sarif};
    words.insert(words.end(), form.begin(), form.end());
    folder.write("junit.xml", "");
    folder.write("report.sarif", "");
    CHECK(run(words).exit_code == all.exit_code);
    CHECK(contents(junit) == xml);
    CHECK(contents(sarif) == code);
  }
}

TEST_CASE("check: reports are written to files of their own") {
  const ScratchFolder folder;
  folder.write("x.node", kReportedNode);
  const std::string mesh = folder.write("x.ele", "2 3\n0 0 1 2\n1 0 2 3\n");
  const std::string report = folder.path("r");
  CHECK(run({"check", mesh, "--junit", "-"}).err ==
        "circumspect: expected a file for a report, found -\n");
  CHECK(run({"check", mesh, "--junit", report, "--sarif", report}).exit_code == 2);
  CHECK(run({"check", mesh, "--sarif", mesh}).exit_code == 2);
  CHECK(run({"check", mesh, "--sarif", folder.path("no/folder")}).exit_code == 2);
  CHECK(contents(mesh) == "2 3\n0 0 1 2\n1 0 2 3\n");
}

}  // namespace circumspect::cli
