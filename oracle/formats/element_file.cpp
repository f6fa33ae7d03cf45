#include "oracle/formats/element_file.hpp"

#include <algorithm>
#include <iterator>
#include <span>

#include "kernel/complex/simplex.hpp"

namespace circumspect::formats {

namespace {

void add_to(SimplexFile& list, Simplex vertices, std::size_t line, std::optional<Vertex> label) {
  list.simplices.push_back(std::move(vertices));
  list.lines.push_back(line);
  if (label) list.labels.push_back(*label);
}

// The least number of vertices of a shape.
std::size_t fewest_vertices(ElementShape shape) {
  switch (shape) {
    case ElementShape::kPolyline:
      return 2;
    case ElementShape::kPolygon:
    case ElementShape::kStrip:
      return 3;
    case ElementShape::kPixel:
    case ElementShape::kTetrahedron:
      return 4;
    default:
      return 1;
  }
}

void add_polygon(ElementFile& file, Simplex vertices, std::string_view name, std::size_t line,
                 std::optional<Vertex> label) {
  if (vertices.size() == 3) {
    add_to(file.triangles, std::move(vertices), line, label);
    return;
  }
  if (!file.first_other) file.first_other = {std::string(name), line};
  add_to(file.polygons, std::move(vertices), line, label);
  file.triangles_before.push_back(file.triangles.simplices.size());
}

void add_strip(ElementFile& file, const Simplex& vertices, std::size_t line,
               std::optional<Vertex> label) {
  for (std::size_t i = 0; i + 2 < vertices.size(); ++i) {
    Simplex triangle = {vertices[i], vertices[i + 1], vertices[i + 2]};
    if (i % 2 == 1) std::swap(triangle[0], triangle[1]);  // all have one side in front
    add_to(file.triangles, std::move(triangle), line, label);
  }
}

}  // namespace

std::optional<std::string> add_element(ElementFile& file, ElementShape shape, Simplex vertices,
                                       std::string_view name, std::size_t line,
                                       std::optional<Vertex> label) {
  const std::size_t fewest = fewest_vertices(shape);
  if (vertices.size() < fewest) {
    return std::string(name) + " of " + std::to_string(fewest) +
           (fewest == 1 ? " vertex or more" : " vertices or more");
  }
  switch (shape) {
    case ElementShape::kPoint:
      break;
    case ElementShape::kPolyline:
      for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
        add_to(file.edges, {vertices[i], vertices[i + 1]}, line, label);
      }
      break;
    case ElementShape::kPixel:
      std::swap(vertices[2], vertices[3]);
      add_polygon(file, std::move(vertices), name, line, label);
      break;
    case ElementShape::kPolygon:
      add_polygon(file, std::move(vertices), name, line, label);
      break;
    case ElementShape::kStrip:
      add_strip(file, vertices, line, label);
      break;
    case ElementShape::kTetrahedron:
      add_to(file.tetrahedra, std::move(vertices), line, label);
      break;
    case ElementShape::kOtherSolid:
      if (!file.first_other) file.first_other = {std::string(name), line};
      add_to(file.other_solids, std::move(vertices), line, label);
      break;
    case ElementShape::kCurved:
      if (!file.first_curved) file.first_curved = {std::string(name), line};
      break;
  }
  return std::nullopt;
}

void finish_elements(ElementFile& file) {
  for (SimplexFile* const list :
       {&file.edges, &file.triangles, &file.polygons, &file.tetrahedra, &file.other_solids}) {
    list->vertices_per_simplex = size_of_each(list->simplices);
    list->first_index = file.points.first_index;
  }
}

Status check_simplices(const ElementFile& file, const std::string& name) {
  const auto& other = file.first_curved ? file.first_curved : file.first_other;
  if (!other) return {};
  return tl::unexpected(
      FormatError{name, other->line, "edges, triangles and tetrahedra", other->name});
}

TopElements top_elements(ElementFile& file) {
  TopElements top;
  for (SimplexFile* const list : {&file.edges, &file.triangles, &file.tetrahedra}) {
    if (list->simplices.empty()) continue;
    std::vector<Simplex>& lower = top.simplices.simplices;
    top.faces.insert(top.faces.end(), std::make_move_iterator(lower.begin()),
                     std::make_move_iterator(lower.end()));
    top.simplices = std::move(*list);
  }
  return top;
}

std::vector<Simplex> surface_of(const ElementFile& file) {
  std::vector<Simplex> surface = file.triangles.simplices;
  for_each_facet(facet_uses(file.tetrahedra.simplices), [&](std::span<const FacetUse> uses) {
    if (uses.size() != 1) return;
    const std::size_t place = uses.front().opposite;
    Simplex facet = facet_opposite(file.tetrahedra.simplices[uses.front().simplex], place);
    if (place % 2 == 0) std::swap(facet[0], facet[1]);
    surface.push_back(std::move(facet));
  });
  return surface;
}

bool is_of_plane(const ElementFile& file) {
  return file.tetrahedra.simplices.empty() && file.other_solids.simplices.empty() &&
         !file.first_curved;
}

// ---- Element domain ----
// The domain among the elements of a mesh.

namespace {

Status add_edges(DomainFile& domain, const SimplexFile& edges) {
  for (std::size_t i = 0; i < edges.simplices.size(); ++i) {
    const std::size_t line = edges.lines[i];
    Simplex segment;
    for (const Vertex index : edges.simplices[i]) {
      const Result<Vertex> place = place_of(domain, index, line);
      if (!place) return tl::unexpected(place.error());
      segment.push_back(*place);
    }
    if (segment[0] == segment[1]) {
      return tl::unexpected(
          FormatError{domain.name, line, "an edge with two ends", "the same end twice"});
    }
    add_segment(domain, segment, line);
  }
  return {};
}

// Triangles and polygons as the file lists them: messages count them in this order.
SimplexFile faces_in_order(const ElementFile& elements) {
  SimplexFile faces;
  const auto add = [&faces](const SimplexFile& list, std::size_t place) {
    faces.simplices.push_back(list.simplices[place]);
    faces.lines.push_back(list.lines[place]);
  };
  std::size_t triangle = 0;
  for (std::size_t i = 0; i < elements.polygons.simplices.size(); ++i) {
    for (; triangle < elements.triangles_before[i]; ++triangle) add(elements.triangles, triangle);
    add(elements.polygons, i);
  }
  for (; triangle < elements.triangles.simplices.size(); ++triangle) {
    add(elements.triangles, triangle);
  }
  return faces;
}

// Whether each point belongs to a segment or a polygon.
std::vector<bool> points_in_use(const DomainFile& domain) {
  std::vector<bool> used(domain.input.points.size());
  const auto use = [&used](const std::vector<Vertex>& vertices) {
    for (const Vertex v : vertices) used[static_cast<std::size_t>(v)] = true;
  };
  for (const auto& segment : domain.input.segments) use(segment);
  for (const PolygonLines& polygon : domain.input.polygons) {
    for (const auto& line : polygon.lines) use(line);
  }
  return used;
}

// The points that only cells use.
std::vector<bool> points_of_cells_alone(const DomainFile& domain,
                                        const std::vector<const SimplexFile*>& lists) {
  const std::vector<bool> used = points_in_use(domain);
  std::vector<bool> alone(used.size());
  for (const SimplexFile* const cells : lists) {
    for (const Simplex& cell : cells->simplices) {
      for (const Vertex index : cell) {
        const Result<Vertex> place = place_of(domain, index, 0);
        if (!place) continue;
        const auto v = static_cast<std::size_t>(*place);
        alone[v] = !used[v];
      }
    }
  }
  return alone;
}

void drop_points(DomainFile& domain, const std::vector<bool>& dropped) {
  std::vector<Vertex> place(dropped.size());
  std::vector<Point> kept;
  for (std::size_t v = 0; v < dropped.size(); ++v) {
    if (dropped[v]) continue;
    place[v] = static_cast<Vertex>(kept.size());
    kept.push_back(std::move(domain.input.points[v]));
    domain.labels.push_back(static_cast<Vertex>(v) + domain.first_index);
  }
  domain.notes.push_back(domain.name + ": " + std::to_string(dropped.size() - kept.size()) +
                         " vertices of cells alone left out of the domain");
  domain.input.points = std::move(kept);
  const auto renumber = [&place](std::vector<Vertex>& vertices) {
    for (Vertex& v : vertices) v = place[static_cast<std::size_t>(v)];
  };
  for (auto& segment : domain.input.segments) renumber(segment);
  for (PolygonLines& polygon : domain.input.polygons) {
    for (auto& line : polygon.lines) renumber(line);
  }
}

}  // namespace

Result<DomainFile> domain_of(const ElementFile& elements, const std::string& name) {
  if (elements.first_curved) {
    return tl::unexpected(FormatError{name, elements.first_curved->line, "elements of first order",
                                      elements.first_curved->name});
  }
  DomainFile domain;
  domain.name = name;
  domain.notes = elements.notes;
  Status status = take_points(domain, elements.points, 0);
  if (status) status = add_edges(domain, elements.edges);
  if (domain.dimension == 3 || elements.edges.simplices.empty()) {
    if (status) status = add_faces(domain, faces_in_order(elements));
  }
  if (!status) return tl::unexpected(status.error());
  const std::vector<bool> dropped =
      domain.dimension == 2
          ? points_of_cells_alone(domain, {&elements.triangles, &elements.polygons})
          : points_of_cells_alone(domain, {&elements.tetrahedra, &elements.other_solids});
  if (std::find(dropped.begin(), dropped.end(), true) != dropped.end()) {
    drop_points(domain, dropped);
  }
  if (domain.input.points.empty() && !elements.points.points.empty()) {
    return tl::unexpected(FormatError{
        name, 0, "edges and polygons of a domain",
        "cells alone (Gmsh also lists the triangles of the boundary with -save_all; the domain may "
        "be in another file, which the program was given that made the mesh)"});
  }
  return domain;
}

}  // namespace circumspect::formats
