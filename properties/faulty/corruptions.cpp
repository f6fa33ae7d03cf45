// Right meshes, spoilt afterwards, in the ways that bookkeeping goes wrong.
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/orientation.hpp"
#include "properties/faulty/fault.hpp"
#include "properties/faulty/plain_predicates.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/flip.hpp"
#include "reference/delaunay/flip_algorithm.hpp"
#include "reference/delaunay/lexicographic.hpp"

namespace circumspect::faulty {
namespace {

using Simplices = std::vector<Simplex>;

SimplexArray rows(const Simplices& simplices) {
  return SimplexArray(simplices.begin(), simplices.end());
}

Simplices simplices_of(const PointArray& points) {
  const SimplexArray right = right_answer(points);
  return Simplices(right.begin(), right.end());
}

// Spoils the canonical triangulation of points that span at least a plane.
using Spoil = std::function<void(const PointSet&, Simplices&)>;

Fault by(std::string name, std::string about, const Spoil& spoil) {
  return {std::move(name), std::move(about), Kind::kCorruption, Claim::kDelaunay,
          [spoil](const PointArray& points) {
            Simplices simplices = simplices_of(points);
            const PointSet set = exact_points(points);
            if (set.dimension() >= 2) spoil(set, simplices);
            return rows(simplices);
          }};
}

// How many facets of each simplex are on the boundary.
std::vector<std::size_t> hull_facets(const Simplices& simplices) {
  std::vector<std::size_t> count(simplices.size());
  for (const auto uses : ByFacet(facet_uses(simplices))) {
    if (uses.size() == 1) ++count[uses[0].simplex];
  }
  return count;
}

void lose_one(Simplices& simplices, bool at_the_hull) {
  const std::vector<std::size_t> hull = hull_facets(simplices);
  for (std::size_t i = 0; i < hull.size(); ++i) {
    if ((hull[i] > 0) != at_the_hull) continue;
    simplices.erase(simplices.begin() + static_cast<std::ptrdiff_t>(i));
    return;
  }
}

void list_first_twice(const PointSet&, Simplices& simplices) {
  Simplex again = simplices.front();
  std::reverse(again.begin(), again.end());
  simplices.push_back(again);
}

// The first flip that is possible, with one of the deleted simplices left in.
void flip_and_forget(const PointSet& points, Simplices& simplices) {
  const StarIndex mesh(simplices);
  for (const Simplex& facet : facets_of(simplices)) {
    if (mesh.star(facet).size() < 2) continue;
    const auto flip = delaunay::extended_flip(mesh, delaunay::flip_of_facet(points, mesh, facet));
    if (!flip) continue;
    StarIndex after = mesh;
    after.replace(flip->deleted, flip->created);
    simplices.assign(after.simplices().begin(), after.simplices().end());
    simplices.push_back(flip->deleted.front());
    return;
  }
}

void add_other_triangulation(const PointSet& points, Simplices& simplices) {
  const std::set<Simplex> right(simplices.begin(), simplices.end());
  const Triangulation other = delaunay::lexicographic(points);
  for (const Simplex& simplex : other.simplices()) {
    if (!right.contains(simplex)) simplices.push_back(simplex);
  }
}

// The upper hull of the lifted points is the lower one of the negated heights: w = 2|p|².
void add_upper_hull(const PointSet& points, Simplices& simplices) {
  std::vector<Rational> weights;
  for (const Point& p : points.points()) weights.push_back(2 * squared_length(p));
  const Triangulation upper = delaunay::bowyer_watson(PointSet(points.points(), weights));
  simplices.insert(simplices.end(), upper.simplices().begin(), upper.simplices().end());
}

// Two facets of the hull in one plane that share a ridge: the flat simplex of their vertices.
void add_flat_simplex(const PointSet& points, Simplices& simplices) {
  Simplices hull;
  for (const auto uses : ByFacet(facet_uses(simplices))) {
    if (uses.size() == 1) hull.push_back(uses[0].facet);
  }
  for (std::size_t a = 0; a < hull.size(); ++a) {
    for (std::size_t b = a + 1; b < hull.size(); ++b) {
      std::set<Vertex> both(hull[a].begin(), hull[a].end());
      both.insert(hull[b].begin(), hull[b].end());
      const Simplex flat(both.begin(), both.end());
      if (flat.size() != hull[a].size() + 1) continue;
      if (orientation(points.configuration(), flat) == 0) return simplices.push_back(flat);
    }
  }
}

// Behind a facet of the hull goes a second simplex, on the same side as the first, with an apex
// outside the ball of the first: a test that looks from one side only finds the facet locally
// Delaunay.
void fold_at_the_hull(const PointSet& points, Simplices& simplices) {
  Simplices folded;
  const auto apex_for = [&](const FacetUse& use) {
    const Simplex& simplex = simplices[use.simplex];
    for (Vertex v = 0; points.names(v); ++v) {
      if (contains(simplex, v) || in_ball(points.configuration(), simplex, v) > 0) continue;
      const Simplex other = with_vertex_replaced(simplex, use.opposite, v);
      if (orientation(points.configuration(), other) ==
          orientation(points.configuration(), simplex)) {
        folded.push_back(other);
        return;
      }
    }
  };
  for (const auto uses : ByFacet(facet_uses(simplices))) {
    if (uses.size() == 1 && folded.empty()) apex_for(uses[0]);
  }
  simplices.insert(simplices.end(), folded.begin(), folded.end());
}

// Of two neighbours on one sphere only the first is written.
void cut_cospherical_cells_short(const PointSet& points, Simplices& simplices) {
  std::set<std::size_t> dropped;
  for (const auto uses : ByFacet(facet_uses(simplices))) {
    if (uses.size() < 2) continue;
    const auto [one, other] = std::minmax(uses[0].simplex, uses[1].simplex);
    const FacetUse& far = uses[0].simplex == other ? uses[0] : uses[1];
    if (in_ball(points.configuration(), simplices[one], simplices[other][far.opposite]) == 0) {
      dropped.insert(other);
    }
  }
  Simplices kept;
  for (std::size_t i = 0; i < simplices.size(); ++i) {
    if (!dropped.contains(i)) kept.push_back(simplices[i]);
  }
  simplices = kept;
}

// The simplices whose barycentre is halfway between the least and the largest abscissa.
Simplices on_the_seam(const PointSet& points, const Simplices& simplices) {
  Rational low = points[0][0], high = low;
  for (const Point& p : points.points()) {
    low = std::min(low, p[0]);
    high = std::max(high, p[0]);
  }
  Simplices on_it;
  for (const Simplex& simplex : simplices) {
    Rational sum = 0;
    for (const Vertex v : simplex) sum += points[v][0];
    if (2 * sum == (low + high) * static_cast<long>(simplex.size())) on_it.push_back(simplex);
  }
  return on_it;
}

void leave_out_the_seam(const PointSet& points, Simplices& simplices) {
  for (const Simplex& simplex : on_the_seam(points, simplices)) {
    std::erase(simplices, simplex);
  }
}

void list_the_seam_twice(const PointSet& points, Simplices& simplices) {
  const Simplices again = on_the_seam(points, simplices);
  simplices.insert(simplices.end(), again.begin(), again.end());
}

void mix_orientations(const PointSet& points, Simplices& simplices) {
  for (Simplex& simplex : simplices) simplex = positively_oriented(points, simplex);
  for (std::size_t i = 1; i < simplices.size(); i += 2) {
    std::swap(simplices[i][0], simplices[i][1]);
  }
}

// Some vertex that is not on the hull, if there is one.
std::optional<Vertex> inner_vertex(const PointSet& points, const Simplices& simplices) {
  std::set<Vertex> outer;
  for (const auto uses : ByFacet(facet_uses(simplices))) {
    if (uses.size() == 1) outer.insert(uses[0].facet.begin(), uses[0].facet.end());
  }
  for (Vertex v = 0; points.names(v); ++v) {
    if (!outer.contains(v)) return v;
  }
  return std::nullopt;
}

// Its star is replaced by the triangulation of all other points.
void forget_inner_vertex(const PointSet& points, Simplices& simplices) {
  const auto v = inner_vertex(points, simplices);
  if (!v) return;
  std::vector<Point> others = points.points();
  others.erase(others.begin() + *v);
  simplices = delaunay::bowyer_watson(PointSet(others)).simplices();
  for (Simplex& simplex : simplices) {
    for (Vertex& w : simplex) w += w >= *v ? 1 : 0;
  }
}

// In the plane: an inner vertex, and all others around it, two steps of the angle at a time.
void wind_twice(const PointSet& points, Simplices& simplices) {
  const auto centre = inner_vertex(points, simplices);
  if (!centre || points.size() % 2 != 0 || points.size() < 6) return;
  std::vector<Vertex> order;
  for (Vertex v = 0; points.names(v); ++v) {
    if (v != *centre) order.push_back(v);
  }
  const auto angle = [&](Vertex v) {
    const Point way = points[v] - points[*centre];
    return std::atan2(way[1].get_d(), way[0].get_d());
  };
  std::stable_sort(order.begin(), order.end(),
                   [&angle](Vertex a, Vertex b) { return angle(a) < angle(b); });
  simplices.clear();
  for (std::size_t i = 0; i < order.size(); ++i) {
    simplices.push_back({*centre, order[i], order[(i + 2) % order.size()]});
  }
}

std::vector<Fault> corruptions_of_any_dimension() {
  return {
      by("simplex-listed-twice", "One simplex is written twice, its vertices in another order.",
         list_first_twice),
      by("hole-inside", "A simplex of the interior is lost: a recycled slot of an array.",
         [](const PointSet&, Simplices& simplices) { lose_one(simplices, false); }),
      by("hull-simplex-lost", "A simplex at the hull is lost: taken for one of the outside.",
         [](const PointSet&, Simplices& simplices) { lose_one(simplices, true); }),
      by("flip-keeps-a-simplex",
         "A flip creates its simplices and deletes all but one of the old: two simplices overlap.",
         flip_and_forget),
      by("covered-by-two-triangulations",
         "What was there before the flips is still there after them, with the other diagonals: "
         "output that is not cleared.",
         add_other_triangulation),
      by("upper-hull-too",
         "Of the convex hull of the lifted points all facets are written, not only the lower ones: "
         "everything is covered twice, the second time by the furthest-point triangulation.",
         add_upper_hull),
      by("flat-simplices-kept",
         "Flat simplices of coplanar points on the hull stay in the output: joggled input, or "
         "flips "
         "that leave them behind.",
         add_flat_simplex),
      by("folded-at-the-hull",
         "A simplex lies over another, on the same side of a hull facet, though a test from one "
         "side finds the facet locally Delaunay.",
         fold_at_the_hull),
      by("cospherical-cells-cut-short",
         "Of a cell of cospherical points one simplex is written, and not the others: facets of a "
         "hull code that are not simplices.",
         cut_cospherical_cells_short),
      by("seam-owned-by-nobody",
         "Two processes write the simplices with barycentres left and right of a border, `<` and "
         "`>`: those on it are lost.",
         leave_out_the_seam),
      by("seam-owned-twice", "The same with `<=` and `>=`: both processes write them.",
         list_the_seam_twice),
      by("inner-vertex-forgotten",
         "An inner vertex was deleted, and is still in the list of points.", forget_inner_vertex),
  };
}

}  // namespace

std::vector<Fault> corruptions() {
  std::vector<Fault> all = corruptions_of_any_dimension();
  Fault mixed = by("orientations-mixed",
                   "Every other simplex lists its vertices the other way round: faces swapped by "
                   "flips. The program promises one orientation.",
                   mix_orientations);
  mixed.oriented = true;
  all.push_back(mixed);
  Fault fan = by("doubly-winding-fan",
                 "A fan around a vertex that winds around it twice: angles sorted with a step too "
                 "many. All triangles are of one orientation, and every inner edge has two.",
                 wind_twice);
  fan.dimensions = {2};
  all.push_back(fan);
  return all;
}

}  // namespace circumspect::faulty
