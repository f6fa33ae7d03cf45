#include "oracle/judge/within/images.hpp"

#include <algorithm>

namespace circumspect::check {

Images::Images(const ExactMesh& mesh, const Cells& cells, const Regions& regions,
               const Reaches& reaches, const MeshFaces& faces)
    : mesh_(mesh),
      cells_(cells),
      regions_(regions),
      reaches_(reaches),
      faces_(faces),
      rounded_(rounded(mesh.points.points())),
      rounded_domain_(rounded(cells.complex().points.points())),
      vertices_(cells.complex().points.size()),
      paths_(cells.complex().segments.size()),
      patches_(cells.complex().polygons.size()) {}

const ImageOr<Vertex>& Images::vertex(std::size_t v, const Rational& squared_reach) const {
  auto& known = vertices_[v];
  if (!known || known->first != squared_reach) {
    known.emplace(squared_reach, found_vertex(v, squared_reach));
  }
  return known->second;
}

const ImageOr<std::vector<Vertex>>& Images::path(std::size_t segment,
                                                 const Rational& squared_reach) const {
  auto& known = paths_[segment];
  if (!known || known->first != squared_reach) {
    known.emplace(squared_reach, found_path(segment, squared_reach));
  }
  return known->second;
}

const ImageOr<Patch>& Images::patch(std::size_t polygon, const Rational& squared_reach) const {
  auto& known = patches_[polygon];
  if (!known || known->first != squared_reach) {
    known.emplace(squared_reach, found_patch(polygon, squared_reach));
  }
  return known->second;
}

ImageOr<Vertex> Images::found_vertex(std::size_t v, const Rational& squared_reach) const {
  const Cell cell = {0, v};
  std::vector<Vertex> found;
  for (const Reaches::ToVertex& near : reaches_.near(cell)) {
    if (near.squared > squared_reach) break;
    if (reaches_.carrier(near.vertex, squared_reach).is(cell)) found.push_back(near.vertex);
  }
  if (found.size() == 1) return found.front();
  Witness witness{.vertices = found, .domain_cell = Simplex{static_cast<Vertex>(v)}};
  if (found.empty() && !reaches_.near(cell).empty()) {
    const Reaches::ToVertex& nearest = reaches_.near(cell).front();
    witness.nearest = NearestVertex{nearest.vertex, nearest.squared};
  }
  return tl::unexpected(NoImage{{Rule::kDomainVertexMissing, witness}});
}

ImageOr<std::vector<Vertex>> Images::found_path(std::size_t segment,
                                                const Rational& squared_reach) const {
  const PiecewiseLinearComplex& complex = cells_.complex();
  const Simplex& ends = complex.segments[segment];
  const Cell cell = {1, segment};
  const Point& from = complex.points[ends[0]];
  std::vector<std::pair<Rational, Vertex>> inner;
  for (const Reaches::ToVertex& near : reaches_.near(cell)) {
    if (near.squared > squared_reach) break;
    if (!reaches_.carrier(near.vertex, squared_reach).is(cell)) continue;
    inner.emplace_back(0, near.vertex);
  }
  const Vertex first = *vertex(static_cast<std::size_t>(ends[0]), squared_reach);
  const Vertex last = *vertex(static_cast<std::size_t>(ends[1]), squared_reach);
  const auto missing = [&](Vertex a, Vertex b) {
    const Witness witness{.face = sorted({a, b}), .domain_cell = ends};
    return tl::unexpected(NoImage{{Rule::kSegmentMissing, witness}});
  };
  // The ends are within reach of cells that are more than three times as far apart: they are in order.
  if (inner.empty()) {
    if (!faces_.has_edge(first, last)) return missing(first, last);
    return std::vector<Vertex>{first, last};
  }
  const Point along = complex.points[ends[1]] - from;
  const auto place_of = [&](Vertex v) { return inner_product(mesh_.points[v] - from, along); };
  for (auto& [place, v] : inner) place = place_of(v);
  std::sort(inner.begin(), inner.end());
  inner.insert(inner.begin(), {place_of(first), first});
  inner.emplace_back(place_of(last), last);
  std::vector<Vertex> path = {first};
  for (std::size_t i = 1; i < inner.size(); ++i) {
    const Vertex a = inner[i - 1].second, b = inner[i].second;
    if (!(inner[i - 1].first < inner[i].first) || !faces_.has_edge(a, b)) return missing(a, b);
    path.push_back(b);
  }
  return path;
}

bool Images::has_image(Cell cell, const Rational& squared_reach) const {
  if (cell.dimension == 0) return vertex(cell.place, squared_reach).has_value();
  const auto& ends = cells_.complex().segments[cell.place];
  return vertex(static_cast<std::size_t>(ends[0]), squared_reach) &&
         vertex(static_cast<std::size_t>(ends[1]), squared_reach) &&
         path(cell.place, squared_reach);
}

std::optional<NoImage> Images::fault(Cell cell, const Rational& squared_reach) const {
  for (const Cell face : cells_.closure(cell)) {
    if (face != cell && !has_image(face, squared_reach)) return std::nullopt;
  }
  if (cell.dimension == 0) {
    const auto& found = vertex(cell.place, squared_reach);
    return found ? std::nullopt : std::optional(found.error());
  }
  if (cell.dimension == 1) {
    const auto& found = path(cell.place, squared_reach);
    return found ? std::nullopt : std::optional(found.error());
  }
  const auto& found = patch(cell.place, squared_reach);
  return found ? std::nullopt : std::optional(found.error());
}

std::optional<Rational> Images::next_change(Cell cell, const Rational& squared_reach) const {
  std::optional<Rational> next;
  const auto consider = [&](const Rational& squared) {
    if (squared > squared_reach && (!next || squared < *next)) next = squared;
  };
  for (const Cell face : cells_.closure(cell)) {
    for (const Reaches::ToVertex& near : reaches_.near(face)) {
      if (near.squared > squared_reach) {
        consider(near.squared);
        break;
      }
      // Within reach already: another cell of lower dimension may come to carry it.
      for (const ToCell& to : reaches_.of(near.vertex)) consider(to.squared);
    }
  }
  return next;
}

}  // namespace circumspect::check
