#include "command/build/mesh_output.hpp"

#include <algorithm>
#include <cassert>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include "command/output/output.hpp"
#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/simplex.hpp"
#include "oracle/formats/json.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/point_file.hpp"
#include "oracle/formats/tetgen.hpp"
#include "oracle/model/mesh.hpp"
#include "platform/files.hpp"

namespace circumspect::cli {
namespace {

// The empty set has no simplices, but a file of them still says how many vertices each has.
std::size_t vertices_of_each(const Mesh& mesh) {
  return std::max<std::size_t>(mesh.simplices.columns(), 1);
}

// Where there are no points, files say one.
std::size_t coordinates_of_each(const Mesh& mesh) {
  return mesh.points() == 0 ? 1 : mesh.dimension();
}

// Simplices are numbered as the points are, but never −1, which means none, nor beyond 64 bits.
Vertex first_index_of_simplices(const Mesh& mesh) {
  return mesh.first_index >= 0 && has_room(mesh.first_index, mesh.simplices.size())
             ? mesh.first_index
             : 0;
}

// With `name(v)` for vertex v.
template <class Name>
formats::SimplexFile named_simplices(const Mesh& mesh, const Name& name) {
  formats::SimplexFile file;
  file.first_index = first_index_of_simplices(mesh);
  file.vertices_per_simplex = vertices_of_each(mesh);
  file.simplices.reserve(mesh.simplices.size() * file.vertices_per_simplex);
  mesh.simplices.visit([&]<class Lists>(const Lists& lists) {
    if constexpr (!std::is_same_v<Lists, std::vector<Simplex>>) {
      Simplex own(lists.columns());
      for (std::size_t i = 0; i < lists.rows(); ++i) {
        const auto row = lists.row(i);
        std::transform(row.begin(), row.end(), own.begin(), name);
        file.simplices.push_back(own);
      }
    } else {
      assert(lists.empty());  // of one length, they are in rows
    }
  });
  return file;
}

formats::PointRows point_rows(const Numbers& numbers) {
  formats::PointRows points;
  points.set_columns(std::max<std::size_t>(columns_of(numbers), 1));
  points.reserve(rows_of(numbers));
  std::visit(
      [&](const auto& rows) {
        for (const auto& number : rows.values()) points.add(number);
      },
      numbers);
  return points;
}

}  // namespace

std::string output_name_fault(const std::string& path,
                              const std::vector<std::string_view>& extensions) {
  const std::string end = formats::extension(path);
  if (path == "-" || std::find(extensions.begin(), extensions.end(), end) != extensions.end() ||
      is_device_or_pipe(path)) {
    return "";
  }
  std::string names;
  for (const std::string_view extension : extensions) names += fmt::format("OUT{}, ", extension);
  return fmt::format("expected -o {}or - for standard output, found {}", names, path);
}

formats::SimplexFile simplex_file(const Mesh& mesh) {
  return named_simplices(mesh, [&](Vertex v) { return mesh.label(v); });
}

formats::PointFile point_file(const Mesh& mesh, const std::vector<Duplicate>& merged) {
  formats::PointFile file;
  file.dimension = coordinates_of_each(mesh);
  file.first_index = mesh.first_index;
  if (merged.empty()) {
    file.points = point_rows(mesh.coordinates);
    for (Vertex v = 0; mesh.is_weighted() && mesh.names(v); ++v) {
      file.attributes.push_back({mesh.weight(v)});
    }
    return file;
  }
  std::vector<Point> all(mesh.points() + merged.size());
  if (mesh.is_weighted()) file.attributes.resize(all.size());
  for (Vertex v = 0; mesh.names(v); ++v) {
    const auto place = static_cast<std::size_t>(place_of_index(mesh.label(v), mesh.first_index));
    all[place] = mesh.point(v);
    if (mesh.is_weighted()) file.attributes[place] = {mesh.weight(v)};
  }
  const auto copy_missing = [&](Vertex from, Vertex to) {
    const auto source = static_cast<std::size_t>(from);
    const auto target = static_cast<std::size_t>(to);
    if (!all[target].empty()) return;
    all[target] = all[source];
    if (mesh.is_weighted()) file.attributes[target] = file.attributes[source];
  };
  // Of equal points with weights, any may be the one that is left.
  for (const auto& [kept, again] : merged) copy_missing(again, kept);
  for (const auto& [kept, again] : merged) copy_missing(kept, again);
  file.points = all;
  return file;
}

std::string points_beside(const std::string& path, const std::string& input) {
  if (formats::extension(path) != ".ele" || is_device_or_pipe(path)) return "";
  std::string beside = path.substr(0, path.size() - std::string_view(".ele").size()) + ".node";
  const auto there = platform::status_of(beside), read = platform::status_of(input);
  const bool is_input =
      there && read && there->device == read->device && there->number == read->number;
  return is_input ? "" : beside;
}

formats::NeighborFile neighbor_file(const Mesh& mesh) {
  const std::vector<Simplex> simplices = mesh.simplices.lists();
  formats::NeighborFile file;
  file.first_index = first_index_of_simplices(mesh);
  file.neighbors_per_simplex = vertices_of_each(mesh);
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

formats::JsonFile json_file(const Mesh& mesh) {
  formats::JsonFile file;
  file.points.dimension = coordinates_of_each(mesh);
  file.points.points = point_rows(mesh.coordinates);
  file.points.first_index = mesh.first_index;
  for (Vertex v = 0; mesh.is_weighted() && mesh.names(v); ++v) {
    file.weights.push_back(mesh.weight(v));
  }
  file.has_simplices = true;
  file.simplices =
      named_simplices(mesh, [&](Vertex v) { return index_of_place(v, mesh.first_index); });
  return file;
}

}  // namespace circumspect::cli
