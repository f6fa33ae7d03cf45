// What circumspect compare reads: points elsewhere, points of a plane in space, simplices that are
// listed twice.
#include <doctest/doctest.h>

#include "command/run_command_test.hpp"
#include "oracle/formats/flat_square_test.hpp"
#include "oracle/formats/reading_test.hpp"

namespace circumspect::cli {
namespace {

using formats::flat_square;
using formats::flat_square_meshes;

}  // namespace

TEST_CASE(
    "compare: one mesh of the plane is the same in every format, and notes say what was left out") {
  const ScratchFolder folder;
  const std::vector<std::string> meshes = flat_square_meshes(folder, "m", "0");
  folder.write("plane.node", "4 2\n0 0 0\n1 1 0\n2 1 1\n3 0 1\n");
  const std::string plane = folder.write("plane.ele", "2 3\n0 0 1 2\n1 0 2 3\n");
  for (const std::string& a : meshes) {
    const Run same = run({"compare", a, plane});
    CHECK(same.exit_code == 0);
    CHECK(has(same.out, ": the third coordinate, 0 for all points, was left out\n"));
    CHECK(run({"compare", meshes.front(), a}).exit_code == 0);
  }
  const auto json = document(run({"compare", meshes.front(), plane, "--format", "json"}));
  CHECK(json["results"][0]["notes"].size() == 1);
}

TEST_CASE("compare: planes of other heights, and surfaces, are compared in space") {
  const ScratchFolder folder;
  const std::string low = folder.write("low.off", flat_square("0").at(".off"));
  const std::string high = folder.write("high.obj", flat_square("2").at(".obj"));
  const Run apart = run({"compare", low, high});
  CHECK(apart.exit_code == 1);
  CHECK(has(apart.out, "only in " + high + ": point 1 (0, 0, 2)\n"));
  CHECK(!has(apart.out, "left out"));
  std::string bent = flat_square("0").at(".off");
  bent.replace(bent.find("1 1 0"), 5, "1 1 1");
  const Run surface = run({"compare", low, folder.write("bent.off", bent)});
  CHECK(surface.exit_code == 1);
  CHECK(has(surface.out, "only in " + low + ": point 2 (1, 1, 0)\n"));
  CHECK(has(surface.out, "differ: 1 point 2 simplices only in "));
  folder.write("line.node", "2 1\n0 0\n1 1\n");
  const Run other = run({"compare", low, folder.write("line.ele", "1 2\n0 0 1\n")});
  CHECK(other.exit_code == 1);
  CHECK(has(other.out, "has points of dimension 3 and " + folder.path("line.ele") +
                           " of dimension 1: no point is in both\n"));
}

TEST_CASE("compare: a simplex that both have and one lists more often is only listed once more") {
  const ScratchFolder folder;
  const std::string points = "4 2\n0 0 0\n1 1 0\n2 0 1\n3 1 1\n";
  folder.write("a.node", points);
  folder.write("b.node", points);
  const std::string a = folder.write("a.ele", "1 3\n0 0 1 2\n");
  const std::string b = folder.write("b.ele", "4 3\n0 0 1 2\n1 1 2 0\n2 2 1 3\n3 1 2 3\n");
  const Run differ = run({"compare", a, b});
  CHECK(differ.exit_code == 1);
  CHECK(differ.out == "only in " + b + ": simplex 2 1 3\nonly in " + b + ": simplex 1 2 3\n" +
                          "listed once more in " + b + ": simplex 1 2 0\n" +
                          "differ: 0 points 0 simplices only in " + a +
                          ", 0 points 2 simplices only in " + b +
                          ", 1 simplex listed once more in " + b + "\n");
  const Run turned = run({"compare", b, a, "--format", "json"});
  const auto side = document(turned)["results"][0]["only_in_a"];
  CHECK(side["simplex_count"] == 2);
  CHECK(side["repeated_count"] == 1);
  CHECK(side["repeated"] == nlohmann::json({{1, 2, 0}}));
  const std::string twice = folder.write("a.ele", "2 3\n0 0 1 2\n1 1 2 0\n");
  const std::string thrice = folder.write("b.ele", "3 3\n0 0 1 2\n1 1 2 0\n2 1 0 2\n");
  CHECK(has(run({"compare", twice, thrice}).out, "differ: 0 points 0 simplices only in "));
  CHECK(run({"compare", twice, thrice}).exit_code == 1);
}

TEST_CASE(
    "compare: points of either mesh may be in another file, which messages name by its option") {
  const ScratchFolder folder;
  const std::string points = folder.write("p.node", "4 2\n0 0 0\n1 1 0\n2 0 1\n3 1 1\n");
  const std::string a = folder.write("a.ele", "2 3\n0 0 1 3\n1 2 0 3\n");
  const std::string b = folder.write("b.ele", "2 3\n0 0 1 3\n1 2 0 3\n");
  CHECK(run({"compare", a, b, "--points-a", points, "--points-b", points}).exit_code == 0);
  const Run lacking = run({"compare", a, b, "--points-a", points});
  CHECK(lacking.exit_code == 3);
  CHECK(has(lacking.err, "(--points-b names another)"));
  const std::string npy =
      folder.write("s.npy", formats::npy<std::int32_t>("<i4", "(2, 3)", {0, 1, 3, 2, 0, 3}));
  const std::string of_npy =
      folder.write("p.npy", formats::npy<double>("<f8", "(4, 2)", {0, 0, 1, 0, 0, 1, 1, 1}));
  CHECK(has(run({"compare", npy, a}).err, "--points-a"));
  CHECK(run({"compare", npy, a, "--points-a", of_npy, "--points-b", points}).exit_code == 0);
  CHECK(
      run({"compare", a, "-", "--points-a", points, "--points-b", points}, contents(b)).exit_code ==
      0);
  const Run streams = run({"compare", a, "-", "--points-a", "-", "--points-b", points}, "");
  CHECK(streams.exit_code == 2);
  CHECK(
      run({"compare", a, b, "--points-a", points, "--points-b", points, "-o", points}).exit_code ==
      2);
}

TEST_CASE("build: -o OUT.ele writes the points beside it, so that compare reads what was built") {
  const ScratchFolder folder;
  const std::string csv = folder.write("p.csv", "x,y\n0,0\n2,0\n0,2\n0.1,0.3\n0,0\n");
  const std::string ele = folder.path("out.ele");
  CHECK(run({"build", "delaunay", csv, "-o", ele, "--duplicates", "merge"}).exit_code == 0);
  CHECK(contents(folder.path("out.node")) == "5 2 0 0\n0 0 0\n1 2 0\n2 0 2\n3 0.1 0.3\n4 0 0\n");
  const std::string json = folder.path("out.json");
  CHECK(run({"build", "delaunay", csv, "-o", json, "--duplicates", "merge"}).exit_code == 0);
  CHECK(run({"compare", ele, json, "--duplicates", "merge"}).exit_code == 0);
  // Weights are the first attribute; of equal points with weights the heaviest is left.
  const std::string weighted =
      folder.write("w.node", "5 2 1\n7 0 0 1\n8 2 0 0\n9 0 2 0\n10 0 0 3\n11 0 0 2\n");
  const std::string of_weighted = folder.path("v.ele");
  CHECK(run({"build", "weighted-delaunay", weighted, "-o", of_weighted, "--duplicates", "merge"})
            .exit_code == 0);
  CHECK(contents(folder.path("v.node")) ==
        "5 2 1 0\n7 0 0 3\n8 2 0 0\n9 0 2 0\n10 0 0 3\n11 0 0 3\n");
  CHECK(contents(of_weighted) == "1 3 0\n7 10 8 9\n");
}

TEST_CASE("build: points are not written over themselves, and not beside a stream") {
  const ScratchFolder folder;
  const std::string text = "# mine\n3 2\n1 0 0\n2 1 0\n3 0 1\n";
  const std::string node = folder.write("x.node", text);
  CHECK(run({"build", "delaunay", node, "-o", folder.path("x.ele")}).exit_code == 0);
  CHECK(contents(node) == text);
  CHECK(run({"check", folder.path("x.ele")}).exit_code == 0);
  CHECK(run({"build", "delaunay", node, "-o", "-"}).exit_code == 0);
  const Run clash = run({"build", "delaunay", node, "-o", folder.path("y.ele"), "--neighbors",
                         folder.path("y.node")});
  CHECK(clash.exit_code == 2);
}

}  // namespace circumspect::cli
