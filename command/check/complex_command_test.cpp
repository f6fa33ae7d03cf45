// check --claim complex: its options, what is refused, and the notes about it beside other claims.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {
namespace {

struct SmallMeshes {
  ScratchFolder folder;
  std::string ring =
      write("ring", "8 2 0 0\n0 1 1\n1 -1 1\n2 -1 -1\n3 1 -1\n4 3 3\n5 -3 3\n6 -3 -3\n7 3 -3\n",
            "8 3 0\n0 0 4 5\n1 0 5 1\n2 1 5 6\n3 1 6 2\n4 2 6 7\n5 2 7 3\n6 3 7 4\n"
            "7 3 4 0\n");
  std::string hanging = write("hanging", "5 2 0 0\n0 0 0\n1 4 0\n2 0 4\n3 4 4\n4 2 2\n",
                              "3 3 0\n0 0 1 4\n1 0 4 2\n2 1 3 2\n");
  std::string surface = write("surface", "4 3 0 0\n0 0 0 0\n1 4 0 0\n2 0 4 0\n3 0 0 4\n",
                              "3 3 0\n0 0 2 1\n1 0 1 3\n2 0 3 2\n");

  std::string write(const std::string& name, const std::string& points,
                    const std::string& simplices) {
    folder.write(name + ".node", points);
    return folder.write(name + ".ele", simplices);
  }
};

Run judged(const std::string& mesh, std::vector<std::string> more = {}) {
  more.insert(more.begin(), {"check", mesh, "--claim", "complex"});
  return run(more);
}

}  // namespace

TEST_CASE("check --claim complex: a mesh that need not be convex, in words and in JSON") {
  SmallMeshes meshes;
  const Run held = judged(meshes.ring, {"--manifold", "--connected", "--oriented=positive"});
  CHECK(held.exit_code == 0);
  CHECK(has(held.out, "8 points 8 triangles 1 part 8 boundary-facets positive\n"));
  CHECK(judged(meshes.ring, {"--oriented=negative"}).exit_code == 1);
  CHECK(judged(meshes.ring, {"--by", "definition"}).out == judged(meshes.ring).out);
  const Run json = judged(meshes.ring, {"--format", "json"});
  CHECK(has(json.out, "\"boundary_facets\": 8"));
  CHECK(has(json.out, "\"others_form_a_complex\": true"));
}

TEST_CASE("check --claim complex: hanging vertices fail, unless they are allowed") {
  SmallMeshes meshes;
  const Run failed = judged(meshes.hanging);
  CHECK(failed.exit_code == 1);
  CHECK(has(failed.out, "complex.hanging-vertex 1 face 1 2 vertex 4"));
  const Run allowed = judged(meshes.hanging, {"--allow", "hanging-vertex"});
  CHECK(allowed.exit_code == 0);
  CHECK(has(allowed.out, " 1 hanging-vertex\n"));
}

TEST_CASE("check --claim complex: a surface that is open, and equal points that are merged") {
  SmallMeshes meshes;
  CHECK(judged(meshes.surface, {"--oriented", "--manifold"}).exit_code == 0);
  const Run open = judged(meshes.surface, {"--closed"});
  CHECK(open.exit_code == 1);
  CHECK(has(open.out, "complex.not-closed 3"));
  const std::string crack = meshes.write(
      "crack", "6 2 0 0\n0 0 0\n1 4 0\n2 0 4\n3 4 0\n4 0 4\n5 4 4\n", "2 3 0\n0 0 1 2\n1 3 5 4\n");
  const Run equal = judged(crack);
  CHECK(equal.exit_code == 1);
  CHECK(has(equal.out, "complex.points-equal 2 vertex 1 3"));
  const Run merged = judged(crack, {"--duplicates", "merge"});
  CHECK(merged.exit_code == 0);
  CHECK(has(merged.out, " 1 part 4 boundary-facets positive\n"));
}

TEST_CASE("check: an STL surface is judged by itself, and refused where a mesh has to fill") {
  const ScratchFolder folder;
  const auto facet = [](const char* a, const char* b, const char* c) {
    return fmt::format(
        "facet normal 0 0 0\nouter loop\nvertex {}\nvertex {}\nvertex {}\nendloop\n"
        "endfacet\n",
        a, b, c);
  };
  const std::string half = "solid\n" + facet("0 0 0", "0 1 0", "1 0 0") +
                           facet("0 0 0", "1 0 0", "0 0 1") + facet("0 0 0", "0 0 1", "0 1 0");
  const std::string whole =
      folder.write("whole.stl", half + facet("1 0 0", "0 1 0", "0 0 1") + "endsolid\n");
  const Run held = judged(whole, {"--closed", "--manifold", "--oriented"});
  CHECK(held.exit_code == 0);
  CHECK(has(held.out, " 4 points 4 triangles 1 part 0 boundary-facets"));
  CHECK(run({"check", whole, "--claim", "surface-delaunay"}).exit_code == 0);
  CHECK(run({"check", whole, "--claim", "convex-hull"}).exit_code == 0);
  for (const std::vector<std::string>& command : {std::vector<std::string>{"check", whole},
                                                  {"check", whole, "--claim", "triangulation"},
                                                  {"certify", whole, "-o", folder.path("c")}}) {
    const Run refused = run(command);
    CHECK(refused.exit_code == 3);
    CHECK(has(refused.err, "found a surface (check --claim complex " + whole));
  }
  const std::string cracked =
      folder.write("cracked.stl", half + facet("1 0 0", "0 1 0", "0 0 1.0000000000000002") +
                                      facet("0 0 1", "0 0 1", "1 0 0") + "endsolid\n");
  const Run failed = judged(cracked, {"--closed"});
  CHECK(failed.exit_code == 1);
  CHECK(has(failed.out, "simplex.repeated-vertex"));
  CHECK(has(failed.out, "5 points"));
  // In one plane it is a mesh as any other.
  CHECK(run({"check",
             folder.write("flat.stl", "solid\n" + facet("0 0 5", "1 0 5", "0 1 5") + "endsolid\n")})
            .exit_code == 0);
}

TEST_CASE("check --claim complex: what contradicts itself is refused, and what makes no sense") {
  SmallMeshes meshes;
  CHECK(run({"check", meshes.ring, "--manifold"}).exit_code == 2);
  CHECK(run({"check", meshes.ring, "--oriented=positive"}).exit_code == 2);
  CHECK(judged(meshes.surface, {"--closed", "--allow", "hanging-vertex"}).exit_code == 2);
  CHECK(judged(meshes.ring, {"--allow", "overlap"}).exit_code == 2);
  CHECK(judged(meshes.ring, {"--oriented=up"}).exit_code == 2);
  for (const char* demand : {"--manifold", "--connected", "--oriented=positive"}) {
    const Run unproved = judged(meshes.ring, {demand, "--certificate", "c"});
    CHECK(unproved.exit_code == 2);
    CHECK(has(unproved.err, demand + std::string(" beside --certificate, found it: nothing")));
  }
  CHECK(judged(meshes.ring, {"--memory", "1G"}).exit_code == 2);
  CHECK(judged(meshes.ring, {"--domain", "d.poly"}).exit_code == 2);
  const Run sign = judged(meshes.surface, {"--oriented=positive"});
  CHECK(sign.exit_code == 3);
  CHECK(has(sign.err, "--oriented=same"));
  const std::string none = meshes.write("none", "1 2 0 0\n0 0 0\n", "0 3 0\n");
  const Run empty = judged(none);
  CHECK(empty.exit_code == 3);
  CHECK(has(empty.err, "expected simplices, found none"));
  const Run certified = run({"certify", none, "--claim", "complex", "-o", "-"});
  CHECK(certified.exit_code == 3);
  CHECK(has(certified.err, "expected simplices, found none"));
}

TEST_CASE("check: beside a hull that is not filled, a note says whether the mesh is a complex") {
  SmallMeshes meshes;
  CHECK(has(run({"check", meshes.ring}).out, "with --claim complex it holds"));
  CHECK(has(run({"check", meshes.hanging, "--claim", "triangulation"}).out,
            "with --claim complex it fails, too: complex.hanging-vertex 1"));
}

}  // namespace circumspect::cli
