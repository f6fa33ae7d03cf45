// circumspect compare, as its users run it.
#include <doctest/doctest.h>

#include "command/run_command.hpp"

namespace circumspect::cli {
namespace {

constexpr const char* kUnitSquare = "4 2\n1 0 0\n2 1 0\n3 0 1\n4 1 1\n";
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
  const std::string a = mesh(folder, "a", kUnitSquare, kRisingDiagonal);
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
  const std::string a = mesh(folder, "a", kUnitSquare, kRisingDiagonal);
  const std::string b = mesh(folder, "b", kUnitSquare, kFallingDiagonal);
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

std::string weighted_triangle(const std::string& weights) {
  return R"({"circumspect":1,"dimension":2,"points":[[0,0],[1,0],[0,1]],)" + weights +
         R"("simplices":[[0,1,2]]})";
}

TEST_CASE("compare: the weights of JSON tell points apart") {
  const ScratchFolder folder;
  const std::string a = folder.write("a.json", weighted_triangle(R"("weights":[5,5,5],)"));
  const std::string b = folder.write("b.json", weighted_triangle(R"("weights":[6,5,5],)"));
  const std::string none = folder.write("none.json", weighted_triangle(""));
  const std::string zero = folder.write("zero.json", weighted_triangle(R"("weights":[0,0,0],)"));
  const Run differ = run({"compare", a, b});
  CHECK(differ.exit_code == 1);
  CHECK(differ.out ==
        "only in " + a + ": point 0 (0, 0; weight 5)\n" + "only in " + a + ": simplex 0 1 2\n" +
            "only in " + b + ": point 0 (0, 0; weight 6)\n" + "only in " + b + ": simplex 0 1 2\n" +
            "differ: 1 point 1 simplex only in " + a + ", 1 point 1 simplex only in " + b + "\n");
  auto json = document(run({"compare", a, b, "--format", "json"}))["results"][0];
  CHECK(json["weighted"] == true);
  CHECK(json["only_in_a"]["points"][0]["weight"] == "5");
  CHECK(run({"compare", a, a}).out == "same: " + a + " " + a + " 3 points 1 simplex weighted\n");
  // What has no weights has the weights 0.
  CHECK(run({"compare", a, none}).exit_code == 1);
  CHECK(run({"compare", zero, none}).exit_code == 0);
  CHECK(run({"compare", none, none}).out == "same: " + none + " " + none + " 3 points 1 simplex\n");
  // Unless they are asked for.
  CHECK(run({"compare", a, none, "--weighted"}).exit_code == 3);
}

TEST_CASE("compare: the first attributes of .node are weights if --weighted says so") {
  const ScratchFolder folder;
  const std::string triangle = "1 3\n1 1 2 3\n";
  const std::string a = mesh(folder, "a", "3 2 2\n1 0 0 5 1\n2 1 0 5 1\n3 0 1 5 1\n", triangle);
  const std::string b = mesh(folder, "b", "3 2 1\n1 0 0 6\n2 1 0 5\n3 0 1 5\n", triangle);
  const std::string json = folder.write("b.json", weighted_triangle(R"("weights":[6,5,5],)"));
  CHECK(run({"compare", a, b}).exit_code == 0);
  const Run differ = run({"compare", a, b, "--weighted"});
  CHECK(differ.exit_code == 1);
  CHECK(has(differ.out, "only in " + a + ": point 1 (0, 0; weight 5)\n"));
  CHECK(has(differ.out, "only in " + b + ": point 1 (0, 0; weight 6)\n"));
  CHECK(has(differ.out, "differ: 1 point 1 simplex only in "));
  CHECK(run({"compare", a, a, "--weighted"}).out ==
        "same: " + a + " " + a + " 3 points 1 simplex weighted\n");
  CHECK(run({"compare", b, json, "--weighted"}).exit_code == 0);
  const Run guessed = run({"compare", b, json});
  CHECK(guessed.exit_code == 1);
  CHECK(has(guessed.out, "note: " + json + " has weights and " + b +
                             " has none; --weighted takes the first attributes of a .node file "
                             "for weights\n"));
  const std::string plain = mesh(folder, "plain", "3 2\n1 0 0\n2 1 0\n3 0 1\n", triangle);
  const Run missing = run({"compare", a, plain, "--weighted"});
  CHECK(missing.exit_code == 3);
  CHECK(has(missing.err, "plain.node: expected a weight for each point"));
  CHECK(has(run({"compare", "--help"}).out, "--weighted"));
}

TEST_CASE("compare: of merged points the heaviest counts") {
  const ScratchFolder folder;
  const std::string twice = folder.write(
      "twice.json",
      R"({"circumspect":1,"dimension":1,"points":[[0],[1],[0]],"weights":[1,0,2],"simplices":[[0,1]]})");
  const std::string once = folder.write(
      "once.json",
      R"({"circumspect":1,"dimension":1,"points":[[0],[1]],"weights":[2,0],"simplices":[[0,1]]})");
  CHECK(run({"compare", twice, once, "--duplicates", "merge"}).exit_code == 0);
  CHECK(run({"compare", twice, once}).exit_code == 3);
}

TEST_CASE("compare: a file that cannot be read, and two on one standard input") {
  const ScratchFolder folder;
  const std::string a = mesh(folder, "a", kUnitSquare, kRisingDiagonal);
  const Run missing = run({"compare", a, folder.path("none.ele")});
  CHECK(missing.exit_code == 3);
  CHECK(is_error_line(missing.err));
  CHECK(run({"compare", "-", "-"}).exit_code == 2);
  CHECK(run({"compare", a}).exit_code == 2);
}

}  // namespace
}  // namespace circumspect::cli
