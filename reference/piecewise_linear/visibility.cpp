// Visibility, decided exactly. Book: Definition 2.13: x and y are visible to each other iff xy
// respects P, that is xy ⊆ |P| and no cell meets the relative interior of xy without including it.
//
// Let σ respect P, v a vertex of P that is none of σ's, H = aff(v ∪ σ), of dimension k. No point of
// σ is v. For x in relint σ let ]x, v[ be the open segment. What may occlude?
//
// 1. Directions. The points of relint σ that v sees through in one direction count as one; the
//    directions form an open set of dimension k − 1. The cells that meet H in a set of which v sees
//    no more than k − 2 dimensions (vertices; segments, unless k = 2 and they lie in H; polygons
//    whose plane contains v, unless they lie in H) block a nowhere dense set of directions. The
//    other walls that cross H are closed, and block a closed set. So v is visible iff those walls
//    leave an open set of directions, or, what is the same, any direction at all: a closed set that
//    is not everything leaves an open one, and a nowhere dense set cannot fill that.
//    - k = 3: walls are the triangles of all polygons whose plane does not contain v.
//    - k = 2, in the plane: walls are the segments. In space: segments in H, and what H cuts out of
//      triangles. A polygon in H occludes nothing: a line in H that enters or leaves it crosses its
//      boundary, which consists of segments.
//
// 2. v ∈ aff σ (σ a tetrahedron in space, a triangle in its plane; σ of dimension k). A line of
//    sight enters σ through a facet φ that has v strictly beyond it, in a point y of relint φ (for
//    an open set of directions), and runs in relint σ from there, where it meets no cell without
//    being in it. So v sees relint σ iff it sees relint φ for some such φ, past all that lies
//    before φ, and nothing occludes in y itself. Either φ lies in a polygon that is not in H (in a
//    segment, if k = 2), then all y are blocked; or relint φ meets none, for σ respects P. Walls
//    that touch φ in single points or lines block few directions. An obstacle that lies partly
//    before φ and partly behind it is cut at φ; behind φ it blocks nothing, not even if it comes
//    before other parts of σ, since lines that enter through φ do not meet it before they are in σ.
//    If σ is an edge and v on its line, an end of σ lies between: invisible.
//
// 3. v ∉ aff σ (k − 1 = dimension of σ): the same with φ = σ, and no question about y: a polygon
//    that contains σ meets ]x, v[ nowhere or includes it.
//
// 4. ]x, v[ ⊆ |P|? If it is not occluded, ]x, v[ lies in one region, or one polygon in H, or is
//    part of a segment in no region that matters (generic lines are in no segment). In 2 it starts
//    in relint σ, so it stays in the region, or the polygon, of σ: yes. In 3 it starts beside
//    relint σ, along which P is everywhere the same (σ respects P): the region on v's side of σ
//    decides, one for all x. If σ is a facet (dimension d − 1) and in no wall, that is the region
//    of σ itself. If a wall contains it, as a dangling one does, the region in front of that; a
//    dangling polygon outside sees nothing beside its own plane. If σ is an edge in space, the
//    middle of one line of sight decides for all. In the hull kind nothing leads out of |P|, which
//    is convex. (The region next to v needs no look: it is that of all of ]x, v[.)
//
// So as not to look at all walls, a line of sight is tried that goes through what is still open;
// the walls that it meets are taken away, and another one is tried, until one is clear or nothing
// is open. A wall that counts takes away all lines that it meets, and with any of them in an open
// part some of the interior of that part; no line tried later meets it. Those that block few
// directions are avoided by trying other lines through the same open part. So this ends.
#include "reference/piecewise_linear/visibility.hpp"

#include <algorithm>
#include <numeric>

#include "reference/piecewise_linear/sight_cone.hpp"
#include "reference/predicates/intersection.hpp"
#include "reference/predicates/orientation.hpp"
#include "reference/predicates/space_axes.hpp"

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

  std::optional<Point> point() const {
    if (simplex_.size() == 1) {
      const bool sees = respects(complex_, regions_, {simplex_[0], v_});
      return sees ? std::optional(points()[simplex_[0]]) : std::nullopt;
    }
    const bool is_facet = !v_is_in_hull_ && simplex_.size() == dimension();
    if (is_facet && !may_start()) return std::nullopt;
    for (const Simplex& face : faces_towards_v()) {
      const auto x = unoccluded_point(face);
      if (!x) continue;
      if (v_is_in_hull_ || is_facet) return x;
      // An edge in space: what holds for one line of sight holds for all.
      return is_in_domain(Rational(1, 2) * (*x + points()[v_])) ? x : std::nullopt;
    }
    return std::nullopt;
  }

 private:
  const PointSet& points() const { return complex_.points; }
  std::size_t dimension() const { return complex_.ambient_dimension(); }
  const std::vector<Simplex>& walls() const { return regions_.walls().simplices(); }
  Point centre(const Simplex& simplex) const { return barycentre(coordinates(points(), simplex)); }
  bool is_segment(const Simplex& edge) const {
    return std::binary_search(complex_.segments.begin(), complex_.segments.end(), edge);
  }

  bool is_in_domain(const Point& point) const {
    const auto region = regions_.region_at(point);
    return !region || regions_.where(*region) == Where::kInside;
  }

  // May lines of sight leave the simplex, a facet, on the side of v? (4 above.)
  bool may_start() const {
    for (const std::size_t i : regions_.walls().at(centre(simplex_))) {
      const int side = regions_.walls().side_of(i, points()[v_]);
      const OrientedFacet front{walls()[i], side < 0};
      return regions_.where(regions_.in_front_of(front)) == Where::kInside;
    }
    return true;
  }

  // The simplex itself or, if v is in its affine hull, its facets that have v beyond them and
  // occlude nothing themselves.
  std::vector<Simplex> faces_towards_v() const {
    if (!v_is_in_hull_) return {simplex_};
    std::vector<Simplex> found;
    if (simplex_.size() == 2) return found;
    const Configuration& configuration = points().configuration();
    const std::vector<std::size_t> axes = axes_of(configuration, simplex_);
    const int front = orientation(configuration, axes, simplex_);
    for (std::size_t i = 0; i < simplex_.size(); ++i) {
      const Simplex face = facet_opposite(simplex_, i);
      const bool beyond =
          orientation(configuration, axes, with_vertex_replaced(simplex_, i, v_)) == -front;
      if (beyond && !occludes(face)) found.push_back(face);
    }
    return found;
  }

  // Is a facet of the simplex in a wall that blocks all views through it? (2 above.)
  bool occludes(const Simplex& face) const {
    if (face.size() == 2 && is_segment(face)) return true;
    const std::vector<std::size_t> at = regions_.walls().at(centre(face));
    return std::any_of(at.begin(), at.end(), [&](std::size_t i) {
      if (face.size() == dimension()) return true;
      const Simplex& s = simplex_;
      return std::any_of(walls()[i].begin(), walls()[i].end(), [&](Vertex w) {
        return !contains(s, w) &&
               orientation(points().configuration(), kSpace, Simplex{s[0], s[1], s[2], w}) != 0;
      });
    });
  }

  // A point of relint σ that v sees through a face, but for the domain; v is not in the affine hull
  // of the face.
  std::optional<Point> unoccluded_point(const Simplex& face) const {
    SightCone cone(points()[v_], coordinates(points(), face));
    while (const auto part = cone.open_part()) {
      for (int t = 1;; ++t) {
        const Point x = in_simplex(point_of(*part, t));
        const Occlusion occlusion = occlude(cone, face, x);
        if (occlusion == Occlusion::kNone) return x;
        if (occlusion == Occlusion::kOpen) break;
      }
    }
    return std::nullopt;
  }

  // Does anything occlude v from x, and if so, an open set of directions? Then they are taken away.
  // A wall in a plane with x and v hides few directions, those of its corners; segments bound polygons.
  enum class Occlusion { kNone, kFewDirections, kOpen };
  Occlusion occlude(SightCone& cone, const Simplex& face, const Point& x) const {
    const std::vector<Point> sight = {x, points()[v_]};
    const auto touches = [&](const std::vector<Point>& common) {
      return common.size() == 1 && common[0] != sight[0] && common[0] != sight[1];
    };
    bool any = false, open = false;
    for (const Vertex w : regions_.cells().vertices(x, points()[v_])) {
      any = any || touches(intersection(sight, {points()[w]}));
    }
    for (const Simplex& s : regions_.cells().segments(x, points()[v_])) {
      const std::vector<Point> common = intersection(sight, coordinates(points(), s));
      if (common.size() < 2 && !touches(common)) continue;
      any = true;
      open = obstruct(cone, face, s) || open;
    }
    for (const std::size_t i : regions_.walls().near(x, points()[v_])) {
      const Simplex& wall = walls()[i];
      if (contains(wall, v_) || !touches(intersection(sight, coordinates(points(), wall))))
        continue;
      any = true;
      open = obstruct(cone, face, wall) || open;
    }
    return open ? Occlusion::kOpen : any ? Occlusion::kFewDirections : Occlusion::kNone;
  }

  // Takes the directions away in which a segment or a wall lies before the face.
  bool obstruct(SightCone& cone, const Simplex& face, const Simplex& cell) const {
    std::vector<Point> corners;
    if (cell.size() == dimension()) {
      if (face.size() == dimension()) {
        corners = coordinates(points(), cell);
      } else {
        corners = section_of(cell, face);
      }
    } else if (face.size() < dimension() && side(face, cell[0]) == 0 && side(face, cell[1]) == 0) {
      corners = coordinates(points(), cell);
    }
    if (corners.size() < face.size()) return false;
    for (Point& corner : corners) corner = cone.coordinates(corner);
    return cone.obstruct(corners);
  }

  // On which side of the plane through v and an edge is w?
  int side(const Simplex& edge, Vertex w) const {
    if (w == v_ || contains(edge, w)) return 0;
    return orientation(points().configuration(), kSpace, Simplex{edge[0], edge[1], v_, w});
  }

  // What the plane through v and an edge cuts out of a triangle: at most two ends. Nothing of a
  // triangle that lies in the plane: what it hides there, its segments hide.
  std::vector<Point> section_of(const Simplex& wall, const Simplex& edge) const {
    std::vector<int> sides;
    for (const Vertex w : wall) sides.push_back(side(edge, w));
    if (sides == std::vector<int>{0, 0, 0}) return {};
    std::vector<Point> ends;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3;
      if (sides[i] == 0) ends.push_back(points()[wall[i]]);
      if (sides[i] * sides[next] < 0) ends.push_back(crossing(edge, wall[i], wall[next]));
    }
    return ends;
  }
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
  Point point_of(const std::vector<Point>& simplex, int t) const {
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
      const Point c = inside.coordinates(x);
      const bool positive =
          std::all_of(c.begin(), c.end(), [](const Rational& r) { return sign(r) > 0; });
      if (positive && std::accumulate(c.begin(), c.end(), Rational(0)) < 1) return x;
    }
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
