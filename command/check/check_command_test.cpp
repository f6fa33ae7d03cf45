// circumspect check, as its users run it.
#include <doctest/doctest.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {
namespace {

constexpr const char* kSquare = "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n";
constexpr const char* kKite = "4 2 0 0\n0 -2 0\n1 2 0\n2 0 1\n3 0 -0.5\n";

// A folder with a mesh that holds, one that fails, and one that is malformed.
struct Meshes {
  ScratchFolder folder;
  std::string good;
  std::string bad;
  std::string malformed;
  Meshes() {
    folder.write("good.node", kSquare);
    good = folder.write("good.ele", "2 3 0\n1 1 2 3\n2 1 3 4\n");
    folder.write("bad.node", kKite);
    bad = folder.write("bad.ele", "2 3 0\n0 0 1 2\n1 0 1 3\n");
    folder.write("malformed.node", kKite);
    malformed = folder.write("malformed.ele", "2 3 0\n0 0 1 x\n1 0 1 3\n");
  }
};

TEST_CASE("check: exit code 0, and the verdict on the last line") {
  const Meshes meshes;
  const Run result = run({"check", meshes.good});
  CHECK(result.exit_code == 0);
  CHECK(result.out ==
        "holds: delaunay " + meshes.good + " 4 points 2 triangles not-unique canonical\n");
  CHECK(result.err.empty());
}

TEST_CASE("check: exit code 1, the witness, and the verdict on the last line") {
  const Meshes meshes;
  const Run result = run({"check", meshes.bad});
  CHECK(result.exit_code == 1);
  CHECK(begins_with(result.out, "delaunay.facet-not-local: "));
  const std::string last = result.out.substr(result.out.rfind('\n', result.out.size() - 2) + 1);
  CHECK(last ==
        "fails: delaunay " + meshes.bad + " delaunay.facet-not-local 1 face 0 1 vertex 3\n");
  CHECK(result.err.empty());
  CHECK(run({"check", meshes.bad, "--claim", "triangulation"}).exit_code == 0);
  const Run definition = run({"check", "--by", "definition", meshes.bad});
  CHECK(definition.exit_code == 1);
  CHECK(has(definition.out, " delaunay.vertex-in-ball 2 simplex 0 1 2 vertex 3\n"));
}

TEST_CASE("check: exit code 2 for what is not a command line") {
  const Meshes meshes;
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{},
                                             {"check"},
                                             {"frobnicate"},
                                             {"check", "--claim", "beautiful", meshes.good},
                                             {"check", "--by", "hope", meshes.good},
                                             {"check", "--format", "xml", meshes.good},
                                             {"check", "--coordinates", "float", meshes.good},
                                             {"check", "--duplicates", "keep", meshes.good},
                                             {"check", "--max-errors", "many", meshes.good},
                                             {"check", "--max-errors", "-1", meshes.good},
                                             {"check", "--threads", "0", meshes.good},
                                             {"check", "--threads", "many", meshes.good},
                                             {"check", "--frobnicate", meshes.good}}) {
    const Run result = run(arguments);
    CHECK(result.exit_code == 2);
    CHECK(result.out.empty());
    CHECK(!result.err.empty());
  }
}

TEST_CASE("check: what is not a word or number of an option is answered with those that are") {
  const Meshes meshes;
  const auto said = [&](const std::string& option, const std::string& value) {
    return run({"check", option, value, meshes.good}).err;
  };
  const std::string more = "\nRun with --help for more information.\n";
  CHECK(said("--by", "foo") == "--by: expected definition|lemma, found foo" + more);
  CHECK(said("--max-errors", "-1") ==
        "--max-errors: expected a whole number from 0 to 2^64 - 1, found -1" + more);
  CHECK(said("--threads", "0") ==
        "--threads: expected a whole number from 1 to 2^64 - 1, found 0" + more);
  CHECK(said("--threads", "foo") ==
        "--threads: expected a whole number from 1 to 2^64 - 1, found foo" + more);
  CHECK(said("--claim", "foo") ==
        "--claim: expected cdt|complex|conforming-delaunay|convex-hull|delaunay|periodic-delaunay|"
        "plc-triangulation|steiner-cdt|steiner-triangulation|surface-delaunay|triangulation|"
        "voronoi|weighted-delaunay, found foo" +
            more);
  CHECK(said("--domain-kind", "foo") ==
        "--fill: expected enclosed|even-odd|hull|winding, found foo" + more);
  CHECK(said("--coordinates", "x") == "--coordinates: expected decimal|double, found x" + more);
  CHECK(said("--duplicates", "x") == "--duplicates: expected merge|reject, found x" + more);
  CHECK(said("--format", "xml") == "--format: expected json|text, found xml" + more);
  CHECK(run({"check", "--by", "Definition", "--claim", "CDT", meshes.good}).exit_code == 2);
  CHECK(run({"check", "--by", "Definition", "--claim", "Delaunay", meshes.good}).exit_code == 0);
}

TEST_CASE("check: exit code 3 for a malformed file, a directory, a file that is not there") {
  const Meshes meshes;
  for (const std::string& path :
       {meshes.malformed, meshes.folder.path(""), meshes.folder.path("nowhere.ele")}) {
    const Run result = run({"check", path});
    CAPTURE(path);
    CHECK(result.exit_code == 3);
    CHECK(result.out.empty());
    CHECK(is_error_line(result.err));
  }
  CHECK(has(run({"check", meshes.malformed}).err, "malformed.ele:2: expected "));
}

TEST_CASE("check: exit code 3 for a file that may not be read") {
  const Meshes meshes;
  namespace fs = std::filesystem;
  fs::permissions(meshes.bad, fs::perms::none);
  if (std::ifstream(meshes.bad)) return;  // Who runs this may read everything.
  const Run result = run({"check", meshes.bad});
  CHECK(result.exit_code == 3);
  CHECK(is_error_line(result.err));
}

TEST_CASE("check: of several meshes, all are judged and the worst decides") {
  const Meshes meshes;
  const Run fails = run({"check", meshes.good, meshes.bad, meshes.good});
  CHECK(fails.exit_code == 1);
  CHECK(has(fails.out, "holds: delaunay " + meshes.good));
  CHECK(has(fails.out, "fails: delaunay " + meshes.bad));
  const Run fault = run({"check", meshes.malformed, meshes.good, meshes.bad});
  CHECK(fault.exit_code == 3);
  CHECK(has(fault.out, "holds: delaunay " + meshes.good));
  CHECK(has(fault.out, "fails: delaunay " + meshes.bad));
  CHECK(is_error_line(fault.err));
  CHECK(run({"check", meshes.good, meshes.good}).exit_code == 0);
}

TEST_CASE("check: --quiet prints errors and nothing else") {
  const Meshes meshes;
  const Run result = run({"check", "--quiet", meshes.good, meshes.bad});
  CHECK(result.exit_code == 1);
  CHECK(result.out.empty());
  CHECK(result.err.empty());
  const Run fault = run({"check", "--quiet", meshes.malformed});
  CHECK(fault.exit_code == 3);
  CHECK(fault.out.empty());
  CHECK(is_error_line(fault.err));
}

TEST_CASE("check: --format json is one document, whatever the answers are") {
  const Meshes meshes;
  const Run result = run({"check", "--format", "json", meshes.bad, meshes.malformed, meshes.good});
  CHECK(result.exit_code == 3);
  CHECK(is_error_line(result.err));
  const nlohmann::json all = document(result);
  CHECK(all["circumspect"] == 1);
  REQUIRE(all["results"].size() == 3);
  CHECK(all["results"][0]["verdict"] == "fails");
  CHECK(all["results"][0]["violations"][0]["coordinates"]["3"][1] == "-1/2");
  CHECK(all["results"][1]["mesh"] == meshes.malformed);
  CHECK(has(all["results"][1]["error"], "malformed.ele:2: expected "));
  CHECK(all["results"][2]["verdict"] == "holds");
  CHECK(document(run({"check", "--format", "json", "nowhere.ele"}))["results"].size() == 1);
}

TEST_CASE("check: --max-errors keeps fewer witnesses and counts all; 0 keeps all") {
  const ScratchFolder folder;
  folder.write("m.node", "5 1 0 0\n0 0\n1 1\n2 2\n3 3\n4 4\n");
  const std::string mesh = folder.write("m.ele", "1 2 0\n0 0 1\n");
  const auto kept = [&](const std::string& most) {
    const Run result = run({"check", "--format", "json", "--max-errors", most, mesh});
    const nlohmann::json verdict = document(result)["results"][0];
    CHECK(verdict["rules"][0]["count"] == 3);
    return verdict["violations"].size();
  };
  CHECK(kept("1") == 1);
  CHECK(kept("0") == 3);
  CHECK(has(run({"check", "--max-errors", "1", mesh}).out, "… and 2 more"));
}

TEST_CASE("check: a mesh on standard input, and points elsewhere") {
  const Meshes meshes;
  const std::string triangle =
      R"({"circumspect": 1, "dimension": 2, "points": [[0,0],[1,0],[0,1]], "simplices": [[0,1,2]]})";
  const Run result = run({"check", "-"}, triangle);
  CHECK(result.exit_code == 0);
  CHECK(result.out == "holds: delaunay - 3 points 1 triangle unique canonical\n");
  const Run garbage = run({"check", "-"}, "\xff\n\n{");
  CHECK(garbage.exit_code == 3);
  CHECK(is_error_line(garbage.err));
  CHECK(run({"check", "-"}).exit_code == 3);
  CHECK(run({"check", meshes.good, "--points", "-"}, kSquare).exit_code == 0);
  const std::string elsewhere = meshes.folder.write("else.node", kKite);
  CHECK(run({"check", meshes.bad, "--points", elsewhere}).exit_code == 1);
}

TEST_CASE("check: a mesh on standard input is told by what it holds") {
  const std::vector<std::string> meshes = {
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
      "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty "
      "double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n"
      "0 1 0\n3 0 1 2\n",
      "MeshVersionFormatted 2\nDimension 2\nVertices\n3\n0 0 0\n1 0 0\n0 1 0\nTriangles\n1\n1 2 3 "
      "0\nEnd\n",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n"
      "$Elements\n1\n1 2 0 1 2 3\n$EndElements\n",
      "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 double\n0 0 0 1 0 "
      "0 "
      "0 1 0\nCELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n",
      "4 vertices\n1 tets\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n4 0 1 2 3\n"};
  for (const std::string& mesh : meshes) {
    CAPTURE(mesh);
    const Run result = run({"check", "-"}, mesh);
    CHECK(result.err == "");
    CHECK(has(result.out, "holds: delaunay - "));
  }
}

TEST_CASE("check: --threads, of any number, does not change the answer") {
  const Meshes meshes;
  const Run one = run({"check", meshes.good, meshes.bad, "--threads", "1"});
  CHECK(one.exit_code == 1);
  for (const std::string threads : {"2", "7", "18446744073709551615"}) {
    const Run result = run({"check", meshes.good, meshes.bad, "--threads", threads});
    CHECK(result.exit_code == 1);
    CHECK(result.out == one.out);
    CHECK(result.err.empty());
  }
}

TEST_CASE("check: a list of simplices on standard input, where the points are known") {
  const Meshes meshes;
  const std::string points = meshes.folder.path("bad.node");
  const Run result = run({"check", "-", "--points", points}, contents(meshes.bad));
  const Run of_file = run({"check", meshes.bad});
  CHECK(result.exit_code == 1);
  CHECK(result.out.substr(0, result.out.rfind("fails:")) ==
        of_file.out.substr(0, of_file.out.rfind("fails:")));
  CHECK(has(result.out, "fails: delaunay - delaunay.facet-not-local 1 face 0 1 vertex 3\n"));
  const Run fault = run({"check", "-", "--points", points}, "2 3 0\n0 0 1 x\n");
  CHECK(fault.exit_code == 3);
  CHECK(begins_with(fault.err, "circumspect: <stdin>:2: expected "));
}

TEST_CASE("check: --oriented demands one orientation") {
  const Meshes meshes;
  meshes.folder.write("mixed.node", kSquare);
  const std::string mixed = meshes.folder.write("mixed.ele", "2 3 0\n1 1 2 3\n2 1 4 3\n");
  CHECK(run({"check", mixed}).exit_code == 0);
  CHECK(run({"check", "--oriented", meshes.good}).exit_code == 0);
  const Run result = run({"check", "--oriented", mixed});
  CHECK(result.exit_code == 1);
  CHECK(has(result.out, " simplex.orientation 1 simplex 1 2 3\n"));
}

TEST_CASE("check: an index that names no point is the mesh's fault, a word is the file's") {
  const Meshes meshes;
  meshes.folder.write("u.node", kSquare);
  const std::string mesh = meshes.folder.write("u.ele", "2 3 0\n1 1 2 3\n2 1 3 5\n");
  const Run result = run({"check", mesh});
  CHECK(result.exit_code == 1);
  CHECK(has(result.out, " triangulation.unknown-vertex 1 simplex 1 3 5 vertex 5 "));
}

TEST_CASE("check: a duplicate point is the input's fault unless it is to be merged") {
  const ScratchFolder folder;
  folder.write("d.node", "5 2 0 0\n1 0 0\n2 1 0\n3 0.0 0\n4 1 1\n5 0 1\n");
  const std::string mesh = folder.write("d.ele", "2 3 0\n1 1 2 4\n2 3 4 5\n");
  const Run rejected = run({"check", mesh});
  CHECK(rejected.exit_code == 3);
  CHECK(is_error_line(rejected.err));
  CHECK(has(rejected.err, "d.node: expected distinct points, found points 1 and 3 equal"));
  const Run merged = run({"check", "--duplicates", "merge", mesh});
  CHECK(merged.exit_code == 0);
  CHECK(has(merged.out, " 4 points 2 triangles "));
  // After the merge everything is still called by the user's own indices, as it is listed.
  folder.write("e.node", contents(folder.path("d.node")));
  const std::string partial = folder.write("e.ele", "2 3 0\n1 1 2 4\n2 3 1 5\n");
  const Run labels = run({"check", "--duplicates", "merge", partial});
  CHECK(labels.exit_code == 1);
  CHECK(has(labels.out, "simplex.repeated-vertex 1 simplex 3 1 5 vertex 1"));
  const std::string unused = folder.write("f.ele", "1 3 0\n1 3 2 4\n");
  folder.write("f.node", contents(folder.path("d.node")));
  CHECK(has(run({"check", "--duplicates", "merge", unused}).out,
            "triangulation.unused-point 1 vertex 5\n"));
}

TEST_CASE("check: 0.1 is what strtod makes of it, or exactly a tenth") {
  const ScratchFolder folder;
  // Four points of one circle in decimals; the doubles nearest to them are on no common circle.
  folder.write("c.node", "4 2 0 0\n0 0.1 0.2\n1 0.4 0.3\n2 0.3 0.6\n3 0 0.5\n");
  const std::string circle = folder.write("c.ele", "2 3 0\n0 0 1 2\n1 0 2 3\n");
  const auto is_unique = [&](const std::string& coordinates) {
    const Run result = run({"check", "--format", "json", "--coordinates", coordinates, circle});
    return document(result)["results"][0].value("unique", true);
  };
  CHECK(!is_unique("decimal"));
  CHECK(is_unique("double"));
}

TEST_CASE("check: --neighbors holds a .neigh file against the mesh, and asks for one") {
  const Meshes meshes;
  CHECK(run({"check", "--neighbors", meshes.good}).exit_code == 3);
  meshes.folder.write("good.neigh", "2 3\n1 -1 2 -1\n2 -1 -1 1\n");
  CHECK(run({"check", "--neighbors", meshes.good}).exit_code == 0);
  meshes.folder.write("good.neigh", "2 3\n1 2 -1 -1\n2 -1 -1 1\n");
  CHECK(run({"check", meshes.good}).exit_code == 0);
  const Run result = run({"check", "--neighbors", meshes.good});
  CHECK(result.exit_code == 1);
  CHECK(has(result.out, "complex.wrong-neighbor 2 "));
  meshes.folder.write("good.neigh", "1 3\n1 2 -1 -1\n");
  CHECK(run({"check", "--neighbors", meshes.good}).exit_code == 3);
}

TEST_CASE("help and version") {
  const Run help = run({"--help"});
  CHECK(help.exit_code == 0);
  CHECK(has(help.out, "Usage: circumspect"));
  CHECK(help.err.empty());
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"check", "--help"}, {"inspect", "--help"}, {"build", "delaunay", "--help"}}) {
    const Run result = run(arguments);
    CHECK(result.exit_code == 0);
    CHECK(has(result.out, "Example:"));
  }
  const Run version = run({"--version"});
  CHECK(version.exit_code == 0);
  CHECK(begins_with(version.out, "circumspect "));
  for (const char* library : {"GMP ", "MPFR ", "{fmt} ", "CLI11 "}) {
    CHECK(has(version.out, library));
  }
}

TEST_CASE("every malformed file of the corpus: exit code 3 and one line that says what is wrong") {
  const std::string folder = CIRCUMSPECT_CORPUS_DIR "/malformed/";
  std::ifstream table(folder + "expected.tsv");
  std::string file;
  std::string options;
  std::string message;
  std::size_t rows = 0;
  while (std::getline(table, file, '\t') && std::getline(table, options, '\t') &&
         std::getline(table, message)) {
    ++rows;
    std::vector<std::string> arguments = {"check", folder + file};
    std::istringstream more(options);
    for (std::string option; more >> option;) {
      const bool is_file = arguments.back() == "--domain" || arguments.back() == "--points";
      arguments.push_back(is_file ? folder + option : option);
    }
    const Run result = run(arguments);
    CAPTURE(file);
    CHECK(result.exit_code == 3);
    // Notes may say how the file was read up to there.
    CHECK((result.out.empty() || begins_with(result.out, "note: ")));
    CHECK_MESSAGE(is_error_line(result.err), result.err);
    CHECK_MESSAGE(has(result.err, message), result.err);
  }
  CHECK(rows > 30);
}

}  // namespace
}  // namespace circumspect::cli
