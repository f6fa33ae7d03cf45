// The image of a polygon: docs/theory/within.md, 3.
#include <algorithm>
#include <array>
#include <map>

#include "kernel/boxes/box_index.hpp"
#include "kernel/exact/point.hpp"
#include "oracle/judge/within/images.hpp"
#include "oracle/judge/within/seen_from_above.hpp"

namespace circumspect::check {

namespace {

Vertex apex(const Simplex& triangle, const Edge& edge) {
  for (const Vertex v : triangle) {
    if (v != edge.first && v != edge.second) return v;
  }
  return -1;
}
Edge reverse(const Edge& edge) { return {edge.second, edge.first}; }

// Finds the image of one polygon: from the paths of its segments, on the sides on which the polygon
// lies, across all other edges. Where several triangles are on one side of an edge, there is
// something flat between them, which is to lie inside the domain or else above.
class PatchSearch {
 public:
  struct Link {
    std::size_t own;  // the domain's triangle on the left, if any
    bool has_own;
  };

  PatchSearch(const PointSet& points, const std::vector<RoundedPoint>& rounded,
              const Polygon& polygon, std::size_t number, const SeenFromAbove& above, double reach,
              Work& work)
      : points_(points),
        rounded_(rounded),
        polygon_(polygon),
        number_(number),
        above_(above),
        reach_(reach),
        work_(work) {
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
    const Link forward = link({segment[0], segment[1]}), backward = link({segment[1], segment[0]});
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      links_.emplace_back(Edge(path[i], path[i + 1]), forward);
      links_.emplace_back(Edge(path[i + 1], path[i]), backward);
    }
  }
  void add_candidate(const Simplex& triangle) {
    const int turn = above_.turn(triangle);
    if (turn == 0) return;
    candidates_.push_back(triangle);
    if (turn < 0) std::swap(candidates_.back()[1], candidates_.back()[2]);
    for (const Edge& edge : edges(candidates_.back())) {
      left_of_.emplace_back(edge, candidates_.size() - 1);
    }
  }

  // Once, after all paths and candidates.
  void finish() {
    std::sort(left_of_.begin(), left_of_.end());
    std::sort(links_.begin(), links_.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
  }

  // All candidates, if they are an image: then there is nothing to choose. Else something else or
  // nothing.
  ImageOr<Patch> all(const std::vector<Vertex>& must_have) {
    lowest_.assign(own_.size(), false);
    choices_.clear();
    return flooded(must_have);
  }

  // Which of several triangles beside an edge: the lowest, as seen with the normal upwards, if what
  // is flat is to lie above the patch.
  template <class IsFlatAbove>
  ImageOr<Patch> found(const std::vector<Vertex>& must_have, const IsFlatAbove& is_flat_above) {
    lowest_.clear();
    for (const Simplex& own : own_) lowest_.push_back(is_flat_above(own));
    choices_.clear();
    auto first = flooded(must_have);
    if (first) return first;
    // Every other series of choices, one after another.
    for (std::size_t tries = 1; next_choices(); ++tries) {
      if (tries == kMostTries || work_.is_too_much()) {
        first.error()->is_open = true;
        return first;
      }
      if (auto other = flooded(must_have)) return other;
    }
    return first;
  }

 private:
  static constexpr std::size_t kMostTries = 1000;

  // Of so many triangles beside an edge the one at this place, in their order from the first that
  // is wanted.
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
    std::vector<bool> has_left(left_of_.size(), false);  // by the first candidate there
    for (std::size_t next = 0; next < reached_.size(); ++next) {
      const Simplex& triangle = candidates_[reached_[next]];
      for (const Edge& edge : edges(triangle)) {
        auto has = has_left.begin() + (first_left_of(edge) - left_of_.begin());
        if (*has) return fault(edge, triangle);
        *has = true;
        if (const Link* const link = link_at(edge)) {
          if (!link->has_own) return fault(edge, triangle);
        } else if (!reach(reverse(edge), reference_[next])) {
          return fault(edge, triangle);
        }
      }
    }
    work_.add(4 * reached_.size() + 1);
    if (auto lacking = lacks(must_have)) return not_tiled(std::move(*lacking));
    if (auto folded = folds()) return not_tiled(std::move(*folded));
    Patch patch;
    for (std::size_t i = 0; i < reached_.size(); ++i) {
      patch.triangles.push_back(candidates_[reached_[i]]);
      patch.own.push_back(own_[reference_[i]]);
    }
    return patch;
  }

  // Takes the triangle on the left of an edge; false if there is none.
  bool reach(const Edge& edge, std::size_t own) {
    const auto first = first_left_of(edge);
    auto last = first;
    while (last != left_of_.end() && last->first == edge) ++last;
    if (first == last) return false;
    std::size_t best = first->second;
    if (last - first > 1) {
      std::vector<std::size_t> order;
      for (auto at = first; at != last; ++at) order.push_back(at->second);
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

  using LeftOf = std::vector<std::pair<Edge, std::size_t>>;
  LeftOf::const_iterator first_left_of(const Edge& edge) const {
    return std::lower_bound(left_of_.begin(), left_of_.end(), std::pair(edge, std::size_t{0}));
  }
  const Link* link_at(const Edge& edge) const {
    const auto at = std::lower_bound(links_.begin(), links_.end(), edge,
                                     [](const auto& one, const Edge& e) { return one.first < e; });
    return at != links_.end() && at->first == edge ? &at->second : nullptr;
  }

  // Is the second apex above (positive) or below the plane of edge and first apex?
  int side(const Edge& edge, Vertex first, Vertex second) const {
    const Point& from = points_[edge.first];
    return sign(inner_product(cross_product(points_[edge.second] - from, points_[first] - from),
                              points_[second] - from));
  }

  static tl::unexpected<std::shared_ptr<NoImage>> not_tiled(Witness witness) {
    return no_image(Rule::kPolygonNotTiled, std::move(witness));
  }

  std::optional<Witness> lacks(const std::vector<Vertex>& must_have) const {
    std::vector<Vertex> had;
    for (const std::size_t t : reached_) {
      had.insert(had.end(), candidates_[t].begin(), candidates_[t].end());
    }
    for (const auto& [edge, link] : links_) had.push_back(edge.first);
    std::sort(had.begin(), had.end());
    for (const Vertex v : must_have) {
      if (std::binary_search(had.begin(), had.end(), v)) continue;
      return Witness{.vertices = {v}, .polygon = number_};
    }
    return std::nullopt;
  }

  // Does the patch cover a point of the plane twice?
  std::optional<Witness> folds() const {
    std::vector<Box> boxes;
    for (const std::size_t t : reached_) {
      std::array<RoundedPoint, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) {
        corners[i] = rounded_[static_cast<std::size_t>(candidates_[t][i])];
      }
      boxes.push_back(box_about(corners, reach_));
    }
    const auto overlap = [&](std::size_t i, std::size_t j) -> std::optional<Witness> {
      const Simplex &a = candidates_[reached_[i]], &b = candidates_[reached_[j]];
      if (parts(a, b) || parts(b, a)) return std::nullopt;
      return Witness{.simplices = {sorted(a), sorted(b)}, .polygon = number_};
    };
    // All vertices are within reach of the plane. So triangles that project on each other are at
    // most two reaches apart.
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

  // Has the line through an edge of a triangle another one on its far side? Two counterclockwise
  // triangles of the plane have no interior points in common if, and only if, it is so for an edge
  // of one of them.
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

  tl::unexpected<std::shared_ptr<NoImage>> fault(const Edge& edge,
                                                 const Simplex& triangle = {}) const {
    Witness witness{.face = sorted({edge.first, edge.second}), .polygon = number_};
    if (!triangle.empty()) witness.simplices = {sorted(triangle)};
    return not_tiled(std::move(witness));
  }

  const PointSet& points_;
  const std::vector<RoundedPoint>& rounded_;
  const Polygon& polygon_;
  std::size_t number_;
  const SeenFromAbove& above_;
  double reach_;  // at least
  Work& work_;
  std::vector<Simplex> own_;  // the domain's triangles, counterclockwise
  std::map<Edge, std::size_t> own_at_;
  std::vector<std::pair<Edge, Link>> links_;
  std::vector<Simplex> candidates_;
  LeftOf left_of_;  // candidates on the left of an edge
  std::vector<bool> lowest_;
  std::vector<bool> chosen_;
  std::vector<std::size_t> reached_, reference_;
  std::vector<Choice> choices_;
  std::size_t chosen_so_far_ = 0;
};

}  // namespace

// Where only the images of its three vertices are near a triangle, theirs is its image or nothing
// is.
std::optional<Patch> Images::patch_of_triangle(std::size_t polygon, const SeenFromAbove& seen,
                                               const Rational& squared_reach) const {
  const std::vector<Simplex>& triangles = cells_.complex().polygons[polygon].triangles;
  if (triangles.size() != 1 || reaches_.near({2, polygon}).size() != 3) return std::nullopt;
  const Simplex own = seen.own(triangles.front());
  Simplex triangle;
  for (const Vertex v : own) {
    triangle.push_back(*vertex(static_cast<std::size_t>(v), squared_reach));
  }
  const auto& faces = faces_.triangles_near(polygon);
  const bool is_face = std::binary_search(faces.begin(), faces.end(), sorted(triangle));
  if (!is_face || seen.turn(triangle) <= 0) return std::nullopt;
  return Patch{{triangle}, {own}};
}

ImageOr<Patch> Images::found_patch(std::size_t polygon, const Rational& squared_reach) const {
  const PiecewiseLinearComplex& complex = cells_.complex();
  const Cell cell = {2, polygon};
  const SeenFromAbove seen = seen_from_above(polygon);
  if (auto patch = patch_of_triangle(polygon, seen, squared_reach)) return *std::move(patch);
  std::vector<Vertex> must_have;
  for (const Vertex v : complex.polygons[polygon].vertices) {
    must_have.push_back(*vertex(static_cast<std::size_t>(v), squared_reach));
  }
  std::vector<Vertex> carried;
  for (const Reaches::ToVertex& near : reaches_.near(cell)) {
    if (near.squared() > squared_reach) break;
    const Carrier carrier = reaches_.carrier(near.vertex, squared_reach);
    if (!carrier.is_one() || !cells_.is_in_closure(*carrier.cell, cell)) continue;
    carried.push_back(near.vertex);
    if (*carrier.cell == cell) must_have.push_back(near.vertex);
  }
  std::sort(carried.begin(), carried.end());
  std::vector<const Simplex*> candidates, named;
  work_.add(faces_.triangles_near(polygon).size());
  for (const Simplex& triangle : faces_.triangles_near(polygon)) {
    const bool is_candidate = std::all_of(triangle.begin(), triangle.end(), [&](Vertex v) {
      return std::binary_search(carried.begin(), carried.end(), v);
    });
    if (!is_candidate) continue;
    candidates.push_back(&triangle);
    if (cells_.is_marked(triangle, polygon)) named.push_back(&triangle);
  }
  const auto search_among = [&](const std::vector<const Simplex*>& triangles) {
    PatchSearch search(mesh_.points, rounded_, complex.polygons[polygon], polygon, seen,
                       pieces_.rounding().distance(squared_reach), work_);
    for (const std::size_t s : cells_.segments_of(polygon)) {
      search.add_path(complex.segments[s], *path(s, squared_reach));
    }
    for (const Simplex* const triangle : triangles) search.add_candidate(*triangle);
    search.finish();
    return search;
  };
  if (!named.empty()) {
    auto patch = search_among(named).all(must_have);
    if (patch && patch->triangles.size() == named.size()) return patch;
  }
  const auto is_flat_above = [&](const Simplex& own) {
    const OrientedFacet down = OrientedFacet::of(own);  // counterclockwise: its front is below
    return regions_.faces_inside(down.reverse()) || !regions_.faces_inside(down);
  };
  return search_among(candidates).found(must_have, is_flat_above);
}

}  // namespace circumspect::check
