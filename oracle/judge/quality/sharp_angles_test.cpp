// Sharp angles: which simplices touch both of their sides, of a domain, of one that was moved, and
// of the boundary of a mesh.
#include "oracle/judge/quality/sharp_angles.hpp"

#include <doctest/doctest.h>

#include "oracle/judge/quality/judge_quality.hpp"
#include "oracle/model/listed_mesh_test.hpp"

namespace circumspect::check {
namespace {

std::vector<bool> touched(const Mesh& mesh, const Domain* domain, const char* degrees,
                          const Rational& squared_reach = 0) {
  return quality::SharpAngles(mesh, domain, read_degrees(degrees).value(), squared_reach).touched();
}

// A fan of four triangles in a corner of 45 degrees, from 0 to 5, cut at half of its length.
const std::vector<Point> kCorner = {{0, 0}, {4, 0}, {8, 0}, {8, 8}, {4, 4}, {6, 3}, {8, 4}};
const std::vector<Simplex> kInCorner = {{0, 1, 4}, {1, 5, 4}, {1, 2, 5},
                                        {4, 5, 3}, {2, 6, 5}, {5, 6, 3}};

Domain corner_domain() {
  PiecewiseLinearInput input;
  input.points = {{0, 0}, {8, 0}, {8, 8}};
  input.segments = {{0, 1}, {1, 2}, {0, 2}};
  return {assemble(input)};
}

TEST_CASE("simplices with a vertex on each of two segments that meet at a sharp angle") {
  const Mesh mesh = listed_mesh(kCorner, kInCorner);
  const Domain domain = corner_domain();
  // Angles of 45, 90 and 45 degrees: between 0-1 and 0-2, and between 0-2 and 1-2.
  CHECK(touched(mesh, &domain, "45deg") == std::vector<bool>(6, false));
  CHECK(touched(mesh, &domain, "46deg") == std::vector<bool>{true, true, false, true, false, true});
  CHECK(touched(mesh, &domain, "91deg") == std::vector<bool>{true, true, true, true, true, true});
  Verdict verdict(Claim::kComplex, 0);
  Options options;
  options.quality = {{read_requirement("min-edge:3.7").value()}, Rational(46)};
  judge_quality(mesh, &domain, 0, options, verdict);
  CHECK(verdict.quality->set_aside == 4);
  CHECK(verdict.tallies().at(Rule::kQualityMinEdge).count == 2);
}

TEST_CASE("a vertex that was rounded off a segment is on it within the distance") {
  std::vector<Point> rounded = kCorner;
  rounded[4] = {4, Rational(401, 100)};
  const Mesh mesh = listed_mesh(rounded, kInCorner);
  const Domain domain = corner_domain();
  CHECK(touched(mesh, &domain, "46deg") ==
        std::vector<bool>{true, false, false, true, false, true});
  CHECK(touched(mesh, &domain, "46deg", Rational(1, 20000)) ==  // the distance is 0.01/√2
        std::vector<bool>{true, true, false, true, false, true});
  CHECK(touched(mesh, &domain, "46deg", Rational(1, 20001)) ==
        std::vector<bool>{true, false, false, true, false, true});
}

TEST_CASE("without a domain the boundary of the mesh has the sharp angles") {
  const Mesh mesh = listed_mesh(kCorner, kInCorner);
  // Boundary edges 0-1 and 0-4 meet at 45 degrees, and 3-4 and 3-6.
  CHECK(touched(mesh, nullptr, "46deg") == std::vector<bool>{true, true, false, true, false, true});
  CHECK(touched(mesh, nullptr, "45deg") == std::vector<bool>(6, false));
  // A flat simplex is set apart, and closes nothing.
  std::vector<Simplex> with_flat = kInCorner;
  with_flat.push_back({0, 1, 2});
  std::vector<bool> same = touched(listed_mesh(kCorner, with_flat), nullptr, "46deg");
  same.pop_back();
  CHECK(same == std::vector<bool>{true, true, false, true, false, true});
  const Mesh corner = listed_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {9, 9, 9}},
                                  {{0, 1, 2, 3}, {1, 2, 3, 4}});
  CHECK(touched(corner, nullptr, "10deg") == std::vector<bool>{false, false});
  CHECK(touched(corner, nullptr, "91deg") == std::vector<bool>{true, true});
}

TEST_CASE("polygons meet at a sharp angle along their common edge") {
  PiecewiseLinearInput input;  // a wedge of 45 degrees along the edge 0 1
  input.points = {{0, 0, 0}, {0, 4, 0}, {4, 0, 0}, {4, 4, 0}, {4, 0, 4}, {4, 4, 4}};
  for (const std::vector<Vertex>& outline : std::vector<std::vector<Vertex>>{
           {0, 1, 3, 2}, {0, 1, 5, 4}, {2, 3, 5, 4}, {0, 2, 4}, {1, 3, 5}}) {
    input.polygons.push_back({{outline}, {}});
  }
  const Domain domain{assemble(input)};
  std::vector<Point> points = input.points;
  points.push_back({3, 2, 1});
  const Mesh mesh =
      listed_mesh(points, {{0, 1, 2, 6}, {0, 1, 4, 6}, {2, 4, 5, 6}, {2, 3, 5, 6}, {1, 3, 5, 6}});
  // Corners of 45 degrees of the two triangles have segments for sides.
  CHECK(touched(mesh, &domain, "44deg") == std::vector<bool>(5, false));
  const std::vector<bool> at_wedge = touched(mesh, &domain, "46deg");
  CHECK(at_wedge[0]);
  CHECK(at_wedge[1]);
  CHECK(at_wedge[3]);  // 2 is on the lower polygon, and 5 on the upper
}

}  // namespace
}  // namespace circumspect::check
