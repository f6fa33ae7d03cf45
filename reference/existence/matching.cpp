#include "reference/existence/matching.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <map>
#include <optional>
#include <set>

#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/intersection.hpp"
#include "kernel/predicates/orientation.hpp"

namespace circumspect::existence {

namespace {

bool is_degenerate(const PiecewiseLinearComplex& complex, const Simplex& simplex) {
  return axes_of(complex.points.configuration(), simplex).size() + 1 < simplex.size();
}

// The simplices of one dimension more whose facets are all among these, and which respect the
// complex. A face of a simplex that respects a complex does so too, and the domain is closed.
std::vector<Simplex> grown(const PiecewiseLinearComplex& complex, const Regions& regions,
                           const std::vector<Simplex>& simplices) {
  const std::set<Simplex> faces(simplices.begin(), simplices.end());
  std::vector<Simplex> larger;
  for (const Simplex& simplex : simplices) {
    for (Vertex v = simplex.back() + 1; complex.points.names(v); ++v) {
      Simplex candidate = simplex;
      candidate.push_back(v);
      bool has_facets = true;
      for (std::size_t place = 0; place < candidate.size() && has_facets; ++place) {
        has_facets = faces.contains(facet_opposite(candidate, place));
      }
      if (has_facets && !is_degenerate(complex, candidate) &&
          respects(complex, regions, candidate)) {
        larger.push_back(candidate);
      }
    }
  }
  return larger;
}

bool is_constrained_delaunay(const PiecewiseLinearComplex& complex, const Regions& regions,
                             const Simplex& tetrahedron) {
  for (Vertex v = 0; complex.points.names(v); ++v) {
    if (!contains(tetrahedron, v) &&
        in_ball(complex.points.configuration(), kSpace, tetrahedron, v) > 0 &&
        is_visible(complex, regions, v, tetrahedron)) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::vector<Simplex> respecting_tetrahedra(const PiecewiseLinearComplex& complex,
                                           const Regions& regions) {
  std::vector<Simplex> simplices;
  for (Vertex v = 0; complex.points.names(v); ++v) simplices.push_back({v});
  for (int dimension = 1; dimension <= 3; ++dimension) {
    simplices = grown(complex, regions, simplices);
  }
  return simplices;
}

std::vector<Simplex> constrained_delaunay_tetrahedra(const PiecewiseLinearComplex& complex,
                                                     const Regions& regions) {
  std::vector<Simplex> tetrahedra = respecting_tetrahedra(complex, regions);
  std::erase_if(tetrahedra, [&](const Simplex& tetrahedron) {
    return !is_constrained_delaunay(complex, regions, tetrahedron);
  });
  return tetrahedra;
}

namespace {

class Matching {
 public:
  Matching(const PiecewiseLinearComplex& complex, const Regions& regions,
           const std::vector<Simplex>& tetrahedra)
      : complex_(complex), regions_(regions), walls_(walls(complex)) {
    formula_.variables = static_cast<int>(tetrahedra.size());
    for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
      for (std::size_t place = 0; place < 4; ++place) {
        const Simplex facet = facet_opposite(tetrahedra[i], place);
        users_[{facet, side(facet, tetrahedra[i][place]) < 0}].push_back(static_cast<Literal>(i) +
                                                                         1);
      }
    }
  }

  Formula formula() {
    for (const auto& [facet, users] : users_) {
      at_most_one(users);
      match(facet, users);
    }
    cover_regions();
    if (complex_.kind == DomainKind::kHull) cover_hull();
    return std::move(formula_);
  }

 private:
  int side(const Simplex& facet, Vertex v) const {
    return side_of_facet(complex_.points.configuration(), kSpace, facet, v);
  }

  void at_most_one(const std::vector<Literal>& tetrahedra) {
    for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        formula_.clauses.push_back({-tetrahedra[i], -tetrahedra[j]});
      }
    }
  }

  bool is_on_hull(const OrientedFacet& facet) const {
    for (Vertex v = 0; complex_.points.names(v); ++v) {
      if (side(facet.vertices, v) == -facet.front()) return false;
    }
    return true;
  }

  // The wall in which a facet lies, if any. A facet of a tetrahedron that respects the complex lies
  // in a polygon as soon as its barycentre does.
  std::optional<Simplex> wall_of(const Simplex& facet) const {
    const Point centre = barycentre(complex_.points, facet);
    for (const Simplex& wall : walls_) {
      if (std::any_of(facet.begin(), facet.end(), [&](Vertex v) { return side(wall, v) != 0; })) {
        continue;
      }
      if (!intersection(coordinates(complex_.points, wall), {centre}).empty()) return wall;
    }
    return std::nullopt;
  }

  // The side of one facet that faces the same way as a given side of another facet in its plane.
  int same_side(const OrientedFacet& facet, const Simplex& coplanar) const {
    for (Vertex v = 0; complex_.points.names(v); ++v) {
      if (const int s = side(facet.vertices, v); s != 0) {
        return s == facet.front() ? side(coplanar, v) : -side(coplanar, v);
      }
    }
    assert(false);
    return 0;
  }

  // Is some of the domain on the other side of a facet?
  bool has_domain_beyond(const OrientedFacet& facet) const {
    if (complex_.kind == DomainKind::kHull) return !is_on_hull(facet);
    const std::optional<Simplex> wall = wall_of(facet.vertices);
    if (!wall) return true;
    const OrientedFacet beyond{*wall, same_side(facet, *wall) > 0};
    return regions_.faces_inside(beyond);
  }

  void match(const OrientedFacet& facet, const std::vector<Literal>& users) {
    const auto across = users_.find(facet.reverse());
    if (!has_domain_beyond(facet)) return;
    for (const Literal user : users) {
      Clause clause = {-user};
      if (across != users_.end()) {
        clause.insert(clause.end(), across->second.begin(), across->second.end());
      }
      formula_.clauses.push_back(clause);
    }
  }

  // Exactly one of the tetrahedra that reach a generic point of a facet from its side.
  void cover(const OrientedFacet& facet) {
    for (long weight = 1;; ++weight) {
      // Points along a curve in the facet; a line contains at most three of them.
      const Rational a = Rational(1, 3 + weight), b = Rational(1, 3 + weight * weight);
      const Point point = a * complex_.points[facet.vertices[0]] +
                          b * complex_.points[facet.vertices[1]] +
                          (1 - a - b) * complex_.points[facet.vertices[2]];
      if (const auto clause = that_reach(facet, point)) {
        formula_.clauses.push_back(*clause);
        at_most_one(*clause);
        return;
      }
    }
  }

  // The tetrahedra on one side of a facet whose own facets in its plane hold the point; nothing if
  // it lies on the edge of one.
  std::optional<Clause> that_reach(const OrientedFacet& facet, const Point& point) const {
    Clause clause;
    for (const auto& [other, users] : users_) {
      const bool is_coplanar = std::all_of(other.vertices.begin(), other.vertices.end(),
                                           [&](Vertex v) { return side(facet.vertices, v) == 0; });
      if (!is_coplanar || same_side(facet, other.vertices) != other.front()) continue;
      const std::vector<Point> corners = coordinates(complex_.points, other.vertices);
      if (intersection(corners, {point}).empty()) continue;
      for (std::size_t place = 0; place < 3; ++place) {
        std::vector<Point> edge = corners;
        edge.erase(edge.begin() + static_cast<std::ptrdiff_t>(place));
        if (!intersection(edge, {point}).empty()) return std::nullopt;
      }
      clause.insert(clause.end(), users.begin(), users.end());
    }
    return clause;
  }

  // Once for each region of the domain, at some wall of it.
  void cover_regions() {
    std::set<std::size_t> covered;
    for (const Simplex& wall : walls_) {
      for (const bool reversed : {false, true}) {
        const OrientedFacet facet{wall, reversed};
        const std::size_t region = regions_.in_front_of(facet);
        if (regions_.where(region) != Where::kInside || covered.contains(region)) continue;
        // The part of a hull in the unbounded region may have several components, or be empty.
        if (complex_.kind == DomainKind::kHull && is_on_hull(facet.reverse())) continue;
        if (complex_.kind == DomainKind::kEnclosed) covered.insert(region);
        cover(facet);
      }
    }
  }

  // Every facet on the hull is reached from within once, and there must be some.
  void cover_hull() {
    bool has_facet = complex_.points.dimension() < 3;
    for (const auto& [facet, users] : users_) {
      if (!is_on_hull(facet)) continue;
      has_facet = true;
      cover(facet);
    }
    if (!has_facet) formula_.clauses.push_back({});
  }

  const PiecewiseLinearComplex& complex_;
  const Regions& regions_;
  std::vector<Simplex> walls_;
  std::map<OrientedFacet, std::vector<Literal>> users_;
  Formula formula_;
};

}  // namespace

Formula matching_formula(const PiecewiseLinearComplex& complex, const Regions& regions,
                         const std::vector<Simplex>& tetrahedra) {
  return Matching(complex, regions, tetrahedra).formula();
}

}  // namespace circumspect::existence
