// What build writes of a domain, in every form, check reads again; and what could not be read again
// is not written.
#include <doctest/doctest.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {
namespace {

// A quadrilateral with one Delaunay diagonal.
const std::string kPlane = "4 2\n1 0 0\n2 3 0\n3 3 1\n4 0 2\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n";
// The same over x and y in a plane of space that is aslant: one with a constant z is the plane.
const std::string kFlat = "4 3\n1 0 0 5\n2 3 0 8\n3 3 1 8\n4 0 2 5\n1 0\n1\n4 1 2 3 4\n0\n";
// A tetrahedron; apart from it a triangle and, at one of its corners, a segment.
const std::string kDangling =
    "8 3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 3 3 3\n6 4 3 3\n7 3 4 3\n8 9 9 9\n"
    "6\n1\n3 1 2 3\n1\n3 1 2 4\n1\n3 1 3 4\n1\n3 2 3 4\n1\n3 5 6 7\n1\n2 5 8\n0\n";
const std::string kSegments = "4 2\n1 0 0\n2 1 0\n3 2 0\n4 4 0\n2 0\n1 1 2\n2 3 4\n0\n";

const std::vector<std::string> kExtensions = {".ele", ".mesh", ".json"};

void build_and_check(const std::string& what, const std::string& domain, const std::string& out) {
  CAPTURE(out);
  const Run built = run({"build", what, domain, "-o", out});
  CHECK_MESSAGE(built.exit_code == 0, built.err);
  for (const std::string by : {"lemma", "definition"}) {
    const Run checked = run({"check", out, "--domain", domain, "--claim", "cdt", "--by", by});
    CHECK_MESSAGE(checked.exit_code == 0, (checked.out + checked.err));
  }
}

}  // namespace

TEST_CASE("build and check: domains of the plane and flat ones, as .ele, .mesh and .json") {
  const ScratchFolder folder;
  for (const std::string& text : {kPlane, kFlat, kSegments}) {
    const std::string domain = folder.write("d.poly", text);
    for (const std::string& extension : kExtensions) {
      build_and_check("cdt", domain, folder.path("d.1" + extension));
      build_and_check("planar-cdt", domain, folder.path("d.2" + extension));
    }
  }
}

TEST_CASE("build planar-cdt --help: its example, for a domain in a plane of space") {
  const std::string help = run({"build", "planar-cdt", "--help"}).out;
  CHECK(has(help,
            "  circumspect build planar-cdt plan.poly -o plan.1.ele\n"
            "  circumspect check plan.1.ele --domain plan.poly --claim cdt\n"));
  CHECK(has(unbroken(help), "all of the domain lies in one plane"));
  const ScratchFolder folder;
  build_and_check("planar-cdt", folder.write("plan.poly", kFlat), folder.path("plan.1.ele"));
}

TEST_CASE("check: a .mesh of dangling triangles that are not Delaunay fails") {
  const ScratchFolder folder;
  const std::string domain = folder.write("d.poly", kFlat);
  const std::string mesh =
      folder.write("d.mesh",
                   "MeshVersionFormatted 2 Dimension 3 Vertices 4 0 0 5 0 3 0 8 0 3 1 8 0 0 2 5 0 "
                   "Triangles 2 1 2 4 0 2 3 4 0 End");
  const Run checked = run({"check", mesh, "--domain", domain});
  CHECK(checked.exit_code == 1);
  CHECK(has(checked.out, "cdt.dangling-not-delaunay"));
}

TEST_CASE("check: a .mesh of the plane with z = 0 everywhere, which is noted") {
  const ScratchFolder folder;
  const std::string domain = folder.write("d.poly", kPlane);
  const std::string vertices = "MeshVersionFormatted 2 Dimension 3 Vertices 4 0 0 0 0 3 0 0 0 3 1 ";
  const std::string triangles = " 0 0 2 0 0 Triangles 2 1 2 3 0 1 3 4 0 End";
  const std::string mesh = folder.write("d.mesh", vertices + "0" + triangles);
  const Run checked = run({"check", mesh, "--domain", domain});
  CHECK_MESSAGE(checked.exit_code == 0, (checked.out + checked.err));
  const std::string note = mesh + ": the third coordinate, 0 for all points, was left out";
  CHECK(has(checked.out, "note: " + note + "\n"));
  const auto json = document(run({"check", mesh, "--domain", domain, "--format", "json"}));
  CHECK(json["results"][0]["notes"].back() == note);
  const Run lifted =
      run({"check", folder.write("l.mesh", vertices + "1e-300" + triangles), "--domain", domain});
  CHECK(lifted.exit_code == 3);
  CHECK(has(lifted.err, "expected points of dimension 2"));
}

TEST_CASE("build: JSON carries what dangles, on stdout and in a file") {
  const ScratchFolder folder;
  const std::string domain = folder.write("d.poly", kDangling);
  const std::string file = folder.path("d.1.json");
  const Run json = run({"build", "cdt", domain, "--domain-kind", "enclosed", "--format", "json"});
  CHECK(json.exit_code == 0);
  nlohmann::json mesh = document(json);
  CHECK(mesh["simplices"].size() == 1);
  CHECK(mesh["faces"].dump() == "[[5,6,7],[5,8]]");
  CHECK(run({"build", "cdt", domain, "--domain-kind", "enclosed", "-o", file}).exit_code == 0);
  CHECK(contents(file) == json.out);
  const Run checked =
      run({"check", "-", "--domain", domain, "--domain-kind", "enclosed"}, json.out);
  CHECK_MESSAGE(checked.exit_code == 0, checked.out);
  mesh.erase("faces");
  CHECK(
      run({"check", "-", "--domain", domain, "--domain-kind", "enclosed"}, mesh.dump()).exit_code ==
      1);
}

TEST_CASE("build: -o - is refused where an .ele alone would lose something") {
  const ScratchFolder folder;
  const std::string flat = folder.write("f.poly", kFlat);
  const Run dangling = run({"build", "cdt", flat, "-o", "-"});
  CHECK(dangling.exit_code == 2);
  CHECK(dangling.out.empty());
  // Before it stands a note: the domain fills nothing.
  CHECK(is_error_line(dangling.err.substr(dangling.err.find("circumspect: "))));
  CHECK(has(dangling.err, "found -o -, which would lose 2 dangling triangles and edges\n"));
  const std::string schonhardt =
      folder.write("s.off",
                   "OFF\n6 8 0\n8 0 0\n-4 7 0\n-4 -7 0\n7 4 9\n-7 4 9\n0 -8 9\n3 0 1 2\n3 3 4 5\n"
                   "3 0 1 4\n3 1 2 5\n3 2 0 3\n3 0 4 3\n3 1 5 4\n3 2 3 5\n");
  const Run steiner = run({"build", "steiner-cdt", schonhardt, "-o", "-"});
  CHECK(steiner.exit_code == 2);
  CHECK(steiner.out.empty());
  CHECK(has(steiner.err, " Steiner points\n"));
  const Run whole = run({"build", "cdt", folder.write("p.poly", kPlane), "-o", "-"});
  CHECK(whole.exit_code == 0);
  CHECK(whole.out == "2 3 0\n1 1 2 3\n2 1 3 4\n");
}

TEST_CASE("build: names of files that are not written") {
  const ScratchFolder folder;
  const std::string domain = folder.write("p.poly", kPlane);
  const std::string points = folder.write("p.node", kPlane.substr(0, kPlane.find("\n4 0\n") + 1));
  for (const std::string name : {"x.off", "x.vtk", "x", "x.node"}) {
    const std::string out = folder.path(name);
    const Run of_domain = run({"build", "cdt", domain, "-o", out});
    CHECK(of_domain.exit_code == 2);
    CHECK(of_domain.err ==
          "circumspect: expected -o OUT.ele, OUT.mesh, OUT.msh, OUT.vtu, OUT.obj, OUT.ply, "
          "OUT.json, or - for standard output, found " +
              out + "\n");
    const Run of_points = run({"build", "delaunay", points, "-o", out});
    CHECK(of_points.exit_code == 2);
    CHECK(of_points.err ==
          "circumspect: expected -o OUT.ele, OUT.json, or - for standard output, "
          "found " +
              out + "\n");
    CHECK(!std::filesystem::exists(out));
  }
  CHECK(run({"build", "delaunay", points, "-o", folder.path("x.mesh")}).exit_code == 2);
}

}  // namespace circumspect::cli
