// campaign --html: a page of what was found.
#include <doctest/doctest.h>

#include "command/run_command.hpp"

namespace circumspect::cli {
namespace {

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
