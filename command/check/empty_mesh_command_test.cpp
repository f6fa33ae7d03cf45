// A file without points and without simplices: in CI it means that a program wrote nothing.
#include <doctest/doctest.h>

#include "command/run_command.hpp"
#include "oracle/formats/reading_test.hpp"

namespace circumspect::cli {
namespace {

constexpr const char* kEmptyJson =
    R"({"circumspect": 1, "dimension": 2, "points": [], "simplices": []})";
constexpr const char* kTriangle =
    R"({"circumspect": 1, "dimension": 2, "points": [[0,0],[1,0],[0,1]], "simplices": [[0,1,2]]})";

// Meshes of nothing in every format that can say so.
std::vector<std::string> empty_meshes(const ScratchFolder& folder) {
  folder.write("e.node", "0 3 0 0\n");
  folder.write("e.qhull", "3\n0\n");
  return {folder.write("e.off", "OFF\n0 0 0\n"),
          folder.write("e.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices 0\nEnd\n"),
          folder.write("e.ele", "0 4 0\n"), folder.write("e.qhull-i", "0\n"),
          folder.write("e.json", kEmptyJson)};
}

TEST_CASE("a mesh of nothing is the input's fault, in every format, under every claim") {
  const ScratchFolder folder;
  for (const std::string& mesh : empty_meshes(folder)) {
    CAPTURE(mesh);
    for (const std::string claim : {"triangulation", "delaunay", "weighted-delaunay"}) {
      const Run result = run({"check", "--claim", claim, mesh});
      CHECK(result.exit_code == 3);
      CHECK(result.out.empty());
      CHECK(is_error_line(result.err));
      CHECK(has(result.err, mesh + ": expected a mesh, found neither points nor simplices"));
      const Run allowed = run({"check", "--allow-empty", "--claim", claim, mesh});
      CHECK(allowed.exit_code == 0);
      CHECK(begins_with(allowed.out, "holds: " + claim + " " + mesh + " 0 points 0 simplices"));
    }
    CHECK(run({"check", "--by", "definition", mesh}).exit_code == 3);
  }
  CHECK(run({"check", "-"}, kEmptyJson).exit_code == 3);
  CHECK(run({"check", "-", "--allow-empty"}, kEmptyJson).exit_code == 0);
  const Run json = run({"check", "--format", "json", folder.path("e.off")});
  CHECK(has(document(json)["results"][0]["error"], "neither points nor simplices"));
  // What is worse than another answer stays so.
  CHECK(run({"check", folder.path("e.off"), folder.write("t.json", kTriangle)}).exit_code == 3);
}

TEST_CASE("arrays without rows are a mesh of nothing too") {
  const ScratchFolder folder;
  const std::string points = folder.write("p.npy", formats::npy<double>("<f8", "(0, 3)", {}));
  const std::string simplices =
      folder.write("s.npy", formats::npy<std::int64_t>("<i8", "(0, 4)", {}));
  CHECK(run({"check", simplices, "--points", points}).exit_code == 3);
  CHECK(run({"check", simplices, "--points", points, "--allow-empty"}).exit_code == 0);
}

TEST_CASE("points without simplices, and simplices without points, do not hold") {
  const ScratchFolder folder;
  folder.write("p.node", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n");
  const std::string points = folder.write("p.ele", "0 3 0\n");
  folder.write("s.node", "0 2 0 0\n");
  const std::string simplices = folder.write("s.ele", "1 3 0\n1 1 2 3\n");
  for (const std::string option : {"--quiet", "--allow-empty"}) {
    CAPTURE(option);
    CHECK(run({"check", option, points}).exit_code == 1);
    CHECK(run({"check", option, simplices}).exit_code == 1);
  }
  CHECK(has(run({"check", points}).out, " triangulation.unused-point 3 "));
  CHECK(has(run({"check", simplices}).out, " triangulation.unknown-vertex 1 "));
}

TEST_CASE("a mesh of nothing does not fill a domain, and nobody asks whether it does") {
  const ScratchFolder folder;
  const std::string domain =
      folder.write("d.poly", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n");
  const std::string mesh = folder.write("e.off", "nOFF\n2\n0 0 0\n");
  CHECK(run({"check", mesh, "--domain", domain}).exit_code == 3);
  CHECK(run({"check", mesh, "--domain", domain, "--allow-empty"}).exit_code == 1);
  // An edge that names no point is something.
  const std::string edge = folder.write(
      "f.json",
      R"({"circumspect": 1, "dimension": 2, "points": [], "simplices": [], "faces": [[0, 1]]})");
  CHECK(run({"check", edge, "--domain", domain}).exit_code == 1);
}

TEST_CASE("compare and certify take no mesh of nothing for one either") {
  const ScratchFolder folder;
  const std::string empty = folder.write("e.json", kEmptyJson);
  const std::string other = folder.write("f.off", "nOFF\n2\n0 0 0\n");
  const std::string triangle = folder.write("t.json", kTriangle);
  CHECK(run({"compare", empty, other}).exit_code == 3);
  CHECK(run({"compare", empty, triangle}).exit_code == 3);
  CHECK(run({"compare", "--allow-empty", empty, other}).exit_code == 0);
  CHECK(run({"compare", "--allow-empty", triangle, empty}).exit_code == 1);
  // Nor files of the plain form, which have a reader of their own.
  folder.write("n.node", "0 2\n");
  const std::string plain = folder.write("n.ele", "0 3\n");
  CHECK(run({"compare", plain, plain}).exit_code == 3);
  CHECK(run({"compare", plain, triangle}).exit_code == 3);
  CHECK(run({"compare", "--allow-empty", plain, empty}).exit_code == 0);
  const Run certificate = run({"certify", empty, "-o", folder.path("c")});
  CHECK(certificate.exit_code == 3);
  CHECK(is_error_line(certificate.err));
  CHECK(!std::filesystem::exists(folder.path("c")));
}

}  // namespace
}  // namespace circumspect::cli
