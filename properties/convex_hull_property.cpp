// The claim `convex-hull`: by lemma and by definition the same is said, word for word, of hulls
// with and without the points of their boundary, and of those in which faults were planted. Proof:
// docs/theory/questions.md.
#include <algorithm>
#include <map>
#include <set>

#include <doctest/doctest.h>

#include "inputs/dice.hpp"
#include "kernel/complex/by_facet.hpp"
#include "oracle/judge/convex_hull/judge_convex_hull.hpp"
#include "oracle/judge/definition/complex.hpp"
#include "oracle/judge/judge.hpp"
#include "oracle/judge/points/simplices.hpp"
#include "oracle/report/text.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::properties::convex_hull {
namespace {

using generators::Dice;

struct ListedHull {
  std::vector<Point> points;
  std::vector<Simplex> facets;
};

// Few coordinates, so that much lies in one hyperplane.
Point small_point(Dice& dice, std::size_t d) {
  Point point;
  for (std::size_t axis = 0; axis < d; ++axis) point.push_back(dice.within(0L, d == 1 ? 9L : 3L));
  return point;
}

// The boundary of the triangulation of some points, in a set that has more of them: inside,
// outside, or in the boundary.
ListedHull drawn_hull(Dice& dice, std::size_t d) {
  std::set<Point> some;
  const std::size_t count = d + 1 + dice.below(5);
  while (some.size() < count) some.insert(small_point(dice, d));
  ListedHull hull{{some.begin(), some.end()}, {}};
  hull.facets = definition::open_facets(delaunay::bowyer_watson(PointSet(hull.points)).simplices());
  for (std::size_t more = dice.below(4); more > 0; --more) {
    const Point point = dice.below(2) == 0
                            ? barycentre({hull.points[0], hull.points[dice.below(count)]})
                            : small_point(dice, d);
    if (some.insert(point).second) hull.points.push_back(point);
  }
  return hull;
}

Simplex& any(Dice& dice, std::vector<Simplex>& facets) { return facets[dice.below(facets.size())]; }
void erase_any(Dice& dice, std::vector<Simplex>& facets) {
  facets.erase(facets.begin() + static_cast<std::ptrdiff_t>(dice.below(facets.size())));
}

// Two facets with a common ridge become those with the other diagonal of their quadrilateral.
void flip_one(Dice& dice, ListedHull& hull) {
  const std::vector<FacetUse> uses = facet_uses(hull.facets);
  std::vector<std::pair<FacetUse, FacetUse>> pairs;
  for (const auto group : ByFacet(uses)) {
    if (group.size() == 2 && group[0].facet.size() == 2) pairs.emplace_back(group[0], group[1]);
  }
  if (pairs.empty()) return;
  const auto& [a, b] = pairs[dice.below(pairs.size())];
  const Vertex p = hull.facets[a.simplex][a.opposite], q = hull.facets[b.simplex][b.opposite];
  hull.facets[a.simplex] = {p, q, a.facet[0]};
  hull.facets[b.simplex] = {q, p, a.facet[1]};
}

void break_once(Dice& dice, ListedHull& hull) {
  if (hull.facets.empty()) return;
  const std::size_t d = hull.points.front().size();
  const auto any_vertex = [&] { return static_cast<Vertex>(dice.below(hull.points.size())); };
  switch (dice.below(8)) {
    case 0: {
      const Point moved = small_point(dice, d);
      if (std::count(hull.points.begin(), hull.points.end(), moved) == 0) {
        hull.points[dice.below(hull.points.size())] = moved;
      }
      return;
    }
    case 1: {
      Simplex& facet = any(dice, hull.facets);
      facet[dice.below(facet.size())] = any_vertex();
      return;
    }
    case 2: {
      Simplex added = any(dice, hull.facets);
      for (Vertex& v : added) v = any_vertex();
      hull.facets.push_back(added);
      return;
    }
    case 3:
      hull.facets.push_back(any(dice, hull.facets));
      return;
    case 4: {
      Simplex& facet = any(dice, hull.facets);
      std::swap(facet.front(), facet.back());
      return;
    }
    case 5: {  // one vertex takes the place of another everywhere
      const Vertex from = any_vertex(), to = any_vertex();
      for (Simplex& facet : hull.facets) std::replace(facet.begin(), facet.end(), from, to);
      return;
    }
    case 6:
      return flip_one(dice, hull);
    default:
      erase_any(dice, hull.facets);
  }
}

// Sometimes in a hyperplane of a space of one more dimension.
void lift(Dice& dice, ListedHull& hull) {
  if (dice.below(8) != 0) return;
  for (Point& point : hull.points) point.push_back(Rational(point.front() * 2 + 1));
}

// A polygon that winds twice around its inside, convex at each vertex; or a double pyramid over it,
// around whose apex only the ray sees two facets.
ListedHull wound_twice(std::size_t d) {
  ListedHull star{{{4, 0}, {1, 4}, {-3, 2}, {-3, -2}, {1, -4}}, {}};
  for (Vertex v = 0; v < 5; ++v) star.facets.push_back({v, (v + 2) % 5});
  if (d == 2) return star;
  for (Point& point : star.points) point.push_back(0);
  star.points.push_back({0, 0, 5});
  star.points.push_back({0, 0, -5});
  const std::vector<Simplex> edges = star.facets;
  star.facets.clear();
  for (const Simplex& edge : edges) {
    star.facets.push_back({edge[0], edge[1], 5});
    star.facets.push_back({edge[0], edge[1], 6});
  }
  return star;
}

// Two quadrilaterals of eight points in convex position. Seen from the centre of the first three,
// the middle of the first side is just before a corner of the other one.
ListedHull two_quadrilaterals() {
  ListedHull both{{{12, 0}, {0, 12}, {-12, 0}, {0, -12}, {9, 7}, {-9, 9}, {-9, -9}, {9, -9}}, {}};
  for (Vertex v = 0; v < 8; ++v) both.facets.push_back({v, v / 4 * 4 + (v + 1) % 4});
  return both;
}

// The same hull seen in a mirror, with everything numbered from the other end.
ListedHull turned_round(ListedHull hull) {
  std::reverse(hull.points.begin(), hull.points.end());
  for (Point& point : hull.points) point = Rational(-1) * point;
  std::reverse(hull.facets.begin(), hull.facets.end());
  const auto count = static_cast<Vertex>(hull.points.size());
  for (Simplex& facet : hull.facets) {
    for (Vertex& v : facet) v = count - 1 - v;
  }
  return hull;
}

std::map<Rule, std::size_t> counts(const Verdict& verdict) {
  std::map<Rule, std::size_t> counts;
  for (const auto& [rule, tally] : verdict.tallies()) counts[rule] = tally.count;
  return counts;
}

std::string text(const Verdict& verdict, const Mesh& mesh) {
  return report::explanation(verdict, mesh) + report::verdict_line(verdict, mesh, "m");
}

struct Outcomes {
  std::map<Rule, std::size_t> broken = {};
  std::size_t held = 0, held_with_more = 0;
};

void compare(std::size_t d, int inputs, Outcomes& seen) {
  CHECK(holds("by lemma as by definition, and as by the judge of arrays", inputs, [&, d] {
    Dice dice(*rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>()));
    const bool is_star = (d == 2 || d == 3) && dice.below(40) == 0;
    const bool is_double = d == 2 && is_star && dice.below(2) == 0;
    ListedHull hull = is_double ? two_quadrilaterals()
                      : is_star ? wound_twice(d)
                                : drawn_hull(dice, d);
    for (std::size_t faults = dice.below(3); faults > 0; --faults) break_once(dice, hull);
    lift(dice, hull);
    const ExactMesh listed{PointSet(hull.points), hull.facets};
    if (listed.points.dimension() < 1) return;
    const check::Options options{
        .oriented = dice.below(4) == 0,
        .hull = {.all_boundary_points = dice.below(3) == 0, .only_extreme = dice.below(3) == 0},
        .max_violations = 0};
    const Mesh mesh = in_rows(listed);
    const auto judged = [&](bool by_definition) {
      return check::judge_convex_hull(listed, options.hull, options.oriented, by_definition, 0);
    };
    const Verdict by_lemma = judged(false);
    RC_ASSERT(text(by_lemma, mesh) == text(judged(true), mesh));
    const Verdict of_arrays = check::judge(Claim::kConvexHull, mesh, nullptr, options).value();
    RC_ASSERT(text(of_arrays, mesh) == text(by_lemma, mesh));
    if (dice.below(4) == 0) {
      const ListedHull turned = turned_round(hull);
      const ExactMesh other{PointSet(turned.points), turned.facets};
      const Verdict again =
          check::judge_convex_hull(other, options.hull, options.oriented, false, dice.below(2));
      RC_ASSERT(counts(again) == counts(by_lemma));
    }
    seen.held += by_lemma.holds() ? 1 : 0;
    seen.held_with_more += by_lemma.holds() && !check::unused_points(listed).empty() ? 1 : 0;
    for (const auto& [rule, tally] : by_lemma.tallies()) ++seen.broken[rule];
  }));
}

TEST_CASE("convex-hull: by lemma and by definition the same is said of every list of facets") {
  Outcomes seen;
  compare(1, 1000, seen);
  compare(2, 4000, seen);
  compare(3, 5000, seen);
  compare(4, 200, seen);
  CHECK(occurs(seen.held, 1000));
  CHECK(occurs(seen.held_with_more, 500));
  for (const Rule rule :
       {Rule::kFacetNotSupporting, Rule::kHullUncovered, Rule::kBoundaryPointLeftOut,
        Rule::kVertexNotExtreme, Rule::kOverlap, Rule::kHangingVertex, Rule::kFacesCross,
        Rule::kNotOriented, Rule::kDegenerateSimplex, Rule::kRepeatedVertex,
        Rule::kDuplicateSimplex, Rule::kWrongDimension}) {
    CAPTURE(identifier(rule));
    CHECK(occurs(seen.broken[rule]));
  }
}

}  // namespace
}  // namespace circumspect::properties::convex_hull
