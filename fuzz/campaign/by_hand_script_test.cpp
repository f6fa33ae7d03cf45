// What is wrong, as a script that anybody can run.
#include "fuzz/campaign/by_hand_script.hpp"

#include <cstdio>
#include <fstream>
#include <string>

#include <doctest/doctest.h>

#include "inputs/scratch_folder_test.hpp"

namespace circumspect::campaign {
namespace {

using report::Json;

Json verdict_of(Json witness) {
  witness["rule"] = "some.rule";
  witness["meaning"] = "something is wrong";
  return {{"violations", Json::array({witness})}};
}

// What Python prints.
std::string printed(const std::string& script) {
  const formats::ScratchFolder folder;
  const std::string path = folder.write("by-hand.py", script);
  const std::string line = "python3 " + path + " > " + folder.path("said") + " 2>&1";
  CHECK(std::system(line.c_str()) == 0);
  std::ifstream file(folder.path("said"));
  return {std::istreambuf_iterator<char>(file), {}};
}

const Json kFourCorners = {
    {"0", {"0", "0"}}, {"1", {"1", "0"}}, {"2", {"0", "1"}}, {"3", {"3/4", "3/4"}}};

}  // namespace

TEST_CASE("by hand: a vertex in a ball") {
  const std::string script = by_hand_script(verdict_of({{"simplices", {{0, 1, 2}}},
                                                        {"vertices", {3}},
                                                        {"ball", {{"centre", {"1/2", "1/2"}}}},
                                                        {"coordinates", kFourCorners}}));
  CHECK(script.find("# some.rule: something is wrong.\n") != std::string::npos);
  const std::string said = printed(script);
  CHECK(said.find("['1/2', '1/2', '1/2']") != std::string::npos);
  CHECK(said.find("of vertex 3, which is nearer: 1/8\n") != std::string::npos);
}

TEST_CASE("by hand: a point in two simplices, a flat one, and a facet with points on both sides") {
  const std::string overlap =
      printed(by_hand_script(verdict_of({{"simplices", {{0, 1, 2}, {0, 1, 3}}},
                                         {"vertices", Json::array()},
                                         {"point", {"1/2", "1/4"}},
                                         {"coordinates", kFourCorners}})));
  CHECK(overlap == "[0, 1, 2] 1 ['1/4', '1/2', '1/4']\n[0, 1, 3] 3/4 ['5/16', '3/16', '1/4']\n");
  const std::string volume = printed(by_hand_script(verdict_of(
      {{"simplices", {{0, 1, 3}}}, {"vertices", Json::array()}, {"coordinates", kFourCorners}})));
  CHECK(volume == "the volume of the simplex, times 2!: 3/4\n");
  const std::string sides = printed(by_hand_script(verdict_of({{"simplices", {{0, 1, 2}}},
                                                               {"face", {1, 2}},
                                                               {"vertices", {3}},
                                                               {"coordinates", kFourCorners}})));
  CHECK(sides.find("different sides of the facet: 1 -1/2\n") != std::string::npos);
}

TEST_CASE("by hand: no script where numbers do not show it") {
  CHECK(by_hand_script({}).empty());
  CHECK(by_hand_script({{"violations", Json::array()}}).empty());
  CHECK(by_hand_script(verdict_of({{"vertices", {4}}, {"coordinates", kFourCorners}})).empty());
  CHECK(by_hand_script(verdict_of({{"simplices", {{0, 1}}},
                                   {"vertices", Json::array()},
                                   {"coordinates", kFourCorners}}))
            .empty());
}

}  // namespace circumspect::campaign
