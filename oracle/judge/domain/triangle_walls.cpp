#include "oracle/judge/domain/triangle_walls.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <utility>

#include "kernel/exact/each_once.hpp"
#include "oracle/judge/domain/judge_domain.hpp"
#include "oracle/judge/fast/facet_records.hpp"
#include "oracle/judge/fast/predicates/predicates.hpp"
#include "oracle/judge/fast/triangle_complex.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::check {

namespace {

using Corners = std::array<std::int32_t, 3>;

// The polygons, if each is a triangle of different vertices, ascending, and every vertex is in one.
std::optional<std::vector<Corners>> triangles_of(const PiecewiseLinearInput& input) {
  const std::size_t count = input.points.size();
  if (count > std::numeric_limits<std::int32_t>::max()) return std::nullopt;
  std::vector<bool> has_triangle(count, false);
  std::vector<Corners> triangles;
  triangles.reserve(input.polygons.size());
  for (const PolygonLines& polygon : input.polygons) {
    const bool is_triangle = polygon.lines.size() == 1 && polygon.lines.front().size() == 3 &&
                             polygon.hole_seeds.empty();
    if (!is_triangle) return std::nullopt;
    Corners corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vertex v = polygon.lines.front()[i];
      if (v < 0 || static_cast<std::size_t>(v) >= count) return std::nullopt;
      corners[i] = static_cast<std::int32_t>(v);
      has_triangle[static_cast<std::size_t>(v)] = true;
    }
    std::sort(corners.begin(), corners.end());
    if (corners[0] == corners[1] || corners[1] == corners[2]) return std::nullopt;
    triangles.push_back(corners);
  }
  if (std::find(has_triangle.begin(), has_triangle.end(), false) != has_triangle.end()) {
    return std::nullopt;
  }
  return triangles;
}

std::vector<std::array<std::int32_t, 2>> edges_of(const std::vector<Corners>& triangles) {
  std::vector<std::array<std::int32_t, 2>> edges;
  edges.reserve(3 * triangles.size());
  for (const auto& [a, b, c] : triangles) {
    for (const auto& edge : {std::array{a, b}, std::array{a, c}, std::array{b, c}}) {
      edges.push_back(edge);
    }
  }
  keep_each_once(edges);
  return edges;
}

bool are_among(const std::vector<std::vector<Vertex>>& segments,
               const std::vector<std::array<std::int32_t, 2>>& edges) {
  return std::all_of(segments.begin(), segments.end(), [&](const std::vector<Vertex>& segment) {
    if (segment.size() != 2) return false;
    const auto [low, high] = std::minmax(segment[0], segment[1]);
    if (low < 0 || high > std::numeric_limits<std::int32_t>::max()) return false;
    return std::binary_search(
        edges.begin(), edges.end(),
        std::array{static_cast<std::int32_t>(low), static_cast<std::int32_t>(high)});
  });
}

Polygon polygon_of(const Corners& corners, fast::PlaneAxes axes) {
  const Vertex a = corners[0], b = corners[1], c = corners[2];
  return {{a, b, c}, {{a, b}, {a, c}, {b, c}}, {}, {axes.x, axes.y}, {{a, b, c}}};
}

// The complex of an input, if its polygons are triangles of doubles that meet properly, and it has
// nothing else but hole seeds. Then it is a simplicial complex, so that nothing is wrong and no
// polygon adopts anything.
std::optional<PiecewiseLinearComplex> complex_of_triangles(const PiecewiseLinearInput& input) {
  if (input.polygons.empty() || input.points.empty() || input.points.front().size() != 3) {
    return std::nullopt;
  }
  const auto triangles = triangles_of(input);
  if (!triangles) return std::nullopt;
  const auto edges = edges_of(*triangles);
  if (!are_among(input.segments, edges)) return std::nullopt;
  Mesh points;
  points.coordinates = numbers_of(input.points, 3);
  const auto* const doubles = std::get_if<Rows<double>>(&points.coordinates);
  if (doubles == nullptr || !equal_points(points).empty()) return std::nullopt;
  if (!fast::are_surely_a_complex(doubles->values(), *triangles)) return std::nullopt;
  PiecewiseLinearComplex complex{PointSet(input.points), {}, {}, input.hole_seeds, input.kind};
  complex.segments.reserve(edges.size());
  for (const auto& [a, b] : edges) complex.segments.push_back({a, b});
  complex.polygons.reserve(triangles->size());
  for (const Corners& corners : *triangles) {
    complex.polygons.push_back(
        polygon_of(corners, fast::axes_of_triangle(doubles->values(), corners)));
  }
  BreachList found(1);
  find_hole_seed_breaches(complex, found);
  if (!found.empty()) return std::nullopt;
  return complex;
}

}  // namespace

tl::expected<PiecewiseLinearComplex, std::vector<Breach>> validated_domain(
    const PiecewiseLinearInput& input, std::size_t limit, const ValidityWatch& watch) {
  if (auto complex = complex_of_triangles(input)) return *std::move(complex);
  return validated(input, limit, watch);
}

namespace {

std::uint64_t hash_of(const std::array<double, 3>& point) {
  std::uint64_t sum = 0;
  for (const double x : point) {  // of equal zeros one
    sum = fast::mixed_vertex(sum + std::bit_cast<std::uint64_t>(x + 0.0));
  }
  return sum;
}
template <std::size_t kCount>
std::uint64_t hash_of(const std::array<Vertex, kCount>& vertices) {
  std::uint64_t sum = 0;
  for (const Vertex v : vertices) sum = fast::mixed_vertex(sum + static_cast<std::uint64_t>(v));
  return sum;
}

// Where keys, all different, stand in a list.
template <class Key>
class PlaceOf {
 public:
  PlaceOf() = default;
  explicit PlaceOf(std::vector<Key> keys)
      : keys_(std::move(keys)), slots_(std::bit_ceil(2 * keys_.size() + 1), kFree) {
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      std::size_t slot = slot_of(keys_[i]);
      while (slots_[slot] != kFree) slot = (slot + 1) & (slots_.size() - 1);
      slots_[slot] = static_cast<std::uint32_t>(i);
    }
  }

  std::optional<std::size_t> find(const Key& key) const {
    for (std::size_t slot = slot_of(key); slots_[slot] != kFree;
         slot = (slot + 1) & (slots_.size() - 1)) {
      if (keys_[slots_[slot]] == key) return slots_[slot];
    }
    return std::nullopt;
  }

 private:
  static constexpr std::uint32_t kFree = ~std::uint32_t{0};

  std::size_t slot_of(const Key& key) const { return hash_of(key) & (slots_.size() - 1); }

  std::vector<Key> keys_;
  std::vector<std::uint32_t> slots_ = {kFree};
};

template <std::size_t kCount>
using PlaceOfCell = PlaceOf<std::array<Vertex, kCount>>;

template <std::size_t kCount>
PlaceOfCell<kCount> places_of(const std::vector<Simplex>& cells) {
  std::vector<std::array<Vertex, kCount>> keys(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    std::copy(cells[i].begin(), cells[i].end(), keys[i].begin());
  }
  return PlaceOfCell<kCount>(std::move(keys));
}

template <typename Index>
class FacetsAtWalls {
 public:
  FacetsAtWalls(const fast::MeshView<3, Index>& mesh, const Domain& domain)
      : mesh_(mesh), complex_(domain.complex), regions_(domain.regions()) {}

  // Is the mesh a triangulation of the domain with a facet for every wall? `known` is right, each
  // of its facets of one simplex has to be one of these, and each listed face has to be one or an
  // edge of one.
  bool fill(const fast::SimplexFacts& known, const std::vector<Simplex>& faces) {
    const std::vector<Simplex>& walls = regions_.walls().simplices();
    if (walls.empty() || !match_vertices()) return false;
    segments_ = places_of<2>(complex_.segments);
    walls_ = places_of<3>(walls);
    // The first question is the one to which a mesh with a hole says no.
    return are_all_walls(known.boundary) && walls_have_all_cells(walls) && see_simplices() &&
           std::all_of(faces.begin(), faces.end(),
                       [&](const Simplex& face) { return is_known_face(face); });
  }

  // Requires: `fill` has said yes.
  bool are_all_walls(const std::vector<fast::FacetId>& facets) const {
    return std::all_of(facets.begin(), facets.end(), [&](fast::FacetId facet) {
      return wall_of(mesh_.row(facet.simplex()), facet.place()).has_value();
    });
  }
  bool is_of_domain(std::size_t point) const { return in_domain_[point] >= 0; }

 private:
  bool match_vertices() {
    const Numbers numbers = numbers_of(complex_.points.points(), 3);
    const auto* const doubles = std::get_if<Rows<double>>(&numbers);
    if (doubles == nullptr) return false;
    sites_.resize(doubles->rows());
    for (std::size_t v = 0; v < sites_.size(); ++v) {
      std::copy(doubles->row(v).begin(), doubles->row(v).end(), sites_[v].begin());
    }
    const PlaceOf vertex_at(sites_);
    in_domain_.assign(mesh_.points(), -1);
    std::size_t found = 0;
    for (std::size_t v = 0; v < mesh_.points(); ++v) {
      const double* const at = &mesh_.coordinates[3 * v];
      const auto same = vertex_at.find({at[0], at[1], at[2]});
      if (!same) continue;
      in_domain_[v] = static_cast<Vertex>(*same);
      ++found;
    }
    return found == doubles->rows();  // no two points of the mesh are equal
  }

  // Is every segment an edge of a wall, and every vertex a corner of one?
  bool walls_have_all_cells(const std::vector<Simplex>& walls) const {
    std::vector<bool> has_vertex(complex_.points.size(), false);
    std::vector<bool> has_segment(complex_.segments.size(), false);
    for (const Simplex& wall : walls) {
      for (std::size_t i = 0; i < 3; ++i) {
        has_vertex[static_cast<std::size_t>(wall[i])] = true;
        const auto segment = segments_.find({wall[i == 0 ? 1 : 0], wall[i == 2 ? 1 : 2]});
        if (segment) has_segment[*segment] = true;
      }
    }
    const auto all = [](const std::vector<bool>& has) {
      return std::find(has.begin(), has.end(), false) == has.end();
    };
    return all(has_vertex) && all(has_segment);
  }

  // The vertices of the domain that some points of the mesh are, ascending; nothing if one is none.
  template <std::size_t kCount>
  std::optional<std::array<Vertex, kCount>> vertices_of_domain(
      const std::array<Vertex, kCount>& points) const {
    std::array<Vertex, kCount> vertices;
    for (std::size_t i = 0; i < kCount; ++i) {
      if (points[i] < 0 || static_cast<std::size_t>(points[i]) >= in_domain_.size()) {
        return std::nullopt;
      }
      vertices[i] = in_domain_[static_cast<std::size_t>(points[i])];
      if (vertices[i] < 0) return std::nullopt;
    }
    std::sort(vertices.begin(), vertices.end());
    return vertices;
  }

  std::optional<std::size_t> wall_of(std::span<const Index, 4> row, std::size_t place) const {
    std::array<Vertex, 3> facet;
    for (std::size_t i = 0; i < 3; ++i) facet[i] = row[i < place ? i : i + 1];
    return found_in(walls_, vertices_of_domain(facet));
  }
  template <std::size_t kCount>
  static std::optional<std::size_t> found_in(
      const PlaceOfCell<kCount>& place_of,
      const std::optional<std::array<Vertex, kCount>>& vertices) {
    return vertices ? place_of.find(*vertices) : std::nullopt;
  }

  // Does each wall have a simplex on every side that is inside, there is one, and none on the
  // other? Is every point a vertex of a simplex?
  bool see_simplices() {
    std::vector<std::array<bool, 2>> covered(regions_.walls().size());  // behind, in front
    std::vector<bool> used(mesh_.points(), false);
    for (std::size_t s = 0; s < mesh_.size(); ++s) {
      const auto row = mesh_.row(s);
      int others = 0;
      for (const Index v : row) {
        used[static_cast<std::size_t>(v)] = true;
        others += in_domain_[static_cast<std::size_t>(v)] < 0 ? 1 : 0;
      }
      for (std::size_t place = 0; others < 2 && place < 4; ++place) {
        const auto wall = wall_of(row, place);
        if (wall) covered[*wall][side_of(*wall, row[place])] = true;
      }
    }
    if (std::find(used.begin(), used.end(), false) != used.end()) return false;
    for (std::size_t wall = 0; wall < covered.size(); ++wall) {
      const auto [behind, in_front] = regions_.beside(wall);
      const std::array<bool, 2> inside = {is_inside(behind), is_inside(in_front)};
      if (covered[wall] != inside || inside == std::array{false, false}) return false;
    }
    return true;
  }

  bool is_inside(std::size_t region) const { return regions_.where(region) == Where::kInside; }

  // 1 if the point, which is not in its plane, is in front of the wall.
  std::size_t side_of(std::size_t wall, Index apex) const {
    const Simplex& corners = regions_.walls().simplices()[wall];
    std::array<fast::Site<3>, 3> sites;
    for (std::size_t i = 0; i < 3; ++i) {
      sites[i].at = sites_[static_cast<std::size_t>(corners[i])];
    }
    fast::Stages stages;
    const int side =
        fast::orientation(sites[0], sites[1], sites[2], mesh_.template site<false>(apex), stages);
    return side > 0 ? 1 : 0;
  }

  bool is_known_face(const Simplex& face) const {
    if (face.size() == 2) {
      return found_in(segments_, vertices_of_domain(std::array{face[0], face[1]})).has_value();
    }
    return face.size() == 3 &&
           found_in(walls_, vertices_of_domain(std::array{face[0], face[1], face[2]})).has_value();
  }

  const fast::MeshView<3, Index>& mesh_;
  const PiecewiseLinearComplex& complex_;
  Regions regions_;
  std::vector<std::array<double, 3>> sites_;  // of the vertices of the domain
  std::vector<Vertex> in_domain_;  // the vertex of the domain that each point is, or −1
  PlaceOfCell<2> segments_;
  PlaceOfCell<3> walls_;
};

}  // namespace

template <typename Index>
std::optional<Verdict> held_by_facets(Claim claim, const fast::MeshView<3, Index>& mesh,
                                      const std::vector<Simplex>& faces, const Domain& domain,
                                      const fast::SimplexFacts& known, const Options& options) {
  const PiecewiseLinearComplex& complex = domain.complex;
  if (complex.ambient_dimension() != 3 || complex.kind != DomainKind::kEnclosed)
    return std::nullopt;
  if (claim == Claim::kConformingDelaunay &&
      !(known.not_local.empty() && known.boundary_balls_are_empty())) {
    return std::nullopt;
  }
  const std::size_t steiner = mesh.points() - std::min(mesh.points(), complex.points.size());
  if (steiner > 0 && !allows_steiner_points(claim)) return std::nullopt;
  FacetsAtWalls<Index> facets(mesh, domain);
  if (!facets.fill(known, faces)) return std::nullopt;
  Verdict verdict(claim, options.max_violations);
  verdict.points = mesh.points();
  verdict.simplices = mesh.size();
  verdict.dimension = 3;
  verdict.steiner_points = SteinerPoints{.in_polyhedra = steiner};
  ExtraVertices extra{.count = steiner};
  const std::size_t kept =
      options.max_violations == 0 ? steiner : std::min(steiner, options.max_violations);
  for (std::size_t v = 0; extra.first.size() < kept; ++v) {
    if (!facets.is_of_domain(v)) extra.first.push_back(static_cast<Vertex>(v));
  }
  verdict.extra_vertices = std::move(extra);
  if (!is_about_balls(claim) || claim == Claim::kConformingDelaunay) return verdict;
  if (!facets.are_all_walls(known.not_local)) return std::nullopt;
  verdict.canonical = facets.are_all_walls(known.not_canonical);
  if (facets.are_all_walls(known.ties)) verdict.unique = true;
  return verdict;
}

template std::optional<Verdict> held_by_facets(Claim, const fast::MeshView<3, std::int32_t>&,
                                               const std::vector<Simplex>&, const Domain&,
                                               const fast::SimplexFacts&, const Options&);
template std::optional<Verdict> held_by_facets(Claim, const fast::MeshView<3, std::int64_t>&,
                                               const std::vector<Simplex>&, const Domain&,
                                               const fast::SimplexFacts&, const Options&);

}  // namespace circumspect::check
