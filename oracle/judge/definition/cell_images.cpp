#include "oracle/judge/definition/cell_images.hpp"

#include <algorithm>
#include <map>
#include <set>

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

// Have the projections of two triangles no interior points in common? That is so iff one has an
// edge with the other beyond it. Requires: both counterclockwise.
bool project_apart(const Point& normal, const Points& a, const Points& b) {
  const auto is_beyond_an_edge = [&](const Points& one, const Points& other) {
    bool is_beyond = false;
    for (std::size_t i = 0; i < 3; ++i) {
      is_beyond |= std::all_of(other.begin(), other.end(), [&](const Point& p) {
        return sign(area(normal, {one[i], one[(i + 1) % 3], p})) <= 0;
      });
    }
    return is_beyond;
  };
  return is_beyond_an_edge(a, b) || is_beyond_an_edge(b, a);
}

// The triangles at an edge, as half planes about it: a polygon, whether its triangle has the edge
// in this direction, and a direction in the half plane.
using HalfPlanes = std::map<std::pair<std::size_t, bool>, Point>;

HalfPlanes half_planes(const PointSet& points, const std::vector<std::vector<Simplex>>& triangles,
                       Vertex a, Vertex b) {
  HalfPlanes planes;
  for (std::size_t p = 0; p < triangles.size(); ++p) {
    for (const Simplex& t : triangles[p]) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (sorted({t[i], t[(i + 1) % 3]}) != sorted({a, b})) continue;
        planes[{p, t[i] == a}] = points[t[(i + 2) % 3]] - points[a];
      }
    }
  }
  return planes;
}

// Do some half planes stand about an axis in the cyclic order in which others do about theirs? Any
// three must follow each other in the same sense: of the angles from each to the next at least two
// are less than half a turn. (If two are the same half plane, neither sense has two such angles.)
bool stand_alike(const Point& axis_of_a, const HalfPlanes& a, const Point& axis_of_b,
                 const HalfPlanes& b) {
  const auto follow = [](const Point& axis, const Point& x, const Point& y, const Point& z) {
    const auto turn = [&](const Point& from, const Point& to) {
      return sign(inner_product(axis, cross_product(from, to))) > 0 ? 1 : 0;
    };
    return turn(x, y) + turn(y, z) + turn(z, x) >= 2;
  };
  for (const auto& [x, of_x] : a) {
    if (a.size() != b.size() || !b.contains(x)) return false;
  }
  for (const auto& [x, of_x] : a) {
    for (const auto& [y, of_y] : a) {
      for (const auto& [z, of_z] : a) {
        if (x == y || y == z || z == x) continue;
        if (follow(axis_of_a, of_x, of_y, of_z) != follow(axis_of_b, b.at(x), b.at(y), b.at(z))) {
          return false;
        }
      }
    }
  }
  return true;
}

class Imaging {
 public:
  Imaging(const MovedDomain& moved, const Carriers& carriers)
      : moved_(moved), complex_(moved.complex), points_(moved.mesh.points), carriers_(carriers) {
    for (std::size_t p = 0; p < complex_.polygons.size(); ++p) {
      const std::vector<Simplex>& triangles = complex_.polygons[p].triangles;
      const Points t = coordinates(complex_.points, triangles.front());
      const Point normal = cross_product(t[1] - t[0], t[2] - t[0]);
      normals_.push_back(normal < Point(3, 0) ? Rational(-1) * normal : normal);
      own_.emplace_back();
      for (const Simplex& own : triangles) {
        own_.back().push_back(counterclockwise(normals_[p], complex_.points, own));
      }
    }
  }

  tl::expected<CellImages, Violation> run() {
    const auto breach = [](Rule rule, const Witness& witness) {
      return tl::unexpected(Violation{rule, witness});
    };
    // 2. Each vertex v of P is the carrier of exactly one vertex φ(v) of M.
    for (std::size_t v = 0; v < complex_.points.size(); ++v) {
      const std::vector<Vertex> found = carried_by({0, v});
      if (found.size() != 1) {
        return breach(Rule::kDomainVertexMissing, {.domain_cell = Simplex{static_cast<Vertex>(v)}});
      }
      images_.vertices.push_back(found.front());
    }
    for (const Simplex& segment : complex_.segments) {
      auto path = path_of(segment);
      if (!path) return breach(Rule::kSegmentMissing, {.domain_cell = segment});
      images_.paths.push_back(std::move(*path));
    }
    for (std::size_t p = 0; p < complex_.polygons.size(); ++p) {
      auto patch = patch_of(p);
      if (!patch) return breach(Rule::kPolygonNotTiled, {.polygon = p});
      images_.patches.push_back(std::move(*patch));
    }
    if (!have_incidences_of_cells()) return breach(Rule::kImagesMeet, {});
    return std::move(images_);
  }

 private:
  std::vector<Vertex> carried_by(LinearCell cell) const {
    std::vector<Vertex> found;
    for (Vertex v = 0; points_.names(v); ++v) {
      if (carriers_[static_cast<std::size_t>(v)] == cell) found.push_back(v);
    }
    return found;
  }
  Vertex image(Vertex v) const { return images_.vertices[static_cast<std::size_t>(v)]; }
  static std::vector<Simplex> links(const std::vector<Vertex>& path) {
    std::vector<Simplex> links;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) links.push_back({path[i], path[i + 1]});
    return links;
  }
  static bool has(const std::vector<Simplex>& list, const Simplex& simplex) {
    return std::count(list.begin(), list.end(), simplex) > 0;
  }

  // 3. The path of uv: φ(u), then all vertices with the carrier uv, then φ(v). Their projections on
  // the line uv are strictly increasing in this order, and every two that follow each other are an
  // edge of M.
  std::optional<std::vector<Vertex>> path_of(const Simplex& segment) const {
    const Point along = complex_.points[segment[1]] - complex_.points[segment[0]];
    const auto before = [&](Vertex a, Vertex b) {
      return inner_product(points_[a], along) < inner_product(points_[b], along);
    };
    std::vector<Vertex> path = carried_by({1, images_.paths.size()});
    std::sort(path.begin(), path.end(), before);
    path.insert(path.begin(), image(segment[0]));
    path.push_back(image(segment[1]));
    for (const Simplex& link : links(path)) {
      if (!before(link[0], link[1]) || !is_edge(link)) return std::nullopt;
    }
    return path;
  }
  bool is_edge(const Simplex& link) const {
    const auto has_both = [&](const Simplex& simplex) {
      return contains(simplex, link[0]) && contains(simplex, link[1]);
    };
    const std::vector<Simplex> listed = moved_.mesh.simplices_and_faces();
    return std::any_of(listed.begin(), listed.end(), has_both);
  }

  // The choice of T_f: the triangles that are meant, if they satisfy 4. Else of all sets that do
  // the lowest if what is flat belongs above f, otherwise the highest: it belongs on the side that
  // is inside the domain, and above if that is neither or both.
  std::optional<std::vector<Simplex>> patch_of(std::size_t p) const {
    const Point& normal = normals_[p];
    std::vector<Simplex> meant, near;
    for (const Simplex& triangle : triangles_near(moved_, carriers_, p)) {
      const Simplex t = counterclockwise(normal, points_, triangle);
      if (sign(area(normal, coordinates(points_, t))) != 0) near.push_back(t);
      if (has(moved_.triangles_meant[p], triangle)) meant.push_back(t);
    }
    if (!meant.empty() && is_image(p, meant)) return meant;
    const auto is_inside = [&](const OrientedFacet& side) {
      return moved_.regions.where(moved_.regions.in_front_of(side)) == Where::kInside;
    };
    const OrientedFacet below = OrientedFacet::of(own_[p].front());
    const bool is_highest = is_inside(below) && !is_inside(below.reverse());
    std::optional<Rational> best;
    std::optional<std::vector<Simplex>> chosen;
    for (std::size_t bits = 0; bits < (std::size_t{1} << near.size()); ++bits) {
      std::vector<Simplex> some;
      for (std::size_t i = 0; i < near.size(); ++i) {
        if ((bits >> i) % 2 == 1) some.push_back(near[i]);
      }
      if (!is_image(p, some)) continue;
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
  bool is_image(std::size_t p, const std::vector<Simplex>& patch) const {
    // Its boundary is that of f with each segment replaced by its path. Each path of a segment of f
    // consists of edges of it.
    const Chain own_boundary = boundary_of(own_[p]);
    const std::vector<Simplex> edges = faces_of(patch, 2);
    Chain expected;
    for (std::size_t s = 0; s < complex_.segments.size(); ++s) {
      if (!has(complex_.polygons[p].segments, complex_.segments[s])) continue;
      const auto term = own_boundary.find(complex_.segments[s]);
      for (const Simplex& link : links(images_.paths[s])) {
        if (term != own_boundary.end()) add_to(expected, link[0], link[1], term->second);
        if (!has(edges, sorted(link))) return false;
      }
    }
    if (boundary_of(patch) != expected) return false;
    // φ(v) is a vertex of it for each vertex v of f, and so is every vertex with the carrier f.
    std::vector<Vertex> needed = carried_by({2, p});
    for (const Vertex v : complex_.polygons[p].vertices) needed.push_back(image(v));
    const std::vector<Simplex> vertices = faces_of(patch, 1);
    for (const Vertex v : needed) {
      if (!has(vertices, {v})) return false;
    }
    // In the projection on the plane of f none is flat, and no two have interior points in common.
    for (std::size_t i = 0; i < patch.size(); ++i) {
      const Points corners = coordinates(points_, patch[i]);
      if (sign(area(normals_[p], corners)) == 0) return false;
      for (std::size_t j = i + 1; j < patch.size(); ++j) {
        if (!project_apart(normals_[p], corners, coordinates(points_, patch[j]))) return false;
      }
    }
    return true;
  }

  std::set<Simplex> faces_of_image(LinearCell cell) const {
    std::vector<Simplex> simplices;
    if (cell.dimension == 0) simplices = {{images_.vertices[cell.place]}};
    if (cell.dimension == 1) simplices = links(images_.paths[cell.place]);
    if (cell.dimension == 2) simplices = images_.patches[cell.place];
    std::set<Simplex> found;
    for (const Simplex& simplex : simplices) {
      for (const Simplex& face : faces(sorted(simplex))) found.insert(face);
    }
    return found;
  }

  // 5. A simplex in the images of two cells is in the image of a common face of them. Around each
  // edge of the path of a segment the patches stand in the cyclic order of their polygons around
  // the segment.
  bool have_incidences_of_cells() const {
    const std::vector<LinearCell> cells = linear_cells(complex_);
    std::map<LinearCell, std::set<Simplex>> faces;
    for (const LinearCell cell : cells) faces[cell] = faces_of_image(cell);
    for (const LinearCell a : cells) {
      for (const LinearCell b : cells) {
        for (const Simplex& simplex : faces[a]) {
          if (!(a < b) || !faces[b].contains(simplex)) continue;
          const auto is_common_face = [&](LinearCell c) {
            return is_face(complex_, c, a) && is_face(complex_, c, b) && faces[c].contains(simplex);
          };
          if (std::none_of(cells.begin(), cells.end(), is_common_face)) return false;
        }
      }
    }
    for (std::size_t s = 0; s < complex_.segments.size(); ++s) {
      const Vertex u = complex_.segments[s][0], v = complex_.segments[s][1];
      const HalfPlanes expected = half_planes(complex_.points, own_, u, v);
      for (const Simplex& link : links(images_.paths[s])) {
        const HalfPlanes found = half_planes(points_, images_.patches, link[0], link[1]);
        if (found.size() > 2 && !stand_alike(complex_.points[v] - complex_.points[u], expected,
                                             points_[link[1]] - points_[link[0]], found)) {
          return false;
        }
      }
    }
    return true;
  }

  const MovedDomain& moved_;
  const PiecewiseLinearComplex& complex_;
  const PointSet& points_;
  const Carriers& carriers_;
  std::vector<Point> normals_;             // of each polygon
  std::vector<std::vector<Simplex>> own_;  // its triangles, counterclockwise
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
