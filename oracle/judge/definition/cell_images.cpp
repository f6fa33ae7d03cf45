#include "oracle/judge/definition/cell_images.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "kernel/predicates/intersection.hpp"

namespace circumspect::definition {
namespace {

using Points = std::vector<Point>;

// An integer chain: edges, the lesser vertex first, with how often they are passed in this
// direction.
using Chain = std::map<Simplex, long>;

void add_to(Chain& chain, Vertex from, Vertex to, long times) {
  const auto term = chain.try_emplace(sorted({from, to}), 0).first;
  term->second += from < to ? times : -times;
  if (term->second == 0) chain.erase(term);
}
Chain boundary_of(const std::vector<Simplex>& triangles) {
  Chain chain;
  for (const Simplex& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) add_to(chain, t[i], t[(i + 1) % 3], 1);
  }
  return chain;
}

// Twice the area of the projection along the normal, times its length.
Rational area(const Point& normal, const Points& t) {
  return inner_product(normal, cross_product(t[1] - t[0], t[2] - t[0]));
}
Simplex counterclockwise(const Point& normal, const PointSet& points, Simplex t) {
  if (sign(area(normal, coordinates(points, t))) < 0) std::swap(t[1], t[2]);
  return t;
}

// The triangles at the edge ab are half planes about it, each named by its polygon and by whether
// its triangle has the edge in this direction. Their cyclic order: all triples x, y, z that follow
// each other counterclockwise, so that of the angles from each to the next at least two are less
// than half a turn. (If two are the same half plane, no order of the three is.)
using HalfPlane = std::pair<std::size_t, bool>;

std::set<std::array<HalfPlane, 3>> cyclic_order(const PointSet& points,
                                                const std::vector<std::vector<Simplex>>& triangles,
                                                const Simplex& ab) {
  std::map<HalfPlane, Point> planes;  // with a direction in each
  for (std::size_t p = 0; p < triangles.size(); ++p) {
    for (const Simplex& t : triangles[p]) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (sorted({t[i], t[(i + 1) % 3]}) != sorted(ab)) continue;
        planes[{p, t[i] == ab[0]}] = points[t[(i + 2) % 3]] - points[ab[0]];
      }
    }
  }
  const auto turn = [&](const Point& from, const Point& to) {
    return sign(inner_product(points[ab[1]] - points[ab[0]], cross_product(from, to))) > 0 ? 1 : 0;
  };
  std::set<std::array<HalfPlane, 3>> order;
  for (const auto& [x, of_x] : planes) {
    for (const auto& [y, of_y] : planes) {
      for (const auto& [z, of_z] : planes) {
        if (turn(of_x, of_y) + turn(of_y, of_z) + turn(of_z, of_x) >= 2) order.insert({x, y, z});
      }
    }
  }
  return order;
}

class Imaging {
 public:
  Imaging(const MovedDomain& moved, const Carriers& carriers) : moved_(moved), carriers_(carriers) {
    for (const Polygon& polygon : complex_.polygons) {
      const Points t = coordinates(complex_.points, polygon.triangles.front());
      const Point normal = cross_product(t[1] - t[0], t[2] - t[0]);
      normals_.push_back(normal < Point(3, 0) ? Rational(-1) * normal : normal);
      own_.emplace_back();
      for (const Simplex& triangle : polygon.triangles) {
        own_.back().push_back(counterclockwise(normals_.back(), complex_.points, triangle));
      }
    }
  }

  tl::expected<CellImages, Violation> run() {
    for (const LinearCell cell : cells_) {
      auto image = cell.dimension == 0   ? vertex_of(cell)
                   : cell.dimension == 1 ? path_of(cell)
                                         : patch_of(cell);
      if (!image) return tl::unexpected(has_no_image(cell));
      images_[cell] = std::move(*image);
    }
    if (!have_incidences_of_cells()) return tl::unexpected(Violation{Rule::kImagesMeet, {}});
    return std::move(images_);
  }

 private:
  using Image = std::vector<Simplex>;

  Violation has_no_image(LinearCell cell) const {
    if (cell.dimension == 2) return {Rule::kPolygonNotTiled, {.polygon = cell.place}};
    return {cell.dimension == 0 ? Rule::kDomainVertexMissing : Rule::kSegmentMissing,
            {.domain_cell = vertices_of(complex_, cell)}};
  }
  std::vector<Vertex> carried_by(LinearCell cell) const {
    std::vector<Vertex> found;
    for (Vertex v = 0; points_.names(v); ++v) {
      if (carriers_[static_cast<std::size_t>(v)] == cell) found.push_back(v);
    }
    return found;
  }
  // φ(v).
  Vertex image(Vertex v) const {
    return images_.at({0, static_cast<std::size_t>(v)}).front().front();
  }

  // 2. Each vertex v of P is the carrier of exactly one vertex φ(v) of M.
  std::optional<Image> vertex_of(LinearCell v) const {
    const std::vector<Vertex> found = carried_by(v);
    return found.size() == 1 ? std::optional<Image>({found}) : std::nullopt;
  }

  // 3. The path of uv: φ(u), then all vertices with the carrier uv, then φ(v). Their projections on
  // the line uv are strictly increasing in this order, and every two that follow each other are an
  // edge of M.
  std::optional<Image> path_of(LinearCell segment) const {
    const std::vector<Vertex> uv = vertices_of(complex_, segment);
    const Point along = complex_.points[uv[1]] - complex_.points[uv[0]];
    const auto before = [&](Vertex a, Vertex b) {
      return inner_product(points_[a], along) < inner_product(points_[b], along);
    };
    std::vector<Vertex> path = carried_by(segment);
    std::sort(path.begin(), path.end(), before);
    path.insert(path.begin(), image(uv[0]));
    path.push_back(image(uv[1]));
    Image links;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      links.push_back({path[i], path[i + 1]});
      if (!before(path[i], path[i + 1])) return std::nullopt;
      if (count_with_face(moved_.mesh.simplices_and_faces(), links.back()) == 0)
        return std::nullopt;
    }
    return links;
  }

  // The choice of T_f: the triangles that are meant, if they satisfy 4. Else of all sets that do
  // the lowest if what is flat belongs above f, otherwise the highest: it belongs on the side that
  // is inside the domain, and above if that is neither or both.
  std::optional<Image> patch_of(LinearCell f) const {
    const Point& normal = normals_[f.place];
    Image meant, near;
    for (const Simplex& triangle : triangles_near(moved_, carriers_, f.place)) {
      const Simplex t = counterclockwise(normal, points_, triangle);
      if (sign(area(normal, coordinates(points_, t))) != 0) near.push_back(t);
      if (count_with_face(moved_.triangles_meant[f.place], triangle) > 0) meant.push_back(t);
    }
    if (!meant.empty() && is_image(f, meant)) return meant;
    const OrientedFacet below = OrientedFacet::of(own_[f.place].front());
    const bool is_highest =
        moved_.regions.faces_inside(below) && !moved_.regions.faces_inside(below.reverse());
    std::optional<Rational> best;
    std::optional<Image> chosen;
    for (std::size_t bits = 0; bits < (std::size_t{1} << near.size()); ++bits) {
      Image some;
      for (std::size_t i = 0; i < near.size(); ++i) {
        if ((bits >> i) % 2 == 1) some.push_back(near[i]);
      }
      if (!is_image(f, some)) continue;
      Rational height = 0;  // times area, added up
      for (const Simplex& t : some) {
        const Points corners = coordinates(points_, t);
        height += area(normal, corners) * inner_product(normal, barycentre(corners));
      }
      if (is_highest) height = -height;
      if (best && *best <= height) continue;
      best = height;
      chosen = some;
    }
    return chosen;
  }

  // 4. Is it a patch of the polygon f? Its vertices have f or a face of f for carriers.
  bool is_image(LinearCell f, const Image& patch) const {
    // Its boundary is that of f with each segment replaced by its path. Each path of a segment of f
    // consists of edges of it.
    const Chain own_boundary = boundary_of(own_[f.place]);
    Chain expected;
    for (const LinearCell segment : cells_) {
      if (segment.dimension != 1 || !is_face(complex_, segment, f)) continue;
      const auto term = own_boundary.find(vertices_of(complex_, segment));
      for (const Simplex& link : images_.at(segment)) {
        if (term != own_boundary.end()) add_to(expected, link[0], link[1], term->second);
        if (count_with_face(patch, link) == 0) return false;
      }
    }
    if (boundary_of(patch) != expected) return false;
    // φ(v) is a vertex of it for each vertex v of f, and so is every vertex with the carrier f.
    std::vector<Vertex> needed = carried_by(f);
    for (const Vertex v : vertices_of(complex_, f)) needed.push_back(image(v));
    for (const Vertex v : needed) {
      if (count_with_face(patch, {v}) == 0) return false;
    }
    // In the projection on the plane of f none is flat, and no two have interior points in common.
    const Point& normal = normals_[f.place];
    std::vector<Points> projections;
    for (const Simplex& t : patch) {
      Points& corners = projections.emplace_back(coordinates(points_, t));
      for (Point& p : corners) p = p - inner_product(normal, p) / squared_length(normal) * normal;
      if (sign(area(normal, corners)) == 0) return false;
    }
    for (const Points& a : projections) {
      for (const Points& b : projections) {
        if (&a != &b && intersection(a, b).size() > 2) return false;
      }
    }
    return true;
  }

  // 5. A simplex in the images of two cells is in the image of a common face of them. Around each
  // edge of the path of a segment the patches stand in the cyclic order of their polygons around
  // the segment.
  bool have_incidences_of_cells() const {
    std::map<LinearCell, std::set<Simplex>> parts;
    std::vector<Image> patches;
    for (const auto& [cell, image] : images_) {
      if (cell.dimension == 2) patches.push_back(image);
      for (const Simplex& simplex : image) {
        for (const Simplex& face : faces(sorted(simplex))) parts[cell].insert(face);
      }
    }
    for (const LinearCell a : cells_) {
      for (const LinearCell b : cells_) {
        for (const Simplex& simplex : parts[a]) {
          if (!(a < b) || !parts[b].contains(simplex)) continue;
          const auto is_common_face = [&](LinearCell c) {
            return is_face(complex_, c, a) && is_face(complex_, c, b) && parts[c].contains(simplex);
          };
          if (std::none_of(cells_.begin(), cells_.end(), is_common_face)) return false;
        }
      }
      if (a.dimension != 1) continue;
      const auto expected = cyclic_order(complex_.points, own_, vertices_of(complex_, a));
      for (const Simplex& link : images_.at(a)) {
        if (cyclic_order(points_, patches, link) != expected) return false;
      }
    }
    return true;
  }

  const MovedDomain& moved_;
  const Carriers& carriers_;
  const PiecewiseLinearComplex& complex_ = moved_.complex;
  const PointSet& points_ = moved_.mesh.points;
  const std::vector<LinearCell> cells_ = linear_cells(complex_);
  std::vector<Point> normals_;  // of each polygon
  std::vector<Image> own_;      // its triangles, counterclockwise
  CellImages images_;
};

}  // namespace

std::vector<Simplex> triangles_near(const MovedDomain& moved, const Carriers& carriers,
                                    std::size_t polygon) {
  std::vector<Simplex> near = faces_of(moved.mesh.simplices_and_faces(), 3);
  std::erase_if(near, [&](const Simplex& triangle) {
    return std::any_of(triangle.begin(), triangle.end(), [&](Vertex v) {
      const auto& carrier = carriers[static_cast<std::size_t>(v)];
      return !carrier || !is_face(moved.complex, *carrier, {2, polygon});
    });
  });
  return near;
}

tl::expected<CellImages, Violation> cell_images(const MovedDomain& moved,
                                                const Carriers& carriers) {
  return Imaging(moved, carriers).run();
}

}  // namespace circumspect::definition
