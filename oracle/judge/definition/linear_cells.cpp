#include "oracle/judge/definition/linear_cells.hpp"

#include <algorithm>
#include <utility>

#include "kernel/complex/improper_intersection.hpp"
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

  bool vertices_and_segments_are_simplicial_complex() const {
    std::vector<Simplex> simplices = complex_.segments;
    for (const Vertex v : all_vertices(points_)) simplices.push_back({v});
    for (std::size_t a = 0; a < simplices.size(); ++a) {
      for (std::size_t b = a + 1; b < simplices.size(); ++b) {
        if (improper_intersection(points_, simplices[a], simplices[b])) return false;
      }
    }
    return true;
  }

  // An edge of one triangle of a polygon is on its boundary. (And the triangles are in one plane.)
  bool is_bounded_by_segments(const Polygon& polygon) const {
    const std::vector<Simplex>& triangles = polygon.triangles;
    Simplex corners;
    for (const Simplex& t : triangles) corners.insert(corners.end(), t.begin(), t.end());
    if (affine_hull(at(corners)).dimension != 2) return false;
    for (const Simplex& edge : faces_of(triangles, 2)) {
      if (count_with_face(triangles, edge) > 1) continue;
      if (!segments_cover(points_[edge[0]], points_[edge[1]])) return false;
    }
    return true;
  }

  bool lies_in_or_meets_in_ends(const Simplex& segment, const Polygon& polygon) const {
    const Corners ends = at(segment);
    bool meets_in_ends = true;
    std::vector<Corners> parts;
    for (const Simplex& triangle : polygon.triangles) {
      parts.push_back(intersection(ends, at(triangle)));
      meets_in_ends &= parts.back().empty() || parts.back() == Corners{ends[0]} ||
                       parts.back() == Corners{ends[1]};
    }
    return meets_in_ends || cover(parts, ends[0], ends[1]);
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
