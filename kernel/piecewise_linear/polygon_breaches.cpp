#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include "kernel/piecewise_linear/cell_boxes.hpp"
#include "kernel/piecewise_linear/cell_index.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "kernel/predicates/intersection.hpp"
#include "kernel/predicates/place.hpp"

namespace circumspect {
namespace {

// Does the complex have the segment?
bool is_segment(const PiecewiseLinearComplex& complex, Vertex v, Vertex w) {
  return std::binary_search(complex.segments.begin(), complex.segments.end(), Simplex{v, w});
}

struct Tile {
  Simplex triangle;
  std::size_t polygon;
  // Which of the edges 12, 02, 01 (by places in the triangle) are segments of the complex.
  std::array<bool, 3> is_segment;

  bool has_segments_only() const { return is_segment[0] && is_segment[1] && is_segment[2]; }
};

std::vector<Tile> tiles_of(const PiecewiseLinearComplex& complex) {
  std::vector<Tile> tiles;
  for (std::size_t i = 0; i < complex.polygons.size(); ++i) {
    for (const Simplex& triangle : complex.polygons[i].triangles) {
      Tile tile = {triangle, i, {}};
      for (std::size_t place = 0; place < 3; ++place) {
        const Simplex edge = facet_opposite(triangle, place);
        tile.is_segment[place] = is_segment(complex, edge[0], edge[1]);
      }
      tiles.push_back(tile);
    }
  }
  return tiles;
}

BoxIndex index_of(const CellBoxes& boxes, const std::vector<Tile>& tiles) {
  std::vector<Simplex> triangles;
  for (const Tile& tile : tiles) triangles.push_back(tile.triangle);
  return boxes.index_of(triangles);
}

// On which side of a plane vertices are; each side is computed once.
class SidesOfPlane {
 public:
  explicit SidesOfPlane(const PointSet& points)
      : points_(points), sides_(points.size()), known_for_(points.size(), 0) {}

  // Uses the plane of this triangle from now on.
  void set_plane(const Simplex& triangle) {
    triangle_ = triangle;
    ++plane_;
  }
  int side(Vertex v) {
    const auto place = static_cast<std::size_t>(v);
    if (known_for_[place] != plane_) {
      sides_[place] = side_of_triangle(points_.configuration(), triangle_, v);
      known_for_[place] = plane_;
    }
    return sides_[place];
  }

 private:
  const PointSet& points_;
  Simplex triangle_;
  std::size_t plane_ = 0;  // how many there were
  std::vector<int> sides_;
  std::vector<std::size_t> known_for_;
};

// The corners of a tile by their sides of a plane.
struct Sides {
  template <typename SideOf>
  Sides(const Tile& tile, SideOf&& side_of) {
    std::size_t apex = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const int side = side_of(tile.triangle[i]);
      (side == 0 ? in_plane : side > 0 ? above : below) += 1;
      if (side != 0) apex = i;
    }
    has_segment_in_plane = in_plane == 2 && tile.is_segment[apex];
  }
  // Does the plane cut out more than a point, and not only something that is known to lie in a
  // segment?
  bool may_share_stretch() const {
    return (above > 0 && below > 0) || (in_plane == 2 && !has_segment_in_plane);
  }
  int above = 0, below = 0, in_plane = 0;
  bool has_segment_in_plane = false;
};

// Which of some polygons share two vertices that no segment joins: a chord. The chords of a polygon
// of few vertices are listed; those of another, which may be too many, are not.
class CommonChords {
 public:
  CommonChords(const PiecewiseLinearComplex& complex, const std::vector<std::size_t>& polygons)
      : complex_(complex) {
    for (const std::size_t polygon : polygons) {
      if (is_listed(polygon)) {
        const std::vector<Chord> chords = chords_of(polygon);
        chords_.insert(chords_.end(), chords.begin(), chords.end());
      } else {
        for (const Vertex v : vertices(polygon)) large_at_[v].push_back(polygon);
      }
    }
    std::sort(chords_.begin(), chords_.end());
  }

  // The polygons after this one that have a chord in common with it.
  std::set<std::size_t> after(std::size_t polygon) const {
    std::set<std::size_t> found;
    const std::vector<Chord> own = is_listed(polygon) ? chords_of(polygon) : std::vector<Chord>();
    for (const auto& [from, to, self] : own) {
      auto chord = std::upper_bound(chords_.begin(), chords_.end(), Chord{from, to, self});
      for (; chord != chords_.end() && chord->from == from && chord->to == to; ++chord) {
        found.insert(chord->polygon);
      }
    }
    std::map<std::size_t, std::vector<Vertex>> common_with_large;
    for (const Vertex v : vertices(polygon)) {
      if (const auto at = large_at_.find(v); at != large_at_.end()) {
        for (const std::size_t other : at->second) common_with_large[other].push_back(v);
      }
      if (!is_listed(polygon)) find_listed(polygon, v, found);
    }
    for (const auto& [other, common] : common_with_large) {
      if (other > polygon && have_chord(common)) found.insert(other);
    }
    return found;
  }

 private:
  struct Chord {
    Vertex from, to;
    std::size_t polygon;
    auto operator<=>(const Chord&) const = default;
  };

  const std::vector<Vertex>& vertices(std::size_t polygon) const {
    return complex_.polygons[polygon].vertices;
  }
  bool is_listed(std::size_t polygon) const { return vertices(polygon).size() <= 16; }
  bool has(std::size_t polygon, Vertex v) const {
    return std::binary_search(vertices(polygon).begin(), vertices(polygon).end(), v);
  }

  // In lexicographic order.
  std::vector<Chord> chords_of(std::size_t polygon) const {
    const std::vector<Vertex>& all = vertices(polygon);
    std::vector<Chord> chords;
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t j = i + 1; j < all.size(); ++j) {
        if (!is_segment(complex_, all[i], all[j])) chords.push_back({all[i], all[j], polygon});
      }
    }
    return chords;
  }
  // The listed polygons with a chord that starts at v and is one of this polygon.
  void find_listed(std::size_t polygon, Vertex v, std::set<std::size_t>& found) const {
    auto chord = std::lower_bound(chords_.begin(), chords_.end(), Chord{v, -1, 0});
    for (; chord != chords_.end() && chord->from == v; ++chord) {
      if (chord->polygon > polygon && has(polygon, chord->to)) found.insert(chord->polygon);
    }
  }
  // Few segments can join all vertices of a plane, so a pair without a segment is soon found.
  bool have_chord(const std::vector<Vertex>& common) const {
    for (std::size_t i = 0; i < common.size(); ++i) {
      for (std::size_t j = i + 1; j < common.size(); ++j) {
        if (!is_segment(complex_, common[i], common[j])) return true;
      }
    }
    return false;
  }

  const PiecewiseLinearComplex& complex_;
  std::vector<Chord> chords_;
  std::unordered_map<Vertex, std::vector<std::size_t>> large_at_;
};

// How two tiles of different polygons can go wrong, given that vertices and segments form a
// simplicial complex, no segment pierces a polygon, and all vertices and segments of the complex
// that lie in a polygon are corners and edges of its tiles.
//
// The ends of a common stretch of two polygons of different planes lie on the boundary of one or
// the other, in a segment; were they not vertices, the segment would pierce the other polygon or
// lie in both and go on. So the stretch runs from vertex to vertex, and is legal iff it consists of
// segments, which then are edges of tiles of both.
//
// Let the interiors of two polygons of one plane meet, and take from what they share all segments.
// A component of the rest is bounded by segments, whose ends are vertices of both polygons. If it
// is a triangle with no other vertices, it is a tile of both. If not, it can be cut into two
// triangles or more, and the edges between them join vertices of both that no segment joins.
//
// So only equal tiles need a look, and polygons that have a *chord* in common: two vertices that no
// segment joins. In these polygons, only tiles with an edge within their polygon need a look: a
// tile whose edges are all segments holds no vertex but its corners, so what it shares with another
// polygon consists of corners and edges, or it is a tile of both.
class TilePairs {
 public:
  TilePairs(const PiecewiseLinearComplex& complex, const std::vector<Tile>& tiles,
            BreachList& found)
      : points_(complex.points), complex_(complex), tiles_(tiles), found_(found) {}

  void judge_equal_tiles() {
    std::vector<std::size_t> order(tiles_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
      return tiles_[i].triangle < tiles_[j].triangle;
    });
    for (std::size_t i = 0; i + 1 < order.size(); ++i) {
      const Tile& a = tiles_[order[i]];
      const Tile& b = tiles_[order[i + 1]];
      if (a.triangle == b.triangle) add(BreachKind::kPolygonsOverlap, a, b);
    }
  }

  void judge_other_tiles(const Progress& progress) {
    std::map<std::size_t, std::vector<Tile>> tiles_of_polygon;
    for (const Tile& tile : tiles_) {
      if (!tile.has_segments_only()) tiles_of_polygon[tile.polygon].push_back(tile);
    }
    std::vector<std::size_t> polygons;
    for (const auto& [polygon, tiles] : tiles_of_polygon) polygons.push_back(polygon);
    if (polygons.empty()) return;
    const CommonChords chords(complex_, polygons);
    const CellBoxes boxes(points_);
    SidesOfPlane sides(points_);
    std::size_t done = 0;
    for (const std::size_t i : polygons) {
      tell(progress, "polygons against polygons", done++, polygons.size());
      sides.set_plane(complex_.polygons[i].triangles.front());
      for (const std::size_t j : chords.after(i)) {
        if (found_.is_full()) return;
        judge(tiles_of_polygon[i], tiles_of_polygon[j], boxes, sides);
      }
    }
  }

 private:
  // The sides are those of the plane of the first polygon.
  void judge(const std::vector<Tile>& of_first, const std::vector<Tile>& of_second,
             const CellBoxes& boxes, SidesOfPlane& sides) {
    std::vector<Box> around;
    for (const Tile& b : of_second) around.push_back(boxes.of(b.triangle));
    for (const Tile& a : of_first) {
      const Box box = boxes.of(a.triangle);
      for (std::size_t i = 0; i < of_second.size(); ++i) {
        if (!may_meet(box, around[i])) continue;
        const Tile& b = of_second[i];
        judge(a, b, Sides(b, [&](Vertex v) { return sides.side(v); }));
      }
    }
  }
  void judge(const Tile& a, const Tile& b, const Sides& b_from_a) {
    const Configuration& configuration = points_.configuration();
    if (b_from_a.in_plane == 3) {
      const auto& axes = complex_.polygons[a.polygon].axes;
      if (!wrong_.contains(std::minmax(a.polygon, b.polygon)) &&
          interiors_meet(configuration, axes, a.triangle, b.triangle)) {
        add(BreachKind::kPolygonsOverlap, a, b);
      }
      return;
    }
    if (!b_from_a.may_share_stretch()) return;
    const Sides a_from_b(a,
                         [&](Vertex v) { return side_of_triangle(configuration, b.triangle, v); });
    if (a_from_b.may_share_stretch() && common_corners(a, b).size() > 1) {
      add(BreachKind::kPolygonsCross, a, b);
    }
  }
  std::vector<Point> common_corners(const Tile& a, const Tile& b) const {
    return intersection(coordinates(points_, a.triangle), coordinates(points_, b.triangle));
  }
  // One witness for each pair of polygons.
  void add(BreachKind kind, const Tile& a, const Tile& b) {
    const std::pair<std::size_t, std::size_t> pair = std::minmax(a.polygon, b.polygon);
    if (!wrong_.insert(pair).second) return;
    found_.add({kind, {}, {}, {pair.first, pair.second}, barycentre(common_corners(a, b))});
  }

  const PointSet& points_;
  const PiecewiseLinearComplex& complex_;
  const std::vector<Tile>& tiles_;
  BreachList& found_;
  std::set<std::pair<std::size_t, std::size_t>> wrong_;
};

// The triangles of one polygon against segments that have an end on either side of it.
class PiercedPolygon {
 public:
  PiercedPolygon(const PointSet& points, const CellBoxes& boxes, const Polygon& polygon)
      : points_(points), boxes_(boxes), triangles_(polygon.triangles) {}

  // Where the segment goes through the polygon, if it does.
  std::optional<Point> pierced_by(const Simplex& segment) {
    if (triangles_.size() < 8) {
      for (const Simplex& triangle : triangles_) {
        if (const auto point = pierced(triangle, segment)) return point;
      }
      return std::nullopt;
    }
    if (!index_) index_.emplace(boxes_.index_of(triangles_));
    for (const std::size_t i : index_->meeting(boxes_.of(segment))) {
      if (const auto point = pierced(triangles_[i], segment)) return point;
    }
    return std::nullopt;
  }

 private:
  std::optional<Point> pierced(const Simplex& triangle, const Simplex& segment) const {
    if (!segment_pierces_triangle(points_.configuration(), segment, triangle)) {
      return std::nullopt;
    }
    return intersection(coordinates(points_, segment), coordinates(points_, triangle)).front();
  }

  const PointSet& points_;
  const CellBoxes& boxes_;
  const std::vector<Simplex>& triangles_;
  std::optional<BoxIndex> index_;
};

}  // namespace

void find_piercing_segments(const PiecewiseLinearComplex& complex, const Progress& progress,
                            BreachList& found) {
  if (complex.polygons.empty()) return;
  const PointSet& points = complex.points;
  const CellBoxes boxes(points);
  const CellIndex index(boxes.of(complex.segments), complex.segments);
  SidesOfPlane sides(points);
  for (std::size_t i = 0; i < complex.polygons.size() && !found.is_full(); ++i) {
    tell(progress, "polygons against segments", i, complex.polygons.size());
    const Polygon& polygon = complex.polygons[i];
    PiercedPolygon pierced(points, boxes, polygon);
    sides.set_plane(polygon.triangles.front());
    // A segment that ends in a vertex of the polygon has that end in its plane.
    for (const std::size_t place : index.apart(boxes.of(polygon.vertices), polygon.vertices)) {
      const Simplex& segment = complex.segments[place];
      if (sides.side(segment[0]) * sides.side(segment[1]) >= 0) continue;
      if (const auto point = pierced.pierced_by(segment)) {
        found.add({BreachKind::kSegmentPiercesPolygon, {}, {segment}, {i}, *point});
      }
    }
  }
}

void find_polygon_pair_breaches(const PiecewiseLinearComplex& complex, const Progress& progress,
                                BreachList& found) {
  const std::vector<Tile> tiles = tiles_of(complex);
  TilePairs pairs(complex, tiles, found);
  pairs.judge_equal_tiles();
  pairs.judge_other_tiles(progress);
}

void find_hole_seed_breaches(const PiecewiseLinearComplex& complex, BreachList& found) {
  if (complex.hole_seeds.empty()) return;
  const bool in_plane = complex.ambient_dimension() == 2;
  const std::vector<Tile> tiles = tiles_of(complex);
  const CellBoxes boxes(complex.points);
  const BoxIndex index = in_plane ? boxes.index_of(complex.segments) : index_of(boxes, tiles);
  for (const Point& seed : complex.hole_seeds) {
    if (found.is_full()) return;
    for (const std::size_t i : index.meeting(box_around(seed))) {
      const Simplex& wall = in_plane ? complex.segments[i] : tiles[i].triangle;
      if (intersection(coordinates(complex.points, wall), {seed}).empty()) continue;
      Breach breach = {BreachKind::kHoleSeedOnWall, {}, {}, {}, seed};
      if (in_plane) breach.segments = {wall};
      if (!in_plane) breach.polygons = {tiles[i].polygon};
      found.add(breach);
      break;
    }
  }
}

}  // namespace circumspect
