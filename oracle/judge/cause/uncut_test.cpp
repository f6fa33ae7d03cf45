// Vertices that were rounded away from a face that only one side is cut at are named, with how far
// they are off; those that are farther away are not.
#include "oracle/judge/cause/uncut.hpp"

#include <algorithm>

#include <doctest/doctest.h>

#include "oracle/judge/cause/causes.hpp"
#include "oracle/judge/judge.hpp"
#include "oracle/model/listed_mesh_test.hpp"

namespace circumspect::check {
namespace {

std::vector<Cause> causes_of_complex(const Mesh& mesh) {
  const auto judged = [](const Mesh& one) -> std::optional<Verdict> {
    auto verdict = judge(Claim::kComplex, one, nullptr, {});
    if (!verdict) return std::nullopt;
    return std::move(*verdict);
  };
  const auto verdict = judged(mesh);
  REQUIRE(verdict.has_value());
  return causes(*verdict, mesh, judged).found;
}

const Rational kOff(1, 1L << 40);

std::vector<Uncut> found_in(const Mesh& mesh) { return uncut_faces(mesh, bare_facets(mesh)); }

// The triangle above the edge 0 1 is not cut; those below meet in two vertices near it.
Mesh plane(const Rational& off) {
  return listed_mesh({{0, 0}, {3, 0}, {1, off}, {2, off / 2}, {1, -2}, {1, 3}},
                     {{0, 2, 4}, {2, 3, 4}, {3, 1, 4}, {0, 1, 5}});
}

}  // namespace

TEST_CASE("causes: vertices in the plane that were rounded away from an edge") {
  const Mesh mesh = plane(kOff);
  const std::vector<Uncut> found = found_in(mesh);
  REQUIRE(found.size() == 2);
  // Both are beside the edge that is listed, though the second is found beside what the first cuts.
  CHECK(found[0].face == Simplex{0, 1});
  CHECK(found[1].face == Simplex{0, 1});
  CHECK(found[0].squared_distance == kOff * kOff);
  CHECK(found[1].squared_distance == kOff * kOff / 4);
  const std::vector<Cause> causes = causes_of_complex(mesh);
  REQUIRE(causes.size() == 1);
  CHECK(causes[0].name == "hanging-vertices-rounded");
  CHECK(causes[0].explains == 3);
  CHECK(causes[0].of == 3);
  CHECK(causes[0].words ==
        "2 vertices lie beside faces of simplices that are not cut there, at most ~ "
        "9.094947017729282e-13 from them, as if rounded: once cut, both sides have the same "
        "facets");
  CHECK(found_in(plane(Rational(1, 10))).empty());
  // Cut at another vertex, the facets do not match.
  CHECK(found_in(listed_mesh({{0, 0}, {3, 0}, {1, kOff}, {2, -1}, {1, -2}, {1, 3}},
                             {{0, 2, 4}, {2, 3, 4}, {3, 1, 4}, {0, 1, 5}}))
            .empty());
}

TEST_CASE("causes: a vertex in space that was rounded away from an edge, or from a triangle") {
  std::vector<Point> points = {{0, 0, 0},  {0, 0, 2},  {kOff, -kOff, 1}, {2, 0, 1}, {1, 2, 1},
                               {-1, 2, 1}, {-2, 0, 1}, {-1, -2, 1},      {1, -2, 1}};
  std::vector<Simplex> ring;
  for (Vertex i = 0; i < 6; ++i) {
    const Vertex p = 3 + i, q = 3 + (i + 1) % 6;
    if (i < 3) {
      ring.push_back({0, 2, p, q});
      ring.push_back({2, 1, p, q});
    } else {
      ring.push_back({0, 1, p, q});
    }
  }
  const std::vector<Cause> at_edge = causes_of_complex(listed_mesh(points, ring));
  REQUIRE(!at_edge.empty());
  CHECK(at_edge[0].name == "hanging-vertices-rounded");
  CHECK(at_edge[0].words.starts_with("1 vertex lies beside faces"));
  CHECK(at_edge[0].explains == at_edge[0].of);
  const Mesh on_triangle =
      listed_mesh({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, kOff}, {1, 1, -2}, {1, 1, 3}},
                  {{0, 1, 3, 4}, {1, 2, 3, 4}, {2, 0, 3, 4}, {0, 1, 2, 5}});
  const std::vector<Uncut> found = found_in(on_triangle);
  REQUIRE(found.size() == 1);
  CHECK(found[0].face == Simplex{0, 1, 2});
  CHECK(found[0].squared_distance == kOff * kOff);
  CHECK(causes_of_complex(on_triangle)[0].name == "hanging-vertices-rounded");
}

TEST_CASE("causes: beside a triangle is what is above the inside of it, however it is listed") {
  for (const auto& [x, y] : {std::pair{1, 1}, {1, -1}, {-1, 1}, {3, 3}, {1, 0}, {0, 1}, {2, 2}}) {
    Simplex corners = {0, 1, 2};
    do {
      std::vector<Point> points = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
      points = {points[static_cast<std::size_t>(corners[0])],
                points[static_cast<std::size_t>(corners[1])],
                points[static_cast<std::size_t>(corners[2])],
                {x, y, kOff},
                {1, 1, -2},
                {1, 1, 3}};
      const Mesh mesh =
          listed_mesh(points, {{0, 1, 3, 4}, {1, 2, 3, 4}, {2, 0, 3, 4}, {0, 1, 2, 5}});
      const std::vector<Uncut> found = found_in(mesh);
      const bool is_beside = std::any_of(found.begin(), found.end(), [](const Uncut& one) {
        return one.vertex == 3 && one.face == Simplex{0, 1, 2};
      });
      CHECK(is_beside == (x > 0 && y > 0 && x + y < 4));
    } while (std::next_permutation(corners.begin(), corners.end()));
  }
}

}  // namespace circumspect::check
