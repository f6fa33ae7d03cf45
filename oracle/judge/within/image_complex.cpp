#include "oracle/judge/within/image_complex.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <optional>
#include <span>

#include "kernel/exact/each_once.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/place.hpp"
#include "oracle/judge/domain/triangle_walls.hpp"
#include "oracle/judge/within/distance.hpp"

namespace circumspect::check {
namespace {

// A wall of the image by the mesh's vertices, in an order such that its front has the sides of the
// front of `own`, a wall of the domain.
struct ImageWall {
  Simplex wall;
  Simplex own;
};

std::vector<ImageWall> image_walls(const ImageSet& images, const PiecewiseLinearComplex& complex) {
  std::vector<ImageWall> walls;
  if (complex.ambient_dimension() == 2) {
    for (std::size_t s = 0; s < images.paths.size(); ++s) {
      const std::vector<Vertex>& path = images.paths[s];
      for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        walls.push_back({{path[i], path[i + 1]}, complex.segments[s]});
      }
    }
  }
  for (const Patch& patch : images.patches) {
    for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
      walls.push_back({patch.triangles[t], patch.own[t]});
    }
  }
  return walls;
}

bool is_flat_patch(const PointSet& points, const Patch& patch) {
  const std::vector<std::size_t> space = {0, 1, 2};
  const Simplex& first = patch.triangles.front();
  for (const Simplex& triangle : patch.triangles) {
    for (const Vertex v : triangle) {
      if (contains(first, v)) continue;
      const Simplex four = {first[0], first[1], first[2], v};
      if (orientation(points.configuration(), space, four) != 0) return false;
    }
  }
  return true;
}

class Building {
 public:
  Building(const ImageSet& images, const std::vector<bool>& moved, const ExactMesh& mesh,
           const Cells& cells, const Regions& regions)
      : images_(images),
        moved_(moved),
        mesh_(mesh),
        cells_(cells),
        given_(cells.complex()),
        regions_(regions),
        number_(mesh.points.size(), -1) {}

  tl::expected<ImageComplex, Violation> result() {
    number_points();
    if (auto breach = intersection_of_images()) return tl::unexpected(std::move(*breach));
    PiecewiseLinearComplex complex{PointSet(points_), {}, {}, {}, DomainKind::kEnclosed};
    ImageComplex built{{std::move(complex)}, in_mesh_, {}};
    add_cells(built);
    if (const auto side = add_seeds(built)) built.sides_differ = side->vertices;
    return built;
  }

 private:
  Vertex number(Vertex in_mesh) const { return number_[static_cast<std::size_t>(in_mesh)]; }
  Simplex renumbered(Simplex simplex) const {
    for (Vertex& v : simplex) v = number(v);
    return simplex;
  }
  void number_points() {
    const auto add = [&](Vertex v) {
      if (number(v) >= 0) return;
      number_[static_cast<std::size_t>(v)] = static_cast<Vertex>(in_mesh_.size());
      in_mesh_.push_back(v);
      points_.push_back(mesh_.points[v]);
    };
    for (const Vertex v : images_.vertices) add(v);
    for (const auto& path : images_.paths) std::for_each(path.begin(), path.end(), add);
    for (const Patch& patch : images_.patches) {
      for (const Simplex& triangle : patch.triangles) {
        std::for_each(triangle.begin(), triangle.end(), add);
      }
    }
  }

  std::vector<Simplex> links() const {
    std::vector<Simplex> links;
    for (const std::vector<Vertex>& path : images_.paths) {
      for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        links.push_back(sorted(renumbered({path[i], path[i + 1]})));
      }
    }
    std::sort(links.begin(), links.end());
    return links;
  }

  // A vertex, an edge or a triangle in an image.
  struct Piece {
    std::array<Vertex, 3> vertices;
    std::size_t size;

    std::span<const Vertex> span() const { return std::span(vertices).first(size); }
  };

  // Calls visit(piece, is_moved) for all pieces of images. An image is moved if a vertex of it is.
  template <class Visit>
  void for_each_piece(const Visit& visit) const {
    const auto is_moved = [&](const auto& vertices) {
      return std::any_of(vertices.begin(), vertices.end(),
                         [&](Vertex v) { return moved_[static_cast<std::size_t>(v)]; });
    };
    for (const Vertex v : in_mesh_) visit(Piece{{v}, 1}, moved_[static_cast<std::size_t>(v)]);
    for (const auto& path : images_.paths) {
      const bool any = is_moved(path);
      for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        visit(Piece{{path[i], path[i + 1]}, 2}, any);
      }
    }
    for (const Patch& patch : images_.patches) {
      const bool any = std::any_of(patch.triangles.begin(), patch.triangles.end(), is_moved);
      for (const Simplex& triangle : patch.triangles) {
        visit(Piece{{triangle[0], triangle[1], triangle[2]}, 3}, any);
      }
    }
  }

  // The images are faces of the mesh, which is a complex only if they are one. Images without a
  // moved vertex are what the cells are, which is valid. So only moved ones have to be looked at,
  // and what is beside them.
  std::optional<Violation> intersection_of_images() const {
    std::vector<RoundedPoint> points(mesh_.points.size());
    for (const Vertex v : in_mesh_) points[static_cast<std::size_t>(v)] = rounded(mesh_.points[v]);
    const auto box_of = [&](const Piece& piece) {
      std::array<RoundedPoint, 3> corners;
      for (std::size_t i = 0; i < piece.size; ++i) {
        corners[i] = points[static_cast<std::size_t>(piece.vertices[i])];
      }
      return box_about(std::span(corners).first(piece.size), 0);
    };
    std::vector<Box> boxes_of_moved;
    for_each_piece([&](const Piece& piece, bool is_moved) {
      if (is_moved) boxes_of_moved.push_back(box_of(piece));
    });
    if (boxes_of_moved.empty()) return std::nullopt;
    const BoxIndex index(boxes_of_moved);
    std::vector<Simplex> found;
    for_each_piece([&](const Piece& piece, bool is_moved) {
      if (!is_moved && index.meeting(box_of(piece)).empty()) return;
      found.emplace_back(piece.span().begin(), piece.span().end());
    });
    return intersection(found);
  }

  // Do some faces of images intersect otherwise than in common faces?
  std::optional<Violation> intersection(const std::vector<Simplex>& faces) const {
    PiecewiseLinearInput input;
    std::vector<Vertex> in_mesh;
    std::vector<Vertex> number(mesh_.points.size(), -1);
    for (const Simplex& face : faces) {
      Simplex renumbered;
      for (const Vertex v : face) {
        Vertex& of_v = number[static_cast<std::size_t>(v)];
        if (of_v < 0) {
          of_v = static_cast<Vertex>(in_mesh.size());
          in_mesh.push_back(v);
          input.points.push_back(mesh_.points[v]);
        }
        renumbered.push_back(of_v);
      }
      if (face.size() == 2) input.segments.push_back(renumbered);
      if (face.size() == 3) input.polygons.push_back({{renumbered}, {}});
    }
    const auto back = [&](Simplex simplex) {
      for (Vertex& v : simplex) v = in_mesh[static_cast<std::size_t>(v)];
      return simplex;
    };
    Witness witness;
    const auto valid = validated_domain(input, 1);
    if (!valid) {
      const Breach& breach = valid.error().front();
      witness = {.vertices = back(breach.vertices), .point = breach.point};
      for (const Simplex& segment : breach.segments) witness.simplices.push_back(back(segment));
      for (const std::size_t p : breach.polygons) {
        witness.simplices.push_back(back(input.polygons[p].lines.front()));
      }
      return Violation{Rule::kOverlap, witness};
    }
    // A vertex or a link that lies in a triangle without being a face of it. As a complex that
    // would be valid: it would be a face of the triangle as a polygon.
    const std::vector<Adoption> adopted = adoptions(input, *valid);
    if (adopted.empty()) return std::nullopt;
    const Adoption& first = adopted.front();
    witness = {.simplices = {back(input.polygons[first.polygon].lines.front())},
               .vertices = back(first.vertices)};
    for (const Simplex& segment : first.segments) witness.simplices.push_back(back(segment));
    return Violation{Rule::kOverlap, witness};
  }

  void add_cells(ImageComplex& built) const {
    PiecewiseLinearComplex& complex = built.domain.complex;
    complex.segments = links();
    for (std::size_t p = 0; p < images_.patches.size(); ++p) {
      const Patch& patch = images_.patches[p];
      if (is_flat_patch(mesh_.points, patch)) {
        complex.polygons.push_back(flat_polygon(p, complex.points));
        built.polygons.push_back(p);
        continue;
      }
      for (const Simplex& triangle : patch.triangles) {
        complex.polygons.push_back(one_triangle(triangle, complex.points));
        built.polygons.push_back(p);
        for (const Simplex& edge : complex.polygons.back().segments) {
          complex.segments.push_back(edge);
        }
      }
      if (is_dangling(p)) ++built.not_flat_and_dangling;
    }
    keep_each_once(complex.segments);
  }

  bool is_dangling(std::size_t p) const {
    const std::vector<Simplex>& own = images_.patches[p].own;
    return std::any_of(own.begin(), own.end(), [&](const Simplex& triangle) {
      const OrientedFacet facet = OrientedFacet::of(triangle);
      return !regions_.faces_inside(facet) && !regions_.faces_inside(facet.reverse());
    });
  }

  Polygon flat_polygon(std::size_t p, const PointSet& points) const {
    Polygon polygon;
    for (const Simplex& triangle : images_.patches[p].triangles) {
      polygon.triangles.push_back(sorted(renumbered(triangle)));
      const Simplex& added = polygon.triangles.back();
      polygon.vertices.insert(polygon.vertices.end(), added.begin(), added.end());
    }
    std::sort(polygon.triangles.begin(), polygon.triangles.end());
    keep_each_once(polygon.vertices);
    for (const std::size_t s : cells_.segments_of(p)) {
      const std::vector<Vertex>& path = images_.paths[s];
      for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        polygon.segments.push_back(sorted(renumbered({path[i], path[i + 1]})));
      }
    }
    std::sort(polygon.segments.begin(), polygon.segments.end());
    polygon.axes = axes_of_plane(points.configuration(), polygon.triangles.front());
    return polygon;
  }

  Polygon one_triangle(const Simplex& triangle, const PointSet& points) const {
    const Simplex corners = sorted(renumbered(triangle));
    Polygon polygon;
    polygon.vertices = corners;
    polygon.segments = {
        {corners[0], corners[1]}, {corners[0], corners[2]}, {corners[1], corners[2]}};
    polygon.triangles = {corners};
    polygon.axes = axes_of_plane(points.configuration(), corners);
    return polygon;
  }

  // Inside or not, as the sides of the walls say, is said by a seed in each region that is not.
  // If that is not one answer, here is such a side.
  std::optional<OrientedFacet> add_seeds(ImageComplex& built) const {
    PiecewiseLinearComplex& complex = built.domain.complex;
    const Regions regions(complex);
    struct Label {
      bool inside;
      OrientedFacet side;  // where it was seen
    };
    std::vector<std::optional<Label>> labels(regions.size());
    labels[Regions::kUnbounded] = Label{false, {}};
    for (const ImageWall& wall : image_walls(images_, given_)) {
      const OrientedFacet front = OrientedFacet::of(renumbered(wall.wall));
      const OrientedFacet own = OrientedFacet::of(wall.own);
      for (const bool reversed : {false, true}) {
        const OrientedFacet side = reversed ? front.reverse() : front;
        const bool inside = regions_.faces_inside(reversed ? own.reverse() : own);
        std::optional<Label>& label = labels[regions.in_front_of(side)];
        if (!label) label = Label{inside, side};
        if (label->inside == inside) continue;
        return side;
      }
    }
    std::vector<std::size_t> holes;
    for (std::size_t region = 0; region < labels.size(); ++region) {
      if (region == Regions::kUnbounded || labels[region]->inside) continue;
      holes.push_back(region);
      complex.hole_seeds.push_back(seed_before(regions, labels[region]->side, complex.points));
    }
    built.domain.known_regions = regions.with_holes(holes);
    return std::nullopt;
  }

  // A point before a wall with nothing in between.
  static Point seed_before(const Regions& regions, const OrientedFacet& side,
                           const PointSet& points) {
    const std::vector<Point> corners = coordinates(points, side.vertices);
    const Point centre = barycentre(corners);
    const Point u = corners[1] - corners[0];
    Point step = {-u[1], u[0]};  // on the left, where the front of an edge is
    if (corners.size() == 3) step = cross_product(corners[2] - corners[0], u);
    if (side.reversed) step = Rational(-1) * step;
    for (;; step = Rational(1, 2) * step) {
      const auto crossed = regions.walls().crossings(centre, centre + step);
      if (crossed && crossed->size() == 1) return centre + step;
    }
  }

  const ImageSet& images_;
  const std::vector<bool>& moved_;
  const ExactMesh& mesh_;
  const Cells& cells_;
  const PiecewiseLinearComplex& given_;
  const Regions& regions_;
  std::vector<Vertex> number_;  // by the points of the mesh
  std::vector<Vertex> in_mesh_;
  std::vector<Point> points_;
};

}  // namespace

tl::expected<ImageComplex, Violation> image_complex(const ImageSet& images,
                                                    const std::vector<bool>& moved,
                                                    const ExactMesh& mesh, const Cells& cells,
                                                    const Regions& regions) {
  return Building(images, moved, mesh, cells, regions).result();
}

}  // namespace circumspect::check
