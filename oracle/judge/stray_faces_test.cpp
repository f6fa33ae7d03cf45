// What is listed beside simplices: the witness, equal points, and who asks for it.
#include "oracle/judge/stray_faces.hpp"

#include <doctest/doctest.h>

#include "kernel/exact/number_text.hpp"
#include "oracle/judge/judge.hpp"

namespace circumspect::check {
namespace {

// Two triangles, of which the second has points of its own where they meet, and a flat one.
Mesh two_triangles(std::vector<Simplex> faces) {
  Mesh mesh;
  mesh.coordinates = numbers_of({{0, 0}, {4, 0}, {0, 4}, {4, 0}, {0, 4}, {4, 4}, {2, 0}}, 2);
  mesh.simplices = IndexLists(std::vector<Simplex>{{0, 1, 2}, {3, 5, 4}, {0, 6, 1}});
  mesh.faces = std::move(faces);
  mesh.first_index = 1;
  return mesh;
}

Verdict judged_with_faces(const Mesh& mesh, By by, bool asks_for_faces = true,
                          std::size_t max_violations = 0) {
  return judge(Claim::kComplex, mesh, nullptr,
               {.by = by, .complex = {.faces = asks_for_faces}, .max_violations = max_violations})
      .value();
}

TEST_CASE("a listed edge is a face if equal points count as one; flat simplices have faces too") {
  const Mesh mesh = two_triangles({{2, 3}, {5, 1}, {0, 6}, {1, 0}});
  for (const By by : {By::kLemma, By::kDefinition}) {
    const Verdict verdict = judged_with_faces(mesh, by);
    CHECK(!verdict.tallies().contains(Rule::kStrayFace));
    CHECK(verdict.tallies().contains(Rule::kPointsEqual));
    CHECK(verdict.complex->listed_faces == 4);
  }
}

TEST_CASE("the witness of a stray face is the face, and its index among those like it") {
  const Mesh mesh = two_triangles({{0, 5}, {0, 1, 2}, {0, 1}, {6, 5}, {0, 3, 5}, {9, 1}});
  for (const By by : {By::kLemma, By::kDefinition}) {
    const Verdict verdict = judged_with_faces(mesh, by);
    CHECK(verdict.tallies().at(Rule::kStrayFace).count == 4);
    // However many witnesses are kept.
    CHECK(judged_with_faces(mesh, by, true, 1).tallies().at(Rule::kStrayFace).count == 4);
    std::vector<std::string> found;
    for (const auto& [rule, witness] : verdict.violations()) {
      if (rule != Rule::kStrayFace) continue;
      REQUIRE(witness.values.size() == 1);
      std::string text = witness.values[0].name + " " + to_string(witness.values[0].value) + ":";
      for (const Vertex v : *witness.face) text += " " + std::to_string(v);
      found.push_back(text);
    }
    CHECK(found == std::vector<std::string>{"index among the listed edges 1: 0 5",
                                            "index among the listed edges 3: 6 5",
                                            "index among the listed triangles 2: 0 3 5",
                                            "index among the listed edges 4: 9 1"});
  }
}

TEST_CASE("a face that names no point, or one twice, or only one, is stray whoever has it") {
  Mesh mesh = two_triangles({{7, 1}, {-1, 0}, {2, 2}, {0}, {2, 5}});
  mesh.simplices = IndexLists(std::vector<Simplex>{{0, 1, 7}, {-1, 0, 2}, {2, 2, 5}, {0}});
  for (const By by : {By::kLemma, By::kDefinition}) {
    CHECK(judged_with_faces(mesh, by).tallies().at(Rule::kStrayFace).count == 4);
  }
}

TEST_CASE("what is listed beside simplices counts only if it is asked for") {
  const Verdict verdict = judged_with_faces(two_triangles({{0, 5}}), By::kLemma, false);
  CHECK(!verdict.tallies().contains(Rule::kStrayFace));
  CHECK(verdict.complex->listed_faces == 0);
}

}  // namespace
}  // namespace circumspect::check
