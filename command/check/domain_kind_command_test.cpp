// --domain-kind, and what is answered where nobody says it: which part of space a domain fills is
// never guessed in silence.
#include <doctest/doctest.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {
namespace {

// A tetrahedron with a bounding triangle left out, or all of them, on the points 1 to 4, and an
// apex above the open side: the hull is more than the tetrahedron.
const std::string kPointsOfPrism = "1 0 0 0\n2 4 0 0\n3 0 4 0\n4 0 0 4\n5 5 5 5\n";
const std::string kClosed =
    "5 3\n" + kPointsOfPrism + "4 0\n3 1 2 3\n3 1 2 4\n3 1 3 4\n3 2 3 4\n0\n";
const std::string kLeaky = "5 3\n" + kPointsOfPrism + "3 0\n3 1 2 3\n3 1 2 4\n3 1 3 4\n0\n";

// The hull of the five points, and the tetrahedron alone.
struct MeshesOfPrism {
  ScratchFolder folder;
  std::string hull, inner, triangles;
  MeshesOfPrism() {
    for (const char* name : {"h.node", "i.node", "t.node"})
      folder.write(name, "5 3\n" + kPointsOfPrism);
    hull = folder.write("h.ele", "2 4\n1 1 2 3 4\n2 2 3 4 5\n");
    inner = folder.write("i.ele", "1 4\n1 1 2 3 4\n");
    triangles = folder.write("t.ele", "0 4\n");
    folder.write("t.face", "3 0\n1 1 2 3\n2 1 2 4\n3 1 3 4\n");
  }
};

std::string domain_kind_of(const Run& json) {
  return document(json)["results"][0]["domain_kind"].get<std::string>();
}

}  // namespace

TEST_CASE("a surface with a leak is refused, with an open edge, until its kind is said") {
  const MeshesOfPrism meshes;
  const std::string leaky = meshes.folder.write("leaky.smesh", kLeaky);
  for (const std::string& mesh : {meshes.hull, meshes.inner, meshes.triangles}) {
    const Run refused = run({"check", mesh, "--domain", leaky});
    CHECK(refused.exit_code == 3);
    CHECK(refused.out.empty());
    CHECK(is_error_line(refused.err));
    CHECK(begins_with(refused.err, "circumspect: " + leaky +
                                       ": expected polygons that enclose something, found 3 that "
                                       "enclose nothing: edge 2 3, from (4, 0, 0) to (0, 4, 0), "
                                       "belongs to one polygon alone, polygon 1 (line 8), and so "
                                       "do 2 more; "));
    CHECK(has(refused.err, "--fill enclosed if "));
    CHECK(has(refused.err, "--fill hull if "));
  }
  for (const char* what : {"cdt", "steiner-cdt", "conforming-delaunay"}) {
    const Run refused = run({"build", what, leaky, "-o", meshes.folder.path("leaky.1.ele")});
    CHECK(refused.exit_code == 3);
    CHECK(has(refused.err, "edge 2 3, from (4, 0, 0) to (0, 4, 0), belongs to one polygon alone"));
  }
  const Run inspected = run({"inspect", leaky});
  CHECK(inspected.exit_code == 0);
  CHECK(has(inspected.out, "note: " + leaky + ": expected polygons that enclose something"));
  CHECK(has(inspected.out, "; taken as hull\n"));
  CHECK(has(inspected.out, " 0 polyhedra hull "));
  const std::string closed = meshes.folder.write("closed.smesh", kClosed);
  CHECK(run({"check", meshes.inner, "--domain", closed}).exit_code == 0);
}

TEST_CASE("the kind that is said decides, and is shown in text and JSON") {
  const MeshesOfPrism meshes;
  const std::string leaky = meshes.folder.write("leaky.smesh", kLeaky);
  const auto check = [&](const std::string& mesh, const std::string& kind,
                         const std::string& format = "text") {
    return run({"check", mesh, "--domain", leaky, "--domain-kind", kind, "--claim", "cdt",
                "--format", format});
  };
  const Run hull = check(meshes.hull, "hull");
  CHECK_MESSAGE(hull.exit_code == 0, (hull.out + hull.err));
  CHECK(begins_with(hull.out, "domain: " + leaky + " hull, the convex hull\nholds: "));
  CHECK(domain_kind_of(check(meshes.hull, "hull", "json")) == "hull");
  const Run enclosed = check(meshes.triangles, "enclosed");
  CHECK_MESSAGE(enclosed.exit_code == 0, (enclosed.out + enclosed.err));
  CHECK(has(enclosed.out, "domain: " + leaky + " enclosed, what its polygons enclose\n"));
  CHECK(has(enclosed.out, "note: " + leaky + ": nothing is enclosed: there is nothing to fill\n"));
  CHECK(domain_kind_of(check(meshes.triangles, "enclosed", "json")) == "enclosed");
  CHECK(check(meshes.hull, "enclosed").exit_code == 1);
  CHECK(check(meshes.triangles, "hull").exit_code == 1);
  CHECK(check(meshes.inner, "hull").exit_code == 1);
}

TEST_CASE("build of what encloses nothing and is said to be enclosed: triangles and edges alone") {
  const ScratchFolder folder;
  const std::string leaky = folder.write("leaky.smesh", kLeaky);
  for (const std::string what : {"cdt", "steiner-cdt", "conforming-delaunay"}) {
    const std::string mesh = folder.path(what + ".ele");
    const Run built = run({"build", what, leaky, "--domain-kind", "enclosed", "-o", mesh});
    CHECK_MESSAGE(built.exit_code == 0, (built.out + built.err));
    for (const std::string by : {"lemma", "definition"}) {
      const Run checked = run({"check", mesh, "--domain", leaky, "--domain-kind", "enclosed",
                               "--claim", what, "--by", by});
      CHECK_MESSAGE(checked.exit_code == 0, (checked.out + checked.err));
    }
  }
  CHECK(has(run({"inspect", leaky, "--domain-kind", "enclosed"}).out, " 0 polyhedra enclosed "));
}

TEST_CASE("segments of the plane that enclose nothing: an end of one alone is named") {
  const ScratchFolder folder;
  folder.write("t.node", "3 2\n1 0 0\n2 4 0\n3 0 4\n");
  const std::string mesh = folder.write("t.ele", "1 3\n1 1 2 3\n");
  const std::string open =
      folder.write("o.poly", "3 2\n1 0 0\n2 4 0\n3 0 4\n2 0\n1 1 2\n2 2 3\n0\n");
  const Run refused = run({"check", mesh, "--domain", open});
  CHECK(refused.exit_code == 3);
  CHECK(has(refused.err,
            ": expected segments that enclose something, found 2 that enclose nothing: vertex 1 at "
            "(0, 0) belongs to one segment alone, segment 1 2, and so does 1 more; "));
  CHECK(run({"check", mesh, "--domain", open, "--domain-kind", "hull"}).exit_code == 0);
  CHECK(run({"check", mesh, "--domain", open, "--domain-kind", "enclosed"}).exit_code == 1);
  // Points alone have a hull, and nothing else: that is told.
  const std::string points = folder.write("p.poly", "3 2\n1 0 0\n2 4 0\n3 0 4\n0 0\n0\n");
  const Run hull = run({"check", mesh, "--domain", points});
  CHECK_MESSAGE(hull.exit_code == 0, (hull.out + hull.err));
  CHECK(has(hull.out, "note: " + points + ": no segments to enclose anything: the domain is the "));
  CHECK(has(hull.out, "domain: " + points + " hull, the convex hull\n"));
}

TEST_CASE("a leak beside something enclosed is noted, unless the kind is said") {
  const MeshesOfPrism meshes;
  const std::string domain = meshes.folder.write(
      "beside.smesh",
      "5 3\n" + kPointsOfPrism + "5 0\n3 1 2 3\n3 1 2 4\n3 1 3 4\n3 2 3 4\n3 2 3 5\n0\n");
  meshes.folder.write("i.face", "1 0\n1 2 3 5\n");
  const Run noted = run({"check", meshes.inner, "--domain", domain});
  CHECK_MESSAGE(noted.exit_code == 0, (noted.out + noted.err));
  const std::string note = domain +
                           ": 1 polygon with the outside on both sides bounds nothing: edge 2 5, "
                           "from (4, 0, 0) to (5, 5, 5), belongs to one polygon alone, polygon 5 "
                           "(line 12), and so does 1 more; ";
  CHECK(has(noted.out, "note: " + note));
  const auto json =
      document(run({"check", meshes.inner, "--domain", domain, "--format", "json"}))["results"][0];
  CHECK(has(json["notes"].dump(), note));
  const Run said = run({"check", meshes.inner, "--domain", domain, "--domain-kind", "enclosed"});
  CHECK(said.exit_code == 0);
  CHECK(!has(said.out, "note: "));
}

TEST_CASE("the hull of points in one plane of space is not a domain to fill") {
  const ScratchFolder folder;
  const std::string points = "4 3\n1 0 0 5\n2 3 0 5\n3 3 1 5\n4 0 2 5\n";
  folder.write("e.node", points);
  const std::string empty = folder.write("e.ele", "0 4\n");
  folder.write("f.node", points);
  const std::string full = folder.write("f.ele", "0 4\n");
  folder.write("f.face", "2 0\n1 1 2 3\n2 1 3 4\n");
  const std::string square = folder.write("s.poly", points + "1 0\n1\n4 1 2 3 4\n0\n");
  const std::string lone = folder.write("l.poly", points + "0 0\n0\n");
  for (const std::string& mesh : {empty, full}) {
    const Run hull = run({"check", mesh, "--domain", square, "--domain-kind", "hull"});
    CHECK(hull.exit_code == 3);
    CHECK(is_error_line(hull.err));
    CHECK(has(hull.err,
              ": expected points that span space, so that their convex hull has something "
              "to fill, found all in one plane; --fill enclosed "));
    CHECK(run({"check", mesh, "--domain", lone}).exit_code == 3);
  }
  CHECK(run({"check", full, "--domain", square, "--domain-kind", "enclosed"}).exit_code == 0);
  CHECK(run({"check", empty, "--domain", square, "--domain-kind", "enclosed"}).exit_code == 1);
  // Neither kind fills anything, so nothing has to be said.
  const Run unsaid = run({"check", full, "--domain", square});
  CHECK(unsaid.exit_code == 0);
  CHECK(
      has(unsaid.out, "note: " + square + ": points all in one plane: there is nothing to fill\n"));
  CHECK(run({"check", empty, "--domain", square}).exit_code == 1);
  CHECK(run({"inspect", lone}).exit_code == 0);
  CHECK(has(unbroken(run({"check", "--help"}).out), "must not all lie in one plane"));
}

TEST_CASE(
    "a hull in the plane loses what segments enclose around hole seeds, as triangle -pc does") {
  const ScratchFolder folder;
  // A rectangle given by its corners and a point on its side, a square of segments in it.
  const std::string points = "9 2\n1 0 0\n2 6 0\n3 6 6\n4 0 6\n5 2 2\n6 4 2\n7 4 4\n8 2 4\n9 3 0\n";
  const std::string square = "4 0\n1 5 6\n2 6 7\n3 7 8\n4 8 5\n";
  folder.write("h.node", points);
  const std::string ring =
      "1 1 9 5\n2 9 6 5\n3 9 2 6\n4 2 3 6\n5 3 7 6\n6 3 4 7\n7 4 8 7\n8 4 1 8\n9 1 5 8\n";
  const std::string mesh = folder.write("h.ele", "9 3\n" + ring);
  const std::string whole = folder.write("w.ele", "11 3\n" + ring + "10 5 6 7\n11 5 7 8\n");
  folder.write("w.node", points);
  const std::string with_hole = folder.write("h.poly", points + square + "1\n1 3 3\n");
  const Run holds = run({"check", mesh, "--domain", with_hole, "--fill", "hull"});
  CHECK_MESSAGE(holds.exit_code == 0, holds.out);
  CHECK(has(holds.out,
            "h.poly hull, the convex hull without what its segments enclose around "
            "hole seeds\n"));
  const std::string claim = "steiner-triangulation";
  CHECK(has(run({"check", whole, "--domain", with_hole, "--fill", "hull", "--claim", claim}).out,
            "domain.outside 2"));
  // The seed may be said; without one the hull is filled.
  const std::string without = folder.write("n.poly", points + square + "0\n");
  CHECK(run({"check", mesh, "--domain", without, "--fill", "hull", "--hole", "3,3"}).exit_code ==
        0);
  CHECK(run({"check", whole, "--domain", without, "--fill", "hull", "--claim", claim}).exit_code ==
        0);
  CHECK(run({"check", mesh, "--domain", without, "--fill", "hull"}).exit_code == 1);
  // A corner of the hull that is cut off is missing, whatever the seeds say.
  const std::string cut = folder.write("c.ele", "8 3\n" + ring.substr(8));
  folder.write("c.node", points);
  CHECK(run({"check", cut, "--domain", with_hole, "--fill", "hull"}).exit_code != 0);
}

TEST_CASE("hole seeds that make no hole, or leave nothing, are noted") {
  const ScratchFolder folder;
  const std::string points = "3 2\n1 0 0\n2 4 0\n3 0 4\n";
  folder.write("t.node", points);
  const std::string mesh = folder.write("t.ele", "1 3\n1 1 2 3\n");
  const auto domain = [&](const std::string& hole) {
    return folder.write("t.poly", points + "3 0\n1 1 2\n2 2 3\n3 3 1\n1\n1 " + hole + "\n");
  };
  const std::string outside = domain("9 9");
  const std::string note = outside + ": hole seed 1 at (9, 9): ignored, it is in nothing enclosed";
  const Run ignored = run({"check", mesh, "--domain", outside});
  CHECK(ignored.exit_code == 0);
  CHECK(has(ignored.out, "note: " + note + "\n"));
  const auto json = document(run({"check", mesh, "--domain", outside, "--format", "json"}));
  CHECK(json["results"][0]["notes"] == nlohmann::json::array({note}));
  CHECK(has(run({"build", "cdt", outside, "-o", folder.path("b.ele")}).out, "note: " + note));
  CHECK(run({"build", "cdt", outside, "--format", "json"}).err == "note: " + note + "\n");
  CHECK(has(run({"inspect", outside}).out, "note: " + note));
  CHECK(has(run({"check", mesh, "--domain", outside, "--domain-kind", "hull"}).out,
            ": hole seed 1 at (9, 9): ignored, it is in nothing enclosed\n"));
  const Run emptied = run({"check", mesh, "--domain", domain("1 1")});
  CHECK(emptied.exit_code == 1);
  CHECK(has(emptied.out,
            ": hole seeds empty all that is enclosed (one region): nothing is left to "
            "fill; --fill hull fills the convex hull without them\n"));
}

}  // namespace circumspect::cli
