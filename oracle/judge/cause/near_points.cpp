// Points that no simplex has, since a program took each for another one near it.
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "kernel/exact/point.hpp"
#include "oracle/judge/cause/rows.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::check {
namespace {

// Each is compared with all other points.
constexpr std::size_t kMostLeftOut = 64;
// How near, in parts of the extent of the mesh. Whether the claim holds without them is judged.
constexpr double kNearInExtent = 1e-6;

using Places = std::vector<std::vector<double>>;

Places places_of(const Mesh& mesh) {
  Places places(mesh.points());
  for (std::size_t v = 0; v < places.size(); ++v) {
    for (const Rational& x : mesh.point(static_cast<Vertex>(v))) places[v].push_back(x.get_d());
  }
  return places;
}

double extent_of(const Places& places) {
  double extent = 0;
  for (std::size_t axis = 0; axis < places.front().size(); ++axis) {
    const auto [least, most] =
        std::minmax_element(places.begin(), places.end(),
                            [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; });
    extent = std::max(extent, (*most)[axis] - (*least)[axis]);
  }
  return extent;
}

double squared_distance_of(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t axis = 0; axis < a.size(); ++axis) {
    sum += (a[axis] - b[axis]) * (a[axis] - b[axis]);
  }
  return sum;
}

// The greatest squared distance of one of these from the nearest point that is none of them;
// nothing if that is not near.
std::optional<Rational> farthest_from_others(const Mesh& mesh, const std::vector<Vertex>& unused) {
  const Places places = places_of(mesh);
  const double most = kNearInExtent * extent_of(places);
  Rational farthest = 0;
  for (const Vertex v : unused) {
    std::optional<Vertex> nearest;
    double least = most * most;
    for (std::size_t w = 0; w < places.size(); ++w) {
      if (std::binary_search(unused.begin(), unused.end(), static_cast<Vertex>(w))) continue;
      const double distance = squared_distance_of(places[static_cast<std::size_t>(v)], places[w]);
      if (distance >= least) continue;
      least = distance;
      nearest = static_cast<Vertex>(w);
    }
    if (!nearest) return std::nullopt;
    farthest = std::max(farthest, squared_distance(mesh.point(v), mesh.point(*nearest)));
  }
  return farthest;
}

// Requires: ascending, and of no simplex.
Mesh without_points(const Mesh& mesh, const std::vector<Vertex>& points) {
  const auto is_one = [&](std::size_t v) {
    return std::binary_search(points.begin(), points.end(), static_cast<Vertex>(v));
  };
  Mesh other;
  other.coordinates = std::visit(
      [&]<class Value>(const Rows<Value>& rows) -> Numbers {
        Rows<Value> kept(rows.rows() - points.size(), rows.columns());
        for (std::size_t v = 0, to = 0; v < rows.rows(); ++v) {
          if (is_one(v)) continue;
          std::copy(rows.row(v).begin(), rows.row(v).end(), kept.row(to++).begin());
        }
        return kept;
      },
      mesh.coordinates);
  other.simplices = mesh.simplices.visit([&]<class Lists>(const Lists& lists) -> IndexLists {
    if constexpr (std::is_same_v<Lists, std::vector<Simplex>>) {
      return {};
    } else {
      Lists renumbered(lists.rows(), lists.columns());
      std::transform(lists.values().begin(), lists.values().end(), renumbered.values().begin(),
                     [&](auto v) {
                       const auto before = std::lower_bound(points.begin(), points.end(), v);
                       return static_cast<decltype(v)>(v - (before - points.begin()));
                     });
      return renumbered;
    }
  });
  return other;
}

}  // namespace

std::optional<Cause> near_points(Case& of) {
  // Of points with weights, some need not be vertices; the claim `complex` lets others pass.
  const Claim claim = of.verdict().claim();
  const bool are_needed = claim == Claim::kTriangulation || claim == Claim::kDelaunay;
  const std::size_t count = of.count(Rule::kUnusedPoint);
  if (!are_needed || count > kMostLeftOut || of.breaks(Rule::kUnknownVertex)) return std::nullopt;
  const std::vector<Vertex> unused = unused_points(of.mesh(), kMostLeftOut);
  if (unused.size() != count) return std::nullopt;
  const auto farthest = farthest_from_others(of.mesh(), unused);
  if (!farthest) return std::nullopt;
  const auto mended = of.mended(without_points(of.mesh(), unused));
  const bool is_one = count == 1;
  const std::string words = fmt::format(
      "{} {} in no {}, {}at most {} from another point, as if taken for {}{}",
      report::counted(count, "point"), is_one ? "is" : "are",
      report::simplices_noun(static_cast<int>(of.mesh().dimension()), 1), is_one ? "and " : "each ",
      report::square_root_rounded_up(*farthest), is_one ? "it" : "that",
      mended && mended->holds
          ? (is_one ? ": without it the claim holds" : ": without them the claim holds")
          : "");
  return of.cause("near-points", words, mended && mended->holds ? of.violations() : count);
}

}  // namespace circumspect::check
