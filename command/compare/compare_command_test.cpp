// circumspect compare, as its users run it.
#include <set>

#include <doctest/doctest.h>

#include "command/run_command_test.hpp"

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

TEST_CASE("compare: a simplex that names no point is a fault of the input") {
  const ScratchFolder folder;
  const std::string a = mesh(folder, "a", kUnitSquare, kRisingDiagonal);
  const std::string unknown = mesh(folder, "unknown", kUnitSquare, "1 3 0\n1 1 2 9\n");
  for (const auto& [first, second] : {std::pair{a, unknown}, {unknown, a}, {unknown, unknown}}) {
    const Run refused = run({"compare", first, second});
    CHECK(refused.exit_code == 3);
    CHECK(has(refused.err, unknown + ": expected simplices that name points of the mesh, found "
                                     "simplex 1 2 9: there is no point 9\n"));
  }
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

TEST_CASE("compare: a page has a card for each place at which the meshes differ") {
  const ScratchFolder folder;
  // Two squares apart, counted from 1 and from 0; a triangle that both have; a point that only B
  // has.
  const std::string square = "1 0 0\n2 1 0\n3 0 1\n4 1 1\n5 8 0\n6 9 0\n7 8 1\n8 9 1\n9 2 0\n";
  const std::string a =
      mesh(folder, "a", "9 2\n" + square, "5 3\n1 1 2 4\n2 1 4 3\n3 5 6 8\n4 5 8 7\n5 2 9 4\n");
  const std::string b =
      mesh(folder, "<script>alert(1)<!--",
           "10 2\n0 0 0\n1 1 0\n2 0 1\n3 1 1\n4 8 0\n5 9 0\n6 8 1\n7 9 1\n8 2 0\n9 5 5\n",
           "5 3\n0 0 1 2\n1 1 2 3\n2 4 5 6\n3 5 6 7\n4 1 8 3\n");
  const std::string page = folder.path("page.html");
  const Run plain = run({"compare", a, b});
  const Run differ = run({"compare", a, b, "--html", page});
  CHECK(differ.exit_code == 1);
  CHECK(differ.out == plain.out);
  CHECK(!has(contents(page), "<script>alert"));
  const auto result = shown(page);
  CHECK(has(plain.out, result["line"].get<std::string>()));
  REQUIRE(result["cards"].size() == 3);
  const auto& card = result["cards"][0];
  CHECK(card["meaning"] == "2 simplices only in A, and 2 simplices only in B");
  CHECK(card["simplices"] == nlohmann::json({{1, 2, 4}, {1, 4, 3}, {0, 1, 2}, {1, 2, 3}}));
  CHECK(card["groups"][1]["count"] == 2);
  CHECK(card["coordinates"]["A4 B3"] == nlohmann::json({"1", "1"}));
  CHECK(result["pictures"][0]["names"][0] == "A1 B0");
  CHECK(result["pictures"][0]["near"].size() == 1);
  CHECK(result["pictures"][1]["near"].empty());
  CHECK(result["cards"][2]["meaning"] == "1 point only in B");
  CHECK(result["pictures"][2]["core"] == 1);
  CHECK(result["pictures"][2]["names"][0] == "B9");
  // Each simplex is drawn once, by the same places of points where both meshes have them.
  std::set<int> places;
  for (const auto& simplex : result["pictures"][0]["simplices"]) {
    for (const auto& place : simplex) places.insert(place.get<int>());
  }
  CHECK(places.size() == 4);
}

TEST_CASE("compare: meshes of one cube that have no facet in common share a card") {
  const ScratchFolder folder;
  const std::string page = folder.path("page.html");
  const std::string peers = CIRCUMSPECT_CORPUS_DIR "/peers/";
  CHECK(run({"compare", peers + "tetgen/cube-3d.1.ele", peers + "cgal/cube-3d.ele", "--html", page})
            .exit_code == 1);
  CHECK(shown(page)["cards"].size() == 1);
  CHECK(shown(page)["cards"][0]["meaning"] == "6 simplices only in A, and 6 simplices only in B");
}

TEST_CASE("compare: a page names a point by both meshes' index where one simplex alone differs") {
  const ScratchFolder folder;
  const std::string page = folder.path("page.html");
  const std::string a = mesh(folder, "a", kUnitSquare, "1 3\n1 1 2 3\n");
  const std::string b = mesh(folder, "b", kUnitSquare, kFallingDiagonal);
  CHECK(run({"compare", a, b, "--html", page}).exit_code == 1);
  CHECK(shown(page)["pictures"][0]["names"] == nlohmann::json({"2", "3", "4", ""}));
}

TEST_CASE("compare: what differs is never called common, however many simplices one place has") {
  const ScratchFolder folder;
  const std::string page = folder.path("page.html");
  // A fan of forty triangles, none of which B has.
  std::string points = "42 2\n1 0 0\n";
  std::string fan = "40 3\n";
  for (int i = 0; i < 41; ++i) {
    points += std::to_string(i + 2) + " " + std::to_string(i - 20) + " 10\n";
    if (i < 40) {
      fan += std::to_string(i + 1) + " 1 " + std::to_string(i + 3) + " " + std::to_string(i + 2) +
             "\n";
    }
  }
  const std::string a = mesh(folder, "a", points, fan);
  const std::string b = mesh(folder, "b", points, "1 3\n1 2 42 22\n");
  CHECK(run({"compare", a, b, "--html", page}).exit_code == 1);
  const auto result = shown(page);
  REQUIRE(result["cards"].size() >= 2);
  std::size_t simplices = 0;
  for (std::size_t i = 0; i < result["cards"].size(); ++i) {
    CHECK(result["cards"][i]["simplices"].size() <= 30);
    CHECK(result["pictures"][i]["near"].empty());  // both have nothing in common
    simplices += result["cards"][i]["simplices"].size();
  }
  CHECK(simplices == 41);
}

TEST_CASE("compare: a page of meshes that are the same, or that no picture shows, has words") {
  const ScratchFolder folder;
  const std::string page = folder.path("page.html");
  const std::string a = mesh(folder, "a", kUnitSquare, kRisingDiagonal);
  CHECK(run({"compare", a, a, "--html", page}).exit_code == 0);
  CHECK(shown(page)["verdict"] == "holds");
  CHECK(shown(page)["cards"].empty());
  const std::string space =
      mesh(folder, "space", "4 3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n", "1 4\n1 1 2 3 4\n");
  CHECK(run({"compare", a, space, "--html", page}).exit_code == 1);
  CHECK(shown(page)["cards_note"] ==
        "The points of A have 2 coordinates, and those of B have 3 coordinates, so no picture "
        "shows both.");
}

TEST_CASE("compare: of very many differences the first are in the page, which says so") {
  const ScratchFolder folder;
  std::string points = "606 2\n";
  std::string rising = "404 3\n";
  std::string falling = rising;
  for (int i = 0; i < 202; ++i) {
    for (int row = 0; row < 3; ++row) {
      points += std::to_string(3 * i + row + 1) + " " + std::to_string(i) + " " +
                std::to_string(row) + "\n";
    }
  }
  int number = 0;
  for (int i = 0; i < 202; ++i) {
    // Squares apart from each other: every other column.
    if (i % 2 == 1) continue;
    for (int row = 0; row < 2; ++row) {
      const auto at = [i, row](int x, int y) { return std::to_string(3 * (i + x) + row + y + 1); };
      for (std::string* both : {&rising, &falling}) {
        const bool rises = both == &rising;
        *both += std::to_string(number + 1) + " " + at(0, 0) + " " + at(1, 0) + " " +
                 at(rises ? 1 : 0, 1) + "\n" + std::to_string(number + 2) + " " +
                 at(rises ? 0 : 1, 0) + " " + at(1, 1) + " " + at(0, 1) + "\n";
      }
      number += 2;
    }
  }
  const std::string a = mesh(folder, "a", points, rising);
  const std::string b = mesh(folder, "b", points, falling);
  const std::string page = folder.path("page.html");
  CHECK(run({"compare", a, b, "--html", page}).exit_code == 1);
  CHECK(shown(page)["cards"].size() == 100);
  CHECK(shown(page)["cards_note"] == "800 of 808 simplices that differ are in a card here.");
}

TEST_CASE("compare: a page never replaces a mesh, and has a name") {
  const ScratchFolder folder;
  const std::string a = mesh(folder, "a", kUnitSquare, kRisingDiagonal);
  const std::string before = contents(a);
  const Run over = run({"compare", a, a, "--html", a});
  CHECK(over.exit_code == 2);
  CHECK(has(over.err, "expected another name for the page"));
  CHECK(contents(a) == before);
  CHECK(has(run({"compare", a, a, "--html", "-"}).err, "expected a file for --html, found -"));
  const std::string out = folder.path("out.vtu");
  CHECK(run({"compare", a, a, "--html", out, "-o", out}).exit_code == 2);
}

}  // namespace
}  // namespace circumspect::cli
