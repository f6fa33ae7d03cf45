// Sentences of pictures: fields filled in, parts left out, and what stands where a witness lacks a
// field.
#include "oracle/picture/caption.hpp"

#include <set>

#include <doctest/doctest.h>

namespace circumspect::picture {
namespace {

// Counted from 1.
Mesh square() { return in_rows({PointSet({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), {}, {}, 1}); }
Mesh corner() {
  return in_rows({PointSet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}), {}, {}, 1});
}

TEST_CASE("caption: by the user's indices, with circles in the plane and balls in space") {
  const Witness in_plane{.simplices = {{0, 1, 2}}, .face = Simplex{0, 2}, .vertices = {3}};
  CHECK(caption({Rule::kFacetNotLocal, in_plane}, square()) ==
        "Vertex 4 lies inside the circle through the corners of triangle 1 2 3. It is the corner "
        "on the other side of edge 1 3. A Delaunay mesh has no vertex inside such a circle.");
  const Witness in_space{.simplices = {{0, 1, 2, 3}}, .vertices = {4}};
  CHECK(caption({Rule::kVertexInBall, in_space}, corner()) ==
        "Vertex 5 lies inside the ball through the corners of tetrahedron 1 2 3 4. A Delaunay mesh "
        "has no vertex inside such a ball.");
}

TEST_CASE("caption: what is in brackets is left out where the witness lacks it") {
  CHECK(caption({Rule::kUncovered, {.face = Simplex{0, 1}}}, square()) ==
        "Part of the domain is covered by nothing: it begins at edge 1 2.");
  CHECK(caption({Rule::kUncovered, {}}, square()) == "Part of the domain is covered by nothing.");
  CHECK(caption({Rule::kWrongDimension,
                 {.simplices = {{0, 1}}, .values = {{"vertices expected", Rational(3)}}}},
                square()) ==
        "The simplex 1 2 has 2 vertices, and each simplex of these points is to have 3.");
  CHECK(caption({Rule::kDomainVertexMissing, {.nearest = NearestVertex{1, Rational(1, 4)}}},
                square()) ==
        "The domain has a vertex where the mesh has none. The nearest vertex of the mesh, 2, is "
        "about 0.5 away.");
}

TEST_CASE("caption: two simplices, how many there are, and the empty face") {
  CHECK(caption({Rule::kOverlap, {.simplices = {{0, 1, 2}, {0, 1, 3}}}}, square()) ==
        "The triangle 1 2 3 and the triangle 1 2 4 meet in more than a common face.");
  CHECK(
      caption({Rule::kHullNotClosed, {.simplices = {{0}, {1}, {2}}, .face = Simplex{}}},
              square()) ==
      "The boundary is torn or pinched: 3 of its facets meet in the empty face, where two are to.");
}

TEST_CASE("caption: the meaning stands where a field is lacking") {
  CHECK(caption({Rule::kRepeatedVertex, {}}, square()) == "a simplex names the same vertex twice.");
}

// A witness with everything, so that a misspelt field or an open bracket of a row is seen.
TEST_CASE("caption: the sentence of every rule can be filled in") {
  const Witness all{.simplices = {{0, 1, 2, 3}, {1, 2, 3, 4}},
                    .face = Simplex{0, 1, 2},
                    .vertices = {4},
                    .values = {{"vertices expected", Rational(4)}},
                    .nearest = NearestVertex{1, Rational(1)},
                    .measured = Measured{Measure::kEdge, Rational(4), "edge <= 1"}};
  for (const RuleEntry& rule : rules()) {
    CAPTURE(rule.identifier);
    const std::string text = caption({rule.rule, all}, corner());
    CHECK(text != std::string(rule.meaning) + ".");
    CHECK(text.find_first_of("{}[]") == std::string::npos);
    CHECK(text.back() == '.');
  }
}

TEST_CASE("marks: each has a name of its own") {
  std::set<std::string_view> names;
  for (int mark = 0; mark <= static_cast<int>(Mark::kSmallestBall); ++mark) {
    CHECK(names.insert(name(static_cast<Mark>(mark))).second);
  }
  CHECK(!names.contains(""));
}

}  // namespace
}  // namespace circumspect::picture
