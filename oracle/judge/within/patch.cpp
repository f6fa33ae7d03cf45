// The image of a polygon: docs/theory/within.md, 3.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "oracle/judge/within/images.hpp"
#include "reference/kernel/exact/box_index.hpp"

namespace circumspect::check {

namespace {

using Edge = std::pair<Vertex, Vertex>;  // directed

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

std::array<Edge, 3> edges(const Simplex& triangle) {
  return {{{triangle[0], triangle[1]}, {triangle[1], triangle[2]}, {triangle[2], triangle[0]}}};
}
Vertex apex(const Simplex& triangle, const Edge& edge) {
  for (const Vertex v : triangle) {
    if (v != edge.first && v != edge.second) return v;
  }
  return -1;
}
Edge reverse(const Edge& edge) { return {edge.second, edge.first}; }

}  // namespace

Point normal_of(const PiecewiseLinearComplex& complex, std::size_t polygon) {
  const Simplex& t = complex.polygons[polygon].triangles.front();
  Point normal = cross(complex.points[t[1]] - complex.points[t[0]],
                       complex.points[t[2]] - complex.points[t[0]]);
  const auto first =
      std::find_if(normal.begin(), normal.end(), [](const Rational& x) { return sign(x) != 0; });
  return sign(*first) > 0 ? normal : Rational(-1) * normal;
}

namespace {

using Direction = std::array<double, 3>;

Direction difference(const RoundedPoint& a, const RoundedPoint& b) {
  return {a.at[0] - b.at[0], a.at[1] - b.at[1], a.at[2] - b.at[2]};
}
double largest(const Direction& d) {
  return std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])});
}
Direction cross(const Direction& a, const Direction& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Which triangles are counterclockwise seen from above a polygon. Doubles decide where they can.
class SeenFromAbove {
 public:
  SeenFromAbove(const PiecewiseLinearComplex& complex,
                const std::vector<RoundedPoint>& rounded_domain, std::size_t polygon,
                const PointSet& points, const std::vector<RoundedPoint>& rounded)
      : complex_(complex), polygon_(polygon), points_(points), rounded_(rounded) {
    const Simplex& t = complex.polygons[polygon].triangles.front();
    const auto at = [&](std::size_t place) -> const RoundedPoint& {
      return rounded_domain[static_cast<std::size_t>(t[place])];
    };
    const Direction u = difference(at(1), at(0)), v = difference(at(2), at(0));
    normal_ = cross(u, v);
    size_ = largest(u) * largest(v);
    is_double_ = at(0).error == 0 && at(1).error == 0 && at(2).error == 0;
    // A sum of two products of differences is off by at most 2·(2 + 1 + 1)u of what each may be.
    is_double_ = is_double_ && size_ <= kLarge;
    if (is_double_ && std::abs(normal_[0]) > 2e-15 * size_ + kVanishing) {
      is_reversed_ = normal_[0] < 0;
    } else {
      is_reversed_ = inner_product(plain_normal(), exact_normal()) < 0;
    }
    if (is_reversed_) {
      for (double& x : normal_) x = -x;
    }
  }

  // Of the domain's own: positive if its vertices are in that order.
  Simplex own(Simplex triangle) const {
    if (triangle == complex_.polygons[polygon_].triangles.front()) {
      if (is_reversed_) std::swap(triangle[1], triangle[2]);
      return triangle;
    }
    const int side = turn(complex_.points, exact_normal(), triangle);
    return turned(std::move(triangle), side);
  }
  Simplex counterclockwise(const Simplex& triangle) const {
    return turned(triangle, turn(triangle));
  }

  // Positive if the triangle of the mesh is counterclockwise. The determinant is a sum of 12 products of four
  // differences; with all roundings each is off by less than 12u of what it may be.
  int turn(const Simplex& t) const {
    const RoundedPoint& a = rounded_[static_cast<std::size_t>(t[0])];
    const RoundedPoint& b = rounded_[static_cast<std::size_t>(t[1])];
    const RoundedPoint& c = rounded_[static_cast<std::size_t>(t[2])];
    if (is_double_ && a.error == 0 && b.error == 0 && c.error == 0) {
      const Direction v = difference(b, a), w = difference(c, a);
      const double size = largest(v) * largest(w);
      const Direction across = cross(v, w);
      const double found = normal_[0] * across[0] + normal_[1] * across[1] + normal_[2] * across[2];
      const double bound = 2e-14 * size_ * size + kVanishing;
      if (size <= kLarge && std::abs(found) > bound) return found > 0 ? 1 : -1;
    }
    return turn(points_, exact_normal(), t);
  }

  const Point& exact_normal() const {
    if (exact_normal_.empty()) exact_normal_ = normal_of(complex_, polygon_);
    return exact_normal_;
  }

 private:
  // More than what products that vanish leave out, if other factors are no larger than that.
  static constexpr double kVanishing = 1e-200;
  static constexpr double kLarge = 1e120;

  static int turn(const PointSet& points, const Point& normal, const Simplex& t) {
    return sign(inner_product(normal, circumspect::check::cross(points[t[1]] - points[t[0]],
                                                                points[t[2]] - points[t[0]])));
  }
  static Simplex turned(Simplex triangle, int turn) {
    if (turn < 0) std::swap(triangle[1], triangle[2]);
    return triangle;
  }
  Point plain_normal() const {
    const Simplex& t = complex_.polygons[polygon_].triangles.front();
    return circumspect::check::cross(complex_.points[t[1]] - complex_.points[t[0]],
                                     complex_.points[t[2]] - complex_.points[t[0]]);
  }

  const PiecewiseLinearComplex& complex_;
  std::size_t polygon_;
  const PointSet& points_;
  const std::vector<RoundedPoint>& rounded_;
  Direction normal_;
  double size_;
  bool is_double_;
  bool is_reversed_;
  mutable Point exact_normal_;
};

// Finds the image of one polygon: from the paths of its segments, on the sides on which the polygon
// lies, across all other edges. Where several triangles are on one side of an edge, there is something
// flat between them, which is to lie inside the domain or else above.
class PatchSearch {
 public:
  struct Link {
    std::size_t own;  // the domain's triangle on the left, if any
    bool has_own;
  };

  PatchSearch(const PointSet& points, const std::vector<RoundedPoint>& rounded,
              const Polygon& polygon, std::size_t number, const SeenFromAbove& above, double reach)
      : points_(points),
        rounded_(rounded),
        polygon_(polygon),
        number_(number),
        above_(above),
        reach_(reach) {
    for (std::size_t t = 0; t < polygon_.triangles.size(); ++t) {
      own_.push_back(above.own(polygon_.triangles[t]));
      for (const Edge& edge : edges(own_.back())) own_at_[edge] = t;
    }
  }

  void add_path(const Simplex& segment, const std::vector<Vertex>& path) {
    const auto link = [&](const Edge& edge) {
      const auto found = own_at_.find(edge);
      return found == own_at_.end() ? Link{0, false} : Link{found->second, true};
    };
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      links_[{path[i], path[i + 1]}] = link({segment[0], segment[1]});
      links_[{path[i + 1], path[i]}] = link({segment[1], segment[0]});
    }
  }
  void add_candidate(const Simplex& triangle) {
    const int turn = above_.turn(triangle);
    if (turn == 0) return;
    candidates_.push_back(triangle);
    if (turn < 0) std::swap(candidates_.back()[1], candidates_.back()[2]);
    for (const Edge& edge : edges(candidates_.back())) {
      at_[edge].push_back(candidates_.size() - 1);
    }
  }

  // Which of several triangles beside an edge: the lowest, as seen with the normal upwards, if what is
  // flat is to lie above the patch.
  template <class IsFlatAbove>
  ImageOr<Patch> found(const std::vector<Vertex>& must_have, const IsFlatAbove& is_flat_above) {
    lowest_.clear();
    for (const Simplex& own : own_) lowest_.push_back(is_flat_above(own));
    choices_.clear();
    auto first = flooded(must_have);
    if (first) return first;
    // Every other series of choices, one after another.
    for (std::size_t tries = 1; next_choices(); ++tries) {
      if (tries == kMostTries) {
        first.error().is_open = true;
        return first;
      }
      if (auto other = flooded(must_have)) return other;
    }
    return first;
  }

 private:
  static constexpr std::size_t kMostTries = 1000;

  // Of so many triangles beside an edge the one at this place, in their order from the first that is wanted.
  struct Choice {
    std::size_t of;
    std::size_t place;
  };

  // The next series of choices in lexicographic order, as far as it is known.
  bool next_choices() {
    while (!choices_.empty() && ++choices_.back().place == choices_.back().of) choices_.pop_back();
    return !choices_.empty();
  }

  ImageOr<Patch> flooded(const std::vector<Vertex>& must_have) {
    chosen_.assign(candidates_.size(), false);
    reached_.clear();
    reference_.clear();
    chosen_so_far_ = 0;
    for (const auto& [edge, link] : links_) {
      if (link.has_own && !reach(edge, link.own)) return fault(edge);
    }
    std::map<Edge, std::size_t> left;  // which triangle of the patch is on the left
    for (std::size_t next = 0; next < reached_.size(); ++next) {
      const Simplex triangle = candidates_[reached_[next]];
      for (const Edge& edge : edges(triangle)) {
        if (!left.emplace(edge, reached_[next]).second) return fault(edge, triangle);
        const auto link = links_.find(edge);
        if (link != links_.end()) {
          if (!link->second.has_own) return fault(edge, triangle);
        } else if (!reach(reverse(edge), reference_[next])) {
          return fault(edge, triangle);
        }
      }
    }
    if (auto lacking = lacks(must_have)) return tl::unexpected(std::move(*lacking));
    if (auto folded = folds()) return tl::unexpected(std::move(*folded));
    Patch patch;
    for (std::size_t i = 0; i < reached_.size(); ++i) {
      patch.triangles.push_back(candidates_[reached_[i]]);
      patch.own.push_back(own_[reference_[i]]);
    }
    return patch;
  }

  // Takes the triangle on the left of an edge; false if there is none.
  bool reach(const Edge& edge, std::size_t own) {
    const auto at = at_.find(edge);
    if (at == at_.end()) return false;
    std::size_t best = at->second.front();
    if (at->second.size() > 1) {
      std::vector<std::size_t> order = at->second;
      const auto is_wanted_before = [&](std::size_t a, std::size_t b) {
        if (a == b) return false;
        const int above = side(edge, apex(candidates_[a], edge), apex(candidates_[b], edge));
        return lowest_[own] ? above > 0 : above < 0;
      };
      std::stable_sort(order.begin(), order.end(), is_wanted_before);
      if (chosen_so_far_ == choices_.size()) choices_.push_back({order.size(), 0});
      best = order[choices_[chosen_so_far_++].place];
    }
    if (!chosen_[best]) {
      chosen_[best] = true;
      reached_.push_back(best);
      reference_.push_back(own);
    }
    return true;
  }

  // Is the second apex above (positive) or below the plane of edge and first apex?
  int side(const Edge& edge, Vertex first, Vertex second) const {
    const Point& from = points_[edge.first];
    return sign(inner_product(cross(points_[edge.second] - from, points_[first] - from),
                              points_[second] - from));
  }

  std::optional<NoImage> lacks(const std::vector<Vertex>& must_have) const {
    std::vector<Vertex> had;
    for (const std::size_t t : reached_) {
      had.insert(had.end(), candidates_[t].begin(), candidates_[t].end());
    }
    for (const auto& [edge, link] : links_) had.push_back(edge.first);
    std::sort(had.begin(), had.end());
    for (const Vertex v : must_have) {
      if (std::binary_search(had.begin(), had.end(), v)) continue;
      return NoImage{{Rule::kPolygonNotTiled, {.vertices = {v}, .polygon = number_}}};
    }
    return std::nullopt;
  }

  // Does the patch cover a point of the plane twice?
  std::optional<NoImage> folds() const {
    std::vector<Box> boxes;
    for (const std::size_t t : reached_) {
      std::array<RoundedPoint, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) {
        corners[i] = rounded_[static_cast<std::size_t>(candidates_[t][i])];
      }
      boxes.push_back(box_about(corners, reach_));
    }
    const auto overlap = [&](std::size_t i, std::size_t j) -> std::optional<NoImage> {
      const Simplex &a = candidates_[reached_[i]], &b = candidates_[reached_[j]];
      if (parts(a, b) || parts(b, a)) return std::nullopt;
      return NoImage{
          {Rule::kPolygonNotTiled, {.simplices = {sorted(a), sorted(b)}, .polygon = number_}}};
    };
    // All vertices are within reach of the plane. So triangles that project on each other are at most two
    // reaches apart.
    std::optional<BoxIndex> index;
    constexpr std::size_t kFew = 12;
    if (boxes.size() > kFew) index.emplace(boxes);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (index) {
        for (const std::size_t j : index->meeting(boxes[i])) {
          if (j <= i) continue;
          if (auto found = overlap(i, j)) return found;
        }
        continue;
      }
      for (std::size_t j = i + 1; j < boxes.size(); ++j) {
        if (auto found = overlap(i, j)) return found;
      }
    }
    return std::nullopt;
  }

  // Has the line through an edge of a triangle another one on its far side? Two counterclockwise triangles of the
  // plane have no interior points in common if, and only if, it is so for an edge of one of them.
  bool parts(const Simplex& triangle, const Simplex& other) const {
    for (const Edge& edge : edges(triangle)) {
      const bool beyond = std::all_of(other.begin(), other.end(), [&](Vertex v) {
        return v == edge.first || v == edge.second ||
               above_.turn({edge.first, edge.second, v}) <= 0;
      });
      if (beyond) return true;
    }
    return false;
  }

  tl::unexpected<NoImage> fault(const Edge& edge, const Simplex& triangle = {}) const {
    Witness witness{.face = sorted({edge.first, edge.second}), .polygon = number_};
    if (!triangle.empty()) witness.simplices = {sorted(triangle)};
    return tl::unexpected(NoImage{{Rule::kPolygonNotTiled, witness}});
  }

  const PointSet& points_;
  const std::vector<RoundedPoint>& rounded_;
  const Polygon& polygon_;
  std::size_t number_;
  const SeenFromAbove& above_;
  double reach_;              // at least
  std::vector<Simplex> own_;  // the domain's triangles, counterclockwise
  std::map<Edge, std::size_t> own_at_;
  std::map<Edge, Link> links_;
  std::vector<Simplex> candidates_;
  std::map<Edge, std::vector<std::size_t>> at_;  // candidates on the left of an edge
  std::vector<bool> lowest_;
  std::vector<bool> chosen_;
  std::vector<std::size_t> reached_, reference_;
  std::vector<Choice> choices_;
  std::size_t chosen_so_far_ = 0;
};

}  // namespace

// The triangle that is the polygon, if the only vertices near it are where its own three are.
std::optional<Simplex> Images::whole_triangle(std::size_t polygon) const {
  const Polygon& own = cells_.complex().polygons[polygon];
  if (own.triangles.size() != 1 || reaches_.near({2, polygon}).size() != 3) return std::nullopt;
  Simplex triangle;
  for (const Vertex v : own.triangles.front()) {
    const auto& near = reaches_.near({0, static_cast<std::size_t>(v)});
    if (near.empty() || sign(near.front().squared) != 0) return std::nullopt;
    triangle.push_back(near.front().vertex);
  }
  const auto& found = faces_.triangles_near(polygon);
  if (!std::binary_search(found.begin(), found.end(), sorted(triangle))) return std::nullopt;
  return triangle;
}

ImageOr<Patch> Images::found_patch(std::size_t polygon, const Rational& squared_reach) const {
  const PiecewiseLinearComplex& complex = cells_.complex();
  const Cell cell = {2, polygon};
  const SeenFromAbove seen(complex, rounded_domain_, polygon, mesh_.points, rounded_);
  if (const auto triangle = whole_triangle(polygon)) {
    return Patch{{seen.counterclockwise(*triangle)},
                 {seen.own(complex.polygons[polygon].triangles.front())}};
  }
  PatchSearch search(mesh_.points, rounded_, complex.polygons[polygon], polygon, seen,
                     upper_square_root(squared_reach));
  std::vector<Vertex> must_have;
  for (const Vertex v : complex.polygons[polygon].vertices) {
    must_have.push_back(*vertex(static_cast<std::size_t>(v), squared_reach));
  }
  for (const std::size_t s : cells_.segments_of(polygon)) {
    search.add_path(complex.segments[s], *path(s, squared_reach));
  }
  std::map<Vertex, bool> is_carried;
  for (const Reaches::ToVertex& near : reaches_.near(cell)) {
    if (near.squared > squared_reach) break;
    const Carrier carrier = reaches_.carrier(near.vertex, squared_reach);
    if (!carrier.is_one() || !cells_.is_in_closure(*carrier.cell, cell)) continue;
    is_carried[near.vertex] = true;
    if (*carrier.cell == cell) must_have.push_back(near.vertex);
  }
  for (const Simplex& triangle : faces_.triangles_near(polygon)) {
    if (std::all_of(triangle.begin(), triangle.end(),
                    [&](Vertex v) { return is_carried.contains(v); })) {
      search.add_candidate(triangle);
    }
  }
  const auto is_flat_above = [&](const Simplex& own) {
    const OrientedFacet down = OrientedFacet::of(own);  // counterclockwise: its front is below
    const bool below = regions_.where(regions_.in_front_of(down)) == Where::kInside;
    const bool above = regions_.where(regions_.in_front_of(down.reverse())) == Where::kInside;
    return above == below || above;
  };
  return search.found(must_have, is_flat_above);
}

}  // namespace circumspect::check
