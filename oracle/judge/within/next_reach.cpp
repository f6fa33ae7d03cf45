// The next reach at which a cell may have an image: docs/theory/within.md, A and A′.
#include <algorithm>
#include <array>
#include <iterator>

#include "kernel/exact/each_once.hpp"
#include "oracle/judge/within/images.hpp"

namespace circumspect::check {
namespace {

// What every image of a cell consists of, as long as its faces keep theirs.
struct Forced {
  std::vector<Vertex> vertices = {};  // ascending; the cell or a face of it carries each of them
  bool is_all = false;                // is that all that an image consists of?
  bool is_impossible = false;
};

// Goes from the paths of the segments of a polygon to the triangles beside them, and from these on,
// wherever just one triangle near the polygon is on the side of an edge on which the image has one.
class ForcedPatch {
 public:
  ForcedPatch(const std::vector<Simplex>& near, const SeenFromAbove& seen) {
    for (const Simplex& triangle : near) {
      const int turn = seen.turn(triangle);
      if (turn == 0) continue;
      triangles_.push_back(triangle);
      if (turn < 0) std::swap(triangles_.back()[1], triangles_.back()[2]);
      for (const Edge& edge : edges(triangles_.back())) {
        left_of_.emplace_back(edge, triangles_.size() - 1);
      }
    }
    std::sort(left_of_.begin(), left_of_.end());
    is_forced_.assign(triangles_.size(), false);
  }

  // Is the polygon on the left of an edge of a path?
  void add_link(const Edge& edge, bool has_own) { links_.emplace_back(edge, has_own); }

  // `must_have`: vertices that an image has in any case.
  Forced found(const std::vector<Vertex>& must_have) {
    std::sort(links_.begin(), links_.end());
    forced_.is_all = true;
    for (const auto& [edge, has_own] : links_) {
      if (has_own) take_left_of(edge);
    }
    for (std::size_t next = 0; next < reached_.size() && !forced_.is_impossible; ++next) {
      for (const Edge& edge : edges(triangles_[reached_[next]])) cross(edge);
    }
    for (const std::size_t t : reached_) {
      forced_.vertices.insert(forced_.vertices.end(), triangles_[t].begin(), triangles_[t].end());
    }
    keep_each_once(forced_.vertices);
    const auto has = [&](Vertex v) {
      return std::binary_search(forced_.vertices.begin(), forced_.vertices.end(), v);
    };
    if (forced_.is_all && !std::all_of(must_have.begin(), must_have.end(), has)) {
      forced_.is_impossible = true;
    }
    return std::move(forced_);
  }

 private:
  void cross(const Edge& edge) {
    const auto link = std::lower_bound(links_.begin(), links_.end(), std::pair(edge, false));
    if (link == links_.end() || link->first != edge) {
      take_left_of({edge.second, edge.first});
    } else if (!link->second) {
      forced_.is_impossible = true;  // the polygon is not on this side
    }
  }

  void take_left_of(const Edge& edge) {
    const auto first =
        std::lower_bound(left_of_.begin(), left_of_.end(), std::pair(edge, std::size_t{0}));
    if (first == left_of_.end() || first->first != edge) {
      forced_.is_impossible = true;
    } else if (const auto second = std::next(first);
               second != left_of_.end() && second->first == edge) {
      forced_.is_all = false;
    } else if (!is_forced_[first->second]) {
      is_forced_[first->second] = true;
      reached_.push_back(first->second);
    }
  }

  std::vector<Simplex> triangles_;  // counterclockwise
  std::vector<std::pair<Edge, std::size_t>> left_of_;
  std::vector<std::pair<Edge, bool>> links_;
  std::vector<bool> is_forced_;
  std::vector<std::size_t> reached_;
  Forced forced_;
};

// The least reach, from one on, at which a vertex has a carrier of the kind that is wanted; null if
// there is none.
template <class IsWanted>
const Rational* least_with_carrier(const Reaches& reaches, Vertex v, const Rational* from,
                                   const IsWanted& is_wanted) {
  while (!is_wanted(reaches.carrier(v, *from))) {
    const Rational* next = nullptr;
    for (const ToCell& to : reaches.of(v)) {
      if (to.squared() > *from && (next == nullptr || to.squared() < *next)) next = &to.squared();
    }
    if (next == nullptr) return nullptr;
    from = next;
  }
  return from;
}

Forced forced_patch(const Images& images, const Cells& cells, const MeshFaces& faces,
                    const SeenFromAbove& seen, std::size_t polygon, const Rational& squared_reach) {
  const PiecewiseLinearComplex& complex = cells.complex();
  ForcedPatch patch(faces.triangles_near(polygon), seen);
  std::vector<Edge> own;
  for (const Simplex& triangle : complex.polygons[polygon].triangles) {
    for (const Edge& edge : edges(seen.own(triangle))) own.push_back(edge);
  }
  std::sort(own.begin(), own.end());
  for (const std::size_t s : cells.segments_of(polygon)) {
    const Simplex& ends = complex.segments[s];
    const bool forward = std::binary_search(own.begin(), own.end(), Edge(ends[0], ends[1]));
    const bool backward = std::binary_search(own.begin(), own.end(), Edge(ends[1], ends[0]));
    const std::vector<Vertex>& path = *images.path(s, squared_reach);
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      patch.add_link({path[i], path[i + 1]}, forward);
      patch.add_link({path[i + 1], path[i]}, backward);
    }
  }
  std::vector<Vertex> must_have;
  for (const Vertex v : complex.polygons[polygon].vertices) {
    must_have.push_back(*images.vertex(static_cast<std::size_t>(v), squared_reach));
  }
  return patch.found(must_have);
}

// From the image of the first end on, as long as just one edge leads ahead along the segment.
// `places`: of the vertices near the segment, by these, where they project on it.
Forced forced_path(std::vector<std::pair<Vertex, const Rational*>> places, const MeshFaces& faces,
                   Vertex first, Vertex last) {
  std::sort(places.begin(), places.end());
  const auto place_of = [&](Vertex v) -> const Rational* {
    const auto at = std::lower_bound(places.begin(), places.end(), v,
                                     [](const auto& one, Vertex w) { return one.first < w; });
    return at != places.end() && at->first == v ? at->second : nullptr;
  };
  Forced forced;
  for (Vertex v = first; v != last;) {
    const Rational* const here = place_of(v);
    std::vector<Vertex> ahead;
    for (const auto& [from, to] : faces.edges_at(v)) {
      const Rational* const there = place_of(to);
      if (there != nullptr && *there > *here) ahead.push_back(to);
    }
    forced.is_impossible = ahead.empty();
    if (ahead.size() != 1) break;
    v = ahead.front();
    forced.vertices.push_back(v);
    forced.is_all = v == last;
  }
  keep_each_once(forced.vertices);
  return forced;
}

}  // namespace

std::optional<Rational> Images::next_reach(Cell cell, const Rational& squared_reach) const {
  const std::optional<Rational> next = next_change(cell, squared_reach);
  if (!next || cell.dimension == 0) return next;
  std::optional<Rational> next_of_faces;
  for (const Cell face : cells_.closure(cell)) {
    if (face == cell) continue;
    const auto of_face = next_change(face, squared_reach);
    if (of_face && (!next_of_faces || *of_face < *next_of_faces)) next_of_faces = of_face;
  }
  const Forced forced = [&] {
    if (cell.dimension == 2) {
      const SeenFromAbove seen = seen_from_above(cell.place);
      return forced_patch(*this, cells_, faces_, seen, cell.place, squared_reach);
    }
    std::vector<std::pair<Vertex, const Rational*>> places;
    for (const Place& place : places_along(cell.place))
      places.emplace_back(place.vertex, &place.at);
    const Simplex& ends = cells_.complex().segments[cell.place];
    return forced_path(std::move(places), faces_,
                       *vertex(static_cast<std::size_t>(ends[0]), squared_reach),
                       *vertex(static_cast<std::size_t>(ends[1]), squared_reach));
  }();
  if (forced.is_impossible) return next_of_faces;
  const auto is_in_it = [&](const Carrier& carrier) {
    return carrier.is_one() && cells_.is_in_closure(*carrier.cell, cell);
  };
  const auto is_not_it = [&](const Carrier& carrier) { return !carrier.is(cell); };
  const Rational* from = &squared_reach;
  for (;;) {
    const Rational* least = from;
    const auto wait_for = [&](const Rational* squared) {
      if (squared != nullptr && *squared > *least) least = squared;
      return squared != nullptr;
    };
    for (const Vertex v : forced.vertices) {
      if (!wait_for(least_with_carrier(reaches_, v, from, is_in_it))) return next_of_faces;
    }
    for (const Reaches::ToVertex& near : reaches_.near(cell)) {
      if (!forced.is_all || near.squared() > *from) break;
      if (std::binary_search(forced.vertices.begin(), forced.vertices.end(), near.vertex)) continue;
      if (!wait_for(least_with_carrier(reaches_, near.vertex, from, is_not_it))) {
        return next_of_faces;
      }
    }
    if (least == from) break;
    from = least;
    if (next_of_faces && *from >= *next_of_faces) return next_of_faces;
  }
  if (from != &squared_reach) return *from;
  return forced.is_all ? next_of_faces : next;
}

}  // namespace circumspect::check
