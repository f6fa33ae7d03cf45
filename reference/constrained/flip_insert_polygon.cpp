#include "reference/constrained/flip_insert_polygon.hpp"

#include <algorithm>
#include <cassert>
#include <compare>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "kernel/exact/progress.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "kernel/predicates/orientation.hpp"
#include "reference/constrained/cavity.hpp"
#include "reference/constrained/evolving_cdt.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/constrained/planar_cdt.hpp"
#include "reference/delaunay/flip.hpp"

namespace circumspect::constrained {
namespace {

std::strong_ordering ordering(const Rational& a, const Rational& b) {
  const int order = cmp(a, b);
  return order <=> 0;
}

// c_v for each of the five vertices: with the apex at −1 for the apex itself, the others are its
// barycentric coordinates in the tetrahedron. Multiplied by |det(tetrahedron)|.
std::vector<std::pair<Vertex, Rational>> affine_dependence(const PointSet& points,
                                                           const Simplex& tetrahedron,
                                                           Vertex apex) {
  const Configuration& configuration = points.configuration();
  const Rational own = orientation_determinant(configuration, kSpace, tetrahedron);
  std::vector<std::pair<Vertex, Rational>> dependence = {{apex, -abs(own)}};
  for (std::size_t place = 0; place < tetrahedron.size(); ++place) {
    const Simplex replaced = with_vertex_replaced(tetrahedron, place, apex);
    const Rational value = orientation_determinant(configuration, kSpace, replaced);
    dependence.emplace_back(tetrahedron[place], sign(own) * value);
  }
  return dependence;
}

}  // namespace

std::strong_ordering operator<=>(const EventTime& a, const EventTime& b) {
  if (const auto order = ordering(a.standard, b.standard); order != 0) return order;
  auto x = a.infinitesimal.begin();
  auto y = b.infinitesimal.begin();
  while (x != a.infinitesimal.end() || y != b.infinitesimal.end()) {
    const bool only_x =
        y == b.infinitesimal.end() || (x != a.infinitesimal.end() && x->first < y->first);
    if (only_x) return ordering(x->second, Rational(0));
    const bool only_y = x == a.infinitesimal.end() || y->first < x->first;
    if (only_y) return ordering(Rational(0), y->second);
    if (const auto order = ordering(x->second, y->second); order != 0) return order;
    ++x;
    ++y;
  }
  return std::strong_ordering::equal;
}

std::optional<EventTime> event_time(const PolygonInSpace& polygon, const Simplex& tetrahedron,
                                    Vertex apex) {
  const PointSet& points = polygon.points();
  const auto dependence = affine_dependence(points, tetrahedron, apex);
  Rational slope = 0;
  for (const auto& [v, c] : dependence) {
    if (polygon.side(v) > 0) slope += c * polygon.distance(v);
  }
  if (sign(slope) <= 0) return std::nullopt;
  EventTime time;
  for (const auto& [v, c] : dependence) {
    if (sign(c) == 0) continue;
    time.standard -= c * squared_length(points[v]);
    time.infinitesimal.emplace_back(points.configuration().rank(v), c / slope);
  }
  time.standard /= slope;
  std::sort(time.infinitesimal.begin(), time.infinitesimal.end());
  return time;
}

namespace {

// The flip that removes a facet: σ and the apex of τ, which share it.
struct Event {
  EventTime time;
  Simplex facet;
  Simplex tetrahedron;
  Vertex apex;

  bool operator<(const Event& other) const {
    const auto order = time <=> other.time;
    if (order != 0) return order < 0;
    return std::tie(facet, tetrahedron, apex) <
           std::tie(other.facet, other.tetrahedron, other.apex);
  }
};

class FlipInsertPolygon {
 public:
  FlipInsertPolygon(EvolvingCdt& cdt, const PolygonInSpace& polygon)
      : cdt_(cdt), polygon_(polygon) {}

  tl::expected<PolygonFlips, NoChange> run() {
    const std::set<Simplex> region = crossed_tetrahedra(cdt_.tetrahedra, polygon_);  // 1, 2
    before_.assign(region.begin(), region.end());
    now_ = region;
    done_.vertices = vertices_of(before_).size();
    for (const Simplex& facet : facets_of(before_)) certify(facet);  // Step 3.
    while (flip_first_admissible()) continue;                        // Step 4.
    if (const auto wrong = finish()) return tl::unexpected(*wrong);
    return std::move(done_);
  }

 private:
  void certify(const Simplex& facet) {
    if (!polygon_.parts(facet)) return;
    const std::vector<Simplex> sides = cdt_.tetrahedra.star(facet);
    if (sides.size() < 2) return;
    const Vertex apex = without(sides[1], facet).front();
    if (auto time = event_time(polygon_, sides[0], apex)) {
      queue_.insert({*std::move(time), facet, sides[0], apex});
    }
  }

  // Is the facet still there, between the same two tetrahedra? (If it is between others it has been
  // certified again since.)
  bool is_current(const Event& event) const {
    return cdt_.tetrahedra.has(event.tetrahedron) &&
           cdt_.tetrahedra.has(join(event.facet, {event.apex}));
  }

  bool is_in_region(const delaunay::ExtendedFlip& flip) const {
    return std::all_of(flip.deleted.begin(), flip.deleted.end(),
                       [&](const Simplex& tetrahedron) { return now_.contains(tetrahedron); });
  }

  // False if there is none.
  bool flip_first_admissible() {
    for (auto event = queue_.begin(); event != queue_.end();) {
      if (!is_current(*event)) {
        event = queue_.erase(event);
        continue;
      }
      const auto flip = delaunay::extended_flip(
          cdt_.tetrahedra,
          delaunay::basic_flip(polygon_.points(), event->tetrahedron, event->apex));
      if (flip && is_in_region(*flip)) {
        perform({event->time, *flip});
        queue_.erase(event);
        return true;
      }
      ++done_.held_back;
      ++event;
    }
    return false;
  }

  void perform(TimedFlip flip) {
    cdt_.tetrahedra.replace(flip.flip.deleted, flip.flip.created);
    for (const Simplex& tetrahedron : flip.flip.deleted) now_.erase(tetrahedron);
    now_.insert(flip.flip.created.begin(), flip.flip.created.end());
    for (const Simplex& facet : facets_of(flip.flip.created)) certify(facet);
    done_.flips.push_back(std::move(flip));
  }

  // The fault at time ∞, if there is one; then the flips are undone.
  //
  // If no event is left, the polygon is not crossed. Proof: let u be linear on each tetrahedron, 0
  // at vertices left of h and on it, d(v, h) at those right of it. No facet that the polygon
  // divides has an event to come, so u is convex across all of these. Where the polygon is crossed,
  // u is positive on it somewhere, and greatest where an edge crosses it; about that point u is
  // convex and so constant on h, and about all points to which this spreads. But u = 0 on the
  // segments of the polygon.
  //
  // Nor has any wall or segment been lost. All that a flip deletes has a face A, which it exchanges
  // for B, the other Radon part. Were A in a closed half-space of h, its u at the common point
  // would be d or 0, and no greater than that of B, so A would stay below and there would be no
  // event. And a wall or segment with vertices on both sides does not come near the polygon's
  // interior.
  std::optional<NoChange> finish() {
    std::optional<NoChange> wrong;
    if (!queue_.empty()) wrong = NoChange{WhyNoChange::kFlipBlocked, queue_.begin()->facet};
    assert(wrong || std::none_of(now_.begin(), now_.end(), [&](const Simplex& tetrahedron) {
             return polygon_.parts(tetrahedron);
           }));
    Change change{before_, {now_.begin(), now_.end()}};
    for (const Simplex& facet : facets_of(change.created)) {
      if (polygon_.is_coplanar(facet)) change.walls_added.insert(facet);
    }
    cdt_.tetrahedra.replace(change.created, change.deleted);
    if (!wrong) wrong = try_change(polygon_.points(), cdt_, change);
    return wrong;
  }

  EvolvingCdt& cdt_;
  const PolygonInSpace& polygon_;
  std::vector<Simplex> before_;  // the tetrahedra of the region R at time 0
  std::set<Simplex> now_;        // the current ones
  std::set<Event> queue_;
  PolygonFlips done_;
};

// Triangles whose union is the polygon, and which are facets of the CDT if the polygon is already
// there: those of its planar CDT (Proposition 4.11). For many vertices, computing these takes
// longer than seeing that some other triangles are not there.
std::vector<Simplex> likely_tiles(const PointSet& points, const Polygon& polygon) {
  constexpr std::size_t kFew = 16;
  const bool is_small = polygon.triangles.size() > 1 && polygon.vertices.size() <= kFew;
  return is_small ? planar_cdt(points, polygon) : polygon.triangles;
}

}  // namespace

tl::expected<PolygonFlips, NoChange> flip_insert_polygon(const PointSet& points, EvolvingCdt& cdt,
                                                         const Polygon& polygon) {
  for (const Simplex& segment : polygon.segments) {
    if (cdt.tetrahedra.star(segment).empty()) {
      return tl::unexpected(NoChange{WhyNoChange::kSegmentMissing, segment});
    }
  }
  const std::vector<Simplex> tiles = likely_tiles(points, polygon);
  const bool is_there = std::none_of(tiles.begin(), tiles.end(), [&](const Simplex& facet) {
    return cdt.tetrahedra.star(facet).empty();
  });
  if (is_there) {
    cdt.walls.insert(tiles.begin(), tiles.end());
    return PolygonFlips();
  }
  const PolygonInSpace in_space(points, polygon);
  auto run = FlipInsertPolygon(cdt, in_space).run();
  if (run) cdt.walls.merge(facets_included_in(cdt.tetrahedra, in_space));
  return run;
}

}  // namespace circumspect::constrained
