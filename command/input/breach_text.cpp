#include "command/input/breach_text.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "kernel/exact/each_once.hpp"
#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"

namespace circumspect::cli {
namespace {

std::string labels_in_file(const std::vector<Vertex>& vertices, const formats::DomainFile& file) {
  std::vector<Vertex> own;
  for (const Vertex v : vertices) own.push_back(file.label(v));
  return fmt::format("{}", fmt::join(own, " "));
}

// The line on which a segment is listed, alone or as an edge of a polygon; 0 if that is not known.
std::size_t line_of_segment(const Simplex& segment, const formats::DomainFile& file) {
  for (std::size_t i = 0; i < file.input.segments.size(); ++i) {
    if (sorted(file.input.segments[i]) == segment) return file.segment_lines[i];
  }
  for (std::size_t i = 0; i < file.input.polygons.size(); ++i) {
    for (const auto& line : file.input.polygons[i].lines) {
      for (std::size_t j = 0; j < line.size(); ++j) {
        if (sorted({line[j], line[(j + 1) % line.size()]}) == segment) return file.polygon_lines[i];
      }
    }
  }
  return 0;
}

std::string segment_text(const Simplex& segment, const formats::DomainFile& file) {
  const std::size_t line = line_of_segment(sorted(segment), file);
  return "segment " + labels_in_file(segment, file) +
         (line == 0 ? "" : fmt::format(" (line {})", line));
}

// The first axis along which an offset is measured: see Breach.
char offset_axis(const std::vector<Vertex>& plane, const formats::DomainFile& file) {
  const auto& points = file.input.points;
  const auto at = [&](std::size_t i) { return points[static_cast<std::size_t>(plane[i])]; };
  return "xyz"[longest_axis(cross_product(at(1) - at(0), at(2) - at(0)))];
}

bool is_off_a_plane(const Breach& breach) { return breach.offset && breach.vertices.size() >= 3; }

// The subject that is off a plane, then the plane: the last three vertices.
std::string off_plane_text(const Breach& breach, const formats::DomainFile& file) {
  const std::vector<Vertex> plane(breach.vertices.end() - 3, breach.vertices.end());
  return fmt::format("{} off the plane of vertices {} along {}", value_text(*breach.offset),
                     labels_in_file(plane, file), offset_axis(plane, file));
}

}  // namespace

std::string polygon_name(std::size_t polygon, const formats::DomainFile& file) {
  const std::size_t line = file.polygon_lines[polygon];
  return std::to_string(polygon + 1) + (line == 0 ? "" : fmt::format(" (line {})", line));
}

std::string breach_place(const Breach& breach, const formats::DomainFile& file) {
  std::size_t line = 0;
  if (!breach.polygons.empty()) {
    line = file.polygon_lines[breach.polygons.front()];
  } else if (!breach.segments.empty()) {
    line = line_of_segment(sorted(breach.segments.front()), file);
  }
  return file.name + (line == 0 ? "" : ":" + std::to_string(line));
}

namespace {

// Which parts of the input are in question, and how: what stands behind the meaning.
std::string breach_words(const Breach& breach, const formats::DomainFile& file) {
  std::vector<std::string> parts;
  const bool is_off_plane = is_off_a_plane(breach);
  for (const std::size_t polygon : breach.polygons) {
    parts.push_back("polygon " + polygon_name(polygon, file));
  }
  for (const Simplex& segment : breach.segments) parts.push_back(segment_text(segment, file));
  const std::size_t own = breach.vertices.size() - (is_off_plane ? 3 : 0);
  if (own > 0) {
    const std::vector<Vertex> vertices(breach.vertices.begin(),
                                       breach.vertices.begin() + static_cast<std::ptrdiff_t>(own));
    parts.push_back((own == 1 ? "vertex " : "vertices ") + labels_in_file(vertices, file));
  }
  if (breach.point) parts.push_back("point " + point_text(*breach.point));
  if (is_off_plane) parts.push_back(off_plane_text(breach, file));
  if (breach.squared_distance) {
    parts.push_back("~ " + square_root_to_decimal(*breach.squared_distance) +
                    " off the plane that is nearest to all its vertices");
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

std::string breach_line(const Breach& breach, const formats::DomainFile& file) {
  return fmt::format("{}: {}: {}", identifier(breach.kind), meaning(breach.kind),
                     breach_words(breach, file));
}

report::Json breach_json(const Breach& breach, const formats::DomainFile& file) {
  report::Json object = {{"rule", identifier(breach.kind)}, {"meaning", meaning(breach.kind)}};
  const auto own = [&](const std::vector<Vertex>& vertices) {
    report::Json array = report::Json::array();
    for (const Vertex v : vertices) array.push_back(file.label(v));
    return array;
  };
  if (!breach.vertices.empty()) object["vertices"] = own(breach.vertices);
  for (const Simplex& segment : breach.segments) object["segments"].push_back(own(segment));
  for (const std::size_t polygon : breach.polygons) {
    report::Json entry = {{"polygon", polygon + 1}};
    if (file.polygon_lines[polygon] != 0) entry["line"] = file.polygon_lines[polygon];
    object["polygons"].push_back(entry);
  }
  if (breach.point) object["point"] = report::point(*breach.point);
  if (breach.offset) object["offset"] = to_string(*breach.offset);
  if (breach.squared_distance) {
    object["squared_distance"] = to_string(*breach.squared_distance);
    object["distance_decimal"] = square_root_to_decimal(*breach.squared_distance);
  }
  return object;
}

namespace {

constexpr std::size_t kMostEdges = 200;  // of a polygon, as many are drawn

// Calls the visitor for each edge of the lines of a polygon, in their order.
template <typename Visitor>
void for_each_edge(const PolygonLines& polygon, Visitor visitor) {
  for (const auto& line : polygon.lines) {
    if (line.size() < 2) continue;
    for (std::size_t i = 0; i < (line.size() > 2 ? line.size() : 1); ++i) {
      visitor(Simplex{line[i], line[(i + 1) % line.size()]});
    }
  }
}

// What a card draws, and in which groups.
struct Drawn {
  Witness witness = {};
  report::Json groups = report::Json::array();

  // What was added since the last group; without a role, the next one.
  void group(const std::string& words, bool closed = false, std::string_view role = {}) {
    std::size_t count = witness.simplices.size();
    for (const report::Json& before : groups) count -= before["count"].get<std::size_t>();
    constexpr std::string_view kRoles[] = {"first", "second", "third"};
    if (role.empty()) role = kRoles[std::min<std::size_t>(groups.size(), 2)];
    groups.push_back({{"role", role}, {"words", words}, {"count", count}, {"closed", closed}});
  }
  void polygon(const PolygonLines& polygon, std::string words, std::string_view role = {}) {
    std::size_t edges = 0;
    for_each_edge(polygon, [&](Simplex edge) {
      if (++edges <= kMostEdges) witness.simplices.push_back(std::move(edge));
    });
    if (edges > kMostEdges) words += fmt::format(", {} of {} edges", kMostEdges, edges);
    group(words, polygon.lines.size() == 1 && edges > 2 && edges <= kMostEdges, role);
  }
};

}  // namespace

std::pair<report::Json, Witness> breach_card(const Breach& breach,
                                             const formats::DomainFile& file) {
  Drawn drawn;
  Witness& witness = drawn.witness;
  for (const std::size_t place : breach.polygons) {
    drawn.polygon(file.input.polygons[place], "polygon " + polygon_name(place, file));
  }
  for (const Simplex& segment : breach.segments) {
    witness.simplices.push_back(segment);
    drawn.group(segment_text(segment, file));
  }
  witness.vertices = breach.vertices;
  if (is_off_a_plane(breach)) {
    witness.simplices.emplace_back(breach.vertices.end() - 3, breach.vertices.end());
    drawn.group("the plane of vertices " + labels_in_file(witness.simplices.back(), file));
    witness.vertices.resize(breach.vertices.size() - 3);
  }
  witness.point = breach.point;
  if (breach.offset) witness.values.push_back({"offset", *breach.offset});
  if (breach.squared_distance) {
    witness.values.push_back({"squared distance", *breach.squared_distance});
  }
  std::string caption = breach_words(breach, file);
  if (!caption.empty()) caption.front() = static_cast<char>(std::toupper(caption.front()));
  return {{{"rule", identifier(breach.kind)},
           {"meaning", meaning(breach.kind)},
           {"caption", caption + "."},
           {"around", "segments and polygons around it"},
           {"groups", drawn.groups}},
          std::move(witness)};
}

std::optional<std::pair<report::Json, Witness>> domain_card(const formats::DomainFile& file) {
  std::size_t edges = file.input.segments.size();
  for (const PolygonLines& polygon : file.input.polygons) {
    for_each_edge(polygon, [&](const Simplex&) { ++edges; });
  }
  if (edges == 0 || edges > kMostEdges) return std::nullopt;
  Drawn drawn;
  for (const PolygonLines& polygon : file.input.polygons) {
    drawn.polygon(polygon, "polygons", "first");
  }
  for (const auto& segment : file.input.segments) drawn.witness.simplices.push_back(segment);
  drawn.group("segments", false, "second");
  return std::pair(report::Json{{"meaning", "the domain as it was read"},
                                {"caption", "The polygons of the domain, and its segments."},
                                {"groups", drawn.groups}},
                   std::move(drawn.witness));
}

Mesh skeleton(const formats::DomainFile& file) {
  Mesh mesh;
  mesh.coordinates = numbers_of(file.input.points, file.dimension);
  mesh.labels = file.labels;
  mesh.first_index = file.first_index;
  std::vector<Simplex> edges = file.input.segments;
  for (const PolygonLines& polygon : file.input.polygons) {
    for_each_edge(polygon, [&](Simplex edge) { edges.push_back(std::move(edge)); });
  }
  for (Simplex& edge : edges) edge = sorted(std::move(edge));
  keep_each_once(edges);
  mesh.simplices = IndexLists(edges);
  return mesh;
}

}  // namespace circumspect::cli
