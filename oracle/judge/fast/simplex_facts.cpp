#include "oracle/judge/fast/simplex_facts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "kernel/boxes/interval.hpp"
#include "kernel/exact/triple.hpp"
#include "oracle/judge/fast/box_tree.hpp"
#include "oracle/judge/fast/facet_matching.hpp"
#include "oracle/judge/fast/in_chunks.hpp"
#include "oracle/judge/fast/judge.hpp"
#include "oracle/judge/fast/predicates/lattice.hpp"
#include "oracle/judge/fast/predicates/predicates.hpp"
#include "oracle/judge/fast/sweep.hpp"

namespace circumspect::fast {

namespace {

using IntervalPoint = Triple<Interval>;

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
        from_last[i][axis] = exactly(a) - exactly(b);
      }
    }
    const auto& [a, b, c] = from_last;
    const IntervalPoint bc = cross_product(b, c), ca = cross_product(c, a),
                        ab = cross_product(a, b);
    const Interval twice_volume = inner_product(a, bc) + inner_product(a, bc);
    if (certain_sign(twice_volume) == 0) return std::nullopt;
    // The centre x, as seen from the last vertex, has 2 a·x = |a|², and the same for b and c.
    const Interval aa = inner_product(a, a), bb = inner_product(b, b), cc = inner_product(c, c);
    IntervalPoint centre;
    BallInBounds ball;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      centre[axis] = (aa * bc[axis] + bb * ca[axis] + cc * ab[axis]) / twice_volume;
      if (!std::isfinite(centre[axis].low) || !std::isfinite(centre[axis].high)) {
        return std::nullopt;
      }
      ball.centre_[axis] = centre[axis] + exactly(row[3].at[axis]);
    }
    ball.far_ = inner_product(centre, centre).high;
    return ball;
  }

  // Is the whole box certainly outside?
  bool is_beyond(const AxisBox& box) const {
    return least_squared_distance(box.low, box.high, centre_) > far_;
  }

 private:
  IntervalPoint centre_;
  double far_ = 0;  // no less than the square of the radius
};

// The simplices with these facets whose balls are not empty, and those for which it would take long
// to find out.
template <typename Index>
std::vector<std::size_t> doubtful_balls(const MeshView<3, Index>& mesh,
                                        const std::vector<FacetId>& boundary, unsigned threads) {
  constexpr std::size_t kChunk = 256;
  constexpr std::size_t kSteps = 1 << 14;  // for each simplex
  std::vector<std::size_t> simplices;      // facets of one follow each other
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
  const auto is_empty = [&](std::size_t s) {
    const SiteRow<3> row = mesh.template sites<false>(s);
    const auto bounds = BallInBounds::of(row);
    if (!bounds) return false;
    Stages stages;  // not used: the sweep counts those of a mesh
    const Ball<3> ball = ball_of<3, false>(row, lattice);
    const int own = ball.orientation(stages);
    std::size_t steps = kSteps;
    return tree.all_near(
        steps, [&](const AxisBox& box) { return bounds->is_beyond(box); },
        [&](std::uint32_t point) {
          const auto v = static_cast<Index>(point);
          const auto corners = mesh.row(s);
          return std::find(corners.begin(), corners.end(), v) != corners.end() ||
                 ball.contains(mesh.template site<false>(v), stages) * own <= 0;
        });
  };
  std::vector<std::vector<std::size_t>> parts(chunks_of(simplices.size(), kChunk));
  in_chunks(simplices.size(), kChunk, threads,
            [&](std::size_t chunk, std::size_t first, std::size_t last) {
              for (std::size_t i = first; i < last; ++i) {
                if (!is_empty(simplices[i])) parts[chunk].push_back(simplices[i]);
              }
            });
  std::vector<std::size_t> doubtful;
  for (const auto& part : parts) doubtful.insert(doubtful.end(), part.begin(), part.end());
  return doubtful;
}

}  // namespace

template <std::size_t kDimension, typename Index>
tl::expected<SimplexFacts, Undecided> simplex_facts(const MeshView<kDimension, Index>& mesh,
                                                    Wanted wanted, unsigned threads) {
  if (mesh.size() == 0) return tl::unexpected(Undecided::kEmpty);
  if (!are_finite(mesh.coordinates, threads)) return tl::unexpected(Undecided::kNotFinite);
  // Facets with the same vertices have the same hash: a facet without a link is in no other
  // simplex, and one with a link in no third. So two simplices with the same vertices would be
  // linked at all their facets, and neither has a vertex off a facet that the other lacks.
  const auto links =
      matched_facets(mesh, threads, wanted.pairs_suffice ? Proposal::kLikely : Proposal::kComplete);
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
      .positive = sweep.orientations().positive(mesh.size()),
      .uses_all_points = sweep.unused().empty(),
      .stages = swept.stages};
  if (wanted.hull) {
    facts.fills_hull = judge(mesh, links->view(), Question::kTriangulation, threads).has_value();
  }
  if constexpr (kDimension == 3) {
    if (wanted.boundary_balls) facts.doubtful_balls = doubtful_balls(mesh, facts.boundary, threads);
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
