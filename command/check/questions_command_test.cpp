// check --claim convex-hull, surface-delaunay and voronoi, and build voronoi: options, what is
// refused, and that what is built holds.
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "command/run_command_test.hpp"

namespace circumspect::cli {
namespace {

struct SmallLists {
  ScratchFolder folder;
  std::string points =
      folder.write("house.node", "6 2 0 0\n0 0 0\n1 4 0\n2 4 4\n3 0 4\n4 2 0\n5 1 2\n");
  std::string hull = folder.write("house.ele", "4 2 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n");
  std::string flat_points =
      folder.write("cube.node", "4 3 0 0\n0 0 0 0\n1 4 0 0\n2 2 1 0\n3 2 0 1\n");
  std::string wide = folder.write("cube.ele", "2 3 0\n0 0 1 2\n1 1 0 3\n");
};

Run checked(const std::string& mesh, const std::string& claim, std::vector<std::string> more = {}) {
  more.insert(more.begin(), {"check", mesh, "--claim", claim});
  return run(more);
}

}  // namespace

TEST_CASE("check --claim convex-hull: points of the boundary, and what more is demanded of them") {
  SmallLists lists;
  const Run held = checked(lists.hull, "convex-hull");
  CHECK(held.exit_code == 0);
  CHECK(has(held.out, " 6 points 4 edges\n"));
  CHECK(checked(lists.hull, "convex-hull", {"--by", "definition"}).out == held.out);
  CHECK(checked(lists.hull, "convex-hull", {"--only-extreme"}).exit_code == 0);
  const Run left_out = checked(lists.hull, "convex-hull", {"--all-boundary-points"});
  CHECK(left_out.exit_code == 1);
  CHECK(has(left_out.out, "hull.boundary-point-left-out 1 vertex 4"));
}

TEST_CASE("check: where facets alone are listed, a note names the claims that are about these") {
  SmallLists lists;
  const Run edges = run({"check", lists.hull});
  CHECK(edges.exit_code == 1);
  CHECK(has(edges.out, "note: " + lists.hull +
                           ": edges in the plane are a boundary, not a mesh of what is inside. "
                           "--claim convex-hull tells"));
  CHECK(has(run({"check", lists.wide}).out, "triangles in space are a boundary, not a mesh of"));
  for (const std::string& none : {lists.folder.write("house.ele", "2 3 0\n0 0 1 2\n1 0 2\n"),
                                  lists.folder.write("cube.ele", "2 2 0\n0 0 1\n1 0 2\n")}) {
    CHECK(!has(run({"check", none}).out, "are a boundary"));
  }
  const Run as_hull = checked(lists.wide, "convex-hull");
  CHECK(!has(as_hull.out, "are a boundary"));
}

TEST_CASE("check: what is demanded of a hull needs that claim, and the claim no certificate") {
  SmallLists lists;
  const Run other = checked(lists.hull, "triangulation", {"--only-extreme"});
  CHECK(other.exit_code == 2);
  CHECK(has(other.err, "expected --claim convex-hull beside --only-extreme, found none"));
  CHECK(run({"check", lists.hull, "--all-boundary-points"}).exit_code == 2);
  for (const char* option : {"--neighbors", "--memory=1G"}) {
    const Run refused = checked(lists.hull, "convex-hull", {option});
    CHECK(refused.exit_code == 2);
    CHECK(has(refused.err, "beside the claim convex-hull, found it"));
  }
  CHECK(run({"certify", lists.hull, "--claim", "surface-delaunay"}).exit_code == 2);
}

TEST_CASE("check: a claim that makes no sense of a mesh is the input's fault, with what to do") {
  SmallLists lists;
  const Run edges = checked(lists.hull, "surface-delaunay");
  CHECK(edges.exit_code == 3);
  CHECK(has(edges.err, "expected triangles for the claim surface-delaunay, found simplices of 2"));
  const Run no_sites = checked(lists.hull, "voronoi");
  CHECK(no_sites.exit_code == 2);
  CHECK(has(no_sites.err,
            "expected --points FILE beside --claim voronoi, found none: it has the sites"));
  const Run no_cells = checked(lists.hull, "voronoi", {"--points", lists.points});
  CHECK(no_cells.exit_code == 3);
  CHECK(has(no_cells.err,
            "house.ele:1: expected a line with the dimension, as qvoronoi o writes it"));
  const Run worker = run({"campaign", "--claim", "voronoi", "--worker", "--", "true"});
  CHECK(worker.exit_code == 2);
  CHECK(has(worker.err, "expected neither --worker nor --against beside --claim voronoi"));
}

TEST_CASE(
    "check --claim periodic-delaunay: each mesh breaks the rule that its table names, or holds") {
  const std::string corpus = CIRCUMSPECT_CORPUS_DIR "/periodic/";
  std::ifstream table(corpus + "expected.tsv");
  const ScratchFolder folder;
  const std::set<std::string> without_refutation = {"triangulation.unknown-vertex",
                                                    "simplex.wrong-dimension",
                                                    "simplex.orientation", "complex.overlap"};
  std::size_t rows = 0;
  for (std::string line; std::getline(table, line); ++rows) {
    INFO(line);
    std::istringstream columns(line);
    std::string mesh, options, rule;
    std::getline(columns, mesh, '\t');
    std::getline(columns, options, '\t');
    std::getline(columns, rule, '\t');
    std::istringstream words(options);
    const std::vector<std::string> how{std::istream_iterator<std::string>(words), {}};
    const Run judged = checked(corpus + mesh, "periodic-delaunay", how);
    CHECK(judged.exit_code == (rule == "holds" ? 0 : 1));
    CHECK(has(judged.out, rule == "holds" ? "holds: periodic-delaunay" : mesh + " " + rule + " "));
    std::vector<std::string> by_definition = how;
    by_definition.insert(by_definition.end(), {"--by", "definition"});
    CHECK(checked(corpus + mesh, "periodic-delaunay", by_definition).exit_code == judged.exit_code);
    std::vector<std::string> certify = {"certify",           corpus + mesh, "--claim",
                                        "periodic-delaunay", "-o",          folder.path("proof")};
    certify.insert(certify.end(), how.begin(), how.end());
    const Run certified = run(certify);
    if (certified.exit_code == 2) {
      CHECK(without_refutation.contains(rule));
      continue;
    }
    CHECK(certified.exit_code == judged.exit_code);
    CHECK(has(contents(folder.path("proof")), rule == "holds"
                                                  ? "circumspect-certificate 1 periodic-delaunay "
                                                  : "circumspect-refutation 2 periodic-delaunay "));
  }
  CHECK(rows >= 17);
}

TEST_CASE("check --claim periodic-delaunay: corners are named, and told where they are") {
  SmallLists lists;
  lists.folder.write("one.node", "1 2 0 0\n1 0.25 0\n");
  const std::string two =
      lists.folder.write("one.ele", "2 3 6\n1 1 1 1 0 0 1 0 1 1\n2 1 1 1 0 0 0 1 1 1\n");
  const auto judged = [&](const std::string& lattice, std::vector<std::string> more = {}) {
    more.push_back("--lattice=" + lattice);
    return checked(two, "periodic-delaunay", more);
  };
  CHECK(has(judged("1,0,0,1").out, "holds: periodic-delaunay " + two + " 1 point 2 triangles\n"));
  CHECK(judged("1,0,0,1", {"--oriented"}).exit_code == 1);
  const Run long_ = judged("1,0,1,1");
  CHECK(long_.exit_code == 1);
  CHECK(has(long_.out,
            "  simplex  1 1 1 at (0.25, 0) (1.25, 0) (2.25, 1)\n"
            "  face     1 1 at (0.25, 0) (2.25, 1)\n"
            "  vertex   1 at (1.25, 1)\n"));
  const Run json = judged("1,0,1,1", {"--format", "json"});
  const auto violation = nlohmann::json::parse(json.out)["results"][0]["violations"][0];
  CHECK(violation["places"]["face"].dump() == R"([["1/4","0"],["9/4","1"]])");
  CHECK(!violation.contains("coordinates"));
}

TEST_CASE("certify periodic-delaunay: cells that are listed too far from each other are refused") {
  SmallLists lists;
  lists.folder.write("one.node", "1 2 0 0\n1 0.25 0\n");
  const std::string far =
      lists.folder.write("one.ele", "2 3 6\n1 1 1 1 0 0 1 0 1 1\n2 1 1 1 99 0 99 1 100 1\n");
  const Run refused = run({"certify", far, "--claim", "periodic-delaunay", "--lattice=1,0,0,1",
                           "-o", lists.folder.path("proof")});
  CHECK(refused.exit_code == 2);
  CHECK(has(refused.err, "expected cells that are all listed within 64 lattice vectors"));
}

TEST_CASE("check --claim periodic-delaunay: what is refused, and what to do") {
  SmallLists lists;
  lists.folder.write("p.node", "2 2 0 0\n0 0 0\n1 5 5\n");
  const std::string mesh = lists.folder.write("p.ele", "1 3 6\n0 0 0 0 0 0 1 0 0 1\n");
  const std::string bare = lists.folder.write("p.1.ele", "1 3 0\n0 0 0 0\n");
  const auto refused = [&](const std::string& file, std::vector<std::string> more, int code,
                           const std::string& text) {
    more.insert(more.end(), {"--points", lists.folder.path("p.node")});
    const Run run = checked(file, "periodic-delaunay", more);
    CHECK(run.exit_code == code);
    CHECK_MESSAGE(has(run.err, text), run.err);
  };
  refused(mesh, {}, 2,
          "expected --lattice or --box beside --claim periodic-delaunay, found none: say");
  refused(mesh, {"--box=0,0,4,4", "--lattice=1,0,0,1"}, 2, "expected no --lattice beside --box");
  refused(mesh, {"--lattice=1,0,0"}, 3,
          "a lattice of 2 vectors that span the plane, 4 numbers, found 3");
  refused(mesh, {"--lattice=1,2,2,4"}, 3,
          "found vectors that are linearly dependent: give one for each");
  refused(mesh, {"--box=0,0,0,4,4,4"}, 3, "4 numbers, found 9");
  refused(mesh, {"--box=0,0,5,5"}, 3, "found points 0 and 1: list one of them");
  refused(bare, {"--box=0,0,4,4"}, 3,
          "expected 6 attributes of each cell, the offset of each corner, found 0");
  CHECK(checked(mesh, "delaunay", {"--lattice=1,0,0,1"}).exit_code == 2);
  CHECK(run({"campaign", "--claim", "periodic-delaunay", "--", "true", "{points}"}).exit_code == 2);
}

TEST_CASE("check --claim surface-delaunay: the excess, in words and in JSON") {
  SmallLists lists;
  const Run failed = checked(lists.wide, "surface-delaunay");
  CHECK(failed.exit_code == 1);
  CHECK(has(failed.out, "  excess in degrees ~ 73.73979529168804\n"));
  const Run json = checked(lists.wide, "surface-delaunay", {"--format", "json"});
  CHECK(has(json.out, "\"interior_edges\": 1"));
  CHECK(has(json.out, "\"decimal\": \"73.73979529168804\""));
}

TEST_CASE("build voronoi: what it makes is what check reads, and holds within its rounding") {
  SmallLists lists;
  const Run built = run({"build", "voronoi", lists.points});
  REQUIRE(built.exit_code == 0);
  const std::string cells = lists.folder.write("house.qvoronoi", built.out);
  const Run exact = checked(cells, "voronoi", {"--points", lists.points, "--within", "1e-12"});
  CHECK(exact.exit_code == 0);
  CHECK(has(exact.out, " 6 sites 6 cells within "));
  const Run structure =
      checked(cells, "voronoi", {"--points", lists.points, "--within", "1e-12", "--structure"});
  CHECK(structure.exit_code == 0);
  CHECK(has(structure.out, " vertices "));
  CHECK(has(structure.out, " ridges\n"));
  const Run boxed =
      checked(cells, "voronoi", {"--points", lists.points, "--box", "0,0,1,1", "--within=1e-12x"});
  CHECK(boxed.exit_code == 0);
  const Run json = run({"build", "voronoi", lists.points, "--format", "json"});
  CHECK(has(json.out, "\"exact\""));
  const std::string line = lists.folder.write("line.node", "2 2 0 0\n0 0 0\n1 1 1\n");
  const Run flat = run({"build", "voronoi", line});
  CHECK(flat.exit_code == 3);
  CHECK(has(flat.err, "expected sites that span"));
}

TEST_CASE("check --claim voronoi: the box and the distance") {
  SmallLists lists;
  const std::string cells =
      lists.folder.write("none", "2\n1 6 1\n-10.101 -10.101\n0\n0\n0\n0\n0\n0\n");
  const Run missing = checked(cells, "voronoi", {"--points", lists.points});
  CHECK(missing.exit_code == 1);
  CHECK(has(missing.out, "voronoi.cell-missing 6 vertex 0"));
  const Run bare = checked(cells, "voronoi", {"--points", lists.points, "--structure"});
  CHECK(bare.exit_code == 3);
  CHECK(has(bare.err, "expected ridges with their ends for --structure, found none: run qvoronoi"));
  CHECK(has(run({"check", lists.hull, "--structure"}).err,
            "expected --claim voronoi beside --structure, found none"));
  const Run box = checked(cells, "voronoi", {"--points", lists.points, "--box", "1,1,0,2"});
  CHECK(box.exit_code == 2);
  CHECK(has(box.err, "expected X0,Y0,X1,Y1 or X0,Y0,Z0,X1,Y1,Z1 with X0 < X1 and so on"));
  CHECK(run({"check", lists.hull, "--box", "0,0,1,1"}).exit_code == 2);
}

}  // namespace circumspect::cli
