// A mesh whose facets all match and whose boundary is sound: only what is just outside of the
// boundary tells that its simplices overlap.
#include <doctest/doctest.h>

#include "oracle/judge/judge.hpp"

namespace circumspect::check {
namespace {

// A tetrahedron of edge length 8, and one of edge length 1 whose first corner is moved along the
// diagonal from the corner of the large one.
Mesh two_tetrahedra(double moved) {
  Rows<double> points(8, 3);
  const double corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (std::size_t i = 0; i < 24; ++i) {
    const double x = corners[i / 3 % 4][i % 3];
    points.values()[i] = i < 12 ? 8 * x : x + moved;
  }
  Mesh mesh;
  mesh.coordinates = std::move(points);
  mesh.simplices = IndexLists(std::vector<Simplex>{{0, 1, 2, 3}, {4, 5, 6, 7}});
  return mesh;
}

TEST_CASE("a tetrahedron inside another overlaps it, however near it is to its facets") {
  for (const By by : {By::kLemma, By::kDefinition}) {
    for (const double moved : {1.0, 0x1p-40, 7.0 / 3 - 0x1p-50}) {
      const Verdict verdict =
          judge(Claim::kComplex, two_tetrahedra(moved), nullptr, {.by = by}).value();
      CHECK(verdict.tallies().contains(Rule::kOverlap));
    }
    for (const double moved : {-0x1p+4, 8.0 / 3 + 0x1p-50, 9.0}) {
      CHECK(judge(Claim::kComplex, two_tetrahedra(moved), nullptr, {.by = by}).value().holds());
    }
  }
}

}  // namespace
}  // namespace circumspect::check
