// The folder that a campaign writes, and its page.
#include <cstdlib>

#include <doctest/doctest.h>
#include <sys/stat.h>

#include "command/campaign/program_test.hpp"
#include "command/run_command_test.hpp"

namespace circumspect::cli {

// circumspect campaign with programs, names and folders that would lead it astray.

namespace {

TEST_CASE("campaign: whatever stands in the folder of findings, nobody's files are touched") {
  const Program program("echo nonsense > \"$2\"\n");
  // Quiet, since a slow machine is told how far the campaign is.
  const Arguments options = {"--cases",         "2", "--families", "integers",
                             "--minimize-runs", "1", "--quiet"};
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
  REQUIRE(!program.signatures().empty());
  const std::string verdict =
      program.output() + "/findings/" + *program.signatures().begin() + "/verdict.json";
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
                           " campaign --cases 1 --families integers --seed 1 --limit-memory 0 "
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
  // Who does not have the command gets the program's answer, and is told what to do.
  const std::string without =
      "CIRCUMSPECT=/none " + script + " > " + program.output("none") + " 2>&1";
  CHECK(WEXITSTATUS(std::system(without.c_str())) == 2);
  CHECK(has(contents(program.output("none")),
            "put circumspect into PATH, or its\npath into CIRCUMSPECT"));
  CHECK(contents(program.output() + "/findings/" + signature + "/adapter/program") ==
        contents(program.path));
}

TEST_CASE(
    "campaign: reports for code scanning and for GitHub, and a folder that is called findings") {
  const Program program("kill -SEGV $$\n");
  const std::string report = program.output("report.sarif");
  const Run result =
      run(program.campaign({"--cases", "1", "--families", "integers", "--seed", "1",
                            "--minimize-runs", "1", "--sarif", report, "--annotations"},
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

TEST_CASE("campaign: inputs that are changed, and another program on the same ones") {
  const Arguments few = {"--cases",
                         "4",
                         "--families",
                         "uniform",
                         "--max-points",
                         "6",
                         "--full-dimension",
                         "--refusal-exit-code",
                         "9",
                         "--minimize-runs",
                         "60"};
  const auto with = [&](const Program& program, Arguments more, const std::string& out) {
    more.insert(more.end(), few.begin(), few.end());
    return run(program.campaign(more, out));
  };
  const Program half("case $(sed -n 2p \"$1\") in '0 -'*) exit 9;; esac\n" + std::string(kRight));
  CHECK(with(half, {}, "alone").exit_code != 1);
  const Run changed = with(half, {"--metamorphic", "order,reflection"}, "changed");
  CHECK(changed.exit_code == 1);
  const std::string signature = "refused-after-reflection";
  CHECK(half.signatures("changed") == std::set<std::string>{signature});
  CHECK(has(half.finding(signature, "image.node", "changed"), " -"));
  CHECK(has(half.finding(signature, "README.txt", "changed"), "image.node     the small one"));
  CHECK(has(half.finding(signature, "reproduce.sh", "changed"), "cp \"$here/image.node\" x.node"));
  CHECK(has(half.finding(signature, "verdict.json", "changed"),
            "\"text\": \"it takes the input, and refuses it after a change of reflection: "));

  const Program right(kRight);
  const std::string other = right.path + " {points} {mesh}";
  const Run alone = with(half, {"--against", other}, "against");
  CHECK(half.signatures("against") == std::set<std::string>{"refused-alone"});
  CHECK(has(alone.out, "it refuses what program takes, and gets right"));
  CHECK(has(half.finding("refused-alone", "README.txt", "against"),
            "The other program, program: holds"));
  CHECK(with(right, {"--against", other}, "same").exit_code == 0);
  const Run wrong = with(right, {"--against", "false {points} {mesh}"}, "wrong");
  CHECK(wrong.exit_code == 0);
  CHECK(has(wrong.out, "false is wrong: exit-code-1"));
  CHECK(with(right, {"--against", "no-such-program"}, "none").exit_code == 3);
  CHECK(has(with(right, {"--updates", "insert"}, "none").err, "expected --worker with --updates"));
  CHECK(has(with(right, {"--metamorphic", "ordre"}, "none").err, "found ordre"));
}

TEST_CASE("campaign: untidy domains are held against their arrangement") {
  // It makes no mesh but one triangle.
  const Program one("printf 'nOFF 2\\n3 1 0\\n0 0\\n1 0\\n0 1\\n3 0 1 2\\n' > \"$2\"\n");
  const auto with = [&](const Arguments& options, const std::string& out) {
    Arguments all = {
        "campaign",        "--output", one.output(out), "--limit-memory", "0",       "--cases", "6",
        "--minimize-runs", "30",       "--mesh",        "x.off",          "--claim", "cdt"};
    all.insert(all.end(), options.begin(), options.end());
    all.insert(all.end(), {"--", one.path, "{domain}", "{mesh}"});
    return run(all);
  };
  const Run untidy = with({"--untidy", "crossing,repetition", "--dimension", "2", "--about",
                           "one 1.2\nbuilt by hand", "--promise", "\"all are resolved\" (README)"},
                          "untidy");
  CHECK(untidy.exit_code == 1);
  const auto signatures = one.signatures("untidy");
  REQUIRE(!signatures.empty());
  const std::string signature = *signatures.begin();
  CHECK(one.finding(signature, "arranged.poly", "untidy") != "");
  CHECK(has(one.finding(signature, "reproduce.sh", "untidy"), "--domain \"$here/arranged.poly\""));
  CHECK(
      has(one.finding(signature, "README.txt", "untidy"), "arranged.poly  what has to be meshed"));
  const std::string issue = one.finding(signature, "issue.md", "untidy");
  CHECK(has(issue, "Version: one 1.2\\x0abuilt by hand\n"));
  CHECK(has(issue, "What is promised: \"all are resolved\" (README)\n"));
  CHECK(has(issue, "```\n\n![The first witness](picture.svg)\n"));
  const std::string picture = one.finding(signature, "picture.svg", "untidy");
  CHECK(begins_with(picture, "<svg xmlns="));
  CHECK(has(picture, "Z\" fill="));
  CHECK(!has(picture, "nan"));
  CHECK(has(issue, "```\n" + one.finding(signature, "minimal.poly", "untidy") + "```\n"));
  const std::string page = one.folder.path("page.html");
  const std::string script = one.output("untidy") + "/findings/" + signature + "/reproduce.sh";
  CHECK(std::system(("CIRCUMSPECT=" CIRCUMSPECT_COMMAND " sh " + script + " " + page + " > " +
                     page + ".log 2>&1")
                        .c_str()) != 0);
  CHECK(has(contents(page), "<html"));
  CHECK(with({"--untidy", "repetition"}, "space").exit_code == 1);
  const auto in_space = one.signatures("space");
  REQUIRE(!in_space.empty());
  CHECK(has(one.finding(*in_space.begin(), "arranged.poly", "space"), " 3 0 0\n"));
}

TEST_CASE("campaign: says what kept the programs together") {
  const Program program(kRight);
  const Run result =
      run(program.campaign({"--cases", "1", "--containment", "supervisor", "--format", "json"}));
  CHECK(document(result)["results"][0]["containment"] == "supervisor");
  const Run text = run(program.campaign({"--cases", "1", "--containment", "supervisor"}));
  CHECK(has(text.out, "note: a supervisor contained the programs"));
}

// campaign --html: a page of what was found.

namespace fs = std::filesystem;

// Forgets all simplices of six points or more, and dies of five.
constexpr const char* kPoor = R"(#!/bin/sh
read n rest < "$1"
[ $n -ge 6 ] && { echo "0 4" > "$2"; exit 0; }
[ $n -eq 5 ] && kill -SEGV $$
exec )" CIRCUMSPECT_COMMAND R"( build delaunay --quiet --duplicates merge "$1" -o "$2"
)";

TEST_CASE("campaign: the page has the table, and each finding with its input and its pictures") {
  const ScratchFolder folder;
  const std::string program = folder.write("a<b>&program", kPoor);
  fs::permissions(program, fs::perms::owner_all);
  const std::string page = folder.path("page.html");
  const Run result = run({"campaign", "--output", folder.path("out"), "--limit-memory", "0",
                          "--cases", "12", "--max-points", "8", "--families", "uniform", "--html",
                          page, "--", program, "{points}", "{mesh}"});
  CHECK(result.exit_code == 1);
  const std::string text = contents(page);
  CHECK(text.find("<b>") == std::string::npos);
  const std::size_t from = text.find("id=\"data\">") + 10;
  const auto data = nlohmann::json::parse(text.substr(from, text.find("</script>", from) - from));
  CHECK(data["campaign"]["families"]["uniform"].size() >= 2);
  CHECK(has(data["campaign"]["line"].get<std::string>(), "fails: campaign a<b>&program 12 cases"));
  CHECK(data["results"].size() == data["campaign"]["findings_count"].get<std::size_t>());
  bool has_crash = false;
  bool has_picture = false;
  for (const auto& one : data["results"]) {
    const std::string signature = one["finding"]["signature"];
    CHECK(fs::exists(one["finding"]["reproduce"].get<std::string>()));
    CHECK(one["finding"]["minimal"] ==
          contents(folder.path("out/findings/" + signature + "/minimal.node")));
    has_crash = has_crash || signature == "crash-SIGSEGV";
    if (signature == "crash-SIGSEGV") CHECK(!one.contains("report"));
    if (signature != "triangulation.unused-point") continue;
    has_picture = true;
    CHECK(one["report"]["violations"].size() == one["pictures"].size());
    CHECK(one["pictures"][0]["dimension"] == 3);
  }
  CHECK(has_crash);
  CHECK(has_picture);
  CHECK(run({"campaign", "--output", folder.path("out"), "--html",
             folder.path("out/findings/x.html"), "--", program})
            .exit_code == 2);
}

}  // namespace

}  // namespace circumspect::cli
