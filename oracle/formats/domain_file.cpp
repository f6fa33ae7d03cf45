#include "oracle/formats/domain_file.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

namespace circumspect::formats {

namespace {

// Is there a cycle among segments? A forest of them encloses nothing.
bool has_cycle(const std::set<Simplex>& segments) {
  std::map<Vertex, Vertex> parent;
  for (const Simplex& segment : segments) {
    for (const Vertex v : segment) parent[v] = v;
  }
  const auto root = [&parent](Vertex v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const Simplex& segment : segments) {
    const Vertex a = root(segment[0]);
    const Vertex b = root(segment[1]);
    if (a == b) return true;
    parent[a] = b;
  }
  return false;
}

// The segments of a facet whose lines have at most two corners; empty if a line has more.
std::set<Simplex> lone_segments(const PolygonLines& facet) {
  std::set<Simplex> segments;
  for (const auto& line : facet.lines) {
    if (line.size() > 2) return {};
    if (line.size() == 2) segments.insert(sorted(line));
  }
  return segments;
}

bool has_area(const PolygonLines& facet) {
  const bool has_outline = std::any_of(facet.lines.begin(), facet.lines.end(),
                                       [](const auto& line) { return line.size() > 2; });
  return has_outline || !facet.hole_seeds.empty() || has_cycle(lone_segments(facet));
}

}  // namespace

std::vector<Vertex> without_repetitions(const std::vector<Vertex>& line) {
  std::vector<Vertex> corners;
  std::unique_copy(line.begin(), line.end(), std::back_inserter(corners));
  while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
  return corners;
}

Status take_points(DomainFile& file, PointFile points, std::size_t line) {
  if (points.dimension != 2 && points.dimension != 3) {
    return tl::unexpected(FormatError{file.name, line, "points of dimension 2 or 3",
                                      "dimension " + std::to_string(points.dimension)});
  }
  file.dimension = points.dimension;
  file.first_index = points.first_index;
  file.input.points = points.points.points();
  return {};
}

Result<Vertex> place_of(const DomainFile& file, Vertex index, std::size_t line) {
  Vertex place = 0;
  const auto count = static_cast<Vertex>(file.input.points.size());
  const bool overflows = __builtin_sub_overflow(index, file.first_index, &place);
  if (!overflows && place >= 0 && place < count) return place;
  const std::string expected = count == 0
                                   ? "no vertex, since there are no points"
                                   : "a vertex from " + std::to_string(file.first_index) + " to " +
                                         std::to_string(file.first_index + (count - 1));
  return tl::unexpected(FormatError{file.name, line, expected, std::to_string(index)});
}

void add_facet(DomainFile& file, PolygonLines facet, std::size_t line, Vertex marker) {
  for (auto& corners : facet.lines) {
    std::vector<Vertex> distinct = without_repetitions(corners);
    if (distinct.size() < corners.size()) {
      file.notes.push_back(file.name + ":" + std::to_string(line) +
                           ": a corner that repeats the one before it was left out");
    }
    corners = std::move(distinct);
  }
  if (!has_area(facet)) {
    for (const Simplex& segment : lone_segments(facet)) add_segment(file, segment, line);
    return;
  }
  file.input.polygons.push_back(std::move(facet));
  file.polygon_lines.push_back(line);
  file.polygon_markers.push_back(marker);
}

void add_segment(DomainFile& file, const Simplex& segment, std::size_t line) {
  file.input.segments.push_back(segment);
  file.segment_lines.push_back(line);
}

DomainFile with_duplicates_merged(DomainFile file) {
  const std::vector<Duplicate> repeated = duplicates(file.input.points);
  if (repeated.empty()) return file;
  std::vector<Vertex> place(file.input.points.size(), 0);
  for (const Duplicate& duplicate : repeated) {
    place[static_cast<std::size_t>(duplicate.again)] = -1 - duplicate.kept;
  }
  DomainFile merged = file;
  merged.labels.clear();
  merged.faces.clear();
  merged.input =
      PiecewiseLinearInput{{}, {}, {}, std::move(file.input.hole_seeds), file.input.kind};
  merged.segment_lines.clear();
  merged.polygon_lines.clear();
  merged.polygon_markers.clear();
  for (std::size_t v = 0; v < place.size(); ++v) {
    const bool repeats = place[v] < 0;
    if (repeats) {
      place[v] = place[static_cast<std::size_t>(-1 - place[v])];
      continue;
    }
    place[v] = static_cast<Vertex>(merged.input.points.size());
    merged.input.points.push_back(std::move(file.input.points[v]));
    merged.labels.push_back(file.label(static_cast<Vertex>(v)));
  }
  merged.notes.push_back(file.name + ": " + std::to_string(repeated.size()) +
                         (repeated.size() == 1 ? " point merged with an equal one"
                                               : " points merged with equal ones"));
  const auto renumber = [&place](std::vector<Vertex>& vertices) {
    for (Vertex& v : vertices) v = place[static_cast<std::size_t>(v)];
  };
  for (std::size_t i = 0; i < file.input.segments.size(); ++i) {
    renumber(file.input.segments[i]);
    if (file.input.segments[i][0] == file.input.segments[i][1]) continue;
    add_segment(merged, file.input.segments[i], file.segment_lines[i]);
  }
  for (std::size_t i = 0; i < file.input.polygons.size(); ++i) {
    for (auto& line : file.input.polygons[i].lines) renumber(line);
    add_facet(merged, std::move(file.input.polygons[i]), file.polygon_lines[i],
              file.polygon_markers[i]);
  }
  for (PolygonLines& face : file.faces) {
    for (auto& line : face.lines) {
      renumber(line);
      line = without_repetitions(line);
    }
    merged.faces.push_back(std::move(face));
  }
  return merged;
}

Status add_faces(DomainFile& file, const SimplexFile& faces) {
  std::set<Simplex> edges;  // in the plane
  for (std::size_t i = 0; i < faces.simplices.size(); ++i) {
    const std::size_t line = faces.lines.empty() ? 0 : faces.lines[i];
    std::vector<Vertex> corners;
    if (faces.simplices[i].empty()) {
      return tl::unexpected(FormatError{file.name, line, "a face of at least 1 vertex", "none"});
    }
    for (const Vertex index : faces.simplices[i]) {
      const Result<Vertex> place = place_of(file, index, line);
      if (!place) return tl::unexpected(place.error());
      corners.push_back(*place);
    }
    if (file.dimension == 3) {
      add_facet(file, {{std::move(corners)}, {}}, line);
      continue;
    }
    corners = without_repetitions(corners);
    if (corners.size() > 2) file.faces.push_back({{corners}, {}});
    for (std::size_t j = 0; corners.size() > 1 && j < corners.size(); ++j) {
      const Simplex edge = sorted({corners[j], corners[(j + 1) % corners.size()]});
      if (edges.insert(edge).second) add_segment(file, edge, line);
    }
  }
  return {};
}

}  // namespace circumspect::formats
