// circumspect generate, as its users run it.
#include <filesystem>

#include <doctest/doctest.h>

#include "command/run_command_test.hpp"
#include "inputs/families.hpp"
#include "inputs/triangulated/domain_families.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::cli {
namespace {

Run generate(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "generate");
  return run(arguments);
}

TEST_CASE("generate: one set on stdout, the same bytes for a seed") {
  const Run grid = generate({"grid", "--seed", "1", "--points", "6", "--dimension", "2"});
  CHECK(grid.exit_code == 0);
  CHECK(grid.err.empty());
  CHECK(grid.out ==
        "5 2 0 0\n"
        "0 2 0\n"
        "1 1 2\n"
        "2 2 2\n"
        "3 2 1\n"
        "4 1 1\n");
  CHECK(generate({"sphere+ulp", "--seed", "7", "--points", "3"}).out ==
        "3 3 0 0\n"
        "0 -3.4285714285714284 -6.514285714285714 0.5428571428571429\n"
        "1 3.285714285714285 -2.857142857142857 3.4285714285714284\n"
        "2 -3.789473684210526 1.2631578947368418 -10.789473684210527\n");
  CHECK(generate({"submerged", "--seed", "2", "--points", "5", "--dimension", "2"}).out ==
        "5 2 1 0\n"
        "0 -12 -12 0\n"
        "1 48 0 0\n"
        "2 0 48 0\n"
        "3 1 3 0\n"
        "4 -3 -2 0\n");
  CHECK(generate({"planar-grid", "--seed", "2", "--points", "4"}).out ==
        "3 2 0 0\n"
        "0 2 0\n"
        "1 0 0\n"
        "2 1 2\n"
        "6 0\n"
        "0 2 0\n"
        "1 0 1\n"
        "2 1 2\n"
        "3 2 0\n"
        "4 0 1\n"
        "5 0 1\n"
        "0\n"
        "# planar; --fill hull\n");
  CHECK(generate({"grid"}).out == generate({"grid", "--seed", "0", "-o", "-"}).out);
  CHECK(generate({"grid"}).out != generate({"grid", "--seed", "1"}).out);
}

TEST_CASE(
    "generate: numbers are doubles, or exact; there are as many points as asked for, or fewer") {
  const Run rounded = generate({"sphere", "--seed", "2"});
  const Run exact = generate({"sphere", "--seed", "2", "--coordinates", "exact"});
  CHECK_FALSE(has(rounded.out, "/"));
  CHECK(has(exact.out, "/"));
  CHECK(begins_with(generate({"uniform", "--points", "500"}).out, "500 3 0 0\n"));
  CHECK_FALSE(begins_with(generate({"uniform", "--points", "500", "--fewer"}).out, "500 "));
  CHECK(begins_with(generate({"small-weights", "--points", "2"}).out, "2 3 1 0\n"));
}

TEST_CASE("generate: our JSON on stdout or in a file") {
  const Run result = generate({"parallel-lifted", "--points", "6", "--format", "json"});
  CHECK(result.exit_code == 0);
  CHECK(document(result)["dimension"] == 3);
  CHECK(document(result)["weights"].size() == document(result)["points"].size());
  const formats::ScratchFolder folder;
  const Run written = generate({"grid", "-o", folder.path("grid.json"), "--format", "json"});
  CHECK(document(written)["results"][0]["output"] == folder.path("grid.json"));
  CHECK(nlohmann::json::parse(contents(folder.path("grid.json")))["points"].size() ==
        document(written)["results"][0]["points"]);
}

TEST_CASE("generate: files, one a seed, each the one that its seed gives alone") {
  const formats::ScratchFolder folder;
  const std::string sets = folder.path("sets");
  const Run result = generate({"grid", "--count", "3", "--seed", "5", "-o", sets});
  CHECK(result.exit_code == 0);
  CHECK(begins_with(result.out, "generated: grid " + sets + "/grid-5.node "));
  CHECK(contents(sets + "/grid-6.node") == generate({"grid", "--seed", "6"}).out);
  CHECK(std::filesystem::exists(sets + "/grid-7.node"));
  CHECK_FALSE(std::filesystem::exists(sets + "/grid-8.node"));
  CHECK(generate({"planar-grid", "-o", sets, "--quiet"}).out.empty());
  CHECK(std::filesystem::exists(sets + "/planar-grid-0.poly"));
  CHECK(generate({"grid", "-o", sets + "/one.node"}).exit_code == 0);
  CHECK(contents(sets + "/one.node") == generate({"grid"}).out);
}

TEST_CASE("generate --list: every family, as text and as JSON") {
  const Run text = generate({"--list"});
  const Run json = generate({"--list", "--format", "json"});
  CHECK(text.exit_code == 0);
  CHECK(json.exit_code == 0);
  const nlohmann::json table = document(json)["results"][0];
  REQUIRE(table["points"].size() == generators::families().size());
  REQUIRE(table["domains"].size() == properties::domain_families().size());
  for (std::size_t i = 0; i < generators::families().size(); ++i) {
    CHECK(table["points"][i]["name"] == generators::families()[i].name);
    CHECK(has(text.out, "\n  " + generators::families()[i].name + " "));
  }
  for (const auto& modifier : generators::family_modifiers()) {
    CHECK(has(text.out, "\n  +" + modifier.name + " "));
  }
  for (const auto& family : properties::domain_families()) {
    CHECK(has(text.out, "\n  " + family.name + " "));
  }
  CHECK(table["points"][0]["dimensions"].size() == 16);
}

// Each call, and a part of the one line that must come of it.
TEST_CASE("generate: errors say what was expected and found") {
  const formats::ScratchFolder folder;
  const std::vector<std::pair<std::vector<std::string>, std::string>> calls = {
      {{"spheer"}, "found 'spheer'; the nearest are sphere, "},
      {{"sphere+ulps"}, "expected modifiers after sphere, of +ulp, +scaled, +moved; found '+ulps'"},
      {{"planar-grid+scaled"},
       "expected modifiers after planar-grid, of +ulp, +moved, +rotated; found '+scaled'"},
      {{"skew-lines", "--dimension", "2"}, "skew-lines exists in dimension 3 and above; "},
      {{"twisted-prism", "--dimension", "4"}, "twisted-prism exists in dimension 3; "},
      {{"pythagorean-sphere", "--dimension", "7"}, "exists in dimension 2 to 6; "},
      {{"planar-grid", "--dimension", "3"}, "planar-grid exists in dimension 2; "},
      {{"grid", "--count", "2"}, "expected -o FOLDER for 2 inputs, found none"},
      {{"grid", "--count", "2", "-o", "-"}, "expected -o FOLDER for 2 inputs, found -o -"},
      {{"furnished-boxes", "--format", "json"}, "expected points for --format json"},
      {{"grid", "-o", folder.path("no/such/folder.node")},
       "expected a place that can be written to"},
      {{"grid", "--count", "2", "-o", folder.write("file", "")}, "can be written to"},
      {{}, "expected the name of a family or --list"},
  };
  for (const auto& call : calls) {
    const auto& [arguments, expected] = call;
    const std::string part = expected;
    const Run result = generate(arguments);
    CAPTURE(result.err);
    CAPTURE(part);
    CHECK(result.exit_code == 2);
    CHECK(result.out.empty());
    CHECK(is_error_line(result.err));
    CHECK(has(result.err, part));
  }
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"grid", "--count", "0"},
        {"grid", "--points", "0"},
        {"grid", "--points", "-1"},
        {"grid", "--dimension", "17"},
        {"grid", "--seed", "x"},
        {"grid", "--coordinates", "decimal"}}) {
    CHECK(generate(arguments).exit_code == 2);
  }
}

// What is generated is read, built and checked by the other subcommands, in every family: in both
// dimensions, and families with a modifier in one of them, in turn.
TEST_CASE("generate, build, check: every family of points") {
  const formats::ScratchFolder folder;
  const std::string points = folder.path("x.node"), mesh = folder.path("x.ele");
  std::size_t turn = 0;
  for (const auto& family : generators::modified_families()) {
    const bool is_modified = family.name.find('+') != std::string::npos;
    ++turn;
    for (const std::size_t dimension : {2, 3}) {
      if (!family.exists_in(dimension)) continue;
      if (is_modified && family.exists_in(5 - dimension) && turn % 2 == dimension % 2) continue;
      if (is_modified && turn / 2 % properties::one_input_in() != 0) continue;
      CAPTURE(family.name);
      CAPTURE(dimension);
      const std::string number = std::to_string(dimension);  // and the seed
      REQUIRE(generate({family.name, "--seed", number, "--points", "7", "--dimension", number, "-o",
                        points})
                  .exit_code == 0);
      const std::string what = family.weighted ? "weighted-delaunay" : "delaunay";
      const std::string merge = family.repeats_points ? "merge" : "reject";
      CHECK(run({"build", what, points, "-o", mesh, "--duplicates", merge}).exit_code == 0);
      const Run checked = run({"check", mesh, "--claim", what, "--duplicates", merge});
      CAPTURE(checked.out);
      CAPTURE(checked.err);
      CHECK(checked.exit_code == 0);
    }
  }
}

TEST_CASE("generate, inspect: every family of domains is a piecewise linear complex") {
  const formats::ScratchFolder folder;
  const std::string domain = folder.path("x.poly");
  for (const auto& family : properties::domain_families()) {
    for (const std::string seed : {"1", "2", "3"}) {
      CAPTURE(family.name);
      CAPTURE(seed);
      REQUIRE(generate({family.name, "--seed", seed, "--points", "8", "-o", domain}).exit_code ==
              0);
      const Run inspected = run({"inspect", domain});
      CAPTURE(inspected.out);
      CAPTURE(inspected.err);
      CHECK((inspected.exit_code == 0 || inspected.exit_code == 4));
    }
  }
}

TEST_CASE("generate: a seed is a whole number, neither negative nor cut off") {
  for (const char* seed : {"-1", "99999999999999999999999", "1.5", "x"}) {
    CHECK(run({"generate", "uniform", "--seed", seed}).exit_code == 2);
  }
  CHECK(run({"generate", "uniform", "--seed", "18446744073709551615"}).exit_code == 0);
}

}  // namespace
}  // namespace circumspect::cli
