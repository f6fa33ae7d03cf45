// The claim `voronoi`: by lemma and by definition the same is said, word for word, of diagrams that
// are exact, rounded, or broken, in the plane and in space. Proof: docs/theory/questions.md.
#include <map>
#include <set>

#include <doctest/doctest.h>

#include "inputs/dice.hpp"
#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/circumball.hpp"
#include "oracle/judge/voronoi/judge_structure.hpp"
#include "oracle/judge/voronoi/judge_voronoi.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/report/text.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::properties::voronoi {
namespace {

using generators::Dice;

PointSet small_sites(Dice& dice, std::size_t d) {
  std::set<Point> points;
  const std::size_t count = d + 1 + dice.below(d == 2 ? 6 : 3);
  while (points.size() < count) {
    Point point;
    for (std::size_t axis = 0; axis < d; ++axis) point.push_back(dice.within(0L, 5L));
    points.insert(point);
  }
  return PointSet({points.begin(), points.end()});
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
    if (sites.dimension() < static_cast<int>(d)) return;
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
    if (faults == 0) {
      RC_ASSERT(by_lemma.holds());
      RC_ASSERT(!by_lemma.voronoi->site);
      ++seen.exact;
    }
    seen.held += by_lemma.holds() && by_lemma.voronoi->site ? 1 : 0;
    for (const auto& [rule, tally] : by_lemma.tallies()) ++seen.broken[rule];
  }));
}

TEST_CASE("voronoi: by lemma and by definition the same is said of every diagram") {
  Outcomes seen;
  compare(2, 600, seen);
  compare(3, 16, seen);
  CHECK(occurs(seen.exact, 60));
  CHECK(occurs(seen.held, 3));
  for (const Rule rule : {Rule::kCellDiffers, Rule::kCellMissing, Rule::kVoronoiUnknownVertex,
                          Rule::kVertexUnmatched, Rule::kRidgeMissing, Rule::kRidgeDiffers}) {
    CAPTURE(identifier(rule));
    CHECK(occurs(seen.broken[rule]));
  }
}

}  // namespace
}  // namespace circumspect::properties::voronoi
