// The claim `voronoi`: by lemma and by definition the same is said, word for word, of diagrams that
// are exact, rounded, or broken, in the plane and in space. Proof: docs/theory/questions.md.
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

#include <doctest/doctest.h>

#include "inputs/dice.hpp"
#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/circumball.hpp"
#include "oracle/judge/definition/voronoi.hpp"
#include "oracle/judge/definition/voronoi_structure.hpp"
#include "oracle/judge/voronoi/clipped_cell.hpp"
#include "oracle/judge/voronoi/judge_structure.hpp"
#include "oracle/judge/voronoi/judge_voronoi.hpp"
#include "oracle/judge/voronoi/sites_around.hpp"
#include "oracle/judge/voronoi/structure_by_corners.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/report/text.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::properties::voronoi {
namespace {

using generators::Dice;

// In space fewer, mostly: the definition tries all simplices of the corners of a cell.
PointSet small_sites(Dice& dice, std::size_t d) {
  std::set<Point> points;
  const std::size_t count = d + 1 + dice.below(d == 2 ? 6 : 1 + dice.below(3));
  while (points.size() < count) {
    Point point;
    for (std::size_t axis = 0; axis < d; ++axis) point.push_back(dice.within(0L, 5L));
    points.insert(point);
  }
  const PointSet sites({points.begin(), points.end()});
  return sites.dimension() < static_cast<int>(d) ? small_sites(dice, d) : sites;
}

std::set<Simplex> edges_of(const Simplex& simplex) {
  const std::vector<Simplex> edges = faces_of({simplex}, 2);
  return {edges.begin(), edges.end()};
}

// The centre of the circumball of each simplex is a corner of the cells of its vertices. The cells
// of vertices of the boundary are unbounded.
VoronoiDiagram exact_diagram(const PointSet& sites) {
  VoronoiDiagram diagram{sites};
  diagram.cells.resize(sites.size());
  const std::vector<Simplex> simplices = delaunay::bowyer_watson(sites).simplices();
  std::set<Simplex> edges;
  for (const Simplex& simplex : simplices) {
    for (const Vertex v : simplex) {
      diagram.cells[static_cast<std::size_t>(v)].corners.push_back(
          static_cast<Vertex>(diagram.vertices.size()));
    }
    edges.merge(edges_of(simplex));
    diagram.vertices.push_back(circumball(sites, simplex).centre);
  }
  std::set<Simplex> hull;  // the edges of its facets
  for (const auto group : ByFacet(facet_uses(simplices))) {
    for (const Vertex v : group[0].facet) {
      if (group.size() == 1) diagram.cells[static_cast<std::size_t>(v)].is_unbounded = true;
    }
    if (group.size() == 1) hull.merge(edges_of(group[0].facet));
  }
  for (const Simplex& edge : edges) {
    ListedCell ridge{{}, hull.contains(edge)};
    for (std::size_t s = 0; s < simplices.size(); ++s) {
      if (has_face(simplices[s], edge)) ridge.corners.push_back(static_cast<Vertex>(s));
    }
    diagram.neighbors.push_back({edge[0], edge[1]});
    diagram.ridges.push_back(std::move(ridge));
  }
  return diagram;
}

// Lists a vertex once more, for one ridge.
void list_again(Dice& dice, VoronoiDiagram& diagram) {
  ListedCell& ridge = diagram.ridges[dice.below(diagram.ridges.size())];
  if (ridge.corners.empty()) return;
  Vertex& end = ridge.corners[dice.below(ridge.corners.size())];
  diagram.vertices.push_back(diagram.vertices.at(static_cast<std::size_t>(end)));
  end = static_cast<Vertex>(diagram.vertices.size()) - 1;
}

void break_a_ridge(Dice& dice, VoronoiDiagram& diagram) {
  if (diagram.ridges.empty()) return;
  const std::size_t r = dice.below(diagram.ridges.size());
  const auto at = static_cast<std::ptrdiff_t>(r);
  ListedCell& ridge = diagram.ridges[r];
  switch (dice.below(6)) {
    case 0:
      diagram.ridges.erase(diagram.ridges.begin() + at);
      diagram.neighbors.erase(diagram.neighbors.begin() + at);
      return;
    case 1:  // with another
      std::swap(diagram.neighbors[r], diagram.neighbors[dice.below(diagram.neighbors.size())]);
      return;
    case 2:
      if (!ridge.corners.empty()) ridge.corners.pop_back();
      return;
    case 3:
      ridge.corners.push_back(static_cast<Vertex>(dice.below(diagram.vertices.size() + 1)));
      return;
    case 4:
      ridge.is_unbounded = !ridge.is_unbounded;
      return;
    default:
      diagram.vertices.push_back(diagram.vertices[dice.below(diagram.vertices.size())]);
      diagram.vertices.back().front() += Rational(1, 32 << dice.below(3));
  }
}

void break_once(Dice& dice, VoronoiDiagram& diagram) {
  ListedCell& cell = diagram.cells[dice.below(diagram.cells.size())];
  Point& vertex = diagram.vertices[dice.below(diagram.vertices.size())];
  switch (dice.below(6)) {
    case 0:
      for (Rational& x : vertex) x += dice.within(-1L, 1L) / Rational(64);
      return;
    case 1:
      vertex = diagram.sites[static_cast<Vertex>(dice.below(diagram.sites.size()))];
      return;
    case 2:
      if (!cell.corners.empty()) cell.corners.pop_back();
      return;
    case 3:
      cell.corners.push_back(static_cast<Vertex>(dice.below(diagram.vertices.size() + 1)));
      return;
    case 4:
      cell.is_unbounded = !cell.is_unbounded;
      return;
    default:
      diagram.neighbors.erase(diagram.neighbors.begin());
      diagram.ridges.erase(diagram.ridges.begin());
  }
}

// The same diagram seen in a mirror, with everything numbered from the other end.
VoronoiDiagram turned_round(const VoronoiDiagram& diagram) {
  const auto mirrored = [](std::vector<Point> points) {
    std::reverse(points.begin(), points.end());
    for (Point& point : points) point = Rational(-1) * point;
    return points;
  };
  const auto from_end = [](Vertex& v, std::size_t count) {
    if (v >= 0 && v < static_cast<Vertex>(count)) v = static_cast<Vertex>(count) - 1 - v;
  };
  VoronoiDiagram other = diagram;
  other.sites = PointSet(mirrored(diagram.sites.points()));
  other.vertices = mirrored(diagram.vertices);
  for (auto* const list : {&other.cells, &other.ridges}) {
    std::reverse(list->begin(), list->end());
    for (ListedCell& cell : *list) {
      for (Vertex& v : cell.corners) from_end(v, diagram.vertices.size());
    }
  }
  std::reverse(other.neighbors.begin(), other.neighbors.end());
  for (auto& [a, b] : other.neighbors) {
    from_end(a, diagram.sites.size());
    from_end(b, diagram.sites.size());
  }
  return other;
}

std::map<Rule, std::size_t> counts(const Verdict& verdict) {
  std::map<Rule, std::size_t> counts;
  for (const auto& [rule, tally] : verdict.tallies()) counts[rule] = tally.count;
  return counts;
}

// What a diagram's structure is at the distance 0: points of the open box stand for themselves, and
// everything else for one end.
using ExactEnds = std::set<std::optional<Point>>;
std::optional<Point> exact_end(const JudgedBox& box, const Point& point) {
  for (std::size_t axis = 0; axis < point.size(); ++axis) {
    if (point[axis] <= box.low[axis] || point[axis] >= box.high[axis]) return std::nullopt;
  }
  return point;
}

bool has_exact_structure(const VoronoiDiagram& diagram, const JudgedBox& box,
                         const definition::VoronoiStructure& exact) {
  const std::size_t d = diagram.sites.ambient_dimension();
  ExactEnds vertices, listed;
  for (const auto& [centre, nearest] : exact.vertices) vertices.insert(exact_end(box, centre));
  for (const Point& vertex : diagram.vertices) listed.insert(exact_end(box, vertex));
  vertices.insert(std::nullopt);
  listed.insert(std::nullopt);
  if (vertices != listed) return false;
  std::map<std::array<Vertex, 2>, ExactEnds> own;
  for (const auto& [pair, ridge] : exact.ridges) {
    for (const Point& end : ridge.ends) own[pair].insert(exact_end(box, end));
    if (ridge.leaves_box) own[pair].insert(std::nullopt);
  }
  std::set<std::array<Vertex, 2>> pairs;
  for (std::size_t r = 0; r < diagram.ridges.size(); ++r) {
    const auto& [a, b] = diagram.neighbors[r];
    const std::array<Vertex, 2> pair = {std::min(a, b), std::max(a, b)};
    pairs.insert(pair);
    ExactEnds ends;
    bool are_of_both = true;
    for (const Vertex v : diagram.ridges[r].corners) {
      const auto end = exact_end(box, diagram.vertices[static_cast<std::size_t>(v)]);
      ends.insert(end);
      if (!end) continue;
      const Simplex& nearest = exact.vertices.at(*end);
      are_of_both = are_of_both && contains(nearest, a) && contains(nearest, b);
    }
    if (diagram.ridges[r].is_unbounded) ends.insert(std::nullopt);
    const bool is_small = ends.size() < d && own[pair].size() < d;
    if (ends != own[pair] && !(is_small && (ends.size() < 2 || are_of_both))) return false;
  }
  return std::all_of(own.begin(), own.end(), [&](const auto& ridge) {
    return ridge.second.size() < d || pairs.contains(ridge.first);
  });
}

std::string text(const Verdict& verdict, const Mesh& sites) {
  return report::explanation(verdict, sites) + report::verdict_line(verdict, sites, "m");
}

struct Outcomes {
  std::map<Rule, std::size_t> broken = {};
  std::size_t exact = 0, held = 0;
};

void compare(std::size_t d, int inputs, Outcomes& seen) {
  CHECK(holds("by lemma as by definition", inputs, [&, d] {
    Dice dice(*rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>()));
    const PointSet sites = small_sites(dice, d);
    VoronoiDiagram diagram = exact_diagram(sites);
    const std::size_t faults = dice.below(3);
    const bool has_structure = dice.below(2) == 0;
    if (has_structure && dice.below(2) == 0) list_again(dice, diagram);
    for (std::size_t i = 0; i < faults; ++i) {
      if (has_structure && dice.below(3) > 0) {
        break_a_ridge(dice, diagram);
      } else {
        break_once(dice, diagram);
      }
    }
    std::optional<JudgedBox> box;
    if (dice.below(3) == 0) {
      const Point corner = sites[0];
      box = JudgedBox{corner, corner};
      for (Rational& x : box->low) x -= dice.within(1L, 6L) / Rational(2);
      for (Rational& x : box->high) x += dice.within(1L, 6L) / Rational(2);
    }
    if (!check::fault_of_diagram(diagram, box).empty()) return;
    if (has_structure && !check::fault_of_structure(diagram).empty()) return;
    const Rational allowed = dice.below(3) == 0 ? Rational(0) : Rational(1, 1024);
    const Mesh names = in_rows({sites, {}});
    const Verdict by_lemma = check::judge_voronoi(diagram, box, allowed, false, 0, has_structure);
    const Verdict by_definition =
        check::judge_voronoi(diagram, box, allowed, true, 0, has_structure);
    RC_ASSERT(text(by_lemma, names) == text(by_definition, names));
    std::optional<JudgedBox> turned_box;
    if (box) turned_box = JudgedBox{Rational(-1) * box->high, Rational(-1) * box->low};
    const Verdict turned =
        check::judge_voronoi(turned_round(diagram), turned_box, allowed, false, 0, has_structure);
    RC_ASSERT(counts(turned) == counts(by_lemma));
    RC_ASSERT(turned.voronoi->squared_distance == by_lemma.voronoi->squared_distance);
    if (faults == 0) {
      RC_ASSERT(by_lemma.holds());
      RC_ASSERT(!by_lemma.voronoi->site);
      ++seen.exact;
    }
    seen.held += by_lemma.holds() && by_lemma.voronoi->site ? 1 : 0;
    for (const auto& [rule, tally] : by_lemma.tallies()) ++seen.broken[rule];
  }));
}

Outcomes compare_and_meet_every_rule(std::size_t d, int inputs) {
  Outcomes seen;
  compare(d, inputs, seen);
  CHECK(occurs(seen.exact, static_cast<std::size_t>(inputs) / 10));
  for (const Rule rule : {Rule::kCellDiffers, Rule::kCellMissing, Rule::kVoronoiUnknownVertex,
                          Rule::kVertexUnmatched, Rule::kRidgeMissing, Rule::kRidgeDiffers}) {
    CAPTURE(identifier(rule));
    CHECK(occurs(seen.broken[rule]));
  }
  return seen;
}

TEST_CASE("voronoi: by lemma and by definition the same is said of every diagram in the plane") {
  CHECK(occurs(compare_and_meet_every_rule(2, 600).held, 3));
}

TEST_CASE("voronoi: by lemma and by definition the same is said of every diagram in space") {
  compare_and_meet_every_rule(3, 200);
}

TEST_CASE("voronoi: no site that is far away is forgotten where it cuts a cell") {
  for (const std::size_t d : {2u, 3u}) {
    Dice dice(d);
    std::set<Point> points;
    while (points.size() < (d == 2 ? 40 : 20)) {
      Point point;
      for (std::size_t axis = 0; axis < d; ++axis) point.push_back(dice.within(0L, 99L));
      points.insert(point);
    }
    const PointSet sites({points.begin(), points.end()});
    const JudgedBox box = default_box(sites);
    const check::SitesAround around(sites, box);
    for (Vertex site = 0; sites.names(site); ++site) {
      check::ClippedCell cell(box);
      for (Vertex other = 0; sites.names(other); ++other) {
        if (other != site) cell.cut(definition::nearer_to(sites, site, other));
      }
      CHECK(around.corners_of_cell(site) == cell.corners());
    }
  }
}

// Points of a small grid: cells of several sites meet in a point, or in space in an edge. A side of
// the box goes through a vertex, so that some ridges touch it from within.
TEST_CASE("voronoi: linear programs find the ridges, and which leave the box, as corners do") {
  std::array<std::size_t, 2> seen = {};  // those that do not leave, and those that do
  for (std::uint64_t seed = 0; seed < 9; ++seed) {
    Dice dice(seed);
    const std::size_t d = seed < 8 ? 2 : 3;
    std::set<Point> points;
    while (points.size() < (d == 2 ? 9 : 8)) {
      Point point;
      for (std::size_t axis = 0; axis < d; ++axis)
        point.push_back(dice.within(0L, d == 2 ? 3L : 1L));
      points.insert(point);
    }
    if (d == 3) points.insert({Rational(1, 2), Rational(1, 2), dice.within(2L, 4L)});
    const PointSet sites({points.begin(), points.end()});
    JudgedBox box = default_box(sites);
    const auto whole = definition::exact_structure(sites, box);
    box.high[0] = whole.vertices.rbegin()->first[0];
    const auto exact = definition::exact_structure(sites, box);
    std::vector<std::vector<Point>> cells;
    for (Vertex site = 0; sites.names(site); ++site) {
      cells.push_back(definition::exact_corners(sites, site, box));
    }
    const auto by_corners = check::structure_by_corners(sites, cells);
    REQUIRE(exact.ridges.size() == by_corners.ridges.size());
    for (const auto& [pair, ridge] : exact.ridges) {
      const auto other = by_corners.ridges.find(pair);
      REQUIRE(other != by_corners.ridges.end());
      CHECK(ridge.ends == other->second.ends);
      CHECK(ridge.leaves_box == other->second.leaves_box);
      ++seen[ridge.leaves_box ? 1 : 0];
    }
  }
  CHECK(seen[0] > 20);
  CHECK(seen[1] > 20);
}

// A ridge with another end, without one of its ends, or unbounded and not.
std::vector<VoronoiDiagram> with_ridge_changed(const VoronoiDiagram& diagram, std::size_t r) {
  std::vector<VoronoiDiagram> changed(1, diagram);
  changed[0].ridges[r].is_unbounded = !diagram.ridges[r].is_unbounded;
  for (std::size_t i = 0; i < diagram.ridges[r].corners.size(); ++i) {
    changed.push_back(diagram);
    std::vector<Vertex>& corners = changed.back().ridges[r].corners;
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i));
  }
  for (std::size_t v = 0; v < diagram.vertices.size(); ++v) {
    changed.push_back(diagram);
    changed.back().ridges[r].corners.push_back(static_cast<Vertex>(v));
  }
  return changed;
}

// On a grid many sites are on one circle, so there are ridges of a single point. For every other
// seed a side of the box goes through a vertex, which is outside then.
TEST_CASE("voronoi: at the distance 0 a ridge has the ends that it should have, and no others") {
  std::array<std::size_t, 2> seen = {};
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Dice dice(seed);
    std::set<Point> points;
    while (points.size() < 6) points.insert({dice.within(0L, 2L), dice.within(0L, 2L)});
    const VoronoiDiagram diagram = exact_diagram(PointSet({points.begin(), points.end()}));
    JudgedBox box = default_box(diagram.sites);
    if (seed % 2 == 0) {
      box.high[0] = definition::exact_structure(diagram.sites, box).vertices.rbegin()->first[0];
    }
    const auto exact = definition::exact_structure(diagram.sites, box);
    const auto holds = [&](const VoronoiDiagram& other) {
      Verdict verdict(Claim::kVoronoi, 0);
      verdict.voronoi.emplace();
      check::judge_structure(other, box, 0, exact, false, verdict);
      return verdict.holds();
    };
    CHECK(holds(diagram));
    for (std::size_t r = 0; r < diagram.ridges.size(); ++r) {
      for (const VoronoiDiagram& other : with_ridge_changed(diagram, r)) {
        const bool is_exact = has_exact_structure(other, box, exact);
        CHECK(holds(other) == is_exact);
        ++seen[is_exact ? 1 : 0];
      }
    }
  }
  CHECK(seen[0] > 50);
  CHECK(seen[1] > 50);
}

}  // namespace
}  // namespace circumspect::properties::voronoi
