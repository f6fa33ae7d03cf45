// A mesh or a domain of the plane whose points have three coordinates: one answer, whatever the
// formats.
#include <doctest/doctest.h>

#include "command/run_command_test.hpp"
#include "oracle/formats/flat_square_test.hpp"

namespace circumspect::cli {
namespace {

using formats::flat_square;
using formats::flat_square_meshes;

Run check(const std::string& mesh, const std::string& domain,
          const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments = {"check", mesh, "--domain", domain};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run(std::move(arguments));
}

// A ring of eight triangles around a square hole; `z`: of each point, after a blank, or nothing in
// the plane.
std::string ring(const std::string& header, const std::string& z) {
  std::string text = header + "\n8 8 0\n";
  for (const char* const point : {"0 0", "6 0", "6 6", "0 6", "2 2", "4 2", "4 4", "2 4"}) {
    text += point + z + "\n";
  }
  return text + "3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n";
}

}  // namespace

TEST_CASE("check: each mesh of a flat square holds against each form of its domain, in the plane") {
  const ScratchFolder folder;
  const std::vector<std::string> meshes = flat_square_meshes(folder, "m", "0");
  const std::string plane = folder.write("plane.node", "4 2\n0 0 0\n1 1 0\n2 1 1\n3 0 1\n");
  const std::string ele = folder.write("plane.ele", "2 3\n0 0 1 2\n1 0 2 3\n");
  for (const auto& [end, text] : flat_square("0")) {
    const std::string domain = folder.write("d" + end, text);
    std::vector<std::string> arguments = {"check", ele};
    arguments.insert(arguments.end(), meshes.begin(), meshes.end());
    arguments.insert(arguments.end(), {"--domain", domain, "--claim", "plc-triangulation"});
    const Run all = run(std::move(arguments));
    CAPTURE(all.out);
    CHECK(all.exit_code == 0);
    CHECK(has(all.out, domain + ": the third coordinate, 0 for all points, was left out\n"));
    CHECK(has(all.out, "holds: plc-triangulation " + ele + " 4 points 2 triangles\n"));
    for (const std::string& mesh : meshes) {
      CHECK(has(all.out, "holds: plc-triangulation " + mesh + " 4 points 2 triangles\n"));
    }
  }
}

TEST_CASE("check: of a flat surface the faces are filled, and a hole among them is not") {
  const ScratchFolder folder;
  const std::string in_space = folder.write("space.off", ring("OFF", " 0"));
  const std::string in_plane = folder.write("plane.off", ring("nOFF 2", ""));
  std::string filled = ring("OFF", " 0");
  filled.replace(filled.find("8 8 0"), 5, "8 10 0");
  const std::string whole = folder.write("whole.off", filled + "3 4 5 6\n3 4 6 7\n");
  for (const std::string& domain : {in_space, in_plane}) {
    for (const std::string& mesh : {in_space, in_plane}) {
      const Run holds = check(mesh, domain);
      CHECK(holds.exit_code == 0);
      CHECK(has(holds.out, "no face covers 1 of the 9 that are enclosed"));
      CHECK(has(holds.out, "domain: " + domain + " enclosed, what its faces cover\n"));
    }
    const Run outside = check(whole, domain);
    CHECK(outside.exit_code == 1);
    CHECK(has(outside.out, "domain.outside"));
    CHECK(check(whole, domain, {"--fill", "enclosed"}).exit_code == 0);
    CHECK(has(check(in_space, domain, {"--fill", "enclosed"}).out, "domain.uncovered"));
  }
  // A face without area, which goes back on itself, covers nothing of what is beside it.
  std::string with_line = contents(in_plane);
  with_line.replace(with_line.find("8 8 0"), 5, "8 10 0");
  const std::string same = folder.write("line.off", with_line + "4 4 5 6 5\n4 6 5 4 5\n");
  CHECK(check(in_space, same).exit_code == 0);
}

TEST_CASE("check: facets with several lines and holes fill what they fill in space") {
  const ScratchFolder folder;
  // A square with a square hole, in which there is an island.
  const std::string points =
      "12 3\n0 0 0 7\n1 9 0 7\n2 9 9 7\n3 0 9 7\n4 1 1 7\n5 8 1 7\n6 8 8 7\n7 1 8 7\n8 3 3 7\n"
      "9 5 3 7\n10 5 5 7\n11 3 5 7\n";
  const std::string domain =
      folder.write("d.poly", points + "2\n2 1\n4 0 1 2 3\n4 4 5 6 7\n0 2 2 7\n1\n4 8 9 10 11\n0\n");
  folder.write("m.node", points);
  const std::string frame =
      "0 0 1 5\n1 0 5 4\n2 1 2 6\n3 1 6 5\n4 2 3 7\n5 2 7 6\n6 3 0 4\n7 3 4 7\n";
  const std::string mesh = folder.write("m.ele", "10 3\n" + frame + "8 8 9 10\n9 8 10 11\n");
  const Run holds = check(mesh, domain, {"--claim", "plc-triangulation"});
  CHECK(holds.exit_code == 0);
  CHECK(has(holds.out, " 12 points 10 triangles\n"));
  const std::string bare = folder.write("m.ele", "8 3\n" + frame);
  CHECK(has(check(bare, domain, {"--claim", "plc-triangulation"}).out, "domain."));
}

TEST_CASE("check: a mesh that is not in the plane of its flat domain is held against it in space") {
  const ScratchFolder folder;
  const auto surfaces = flat_square("0");
  const std::string domain = folder.write("d.off", surfaces.at(".off"));
  const std::string above = folder.write("above.off", flat_square("5").at(".off"));
  const Run apart = check(above, domain);
  CHECK(apart.exit_code == 1);
  CHECK(has(apart.out, above + ": no mesh of the plane in which " + domain + " lies"));
  CHECK(has(apart.out, "domain.vertex-missing"));
  CHECK(has(apart.out, "squared distance 25"));
  // Rounded off the plane: beyond it exactly, and within a distance in it.
  folder.write("r.node", "4 3\n0 0 0 1e-17\n1 1 0 0\n2 1 1 0\n3 0 1 0\n");
  const std::string rounded = folder.write("r.ele", "2 3\n0 0 1 2\n1 0 2 3\n");
  CHECK(check(rounded, domain).exit_code == 1);
  const Run within = check(rounded, domain, {"--within", "1e-12x"});
  CHECK(within.exit_code == 0);
  CHECK(has(within.out, "4 points 0 tetrahedra 2 dangling"));
  // Tetrahedra are wrong, not an input of the wrong dimension.
  folder.write("t.node", "5 3\n0 0 0 0\n1 1 0 0\n2 1 1 0\n3 0 1 0\n4 0 0 1\n");
  const Run solid = check(folder.write("t.ele", "1 4\n0 0 1 2 4\n"), domain);
  CHECK(solid.exit_code == 1);
  CHECK(has(solid.out, "fails: steiner-cdt "));
  // All in one run, each in its own.
  const std::string flat = folder.write("flat.obj", surfaces.at(".obj"));
  const Run both = run({"check", flat, above, flat, "--domain", domain});
  CHECK(both.exit_code == 1);
  CHECK(has(both.out, "holds: cdt " + flat));
  CHECK(has(both.out, "fails: steiner-cdt " + above));
  // Points with two coordinates have no space to go to.
  const std::string plane =
      folder.write("p.off", "nOFF 2\n4 2 0\n0 0\n1 0\n1 1\n0 1\n3 0 1 2\n3 0 2 3\n");
  const Run refused = check(rounded, plane);
  CHECK(refused.exit_code == 3);
  CHECK(has(refused.err, "expected points of dimension 2, as those of " + plane));
}

TEST_CASE("check: a flat domain is as valid in the plane as it is in space") {
  const ScratchFolder folder;
  const std::string mesh = folder.write("m.off", flat_square("0").at(".off"));
  const std::string overlap =
      folder.write("d.obj", "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 2 1 0\nf 1 2 3\nf 1 2 5\n");
  const Run refused = check(mesh, overlap);
  CHECK(refused.exit_code == 3);
  CHECK(has(refused.err, "plc.polygons-overlap"));
}

TEST_CASE("check: polygons of a flat domain are joined before it is taken for the plane") {
  const ScratchFolder folder;
  const std::string domain = folder.write("d.off", flat_square("0").at(".off"));
  folder.write("m.node", "4 2\n0 0 0\n1 1 0\n2 1 1\n3 0 1\n");
  const std::string other = folder.write("m.ele", "2 3\n0 0 1 3\n1 1 2 3\n");
  CHECK(has(check(other, domain).out, "domain.segment-missing"));
  const Run joined = check(other, domain, {"--merge-coplanar"});
  CHECK(joined.exit_code == 0);
  CHECK(has(joined.out, "2 polygons joined into 1, without 1 segment between them"));
}

TEST_CASE("certify: the numbers are those of the files that circumspect-verified reads") {
  const ScratchFolder folder;
  const std::vector<std::string> meshes = flat_square_meshes(folder, "m", "0");
  const std::string certificate = folder.path("c");
  const Run ele = run({"certify", folder.path("m.ele"), "-o", certificate});
  CHECK(ele.exit_code == 0);
  CHECK(begins_with(contents(certificate), "circumspect-certificate 1 delaunay 3 flat\n"));
  CHECK(run({"check", folder.path("m.ele"), "--certificate", certificate}).exit_code == 0);
  CHECK(run({"certify", folder.path("m.off"), "-o", certificate}).exit_code == 0);
}

TEST_CASE("points of --hole may have the coordinates of the file") {
  const ScratchFolder folder;
  const std::string domain = folder.write("d.off", ring("OFF", " 3"));
  const std::string mesh = folder.write("m.off", ring("nOFF 2", ""));
  CHECK(check(mesh, domain, {"--fill", "enclosed", "--hole", "3,3"}).exit_code == 0);
  CHECK(check(mesh, domain, {"--fill", "enclosed", "--hole", "3,3,3"}).exit_code == 0);
  CHECK(check(mesh, domain, {"--fill", "enclosed", "--hole", "3,3,2"}).exit_code == 3);
}

}  // namespace circumspect::cli
