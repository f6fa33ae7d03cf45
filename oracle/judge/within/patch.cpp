// The image of a polygon: docs/theory/within.md, 3.
#include <algorithm>
#include <array>

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

// Positive if the triangle is counterclockwise seen from where the normal points.
int turn(const PointSet& points, const Point& normal, const Simplex& t) {
  return sign(
      inner_product(normal, cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]])));
}

Simplex counterclockwise(const PointSet& points, const Point& normal, Simplex triangle) {
  if (turn(points, normal, triangle) < 0) std::swap(triangle[1], triangle[2]);
  return triangle;
}

// Whether triangles, counterclockwise in the plane, have interior points in common: not if a line through
// an edge of one of them has the other on its far side.
bool interiors_overlap(const std::array<Point, 3>& a, const std::array<Point, 3>& b) {
  const auto parts = [](const std::array<Point, 3>& one, const std::array<Point, 3>& other) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Point& from = one[i];
      const Point along = one[(i + 1) % 3] - from;
      const bool beyond = std::all_of(other.begin(), other.end(), [&](const Point& p) {
        const Point to = p - from;
        return sign(along[0] * to[1] - along[1] * to[0]) <= 0;
      });
      if (beyond) return true;
    }
    return false;
  };
  return !parts(a, b) && !parts(b, a);
}

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

// Finds the image of one polygon: from the paths of its segments, on the sides on which the polygon
// lies, across all other edges. Where several triangles are on one side of an edge, there is something
// flat between them, which is to lie inside the domain or else above.
class PatchSearch {
 public:
  struct Link {
    std::size_t own;  // the domain's triangle on the left, if any
    bool has_own;
  };

  PatchSearch(const ExactMesh& mesh, const PiecewiseLinearComplex& complex, std::size_t polygon)
      : points_(mesh.points),
        complex_(complex),
        polygon_(complex.polygons[polygon]),
        number_(polygon),
        normal_(normal_of(complex, polygon)) {
    for (std::size_t t = 0; t < polygon_.triangles.size(); ++t) {
      own_.push_back(counterclockwise(complex.points, normal_, polygon_.triangles[t]));
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
    if (turn(points_, normal_, triangle) == 0) return;
    candidates_.push_back(counterclockwise(points_, normal_, triangle));
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
    if (reached_.size() < 2) return std::nullopt;
    const Point& origin = complex_.points[own_.front()[0]];
    const Point u = complex_.points[own_.front()[1]] - origin;
    const Point w = cross(normal_, u);
    std::vector<std::array<Point, 3>> flat;
    std::vector<Box> boxes;
    for (const std::size_t t : reached_) {
      std::array<Point, 3>& corners = flat.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const Point to = points_[candidates_[t][i]] - origin;
        corners[i] = {inner_product(to, u), inner_product(to, w)};
      }
      boxes.push_back(box_around(box_around(box_around(corners[0]), box_around(corners[1])),
                                 box_around(corners[2])));
    }
    const BoxIndex index(boxes);
    for (std::size_t i = 0; i < flat.size(); ++i) {
      for (const std::size_t j : index.meeting(boxes[i])) {
        if (j <= i || !interiors_overlap(flat[i], flat[j])) continue;
        return NoImage{
            {Rule::kPolygonNotTiled,
             {.simplices = {sorted(candidates_[reached_[i]]), sorted(candidates_[reached_[j]])},
              .polygon = number_}}};
      }
    }
    return std::nullopt;
  }

  tl::unexpected<NoImage> fault(const Edge& edge, const Simplex& triangle = {}) const {
    Witness witness{.face = sorted({edge.first, edge.second}), .polygon = number_};
    if (!triangle.empty()) witness.simplices = {sorted(triangle)};
    return tl::unexpected(NoImage{{Rule::kPolygonNotTiled, witness}});
  }

  const PointSet& points_;
  const PiecewiseLinearComplex& complex_;
  const Polygon& polygon_;
  std::size_t number_;
  Point normal_;
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

ImageOr<Patch> Images::patch(std::size_t polygon, const Rational& squared_reach) const {
  const PiecewiseLinearComplex& complex = cells_.complex();
  const Cell cell = {2, polygon};
  PatchSearch search(mesh_, complex, polygon);
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
