#include "oracle/judge/within/images.hpp"

#include <algorithm>
#include <iterator>

namespace circumspect::check {

Images::Images(const ExactMesh& mesh, const std::vector<RoundedPoint>& rounded, const Cells& cells,
               const DomainPieces& pieces, const Regions& regions, const Reaches& reaches,
               const MeshFaces& faces, Work& work)
    : mesh_(mesh),
      rounded_(rounded),
      cells_(cells),
      pieces_(pieces),
      regions_(regions),
      reaches_(reaches),
      faces_(faces),
      work_(work),
      places_(cells.complex().segments.size()),
      vertices_(cells.complex().points.size()),
      paths_(cells.complex().segments.size()),
      patches_(cells.complex().polygons.size()) {}

const ImageOr<Vertex>& Images::vertex(std::size_t v, const Rational& squared_reach) const {
  return known_or_found(vertices_[v], {0, v}, squared_reach,
                        [&] { return found_vertex(v, squared_reach); });
}

const ImageOr<std::vector<Vertex>>& Images::path(std::size_t segment,
                                                 const Rational& squared_reach) const {
  return known_or_found(paths_[segment], {1, segment}, squared_reach,
                        [&] { return found_path(segment, squared_reach); });
}

const ImageOr<Patch>& Images::patch(std::size_t polygon, const Rational& squared_reach) const {
  return known_or_found(patches_[polygon], {2, polygon}, squared_reach,
                        [&] { return found_patch(polygon, squared_reach); });
}

ImageOr<Vertex> Images::found_vertex(std::size_t v, const Rational& squared_reach) const {
  const Cell cell = {0, v};
  std::vector<Vertex> found;
  for (const Reaches::ToVertex& near : reaches_.near(cell)) {
    if (near.squared() > squared_reach) break;
    if (reaches_.carrier(near.vertex, squared_reach).is(cell)) found.push_back(near.vertex);
  }
  if (found.size() == 1) return found.front();
  Witness witness{.vertices = found, .domain_cell = Simplex{static_cast<Vertex>(v)}};
  if (found.empty() && !reaches_.near(cell).empty()) {
    const Reaches::ToVertex& nearest = reaches_.near(cell).front();
    witness.nearest = NearestVertex{nearest.vertex, nearest.squared()};
  }
  return no_image(Rule::kDomainVertexMissing, std::move(witness));
}

const std::vector<Images::Place>& Images::places_along(std::size_t segment) const {
  std::optional<std::vector<Place>>& places = places_[segment];
  if (places) return *places;
  places.emplace();
  const PointSet& points = cells_.complex().points;
  const Simplex& ends = cells_.complex().segments[segment];
  const Point along = points[ends[1]] - points[ends[0]];
  for (const Reaches::ToVertex& near : reaches_.near({1, segment})) {
    places->push_back({inner_product(mesh_.points[near.vertex] - points[ends[0]], along),
                       near.vertex, &near.squared()});
  }
  std::sort(places->begin(), places->end(), [](const Place& a, const Place& b) {
    return a.at != b.at ? a.at < b.at : a.vertex < b.vertex;
  });
  return *places;
}

ImageOr<std::vector<Vertex>> Images::found_path(std::size_t segment,
                                                const Rational& squared_reach) const {
  const Simplex& ends = cells_.complex().segments[segment];
  const Vertex first = *vertex(static_cast<std::size_t>(ends[0]), squared_reach);
  const Vertex last = *vertex(static_cast<std::size_t>(ends[1]), squared_reach);
  const auto missing = [&](Vertex a, Vertex b) {
    const Witness witness{.face = sorted({a, b}), .domain_cell = ends};
    return no_image(Rule::kSegmentMissing, witness);
  };
  // The ends are within reach of cells that are more than three times as far apart: they are in
  // order.
  const bool has_others = reaches_.near({1, segment}).size() > 2;
  if (!has_others) {
    if (!faces_.has_edge(first, last)) return missing(first, last);
    return std::vector<Vertex>{first, last};
  }
  work_.add(places_along(segment).size());
  // The image of the first end may lie beyond a vertex of the path, and that of the last before
  // one.
  std::vector<const Place*> inner;
  const Place *at_first = nullptr, *at_last = nullptr;
  for (const Place& place : places_along(segment)) {
    if (place.vertex == first) at_first = &place;
    if (place.vertex == last) at_last = &place;
    if (*place.squared > squared_reach) continue;
    if (reaches_.carrier(place.vertex, squared_reach).is({1, segment})) inner.push_back(&place);
  }
  inner.insert(inner.begin(), at_first);
  inner.push_back(at_last);
  std::vector<Vertex> path = {first};
  for (std::size_t i = 1; i < inner.size(); ++i) {
    const Vertex a = inner[i - 1]->vertex, b = inner[i]->vertex;
    if (!(inner[i - 1]->at < inner[i]->at) || !faces_.has_edge(a, b)) return missing(a, b);
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
  const auto holds = [&](Cell face) { return has_image(face, squared_reach); };
  if (!cells_.holds_of_faces(cell, holds)) return std::nullopt;
  if (cell.dimension == 0) {
    const auto& found = vertex(cell.place, squared_reach);
    return found ? std::nullopt : std::optional(*found.error());
  }
  if (cell.dimension == 1) {
    const auto& found = path(cell.place, squared_reach);
    return found ? std::nullopt : std::optional(*found.error());
  }
  const auto& found = patch(cell.place, squared_reach);
  return found ? std::nullopt : std::optional(*found.error());
}

std::optional<Rational> Images::next_change(Cell cell, const Rational& squared_reach) const {
  std::optional<Rational> next;
  const auto consider = [&](const Rational& squared) {
    if (squared > squared_reach && (!next || squared < *next)) next = squared;
  };
  for (const Cell face : cells_.closure(cell)) {
    for (const Reaches::ToVertex& near : reaches_.near(face)) {
      if (near.squared() > squared_reach) {
        consider(near.squared());
        break;
      }
      // Within reach already: another cell of lower dimension may come to carry it.
      // Most of these are as far as the cell itself.
      for (const ToCell& to : reaches_.of(near.vertex)) {
        if (to.distance.get() != near.distance) consider(to.squared());
      }
    }
  }
  return next;
}

}  // namespace circumspect::check
