// circumspect campaign and minimize, as their users run them, on programs that are right, wrong and
// rough.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <set>
#include <thread>

#include <doctest/doctest.h>
#include <signal.h>

#include "command/campaign/program_test.hpp"

namespace circumspect::cli {
namespace {

TEST_CASE("campaign: a right program, exit code 0") {
  const Program program(kRight);
  const Run result = run(program.campaign({"--cases", "12", "--max-points", "8"}));
  CHECK(result.exit_code == 0);
  CHECK(begins_with(last_line(result.out), "holds: campaign program 12 cases, "));
  CHECK(has(last_line(result.out), " points, exponents -100 to 100, 12 families\n"));
  CHECK(result.err.empty());
  CHECK(program.signatures().empty());
}

TEST_CASE("campaign: a wrong program, a folder for each way in which it fails") {
  const Program program(forgetful());
  const Run result =
      run(program.campaign({"--cases", "6", "--families", "integers", "--max-points", "12",
                            "--full-dimension", "--junit", program.output("report.xml")}));
  CHECK(result.exit_code == 1);
  CHECK(begins_with(last_line(result.out), "fails: campaign program 6 cases "));
  REQUIRE(!program.signatures().empty());
  const std::string signature = *program.signatures().begin();
  CHECK(has(result.out, signature + ": "));
  const std::string minimal = program.finding(signature, "minimal.node");
  CHECK(minimal.substr(0, minimal.find('\n')) == "6 3 0 0");
  CHECK(begins_with(program.finding(signature, "README.txt"), signature + "\n"));
  const auto verdict = nlohmann::json::parse(program.finding(signature, "verdict.json"));
  CHECK(verdict["results"][0]["signature"] == signature);
  CHECK(verdict["results"][0]["verdict"]["violations"].size() > 0);
  CHECK(has(contents(program.output("report.xml")), "<failure type=\"" + signature + "\""));
  const std::string script = program.output() + "/findings/" + signature + "/reproduce.sh";
  const std::string again =
      "CIRCUMSPECT=" CIRCUMSPECT_COMMAND " " + script + " > " + program.output("again") + " 2>&1";
  CHECK(WEXITSTATUS(std::system(again.c_str())) == 1);
  CHECK(has(contents(program.output("again")), "fails: delaunay x.ele " + signature));
}

TEST_CASE("campaign: what numbers are drawn, what is left out, what is known") {
  const Program program(kRight);
  const Arguments few = {"--cases", "4", "--max-points", "6"};
  const auto with = [&](const std::string& out, Arguments more) {
    more.insert(more.end(), few.begin(), few.end());
    return run(program.campaign(more, out));
  };
  const Run huge = with("a", {"--families", "huge,huge+ulp+moved", "--exponents=-9:9"});
  CHECK(has(last_line(huge.out), ", exponents -9 to 9, 2 families\n"));
  CHECK(has(last_line(with("b", {"--families", "huge", "--extreme"}).out),
            ", extreme exponents, 1 family\n"));
  CHECK(has(last_line(with("c", {"--families", "uniform", "--integers", "4"}).out),
            "integers of 4 bits"));
  CHECK(!has(with("d", {"--exclude", "uniform,integers"}).out, "\nuniform "));
  CHECK(with("e", {"--exclude", "uniforn"}).exit_code == 2);
  CHECK(with("f", {"--exclude", "uniform", "--families", "uniform+ulp"}).exit_code == 2);
  CHECK(has(with("g", {"--exponents=9:-9"}).err, "expected LOW:HIGH, two integers"));
  const Program wrong("exit 3\n");
  const std::string known = program.folder.path("known");
  program.folder.write("known", "exit-code-3  # as its page says\nexit-code-3-flat\n");
  const Run silent = run(wrong.campaign({"--cases", "4", "--known", known}));
  CHECK(has(silent.out, "known: 4 cases"));
  CHECK(silent.exit_code == 0);
  // Another signature, and this one behind #, are not this one.
  program.folder.write("known", "exit-code-33\n# exit-code-3\n");
  CHECK(run(wrong.campaign({"--cases", "4", "--known", known}, "others")).exit_code == 1);
  program.folder.write("known", "# exit-code-3\n\n");
  CHECK(has(run(wrong.campaign({"--cases", "4", "--known", known}, "none")).err, "found none"));
}

// What it does depends on the number of points.
constexpr const char* kRough = R"(
read n rest < "$1"
case $n in
  4) exec yes;;
  5) while :; do sleep 1; done;;
  6) kill -SEGV $$;;
  7) exit 3;;
  8) echo '2 4 0 nonsense' > "$2"; exit 0;;
  9) rm -r "$PWD"/* ; exit 0;;
  10) sleep 1000 & setsid sleep 1000 & ;;
  11) i=0; while :; do i=$((i+1)); head -c 100000 /dev/zero > zero$i; done;;
  12) i=0; while :; do i=$((i+1)); sleep 1000 & done;;
  13) mkfifo "$2"; exit 0;;
esac
exit 7
)";

TEST_CASE("campaign: whatever a program does is told apart, and the campaign goes on") {
  const Program program(kRough);
  const ScratchFolder corpus;
  for (int n = 4; n <= 14; ++n) {
    std::string text = std::to_string(n) + " 3 0 0\n";
    for (int i = 0; i < n; ++i) {
      text += std::to_string(i) + " " + std::to_string(i) + " " + std::to_string(i * i) + " " +
              std::to_string(i * i * i) + "\n";
    }
    corpus.write("points" + std::to_string(n + 10) + ".node", text);
  }
  const Run result = run(program.campaign(
      {"--cases", "0", "--corpus", corpus.path(""), "--limit-time", "2s", "--limit-output", "1M",
       "--limit-processes", "20", "--minimize-runs", "1", "--refusal-exit-code", "9"}));
  CHECK(result.exit_code == 1);
  CHECK(last_line(result.out) == "fails: campaign program 11 cases 8 signatures\n");
  std::string signatures;
  for (const std::string& signature : program.signatures()) signatures += signature + "\n";
  CHECK(signatures ==
        "crash-SIGSEGV\nexit-code-3\nexit-code-7\nhang\nno-mesh\noutput-limit\nprocess-limit\n"
        "unreadable-mesh\n");
  // The program deleted its input; ours is whole.
  CHECK(begins_with(program.finding("no-mesh", "input.node"), "9 3 0 0\n0 0 0 0\n"));
  CHECK(has(program.finding("unreadable-mesh", "README.txt"), "x.ele:1: expected "));
}

TEST_CASE("campaign: the same findings whatever the number of jobs") {
  const Program program(forgetful());
  const Arguments options = {"--cases", "16", "--max-points", "9", "--minimize-runs", "30"};
  const auto with_jobs = [&](const std::string& jobs) {
    Arguments all = options;
    all.insert(all.end(), {"--jobs", jobs});
    return run(program.campaign(all, "out" + jobs));
  };
  CHECK(last_line(with_jobs("1").out) == last_line(with_jobs("3").out));
  CHECK(contents(program.output("out1/journal.tsv")).size() > 100);
  REQUIRE(!program.signatures("out1").empty());
  CHECK(program.signatures("out1") == program.signatures("out3"));
  for (const std::string& signature : program.signatures("out1")) {
    for (const char* file : {"input.node", "minimal.node", "verdict.json", "README.txt"}) {
      CHECK(program.finding(signature, file, "out1") == program.finding(signature, file, "out3"));
    }
  }
}

// It is slow, and notes how many points it was given each time.
std::string slow(const std::string& notes) {
  return "read points rest < \"$1\"; echo $points >> " + notes + "; sleep 0.1\n" + forgetful();
}

std::vector<std::size_t> numbers_in(const std::string& path) {
  std::vector<std::size_t> numbers;
  std::ifstream file(path);
  for (std::size_t number = 0; file >> number;) numbers.push_back(number);
  return numbers;
}

TEST_CASE("campaign: making small is counted in --time, and goes on in the next call") {
  const ScratchFolder notes;
  const Program program(slow(notes.path("notes")));
  const auto campaign = [&](const std::string& time) {
    return run(program.campaign({"--cases", "1", "--families", "integers", "--max-points", "20",
                                 "--full-dimension", "--seed", "3", "--time", time}));
  };
  const auto begin = std::chrono::steady_clock::now();
  const Run first = campaign("2s");
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  CHECK(took.count() < 12);  // two runs more, on a machine that is busy
  CHECK(first.exit_code == 1);
  CHECK(begins_with(first.err, "campaign: 2 s; once something is found, the last 0.5 s of them "));
  CHECK(has(first.err, "no more cases; findings that are made small: 1, until 2 s have passed\n"));
  CHECK(has(first.out, " so far (the same command again goes on)\n"));
  REQUIRE(program.signatures().size() == 1);
  const std::string signature = *program.signatures().begin();
  const std::size_t reached = std::stoul(program.finding(signature, "minimal.node"));
  CHECK(has(contents(program.output("out/journal.tsv")), "\ncut-off\t" + signature + "\n"));
  const auto before = numbers_in(notes.path("notes"));
  REQUIRE(!before.empty());
  REQUIRE(reached < before.front());
  fs::remove(notes.path("notes"));
  const Run second = campaign("280s");
  CHECK(second.exit_code == 1);
  CHECK(!has(second.out, " so far"));
  CHECK(has(contents(program.output("out/journal.tsv")), "\nminimised\t" + signature + "\n"));
  CHECK(begins_with(program.finding(signature, "minimal.node"), "5 3 0 0\n"));
  // It began with what the first call had reached.
  const auto after = numbers_in(notes.path("notes"));
  REQUIRE(!after.empty());
  CHECK(*std::max_element(after.begin(), after.end()) == reached);
  CHECK(campaign("2s").err.find("no more cases") == std::string::npos);  // nothing is left to do
}

TEST_CASE("campaign: the example for CI uploads what is written") {
  const std::string example = contents(CIRCUMSPECT_CORPUS_DIR "/../docs/ci-example.yml");
  const auto value_of = [&example](const std::string& option) {
    const std::size_t at = example.find(option + " ");
    REQUIRE(at != std::string::npos);
    const std::size_t start = at + option.size() + 1;
    return example.substr(start, example.find_first_of(" \n", start) - start);
  };
  CHECK(value_of("--output") != "findings");  // findings/findings
  CHECK(has(example, "\n            " + value_of("--output") + "/findings\n"));
  CHECK(has(example, "\n            " + value_of("--junit") + "\n"));
}

// The number of lines about cases in a journal.
long cases_in(const std::string& journal) {
  const std::string text = contents(journal);
  long count = 0;
  for (std::size_t at = text.find("\ncase\t"); at != std::string::npos;
       at = text.find("\ncase\t", at + 1)) {
    ++count;
  }
  return count;
}

TEST_CASE("campaign: after kill -9 it goes on, and ends as if it had never been killed") {
  const Program program(forgetful());
  const Arguments options = {"--cases",         "40", "--max-points", "9",
                             "--minimize-runs", "30", "--jobs",       "2"};
  Streams streams;
  streams.write(1, "/dev/null");
  const pid_t process = start(program.campaign(options), streams);
  const std::string journal = program.output() + "/journal.tsv";
  for (int i = 0; i < 2000 && cases_in(journal) < 5; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  kill(process, SIGKILL);
  exit_code_of(process);
  CHECK(cases_in(journal) >= 5);
  std::ofstream(journal, std::ios::app) << "case\t99";  // a line that was cut off
  const Run resumed = run(program.campaign(options));
  CHECK(resumed.exit_code == 1);
  CHECK(has(resumed.out,
            " before that\nnote: the call before this one was killed, or the machine "
            "stopped, after "));
  CHECK(!has(run(program.campaign(options)).out, "was killed"));  // that one ended by itself
  CHECK(cases_in(journal) == 40);
  const Run whole = run(program.campaign(options, "whole"));
  CHECK(last_line(resumed.out) == last_line(whole.out));
  CHECK(program.signatures() == program.signatures("whole"));
  for (const std::string& signature : program.signatures("whole")) {
    CHECK(program.finding(signature, "minimal.node") ==
          program.finding(signature, "minimal.node", "whole"));
  }
  Arguments other = program.campaign({"--cases", "40", "--max-points", "9", "--seed", "5"});
  const Run mismatch = run(other);
  CHECK(mismatch.exit_code == 3);
  CHECK(has(mismatch.err, "expected --seed '0' as when it began, found '5'"));
}

TEST_CASE("campaign: usage, and programs that there are not") {
  const Program program(kRight);
  const auto code = [&](const Arguments& options, const Arguments& command) {
    Arguments all = {"campaign", "--output", program.output(), "--cases", "1"};
    all.insert(all.end(), options.begin(), options.end());
    all.push_back("--");
    all.insert(all.end(), command.begin(), command.end());
    const Run result = run(all);
    CHECK(result.out.empty());
    CHECK(!result.err.empty());
    return result.exit_code;
  };
  CHECK(code({}, {program.path, "{points}"}) == 2);
  CHECK(code({}, {program.path, "{mesh}"}) == 2);
  CHECK(code({"--claim", "delaunay"}, {program.path, "{domain}", "{mesh}"}) == 2);
  CHECK(code({"--families", "nonsense"}, {program.path, "{points}", "{mesh}"}) == 2);
  CHECK(code({"--mesh", "../x.ele"}, {program.path, "{points}"}) == 2);
  CHECK(code({"--limit-time", "soon"}, {program.path, "{points}", "{mesh}"}) == 2);
  CHECK(code({}, {"no-such-program", "{points}", "{mesh}"}) == 3);
  for (const char* option : {"--seed", "--cases", "--max-points", "--minimize-runs"}) {
    for (const char* value : {"-1", "99999999999999999999999", "1.5"}) {
      CHECK(code({option, value}, {program.path, "{points}", "{mesh}"}) == 2);
    }
  }
  CHECK(code({"--limit-processes", "0"}, {program.path, "{points}", "{mesh}"}) == 2);
  CHECK(code({}, {program.path + " -Q", "{points}", "{mesh}"}) == 3);
  CHECK(run({"campaign"}).exit_code == 2);
  CHECK(!fs::exists(program.output()));
}

TEST_CASE("campaign and minimize: no place for the files of programs, or for what is found") {
  const Program program(kRight);
  const std::string input =
      program.folder.write("a.node", "4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n");
  const std::string err = program.folder.path("err");
  const std::string command = " -- " + program.path + " '{points}' '{mesh}' > /dev/null 2> " + err;
  for (const std::string& arguments :
       {"campaign --cases 1 --output " + program.folder.path("none"),
        "minimize " + input + " -o " + program.folder.path("b.node")}) {
    const std::string line = "TMPDIR=/nowhere " CIRCUMSPECT_COMMAND " " + arguments + command;
    CHECK(WEXITSTATUS(std::system(line.c_str())) == 3);
    CHECK(is_error_line(contents(err)));
    CHECK(has(contents(err), "/nowhere/circumspect-campaign-"));
  }
  const Run nowhere = run({"campaign", "--cases", "1", "--output", program.path, "--", program.path,
                           "{points}", "{mesh}"});
  CHECK(nowhere.exit_code == 3);
  CHECK(has(nowhere.err, "/program: expected a folder, or a place for one: Not a directory"));
}

TEST_CASE("campaign: stdin and stdout, other formats, JSON") {
  const Program program("cat > in.node\n" CIRCUMSPECT_COMMAND
                        " build delaunay --quiet in.node -o out.ele && cat out.ele\n");
  const Run result =
      run({"campaign", "--output", program.output(), "--limit-memory", "0", "--cases", "4",
           "--families", "integers", "--stdin", "--stdout", "--dimension", "2", "--first-index",
           "1", "--format", "json", "--", program.path});
  CHECK(result.exit_code == 0);
  const auto campaign = document(result)["results"][0];
  CHECK(campaign["cases"] == 4);
  CHECK(campaign["holds"] == true);
  CHECK(campaign["families"]["integers"]["holds"] == 4);
}

TEST_CASE("campaign: names and words of the program forge no line, and reproduce.sh is a script") {
  const Program program("printf 'error\\033[2J\\nholds: x\\n\\377'; echo nonsense > \"$2\"\n");
  const std::string mesh = "-c\nholds: $(touch forged)'\x1b[1m\xff.ele";
  Arguments arguments = program.campaign({"--cases", "1", "--families", "integers", "--seed", "1",
                                          "--mesh", mesh, "--junit", program.output("report.xml")});
  const Run result = run(arguments);
  CHECK(result.exit_code == 1);
  const std::string shown = "-c\\x0aholds: $(touch forged)'\\x1b[1m\\xff.ele";
  CHECK(has(result.out, "  " + shown + ":1: expected"));
  const std::string junit = contents(program.output("report.xml"));
  CHECK(has(junit, "\\x1b[1m\\xff.ele:1: expected"));
  const auto is_harmless = [](const std::string& text) {
    return !has(text, "\x1b") && !has(text, "\xff") && !has(text, "\nholds: x") &&
           !has(text, "\nholds: $");
  };
  CHECK(is_harmless(result.out));
  CHECK(is_harmless(junit));
  for (const char* const file : {"README.txt", "verdict.json", "reproduce.sh"}) {
    CAPTURE(file);
    CHECK(!program.finding("unreadable-mesh", file).empty());
    CHECK(is_harmless(program.finding("unreadable-mesh", file)));
  }
  CHECK(has(program.finding("unreadable-mesh", "said.txt"), "error\\x1b[2J\nholds: x\n\\xff"));
  // The script finds the mesh under its name, and nothing in the name is run.
  const std::string script = program.output() + "/findings/unreadable-mesh/reproduce.sh";
  const std::string log = program.output("log");
  const std::string line = "cd '" + program.folder.path("") +
                           "' && CIRCUMSPECT=" CIRCUMSPECT_COMMAND " '" + script + "' > '" + log +
                           "' 2>&1";
  CHECK(std::system(line.c_str()) != 0);
  CHECK(has(contents(log), shown + ":1: expected"));
  CHECK(!fs::exists(program.folder.path("forged")));
}

TEST_CASE("campaign: domains") {
  const Program program(CIRCUMSPECT_COMMAND " build steiner-cdt --quiet \"$1\" -o \"$2\"\n");
  const Run result =
      run({"campaign", "--output", program.output(), "--limit-memory", "0", "--cases", "4",
           "--max-points", "8", "--dimension", "2", "--", program.path, "{domain}", "{mesh}"});
  CAPTURE(result.out);
  CAPTURE(result.err);
  CHECK(result.exit_code != 2);
  CHECK(result.exit_code != 3);
}

TEST_CASE("minimize: the smallest input, or exit code 3 if it does not fail") {
  const Program program(forgetful());
  std::string points = "60 3 0 0\n";
  for (int i = 0; i < 60; ++i) {
    points += std::to_string(i) + " " + std::to_string(i * 37 % 61) + " " +
              std::to_string(i * i % 53) + ".5 " + std::to_string(i * 11 % 47) + "\n";
  }
  const std::string input = program.folder.write("big.node", points);
  const std::string output = program.output("small.node");
  const Arguments command = {"minimize", input, "-o",         output,     "--limit-memory",
                             "0",        "--",  program.path, "{points}", "{mesh}"};
  const Run result = run(command);
  CHECK(result.exit_code == 0);
  CHECK(result.err == "minimize: 60 points; ends after 120 s at the latest (--minimize-time)\n");
  CHECK(begins_with(last_line(result.out), "minimized: program "));
  // Five of a plane fail as well, but that has a signature of its own.
  CHECK(begins_with(contents(output), "6 3 0 0\n"));
  const std::string page = program.folder.path("page.html");
  const Run drawn = run({"minimize", output, "-o", "-", "--html", page, "--limit-memory", "0", "--",
                         program.path, "{points}", "{mesh}"});
  CHECK(drawn.exit_code == 0);
  const auto card = shown(page);
  CHECK(card["finding"]["minimal"] == contents(output));
  CHECK(card["finding"]["signature"] == card["report"]["rules"][0]["rule"]);
  CHECK(card["pictures"][0]["dimension"] == 3);
  CHECK(run({"minimize", output, "-o", page, "--html", page, "--", program.path}).exit_code == 2);
  const Program right(kRight);
  const Run holds = run({"minimize", input, "-o", output, "--limit-memory", "0", "--", right.path,
                         "{points}", "{mesh}"});
  CHECK(holds.exit_code == 3);
  CHECK(is_error_line(holds.err));
  CHECK(run({"minimize", "nowhere.node", "-o", output, "--", right.path, "{points}", "{mesh}"})
            .exit_code == 3);
}

}  // namespace
}  // namespace circumspect::cli
