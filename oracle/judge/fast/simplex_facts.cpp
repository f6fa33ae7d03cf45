#include "oracle/judge/fast/simplex_facts.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <optional>
#include <utility>

#include "oracle/judge/fast/box_tree.hpp"
#include "oracle/judge/fast/facet_matching.hpp"
#include "oracle/judge/fast/in_chunks.hpp"
#include "oracle/judge/fast/judge.hpp"
#include "oracle/judge/fast/predicates/lattice.hpp"
#include "oracle/judge/fast/predicates/predicates.hpp"
#include "oracle/judge/fast/sweep.hpp"

namespace circumspect::fast {

// ---- Balls at the boundary ----

namespace {

// Two doubles, and a number between them or equal to one.
struct Interval {
  double low, high;
};

// A result rounded to nearest has a relative error of at most 2^-53, or an absolute error of at
// most 2^-1075. Its bounds are moved outward by more than four times that, which the rounding of
// the move itself cannot undo.
Interval outward(double low, double high) {
  return {low - (std::fabs(low) * 0x1p-51 + 0x1p-1060),
          high + (std::fabs(high) * 0x1p-51 + 0x1p-1060)};
}
Interval operator+(Interval a, Interval b) { return outward(a.low + b.low, a.high + b.high); }
Interval operator-(Interval a, Interval b) { return outward(a.low - b.high, a.high - b.low); }
Interval operator*(Interval a, Interval b) {
  const auto [low, high] =
      std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
  return outward(low, high);
}
// Requires: 0 is not in b.
Interval operator/(Interval a, Interval b) {
  const auto [low, high] =
      std::minmax({a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high});
  return outward(low, high);
}

using IntervalPoint = std::array<Interval, 3>;

Interval inner(const IntervalPoint& a, const IntervalPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
IntervalPoint cross(const IntervalPoint& a, const IntervalPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Bounds on the circumball of a tetrahedron.
class BallInBounds {
 public:
  // Nothing if the tetrahedron is nearly flat, or its numbers differ too much in size.
  static std::optional<BallInBounds> of(const SiteRow<3>& row) {
    std::array<IntervalPoint, 3> from_last;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double a = row[i].at[axis], b = row[3].at[axis];
        if (!(std::fabs(a - b) <= kLargestScale)) return std::nullopt;
        from_last[i][axis] = outward(a - b, a - b);
      }
    }
    const auto& [a, b, c] = from_last;
    const IntervalPoint bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
    const Interval twice_volume = inner(a, bc) + inner(a, bc);
    if (twice_volume.low <= 0 && twice_volume.high >= 0) return std::nullopt;
    // The centre x, as seen from the last vertex, has 2 a·x = |a|², and the same for b and c.
    const Interval aa = inner(a, a), bb = inner(b, b), cc = inner(c, c);
    IntervalPoint centre;
    BallInBounds ball;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      centre[axis] = (aa * bc[axis] + bb * ca[axis] + cc * ab[axis]) / twice_volume;
      if (!std::isfinite(centre[axis].low) || !std::isfinite(centre[axis].high)) {
        return std::nullopt;
      }
      const double last = row[3].at[axis];
      ball.centre_[axis] = centre[axis] + Interval{last, last};
    }
    ball.far_ = inner(centre, centre).high * (1 + 0x1p-49) + 0x1p-1060;
    return ball;
  }

  // Is the whole box certainly outside? On each axis, its nearest point to the centre is at least
  // the gap away. The gaps, their squares and the sums are too large by at most a relative 6 ·
  // 2^-53 and an absolute 8 · 2^-1075.
  bool is_beyond(const AxisBox& box) const {
    double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double gap =
          std::max({0.0, box.low[axis] - centre_[axis].high, centre_[axis].low - box.high[axis]});
      sum += gap * gap;
    }
    return sum > far_ && std::isfinite(sum);
  }

 private:
  IntervalPoint centre_;
  double far_ = 0;  // no less than the square of the radius
};

// Also false if it would take long to find out.
template <typename Index>
bool have_empty_balls(const MeshView<3, Index>& mesh, const std::vector<FacetId>& boundary,
                      unsigned threads) {
  constexpr std::size_t kChunk = 256;
  constexpr std::size_t kSteps = 512;  // for each simplex, on average
  std::vector<std::size_t> simplices;  // facets of one follow each other
  for (const FacetId facet : boundary) {
    if (simplices.empty() || simplices.back() != facet.simplex()) {
      simplices.push_back(facet.simplex());
    }
  }
  std::vector<AxisBox> points;
  points.reserve(mesh.points());
  for (std::size_t v = 0; v < mesh.points(); ++v) {
    points.push_back(box_of_point(mesh.coordinates, v));
  }
  const BoxTree tree(std::move(points));
  const Lattice lattice = lattice_of_all(mesh.coordinates, {});
  const auto is_empty = [&](std::size_t s, std::size_t& steps) {
    SiteRow<3> row;
    for (std::size_t i = 0; i < 4; ++i) row[i] = mesh.template site<false>(mesh.row(s)[i]);
    const auto bounds = BallInBounds::of(row);
    if (!bounds) return false;
    Stages stages;  // not used: the sweep counts those of a mesh
    const Ball<3> ball = ball_of<3, false>(row, lattice);
    const int own = ball.orientation(stages);
    return tree.all_near(
        steps, [&](const AxisBox& box) { return bounds->is_beyond(box); },
        [&](std::uint32_t point) {
          const auto v = static_cast<Index>(point);
          const auto corners = mesh.row(s);
          return std::find(corners.begin(), corners.end(), v) != corners.end() ||
                 ball.contains(mesh.template site<false>(v), stages) * own <= 0;
        });
  };
  std::atomic<bool> all = true;
  in_chunks(simplices.size(), kChunk, threads,
            [&](std::size_t, std::size_t first, std::size_t last) {
              std::size_t steps = kSteps * kChunk;
              for (std::size_t i = first; i < last && all.load(std::memory_order_relaxed); ++i) {
                if (!is_empty(simplices[i], steps)) all.store(false, std::memory_order_relaxed);
              }
            });
  return all.load();
}

}  // namespace

// ---- Simplex facts ----

template <std::size_t kDimension, typename Index>
tl::expected<SimplexFacts, Undecided> simplex_facts(const MeshView<kDimension, Index>& mesh,
                                                    Wanted wanted, unsigned threads) {
  if (mesh.size() == 0) return tl::unexpected(Undecided::kEmpty);
  if (!are_finite(mesh.coordinates, threads)) return tl::unexpected(Undecided::kNotFinite);
  // Facets with the same vertices have the same hash: a facet without a link is in no other
  // simplex, and one with a link in no third. So two simplices with the same vertices would be
  // linked at all their facets, and neither has a vertex off a facet that the other lacks.
  const auto links = matched_facets(mesh, threads);
  if (!links) return tl::unexpected(links.error());
  if (!links->overused.empty()) return tl::unexpected(Undecided::kFacetOverused);
  WholeSweep<kDimension, Index, std::int32_t> sweep(mesh, links->view(), threads);
  Swept swept = sweep.run({.balls = wanted.balls, .ties = wanted.balls});
  if (swept.undecided) return tl::unexpected(*swept.undecided);
  SimplexFacts facts{
      .boundary = sweep.boundary().template facets<kDimension + 1>(links->view(), 0, mesh.size()),
      .not_local = std::move(swept.not_local),
      .ties = std::move(swept.ties),
      .not_canonical = std::move(swept.not_canonical),
      .oriented = sweep.orientations().are_equal(),
      .uses_all_points = sweep.unused().empty(),
      .stages = swept.stages};
  if (wanted.hull) {
    facts.fills_hull = judge(mesh, links->view(), Question::kTriangulation, threads).has_value();
  }
  if constexpr (kDimension == 3) {
    // This is not asked if a facet between two simplices is at fault.
    facts.boundary_balls_are_empty = wanted.boundary_balls && facts.not_local.empty() &&
                                     have_empty_balls(mesh, facts.boundary, threads);
  }
  return facts;
}

template tl::expected<SimplexFacts, Undecided> simplex_facts(const MeshView<2, std::int32_t>&,
                                                             Wanted, unsigned);
template tl::expected<SimplexFacts, Undecided> simplex_facts(const MeshView<2, std::int64_t>&,
                                                             Wanted, unsigned);
template tl::expected<SimplexFacts, Undecided> simplex_facts(const MeshView<3, std::int32_t>&,
                                                             Wanted, unsigned);
template tl::expected<SimplexFacts, Undecided> simplex_facts(const MeshView<3, std::int64_t>&,
                                                             Wanted, unsigned);

}  // namespace circumspect::fast
