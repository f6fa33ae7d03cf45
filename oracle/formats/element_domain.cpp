#include "oracle/formats/element_domain.hpp"

#include <algorithm>

#include "oracle/formats/curved_elements.hpp"
#include "oracle/formats/plane.hpp"

namespace circumspect::formats {

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
  const std::size_t left_out = dropped.size() - kept.size();
  domain.notes.push_back(domain.name + ": " + std::to_string(left_out) +
                         (left_out == 1 ? " vertex" : " vertices") +
                         " of cells alone left out of the domain");
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
  if (auto note = note_of_curved(elements, name)) domain.notes.push_back(std::move(*note));
  Status status = take_points(domain, elements.points, 0);
  if (status) status = add_edges(domain, elements.edges);
  if (domain.dimension == 3 || elements.edges.simplices.empty()) {
    if (status) status = add_faces(domain, faces_in_order(elements));
  }
  if (!status) return tl::unexpected(status.error());
  const std::vector<bool> dropped =
      domain.dimension == 2
          ? points_of_cells_alone(domain,
                                  {&elements.triangles, &elements.polygons, &elements.curved})
          : points_of_cells_alone(domain,
                                  {&elements.tetrahedra, &elements.other_solids, &elements.curved});
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

Result<DomainFile> plane_or_space_of(const ElementFile& elements, const std::string& name) {
  Result<DomainFile> domain = domain_of(elements, name);
  if (!domain || !is_of_plane(elements)) return domain;
  DomainFile taken = taken_for_plane(std::move(*domain));
  if (!taken.flat || elements.edges.simplices.empty()) return taken;
  ElementFile plane = elements;
  plane.points.points.drop_last_column();
  plane.points.dimension = 2;
  domain = domain_of(plane, name);
  if (!domain) return domain;
  domain->notes.push_back(taken.notes.back());
  domain->flat = std::move(taken.flat);
  return domain;
}

}  // namespace circumspect::formats
