// Visibility, decided exactly. Book: Definition 2.13, quoted in Section 4.5.2: two points x and y
// are visible to each other if xy respects P, that is, xy ⊆ |P| and no linear cell occludes: none
// intersects the relative interior of xy without including xy.
//
// Let σ respect P, let v be a vertex of P but not of σ, and H = aff(v ∪ σ), of dimension k. A line
// of sight goes from v through relint σ; the directions of all of them are an open set of dimension
// k − 1. Is v visible from a point of relint σ? In three steps, which the functions below justify:
//
// 1. `entrances`: the faces φ of σ through which lines of sight enter σ.
// 2. `unoccluded_point`: the part of each φ that no cell before it occludes; and a point in it.
// 3. `opens_into_domain`, `is_in_domain`: does |P| contain the way from there to v?
#include "kernel/piecewise_linear/visibility.hpp"

#include <algorithm>

#include "kernel/predicates/intersection.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/place.hpp"

namespace circumspect {
namespace {

class Visibility {
 public:
  Visibility(const PiecewiseLinearComplex& complex, const Regions& regions, Vertex v,
             const Simplex& simplex)
      : complex_(complex), regions_(regions), v_(v), simplex_(sorted(simplex)) {
    Simplex all = simplex_;
    all.push_back(v_);
    v_is_in_hull_ = axes_of(points().configuration(), all).size() < simplex_.size();
  }

  // A point of relint σ from which v is visible.
  std::optional<Point> point() const {
    if (simplex_.size() == 1) {
      const bool sees = respects(complex_, regions_, {simplex_[0], v_});
      return sees ? std::optional(points()[simplex_[0]]) : std::nullopt;
    }
    const bool is_facet = !v_is_in_hull_ && simplex_.size() == dimension();
    if (is_facet && !opens_into_domain()) return std::nullopt;
    for (const Simplex& face : entrances()) {
      const auto x = unoccluded_point(face);
      if (x && (v_is_in_hull_ || is_facet || is_in_domain(*x))) return x;
    }
    return std::nullopt;
  }

 private:
  const PointSet& points() const { return complex_.points; }
  std::size_t dimension() const { return complex_.ambient_dimension(); }
  const std::vector<Simplex>& walls() const { return regions_.walls().simplices(); }
  Point centre(const Simplex& simplex) const { return barycentre(points(), simplex); }
  bool is_segment(const Simplex& edge) const {
    return std::binary_search(complex_.segments.begin(), complex_.segments.end(), edge);
  }

  //
  // If v ∉ aff σ, they meet σ in one point each: φ = σ. If v ∈ aff σ, each enters σ through a facet
  // φ that v lies strictly beyond (all but a nowhere dense set of them through relint φ), and runs
  // in relint σ from there, where it meets no cell without being in it. So v sees relint σ iff it
  // sees relint φ for such a φ, past all that lies before φ, unless φ itself occludes. An obstacle
  // that lies partly before φ and partly behind it counts only as far as it is before φ: lines that
  // enter σ through φ do not meet the rest before they are in σ. An edge with v on its line has an
  // end before it: invisible.
  std::vector<Simplex> entrances() const {
    if (!v_is_in_hull_) return {simplex_};
    std::vector<Simplex> found;
    if (simplex_.size() == 2) return found;
    const Configuration& configuration = points().configuration();
    const std::vector<int> signs =
        barycentric_signs(configuration, axes_of(configuration, simplex_), simplex_, v_);
    for (std::size_t i = 0; i < simplex_.size(); ++i) {
      const Simplex face = facet_opposite(simplex_, i);
      if (signs[i] < 0 && !occludes(face)) found.push_back(face);
    }
    return found;
  }

  // A facet φ of σ occludes all lines through it if it lies in a polygon that is not in H
  // (if k = 2, in a segment). Otherwise relint φ meets no such cell, for σ respects P.
  bool occludes(const Simplex& face) const {
    if (face.size() == 2 && is_segment(face)) return true;
    const std::vector<std::size_t> at = regions_.walls().at(centre(face));
    if (face.size() == dimension()) return !at.empty();
    return std::any_of(at.begin(), at.end(), [&](std::size_t i) {
      return std::any_of(walls()[i].begin(), walls()[i].end(), [&](Vertex w) {
        return !contains(simplex_, w) &&
               orientation(points().configuration(), kSpace,
                           Simplex{simplex_[0], simplex_[1], simplex_[2], w}) != 0;
      });
    });
  }

  //
  // Some cells meet H in a set that fills no more than k − 2 dimensions of directions: vertices;
  // segments, unless k = 2 and they lie in H; polygons whose plane contains v. They block a nowhere
  // dense set of directions. All other cells that meet H between v and φ are obstacles: each of
  // these blocks a closed set of directions. So v is visible iff the obstacles leave any direction
  // open, because the rest is an open set, and a nowhere dense set cannot fill it. The obstacles
  // are
  //  - if k = 3, the walls, which are triangles of polygons;
  //  - if k = 2 in the plane, the walls, which are segments;
  //  - if k = 2 in space, segments in H, and what H cuts out of walls. A polygon that lies in H
  //    occludes nothing: a line in H that enters or leaves it crosses its boundary, which consists
  //    of segments.
  // If v ∉ aff σ, a polygon that contains σ meets no line of sight before σ, or includes it.
  //
  // To avoid looking at all cells, one line of sight is tried, through a part of φ that is still
  // open. The obstacles on it are subtracted from what is open, and so on, until a line is clear or
  // nothing is open. This ends, because each obstacle on a line removes part of what was open, and
  // no later line meets it. If the line meets only cells that block few directions, other lines
  // through the same part are tried, until one avoids these cells.

  // A point of relint σ on a line of sight through relint φ that nothing occludes.
  std::optional<Point> unoccluded_point(const Simplex& face) const {
    SightCone cone(points()[v_], coordinates(points(), face));
    while (const auto part = cone.open_part()) {
      for (int t = 1;; ++t) {
        const Point x = in_simplex(interior_point(*part, t));
        const Cells on_line = occluding(x);
        if (on_line.empty) return x;
        bool fewer_open = false;
        for (const Simplex& cell : on_line.cells) {
          std::vector<Point> obstacle = in_hull(face, cell);
          for (Point& corner : obstacle) corner = cone.coordinates(corner);
          if (!obstacle.empty()) fewer_open = cone.obstruct(obstacle) || fewer_open;
        }
        if (fewer_open) break;
      }
    }
    return std::nullopt;
  }

  // The segments and walls that occlude v from x. A wall in a plane with x and v is skipped: if its
  // polygon occludes, so does one of the segments that bound the polygon.
  struct Cells {
    std::vector<Simplex> cells;
    bool empty = true;  // of vertices, too
  };
  Cells occluding(const Point& x) const {
    const std::vector<Point> sight = {x, points()[v_]};
    const auto crosses = [&](const std::vector<Point>& common) {
      return common.size() == 1 && common[0] != sight[0] && common[0] != sight[1];
    };
    Cells found;
    for (const Simplex& segment : regions_.cells().segments(sight[0], sight[1])) {
      const auto common = intersection(sight, coordinates(points(), segment));
      if (common.size() > 1 || crosses(common)) found.cells.push_back(segment);
    }
    for (const std::size_t i : regions_.walls().near(sight[0], sight[1])) {
      const Simplex& wall = walls()[i];
      if (contains(wall, v_)) continue;
      if (crosses(intersection(sight, coordinates(points(), wall)))) found.cells.push_back(wall);
    }
    const std::vector<Vertex> vertices = regions_.cells().vertices(sight[0], sight[1]);
    found.empty =
        found.cells.empty() && std::none_of(vertices.begin(), vertices.end(), [&](Vertex w) {
          return crosses(intersection(sight, {points()[w]}));
        });
    return found;
  }

  // The intersection of H with a segment or a wall, given by its ends (corners), if it is an
  // obstacle; else nothing.
  std::vector<Point> in_hull(const Simplex& face, const Simplex& cell) const {
    if (face.size() == dimension()) {
      return cell.size() == dimension() ? coordinates(points(), cell) : std::vector<Point>();
    }
    std::vector<int> sides;
    for (const Vertex w : cell) sides.push_back(side(face, w));
    const bool lies_in_hull =
        std::all_of(sides.begin(), sides.end(), [](int side) { return side == 0; });
    if (cell.size() == 2) return lies_in_hull ? coordinates(points(), cell) : std::vector<Point>();
    std::vector<Point> ends;
    for (std::size_t i = 0; i < 3 && !lies_in_hull; ++i) {
      const std::size_t next = (i + 1) % 3;
      if (sides[i] == 0) ends.push_back(points()[cell[i]]);
      if (sides[i] * sides[next] < 0) ends.push_back(crossing(face, cell[i], cell[next]));
    }
    return ends.size() == 2 ? ends : std::vector<Point>();
  }

  // For k = 2 in space: on which side of H is w? H is the plane through v and an edge φ.
  int side(const Simplex& edge, Vertex w) const {
    if (w == v_ || contains(edge, w)) return 0;
    return orientation(points().configuration(), kSpace, Simplex{edge[0], edge[1], v_, w});
  }

  // The point of the line pq in that plane.
  Point crossing(const Simplex& edge, Vertex p, Vertex q) const {
    const auto height = [&](Vertex w) {
      return orientation_determinant(points().configuration(), kSpace,
                                     Simplex{edge[0], edge[1], v_, w});
    };
    const Rational from = height(p), to = height(q);
    return points()[p] + (from / (from - to)) * (points()[q] - points()[p]);
  }

  // The t-th of some interior points of a simplex, no more than two of them on any line: with
  // weights 1, t, t².
  Point interior_point(const std::vector<Point>& simplex, int t) const {
    Rational weight = 1, total = 0;
    Point y(dimension());
    for (const Point& corner : simplex) {
      y = y + weight * corner;
      total += weight;
      weight *= t;
    }
    return (1 / total) * y;
  }

  // A point of relint σ on the line of sight that enters it in y.
  Point in_simplex(const Point& y) const {
    if (!v_is_in_hull_) return y;
    const Point& origin = points()[simplex_[0]];
    const SightCone inside(origin, coordinates(points(), {simplex_.begin() + 1, simplex_.end()}));
    const Point direction = y - points()[v_];
    for (Rational step(1, 2);; step /= 2) {
      const Point x = y + step * direction;
      Point c = inside.coordinates(x);
      Rational rest = 1;
      for (const Rational& r : c) rest -= r;
      c.push_back(rest);
      if (std::all_of(c.begin(), c.end(), [](const Rational& r) { return r > 0; })) return x;
    }
  }

  //
  // A line of sight ]x, v[ that is not occluded lies in one region, or in one polygon in H (generic
  // lines are in no segment). If v ∈ aff σ, it begins in relint σ, so it stays in the region, or
  // the polygon, of σ, which is part of |P|. If v ∉ aff σ, it begins beside relint σ, along which P
  // is everywhere the same.
  //
  // If σ is a facet, all lines begin in one region: if a wall contains σ, as a dangling one may,
  // the region in front of that on the side of v; else the region of σ itself. (A dangling polygon
  // outside sees nothing beside its own plane.)
  bool opens_into_domain() const {
    const std::vector<std::size_t> at = regions_.walls().at(centre(simplex_));
    if (at.empty()) return true;
    const int side = regions_.walls().side_of(at.front(), points()[v_]);
    const OrientedFacet front{walls()[at.front()], side < 0};
    return regions_.faces_inside(front);
  }

  // If σ is an edge in space, the middle of one line of sight decides for all. (In the hull kind
  // nothing leads out of |P|, which is convex.)
  bool is_in_domain(const Point& x) const {
    const auto region = regions_.region_at(Rational(1, 2) * (x + points()[v_]));
    return !region || regions_.where(*region) == Where::kInside;
  }

  const PiecewiseLinearComplex& complex_;
  const Regions& regions_;
  const Vertex v_;
  const Simplex simplex_;
  bool v_is_in_hull_;
};

}  // namespace

bool is_visible(const PiecewiseLinearComplex& complex, const Regions& regions, Vertex v,
                const Simplex& simplex) {
  return visible_point(complex, regions, v, simplex).has_value();
}

std::optional<Point> visible_point(const PiecewiseLinearComplex& complex, const Regions& regions,
                                   Vertex v, const Simplex& simplex) {
  return Visibility(complex, regions, v, simplex).point();
}

}  // namespace circumspect
