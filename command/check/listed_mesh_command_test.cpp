// Meshes as files hold them: empty ones, and witnesses that name points and simplices as the user
// listed them.
#include <doctest/doctest.h>

#include "command/run_command_test.hpp"
#include "oracle/formats/reading_test.hpp"

namespace circumspect::cli {

// A file without points and without simplices: in CI it means that a program wrote nothing.

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

// Witnesses name points and simplices as the user listed them: at the ends of 64 bits, and where
// equal points were merged.

namespace {

constexpr const char* kSmallest = "-9223372036854775808";
constexpr const char* kLargest = "9223372036854775807";

// Four corners of a square; the fifth point is the first one again.
constexpr const char* kSquareAndAgain = "5 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 0 0\n";

// What check says of such points and simplices.
struct Merged {
  ScratchFolder folder;
  Run check(const std::string& node, const std::string& ele,
            std::vector<std::string> options = {}) {
    folder.write("m.node", node);
    options.insert(options.begin(), {"check", "--duplicates", "merge"});
    options.push_back(folder.write("m.ele", ele));
    return run(options);
  }
};

TEST_CASE("an index that names no point is named as it stands, however far it is from the others") {
  const ScratchFolder folder;
  const auto check = [&folder](const std::string& node, const std::string& ele) {
    folder.write("x.node", node);
    return run({"check", folder.write("x.ele", ele)}).out;
  };
  const std::string high =
      "3 2 0 0\n9223372036854775805 0 0\n9223372036854775806 1 0\n9223372036854775807 0 1\n";
  const std::string own = "9223372036854775805 9223372036854775806 ";
  CHECK(has(check(high, "1 3 0\n0 " + own + kLargest + "\n"), "holds: "));
  for (const std::string wrong : {"-5", "-6", "0", "9223372036854775804", kSmallest}) {
    CAPTURE(wrong);
    CHECK(has(check(high, "1 3 0\n0 " + own + wrong + "\n"),
              "unknown-vertex 1 simplex " + own + wrong + " vertex " + wrong + " also"));
  }
  const std::string low =
      "3 2 0 0\n-9223372036854775808 0 0\n-9223372036854775807 1 0\n-9223372036854775806 0 1\n";
  for (const std::string wrong : {"0", "7", kLargest}) {
    CAPTURE(wrong);
    CHECK(has(check(low, "1 3 0\n0 -9223372036854775808 -9223372036854775807 " + wrong + "\n"),
              " vertex " + wrong + " also"));
  }
  // Two that were taken for one would be a vertex repeated, or a simplex listed again.
  const std::string two =
      check(low, "2 3 0\n0 -9223372036854775808 5 6\n1 -9223372036854775808 5 7\n");
  CHECK(has(two, "simplex  -9223372036854775808 5 7\n"));
  CHECK(!has(two, "duplicate-simplex"));
}

TEST_CASE("json: the first index may be near 2^63 if there is room for all points") {
  const std::string points = R"("points": [[0,0],[1,0],[0,1]], "simplices": [[)";
  const auto check = [&points](const std::string& first, const std::string& simplex) {
    return run({"check", "-"}, R"({"circumspect": 1, "dimension": 2, "first_index": )" + first +
                                   ", " + points + simplex + "]]}");
  };
  const std::string first = "9223372036854775805";
  CHECK(check(first, first + ", 9223372036854775806, " + kLargest).exit_code == 0);
  CHECK(has(check(first, first + ", 9223372036854775806, -7").out, " vertex -7 also"));
  CHECK(has(check(kSmallest, std::string(kSmallest) + ", 1, 2").out, " vertex 1 also"));
  const Run without_room = check("9223372036854775806", "0, 1, 2");
  CHECK(without_room.exit_code == 3);
  CHECK(has(without_room.err, "leaves room for 3 points in 64 bits"));
}

TEST_CASE("what build numbers fits 64 bits, and can be read again") {
  const ScratchFolder folder;
  const std::string points =
      folder.write("x.node",
                   "4 2 0 0\n9223372036854775804 0 0\n9223372036854775805 1 0\n"
                   "9223372036854775806 0 1\n9223372036854775807 0.3 0.3\n");
  const std::string mesh = folder.path("x.ele");
  CHECK(run({"build", "delaunay", points, "-o", mesh, "--neighbors", folder.path("x.neigh")})
            .exit_code == 0);
  CHECK(run({"check", "--neighbors", mesh}).exit_code == 0);
  // With the index -1 a simplex could not be told from none.
  folder.write("y.node", "4 2 0 0\n-3 0 0\n-2 1 0\n-1 0 1\n0 0.3 0.3\n");
  CHECK(run({"build", "delaunay", folder.path("y.node"), "-o", folder.path("y.ele"), "--neighbors",
             folder.path("y.neigh")})
            .exit_code == 0);
  CHECK(begins_with(contents(folder.path("y.neigh")), "3 3\n0 "));
  CHECK(run({"check", "--neighbors", folder.path("y.ele")}).exit_code == 0);
  // A domain whose Steiner points have no index left.
  const std::string domain = folder.write(
      "d.poly",
      "4 2 0 0\n9223372036854775804 0 0\n9223372036854775805 10 0\n9223372036854775806 5 1\n"
      "9223372036854775807 5 -1\n1 0\n1 9223372036854775804 9223372036854775805\n0\n");
  const Run crowded = run({"build", "conforming-delaunay", domain, "-o", folder.path("d.ele"),
                           "--domain-kind", "hull"});
  CHECK(crowded.exit_code == 3);
  CHECK(is_error_line(crowded.err));
  CHECK(has(crowded.err, "leave room for "));
  CHECK(!std::filesystem::exists(folder.path("d.ele")));
}

TEST_CASE("merged: simplices are named as they are listed, and which points are equal is said") {
  Merged merged;
  const Run repeated = merged.check(kSquareAndAgain, "2 3 0\n1 1 2 3\n2 5 4 1\n");
  CHECK(repeated.exit_code == 1);
  CHECK(has(repeated.out, "  simplex  5 4 1\n  equal    points 5 and 1\n  vertex   1 at (0, 0)\n"));
  CHECK(has(repeated.out, "simplex.repeated-vertex 1 simplex 5 4 1 vertex 1\n"));
  const Run unknown = merged.check(kSquareAndAgain, "2 3 0\n1 1 2 3\n2 5 4 6\n");
  CHECK(has(unknown.out, "unknown-vertex 1 simplex 5 4 6 vertex 6"));
}

TEST_CASE("merged: of simplices that became the same each is named as it is listed") {
  Merged merged;
  const Run result = merged.check(kSquareAndAgain, "4 3 0\n1 1 2 3\n2 5 2 3\n3 1 3 4\n4 5 2 3\n");
  CHECK(has(result.out, "  simplex  1 2 3\n  simplex  5 2 3\n  equal    points 5 and 1\n"));
  CHECK(has(result.out, "  simplex  5 2 3\n  simplex  5 2 3\n  equal    points 5 and 1\n"));
  CHECK(has(result.out, "complex.duplicate-simplex 2 simplex 1 2 3"));
}

TEST_CASE("merged: a face is named as the first of its simplices lists it") {
  Merged merged;
  // A kite cut along its longer diagonal, whose ends are listed twice.
  const std::string kite = "6 2 0 0\n1 -2 0\n2 2 0\n3 0 1\n4 0 -0.5\n5 -2 0\n6 2 0\n";
  const Run result = merged.check(kite, "2 3 0\n1 5 6 3\n2 1 6 4\n");
  CHECK(has(result.out,
            "  simplex  5 6 3\n  face     5 6\n  equal    points 5 and 1\n"
            "  equal    points 6 and 2\n  vertex   4 at (0, -0.5)\n"));
  CHECK(has(result.out, "delaunay.facet-not-local 1 face 5 6 vertex 4\n"));
  const Run json = merged.check(kite, "2 3 0\n1 5 6 3\n2 1 6 4\n", {"--format", "json"});
  const nlohmann::json violation = document(json)["results"][0]["violations"][0];
  CHECK(violation["simplices"] == nlohmann::json::parse("[[5, 6, 3]]"));
  CHECK(violation["face"] == nlohmann::json::parse("[5, 6]"));
  CHECK(violation.at("merged") == nlohmann::json::parse(R"({"5": 1, "6": 2})"));
  CHECK(violation.at("coordinates").at("5") == violation["coordinates"]["1"]);
  CHECK(violation.at("coordinates").at("5") == nlohmann::json::parse(R"(["-2", "0"])"));
}

TEST_CASE("merged: of weighted points the heaviest is left, with its weight and its index") {
  Merged merged;
  // The centre of a square, first submerged and then heavy enough to be a vertex.
  const std::string centre = "6 2 1 0\n1 0 0 0\n2 2 0 0\n3 2 2 0\n4 0 2 0\n5 1 1 -3\n6 1 1 0\n";
  const std::string fan = "4 3 0\n1 1 2 5\n2 2 3 5\n3 3 4 6\n4 4 1 6\n";
  CHECK(merged.check(centre, fan, {"--claim", "weighted-delaunay"}).exit_code == 0);
  const Run without =
      merged.check(centre, "2 3 0\n1 1 2 3\n2 1 3 4\n", {"--claim", "weighted-delaunay"});
  CHECK(without.exit_code == 1);
  CHECK(has(without.out, " vertex 6\n"));
  const std::string points = merged.folder.write("w.node", centre);
  const std::string mesh = merged.folder.path("w.ele");
  CHECK(
      run({"build", "weighted-delaunay", "--duplicates", "merge", points, "-o", mesh}).exit_code ==
      0);
  CHECK(has(contents(mesh), " 6"));
  CHECK(!has(contents(mesh), " 5"));
  CHECK(run({"check", "--duplicates", "merge", "--claim", "weighted-delaunay", mesh}).exit_code ==
        0);
  // Of equal weights the first.
  const Run first = merged.check("4 2 1 0\n1 0 0 1\n2 1 0 1\n3 0 1 1\n4 0 0 1\n",
                                 "1 3 0\n1 4 2 1\n", {"--claim", "weighted-delaunay"});
  CHECK(has(first.out, "simplex 4 2 1 vertex 1\n"));
}

TEST_CASE("merged: inspect is asked by any index of a point, and answers by that") {
  const ScratchFolder folder;
  const std::string points = folder.write("m.node", kSquareAndAgain);
  const Run result = run({"inspect", points, "--simplex", "5 2", "--simplex", "2 1"});
  CHECK(result.exit_code == 0);
  CHECK(has(result.out, "simplex 5 2: strongly-delaunay"));
  CHECK(has(result.out, "simplex 2 1: strongly-delaunay"));
  const Run twice = run({"inspect", points, "--simplex", "5 1"});
  CHECK(twice.exit_code == 2);
  CHECK(has(twice.err, "expected affinely independent points, found 5 1"));
  CHECK(has(run({"inspect", points, "--simplex", "6"}).err, "expected indices of points, found "));
}

TEST_CASE("merged: dangling triangles and edges are named as they are listed") {
  const ScratchFolder folder;
  const std::string domain =
      folder.write("d.poly", "4 2 0 0\n1 0 0\n2 1 0\n3 0 1\n4 5 5\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n");
  folder.write("m.node", "5 2 0 0\n1 0 0\n2 1 0\n3 0 1\n4 5 5\n5 0 0\n");
  folder.write("m.edge", "1 0\n1 5 4\n");
  const Run result = run({"check", "--duplicates", "merge", "--domain", domain,
                          folder.write("m.ele", "1 3 0\n1 5 2 3\n")});
  CHECK(result.exit_code == 1);
  CHECK(has(result.out, "  simplex  5 4\n  equal    points 5 and 1\n"));
}

}  // namespace

}  // namespace circumspect::cli
