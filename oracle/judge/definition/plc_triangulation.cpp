#include "oracle/judge/definition/plc_triangulation.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "kernel/complex/measure.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/piecewise_linear/linear_cell.hpp"
#include "kernel/piecewise_linear/regions.hpp"
#include "kernel/predicates/intersection.hpp"
#include "kernel/predicates/orientation.hpp"
#include "oracle/judge/definition/distance.hpp"
#include "oracle/judge/definition/simplicial_complex.hpp"
#include "oracle/judge/definition/triangulation.hpp"

namespace circumspect::definition {
namespace {

using Axes = std::vector<std::size_t>;

// The measure (measure.hpp) of what two segments of one line, or triangles of one plane, have in
// common.
Rational common_measure(const Axes& axes, const std::vector<Point>& a,
                        const std::vector<Point>& b) {
  const std::vector<Point> corners = intersection(a, b);
  if (corners.empty()) return 0;
  if (axes.size() == 1) return abs(corners.back()[axes[0]] - corners.front()[axes[0]]);
  Rational twice = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    twice += cross_product(corners[i], corners[(i + 1) % corners.size()], axes[0], axes[1]);
  }
  return abs(twice);
}

class Judging {
 public:
  Judging(const ExactMesh& mesh, const PiecewiseLinearComplex& complex, bool may_have_more,
          Verdict& verdict)
      : mesh_(mesh), complex_(complex), may_have_more_(may_have_more), verdict_(verdict) {}

  std::optional<PiecewiseLinearComplex> run() {
    if (complex_.points.empty()) {
      for (const Simplex& s : listed_) verdict_.add(Rule::kOutside, {.simplices = {s}});
      judge_vertices_are_points(mesh_, verdict_);
      return std::nullopt;
    }
    if (!each_is_simplex() || !vertices_are_there() || !is_complex()) return std::nullopt;
    cells_are_unions();
    if (!is_triangulation_so_far()) return std::nullopt;
    union_is_domain();
    return is_triangulation_so_far() ? std::optional(augmented()) : std::nullopt;
  }

 private:
  bool each_is_simplex() {
    const bool faces_are = judge_each_face(mesh_, axes_.size(), verdict_);
    if (mesh_.points.dimension() < static_cast<int>(axes_.size())) {
      // All points lie in one hyperplane: whatever is not a triangle or edge is flat.
      for (const Simplex& simplex : mesh_.simplices) {
        verdict_.add(Rule::kWrongDimension, {.simplices = {simplex}});
      }
      return mesh_.simplices.empty() && faces_are;
    }
    return judge_each_simplex(mesh_, axes_.size() + 1, verdict_) && faces_are;
  }

  // Vertices are matched by their coordinates, for meshers number them as they like.
  bool vertices_are_there() {
    bool complete = true;
    const std::vector<Point>& points = mesh_.points.points();
    for (Vertex v = 0; complex_.points.names(v); ++v) {
      const Point& p = complex_.points[v];
      const auto at = std::find(points.begin(), points.end(), p);
      in_mesh_.push_back(at == points.end() ? -1 : at - points.begin());
      if (at != points.end()) continue;
      complete = false;
      verdict_.add(Rule::kDomainVertexMissing,
                   {.point = p, .domain_cell = Simplex{v}, .nearest = nearest_to({p})});
    }
    ExtraVertices extra;
    SteinerPoints count;
    for (Vertex v = 0; mesh_.points.names(v); ++v) {
      if (contains(in_mesh_, v)) continue;
      if (!is_used(v)) {
        verdict_.add(Rule::kUnusedPoint, {.vertices = {v}, .point = mesh_.points[v]});
        continue;
      }
      extra.add(v, verdict_.max_violations());
      if (!may_have_more_) verdict_.add(Rule::kSteinerForbidden, {.vertices = {v}});
      count.add(dimension_of_cell_with(v));
    }
    verdict_.extra_vertices = extra;
    if (complete) verdict_.steiner_points = count;
    return complete;
  }

  bool is_complex() {
    std::vector<Simplex> all = mesh_.simplices;
    std::set<Simplex> beside;  // a face that is listed twice does not overlap itself
    for (const Simplex& face : mesh_.faces) beside.insert(sorted(face));
    all.insert(all.end(), beside.begin(), beside.end());
    for (const Vertex v : in_mesh_) {
      if (!is_used(v)) all.push_back({v});
    }
    return judge_every_two(mesh_.points, all, verdict_);
  }

  // Every segment and every polygon is a union of simplices.
  void cells_are_unions() {
    for (const LinearCell cell : linear_cells(complex_)) {
      if (cell.dimension == 0) continue;
      const std::vector<Simplex> own = simplices_of(complex_, cell);
      const Axes axes = axes_of(complex_.points.configuration(), own.front());
      std::vector<Simplex>& parts = parts_[cell];
      for (const Simplex& simplex : faces_of(listed_, axes.size() + 1)) {
        if (is_part(simplex, own, axes)) parts.push_back(simplex);
      }
      const Rational whole = measure(complex_.points, axes, own);
      const Rational found = measure(mesh_.points, axes, parts);
      if (found == whole) continue;
      if (cell.dimension == 1) {
        verdict_.add(
            Rule::kSegmentMissing,
            {.values = {{"length along an axis", whole}, {"length of the edges in it", found}},
             .domain_cell = own.front(),
             .nearest = nearest_to(coordinates(complex_.points, own.front()))});
      } else {
        verdict_.add(Rule::kPolygonNotTiled,
                     {.values = {{"twice the area of its projection", whole},
                                 {"that of the triangles in it", found}},
                      .polygon = cell.place});
      }
    }
  }

  // |T| = |P|. By now no simplex crosses a polygon, so the domain has the whole of it if it has its
  // barycentre; a convex hull has it if it has its vertices.
  void union_is_domain() {
    const Regions regions(complex_);
    const bool is_hull = complex_.kind == DomainKind::kHull;
    for (const Simplex& simplex : mesh_.simplices) {
      std::vector<Point> samples = {barycentre(mesh_.points, simplex)};
      for (const Vertex v : simplex) {
        if (is_hull) samples.push_back(mesh_.points[v]);
      }
      for (const Point& sample : samples) {
        const Where where = regions.locate(sample);
        if (where != Where::kOutside && where != Where::kHole) continue;
        verdict_.add(Rule::kOutside, {.simplices = {simplex}, .point = sample});
        break;
      }
    }
    const bool has_inside = complex_.points.dimension() == static_cast<int>(axes_.size());
    if (is_hull && has_inside && mesh_.simplices.empty()) {
      verdict_.add(Rule::kUncovered, {.point = barycentre(complex_.points.points())});
    } else if (is_hull) {
      judge_union_is_hull(mesh_, Rule::kUncovered, verdict_);
    } else {
      const Rational whole = measure_of_inside(regions);
      const Rational found = measure(mesh_.points, axes_, mesh_.simplices);
      if (found < whole) {
        verdict_.add(Rule::kUncovered, {.values = {{"the domain's measure, times d!", whole},
                                                   {"that of the simplices", found}}});
      }
    }
    faces_are_in_domain();
  }

  // What is listed in lower dimensions is a face of a simplex, or lies in a segment or polygon.
  void faces_are_in_domain() {
    std::vector<Simplex> filling = mesh_.simplices;
    for (const auto& [cell, parts] : parts_) {
      filling.insert(filling.end(), parts.begin(), parts.end());
    }
    std::set<Simplex> dangling;  // listed faces of nothing larger
    for (const Simplex& face : mesh_.faces) {
      const auto is_larger = [&](const Simplex& simplex) {
        return simplex.size() > face.size() && has_face(simplex, face);
      };
      if (count_with_face(filling, face) == 0) verdict_.add(Rule::kOutside, {.simplices = {face}});
      if (std::none_of(listed_.begin(), listed_.end(), is_larger)) dangling.insert(sorted(face));
    }
    verdict_.dangling = dangling.size();
  }

  // The cones from one point over the sides of polygons (in the plane: segments) that face the
  // inside, with the sign of the side on which the point is.
  Rational measure_of_inside(const Regions& regions) const {
    Rational sum = 0;
    for (const Simplex& wall : walls(complex_)) {
      const OrientedFacet facet{sorted(wall), false};
      const Rational volume = orientation_determinant(complex_.points.configuration(), axes_,
                                                      with_apex(facet.vertices, 0));
      if (regions.faces_inside(facet)) sum += volume;
      if (regions.faces_inside(facet.reverse())) sum -= volume;
    }
    return sum;
  }
  bool is_triangulation_so_far() const {
    return std::all_of(verdict_.tallies().begin(), verdict_.tallies().end(),
                       [](const auto& tally) { return tally.first == Rule::kSteinerForbidden; });
  }

  PiecewiseLinearComplex augmented() const {
    PiecewiseLinearComplex result{mesh_.points, {}, {}, complex_.hole_seeds, complex_.kind};
    for (const auto& [cell, parts] : parts_) {
      if (cell.dimension == 2) result.polygons.push_back({{}, {}, {}, {}, parts});
      if (cell.dimension == 1) {
        result.segments.insert(result.segments.end(), parts.begin(), parts.end());
      }
    }
    return result;
  }

  bool is_used(Vertex v) const { return count_with_face(listed_, {v}) > 0; }
  // The dimension of the first cell of P that has a vertex of the mesh. Vertices are listed before
  // segments and these before polygons, so it lies in the relative interior of that cell.
  int dimension_of_cell_with(Vertex v) const {
    for (const LinearCell cell : linear_cells(complex_)) {
      for (const Simplex& own : simplices_of(complex_, cell)) {
        const std::vector<Point> corners = coordinates(complex_.points, own);
        if (!intersection(corners, {mesh_.points[v]}).empty()) return cell.dimension;
      }
    }
    return 3;  // a polyhedron
  }
  // Has the edge or triangle as much in common with a cell as with itself?
  bool is_part(const Simplex& simplex, const std::vector<Simplex>& cell, const Axes& axes) const {
    const std::vector<Point> corners = coordinates(mesh_.points, simplex);
    std::vector<Point> all = coordinates(complex_.points, cell.front());
    all.insert(all.end(), corners.begin(), corners.end());
    if (affine_hull(all).dimension != static_cast<int>(axes.size())) return false;
    Rational common = 0;
    for (const Simplex& own : cell) {
      common += common_measure(axes, corners, coordinates(complex_.points, own));
    }
    return common == measure(mesh_.points, axes, simplex);
  }

  // The vertex of the mesh that is nearest to a point or segment, without lying on it. It proves
  // nothing, but shows whether a coordinate was rounded.
  std::optional<NearestVertex> nearest_to(const std::vector<Point>& cell) const {
    std::optional<NearestVertex> nearest;
    for (Vertex v = 0; mesh_.points.names(v); ++v) {
      if (!is_used(v)) continue;
      const Rational squared = squared_distance_between({mesh_.points[v]}, cell);
      if (squared == 0 || (nearest && squared >= nearest->squared_distance)) continue;
      nearest = {v, squared};
    }
    return nearest;
  }

  const ExactMesh& mesh_;
  const PiecewiseLinearComplex& complex_;
  const bool may_have_more_;
  Verdict& verdict_;
  const Axes axes_ = {kSpace.begin(), kSpace.begin() + complex_.ambient_dimension()};
  const std::vector<Simplex> listed_ = mesh_.simplices_and_faces();
  std::vector<Vertex> in_mesh_;  // the point of the mesh that each vertex of P is, or −1
  // The edges and triangles in each segment and polygon of P.
  std::map<LinearCell, std::vector<Simplex>> parts_;
};

}  // namespace

std::optional<PiecewiseLinearComplex> judge_plc_triangulation(const ExactMesh& mesh,
                                                              const PiecewiseLinearComplex& complex,
                                                              bool may_have_more,
                                                              Verdict& verdict) {
  return Judging(mesh, complex, may_have_more, verdict).run();
}

}  // namespace circumspect::definition
