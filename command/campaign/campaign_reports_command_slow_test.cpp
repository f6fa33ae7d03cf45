// All forms in which a campaign tells its result say the same.
#include <doctest/doctest.h>

#include "command/campaign/program_test.hpp"

namespace circumspect::cli {
namespace {

using nlohmann::json;

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

std::string without_percents(std::string text) {
  for (std::size_t at = text.find('%'); at != text.npos; at = text.find('%', at + 1)) {
    text.replace(at, 3, 1, static_cast<char>(std::stoi(text.substr(at + 1, 2), nullptr, 16)));
  }
  return text;
}

// Of the cases of all families, how many there are of each kind.
std::map<std::string, std::size_t> totals(const json& document) {
  std::map<std::string, std::size_t> totals;
  for (const auto& counts : document["families"]) {
    for (const auto& [what, count] : counts.items()) totals[what] += count.get<std::size_t>();
  }
  return totals;
}

// The annotations of GitHub: the file and the signature of each.
std::set<std::pair<std::string, std::string>> annotated(const std::string& out) {
  std::set<std::pair<std::string, std::string>> found;
  const std::string begin = "::error file=", title = ",title=";
  for (std::size_t at = out.find(begin); at != out.npos; at = out.find(begin, at + 1)) {
    // As GitHub reads it: properties end at a comma, and all of them at two colons.
    const std::string rest = out.substr(at + begin.size(), out.find('\n', at) - at - begin.size());
    const std::string file = rest.substr(0, rest.find(','));
    REQUIRE(rest.substr(file.size(), title.size()) == title);
    const std::string named =
        rest.substr(file.size() + title.size(), rest.find("::") - file.size() - title.size());
    const std::string name = without_percents(named);
    found.insert({without_percents(file), name.substr(name.rfind(' ') + 1)});
  }
  return found;
}

void check_junit(const std::string& xml, const json& told,
                 const std::set<std::string>& signatures) {
  std::size_t failures = 0;
  for (const auto& counts : told["families"]) {
    for (const auto& [what, count] : counts.items()) {
      failures += signatures.contains(what) ? 1 : 0;
    }
  }
  CHECK(count_of(xml, "<failure ") == failures);
  CHECK(has(xml, " failures=\"" + std::to_string(failures) + "\""));
  CHECK(has(xml, " tests=\"" + std::to_string(count_of(xml, "<testcase ")) + "\""));
}

// The file and the signature of each result of SARIF.
std::set<std::pair<std::string, std::string>> results_of_sarif(const std::string& path) {
  std::set<std::pair<std::string, std::string>> coded;
  const json document_of_sarif = json::parse(contents(path));
  for (const json& result : document_of_sarif["runs"][0]["results"]) {
    const json& place = result["locations"][0]["physicalLocation"]["artifactLocation"];
    const std::string file = without_percents(place["uri"].get<std::string>());
    coded.insert({file.substr(std::string("file://").size()), result["ruleId"].get<std::string>()});
  }
  return coded;
}

}  // namespace

TEST_CASE("campaign: text, JSON, JUnit, SARIF, annotations and the exit code say the same") {
  // By the number of points: refused for one reason, seldom for another; wrong in a known way,
  // wrong in another way; right.
  const Program program(
      "read n rest < \"$1\"\n"
      "[ $n -eq 6 ] && { echo 'six points' >&2; exit 9; }\n"
      "case $((n % 4)) in 0) echo 'twice even' >&2; exit 9;; 1) exit 3;; 2) exit 5;; esac\n" +
      std::string(kRight));
  program.folder.write("known", "exit-code-3\nexit-code-3-flat\n");
  const auto with = [&](const Arguments& more, const std::string& out) {
    Arguments all = {"--cases",
                     "40",
                     "--families",
                     "uniform,integers",
                     "--max-points",
                     "12",
                     "--refusal-exit-code",
                     "9",
                     "--known",
                     program.folder.path("known"),
                     "--minimize-runs",
                     "1"};
    all.insert(all.end(), more.begin(), more.end());
    return run(program.campaign(all, out));
  };
  const std::string junit = program.output("report.xml"), sarif = program.output("report.sarif");
  const std::string folder = "a, b: c";
  const Run text = with({"--junit", junit, "--sarif", sarif, "--annotations"}, folder);
  const json told = document(with({"--format", "json"}, "json"))["results"][0];
  const auto of = totals(told);
  REQUIRE(of.at("refused") > 0);
  REQUIRE(of.at("known") > 0);
  REQUIRE(of.at("holds") > 0);
  std::size_t cases = 0;
  for (const auto& [what, count] : of) cases += count;
  CHECK(told["cases"] == cases);
  CHECK(told["judged"] == cases - of.at("refused"));
  CHECK(told["holds"] == false);
  CHECK(text.exit_code == 1);
  // The most frequent reason comes first.
  const std::size_t often = text.out.find("cases, \"twice even\""),
                    seldom = text.out.find("cases, \"six points\"");
  REQUIRE(often != std::string::npos);
  REQUIRE(seldom != std::string::npos);
  CHECK(often < seldom);

  std::set<std::string> signatures;
  for (const json& finding : told["findings"]) {
    signatures.insert(finding["signature"].get<std::string>());
    CHECK(has(text.out, finding["signature"].get<std::string>() + ": "));
  }
  CHECK(!signatures.empty());
  CHECK(signatures == program.signatures(folder));
  check_junit(contents(junit), told, signatures);
  const auto coded = results_of_sarif(sarif);
  for (const auto& [file, signature] : coded) CHECK(signatures.contains(signature));
  CHECK(coded.size() == signatures.size());
  CHECK(annotated(text.out) == coded);
}

TEST_CASE("campaign: a program that is wrong only once was not judged right") {
  // The first answer to each input is none.
  const Program program(
      "seen=${0%/*}/seen-$(cksum < \"$1\" | tr ' ' -)\n"
      "[ -e \"$seen\" ] || { touch \"$seen\"; exit 3; }\n" +
      std::string(kRight));
  const Run once = run(program.campaign(
      {"--cases", "4", "--families", "uniform", "--max-points", "8", "--format", "json"}));
  const json told = document(once)["results"][0];
  CHECK(totals(told) == std::map<std::string, std::size_t>{{"flaky", 4}});
  CHECK(told["judged"] == 0);
  CHECK(told["holds"] == false);
  CHECK(once.exit_code != 0);
}

}  // namespace circumspect::cli
