// circumspect compare, as its users run it.
#include <doctest/doctest.h>

#include "oracle/cli/run_command.hpp"

namespace circumspect::cli {
namespace {

constexpr const char* kSquare = "4 2\n1 0 0\n2 1 0\n3 0 1\n4 1 1\n";
constexpr const char* kRisingDiagonal = "2 3\n1 1 2 4\n2 1 4 3\n";
constexpr const char* kFallingDiagonal = "2 3\n1 1 2 3\n2 2 3 4\n";

// Writes NAME.node and NAME.ele and gives back the latter.
std::string mesh(const ScratchFolder& folder, const std::string& name, const std::string& points,
                 const std::string& simplices) {
  folder.write(name + ".node", points);
  return folder.write(name + ".ele", simplices);
}

TEST_CASE("compare: the same mesh, counted from 0 and turned around") {
  const ScratchFolder folder;
  const std::string a = mesh(folder, "a", kSquare, kRisingDiagonal);
  const std::string b =
      mesh(folder, "b", "4 2\n0 1 1\n1 0 1\n2 1 0\n3 0 0\n", "2 3\n0 0 1 3\n1 2 0 3\n");
  const Run same = run({"compare", a, b});
  CHECK(same.exit_code == 0);
  CHECK(same.out == "same: " + a + " " + b + " 4 points 2 simplices\n");
  CHECK(document(run({"compare", a, b, "--format", "json"}))["results"][0]["same"] == true);
  CHECK(run({"compare", a, b, "--quiet"}).out.empty());
}

TEST_CASE("compare: names the simplices that differ by the user's own indices") {
  const ScratchFolder folder;
  const std::string a = mesh(folder, "a", kSquare, kRisingDiagonal);
  const std::string b = mesh(folder, "b", kSquare, kFallingDiagonal);
  const Run differ = run({"compare", a, b, "--max-errors", "1"});
  CHECK(differ.exit_code == 1);
  CHECK(differ.out == "only in " + a + ": simplex 1 2 4\n" + "only in " + a +
                          ": 1 more simplices; --max-errors 0 shows all\n" + "only in " + b +
                          ": simplex 1 2 3\n" + "only in " + b +
                          ": 1 more simplices; --max-errors 0 shows all\n" +
                          "differ: 0 points 2 simplices only in " + a +
                          ", 0 points 2 simplices only in " + b + "\n");
  const auto json = document(run({"compare", a, b, "--format", "json"}))["results"][0];
  CHECK(json["same"] == false);
  CHECK(json["only_in_b"]["simplices"] == nlohmann::json({{1, 2, 3}, {2, 3, 4}}));
}

TEST_CASE("compare: names the points that differ by their exact coordinates") {
  const ScratchFolder folder;
  const std::string a = mesh(folder, "a", "3 2\n1 0 0\n2 1 0\n3 0 1/3\n", "1 3\n1 1 2 3\n");
  const std::string b = mesh(folder, "b", "3 2\n1 0 0\n2 1 0\n3 0 0.3333\n", "1 3\n1 1 2 3\n");
  const Run differ = run({"compare", a, b});
  CHECK(differ.exit_code == 1);
  CHECK(has(differ.out, "only in " + a + ": point 3 (0, 1/3)\n"));
  CHECK(has(differ.out, "only in " + b + ": point 3 (0, 0.3333)\n"));
  const auto json = document(run({"compare", a, b, "--format", "json"}))["results"][0];
  CHECK(json["only_in_a"]["points"][0]["coordinates"] == nlohmann::json({"0", "1/3"}));
}

TEST_CASE("compare: a file that cannot be read, and two on one standard input") {
  const ScratchFolder folder;
  const std::string a = mesh(folder, "a", kSquare, kRisingDiagonal);
  const Run missing = run({"compare", a, folder.path("none.ele")});
  CHECK(missing.exit_code == 3);
  CHECK(is_error_line(missing.err));
  CHECK(run({"compare", "-", "-"}).exit_code == 2);
  CHECK(run({"compare", a}).exit_code == 2);
}

}  // namespace
}  // namespace circumspect::cli
