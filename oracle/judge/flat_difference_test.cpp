// Meshes of doubles are compared as exact ones are.
#include "oracle/judge/flat_difference.hpp"

#include <random>

#include <doctest/doctest.h>

namespace circumspect::check {
namespace {

void are_compared_alike(const Mesh& a, const Mesh& b) {
  const auto flat_a = flat_complex(a);
  const auto flat_b = flat_complex(b);
  REQUIRE(flat_a);
  REQUIRE(flat_b);
  const auto found = difference(*flat_a, *flat_b);
  REQUIRE(found);
  const Difference expected = difference(a, b);
  CHECK(found->points_only_in_a == expected.points_only_in_a);
  CHECK(found->points_only_in_b == expected.points_only_in_b);
  CHECK(found->simplices_only_in_a == expected.simplices_only_in_a);
  CHECK(found->simplices_only_in_b == expected.simplices_only_in_b);
}

TEST_CASE("random meshes: points in any order, weighted or not, of either dimension, with faces") {
  std::mt19937 random(11);
  const auto below = [&random](unsigned n) { return random() % n; };
  for (int round = 0; round < 2000; ++round) {
    const auto mesh = [&] {
      std::vector<Point> all;
      const std::size_t dimension = below(12) == 0 ? 3 : 2;
      for (int x = -1; x < 2; ++x) {
        for (int y = -1; y < 2; ++y) {
          all.push_back({Rational(x) / 8, Rational(y)});
          if (dimension == 3) all.back().emplace_back(x + y);
        }
      }
      std::shuffle(all.begin(), all.end(), random);
      all.resize(1 + below(9));
      std::vector<Rational> weights;
      if (below(2) == 0) {
        for (std::size_t i = 0; i < all.size(); ++i)
          weights.emplace_back(static_cast<int>(below(2)));
      }
      const auto n = static_cast<unsigned>(all.size());
      const auto lists = [&](unsigned size) {
        std::vector<Simplex> some(below(6));
        for (Simplex& one : some) {
          for (unsigned i = 0; i < size; ++i) one.push_back(below(20) == 0 ? 12 : below(n));
        }
        return some;
      };
      return Mesh{PointSet(std::move(all), std::move(weights)), lists(3), {}, 0, {}, lists(2)};
    };
    are_compared_alike(mesh(), mesh());
  }
}

TEST_CASE("what is no double, and points that are equal, are left to the exact comparison") {
  CHECK(!flat_complex(Mesh{PointSet({{Rational(1) / 3}}), {}}));
  CHECK(!flat_complex(Mesh{PointSet({{0}}, {Rational(1) / 3}), {}}));
  const auto one = flat_complex(Mesh{PointSet({{0, 0}}), {}});
  FlatComplex twice;
  twice.points.coordinates = formats::FlatRows<double>(2, 2);
  for (double& x : twice.points.coordinates.values()) x = 0;
  REQUIRE(one);
  CHECK(!difference(twice, *one));
  CHECK(!difference(*one, twice));
  CHECK(difference(*one, *one)->empty());
  const auto nothing = flat_complex(Mesh{PointSet({}), {}});
  REQUIRE(nothing);
  CHECK(difference(*nothing, *one)->points_only_in_b == std::vector<Vertex>{0});
}

}  // namespace
}  // namespace circumspect::check
