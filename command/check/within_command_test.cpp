// check --within, as its users run it.
#include <algorithm>

#include <doctest/doctest.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {
namespace {

const std::string kFolder = CIRCUMSPECT_CORPUS_DIR "/domains/";

Run check_near(const std::string& name, const std::vector<std::string>& more) {
  std::vector<std::string> words = {"check", kFolder + name + ".ele", "--domain",
                                    kFolder + name + ".poly"};
  words.insert(words.end(), more.begin(), more.end());
  return run(words);
}

}  // namespace

TEST_CASE("check --within: the verdict ends with the distance that was needed") {
  const Run moved = check_near("accept/within--segment", {"--within", "1e-8"});
  CHECK(moved.exit_code == 0);
  CHECK(has(moved.out, "holds: steiner-cdt"));
  CHECK(has(moved.out, "within ~ 5."));
  // 1e-8 of the longest side, which is 4: as much, or a half of what is needed.
  CHECK(check_near("accept/within--segment", {"--within", "1e-8x"}).exit_code == 0);
  CHECK(check_near("accept/within--segment", {"--within", "1/1000000000x"}).exit_code == 1);
  const Run less = check_near("accept/within--segment", {"--within", "4e-9"});
  CHECK(less.exit_code == 1);
  CHECK(has(less.out, "fails: steiner-cdt"));
  CHECK(has(less.out, "domain.segment-missing 1"));
  CHECK(has(less.out, "beyond ~ 4.0e-09"));
  const Run exact = check_near("accept/cube-five", {"--within", "1"});
  CHECK(exact.exit_code == 0);
  CHECK(has(exact.out, "within 0"));
}

TEST_CASE("check --within: JSON has the square of the distance, exactly") {
  const auto json = document(check_near(
      "accept/within--vertex",
      {"--within", "1e-8", "--claim", "plc-triangulation", "--format", "json"}))["results"][0];
  CHECK(json["verdict"] == "holds");
  CHECK(json["claim"] == "plc-triangulation");
  CHECK(json["within"].contains("squared_distance"));
  CHECK(json["within"]["distance_rounded_up"] == "3.1e-09");
  CHECK(json["within"]["polygons_not_compared"] == 0);
}

TEST_CASE("check --within: where the distance does not tell cells apart, there is no verdict") {
  ScratchFolder folder;
  const std::string domain = folder.write(
      "d.poly",
      "5 2 0 0\n0 0 0\n1 4 0\n2 4 4\n3 0 4\n4 2 1e-9\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n");
  folder.write("m.node", "5 2 0 0\n0 0 0\n1 4 0\n2 4 4\n3 0 4\n4 2 -1e-9\n");
  const std::string mesh = folder.write("m.ele", "3 3 0\n0 0 4 3\n1 4 2 3\n2 4 1 2\n");
  const Run result = run({"check", mesh, "--domain", domain, "--within", "1e-7"});
  CHECK(result.exit_code == 3);
  CHECK(has(result.err, "vertex 4"));
  CHECK(has(result.err, "Name a smaller distance"));
  CHECK(result.out.find("holds") == std::string::npos);
}

TEST_CASE("check: without --within a note says what is left of a mesh of rounded coordinates") {
  const std::vector<std::string> claim = {"--claim", "plc-triangulation"};
  const Run holds = check_near("accept/within--vertex", claim);
  CHECK(holds.exit_code == 1);
  CHECK(has(holds.out + holds.err,
            "(domain.vertex-missing 1): with --within 3.1e-09 the claim holds"));
  CHECK(check_near("accept/within--vertex", {"--claim", "plc-triangulation", "--within", "3.1e-09"})
            .exit_code == 0);
  CHECK(check_near("accept/within--vertex", {"--claim", "plc-triangulation", "--within", "2.9e-09"})
            .exit_code == 1);
  const Run more = check_near("reject/domain.outside--within-2d", {});
  CHECK(more.exit_code == 1);
  CHECK(has(more.out + more.err, "the mesh still breaks domain.outside 2"));
}

TEST_CASE(
    "check --within: what is not a distance, and a distance without a domain, are usage errors") {
  for (const char* wrong : {"-1", "x", "near", "", "1e-9xx"}) {
    const Run result = check_near("accept/cube-five", {"--within", wrong});
    CHECK(result.exit_code == 2);
  }
  CHECK(run({"check", kFolder + "accept/cube-five.ele", "--within", "1"}).exit_code == 2);
}

TEST_CASE("check --within: a convex hull, and a face of it that nobody listed") {
  const Run hull =
      check_near("accept/within--segment", {"--domain-kind", "hull", "--within", "1e-8"});
  CHECK(hull.exit_code == 0);
  CHECK(has(hull.out, "within ~ 5."));
  ScratchFolder folder;
  const std::string corners = "0 0 0 0\n1 1 0 0\n2 0 1 0\n3 1 1 0\n4 0 0 1\n5 1 0 1\n6 0 1 1\n";
  const std::string domain = folder.write("d.poly", "8 3 0 0\n" + corners + "7 1 1 1\n0 0\n0\n");
  folder.write("m.node", "8 3 0 0\n" + corners + "7 1 1 1.000000001\n");
  const std::string others = "1 0 1 5 7\n2 0 2 3 7\n3 0 2 6 7\n4 0 4 5 7\n5 0 4 6 7\n";
  const std::string whole = folder.write("m.ele", "6 4 0\n0 0 1 3 7\n" + others);
  CHECK(
      run({"check", whole, "--domain", domain, "--within", "1e-8", "--claim", "plc-triangulation"})
          .exit_code == 0);
  const std::string less = folder.write("m.ele", "5 4 0\n" + others);
  folder.write("m.edge", "1 0\n0 1 3\n");
  const Run fails = run({"check", less, "--domain", domain, "--within", "1e-8"});
  CHECK(fails.exit_code == 1);
  CHECK(has(fails.out, "domain.polygon-not-tiled 2"));
  CHECK(has(fails.out, "hull-face 0 1 "));
  const auto json =
      document(run({"check", less, "--domain", domain, "--within", "1e-8", "--format", "json"}));
  CHECK(json["results"][0]["violations"][0]["domain"].contains("hull_face"));
  const std::string page = folder.path("m.html");
  CHECK(run({"check", less, "--domain", domain, "--within", "1e-8", "--html", page}).exit_code ==
        1);
}

TEST_CASE("check --within: the markers of a .face file say which facets a polygon is") {
  // A square wall in a bipyramid. Two of its corners are moved, so that a flat tetrahedron is
  // between two ways to tile it. Above, where that belongs if nobody says otherwise, all facets
  // that are not walls see into balls.
  ScratchFolder folder;
  const std::string apexes = "4 0 0 1\n5 0 0 -5\n";
  const std::string points = "6 3 0 0\n0 -3 0 0\n1 0 3 0\n2 3 0 0\n3 0 -3 0\n" + apexes;
  const std::string roof =
      "3 0 1 4 1\n3 1 2 4 1\n3 2 3 4 1\n3 3 0 4 1\n3 0 1 5 1\n3 1 2 5 1\n"
      "3 2 3 5 1\n3 3 0 5 1\n0\n0\n";
  const std::string whole = folder.write("d.smesh", points + "9 1\n4 0 1 2 3 7\n" + roof);
  const std::string halves =
      folder.write("e.smesh", points + "10 1\n3 0 1 2 7\n3 0 2 3 7\n" + roof);
  const std::string others =
      folder.write("f.smesh", points + "10 1\n3 0 1 2 7\n3 0 2 3 8\n" + roof);
  folder.write("m.node", "6 3 0 0\n0 -3 0 -1e-9\n1 0 3 0\n2 3 0 -1e-9\n3 0 -3 0\n" + apexes);
  const std::string mesh =
      folder.write("m.ele", "5 4 0\n0 0 1 3 4\n1 1 2 3 4\n2 0 1 2 3\n3 0 1 2 5\n4 0 2 3 5\n");
  const auto last_line = [&](const std::string& domain, const std::vector<std::string>& more) {
    std::vector<std::string> words = {"check", mesh, "--domain", domain};
    words.insert(words.end(), more.begin(), more.end());
    const std::string out = run(words).out;
    return out.substr(std::min(out.find("holds:"), out.find("fails:")));
  };
  const std::string above = "cdt.facet-not-local 3 ", below = "cdt.facet-not-local 1 ";
  CHECK(has(last_line(whole, {"--within", "1e-8"}), above));
  folder.write("m.face", "2 1\n0 3 1 0 7\n1 1 2 3 7\n");
  CHECK(has(last_line(whole, {"--within", "1e-8"}), below));
  CHECK(has(last_line(whole, {"--within", "1e-8", "--coordinates", "decimal"}), below));
  CHECK(has(last_line(halves, {"--within", "1e-8", "--merge-coplanar"}), below));
  CHECK(has(last_line(others, {"--within", "1e-8", "--merge-coplanar"}), above));
  // The note under the exact verdict says what --within would.
  const Run exact = run({"check", mesh, "--domain", whole});
  CHECK(exact.exit_code == 1);
  CHECK(has(exact.out + exact.err,
            "with --within 1.1e-09 the mesh still breaks cdt.facet-not-local 1\n"));
  folder.write("m.face", "2 1\n0 0 1 3 7\n1 1 2 3 8\n");
  CHECK(has(last_line(whole, {"--within", "1e-8"}), above));
}

}  // namespace circumspect::cli
