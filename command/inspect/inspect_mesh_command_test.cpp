// inspect of a mesh: its topology, its size, and what its simplices measure.
#include <tuple>

#include <doctest/doctest.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {
namespace {

const std::string kCorpus = CIRCUMSPECT_CORPUS_DIR;

}  // namespace

TEST_CASE("inspect of a mesh: every fact, in words and in JSON") {
  const std::string ring = kCorpus + "/accept/complex-square-ring-2d.ele";
  const Run told = run({"inspect", ring});
  CHECK(told.exit_code == 0);
  CHECK(has(told.out,
            "mesh: 8 points 8 triangles in dimension 2\n"
            "faces: 8 vertices, 16 edges, 8 triangles, euler-characteristic 0\n"
            "complex: complex manifold 1 part 8 boundary-facets in 2 parts genus 0\n"
            "orientations: 8 positive 0 negative\n"
            "area: "));
  CHECK(has(told.out, "\nleast angle: "));
  CHECK(has(told.out, "\nhistogram: min-angle\n"));
  CHECK(has(told.out, " 8 points 8 triangles complex manifold 1 part\n"));
  const auto known = document(run({"inspect", ring, "--format", "json"}))["results"][0];
  CHECK(known["genus"] == 0);
  CHECK(known["boundary_parts"] == 2);
  CHECK(known["extremes"].size() == 10);
  CHECK(known["histograms"][0]["measure"] == "min-angle");
  const Run some = run({"inspect", ring, "--only", "quality"});
  CHECK(!has(some.out, "euler"));
  CHECK(has(some.out, "least angle"));
}

TEST_CASE("inspect of a mesh: what is not a complex, and what is set apart") {
  const Run flat =
      run({"inspect", kCorpus + "/reject/simplex.degenerate--others-form-a-complex.ele"});
  CHECK(flat.exit_code == 0);
  CHECK(has(flat.out, "not-complex"));
  CHECK(has(flat.out, "measured: 1 tetrahedron set apart"));
  const Run branched = run({"inspect", kCorpus + "/reject/complex.not-manifold.ele"});
  CHECK(has(branched.out, "complex: complex not-manifold"));
  CHECK(!has(branched.out, "genus"));
}

TEST_CASE("inspect of a mesh: surfaces that cross have no genus, and equal points join parts") {
  const ScratchFolder folder;
  const auto surfaces = [&](const std::string& name, int away) {
    std::string points, faces;
    for (const int by : {0, away}) {
      for (const auto& [x, y, z] : {std::tuple{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}) {
        points += std::to_string(x + by) + " " + std::to_string(y + by) + " " +
                  std::to_string(z + by) + "\n";
      }
      const int first = by == 0 ? 0 : 4;
      for (const auto& [a, b, c] : {std::tuple{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}) {
        faces += "3 " + std::to_string(a + first) + " " + std::to_string(b + first) + " " +
                 std::to_string(c + first) + "\n";
      }
    }
    return run({"inspect", "--mesh", folder.write(name, "OFF\n8 8 0\n" + points + faces)}).out;
  };
  CHECK(has(surfaces("apart.off", 9),
            "complex: complex manifold 2 parts 0 boundary-facets in 0 parts genus 0\n"));
  const std::string crossing = surfaces("crossing.off", 1);
  CHECK(has(crossing, "complex: not-complex 2 parts"));
  CHECK(!has(crossing, "genus"));
  const std::string torn = folder.write(
      "torn.off", "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 3 4 5\n");
  CHECK(has(run({"inspect", "--mesh", torn, "--duplicates", "merge"}).out,
            "complex manifold 1 part "));
}

TEST_CASE("inspect of a mesh: --mesh, and what is refused") {
  const ScratchFolder folder;
  const std::string mesh =
      folder.write("square.mesh",
                   "MeshVersionFormatted 2\nDimension 2\nVertices 3\n0 0 0\n1 0 0\n0 1 0\n"
                   "Triangles 1\n1 2 3 0\nEnd\n");
  CHECK(has(run({"inspect", "--mesh", mesh}).out, "area: 1/2 ~ 0.5\n"));
  CHECK(!has(run({"inspect", mesh}).out, "area:"));
  const Run unknown = run({"inspect", kCorpus + "/accept/grid-3x3x3.ele", "--only", "cdt"});
  CHECK(unknown.exit_code == 2);
  CHECK(has(unknown.err, "topology|size|quality for a mesh"));
  const std::string page = folder.path("page.html");
  CHECK(run({"inspect", kCorpus + "/accept/grid-3x3x3.ele", "--html", page}).exit_code == 0);
  CHECK(shown(page)["cards"].size() == 12);
  CHECK(shown(page)["histograms"].size() == 4);
}

}  // namespace circumspect::cli
