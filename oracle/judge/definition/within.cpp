#include "oracle/judge/definition/within.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "oracle/judge/definition/distance.hpp"

namespace circumspect::definition {
namespace {

using Points = std::vector<Point>;

class Reaches {
 public:
  explicit Reaches(const MovedDomain& moved) : moved_(moved), cells_(linear_cells(moved.complex)) {
    const PointSet& points = moved.mesh.points;
    for (Vertex v = 0; points.names(v); ++v) {
      std::map<LinearCell, Rational>& distances = distances_.emplace_back();
      if (!moved.used[static_cast<std::size_t>(v)]) continue;
      for (const LinearCell cell : cells_) {
        distances[cell] = distance({{points[v]}}, simplices_of(cell));
      }
    }
  }

  tl::expected<LeastReach, std::optional<Violation>> least(const Rational& squared_limit) {
    std::set<Rational> candidates = {0, squared_limit};
    for (const auto& of_vertex : distances_) {
      for (const auto& [cell, squared] : of_vertex) candidates.insert(squared);
    }
    std::optional<Violation> breach;
    bool was_ambiguous = false;
    for (const Rational& squared : candidates) {
      if (squared > squared_limit) break;
      if (takes_cells_for_each_other(squared)) {  // as at all larger reaches
        was_ambiguous = true;
        break;
      }
      bool is_ambiguous = false;
      Carriers carriers = carriers_at(squared, is_ambiguous);
      auto images = cell_images(moved_, carriers);
      if (images && !is_ambiguous) return LeastReach{squared, *images, carriers};
      was_ambiguous |= images.has_value();
      if (!images) breach = images.error();
    }
    return tl::unexpected(was_ambiguous ? std::nullopt : breach);
  }

  // 1. The cell of lowest dimension within reach of each vertex of M. If there are two of that
  // dimension, it has no carrier, and the reach is ambiguous.
  Carriers carriers_at(const Rational& squared_reach, bool& is_ambiguous) const {
    Carriers carriers;
    for (const auto& distances : distances_) {
      std::vector<LinearCell> lowest;
      for (const auto& [cell, squared] : distances) {
        const bool is_low = lowest.empty() || lowest.front().dimension == cell.dimension;
        if (squared <= squared_reach && is_low) lowest.push_back(cell);
      }
      carriers.push_back(lowest.size() == 1 ? std::optional(lowest.front()) : std::nullopt);
      is_ambiguous |= lowest.size() > 1;
    }
    return carriers;
  }

 private:
  // Have two vertices of M one vertex of P within reach? Or is the reach not 0, and two cells of P
  // that do not meet are at most three times as far apart?
  bool takes_cells_for_each_other(const Rational& squared_reach) {
    for (std::size_t v = 0; v < moved_.complex.points.size(); ++v) {
      const auto near =
          std::count_if(distances_.begin(), distances_.end(), [&](const auto& distances) {
            return !distances.empty() && distances.at({0, v}) <= squared_reach;
          });
      if (near > 1) return true;
    }
    if (sign(squared_reach) == 0) return false;
    if (apart_.empty()) {
      for (const LinearCell a : cells_) {
        for (const LinearCell b : cells_) {
          if (a < b) apart_.insert(distance(simplices_of(a), simplices_of(b)));
        }
      }
    }
    const auto least = apart_.upper_bound(0);
    return least != apart_.end() && *least <= 9 * squared_reach;
  }

  std::vector<Points> simplices_of(LinearCell cell) const {
    std::vector<Points> corners;
    for (const Simplex& simplex : circumspect::simplices_of(moved_.complex, cell)) {
      corners.push_back(coordinates(moved_.complex.points, simplex));
    }
    return corners;
  }
  static Rational distance(const std::vector<Points>& a, const std::vector<Points>& b) {
    Rational least = squared_distance_between(a.front(), b.front());
    for (const Points& s : a) {
      for (const Points& t : b) least = std::min(least, squared_distance_between(s, t));
    }
    return least;
  }

  const MovedDomain& moved_;
  std::vector<LinearCell> cells_;
  std::vector<std::map<LinearCell, Rational>> distances_;  // squared, of each vertex of M
  std::set<Rational> apart_;                               // and of each two cells, when asked
};

}  // namespace

tl::expected<LeastReach, std::optional<Violation>> least_reach(const MovedDomain& moved,
                                                               const Rational& squared_limit) {
  return Reaches(moved).least(squared_limit);
}

std::size_t most_triangles_near(const MovedDomain& moved, const Rational& squared_reach) {
  bool is_ambiguous = false;
  const Carriers carriers = Reaches(moved).carriers_at(squared_reach, is_ambiguous);
  std::size_t most = 0;
  for (std::size_t p = 0; p < moved.complex.polygons.size(); ++p) {
    most = std::max(most, triangles_near(moved, carriers, p).size());
  }
  return most;
}

}  // namespace circumspect::definition
