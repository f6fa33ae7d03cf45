// What check cannot do beside another option is refused, and never left out: a verdict would be
// about less than was asked for.
#include <doctest/doctest.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {
namespace {

using Words = std::vector<std::string>;

// A triangle, with everything that options may name.
struct Corner {
  ScratchFolder folder;
  std::string points = folder.write("a.node", "3 2 0 0\n0 0 0\n1 4 0\n2 0 4\n");
  std::string mesh = folder.write("a.ele", "1 3 1\n0 0 1 2 1\n");
  std::string domain = folder.write("a.poly", "0 2 0 0\n3 0\n0 0 1\n1 1 2\n2 2 0\n0\n");

  Run judged(const Words& some, const Words& more) const {
    Words all = {"check", mesh};
    all.insert(all.end(), some.begin(), some.end());
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  }
  // Each alone is not a reason to refuse the command line.
  void contradict(const Words& one, const Words& other) const {
    const Run both = judged(one, other);
    CAPTURE(one.front());
    CAPTURE(other.front());
    CHECK(both.exit_code == 2);
    CHECK(both.out.empty());
    CHECK_MESSAGE(has(both.err, "expected "), both.err);
  }
  // One alone is refused, and has a meaning beside the other.
  void depends(const Words& one, const Words& other) const {
    CAPTURE(one.front());
    CHECK(judged(one, {}).exit_code == 2);
    CHECK(judged(one, other).exit_code != 2);
  }
};

}  // namespace

TEST_CASE("check: two orientations contradict each other") {
  const Corner corner;
  corner.contradict({"--claim", "complex", "--oriented=positive"}, {"--oriented=negative"});
  corner.contradict({"--oriented"}, {"--oriented=positive"});
}

TEST_CASE("check --memory refuses every question that needs the whole mesh") {
  const Corner corner;
  const Words memory = {"--memory", "64M"};
  CHECK(corner.judged({}, memory).exit_code == 0);
  for (const Words& asked : std::initializer_list<Words>{{"--domain", corner.domain},
                                                         {"--by", "definition"},
                                                         {"--oriented"},
                                                         {"--require", "edge:9"},
                                                         {"--neighbors"},
                                                         {"--keep-label", "1"},
                                                         {"--dimension", "2"},
                                                         {"--allow-empty"},
                                                         {"--duplicates", "merge"},
                                                         {"--coordinates", "decimal"},
                                                         {"--certificate", "c"},
                                                         {"--html", "p.html"}}) {
    corner.contradict(asked, memory);
  }
}

TEST_CASE("check: options that are about different things do not stand beside each other") {
  const Corner corner;
  const Words certificate = {"--certificate", "c"}, neighbors = {"--neighbors"},
              labels = {"--keep-label", "1"};
  corner.contradict({"--require", "edge:9"}, certificate);
  corner.contradict({"--domain", corner.domain, "--within", "1"}, certificate);
  corner.contradict(neighbors, labels);
  corner.contradict(certificate, labels);
  for (const char* const claim : {"convex-hull", "surface-delaunay", "complex"}) {
    corner.contradict({"--claim", claim}, neighbors);
    corner.contradict({"--claim", claim}, {"--memory", "64M"});
  }
  corner.contradict({"--claim", "complex", "--closed"}, {"--allow", "hanging-vertex"});
}

TEST_CASE("check: a demand of one claim alone is refused beside every other") {
  const Corner corner;
  const Words complex = {"--claim", "complex"};
  for (const Words& demand : std::initializer_list<Words>{{"--manifold"},
                                                          {"--connected"},
                                                          {"--closed"},
                                                          {"--faces"},
                                                          {"--allow-unused"},
                                                          {"--allow", "hanging-vertex"},
                                                          {"--oriented=positive"},
                                                          {"--oriented=negative"}}) {
    corner.depends(demand, complex);
  }
  const Words hull = {"--claim", "convex-hull"};
  corner.depends({"--all-boundary-points"}, hull);
  corner.depends({"--only-extreme"}, hull);
  corner.depends({"--except-sharp", "60deg"}, {"--require", "edge:9"});
  corner.depends({"--within", "1"}, {"--domain", corner.domain});
  // What is demanded counts.
  CHECK(corner.judged(complex, {"--oriented=positive"}).exit_code == 0);
  CHECK(corner.judged(complex, {"--oriented=negative"}).exit_code == 1);
}

}  // namespace circumspect::cli
