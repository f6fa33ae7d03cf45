// The extremes, histograms, size and topology of meshes: against the definition of each measure,
// and of meshes about which everything is known.
#include "oracle/judge/quality/survey.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <doctest/doctest.h>

#include "inputs/dice.hpp"
#include "kernel/piecewise_linear/disjoint_sets.hpp"
#include "oracle/judge/definition/quality.hpp"
#include "oracle/judge/quality/topology.hpp"
#include "oracle/model/listed_mesh_test.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::quality {
namespace {

using generators::Dice;

// Segments of a line, triangles or tetrahedra on a small grid, or on one of numbers that are
// rounded.
Mesh drawn_mesh(Dice& dice) {
  const std::size_t space = dice.below(8) == 0 ? 1 : dice.below(2) + 2;
  const std::size_t size = space == 3 ? 3 + dice.below(2) : space + 1;
  const bool is_rounded = dice.below(2) == 0;
  std::vector<Point> points;
  for (std::size_t i = 0; i < 7; ++i) {
    Point& point = points.emplace_back();
    for (std::size_t axis = 0; axis < space; ++axis) {
      const Rational on_grid(dice.within(0L, 3L));
      point.push_back(is_rounded ? exact_value(on_grid.get_d() * 0.1) : on_grid);
    }
  }
  std::vector<Simplex> simplices(12);
  for (Simplex& simplex : simplices) {
    for (std::size_t i = 0; i < size; ++i) {
      simplex.push_back(static_cast<Vertex>(dice.below(dice.below(30) == 0 ? 9 : 7)));
    }
  }
  return listed_mesh(std::move(points), std::move(simplices));
}

// What the definition measures of each simplex, by its place.
std::vector<std::pair<std::size_t, Rational>> defined(Measure measure, const Mesh& mesh) {
  std::vector<std::pair<std::size_t, Rational>> all;
  for (std::size_t s = 0; s < mesh.simplices.size(); ++s) {
    std::vector<Point> corners;
    for (const Vertex v : mesh.simplices[s]) {
      if (mesh.names(v)) corners.push_back(mesh.point(v));
    }
    if (corners.size() < mesh.simplices.columns()) continue;
    if (const auto value = definition::measured(measure, corners)) all.emplace_back(s, *value);
  }
  return all;
}

// Is the first number, as people know it, larger? The square of the cosine says the opposite.
bool is_larger(Measure measure, const Rational& a, const Rational& b) {
  return entry(measure).is_angle ? a < b : b < a;
}

TEST_CASE("extremes and histograms are those of the definition") {
  std::size_t extremes = 0, counted = 0;
  for (std::uint64_t seed = 0; seed < 300 / properties::kOneInputIn; ++seed) {
    CAPTURE(seed);
    Dice dice(seed);
    const Mesh mesh = drawn_mesh(dice);
    const Survey found = survey(mesh, 1);
    CHECK(found.dimension + 1 == static_cast<int>(mesh.simplices.columns()));
    for (const Extreme& extreme : found.extremes) {
      const auto all = defined(extreme.measure, mesh);
      REQUIRE(!all.empty());
      const auto* first = &all.front();
      for (const auto& one : all) {
        const bool is_further = extreme.is_largest
                                    ? is_larger(extreme.measure, one.second, first->second)
                                    : is_larger(extreme.measure, first->second, one.second);
        if (is_further) first = &one;
      }
      CAPTURE(entry(extreme.measure).name);
      CHECK(extreme.simplex == first->first);
      CHECK(extreme.found.value == first->second);
      ++extremes;
    }
    for (const Histogram& histogram : found.histograms) {
      std::vector<std::size_t> counts(histogram.bounds.size() + 1, 0);
      for (const auto& [place, value] : defined(histogram.measure, mesh)) {
        std::size_t bin = 0;
        while (bin < histogram.bounds.size() &&
               compare(histogram.measure, value, histogram.bounds[bin]) >= 0) {
          ++bin;
        }
        ++counts[bin];
        ++counted;
      }
      CHECK(histogram.counts == counts);
    }
    CHECK(found.measured + found.set_apart == mesh.simplices.size());
  }
  CHECK(extremes > 1000 / properties::kOneInputIn);
  CHECK(counted > 3000 / properties::kOneInputIn);
}

TEST_CASE(
    "the survey of a large mesh does not depend on the threads, and finds its one bad simplex") {
  std::vector<Point> points;
  std::vector<Simplex> simplices;
  constexpr long kSide = 80;
  for (long y = 0; y <= kSide; ++y) {
    for (long x = 0; x <= kSide; ++x) points.push_back({x, y});
  }
  points[41 * (kSide + 1) + 40] = {40, Rational(161, 4)};
  for (long y = 0; y < kSide; ++y) {
    for (long x = 0; x < kSide; ++x) {
      const Vertex a = y * (kSide + 1) + x, b = a + kSide + 1;
      simplices.push_back({a, a + 1, b + 1});
      simplices.push_back({a, b + 1, b});
    }
  }
  const Mesh mesh = listed_mesh(points, simplices);
  for (const unsigned threads : {1U, 3U}) {
    const Survey found = survey(mesh, threads);
    REQUIRE(found.extremes.size() == 10);
    CHECK(measure_text(found.extremes[0].measure, found.extremes[0].found.value) ==
          "8.130102354155978deg");
    CHECK(found.extremes[0].simplex == 2 * (40 * kSide + 40) + 1);
    CHECK(found.measured == simplices.size());
    CHECK(found.histograms[0].counts[9] == simplices.size() - 5);  // of 45 degrees
  }
}

TEST_CASE("of a mesh that is listed a thousand times over each bin has a thousand times as many") {
  constexpr std::size_t kTimes = 1000;
  for (std::uint64_t seed = 0; seed < 2; ++seed) {
    CAPTURE(seed);
    Dice dice(seed);
    const Mesh once = drawn_mesh(dice);
    std::vector<Simplex> often;
    for (std::size_t i = 0; i < kTimes; ++i) {
      for (std::size_t s = 0; s < once.simplices.size(); ++s) often.push_back(once.simplices[s]);
    }
    const Survey one = survey(once, 1), many = survey(listed_mesh(once.exact_points(), often), 2);
    CHECK(many.measured == kTimes * one.measured);
    CHECK(many.set_apart == kTimes * one.set_apart);
    REQUIRE(many.extremes.size() == one.extremes.size());
    for (std::size_t i = 0; i < one.extremes.size(); ++i) {
      CHECK(many.extremes[i].found.value == one.extremes[i].found.value);
      CHECK(many.extremes[i].simplex == one.extremes[i].simplex);
    }
    for (std::size_t h = 0; h < one.histograms.size(); ++h) {
      for (std::size_t bin = 0; bin < one.histograms[h].counts.size(); ++bin) {
        CHECK(many.histograms[h].counts[bin] == kTimes * one.histograms[h].counts[bin]);
      }
    }
  }
}

TEST_CASE("topology: a ring, a sphere, a torus, a Moebius strip, a ball and a thick shell") {
  const Topology ring = topology(listed_mesh(
      {{2, 2}, {-2, 2}, {-2, -2}, {2, -2}, {5, 6}, {-6, 5}, {-5, -6}, {6, -5}},
      {{0, 4, 5}, {0, 5, 1}, {1, 5, 6}, {1, 6, 2}, {2, 6, 7}, {2, 7, 3}, {3, 7, 4}, {3, 4, 0}}));
  CHECK(ring.faces == std::vector<std::size_t>{8, 16, 8});
  CHECK(ring.euler_characteristic == 0);
  CHECK(ring.boundary_facets == 8);
  CHECK(ring.boundary_parts == 2);
  CHECK(ring.genus == std::size_t{0});
  const std::vector<Point> corner = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Topology sphere =
      topology(listed_mesh(corner, {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}));
  CHECK(sphere.euler_characteristic == 2);
  CHECK(sphere.boundary_parts == 0);
  CHECK(sphere.genus == std::size_t{0});
  const Topology ball = topology(listed_mesh(corner, {{0, 1, 2, 3}, {0, 1, 2, 2}, {0, 1, 2, 7}}));
  CHECK(ball.faces == std::vector<std::size_t>{4, 6, 4, 1});
  CHECK(ball.euler_characteristic == 1);
  CHECK(ball.boundary_parts == 1);
  CHECK(ball.genus == std::size_t{0});
  // A closed strip of squares around a square, with a twist or without, and its boundary.
  std::vector<Point> around;
  for (long i = 0; i < 12; ++i) around.push_back({i % 3, (i * i) % 7, i});
  std::vector<Simplex> torus;  // four rings of three corners each, and the last joined to the first
  for (Vertex i = 0; i < 4; ++i) {
    for (Vertex j = 0; j < 3; ++j) {
      const Vertex a = 3 * i + j, b = 3 * i + (j + 1) % 3, c = (a + 3) % 12, d = (b + 3) % 12;
      torus.push_back({a, b, c});
      torus.push_back({b, c, d});
    }
  }
  const Topology one_handle = topology(listed_mesh(around, torus));
  CHECK(one_handle.euler_characteristic == 0);
  CHECK(one_handle.boundary_parts == 0);
  CHECK(one_handle.genus == std::size_t{1});
  const Topology strip =
      topology(listed_mesh(around, {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}}));
  CHECK(strip.euler_characteristic == 0);
  CHECK(strip.boundary_parts == 1);
  CHECK(!strip.genus);  // it has one side only
  const Topology two_strips = topology(listed_mesh(around, {{0, 1, 2},
                                                            {1, 2, 3},
                                                            {2, 3, 4},
                                                            {3, 4, 0},
                                                            {4, 0, 1},
                                                            {5, 6, 7},
                                                            {6, 7, 8},
                                                            {7, 8, 9},
                                                            {8, 9, 5},
                                                            {9, 5, 6}}));
  CHECK(two_strips.boundary_parts == 2);
  CHECK(!two_strips.genus);  // which as two surfaces with two sides would be 1
  // Of edges, all ends of which have the empty ridge in common.
  const Topology path = topology(listed_mesh(corner, {{0, 1}, {1, 2}}));
  CHECK(path.boundary_facets == 2);
  CHECK(path.boundary_parts == 1);
  const Topology cycle = topology(listed_mesh(corner, {{0, 1}, {1, 2}, {2, 0}}));
  CHECK(cycle.euler_characteristic == 0);
  CHECK(cycle.boundary_parts == 0);
}

// In how many parts are some faces, if those with a common face of this size are connected?
std::size_t parts_of(const std::vector<Simplex>& faces_in, std::size_t size) {
  DisjointSets sets(faces_in.size());
  std::map<Simplex, std::size_t> first;
  std::set<std::size_t> parts;
  for (std::size_t i = 0; i < faces_in.size(); ++i) {
    for (const Simplex& face : faces_of({faces_in[i]}, size)) {
      sets.unite(i, first.try_emplace(face, i).first->second);
    }
  }
  for (std::size_t i = 0; i < faces_in.size(); ++i) parts.insert(sets.find(i));
  return parts.size();
}

// 2 − 2g = χ + circles for each part, if the triangles can be turned so that any two pass their
// common edge in opposite directions: all ways to turn them are tried.
std::optional<std::size_t> genus_by_trying(const std::vector<Simplex>& triangles) {
  std::map<Simplex, std::vector<std::pair<std::size_t, bool>>> uses;  // is it passed upwards?
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vertex a = triangles[t][i], b = triangles[t][(i + 1) % 3];
      uses[sorted({a, b})].emplace_back(t, a < b);
    }
  }
  std::vector<Simplex> open;
  for (const auto& [edge, of_edge] : uses) {
    if (of_edge.size() > 2) return std::nullopt;
    if (of_edge.size() == 1) open.push_back(edge);
  }
  bool is_orientable = false;
  for (std::size_t turned = 0; turned < std::size_t{1} << triangles.size(); ++turned) {
    is_orientable |= std::all_of(uses.begin(), uses.end(), [&](const auto& of_edge) {
      const auto upwards = [&](const auto& use) {
        return use.second != ((turned >> use.first & 1) != 0);
      };
      const auto& both = of_edge.second;
      return both.size() == 1 || upwards(both[0]) != upwards(both[1]);
    });
  }
  const auto count = [](std::size_t size) { return static_cast<int>(size); };
  const int twice = 2 * count(parts_of(triangles, 2)) - count(parts_of(open, 1)) +
                    count(uses.size()) - count(triangles.size()) -
                    count(faces_of(triangles, 1).size());
  if (!is_orientable || twice < 0 || twice % 2 != 0) return std::nullopt;
  return static_cast<std::size_t>(twice / 2);
}

// Points of a moment curve, of which no four are in one plane.
TEST_CASE("topology: handles are as many as the definition has, if the surface has two sides") {
  Dice dice(20261127);
  std::map<std::optional<std::size_t>, std::size_t> seen;
  for (int round = 0; round < 1500; ++round) {
    const std::size_t vertices = 5 + dice.below(2), size = 3 + dice.below(2);
    std::vector<Point> points;
    std::vector<Simplex> all = {first_subset(vertices)}, some;
    for (long t = 0; t < static_cast<long>(vertices); ++t) points.push_back({t, t * t, t * t * t});
    for (const Simplex& simplex : faces_of(all, size)) {
      if (dice.below(faces_of(all, size).size()) < (size == 3 ? 8 : 3)) some.push_back(simplex);
    }
    std::vector<Simplex> surface;
    for (const Simplex& triangle : faces_of(some, 3)) {
      const auto has_it = [&](const Simplex& simplex) { return has_face(simplex, triangle); };
      if (size == 3 || std::count_if(some.begin(), some.end(), has_it) == 1)
        surface.push_back(triangle);
    }
    if (some.empty() || surface.size() > 12) continue;
    // Of tetrahedra three of which share a facet, the boundary may be open and enclose nothing.
    std::optional<std::size_t> expected = genus_by_trying(surface);
    if (size == 4) {
      for (const Simplex& edge : faces_of(surface, 2)) {
        const auto has_it = [&](const Simplex& triangle) { return has_face(triangle, edge); };
        if (std::count_if(surface.begin(), surface.end(), has_it) == 1) expected.reset();
      }
    }
    CHECK(topology(listed_mesh(points, some)).genus == expected);
    ++seen[expected];
  }
  CHECK(seen[std::nullopt] > 100);
  CHECK(seen[0] > 100);
}

TEST_CASE("sizes are exact where they are rational, and correctly rounded elsewhere") {
  const Mesh corner = listed_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}});
  CHECK(size_of(corner).exact == Rational(1, 6));
  CHECK(size_of(corner).decimal == "0.16666666666666666");
  CHECK(!size_of_boundary(corner).exact);
  CHECK(size_of_boundary(corner).decimal == "2.366025403784439");  // 3/2 + √3/2
  const Mesh square =
      listed_mesh({{0, 0}, {3, 0}, {3, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}, {0, 1, 9}});
  CHECK(size_of(square).exact == Rational(3));
  CHECK(size_of_boundary(square).decimal == "8");
  const Mesh steps = listed_mesh({{0}, {1}, {4}, {Rational(9, 2)}}, {{0, 1}, {2, 1}, {2, 3}});
  CHECK(size_of(steps).exact == Rational(9, 2));
}

TEST_CASE("a size is exact where every point has a denominator of its own") {
  std::vector<Point> points = {{0, 0}};
  std::vector<Simplex> fan;
  Rational twice = 0;
  for (int i = 1; i <= 40; ++i) {
    const Rational tiny(Integer(1), (Integer(1) << 70U) + i);
    points.push_back({i + tiny, 1});
    if (i == 1) continue;
    fan.push_back({0, i - 1, i});
    twice += points[static_cast<std::size_t>(i)][0] - points[static_cast<std::size_t>(i) - 1][0];
  }
  CHECK(size_of(listed_mesh(points, fan)).exact == twice / 2);
}

}  // namespace
}  // namespace circumspect::quality
