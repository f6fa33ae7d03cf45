#include "oracle/judge/definition/linear_cells.hpp"

#include <algorithm>
#include <utility>

#include "kernel/predicates/intersection.hpp"

namespace circumspect::definition {
namespace {

class LinearCells {
 public:
  explicit LinearCells(const PiecewiseLinearComplex& complex)
      : complex_(complex), points_(complex.points) {}

  bool are_complex() const {
    const std::vector<Polygon>& polygons = complex_.polygons;
    if (!vertices_and_segments_are_simplicial_complex()) return false;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
      if (!is_bounded_by_segments(polygons[i])) return false;
      for (const Simplex& segment : complex_.segments) {
        if (!lies_in_or_meets_in_ends(segment, polygons[i])) return false;
      }
      for (std::size_t j = i + 1; j < polygons.size(); ++j) {
        if (!meet_in_segments_and_vertices(polygons[i], polygons[j])) return false;
      }
    }
    return true;
  }

 private:
  using Corners = std::vector<Point>;

  Corners at(const Simplex& simplex) const { return coordinates(points_, simplex); }
  bool is_end(const Simplex& segment, const Point& p) const {
    return p == points_[segment[0]] || p == points_[segment[1]];
  }

  bool vertices_and_segments_are_simplicial_complex() const {
    for (const Simplex& a : complex_.segments) {
      for (const Point& p : points_.points()) {
        if (!is_end(a, p) && !intersection(at(a), {p}).empty()) return false;
      }
      for (const Simplex& b : complex_.segments) {
        if (a == b) continue;
        for (const Point& p : intersection(at(a), at(b))) {
          if (!is_end(a, p) || !is_end(b, p)) return false;
        }
      }
    }
    return true;
  }

  // An edge of one triangle of a polygon is on its boundary. (And the triangles are in one plane.)
  bool is_bounded_by_segments(const Polygon& polygon) const {
    if (polygon.triangles.empty()) return false;
    Corners corners;
    for (const Simplex& triangle : polygon.triangles) {
      for (const Point& p : at(triangle)) corners.push_back(p);
    }
    if (affine_hull(corners).dimension != 2) return false;
    const std::vector<FacetUse> uses = facet_uses(polygon.triangles);
    return std::all_of(uses.begin(), uses.end(), [&](const FacetUse& use) {
      const auto of_edge = std::count_if(uses.begin(), uses.end(), [&](const FacetUse& other) {
        return other.facet == use.facet;
      });
      return of_edge > 1 || segments_cover(points_[use.facet[0]], points_[use.facet[1]]);
    });
  }

  bool lies_in_or_meets_in_ends(const Simplex& segment, const Polygon& polygon) const {
    bool meets_in_ends = true;
    std::vector<Corners> parts;
    for (const Simplex& triangle : polygon.triangles) {
      parts.push_back(intersection(at(segment), at(triangle)));
      meets_in_ends &= parts.back().empty() ||
                       (parts.back().size() == 1 && is_end(segment, parts.back().front()));
    }
    return meets_in_ends || cover(parts, points_[segment[0]], points_[segment[1]]);
  }

  // A single point needs no look: it is on the boundary of one of them, which consists of segments,
  // or it is the end of a stretch that other triangles have in common.
  bool meet_in_segments_and_vertices(const Polygon& a, const Polygon& b) const {
    for (const Simplex& s : a.triangles) {
      for (const Simplex& t : b.triangles) {
        const Corners common = intersection(at(s), at(t));
        if (common.size() > 2) return false;
        if (common.size() == 2 && !segments_cover(common[0], common[1])) return false;
      }
    }
    return true;
  }

  bool segments_cover(const Point& p, const Point& q) const {
    std::vector<Corners> parts;
    for (const Simplex& segment : complex_.segments) {
      parts.push_back(intersection({p, q}, at(segment)));
    }
    return cover(std::move(parts), p, q);
  }

  // Is pq the union of some parts of it? Those that are not stretches add nothing.
  static bool cover(std::vector<Corners> parts, Point p, Point q) {
    if (q < p) std::swap(p, q);
    std::erase_if(parts, [](const Corners& part) { return part.size() < 2; });
    for (Corners& part : parts) std::sort(part.begin(), part.end());
    std::sort(parts.begin(), parts.end());
    for (const Corners& part : parts) {
      if (part.front() > p) return false;
      p = std::max(p, part.back());
    }
    return p == q;
  }

  const PiecewiseLinearComplex& complex_;
  const PointSet& points_;
};

}  // namespace

bool is_piecewise_linear_complex(const PiecewiseLinearComplex& complex) {
  return LinearCells(complex).are_complex();
}

}  // namespace circumspect::definition
