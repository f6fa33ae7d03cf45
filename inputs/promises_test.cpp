// Each family is exactly what the table says.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include <doctest/doctest.h>

#include "inputs/families.hpp"
#include "inputs/in_doubles.hpp"
#include "kernel/exact/point.hpp"
#include "kernel/predicates/in_ball.hpp"

namespace circumspect::generators {
namespace {

constexpr std::uint64_t kSeeds = 12;

PointsCase drawn_from(const char* name, std::size_t dimension, std::uint64_t seed) {
  const Family* family = find_family(name);
  REQUIRE(family != nullptr);
  return drawn(*family, dimension, {12, true}, seed);
}

int affine_dimension(const PointsCase& set) { return affine_hull(set.points).dimension; }

// Are all points on the circumsphere of the first affine basis?
bool is_cospherical(const PointsCase& set) {
  const Configuration points(set.points, set.weights);
  std::vector<Vertex> basis(points.hull().basis.begin(), points.hull().basis.end());
  for (std::size_t v = 0; v < points.size(); ++v) {
    const auto vertex = static_cast<Vertex>(v);
    if (std::find(basis.begin(), basis.end(), vertex) != basis.end()) continue;
    if (in_ball(points, basis, vertex) != 0) return false;
  }
  return true;
}

bool is_of_doubles(const PointsCase& set) { return in_doubles(set, true).points == set.points; }

bool is_of_integers(const PointsCase& set) {
  return std::all_of(set.points.begin(), set.points.end(), [](const Point& point) {
    return std::all_of(point.begin(), point.end(),
                       [](const Rational& x) { return x.get_den() == 1; });
  });
}

PointsCase without_centre(PointsCase set) {
  std::erase_if(set.points, [](const Point& x) { return sign(squared_length(x)) == 0; });
  return set;
}

TEST_CASE("families on spheres are cospherical, exactly") {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    for (const std::size_t dimension : {2u, 3u, 4u}) {
      CAPTURE(seed);
      CAPTURE(dimension);
      for (const char* name : {"sphere", "symmetric-sphere", "pythagorean-sphere", "sphere+scaled",
                               "parallel-lifted"}) {
        CAPTURE(name);
        PointsCase set = drawn_from(name, dimension, seed);
        if (name == std::string("parallel-lifted")) {
          // Coplanar points are "cospherical" as weighted points.
          PointsCase lower;
          for (std::size_t v = 0; v < set.points.size(); ++v) {
            if (set.weights[v] != squared_length(set.points[v])) continue;
            lower.points.push_back(set.points[v]);
            lower.weights.push_back(set.weights[v]);
          }
          set = lower;
        }
        CHECK(is_cospherical(set));
      }
      CHECK(is_cospherical(without_centre(drawn_from("polytopes", dimension, seed))));
    }
    CHECK(is_cospherical(drawn_from("circle", 2, seed)));
  }
}

TEST_CASE("families that keep their promise as doubles") {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    CAPTURE(seed);
    for (const std::size_t dimension : {2u, 3u}) {
      for (const char* name : {"pythagorean-sphere",
                               "symmetric-sphere",
                               "polytopes",
                               "grid",
                               "cube",
                               "cubic-lattice",
                               "body-centred-lattice",
                               "face-centred-lattice",
                               "hexagonal-lattice",
                               "huge",
                               "tiny",
                               "slab",
                               "clusters",
                               "nested-clusters",
                               "extreme-exponents",
                               "mixed-exponents",
                               "uniform",
                               "duplicates",
                               "submerged",
                               "pythagorean-sphere+scaled",
                               "sphere+ulp",
                               "sphere+moved",
                               "extreme-exponents+scaled",
                               "tiny+scaled",
                               "huge+moved",
                               "huge+ulp"}) {
        CAPTURE(name);
        CHECK(is_of_doubles(drawn_from(name, dimension, seed)));
      }
      CHECK(is_of_integers(drawn_from("cubic-lattice", dimension, seed)));
    }
  }
}

TEST_CASE("the circle in space: its axis passes all its points at one distance") {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const PointsCase set = drawn_from("circle", 3, seed);
    // Some plane holds a cocircular subset, and the other points are collinear: at most 12 points,
    // so that three of the circle are found by looking for a triple whose circle has most points.
    std::size_t most = 0;
    std::vector<bool> best;
    const std::size_t n = set.points.size();
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = a + 1; b < n; ++b) {
        for (std::size_t c = b + 1; c < n; ++c) {
          std::vector<bool> on(n);
          for (std::size_t v = 0; v < n; ++v) {
            PointsCase part{{set.points[a], set.points[b], set.points[c]}};
            if (v != a && v != b && v != c) part.points.push_back(set.points[v]);
            on[v] = affine_dimension(part) == 2 && is_cospherical(part);
          }
          const auto count = static_cast<std::size_t>(std::count(on.begin(), on.end(), true));
          if (count > most) {
            most = count;
            best = on;
          }
        }
      }
    }
    PointsCase axis;
    for (std::size_t v = 0; v < n && most > 0; ++v) {
      if (!best[v]) axis.points.push_back(set.points[v]);
    }
    CHECK(most >= 4);
    CHECK(affine_dimension(axis) <= 1);
  }
}

TEST_CASE("flat families span a flat") {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    for (const std::size_t dimension : {2u, 3u, 4u}) {
      CAPTURE(seed);
      CAPTURE(dimension);
      CHECK(affine_dimension(drawn_from("collinear", dimension, seed)) <= 1);
      CHECK(affine_dimension(drawn_from("lower-dimensional", dimension, seed)) <
            static_cast<int>(dimension));
      PointsCase base = drawn_from("pyramid", dimension, seed);
      base.points.resize(base.points.size() - std::min<std::size_t>(base.points.size(), 2));
      CHECK(affine_dimension(base) < static_cast<int>(dimension));
      if (dimension >= 3) CHECK(affine_dimension(drawn_from("coplanar", dimension, seed)) <= 2);
      for (const Point& x : drawn_from("box-boundary", dimension, seed).points) {
        CHECK(std::any_of(x.begin(), x.end(), [](const Rational& c) { return c == 0 || c == 4; }));
      }
    }
  }
}

// Tetrahedron, octahedron, cube, cuboctahedron and icosahedron, truncated octahedron; in dimension
// 4 the half-cube and cross-polytope, the tesseract, the 24-cell, and the permutations of (±1, ±2,
// 0, 0).
TEST_CASE("polytopes have all their vertices, and no others") {
  const auto sizes = [](std::size_t dimension) {
    std::set<std::size_t> found;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const PointsCase set = drawn(*find_family("polytopes"), dimension, {700, true}, seed);
      found.insert(without_centre(set).points.size());
    }
    return found;
  };
  CHECK(sizes(2) == std::set<std::size_t>{2, 4, 8});
  CHECK(sizes(3) == std::set<std::size_t>{4, 6, 8, 12, 24});
  CHECK(sizes(4) == std::set<std::size_t>{8, 16, 24, 48});
}

TEST_CASE("integer points of circles: as many as number theory says") {
  std::set<std::size_t> sizes;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    sizes.insert(drawn(*find_family("pythagorean-sphere"), 2, {2000, true}, seed).points.size());
  }
  CHECK(sizes == std::set<std::size_t>{12, 48, 96});
}

TEST_CASE("rings and prisms: many points at a height, and both rings of a prism on one sphere") {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    CAPTURE(seed);
    const PointsCase set = drawn_from("twisted-prism", 3, seed);
    const bool is_schonhardts =
        is_of_integers(set) && set.points.size() <= 7 &&
        std::any_of(set.points.begin(), set.points.end(), [](const Point& x) { return x[2] >= 5; });
    if (!is_schonhardts) CHECK(is_cospherical(set));
  }
}

TEST_CASE("lattices: sums, halves and rows") {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    for (const Point& x : drawn_from("face-centred-lattice", 3, seed).points) {
      CHECK(Rational((x[0] + x[1] + x[2]) / 2).get_den() == 1);
    }
    for (const Point& x : drawn_from("body-centred-lattice", 3, seed).points) {
      CHECK(std::all_of(x.begin(), x.end(),
                        [&x](const Rational& c) { return c.get_den() == x[0].get_den(); }));
      CHECK(x[0].get_den() <= 2);
    }
    for (const Point& x : drawn_from("hexagonal-lattice", 2, seed).points) {
      const double row = x[1].get_d() / std::sqrt(0.75);
      CHECK(std::abs(row - std::round(row)) < 1e-12);
      CHECK(Rational(2 * x[0]).get_den() == 1);
    }
  }
}

TEST_CASE("moment curve: every d + 1 points are affinely independent") {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    PointsCase set = drawn_from("moment-curve", 3, seed);
    for (std::size_t i = 0; i + 4 <= set.points.size(); ++i) {
      const auto first = set.points.begin() + static_cast<std::ptrdiff_t>(i);
      CHECK(affine_hull({first, first + 4}).dimension == 3);
    }
  }
}

TEST_CASE(
    "submerged: a low weight lies above the lifted simplex of the corners, which come first") {
  std::size_t low = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    for (const std::size_t dimension : {2u, 3u, 4u}) {
      const PointsCase set = drawn_from("submerged", dimension, seed);
      const Configuration points(set.points, set.weights);
      std::vector<Vertex> corners(dimension + 1);
      std::iota(corners.begin(), corners.end(), Vertex{0});
      REQUIRE(points.dimension() == static_cast<int>(dimension));
      for (std::size_t v = dimension + 1; v < set.points.size(); ++v) {
        const bool is_low = set.weights[v] != 0;
        low += is_low ? 1 : 0;
        CHECK(in_ball(points, corners, static_cast<Vertex>(v)) == (is_low ? -1 : 1));
      }
    }
  }
  CHECK(low > 50);
}

TEST_CASE("scales: squares that overflow, that underflow, and exponents far apart") {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    double largest = 0, least = HUGE_VAL;
    for (const Point& point : drawn_from("huge", 3, seed).points) {
      for (const Rational& x : point) largest = std::max(largest, std::abs(x.get_d()));
    }
    CHECK(largest >= 1e297);
    CHECK(std::isinf(largest * largest));
    for (const Point& point : drawn_from("tiny", 3, seed).points) {
      for (const Rational& x : point)
        least = sign(x) == 0 ? least : std::min(least, std::abs(x.get_d()));
    }
    CHECK(least * least == 0);
    for (const Point& x : drawn_from("slab", 3, seed).points) CHECK(abs(x[2]) * 256 < 1);
  }
}

}  // namespace
}  // namespace circumspect::generators
