// Domains and meshes as people have them: --resolve, --drop, corners that were rounded.
#include <doctest/doctest.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {
namespace {

// A square with both diagonals, whose crossing the program made a vertex.
struct Crossing {
  ScratchFolder folder;
  std::string mesh = written("2 2");
  std::string domain = folder.write(
      "d.poly",
      "4 2 0 0\n0 0 0\n1 4 0\n2 4 4\n3 0 4\n6 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n4 0 2\n5 1 3\n0\n");

  std::string written(const std::string& crossing) const {
    folder.write("x.node", "5 2 0 0\n0 0 0\n1 4 0\n2 4 4\n3 0 4\n4 " + crossing + "\n");
    return folder.write("x.ele", "4 3 0\n0 0 1 4\n1 1 2 4\n2 2 3 4\n3 3 0 4\n");
  }
};

const std::string kTerrain =
    "v 0 0 1\nv 4 0 2\nv 4 4 0\nv 0 4 3\nv 2 2 5\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";

}  // namespace

TEST_CASE("check --resolve: segments that cross are judged as their arrangement") {
  const Crossing square;
  const Run refused = run({"check", square.mesh, "--domain", square.domain});
  CHECK(refused.exit_code == 3);
  CHECK(has(refused.err, "plc.crossing-segments"));
  CHECK(has(refused.err,
            "; if the program makes a vertex where segments meet, check --resolve judges its "
            "mesh"));
  const Run resolved = run({"check", square.mesh, "--domain", square.domain, "--resolve"});
  CHECK_MESSAGE(resolved.exit_code == 0, (resolved.out + resolved.err));
  CHECK(
      has(resolved.out,
          "d.poly: 6 segments resolved into 8, with 1 vertex where they meet, numbered from 4\n"));
  CHECK(has(resolved.out, "holds: cdt "));
  // A crossing that the program rounded is within a distance of where it is.
  const std::string rounded = square.written("2.0000001 2");
  CHECK(run({"check", rounded, "--domain", square.domain, "--resolve"}).exit_code == 1);
  CHECK(run({"check", rounded, "--domain", square.domain, "--resolve", "--within", "1e-6"})
            .exit_code == 0);
  // Without the crossing a diagonal is missing.
  square.folder.write("y.node", "4 2 0 0\n0 0 0\n1 4 0\n2 4 4\n3 0 4\n");
  const std::string two = square.folder.write("y.ele", "2 3 0\n0 0 1 2\n1 0 2 3\n");
  CHECK(has(run({"check", two, "--domain", square.domain, "--resolve"}).out,
            "domain.vertex-missing"));
}

TEST_CASE("check --resolve: overlaps, repeated points and what it does not go with") {
  const Crossing square;
  const std::string untidy =
      square.folder.write("u.poly",
                          "5 2 0 0\n0 0 0\n1 4 0\n2 4 4\n3 0 4\n4 0 0\n5 0\n0 0 1\n1 1 0\n2 1 2\n3 "
                          "2 3\n4 3 4\n0\n");
  square.folder.write("y.node", "4 2 0 0\n0 0 0\n1 4 0\n2 4 4\n3 0 4\n");
  const std::string two = square.folder.write("y.ele", "2 3 0\n0 0 1 2\n1 0 2 3\n");
  const Run tidy = run({"check", two, "--domain", untidy, "--resolve"});
  CHECK_MESSAGE(tidy.exit_code == 0, (tidy.out + tidy.err));
  CHECK(has(tidy.out, "; 1 equal point merged\n"));
  CHECK(run({"check", two, "--resolve"}).exit_code == 2);
  CHECK(run({"certify", two, "--domain", untidy, "--resolve"}).exit_code == 2);
}

TEST_CASE("check --domain: polygons as rings, with holes and without hole seeds") {
  const ScratchFolder folder;
  // A square with a hole, which a second polygon fills, and a third beside.
  const std::string whole =
      folder.write("w.wkt",
                   "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 3 1, 3 3, 1 3, 1 1))\n"
                   "POLYGON ((1 1, 3 1, 3 3, 1 3)) POLYGON ((4 0, 6 0, 6 4, 4 4))\n");
  const std::string ring = folder.write("r.geojson",
                                        "{\"type\": \"Polygon\", \"coordinates\": [[[0, 0], [4, "
                                        "0], [4, 4], [0, 4], [0, 0]],\n[[1, 1], "
                                        "[3, 1], [3, 3], [1, 3], [1, 1]]]}\n");
  const std::string points = "8 2 0 0\n0 0 0\n1 4 0\n2 4 4\n3 0 4\n4 1 1\n5 3 1\n6 3 3\n7 1 3\n";
  const std::string around =
      "0 0 1 5\n1 0 5 4\n2 1 2 6\n3 1 6 5\n4 2 3 7\n5 2 7 6\n6 3 0 4\n7 3 4 7\n";
  folder.write("m.node", points);
  const std::string mesh = folder.write("m.ele", "8 3 0\n" + around);
  const Run holds = run({"check", mesh, "--domain", ring});
  CHECK_MESSAGE(holds.exit_code == 0, (holds.out + holds.err));
  CHECK(has(holds.out, "r.geojson enclosed, what its faces cover\n"));
  const Run fills = run({"check", mesh, "--domain", ring, "--fill", "enclosed"});
  CHECK(fills.exit_code == 1);
  CHECK(has(fills.out, "domain.uncovered"));
  CHECK(run({"check", mesh, "--domain", whole}).exit_code == 1);
  folder.write("n.node", "10" + points.substr(1) + "8 6 0\n9 6 4\n");
  const std::string all =
      folder.write("n.ele", "12 3 0\n" + around + "8 4 5 6\n9 4 6 7\n10 1 8 9\n11 1 9 2\n");
  const Run both = run({"check", all, "--domain", whole});
  CHECK_MESSAGE(both.exit_code == 0, (both.out + both.err));
  CHECK(has(run({"inspect", ring}).out, "8 vertices 8 segments"));
}

TEST_CASE("check --domain: rings that are no holes are named") {
  const ScratchFolder folder;
  const auto noted = [&](const std::string& rings) {
    const std::string text = "POLYGON ((0 0, 9 0, 9 9, 0 9), (1 1, 5 1, 5 5, 1 5)" + rings + ")\n";
    return run({"inspect", "--domain", folder.write("d.wkt", text)}).out;
  };
  CHECK(!has(noted(""), "no hole"));
  CHECK(has(noted(", (2 2, 3 2, 3 3)"),
            "d.wkt: ring 3 of polygon 1, which has vertex 8, lies in the hole of ring 2: no hole, "
            "but an island that is filled\n"));
  CHECK(has(noted(", (10 1, 11 1, 11 2), (2 2, 3 2, 3 3)"),
            "d.wkt: ring 3 of polygon 1, which has vertex 8, lies outside of ring 1: no hole, but "
            "a part that is filled (and 1 more)\n"));
}

TEST_CASE("check --resolve: rings that cross cover what an odd number of them enclose") {
  const ScratchFolder folder;
  const std::string tie = folder.write("tie.json", "[[0, 0], [2, 2], [2, 0], [0, 2]]\n");
  folder.write("m.node", "5 2 0 0\n0 0 0\n1 2 2\n2 2 0\n3 0 2\n4 1 1\n");
  const std::string wings = folder.write("m.ele", "2 3 0\n0 0 4 3\n1 1 4 2\n");
  CHECK(has(run({"check", wings, "--domain", tie}).err,
            "tie.json:1: expected a piecewise linear complex, "
            "found plc.crossing-segments"));
  const Run resolved = run({"check", wings, "--domain", tie, "--resolve"});
  CHECK_MESSAGE(resolved.exit_code == 0, (resolved.out + resolved.err));
  // Where two squares of one polygon overlap, nothing is covered.
  const std::string two =
      folder.write("two.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4), (2 2, 6 2, 6 6, 2 6))\n");
  folder.write("s.node",
               "10 2 0 0\n0 0 0\n1 4 0\n2 4 2\n3 2 2\n4 2 4\n5 0 4\n6 6 2\n7 6 6\n8 2 6\n9 4 4\n");
  const std::string ells = folder.write(
      "s.ele", "8 3 0\n0 0 1 3\n1 1 2 3\n2 0 3 5\n3 3 4 5\n4 2 6 9\n5 6 7 9\n6 7 8 9\n7 8 4 9\n");
  const Run judged =
      run({"check", ells, "--domain", two, "--resolve", "--claim", "plc-triangulation"});
  CHECK_MESSAGE(judged.exit_code == 0, (judged.out + judged.err));
}

TEST_CASE("check --drop: a terrain is judged as it is seen from above") {
  const ScratchFolder folder;
  const std::string terrain = folder.write("t.obj", kTerrain);
  CHECK(run({"check", terrain}).exit_code == 1);
  const Run seen = run({"check", terrain, "--drop", "z"});
  CHECK_MESSAGE(seen.exit_code == 0, (seen.out + seen.err));
  CHECK(has(seen.out, "note: " + terrain + ": the coordinate z was left out (--drop)\n"));
  CHECK(has(seen.out, "holds: delaunay " + terrain + " 5 points 4 triangles"));
  // Along y the points are 0 1, 4 2, 4 0, 0 3, 2 5, and triangles lie over one another.
  CHECK(run({"check", terrain, "--drop", "y", "--claim", "complex"}).exit_code == 1);
  // Where z is the same for all, it is not missed.
  const std::string flat = folder.write("f.obj", "v 0 0 7\nv 4 0 7\nv 0 4 7\nf 1 2 3\n");
  CHECK(run({"check", flat, "--drop", "z"}).exit_code == 0);
  const std::string solid = folder.write(
      "s.mesh",
      "MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
      "Tetrahedra 1\n1 2 3 4 0\nEnd\n");
  const Run refused = run({"check", solid, "--drop", "z"});
  CHECK(refused.exit_code == 3);
  CHECK(has(refused.err, "expected triangles or edges for --drop, found a simplex of 4 vertices"));
  folder.write("p.node", "3 2\n0 0 0\n1 4 0\n2 0 4\n");
  CHECK(has(run({"check", folder.write("p.ele", "1 3\n0 0 1 2\n"), "--drop", "x"}).err,
            "expected points with 3 coordinates for --drop, found 2"));
  CHECK(run({"check", terrain, "--drop", "w"}).exit_code == 2);
}

TEST_CASE("--dimension: numbers behind the coordinates are left out") {
  const ScratchFolder folder;
  const std::string scan =
      folder.write("scan.xyz", "0 0 0 9 8 7\n1 0 0 9 8 7\n0 1 0 9 8 1\n0 0 1 9 8 2\n");
  CHECK(has(run({"inspect", scan}).out, "give --dimension 3\n"));
  const Run seen = run({"inspect", scan, "--dimension", "3"});
  CHECK(has(seen.out, "the first 3 of 6 numbers of each point are taken for coordinates"));
  CHECK(has(seen.out, "dimension 3 of 3"));
  const std::string mesh = folder.write("m.qhull-i", "1\n0 1 2 3\n");
  CHECK(run({"check", mesh, "--points", scan, "--dimension", "3"}).exit_code == 0);
  CHECK(has(run({"inspect", scan, "--dimension", "7"}).err,
            "expected points with at least 7 numbers for --dimension, found 6"));
  CHECK(run({"inspect", scan, "--dimension", "0"}).exit_code == 2);
}

TEST_CASE("check --within: a polygon whose corners were rounded off its plane is taken for flat") {
  const ScratchFolder folder;
  const auto points_of = [](const std::string& corner) {
    return "8 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 1 1 0\n4 0 0 1\n5 1 0 1\n6 0 1 1\n7 1 1 " +
           corner + "\n";
  };
  const std::string facets =
      "6 0\n1\n4 0 1 3 2\n1\n4 4 5 7 6\n1\n4 0 2 6 4\n1\n4 1 3 7 5\n1\n4 0 1 5 4\n1\n4 2 3 7 "
      "6\n0\n0\n";
  const auto domain_of = [&](const std::string& corner) {
    folder.write("c.node", points_of(corner));
    return folder.write("c.poly", points_of(corner) + facets);
  };
  const std::string cells =
      "6 4 0\n0 0 1 3 7\n1 0 1 5 7\n2 0 2 3 7\n3 0 2 6 7\n4 0 4 5 7\n5 0 4 6 7\n";
  const std::string mesh = folder.write("c.ele", cells);
  const auto judged = [&](const std::string& domain, const std::string& of,
                          const std::string& distance) {
    return run(
        {"check", of, "--domain", domain, "--claim", "plc-triangulation", "--within", distance});
  };
  const std::string domain = domain_of("1.0000000000000002");
  CHECK(run({"check", mesh, "--domain", domain, "--claim", "plc-triangulation"}).exit_code == 3);
  const Run holds = judged(domain, mesh, "1e-12");
  CHECK_MESSAGE(holds.exit_code == 0, (holds.out + holds.err));
  CHECK(has(holds.out, "c.poly: 1 polygon taken for flat, whose corners are up to a distance of "));
  // The distance bounds how uneven a polygon may be, and a missing cell is still missing.
  const Run uneven = judged(domain, mesh, "1e-18");
  CHECK(uneven.exit_code == 3);
  CHECK(has(uneven.err, "plc.polygon-not-planar"));
  folder.write("d.node", points_of("1.0000000000000002"));
  const std::string hole = folder.write("d.ele", "5 4 0\n" + cells.substr(6, 50));
  const Run fails = judged(domain, hole, "1e-12");
  CHECK_MESSAGE(fails.exit_code == 1, (fails.out + fails.err));
  CHECK(judged(domain_of("1.5"), mesh, "1e-12").exit_code == 3);
}

}  // namespace circumspect::cli
