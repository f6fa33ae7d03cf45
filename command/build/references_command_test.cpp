// circumspect build with every algorithm, of weighted sets, subdivisions and all triangulations;
// and inspect --simplex, as their users run them.
#include <doctest/doctest.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {
namespace {

constexpr const char* kGrid =
    "9 2\n1 0 0\n2 1 0\n3 2 0\n4 0 1\n5 1 1\n6 2 1\n7 0 2\n8 1 2\n9 2 2\n";
constexpr const char* kSquareWithLightCentre =
    "5 2 1\n1 0 0 0\n2 4 0 0\n3 0 4 0\n4 4 4 0\n5 1 1 -9\n";

TEST_CASE("build: one file, byte for byte, whatever the algorithm, order, location and seed") {
  const ScratchFolder folder;
  const std::string points = folder.write("grid.node", kGrid);
  const Run first = run({"build", "delaunay", points, "-o", "-"});
  CHECK(first.exit_code == 0);
  for (const char* algorithm : {"by-definition", "flips", "gift-wrapping", "gift-wrapping-cells",
                                "lifted-hull", "lifted-hull-by-definition"}) {
    CAPTURE(algorithm);
    CHECK(run({"build", "delaunay", points, "-o", "-", "--algorithm", algorithm}).out == first.out);
  }
  for (const char* order : {"as-given", "random", "brio-hilbert", "brio-z-order"}) {
    for (const char* location : {"linear-scan", "conflict-graph", "walking"}) {
      CAPTURE(order);
      CAPTURE(location);
      CHECK(run({"build", "delaunay", points, "-o", "-", "--order", order, "--location", location,
                 "--seed", "7"})
                .out == first.out);
    }
  }
}

TEST_CASE("build --statistics counts what was created") {
  const ScratchFolder folder;
  const std::string points = folder.write("grid.node", kGrid);
  const Run built = run({"build", "delaunay", points, "-o", folder.path("x.ele"), "--statistics"});
  CHECK(begins_with(built.out, "created: "));
  CHECK(built.out.find("\nconflict tests: ") != std::string::npos);
}

TEST_CASE("build weighted-delaunay names the points that are not vertices, and check accepts it") {
  const ScratchFolder folder;
  const std::string points = folder.write("w.node", kSquareWithLightCentre);
  const std::string mesh = folder.path("w.ele");
  const Run built = run({"build", "weighted-delaunay", points, "-o", mesh});
  CHECK(built.out == "not vertices: 5\nbuilt: weighted-delaunay " + points +
                         " 5 points 2 triangles not-unique canonical\n");
  CHECK(run({"check", "--claim", "weighted-delaunay", mesh}).exit_code == 0);
  CHECK(run({"check", "--claim", "triangulation", mesh}).exit_code == 1);
  const Run json = run({"build", "weighted-delaunay", points, "--format", "json"});
  CHECK(run({"check", "--claim", "weighted-delaunay", "-"}, json.out).exit_code == 0);
}

TEST_CASE("build weighted-delaunay without weights is the input's fault") {
  const ScratchFolder folder;
  const std::string points = folder.write("grid.node", kGrid);
  const Run built = run({"build", "weighted-delaunay", points, "-o", folder.path("x.ele")});
  CHECK(built.exit_code == 3);
  CHECK(built.err.find("expected a weight for each point") != std::string::npos);
}

TEST_CASE("build delaunay-subdivision: the four squares of a grid, and their faces") {
  const ScratchFolder folder;
  const std::string points = folder.write("grid.node", kGrid);
  for (const char* algorithm : {"lifted-hull", "by-definition", "gift-wrapping-cells"}) {
    CAPTURE(algorithm);
    const Run text = run({"build", "delaunay-subdivision", points, "--algorithm", algorithm});
    CHECK(text.exit_code == 0);
    CHECK(text.out ==
          "cell 1 2 4 5\ncell 2 3 5 6\ncell 4 5 7 8\ncell 5 6 8 9\n"
          "built: delaunay-subdivision " +
              points + " 9 points 4 cells not-simplicial\n");
  }
  const Run json = run({"build", "delaunay-subdivision", points, "--format", "json"});
  const auto result = document(json)["results"][0];
  CHECK(result["simplicial"] == false);
  CHECK(result["faces"]["0"].size() == 9);
  CHECK(result["faces"]["1"].size() == 12);
}

TEST_CASE("build lexicographic is a triangulation") {
  const ScratchFolder folder;
  const std::string points = folder.write("x.node", "4 2\n1 0 0\n2 1 2\n3 3 1\n4 9 0\n");
  const std::string mesh = folder.path("x.ele");
  CHECK(run({"build", "lexicographic", points, "-o", mesh}).exit_code == 0);
  CHECK(run({"check", "--claim", "triangulation", mesh}).exit_code == 0);
}

TEST_CASE("build all-triangulations: the two of a square, and a limit that the user sets") {
  const ScratchFolder folder;
  const std::string points = folder.write("s.node", "4 2\n1 0 0\n2 1 0\n3 0 1\n4 1 1\n");
  CHECK(run({"build", "all-triangulations", points}).out ==
        "1 2 3, 2 3 4 delaunay regular\n1 2 4, 1 3 4 delaunay regular\n"
        "built: all-triangulations " +
            points + " 4 points 2 triangulations 2 regular 2 delaunay\n");
  const Run refused = run({"build", "all-triangulations", points, "--max-points", "3"});
  CHECK(refused.exit_code == 4);
  CHECK(refused.err.find("expected at most 3 points, found 4") != std::string::npos);
}

TEST_CASE("inspect --simplex: strongly Delaunay, Delaunay, neither; and questions with a fault") {
  const ScratchFolder folder;
  const std::string points = folder.write("grid.node", kGrid);
  const auto answer = [&](const std::string& simplex) {
    return run({"inspect", points, "--simplex", simplex}).out;
  };
  CHECK(has(answer("1 2"), "simplex 1 2: strongly-delaunay, ball of centre"));
  CHECK(has(answer("1,5"), "simplex 1 5: delaunay, ball of centre"));
  CHECK(has(answer("1 6"), "simplex 1 6: not-delaunay, every open circumball contains"));
  CHECK(run({"inspect", points, "--simplex", "1 99"}).exit_code == 2);
  CHECK(run({"inspect", points, "--simplex", "1 2 3"}).exit_code == 2);
  CHECK(run({"inspect", points, "--simplex", ""}).exit_code == 2);
}

TEST_CASE("inspect counts the simplices of the canonical triangulation against the bounds") {
  const ScratchFolder folder;
  // Two skew lines with 3 points each: (3 − 1)(3 − 1) tetrahedra.
  const std::string points =
      folder.write("lines.node", "6 3\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 0 1\n5 0 1 1\n6 0 2 1\n");
  const std::string out = run({"inspect", points}).out;
  CHECK(out.find("simplices: 13 of at most 15 edges, 12 of at most 18 triangles, "
                 "4 of at most 8 tetrahedra\n") != std::string::npos);
}

}  // namespace
}  // namespace circumspect::cli
