// What the rings of faces leave empty.
#include "oracle/domain/uncovered.hpp"

#include <algorithm>
#include <string>

#include <doctest/doctest.h>

#include "kernel/piecewise_linear/validity.hpp"

namespace circumspect {
namespace {

using Ring = std::vector<Vertex>;

// Squares of half sides 4, 3, 2 and 1 around (0, 0), and a square beside the first; the rings of
// the faces are named by these.
struct Squares {
  PiecewiseLinearInput input;
  std::vector<Ring> rings;

  Squares() {
    for (const long half : {4, 3, 2, 1}) {
      const auto first = static_cast<Vertex>(input.points.size());
      for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        input.points.push_back({half * x, half * y});
      }
      rings.push_back({first, first + 1, first + 2, first + 3});
    }
    input.points.push_back({8, -4});
    input.points.push_back({8, 4});
    rings.push_back({1, 16, 17, 2});
    for (const Ring& ring : rings) {
      for (std::size_t i = 0; i < 4; ++i) input.segments.push_back({ring[i], ring[(i + 1) % 4]});
    }
  }

  // For each ring that is no hole, the face, the ring, and the hole that it lies in.
  std::string no_holes(const std::vector<std::vector<std::size_t>>& faces) const {
    const auto complex = validated(input);
    REQUIRE(complex);
    std::string text;
    for (const auto& [face, ring, in_hole] :
         rings_that_are_no_holes(of_squares(faces), Regions(*complex))) {
      text += std::to_string(face) + std::to_string(ring) +
              (in_hole ? std::to_string(*in_hole) : std::string("-")) + " ";
    }
    return text;
  }

  // Whether the regions from the inmost outwards, and then that beside them, are covered.
  std::string covered(const std::vector<std::vector<std::size_t>>& faces) const {
    auto complex = validated(input);
    REQUIRE(complex);
    const Regions regions(*complex);
    complex->hole_seeds = points_without_rings(of_squares(faces), regions);
    const Regions filled(*complex);
    std::string text;
    for (const Rational& x :
         {Rational(0), Rational(3, 2), Rational(5, 2), Rational(7, 2), Rational(6)}) {
      text += filled.locate({x, 0}) == Where::kInside ? '+' : '-';
    }
    return text;
  }

  std::vector<PolygonLines> of_squares(const std::vector<std::vector<std::size_t>>& faces) const {
    std::vector<PolygonLines> of_rings;
    for (const auto& face : faces) {
      PolygonLines& lines = of_rings.emplace_back();
      for (const std::size_t ring : face) lines.lines.push_back(rings[ring]);
    }
    return of_rings;
  }
};

}  // namespace

TEST_CASE("rings: a face covers what an odd number of its rings enclose") {
  const Squares squares;
  CHECK(squares.covered({{0}}) == "++++-");
  CHECK(squares.covered({{0, 1}}) == "---+-");
  CHECK(squares.covered({{0, 1, 2, 3}}) == "-+-+-");
  CHECK(squares.covered({{0, 4}}) == "+++++");
}

TEST_CASE("rings: faces do not empty one another") {
  const Squares squares;
  CHECK(squares.covered({{0, 1}, {1, 2}}) == "--++-");
  CHECK(squares.covered({{0}, {1}}) == "++++-");
  CHECK(squares.covered({{0, 1}, {3}, {4}}) == "+--++");
  // A ring that is there twice encloses nothing.
  CHECK(squares.covered({{0, 0, 1}}) == "+++--");
  CHECK(squares.covered({}) == "-----");
}

TEST_CASE("faces: one line covers what it encloses, and nothing if it leads back along itself") {
  const Squares squares;
  const auto complex = validated(squares.input);
  REQUIRE(complex);
  const Regions regions(*complex);
  const auto bare = [&](const Ring& line) {
    return points_without_face({{{line}, {}}}, regions, complex->points).size();
  };
  CHECK(regions.size() == 6);
  CHECK(bare({0, 1, 2, 1}) == 5);
  CHECK(bare({1, 2, 1, 0}) == 5);
  for (const std::size_t ring : {0, 1, 2, 3}) {
    Ring line = squares.rings[ring];
    CHECK(bare(line) == 1 + ring);
    std::reverse(line.begin(), line.end());
    CHECK(bare(line) == 1 + ring);
  }
}

TEST_CASE("rings: those that are no holes of the first are found") {
  const Squares squares;
  CHECK(squares.no_holes({{0, 1}, {2}, {4}}).empty());
  CHECK(squares.no_holes({{0, 1, 2}}) == "021 ");
  CHECK(squares.no_holes({{0, 2, 1, 3}}) == "012 031 ");  // in either order
  CHECK(squares.no_holes({{4}, {0, 4}}) == "11- ");
  CHECK(squares.no_holes({{1, 0}}) == "01- ");  // the first is in the second
  CHECK(squares.no_holes({{0, 1, 1}}) == "021 ");
}

}  // namespace circumspect
