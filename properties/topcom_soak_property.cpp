// The numbers of triangulations that TOPCOM counts (J. Rambau, TOPCOM: Triangulations of Point
// Configurations and Oriented Matroids, 2002; Debian: topcom). It works on chirotopes, so it shares
// neither code nor method. Book: Section 4.1, Section 4.4.
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>

#include <doctest/doctest.h>
#include <unistd.h>

#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/lifted_hull.hpp"
#include "reference/optimality/all_triangulations.hpp"
#include "reference/optimality/flip_graph.hpp"

namespace circumspect::properties {
namespace {

using generators::PointsCase;
using optimality::all_triangulations;
using optimality::flip_graph_from;
using optimality::VertexUse;

// Homogeneous coordinates, exact: [[0,1/2,1],[1,0,1]].
std::string in_topcom_format(const std::vector<Point>& points) {
  std::ostringstream text;
  text << "[";
  for (std::size_t i = 0; i < points.size(); ++i) {
    text << (i == 0 ? "[" : ",[");
    for (const Rational& coordinate : points[i]) text << coordinate << ",";
    text << "1]";
  }
  text << "]";
  return text.str();
}

// What one of TOPCOM's counting commands prints; nothing if it is not installed or fails.
std::optional<std::size_t> counted_by(const std::string& command,
                                      const std::vector<Point>& points) {
  char path[] = "/tmp/circumspect-topcom-XXXXXX";
  const int descriptor = mkstemp(path);
  if (descriptor < 0) return std::nullopt;
  FILE* file = fdopen(descriptor, "w");
  std::fputs((in_topcom_format(points) + "\n").c_str(), file);
  std::fclose(file);
  std::optional<std::size_t> count;
  FILE* output = popen(("timeout 60 " + command + " < " + path + " 2>/dev/null").c_str(), "r");
  unsigned long number = 0;
  if (output && std::fscanf(output, "%lu", &number) == 1) count = number;
  if (output && pclose(output) != 0) count.reset();
  std::remove(path);
  return count;
}

// Our two enumerations against TOPCOM's two: all triangulations, and those that flips connect to a
// regular one.
bool agrees_with_topcom(const std::vector<Point>& coordinates, VertexUse use) {
  const std::string fine = use == VertexUse::kAllPoints ? "fine" : "";
  const PointSet points(coordinates);
  const auto all = counted_by("topcom-points2nall" + fine + "triangs", coordinates);
  const auto connected = counted_by("topcom-points2n" + fine + "triangs", coordinates);
  if (!all || !connected) {
    FAIL_CHECK("TOPCOM does not answer: is it installed? (apt-get install topcom)");
    return false;
  }
  CHECK(all_triangulations(points, use).size() == *all);
  CHECK(flip_graph_from(points, delaunay::by_definition(points), use).triangulations.size() ==
        *connected);
  return all_triangulations(points, use).size() == *all;
}

struct NamedSet {
  std::string name;
  std::vector<Point> points;
};

std::vector<Point> grid(long columns, long rows, long layers) {
  std::vector<Point> points;
  for (long x = 0; x < columns; ++x) {
    for (long y = 0; y < rows; ++y) {
      for (long z = 0; z < layers; ++z) points.push_back({x, y, z});
    }
  }
  return points;
}

// The cyclic polytope C(n, d): points on the moment curve.
std::vector<Point> cyclic(long n, std::size_t d) {
  std::vector<Point> points;
  for (long t = 1; t <= n; ++t) {
    Point p{Rational(t)};
    while (p.size() < d) p.push_back(p.back() * t);
    points.push_back(p);
  }
  return points;
}

std::vector<NamedSet> named_sets() {
  std::vector<Point> octahedron;
  for (const long side : {-1, 1}) {
    octahedron.push_back({side, 0, 0});
    octahedron.push_back({0, side, 0});
    octahedron.push_back({0, 0, side});
  }
  std::vector<Point> cube_and_centre = grid(2, 2, 2);
  cube_and_centre.push_back({Rational(1, 2), Rational(1, 2), Rational(1, 2)});
  return {
      {"four points on a line", {{0, 1}, {1, 1}, {2, 1}, {7, 1}}},
      {"square", {{0, 0}, {1, 0}, {0, 1}, {1, 1}}},
      {"square and centre", {{0, 0}, {2, 0}, {0, 2}, {2, 2}, {1, 1}}},
      {"square in space", {{0, 0, 3}, {1, 0, 4}, {0, 1, 3}, {1, 1, 4}}},
      {"pentagon", cyclic(5, 2)},
      {"heptagon", cyclic(7, 2)},
      {"two concentric triangles", {{0, 0}, {4, 0}, {0, 4}, {1, 1}, {2, 1}, {1, 2}}},
      {"grid of 3 x 2", {{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}}},
      {"grid of 3 x 3", {{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}, {0, 2}, {1, 2}, {2, 2}}},
      {"cube", grid(2, 2, 2)},
      {"cube and centre", cube_and_centre},
      {"octahedron", octahedron},
      {"prism", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}},
      {"C(6,3)", cyclic(6, 3)},
      {"C(7,3)", cyclic(7, 3)},
      {"C(8,3)", cyclic(8, 3)},
      {"C(6,4)", cyclic(6, 4)},
      {"C(7,4)", cyclic(7, 4)},
      {"C(8,5)", cyclic(8, 5)},
  };
}

TEST_CASE("TOPCOM counts as many triangulations of well-known sets") {
  for (const NamedSet& set : named_sets()) {
    CAPTURE(set.name);
    for (const VertexUse use : {VertexUse::kAllPoints, VertexUse::kSomePoints}) {
      CHECK(agrees_with_topcom(set.points, use));
    }
  }
}

TEST_CASE("TOPCOM counts as many triangulations of random sets") {
  for (const std::size_t d : {2u, 3u, 4u}) {
    CAPTURE(d);
    CHECK(holds("numbers of triangulations", 10, [d] {
      const PointsCase set = *generators::unweighted(
          rc::gen::oneOf(generators::sets_of(generators::integer_points, d, d + 4),
                         generators::sets_of(generators::grid_points, d, d + 4),
                         generators::sets_of(generators::cube_points, d, d + 4),
                         generators::sets_of(generators::rational_points, d, d + 4)));
      // Of an affinely independent set TOPCOM 1.1.0 explores the flip graph without end.
      const int dimension = PointSet(set.points).dimension();
      RC_PRE(static_cast<int>(set.points.size()) > dimension + 1);
      RC_ASSERT(agrees_with_topcom(set.points, VertexUse::kAllPoints));
      RC_ASSERT(agrees_with_topcom(set.points, VertexUse::kSomePoints));
    }));
  }
}

}  // namespace
}  // namespace circumspect::properties
