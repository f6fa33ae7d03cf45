// The defaults that docs/domains.md lists, row by row, as far as domain_kind_command_test.cpp does
// not hold them already.
#include <doctest/doctest.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {
namespace {

const std::string kCubePoints =
    "8 3\n0 0 0 0\n1 4 0 0\n2 0 4 0\n3 4 4 0\n4 0 0 4\n5 4 0 4\n6 0 4 4\n7 4 4 4\n";
const std::string kCubeSquares =
    "1\n4 0 1 3 2\n1\n4 4 5 7 6\n1\n4 0 1 5 4\n1\n4 2 3 7 6\n1\n4 0 2 6 4\n1\n4 1 3 7 5\n";

// What inspect, check of a mesh and build cdt answer to a domain, by exit codes.
struct AnswersToDefaults {
  int inspect, check, build;
  friend bool operator==(const AnswersToDefaults&, const AnswersToDefaults&) = default;
};

class Folder : public ScratchFolder {
 public:
  AnswersToDefaults answers(const std::string& domain, const std::string& mesh,
                            const std::vector<std::string>& kind = {}) const {
    const auto with_kind = [&](std::vector<std::string> arguments) {
      arguments.insert(arguments.end(), kind.begin(), kind.end());
      return run(arguments).exit_code;
    };
    return {with_kind({"inspect", domain}), with_kind({"check", mesh, "--domain", domain}),
            with_kind({"build", "cdt", domain, "-o", path("built.ele")})};
  }
};

const std::vector<std::string> kHull = {"--domain-kind", "hull"};
const std::vector<std::string> kEnclosed = {"--domain-kind", "enclosed"};

}  // namespace

TEST_CASE(
    "flat domains: walls are meshed alone, and without walls there has to be said what is meant") {
  const Folder folder;
  const std::string points = "4 3\n1 0 0 0\n2 3 0 3\n3 3 1 3\n4 0 2 0\n";
  folder.write("m.node", points);
  const std::string mesh = folder.write("m.ele", "0 4\n");
  const std::string faces = "2 0\n1 1 2 3\n2 1 3 4\n";
  folder.write("m.face", faces);
  const std::string square = folder.write("square.poly", points + "1 0\n1\n4 1 2 3 4\n0\n");
  CHECK(folder.answers(square, mesh) == AnswersToDefaults{0, 0, 0});
  CHECK(folder.answers(square, mesh, kEnclosed) == AnswersToDefaults{0, 0, 0});
  CHECK(folder.answers(square, mesh, kHull) == AnswersToDefaults{3, 3, 3});
  folder.write("n.node", points);
  const std::string nothing = folder.write("n.ele", "0 4\n");
  const std::string lone = folder.write("lone.poly", points + "0 0\n0\n");
  CHECK(folder.answers(lone, nothing) == AnswersToDefaults{0, 3, 3});
  CHECK(folder.answers(lone, nothing, kHull) == AnswersToDefaults{3, 3, 3});
  CHECK(folder.answers(lone, nothing, kEnclosed) == AnswersToDefaults{0, 0, 0});
  const Run told = run({"inspect", lone});
  CHECK(has(told.out, "note: " + lone + ": expected points that span space"));
  CHECK(has(told.out, " 0 polyhedra enclosed "));
  const std::string segment = folder.write("segment.poly", points + "1 0\n1\n2 1 2\n0\n");
  folder.write("e.node", points);
  const std::string edge = folder.write("e.ele", "0 4\n");
  folder.write("e.edge", "1 0\n1 1 2\n");
  CHECK(folder.answers(segment, edge) == AnswersToDefaults{0, 3, 3});
  CHECK(folder.answers(segment, edge, kEnclosed) == AnswersToDefaults{0, 0, 0});
}

TEST_CASE("domains on a line of the plane: segments are walls there") {
  const Folder folder;
  const std::string points = "3 2\n1 0 0\n2 4 0\n3 8 0\n";
  folder.write("m.node", points);
  const std::string mesh = folder.write("m.ele", "0 3\n");
  folder.write("m.edge", "2 0\n1 1 2\n2 2 3\n");
  const std::string chain = folder.write("chain.poly", points + "2 0\n1 1 2\n2 2 3\n0\n");
  CHECK(folder.answers(chain, mesh) == AnswersToDefaults{0, 0, 0});
  CHECK(folder.answers(chain, mesh, kHull) == AnswersToDefaults{3, 3, 3});
  CHECK(
      has(run({"check", mesh, "--domain", chain}).out, " 3 points 0 triangles 2 dangling unique"));
  const std::string lone = folder.write("lone.poly", points + "0 0\n0\n");
  folder.write("n.node", points);
  CHECK(folder.answers(lone, folder.write("n.ele", "0 3\n")) == AnswersToDefaults{0, 3, 3});
}

TEST_CASE("what dangles is counted, by build as by check") {
  const Folder folder;
  const std::string flat = folder.write(
      "flat.smesh", "5 3\n0 0 0 0\n1 4 0 4\n2 4 4 4\n3 0 4 0\n4 2 2 2\n1 0\n4 0 1 2 3\n0\n");
  const std::string mesh = folder.path("flat.1.ele");
  CHECK(has(run({"build", "cdt", flat, "-o", mesh}).out, " 5 points 0 tetrahedra 4 dangling "));
  const Run checked = run({"check", mesh, "--domain", flat});
  CHECK(has(checked.out,
            "\nholds: cdt " + mesh + " 5 points 0 tetrahedra 4 dangling unique canonical\n"));
  const auto json = document(run({"check", mesh, "--domain", flat, "--format", "json"}));
  CHECK(json["results"][0]["dangling"] == 4);
  // Vertices that belong to nothing are points.
  const std::string lone = folder.write("lone.poly", "2 3\n0 0 0 0\n1 1 0 1\n0 0\n0\n");
  const Run built = run({"build", "cdt", lone, "--domain-kind", "enclosed", "-o", mesh});
  CHECK(has(built.out, " 2 points 0 tetrahedra canonical\n"));
}

TEST_CASE("a segment that is listed twice counts once, a polygon breaks Definition 4.3") {
  const Folder folder;
  const std::string points = "3 2\n1 0 0\n2 4 0\n3 0 4\n";
  folder.write("m.node", points);
  const std::string mesh = folder.write("m.ele", "1 3\n1 1 2 3\n");
  const std::string segments =
      folder.write("segments.poly", points + "5 0\n1 1 2\n2 2 3\n3 3 1\n4 2 1\n5 2 3\n0\n");
  CHECK(folder.answers(segments, mesh) == AnswersToDefaults{0, 0, 0});
  CHECK(has(run({"inspect", segments}).out, " 3 vertices 3 segments 1 region enclosed "));
  const std::string cube =
      folder.write("cube.poly", kCubePoints + "7 0\n" + kCubeSquares + "1\n4 2 3 1 0\n0\n");
  CHECK(folder.answers(cube, mesh) == AnswersToDefaults{3, 3, 3});
  CHECK(has(run({"inspect", cube}).out, "plc.polygons-overlap"));
}

TEST_CASE("hole seeds: on a wall a fault whatever is filled, elsewhere ignored in a hull") {
  const Folder folder;
  folder.write("m.node", kCubePoints);
  const std::string mesh =
      folder.write("m.ele", "5 4\n0 0 3 5 6\n1 0 1 3 5\n2 0 2 3 6\n3 0 4 5 6\n4 3 5 6 7\n");
  const auto cube = [&](const std::string& seed) {
    return folder.write("cube.poly", kCubePoints + "6 0\n" + kCubeSquares + "1\n1 " + seed + "\n");
  };
  const std::string on_wall = cube("2 2 0");
  for (const auto& kind : {std::vector<std::string>{}, kEnclosed, kHull}) {
    CHECK(folder.answers(on_wall, mesh, kind) == AnswersToDefaults{3, 3, 3});
  }
  CHECK(has(run({"inspect", on_wall, "--domain-kind", "hull"}).out, "plc.hole-seed-on-wall"));
  const std::string inside = cube("2 2 2");
  CHECK(folder.answers(inside, mesh).check == 1);
  CHECK(folder.answers(inside, mesh, kHull) == AnswersToDefaults{0, 0, 0});
  CHECK(has(run({"check", mesh, "--domain", inside, "--domain-kind", "hull"}).out,
            ": hole seed 1 at (2, 2, 2): ignored, there are no holes in a hull\n"));
  CHECK(folder.answers(cube("9 9 9"), mesh) == AnswersToDefaults{0, 0, 0});
}

TEST_CASE("a bridge over the mouth of a tunnel bounds what is beside the tunnel") {
  const Folder folder;
  const std::string points =
      "16 3\n0 0 0 0\n1 4 0 0\n2 0 4 0\n3 4 4 0\n4 0 0 4\n5 4 0 4\n6 0 4 4\n7 4 4 4\n"
      "8 1 1 0\n9 3 1 0\n10 3 3 0\n11 1 3 0\n12 1 1 4\n13 3 1 4\n14 3 3 4\n15 1 3 4\n";
  const std::string others =
      "1\n4 0 1 5 4\n1\n4 2 3 7 6\n1\n4 0 2 6 4\n1\n4 1 3 7 5\n1\n4 8 9 13 12\n1\n4 9 10 14 13\n1\n"
      "4 10 11 15 14\n1\n4 11 8 12 15\n0\n";
  const std::string mouth = "2 1\n4 0 1 3 2\n4 8 9 10 11\n0 2 2 0\n";
  const std::string bridge =
      folder.write("bridge.poly", points + "10 0\n" + mouth + "1\n4 4 5 7 6\n" + others);
  const Run told = run({"inspect", bridge});
  CHECK(told.exit_code == 0);
  CHECK(has(told.out, "note: " + bridge +
                          ": polygon 2 (line 23): a part of it has the outside on both sides and "
                          "bounds nothing, the rest of it bounds what is enclosed; "));
  CHECK(!has(told.out, "bounds nothing: "));
  CHECK(!has(run({"inspect", bridge, "--domain-kind", "enclosed"}).out, "note: "));
}

}  // namespace circumspect::cli
