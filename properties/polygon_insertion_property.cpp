// C3, C7: polygon insertion, by flips in any order and by cavities, makes one CDT, the one that
// gift-wrapping makes; flips keep within their bounds. Book: Sections 5.6 and 5.8.
#include <algorithm>
#include <optional>

#include <doctest/doctest.h>

#include "properties/arguments/complexes.hpp"
#include "properties/arguments/generated.hpp"
#include "properties/arguments/run.hpp"
#include "reference/constrained/cavity.hpp"
#include "reference/constrained/cdt_by_polygon_insertion.hpp"
#include "reference/constrained/evolving_cdt.hpp"
#include "reference/constrained/flip_insert_polygon.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/constrained/plc_triangulation.hpp"

namespace circumspect::properties {
namespace {

using constrained::EvolvingCdt;
using constrained::PlcTriangulation;
using constrained::PolygonFlips;
using constrained::PolygonInsertion;
using generators::ComplexCase;

std::vector<std::size_t> order_of_polygons(std::size_t count) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < count; ++i) {
    const long place = *generators::below(static_cast<long>(i + 1));
    order.insert(order.begin() + place, i);
  }
  return order;
}

std::set<Simplex> difference(const std::set<Simplex>& a, const std::set<Simplex>& b) {
  std::set<Simplex> only_a;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::inserter(only_a, only_a.end()));
  return only_a;
}

// Proposition 5.5, and that no edge ever returns, not even in a later insertion (Proposition 5.6).
class Bounds {
 public:
  void check(const PolygonFlips& run) {
    const bool is_bounded = run.flips.empty() || run.flips.size() < run.vertices * run.vertices;
    RC_ASSERT(is_bounded);
    RC_ASSERT(run.held_back == 0u);
    for (std::size_t i = 0; i < run.flips.size(); ++i) {
      const constrained::TimedFlip& flip = run.flips[i];
      RC_ASSERT(sign(flip.time.standard) >= 0);
      if (i > 0) RC_ASSERT(run.flips[i - 1].time < flip.time);
      const std::set<Simplex> before = constrained::edges_of(flip.flip.deleted);
      const std::set<Simplex> after = constrained::edges_of(flip.flip.created);
      for (const Simplex& edge : difference(after, before)) RC_ASSERT(!gone_.contains(edge));
      gone_.merge(difference(before, after));
    }
    flips_ += run.flips.size();
  }
  std::size_t flips() const { return flips_; }

 private:
  std::set<Simplex> gone_;
  std::size_t flips_ = 0;
};

TEST_CASE("C3 C7 polygon insertion in any order and gift-wrapping make one CDT (Prop. 4.12)") {
  std::size_t flips = 0;
  CHECK(holds("polygon insertion", 250, [&] {
    const ComplexCase generated = *any_protected_complex(12);
    const PiecewiseLinearComplex complex = generated.complex();
    constrained::PolygonInsertionOptions options;
    Bounds bounds;
    std::vector<PolygonFlips> runs;
    const auto as_given = constrained::cdt_by_polygon_insertion(complex, options, &runs);
    RC_ASSERT(as_given.has_value());
    for (const PolygonFlips& run : runs) bounds.check(run);
    flips += bounds.flips();
    options.order = order_of_polygons(complex.polygons.size());
    RC_ASSERT(constrained::cdt_by_polygon_insertion(complex, options).value() == *as_given);
    options.by = PolygonInsertion::kCavities;
    RC_ASSERT(constrained::cdt_by_polygon_insertion(complex, options).value() == *as_given);
    RC_ASSERT(constrained::gift_wrapping_cdt(complex).value() == *as_given);
  }));
  CHECK(occurs(flips, 101));
}

// The input without one of its polygons, whose segments stay.
PiecewiseLinearInput without_polygon(PiecewiseLinearInput input, std::size_t place) {
  const auto polygon = input.polygons.begin() + static_cast<std::ptrdiff_t>(place);
  for (const auto& line : polygon->lines) {
    for (std::size_t i = 0; i < line.size() && line.size() > 1; ++i) {
      input.segments.push_back({line[i], line[(i + 1) % line.size()]});
    }
  }
  input.polygons.erase(polygon);
  return input;
}

// Inserts a polygon into the CDT of all the others, if there is one, both ways. Says whether the
// whole has a CDT; nothing if the others have none.
std::optional<bool> insert_into_others(const PiecewiseLinearInput& whole, std::size_t place) {
  const PiecewiseLinearComplex others = assemble(without_polygon(whole, place));
  const auto before = constrained::gift_wrapping_cdt(others);
  if (!before) return std::nullopt;
  const PiecewiseLinearComplex complex = assemble(whole);
  const Polygon& polygon = complex.polygons[place];
  const auto after = constrained::gift_wrapping_cdt(complex);
  const EvolvingCdt start = constrained::evolving_cdt(others, *before);
  const EvolvingCdt expected = after ? constrained::evolving_cdt(complex, *after) : start;

  EvolvingCdt by_cavity = start;
  const auto wrong = constrained::insert_polygon_by_cavity(complex.points, by_cavity, polygon);
  RC_ASSERT(!wrong == after.has_value());
  RC_ASSERT(by_cavity == expected);
  EvolvingCdt by_flips = start;
  const auto run = constrained::flip_insert_polygon(complex.points, by_flips, polygon);
  RC_ASSERT(run.has_value() == after.has_value());
  RC_ASSERT(by_flips == expected);
  return after.has_value();
}

TEST_CASE(
    "C3 a polygon is inserted iff that leaves a CDT, segments Delaunay or not (Section 5.8)") {
  std::size_t inserted = 0;
  CHECK(holds("any polygon", 300, [&] {
    ComplexCase whole = *generators::any_complex(10);
    whole.input.kind = DomainKind::kHull;
    whole.input.hole_seeds.clear();
    if (PointSet(whole.input.points).dimension() < 3) return;
    for (std::size_t place = 0; place < whole.input.polygons.size(); ++place) {
      if (insert_into_others(whole.input, place)) ++inserted;
    }
  }));
  CHECK(occurs(inserted, 51));
}

}  // namespace
}  // namespace circumspect::properties
