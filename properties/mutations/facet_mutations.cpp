#include <algorithm>
#include <optional>

#include "kernel/exact/each_once.hpp"
#include "properties/mutations/catalogue.hpp"

namespace circumspect::properties {
namespace {

using enum Rule;
using Row = std::vector<std::int64_t>;

constexpr int kTries = 200;
const std::set<Rule> kHoles = {kUnusedPoint, kHullNotClosed, kHullNotConvex, kPointBelowPlane};
const std::set<Rule> kFolds = {kDegenerateSimplex, kDuplicateSimplex, kFacetOverused, kOverlap};

Row row_of(const ArrayMesh& mesh, std::size_t s) {
  return Row(mesh.row(s).begin(), mesh.row(s).end());
}

void drop(ArrayMesh& mesh, std::vector<std::size_t> simplices) {
  keep_each_once(simplices);
  for (auto s = simplices.rbegin(); s != simplices.rend(); ++s) {
    const auto begin = mesh.simplices.begin() + static_cast<std::ptrdiff_t>(*s * mesh.width());
    mesh.simplices.erase(begin, begin + static_cast<std::ptrdiff_t>(mesh.width()));
  }
  mesh.neighbors.clear();
}

void add(ArrayMesh& mesh, const Row& row) {
  mesh.simplices.insert(mesh.simplices.end(), row.begin(), row.end());
  mesh.neighbors.clear();
}

// Two simplices that share a facet, and the simplices that a flip would join: the join
// of the edge between their apexes with a ridge of the facet.
struct Pair {
  std::size_t first, second;
  std::vector<Row> created;
  bool convex = true;  // the facet and that edge cross in a point inside both
  bool strict = true;  // neither apex is on the sphere of the other simplex
};

Pair pair_at(const ArrayMesh& mesh, std::size_t facet) {
  const std::size_t other = other_side(mesh, facet);
  Pair pair{facet / mesh.width(), other / mesh.width(), {}};
  const Row row = row_of(mesh, pair.first);
  const std::int64_t apex = mesh.simplices[other];
  const int own = orientation_of(mesh, row);
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (i == facet % mesh.width()) continue;
    pair.created.push_back(row);
    pair.created.back()[i] = apex;
    pair.convex &= orientation_of(mesh, pair.created.back()) == own;
  }
  pair.strict = in_ball_of(mesh, row, apex) < 0;
  return pair;
}

std::optional<Pair> any_pair(const ArrayMesh& mesh, Dice& dice, bool convex) {
  for (int i = 0; i < kTries; ++i) {
    const std::size_t facet = dice.below(mesh.neighbors.size());
    if (mesh.neighbors[facet] < 0) continue;
    Pair pair = pair_at(mesh, facet);
    if (pair.convex == convex && pair.strict) return pair;
  }
  return std::nullopt;
}

bool flip(ArrayMesh& mesh, Dice& dice, bool convex) {
  const auto pair = any_pair(mesh, dice, convex);
  if (!pair) return false;
  drop(mesh, {pair->first, pair->second});
  for (const Row& row : pair->created) add(mesh, row);
  return true;
}

bool flip_rightly(ArrayMesh& mesh, Dice& dice) { return flip(mesh, dice, true); }
bool flip_wrongly(ArrayMesh& mesh, Dice& dice) { return flip(mesh, dice, false); }

bool flip_and_forget_one(ArrayMesh& mesh, Dice& dice) {
  const auto pair = any_pair(mesh, dice, true);
  if (!pair) return false;
  drop(mesh, {pair->first, pair->second});
  for (std::size_t i = 1; i < pair->created.size(); ++i) add(mesh, pair->created[i]);
  return true;
}

bool flip_and_keep_one(ArrayMesh& mesh, Dice& dice) {
  const auto pair = any_pair(mesh, dice, true);
  if (!pair) return false;
  drop(mesh, {pair->first});
  for (const Row& row : pair->created) add(mesh, row);
  return true;
}

bool merge_two(ArrayMesh& mesh, Dice& dice) {
  const auto pair = any_pair(mesh, dice, dice.below(2) == 0);
  if (!pair) return false;
  drop(mesh, {pair->first, pair->second});
  add(mesh, pair->created[dice.below(pair->created.size())]);
  return true;
}

bool drop_with_neighbors(ArrayMesh& mesh, Dice& dice) {
  const std::size_t s = dice.below(mesh.size());
  std::vector<std::size_t> gone{s};
  for (std::size_t i = 0; i < mesh.width(); ++i) {
    const std::int64_t link = mesh.neighbors[s * mesh.width() + i];
    if (link >= 0) gone.push_back(static_cast<std::size_t>(link));
  }
  drop(mesh, gone);
  return true;
}

bool has_all(std::span<const std::int64_t> row, const Row& vertices) {
  return std::all_of(vertices.begin(), vertices.end(), [&](std::int64_t v) {
    return std::find(row.begin(), row.end(), v) != row.end();
  });
}

void drop_star(ArrayMesh& mesh, const Row& vertices) {
  std::vector<std::size_t> star;
  for (std::size_t s = 0; s < mesh.size(); ++s) {
    if (has_all(mesh.row(s), vertices)) star.push_back(s);
  }
  drop(mesh, star);
}

bool drop_star_of_vertex(ArrayMesh& mesh, Dice& dice) {
  drop_star(mesh, {mesh.simplices[dice.below(mesh.simplices.size())]});
  return true;
}

bool drop_star_of_edge(ArrayMesh& mesh, Dice& dice) {
  const auto row = mesh.row(dice.below(mesh.size()));
  const std::size_t a = dice.below(row.size());
  drop_star(mesh, {row[a], row[(a + 1 + dice.below(row.size() - 1)) % row.size()]});
  return true;
}

std::size_t any_boundary_facet(const ArrayMesh& mesh, Dice& dice) {
  std::size_t facet = dice.below(mesh.neighbors.size());
  while (mesh.neighbors[facet] >= 0) facet = (facet + 1) % mesh.neighbors.size();
  return facet;
}

bool drop_at_the_hull(ArrayMesh& mesh, Dice& dice) {
  drop(mesh, {any_boundary_facet(mesh, dice) / mesh.width()});
  return true;
}

// In space: what remains has the two other facets of the simplex for boundary facets.
bool flip_edge_of_the_hull(ArrayMesh& mesh, Dice& dice) {
  const std::size_t start = dice.below(mesh.size());
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const std::size_t s = (start + i) % mesh.size();
    const auto links = std::span(mesh.neighbors).subspan(s * mesh.width(), mesh.width());
    if (std::count(links.begin(), links.end(), -1) != 2) continue;
    drop(mesh, {s});
    return true;
  }
  return false;
}

// The vertex off the ridge of the other boundary facet at a ridge: the ridge is the simplex without
// the vertex opposite the facet and the one at place `off`.
std::int64_t far_vertex(const ArrayMesh& mesh, std::size_t facet, std::size_t off) {
  std::size_t s = facet / mesh.width(), apex = facet % mesh.width();
  while (mesh.neighbors[s * mesh.width() + off] >= 0) {
    const std::size_t across = other_side(mesh, s * mesh.width() + off);
    const std::int64_t behind = mesh.row(s)[apex];
    s = across / mesh.width();
    apex = across % mesh.width();
    off = static_cast<std::size_t>(std::find(mesh.row(s).begin(), mesh.row(s).end(), behind) -
                                   mesh.row(s).begin());
  }
  return mesh.row(s)[apex];
}

bool cover_edge_of_the_hull(ArrayMesh& mesh, Dice& dice) {
  const std::size_t facet = any_boundary_facet(mesh, dice), place = facet % mesh.width();
  const std::size_t off = (place + 1 + dice.below(mesh.dimension)) % mesh.width();
  Row ear = row_of(mesh, facet / mesh.width());
  ear[place] = far_vertex(mesh, facet, off);
  add(mesh, ear);
  return true;
}

bool fold_at_the_hull(ArrayMesh& mesh, Dice& dice) {
  const std::size_t facet = any_boundary_facet(mesh, dice), place = facet % mesh.width();
  const Row row = row_of(mesh, facet / mesh.width());
  const int own = orientation_of(mesh, row);
  for (int i = 0; i < kTries; ++i) {
    Row folded = row;
    folded[place] = mesh.simplices[dice.below(mesh.simplices.size())];
    if (has_all(row, {folded[place]}) || orientation_of(mesh, folded) != own) continue;
    add(mesh, folded);
    return true;
  }
  return false;
}

}  // namespace

std::vector<Mutation> facet_mutations() {
  return {
      {"flipped",
       "Two simplices are flipped, as they may be: not Delaunay any more.",
       Expected::kFails,
       {kFacetNotLocal, kVertexSubmerged},
       flip_rightly},
      {"flipped-not-convex", "Two simplices are flipped though their union is not convex.",
       Expected::kFails, kFolds, flip_wrongly},
      {"flip-forgets-one", "Of what a flip creates one simplex is not listed.", Expected::kFails,
       kHoles, flip_and_forget_one},
      {"flip-keeps-one", "Of what a flip deletes one simplex stays.", Expected::kFails, kFolds,
       flip_and_keep_one},
      {"two-merged",
       "One simplex of the vertices of two takes the place of both.",
       Expected::kFails,
       {kDegenerateSimplex, kDuplicateSimplex, kUnusedPoint, kFacetOverused, kOverlap,
        kHullNotClosed, kHullNotConvex, kPointBelowPlane},
       merge_two},
      {"cavity", "A simplex and all its neighbours are missing.", Expected::kFails, kHoles,
       drop_with_neighbors},
      {"star-of-vertex-dropped", "All simplices with one vertex are missing.", Expected::kFails,
       kHoles, drop_star_of_vertex},
      {"star-of-edge-dropped", "All simplices with one edge are missing.", Expected::kFails, kHoles,
       drop_star_of_edge},
      {"hull-simplex-dropped", "A simplex with a facet of the hull is missing.", Expected::kFails,
       kHoles, drop_at_the_hull},
      {"hull-flipped", "A simplex with two facets of the hull is missing.", Expected::kFails,
       kHoles, flip_edge_of_the_hull},
      {"hull-edge-covered", "Two facets of the hull have one more simplex, on their inner side.",
       Expected::kFails, kFolds, cover_edge_of_the_hull},
      {"folded-at-the-hull", "A facet of the hull has a second simplex, on its inner side.",
       Expected::kFails, kFolds, fold_at_the_hull},
  };
}

}  // namespace circumspect::properties
