#include "oracle/judge/within/image_set.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <span>

#include "kernel/exact/point.hpp"

namespace circumspect::check {
namespace {

// The edge or triangle of a patch, or nothing but the polygon, that a fault is about.
Misplaced fault(const Cells& cells, Cell a, Cell b, const Simplex& face) {
  Witness witness{.face = face, .polygon = b.place};
  if (a.dimension == 1) witness.domain_cell = cells.complex().segments[a.place];
  return {a, b, {Rule::kImagesMeet, witness}};
}

// Half a plane at an axis: on which side of which polygon it is, and a direction in it.
struct HalfPlane {
  std::size_t polygon;
  bool left;
  Point direction;
};

// The half planes in order about the axis, from the first of them; nothing if two are the same.
std::optional<std::vector<std::pair<std::size_t, bool>>> order_about(
    const Point& axis, const std::vector<HalfPlane>& planes) {
  const auto turn = [&](const HalfPlane& a, const HalfPlane& b) {
    return sign(inner_product(axis, cross_product(a.direction, b.direction)));
  };
  // The part of a direction that is at right angles to the axis.
  const auto across = [&](const Point& p) {
    return p - (inner_product(p, axis) / squared_length(axis)) * axis;
  };
  const HalfPlane& first = planes.front();
  const Point ahead = across(first.direction);
  const auto part = [&](const HalfPlane& plane) {
    if (&plane == &first) return 0;
    const int side = turn(first, plane);
    if (side != 0) return side > 0 ? 2 : 4;
    return sign(inner_product(ahead, across(plane.direction))) > 0 ? 1 : 3;
  };
  std::vector<std::pair<int, const HalfPlane*>> order;
  for (const HalfPlane& plane : planes) order.emplace_back(part(plane), &plane);
  const auto before = [&](const auto& a, const auto& b) {
    if (a.first != b.first) return a.first < b.first;
    return a.second != b.second && turn(*a.second, *b.second) > 0;
  };
  std::sort(order.begin(), order.end(), before);
  std::vector<std::pair<std::size_t, bool>> names;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (order[i].first == 1) return std::nullopt;
    if (i > 0 && !before(order[i - 1], order[i])) return std::nullopt;
    names.emplace_back(order[i].second->polygon, order[i].second->left);
  }
  return names;
}

// A face of an image, by its vertices ascending (−1 in front of those of an edge), and whose it is.
struct FaceOf {
  std::array<Vertex, 3> face;
  std::size_t cell;
  std::size_t triangle = 0;  // of the patch
  std::size_t place = 0;     // opposite which vertex of it an edge is

  Simplex vertices() const {
    return face[0] < 0 ? Simplex{face[1], face[2]} : Simplex{face[0], face[1], face[2]};
  }
};
std::array<Vertex, 3> edge_key(Vertex a, Vertex b) { return {-1, std::min(a, b), std::max(a, b)}; }

class Placing {
 public:
  Placing(const ImageSet& images, const ExactMesh& mesh, const Cells& cells)
      : images_(images), points_(mesh.points), cells_(cells), complex_(cells.complex()) {
    for (std::size_t s = 0; s < images.paths.size(); ++s) {
      const std::vector<Vertex>& path = images.paths[s];
      for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        links_.push_back({edge_key(path[i], path[i + 1]), s});
      }
    }
    sort(links_);
    for (std::size_t p = 0; p < images_.patches.size(); ++p) {
      for (std::size_t t = 0; t < images_.patches[p].triangles.size(); ++t) {
        const Simplex& triangle = images_.patches[p].triangles[t];
        for (std::size_t place = 0; place < 3; ++place) {
          edges_.push_back(
              {edge_key(triangle[(place + 1) % 3], triangle[(place + 2) % 3]), p, t, place});
        }
        const Simplex corners = sorted(triangle);
        triangles_.push_back({{corners[0], corners[1], corners[2]}, p, t});
      }
    }
    sort(edges_);
    sort(triangles_);
  }

  std::optional<Misplaced> shared_faces() const {
    for (std::size_t i = 0; i + 1 < triangles_.size(); ++i) {
      const FaceOf &a = triangles_[i], &b = triangles_[i + 1];
      if (a.face == b.face && a.cell != b.cell) {
        return fault(cells_, {2, a.cell}, {2, b.cell}, a.vertices());
      }
    }
    std::optional<Misplaced> found;
    for_each_edge([&](std::span<const FaceOf> uses, std::optional<std::size_t> link) {
      for (const FaceOf& use : uses) {
        if (found) return;
        const std::size_t other = uses.front().cell;
        if (link && !cells_.is_in_closure({1, *link}, {2, use.cell})) {
          found = fault(cells_, {1, *link}, {2, use.cell}, use.vertices());
        } else if (!link && use.cell != other) {
          found = fault(cells_, {2, other}, {2, use.cell}, use.vertices());
        }
      }
    });
    return found;
  }

  std::optional<Misplaced> order_at_segments() const {
    std::map<std::size_t, std::vector<HalfPlane>> own;  // of segments with more than two of them
    for_each_edge([&](std::span<const FaceOf> uses, std::optional<std::size_t> link) {
      if (link && uses.size() > 2) own[*link];
    });
    if (own.empty()) return std::nullopt;
    for (std::size_t p = 0; p < complex_.polygons.size(); ++p) {
      const auto& segments = cells_.segments_of(p);
      if (std::none_of(segments.begin(), segments.end(),
                       [&](std::size_t s) { return own.contains(s); })) {
        continue;
      }
      const Point normal = normal_of(complex_, p);
      for (const Simplex& triangle : complex_.polygons[p].triangles) {
        add_own(p, normal, triangle, own);
      }
    }
    std::optional<Misplaced> found;
    for_each_edge([&](std::span<const FaceOf> uses, std::optional<std::size_t> link) {
      if (found || !link || uses.size() <= 2) return;
      std::vector<HalfPlane> planes;
      for (const FaceOf& use : uses) {
        const Simplex& triangle = images_.patches[use.cell].triangles[use.triangle];
        const Vertex a = triangle[(use.place + 1) % 3], b = triangle[(use.place + 2) % 3];
        // On the left of its counterclockwise edge: is that the direction of the path?
        const std::vector<Vertex>& path = images_.paths[*link];
        const auto at = std::find(path.begin(), path.end(), a);
        const bool left = at + 1 != path.end() && *(at + 1) == b;
        planes.push_back({use.cell, left, points_[triangle[use.place]] - points_[a]});
      }
      const Simplex edge = uses.front().vertices();
      if (!agree(*link, edge, own.at(*link), planes)) {
        found = fault(cells_, {1, *link}, {2, planes.front().polygon}, edge);
      }
    });
    return found;
  }

 private:
  static void sort(std::vector<FaceOf>& faces) {
    std::stable_sort(faces.begin(), faces.end(),
                     [](const FaceOf& a, const FaceOf& b) { return a.face < b.face; });
  }

  // Once for each edge of patches, with all its uses, and the segment whose path it is in.
  template <class Visit>
  void for_each_edge(const Visit& visit) const {
    auto link = links_.begin();
    for (std::size_t first = 0, last = 0; first < edges_.size(); first = last) {
      while (last < edges_.size() && edges_[last].face == edges_[first].face) ++last;
      while (link != links_.end() && link->face < edges_[first].face) ++link;
      const bool is_link = link != links_.end() && link->face == edges_[first].face;
      visit(std::span(edges_).subspan(first, last - first),
            is_link ? std::optional(link->cell) : std::nullopt);
    }
  }

  void add_own(std::size_t p, const Point& normal, const Simplex& triangle,
               std::map<std::size_t, std::vector<HalfPlane>>& own) const {
    for (std::size_t place = 0; place < 3; ++place) {
      const Simplex edge = sorted(facet_opposite(triangle, place));
      const auto at = std::lower_bound(complex_.segments.begin(), complex_.segments.end(), edge);
      if (at == complex_.segments.end() || *at != edge) continue;
      const auto planes = own.find(static_cast<std::size_t>(at - complex_.segments.begin()));
      if (planes == own.end()) continue;
      const Point direction = complex_.points[triangle[place]] - complex_.points[edge[0]];
      const Point along = complex_.points[edge[1]] - complex_.points[edge[0]];
      const bool left = sign(inner_product(normal, cross_product(along, direction))) > 0;
      planes->second.push_back({p, left, direction});
    }
  }

  // Is the cyclic order the same?
  bool agree(std::size_t s, const Simplex& edge, const std::vector<HalfPlane>& own,
             const std::vector<HalfPlane>& planes) const {
    const Simplex& segment = complex_.segments[s];
    const auto expected =
        order_about(complex_.points[segment[1]] - complex_.points[segment[0]], own);
    const std::vector<Vertex>& path = images_.paths[s];
    const auto at = std::find(path.begin(), path.end(), edge[0]);
    const bool forward = at + 1 != path.end() && *(at + 1) == edge[1];
    const Point axis =
        forward ? points_[edge[1]] - points_[edge[0]] : points_[edge[0]] - points_[edge[1]];
    auto found = order_about(axis, planes);
    if (!expected || !found || expected->size() != found->size()) return false;
    const auto start = std::find(found->begin(), found->end(), expected->front());
    if (start == found->end()) return false;
    std::rotate(found->begin(), start, found->end());
    return *found == *expected;
  }

  const ImageSet& images_;
  const PointSet& points_;
  const Cells& cells_;
  const PiecewiseLinearComplex& complex_;
  // Ascending.
  std::vector<FaceOf> links_;  // of paths
  std::vector<FaceOf> edges_;  // of triangles
  std::vector<FaceOf> triangles_;
};

}  // namespace

ImageSet image_set(const Images& images, const Cells& cells, const Rational& squared_reach) {
  const PiecewiseLinearComplex& complex = cells.complex();
  ImageSet set;
  for (std::size_t v = 0; v < complex.points.size(); ++v) {
    set.vertices.push_back(*images.vertex(v, squared_reach));
  }
  for (std::size_t s = 0; s < complex.segments.size(); ++s) {
    set.paths.push_back(*images.path(s, squared_reach));
  }
  for (std::size_t p = 0; p < complex.polygons.size(); ++p) {
    set.patches.push_back(*images.patch(p, squared_reach));
  }
  return set;
}

// In the plane, and wherever only vertices are shared, there is nothing to ask: a vertex of the
// mesh has one carrier, which is a face of every cell that has the vertex in its image.
std::optional<Misplaced> misplaced(const ImageSet& images, const ExactMesh& mesh,
                                   const Cells& cells) {
  if (images.patches.empty()) return std::nullopt;
  const Placing placing(images, mesh, cells);
  if (auto found = placing.shared_faces()) return found;
  return placing.order_at_segments();
}

}  // namespace circumspect::check
