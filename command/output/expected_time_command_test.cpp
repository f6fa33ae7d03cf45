// What nobody waits for is said beforehand.
#include <doctest/doctest.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {
namespace {

// Some points of dimension 16, and simplices of any 17 of them.
struct InManyDimensions {
  ScratchFolder folder;
  std::string points;
  std::string mesh;

  InManyDimensions() {
    constexpr unsigned point_count = 200;
    constexpr int simplex_count = 800;
    constexpr unsigned dimension = 16;
    unsigned state = 1;
    const auto next = [&state] { return (state = state * 1103515245 + 12345) >> 16; };
    std::string nodes = "200 16 0 0\n";
    for (unsigned i = 0; i < point_count; ++i) {
      nodes += std::to_string(i);
      for (unsigned k = 0; k < dimension; ++k) nodes += " " + std::to_string(next() % 1000);
      nodes += "\n";
    }
    std::string elements = "800 17 0\n";
    for (int i = 0; i < simplex_count; ++i) {
      elements += std::to_string(i);
      // No two of them are the same: that would be all that is said of them.
      const unsigned first = static_cast<unsigned>(i) % point_count;
      const unsigned step = 1 + static_cast<unsigned>(i) / point_count;
      for (unsigned k = 0; k <= dimension; ++k) {
        elements += " " + std::to_string((first + k * step) % point_count);
      }
      elements += "\n";
    }
    points = folder.write("many.node", nodes);
    mesh = folder.write("many.ele", elements);
  }
};

TEST_CASE("judging and triangulating in dimension 16: what takes long is announced") {
  const InManyDimensions files;
  const Run check = run({"check", files.mesh, "--limit", "300ms"});
  CHECK(check.exit_code == 4);
  CHECK(has(check.err, "circumspect: judging " + files.mesh + " may take about 2"));
  CHECK(has(check.err, " s (--limit TIME ends it)\n"));
  const Run build = run(
      {"build", "delaunay", files.points, "-o", files.folder.path("y.ele"), "--limit", "300ms"});
  CHECK(build.exit_code == 4);
  CHECK(has(build.err, "circumspect: triangulating " + files.points + " may take about longer"));
}

TEST_CASE("in space, nobody is warned of a moment") {
  const Run check = run({"check", CIRCUMSPECT_CORPUS_DIR "/peers/tetgen/random-3d-500.1.ele"});
  CHECK(check.exit_code == 0);
  CHECK(check.err.empty());
}

}  // namespace
}  // namespace circumspect::cli
