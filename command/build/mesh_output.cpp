#include "command/build/mesh_output.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/complex/triangulation.hpp"
#include "oracle/formats/json.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/point_file.hpp"
#include "oracle/formats/tetgen.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace circumspect::cli {
namespace {

// The empty set has no simplices, but a file of them still says how many vertices each has.
std::size_t vertices_of_each(const Triangulation& triangulation) {
  return static_cast<std::size_t>(std::max(triangulation.dimension(), 0) + 1);
}

// Simplices are numbered as the points are, but never −1, which means none, nor beyond 64 bits.
Vertex first_index_of_simplices(const ExactMesh& mesh, const Triangulation& triangulation) {
  const std::size_t count = triangulation.simplices().size();
  return mesh.first_index >= 0 && has_room(mesh.first_index, count) ? mesh.first_index : 0;
}

bool is_there_and_no_file(const std::string& path) {
  std::error_code error;
  const std::filesystem::file_status there = std::filesystem::status(path, error);
  return std::filesystem::exists(there) && !std::filesystem::is_regular_file(there) &&
         !std::filesystem::is_directory(there);
}

}  // namespace

std::string output_name_fault(const std::string& path,
                              const std::vector<std::string_view>& extensions) {
  const std::string end = formats::extension(path);
  if (path == "-" || std::find(extensions.begin(), extensions.end(), end) != extensions.end() ||
      is_there_and_no_file(path)) {
    return "";
  }
  std::string names;
  for (const std::string_view extension : extensions) names += fmt::format("OUT{}, ", extension);
  return fmt::format("expected -o {}or - for standard output, found {}", names, path);
}

formats::SimplexFile simplex_file(const ExactMesh& mesh, const Triangulation& triangulation) {
  formats::SimplexFile file;
  file.first_index = first_index_of_simplices(mesh, triangulation);
  file.vertices_per_simplex = vertices_of_each(triangulation);
  for (const Simplex& simplex : triangulation.simplices()) {
    Simplex own = positively_oriented(mesh.points, simplex);
    for (Vertex& v : own) v = mesh.label(v);
    file.simplices.push_back(own);
  }
  return file;
}

formats::PointFile point_file(const ExactMesh& mesh, const std::vector<Duplicate>& merged) {
  const PointSet& points = mesh.points;
  formats::PointFile file;
  file.dimension = std::max<std::size_t>(points.ambient_dimension(), 1);
  file.first_index = mesh.first_index;
  std::vector<Point> all(points.size() + merged.size());
  if (points.is_weighted()) file.attributes.resize(all.size());
  for (Vertex v = 0; points.names(v); ++v) {
    const auto place = static_cast<std::size_t>(place_of_index(mesh.label(v), mesh.first_index));
    all[place] = points[v];
    if (points.is_weighted()) file.attributes[place] = {points.weight(v)};
  }
  const auto copy_missing = [&](Vertex from, Vertex to) {
    const auto source = static_cast<std::size_t>(from);
    const auto target = static_cast<std::size_t>(to);
    if (!all[target].empty()) return;
    all[target] = all[source];
    if (points.is_weighted()) file.attributes[target] = file.attributes[source];
  };
  // Of equal points with weights, any may be the one that is left.
  for (const auto& [kept, again] : merged) copy_missing(again, kept);
  for (const auto& [kept, again] : merged) copy_missing(kept, again);
  file.points = all;
  return file;
}

std::string points_beside(const std::string& path, const std::string& input) {
  if (formats::extension(path) != ".ele" || is_there_and_no_file(path)) return "";
  std::string beside = path.substr(0, path.size() - std::string_view(".ele").size()) + ".node";
  std::error_code error;
  const bool is_input = std::filesystem::equivalent(beside, input, error);
  return is_input && !error ? "" : beside;
}

formats::NeighborFile neighbor_file(const ExactMesh& mesh, const Triangulation& triangulation) {
  std::vector<Simplex> simplices;
  for (const Simplex& simplex : triangulation.simplices()) {
    simplices.push_back(positively_oriented(mesh.points, simplex));
  }
  formats::NeighborFile file;
  file.first_index = first_index_of_simplices(mesh, triangulation);
  file.neighbors_per_simplex = vertices_of_each(triangulation);
  for (const Simplex& simplex : simplices) file.neighbors.emplace_back(simplex.size(), -1);
  for (const auto group : ByFacet(facet_uses(simplices))) {
    if (group.size() != 2) continue;
    const auto link = [&](const FacetUse& from, const FacetUse& to) {
      file.neighbors[from.simplex][from.opposite] =
          static_cast<Vertex>(to.simplex) + file.first_index;
    };
    link(group[0], group[1]);
    link(group[1], group[0]);
  }
  return file;
}

formats::JsonFile json_file(const ExactMesh& mesh, const Triangulation& triangulation) {
  formats::JsonFile file;
  file.points.dimension = std::max<std::size_t>(mesh.points.ambient_dimension(), 1);
  file.points.points = mesh.points.points();
  file.points.first_index = mesh.first_index;
  if (mesh.points.is_weighted()) {
    for (Vertex v = 0; mesh.points.names(v); ++v) file.weights.push_back(mesh.points.weight(v));
  }
  file.has_simplices = true;
  file.simplices = simplex_file({mesh.points, {}, {}, mesh.first_index}, triangulation);
  return file;
}

}  // namespace circumspect::cli
