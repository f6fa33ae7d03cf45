// Man pages and completions say what --help says.
#include <array>
#include <cstdio>
#include <filesystem>
#include <regex>

#include <doctest/doctest.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {
namespace {

const std::vector<std::string> kSubcommands = {"check",    "certify",  "build",    "inspect",
                                               "replay",   "campaign", "minimize", "adapter",
                                               "generate", "compare",  "rule"};

// What a shell command prints on either stream.
std::string shell(const std::string& command) {
  FILE* const pipe = popen(("{ " + command + "\n} 2>&1").c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string text;
  std::array<char, 4096> part{};
  for (std::size_t size = 0; (size = fread(part.data(), 1, part.size(), pipe)) > 0;) {
    text.append(part.data(), size);
  }
  pclose(pipe);
  return text;
}

// All long options in a text, each once.
std::vector<std::string> long_options(const std::string& text) {
  std::vector<std::string> found;
  const std::regex option("^  (?:-.,)?(--[a-z-]+)", std::regex::multiline);
  for (std::sregex_iterator match(text.begin(), text.end(), option), end; match != end; ++match) {
    found.push_back((*match)[1]);
  }
  return found;
}

std::string in_roff(const std::string& text) {
  return std::regex_replace(text, std::regex("-"), "\\-");
}

struct Pages {
  ScratchFolder folder;

  Pages() { REQUIRE(run({"command-pages", folder.path("share")}).exit_code == 0); }

  std::string man(const std::string& name) const {
    return contents(folder.path("share/man/man1/" + name + ".1"));
  }
  // What bash offers for the last of these words.
  std::string offered(const std::string& words) const {
    return shell(
        "bash -c 'source " + folder.path("share/bash-completion/completions/circumspect") +
        "; COMP_WORDS=(circumspect " + words +
        "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _circumspect; echo \"${COMPREPLY[@]}\"'");
  }
};

TEST_CASE("command-pages: a man page has every option that --help has, and its words") {
  const Pages pages;
  for (const std::string& subcommand : kSubcommands) {
    CAPTURE(subcommand);
    const std::string page = pages.man("circumspect-" + subcommand);
    const std::vector<std::string> options = long_options(run({subcommand, "--help"}).out);
    CHECK(!options.empty());
    for (const std::string& option : options) CHECK(has(page, "\\fB" + in_roff(option) + "\\fR"));
  }
  const std::string check = pages.man("circumspect-check");
  CHECK(has(check, ".SH NAME\ncircumspect\\-check \\- Judge meshes"));
  CHECK(has(check, "\\fB\\-\\-by\\fR \\fIlemma|definition\\fR\n"));
  CHECK(has(check, ".SH EXIT STATUS\n0 the claim holds, 1 it does not"));
  CHECK(has(check, ".SH EXAMPLES\n.nf\n  tetgen points.node"));
  CHECK(has(pages.man("circumspect-build-delaunay"), "\\fBcircumspect\\-build\\fR(1)"));
  CHECK(has(pages.man("circumspect"), "\\fBcircumspect\\-check\\fR(1)"));
  CHECK(!has(pages.man("circumspect"), "command\\-pages"));
  CHECK(!has(run({"--help"}).out, "command-pages"));
}

TEST_CASE("command-pages: groff has nothing to complain about") {
  const Pages pages;
  if (shell("command -v groff").empty()) return;
  for (const auto& page :
       std::filesystem::directory_iterator(pages.folder.path("share/man/man1"))) {
    CAPTURE(page.path().string());
    CHECK(shell("groff -man -Tutf8 -ww -z " + page.path().string()) == "");
  }
}

TEST_CASE("command-pages: bash offers subcommands, options and words") {
  const Pages pages;
  CHECK(pages.offered("ch") == "check\n");
  CHECK(pages.offered("build steiner") == "steiner-cdt\n");
  CHECK(pages.offered("check --dom") == "--domain --domain-kind\n");
  CHECK(pages.offered("check --claim steiner") == "steiner-triangulation steiner-cdt\n");
  CHECK(pages.offered("check --domain-kind h") == "hull\n");
  // A file, which is readline's own; and what belongs to the other program.
  CHECK(pages.offered("check --domain x") == "\n");
  CHECK(pages.offered("campaign -- tetgen -") == "\n");
  for (const std::string& subcommand : kSubcommands) {
    CAPTURE(subcommand);
    const std::string offered = " " + pages.offered(subcommand + " --");
    for (const std::string& option : long_options(run({subcommand, "--help"}).out)) {
      CHECK(std::regex_search(offered, std::regex(" " + option + "[ \n]")));
    }
  }
}

TEST_CASE("command-pages: zsh reads its file") {
  const Pages pages;
  const std::string file = pages.folder.path("share/zsh/site-functions/_circumspect");
  CHECK(begins_with(contents(file), "#compdef circumspect\n"));
  CHECK(has(contents(file), "'--by[Judge by the lemmas]:value:(lemma definition)'"));
  if (shell("command -v zsh").empty()) return;
  CHECK(shell("zsh -n " + file) == "");
}

TEST_CASE("command-pages: a folder that cannot be made is a matter of usage") {
  const ScratchFolder folder;
  const Run refused = run({"command-pages", folder.write("file", "")});
  CHECK(refused.exit_code == 2);
  CHECK(is_error_line(refused.err));
}

}  // namespace
}  // namespace circumspect::cli
