#include "fuzz/campaign/domain_text.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "kernel/piecewise_linear/validity.hpp"
#include "oracle/formats/bytes/lines.hpp"

namespace circumspect::campaign {
namespace {

std::string counted(const std::vector<Point>& points, Vertex first) {
  std::string text;
  for (std::size_t i = 0; i < points.size(); ++i) {
    text +=
        std::to_string(first + static_cast<Vertex>(i)) + " " + formats::joined(points[i]) + "\n";
  }
  return text;
}

std::string corners(std::vector<Vertex> line, Vertex first) {
  for (Vertex& v : line) v += first;
  return std::to_string(line.size()) + " " + formats::joined(line) + "\n";
}

std::string segments_text(const PiecewiseLinearInput& input, Vertex first) {
  std::string text = std::to_string(input.segments.size()) + " 0\n";
  for (std::size_t i = 0; i < input.segments.size(); ++i) {
    std::vector<Vertex> row = {static_cast<Vertex>(i)};
    row.insert(row.end(), input.segments[i].begin(), input.segments[i].end());
    for (Vertex& v : row) v += first;
    text += formats::joined(row) + "\n";
  }
  return text;
}

// Adds to each polygon the cells that lie in it and are not listed there: a segment is a line of
// two vertices, an isolated vertex a line of one. By Definition 4.3 of the book these are faces of
// the polygon; TetGen needs them listed.
PiecewiseLinearInput with_all_faces_listed(PiecewiseLinearInput input) {
  const auto complex = validated(input, 1);
  if (!complex) return input;
  for (const Adoption& adoption : adoptions(input, *complex)) {
    std::vector<std::vector<Vertex>>& lines = input.polygons[adoption.polygon].lines;
    std::set<Vertex> ends;
    for (const Simplex& segment : adoption.segments) {
      lines.push_back(segment);
      ends.insert(segment.begin(), segment.end());
    }
    for (const Vertex v : adoption.vertices) {
      if (ends.count(v) == 0) lines.push_back({v});
    }
  }
  return input;
}

std::string facets_text(const PiecewiseLinearInput& input, Vertex first) {
  std::string text = std::to_string(input.polygons.size() + input.segments.size()) + " 0\n";
  for (const PolygonLines& polygon : input.polygons) {
    text += std::to_string(polygon.lines.size()) + " " + std::to_string(polygon.hole_seeds.size()) +
            "\n";
    for (const std::vector<Vertex>& line : polygon.lines) text += corners(line, first);
    text += counted(polygon.hole_seeds, 1);
  }
  for (const std::vector<Vertex>& segment : input.segments)
    text += "1 0\n" + corners(segment, first);
  return text;
}

using Edge = std::pair<Vertex, Vertex>;

Edge undirected(Vertex a, Vertex b) { return {std::min(a, b), std::max(a, b)}; }

// The number of each edge, from 1, and how many polygons have it.
struct Edges {
  std::map<Edge, int> numbers = {};
  std::map<Edge, int> uses = {};

  void add(const std::vector<Vertex>& line) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Edge edge = undirected(line[i], line[(i + 1) % line.size()]);
      numbers.try_emplace(edge, static_cast<int>(numbers.size()) + 1);
      ++uses[edge];
    }
  }
};

bool is_simple(const PolygonLines& polygon) {
  if (polygon.lines.size() != 1 || !polygon.hole_seeds.empty()) return false;
  const std::vector<Vertex>& line = polygon.lines.front();
  return line.size() >= 3 && std::set<Vertex>(line.begin(), line.end()).size() == line.size();
}

// Polygons with one outline each, if there is nothing else; otherwise nothing.
std::optional<Edges> surface(const PiecewiseLinearInput& input) {
  const bool plain = !input.points.empty() && input.points.front().size() == 3 &&
                     input.hole_seeds.empty() && !input.polygons.empty() &&
                     std::all_of(input.polygons.begin(), input.polygons.end(), is_simple);
  if (!plain) return std::nullopt;
  Edges edges;
  std::set<Vertex> used;
  for (const PolygonLines& polygon : input.polygons) {
    edges.add(polygon.lines.front());
    used.insert(polygon.lines.front().begin(), polygon.lines.front().end());
  }
  const bool no_other_segment =
      std::all_of(input.segments.begin(), input.segments.end(), [&](const auto& segment) {
        return edges.numbers.count(undirected(segment.front(), segment.back())) != 0;
      });
  if (!no_other_segment || used.size() != input.points.size()) return std::nullopt;
  return edges;
}

// The surface of one volume, or nothing.
std::optional<Edges> closed_surface(const PiecewiseLinearInput& input) {
  std::optional<Edges> edges = surface(input);
  const auto is_closed = [](const auto& use) { return use.second == 2; };
  if (edges && !std::all_of(edges->uses.begin(), edges->uses.end(), is_closed)) edges.reset();
  return edges;
}

std::string faces_text(const PiecewiseLinearInput& input, const std::string& before_each,
                       bool with_count, Vertex first) {
  std::string text;
  for (const PolygonLines& polygon : input.polygons) {
    std::vector<Vertex> line = polygon.lines.front();
    for (Vertex& v : line) v += first;
    text += before_each + (with_count ? std::to_string(line.size()) + " " : "") +
            formats::joined(line) + "\n";
  }
  return text;
}

std::string stl_text(const PiecewiseLinearInput& input) {
  std::string text = "solid domain\n";
  for (const PolygonLines& polygon : input.polygons) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const Vertex v : polygon.lines.front()) {
      text += "vertex " + formats::joined(input.points[static_cast<std::size_t>(v)]) + "\n";
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid domain\n";
}

std::string rows_after(const std::string& word, const std::vector<Point>& points) {
  std::string text;
  for (const Point& point : points) text += word + formats::joined(point) + "\n";
  return text;
}

// Version 2.2, which all programs read: element type 2 is a triangle; one physical and one
// elementary entity.
std::string msh_text(const PiecewiseLinearInput& input) {
  std::string text = fmt::format("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{}\n{}$EndNodes\n",
                                 input.points.size(), counted(input.points, 1)) +
                     fmt::format("$Elements\n{}\n", input.polygons.size());
  for (std::size_t i = 0; i < input.polygons.size(); ++i) {
    std::vector<Vertex> line = input.polygons[i].lines.front();
    for (Vertex& v : line) ++v;
    text += fmt::format("{} 2 2 1 1 {}\n", i + 1, formats::joined(line));
  }
  return text + "$EndElements\n";
}

std::string with_commas(std::string text) {
  std::replace(text.begin(), text.end(), ' ', ',');
  return text;
}

std::string loop_of(const std::vector<Vertex>& line, const Edges& edges) {
  std::string text;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vertex a = line[i];
    const Vertex b = line[(i + 1) % line.size()];
    text += std::string(i == 0 ? "" : ",") + (a < b ? "" : "-") +
            std::to_string(edges.numbers.at(undirected(a, b)));
  }
  return text;
}

}  // namespace

std::string poly_text(const PiecewiseLinearInput& input, Vertex first_index) {
  const bool in_plane = !input.points.empty() && input.points.front().size() == 2;
  return std::to_string(input.points.size()) + (in_plane ? " 2 0 0\n" : " 3 0 0\n") +
         counted(input.points, first_index) +
         (in_plane ? segments_text(input, first_index)
                   : facets_text(with_all_faces_listed(input), first_index)) +
         std::to_string(input.hole_seeds.size()) + "\n" + counted(input.hole_seeds, 1);
}

std::string case_text(const PiecewiseLinearInput& input, std::size_t dimension) {
  if (!input.points.empty()) dimension = input.points.front().size();
  const PiecewiseLinearInput listed = dimension == 3 ? with_all_faces_listed(input) : input;
  const auto rows = [](const auto& all) {
    std::string text;
    for (const auto& row : all) text += formats::joined(row) + "\n";
    return text;
  };
  std::string text =
      fmt::format("{} {} 0 {} {} {}\n", listed.points.size(), dimension, listed.segments.size(),
                  listed.polygons.size(), listed.hole_seeds.size()) +
      rows(listed.points) + rows(listed.segments);
  for (const PolygonLines& polygon : listed.polygons) {
    text += std::to_string(polygon.lines.size()) + " " + std::to_string(polygon.hole_seeds.size()) +
            "\n";
    for (const std::vector<Vertex>& line : polygon.lines) text += corners(line, 0);
    text += rows(polygon.hole_seeds);
  }
  return text + rows(listed.hole_seeds);
}

bool is_surface_extension(const std::string& extension) {
  return extension == ".off" || extension == ".obj" || extension == ".ply" || extension == ".stl" ||
         extension == ".msh";
}

std::optional<std::string> surface_text(const PiecewiseLinearInput& input,
                                        const std::string& extension) {
  if (!surface(input)) return std::nullopt;
  const bool all_triangles =
      std::all_of(input.polygons.begin(), input.polygons.end(),
                  [](const PolygonLines& polygon) { return polygon.lines.front().size() == 3; });
  if (extension == ".off") {
    return fmt::format("OFF\n{} {} 0\n", input.points.size(), input.polygons.size()) +
           rows_after("", input.points) + faces_text(input, "", true, 0);
  }
  if (extension == ".obj") {
    return rows_after("v ", input.points) + faces_text(input, "f ", false, 1);
  }
  if (extension == ".ply") {
    return fmt::format(
               "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\n"
               "property double z\nelement face {}\nproperty list uchar int vertex_indices\n"
               "end_header\n",
               input.points.size(), input.polygons.size()) +
           rows_after("", input.points) + faces_text(input, "", true, 0);
  }
  if (!all_triangles) return std::nullopt;
  return extension == ".stl" ? stl_text(input) : msh_text(input);
}

std::optional<std::string> geo_text(const PiecewiseLinearInput& input) {
  const std::optional<Edges> edges = closed_surface(input);
  if (!edges) return std::nullopt;
  std::string text = "Mesh.MeshSizeExtendFromBoundary = 0;\nMesh.MeshSizeFromPoints = 0;\n";
  for (std::size_t v = 0; v < input.points.size(); ++v) {
    text += "Point(" + std::to_string(v + 1) + ") = {" +
            with_commas(formats::joined(input.points[v])) + "};\n";
  }
  for (const auto& [edge, number] : edges->numbers) {
    const std::string name = std::to_string(number);
    text += "Line(" + name + ") = {" + std::to_string(edge.first + 1) + "," +
            std::to_string(edge.second + 1) + "};\nTransfinite Line{" + name + "} = 2;\n";
  }
  std::string surfaces;
  for (std::size_t i = 0; i < input.polygons.size(); ++i) {
    const std::string name = std::to_string(i + 1);
    text += "Line Loop(" + name + ") = {" + loop_of(input.polygons[i].lines.front(), *edges) +
            "};\nPlane Surface(" + name + ") = {" + name + "};\n";
    surfaces += (i == 0 ? "" : ",") + name;
  }
  return text + "Surface Loop(1) = {" + surfaces + "};\nVolume(1) = {1};\n";
}

}  // namespace circumspect::campaign
