// circumspect rule, as its users run it.
#include <doctest/doctest.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST_CASE("rule: lists all rules of meshes, then what can be wrong with a domain") {
  const Run all = run({"rule"});
  CHECK(all.exit_code == 0);
  CHECK(has(all.out, "What a mesh can break:\n  triangulation.unknown-vertex "));
  CHECK(has(all.out, "What can be wrong with a domain:\n  plc.index-out-of-range "));
  CHECK(has(all.out,
            "\n  complex.overlap                 two simplices meet in more than a common "
            "face\n"));
  CHECK(run({"rule", "--quiet"}).out.empty());
}

TEST_CASE("rule: prints the page of one, without what only a browser shows") {
  const Run page = run({"rule", "complex.overlap"});
  CHECK(page.exit_code == 0);
  const std::vector<std::string> lines = lines_of(page.out);
  REQUIRE(lines.size() > 20);
  CHECK(lines[0] == "complex.overlap");
  CHECK(begins_with(lines[2], "Rule 8, judged of "));
  CHECK(has(page.out, "\nWhat usually causes it\n"));
  CHECK(has(page.out, "\n  $ circumspect check corpus/reject/complex.overlap--2d.ele\n"));
  CHECK(has(page.out, "delaunator-overlap"));
  CHECK(begins_with(lines.back(), "Read on in docs/"));
  CHECK(has(lines.back(), "docs/from-meshers.md"));
  CHECK(has(lines.back(), ", hunt/pages/delaunator.md"));
  CHECK(has(run({"rule", "cdt.visible-vertex-in-ball"}).out, "docs/rules/cdt.facet-not-local.md"));
  for (const char* mark : {"](", "![", "```", "\n#", "\n\n\n"}) CHECK_FALSE(has(page.out, mark));
}

TEST_CASE("rule: in JSON, with the stored number of each") {
  const auto all = document(run({"rule", "--format", "json"}))["results"];
  REQUIRE(all.size() > 40);
  CHECK(all[0]["rule"] == "triangulation.unknown-vertex");
  CHECK(all[0]["number"] == 1);
  CHECK(all[0]["stage"] == "simplices");
  CHECK_FALSE(all[0].contains("page"));
  const auto one = document(run({"rule", "plc.polygons-cross", "--format", "json"}))["results"];
  REQUIRE(one.size() == 1);
  CHECK(one[0]["number"] == 10);
  CHECK(has(one[0]["page"].get<std::string>(), "How to mend it\n"));
}

TEST_CASE("rule: an unknown one is a matter of usage, and the nearest is named") {
  const Run near = run({"rule", "complex.overlp"});
  CHECK(near.exit_code == 2);
  CHECK(near.out.empty());
  CHECK(near.err ==
        "circumspect: expected the identifier of a rule (circumspect rule lists them), found "
        "complex.overlp; the nearest is complex.overlap\n");
  CHECK_FALSE(has(run({"rule", "frobnicate"}).err, "nearest"));
  // Without the word before the dot, which nobody remembers.
  CHECK(has(run({"rule", "overlap"}).err, "; the nearest is complex.overlap"));
  CHECK(has(run({"rule", "polygons-cross"}).err, "; the nearest is plc.polygons-cross"));
  CHECK(run({"rule", "a", "b"}).exit_code == 2);
}

}  // namespace
}  // namespace circumspect::cli
