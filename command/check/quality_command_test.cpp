// --require and --except-sharp of check and certify.
#include <doctest/doctest.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {
namespace {

// A rectangle that is cut from a point near its lower side, and the domain that it fills.
struct House {
  ScratchFolder folder;
  std::string mesh = written();
  std::string domain = folder.write(
      "house.poly", "4 2 0 0\n0 0 0\n1 10 0\n2 10 8\n3 0 8\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n");

  std::string written() {
    folder.write("house.node", "5 2 0 0\n0 0 0\n1 10 0\n2 10 8\n3 0 8\n4 5 1\n");
    return folder.write("house.ele", "4 3 0\n0 0 1 4\n1 3 0 4\n2 1 2 4\n3 2 3 4\n");
  }
  Run judged(std::vector<std::string> more) const {
    more.insert(more.begin(), {"check", mesh});
    return run(more);
  }
};

}  // namespace

TEST_CASE("check --require: kept or not, in words and in JSON, with any claim") {
  const House house;
  const Run kept =
      house.judged({"--require", "min-angle:11deg", "--require", "max-angle <= 158deg"});
  CHECK(kept.exit_code == 0);
  CHECK(has(kept.out, " canonical min-angle:11deg max-angle:158deg\n"));
  const Run broken = house.judged({"--require", "min-angle >= 20.7deg"});
  CHECK(broken.exit_code == 1);
  CHECK(has(broken.out,
            "quality.min-angle: an angle of a triangle is smaller than was required\n"
            "  simplex  0 1 4\n  vertex   0 at (0, 0)\n"));
  CHECK(has(broken.out, "measured 11.309932474020213deg, required min-angle >= 20.7deg\n"));
  CHECK(has(broken.out, "quality.min-angle 1 simplex 0 1 4 vertex 0\n"));
  CHECK(house.judged({"--require", "min-angle >= 20.7deg", "--by", "definition"}).out ==
        broken.out);
  const Run json = house.judged({"--require", "radius-edge:sqrt(2)", "--format", "json"});
  const auto result = document(json)["results"][0];
  CHECK(result["quality"]["required"][0] == "radius-edge:sqrt(2)");
  CHECK(result["violations"][0]["measured"]["text"] == "2.5495097567963922");
  CHECK(result["violations"][0]["values"]["square"]["exact"] == "13/2");
  CHECK(has(house.judged({"--claim", "complex", "--require", "edge:9"}).out,
            "quality.edge 2 face 0 1\n"));
  CHECK(has(house.judged({"--domain", house.domain, "--require", "area:30"}).out,
            "fails: steiner-cdt"));
  CHECK(
      has(house.judged({"--domain", house.domain, "--within", "1e-9", "--require", "area:30"}).out,
          "quality.area 1 simplex 2 3 4"));
}

TEST_CASE("check --except-sharp: what touches both sides is set aside, and counted") {
  const House house;
  const std::vector<std::string> required = {"--domain", house.domain,     "--require",
                                             "area:30",  "--except-sharp", "91deg"};
  const Run aside = house.judged(required);
  CHECK(aside.exit_code == 0);
  CHECK(has(aside.out, " area:30 except-sharp:91deg 4 set-aside\n"));
  CHECK(has(
      house.judged({"--domain", house.domain, "--require", "area:30", "--except-sharp", "90deg"})
          .out,
      "quality.area 1"));
  CHECK(has(house.judged({"--require", "area:30", "--except-sharp", "91deg"}).out, "4 set-aside"));
}

TEST_CASE("check --require: what cannot be meant is refused, with what to do") {
  const House house;
  const auto refused = [&](std::vector<std::string> more, const std::string& part) {
    const Run result = house.judged(std::move(more));
    CHECK(result.exit_code == 2);
    CHECK_MESSAGE(has(result.err, part), result.err);
  };
  refused({"--require", "min-angle"}, "unless it is quoted");
  refused({"--require", "min-angle:20"}, "20.7deg");
  refused({"--require", "max-angle:181deg"}, "at most 180deg");
  refused({"--require", "volume:2"}, "expected a measure of triangles");
  refused({"--require", "min-angle:61deg"}, "no min-angle is above 60deg");
  refused({"--require", "min-edge:3", "--require", "edge:2"}, "contradict each other");
  refused({"--except-sharp", "60deg"}, "beside --except-sharp");
  refused({"--require", "edge:2", "--except-sharp", "60"}, "20.7deg");
  refused({"--require", "edge:2", "--memory", "100M"}, "expected no --require beside --memory");
  refused({"--require", "edge:2", "--certificate", house.folder.path("c")}, "nothing is proved");
  const Run certified =
      run({"certify", house.mesh, "-o", house.folder.path("c"), "--require", "edge:2"});
  CHECK(certified.exit_code == 2);
  CHECK(has(certified.err, "nothing is proved of the shape of simplices"));
}

}  // namespace circumspect::cli
