// check --claim convex-hull, surface-delaunay and voronoi, and build voronoi: options, what is
// refused, and that what is built holds.
#include <doctest/doctest.h>

#include "command/run_command.hpp"

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
  CHECK(run({"campaign", "--claim", "voronoi", "--", "true", "{points}"}).exit_code == 2);
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
  const Run box = checked(cells, "voronoi", {"--points", lists.points, "--box", "1,1,0,2"});
  CHECK(box.exit_code == 2);
  CHECK(has(box.err, "expected X0,Y0,X1,Y1 or X0,Y0,Z0,X1,Y1,Z1 with X0 < X1 and so on"));
  CHECK(run({"check", lists.hull, "--box", "0,0,1,1"}).exit_code == 2);
}

}  // namespace circumspect::cli
