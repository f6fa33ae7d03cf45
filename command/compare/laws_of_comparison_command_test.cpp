// Laws of compare: A and B differ as B and A do, and the file of what differs says whose it is.
#include <set>

#include <doctest/doctest.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {
namespace {

using nlohmann::json;

struct TwoMeshes {
  std::string a, b;
  std::vector<std::string> options = {};
};

const std::string kMeditSquare =
    "MeshVersionFormatted 2\nDimension 2\nVertices 6\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n5 5 0\n6 5 0\n"
    "Triangles 2\n1 2 3 0\n2 4 3 0\n";

std::string triangle_of(const std::string& points, const std::string& weights) {
  return R"({"circumspect":1,"dimension":2,"points":)" + points + R"(,"weights":)" + weights +
         R"(,"simplices":[[0,1,2]]})";
}

std::string surface(const std::string& last) {
  return "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n" + last + "\n3 0 1 2\n3 1 3 2\n";
}

// Pairs that differ in every way in which meshes may.
std::vector<TwoMeshes> pairs_in(const ScratchFolder& folder) {
  const auto triangle = [&](const std::string& name, const std::string& points,
                            const std::string& weights) {
    return folder.write(name, triangle_of(points, weights));
  };
  const std::string three = "[[0,0],[1,0],[0,1]]";
  return {
      {folder.write("rising.mesh", kMeditSquare + "End\n"),
       folder.write(
           "falling.mesh",
           std::string(kMeditSquare).replace(kMeditSquare.find("2 4 3"), 5, "1 4 3") + "End\n")},
      {folder.write("none.mesh", kMeditSquare + "End\n"),
       folder.write("loose.mesh", kMeditSquare + "Edges 1\n5 6 7\nEnd\n")},
      {folder.write("flat.off", surface("1 1 0")), folder.write("bent.off", surface("1 1 1"))},
      {folder.write("low.off", surface("1 1 0")),
       folder.write("plane.mesh", kMeditSquare + "End\n")},
      {triangle("light.json", three, "[5,5,5]"), triangle("heavy.json", three, "[6,5,5]")},
      {triangle("once.json", three, "[1,1,1]"),
       triangle("twice.json", "[[0,0],[1,0],[0,1],[0,0]]", "[1,1,1,1]"),
       {"--duplicates", "merge"}},
  };
}

json compared(const std::string& a, const std::string& b, const std::vector<std::string>& options,
              int& exit_code) {
  std::vector<std::string> words = {"compare", a, b, "--format", "json"};
  words.insert(words.end(), options.begin(), options.end());
  const Run answer = run(words);
  exit_code = answer.exit_code;
  return document(answer)["results"][0];
}

}  // namespace

TEST_CASE("compare: A and B differ as B and A do") {
  const ScratchFolder folder;
  for (const TwoMeshes& pair : pairs_in(folder)) {
    CAPTURE(pair.a);
    int exit_code = 0, swapped_code = 0;
    const json told = compared(pair.a, pair.b, pair.options, exit_code);
    const json swapped = compared(pair.b, pair.a, pair.options, swapped_code);
    CHECK(exit_code == (told["same"] == true ? 0 : 1));
    CHECK(swapped_code == exit_code);
    CHECK(told["same"] == swapped["same"]);
    CHECK(told["weighted"] == swapped["weighted"]);
    CHECK(told["only_in_a"] == swapped["only_in_b"]);
    CHECK(told["only_in_b"] == swapped["only_in_a"]);
    CHECK(std::set<json>(told["notes"].begin(), told["notes"].end()) ==
          std::set<json>(swapped["notes"].begin(), swapped["notes"].end()));
    int same_code = 1;
    CHECK(compared(pair.b, pair.b, pair.options, same_code)["same"] == true);
    CHECK(same_code == 0);
  }
}

TEST_CASE("compare: what only A has is labelled 1 in the file of what differs, and B's 2") {
  const ScratchFolder folder;
  const TwoMeshes pair = pairs_in(folder).front();
  int exit_code = 0;
  const std::string out = folder.path("out.mesh");
  const json told = compared(pair.a, pair.b, {"-o", out}, exit_code);
  std::map<std::string, std::size_t> labelled;
  std::istringstream file(contents(out));
  for (std::string word; file >> word;) {
    if (word != "Triangles") continue;
    std::size_t count = 0;
    file >> count;
    for (std::string a, b, c, label; count > 0 && file >> a >> b >> c >> label; --count) {
      ++labelled[label];
    }
  }
  CHECK(labelled ==
        std::map<std::string, std::size_t>{{"1", told["only_in_a"]["simplices"].size()},
                                           {"2", told["only_in_b"]["simplices"].size()}});
}

TEST_CASE("compare: of all that is read, one file alone may be standard input") {
  const ScratchFolder folder;
  folder.write("x.node", "3 2\n1 0 0\n2 1 0\n3 0 1\n");
  const std::string mesh = folder.write("x.ele", "1 3\n1 1 2 3\n");
  const std::string points = folder.path("x.node");
  for (unsigned streams = 0; streams < 16; ++streams) {
    const auto word = [&](unsigned place, const std::string& otherwise) {
      return (streams >> place & 1U) != 0 ? std::string("-") : otherwise;
    };
    const int count = __builtin_popcount(streams);
    if (count < 2) continue;
    const Run refused = run({"compare", word(0, mesh), word(1, mesh), "--points-a", word(2, points),
                             "--points-b", word(3, points)});
    CHECK(refused.exit_code == 2);
    CHECK(has(refused.err, "on standard input, found "));
  }
}

}  // namespace circumspect::cli
