#include "oracle/cli/input.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace circumspect::cli {
namespace {

// Points without duplicates, and where each of the original ones went.
struct DistinctPoints {
  std::vector<Point> points;
  std::vector<Vertex> labels;
  std::vector<Vertex> place_of;
};

DistinctPoints merge(const std::vector<Point>& points, const std::vector<Duplicate>& repeated,
                     Vertex first_index) {
  DistinctPoints distinct;
  distinct.place_of.assign(points.size(), -1);
  std::map<Vertex, Vertex> kept_for;
  for (const Duplicate& duplicate : repeated) kept_for[duplicate.again] = duplicate.kept;
  for (std::size_t v = 0; v < points.size(); ++v) {
    const auto kept = kept_for.find(static_cast<Vertex>(v));
    if (kept != kept_for.end()) {
      distinct.place_of[v] = distinct.place_of[static_cast<std::size_t>(kept->second)];
      continue;
    }
    distinct.place_of[v] = static_cast<Vertex>(distinct.points.size());
    distinct.points.push_back(points[v]);
    distinct.labels.push_back(static_cast<Vertex>(v) + first_index);
  }
  return distinct;
}

std::string duplicates_message(const std::string& name, const std::vector<Duplicate>& repeated,
                               Vertex first_index) {
  return fmt::format(
      "{}: expected distinct points, found points {} and {} equal{}; --duplicates merge treats "
      "them as one",
      name, repeated.front().kept + first_index, repeated.front().again + first_index,
      repeated.size() > 1 ? fmt::format(" and {} more duplicates", repeated.size() - 1) : "");
}

tl::expected<Mesh, std::string> assemble(const std::string& points_name, std::vector<Point> points,
                                         std::vector<Simplex> simplices, Vertex first_index,
                                         Duplicates policy) {
  const std::vector<Duplicate> repeated = duplicates(points);
  if (repeated.empty()) {
    return Mesh{PointSet(std::move(points)), std::move(simplices), {}, first_index};
  }
  if (policy == Duplicates::kReject) {
    return tl::unexpected(duplicates_message(points_name, repeated, first_index));
  }
  DistinctPoints distinct = merge(points, repeated, first_index);
  const auto named = static_cast<Vertex>(points.size());
  for (Simplex& simplex : simplices) {
    for (Vertex& v : simplex) {
      if (v >= 0 && v < named) v = distinct.place_of[static_cast<std::size_t>(v)];
    }
  }
  return Mesh{PointSet(std::move(distinct.points)), std::move(simplices),
              std::move(distinct.labels), first_index};
}

// Gives the mesh the neighbours that were read, counted from 0. Returns what is wrong with them, or
// an empty string.
std::string attach_neighbors(Mesh& mesh, const std::string& path,
                             const std::optional<formats::NeighborFile>& file) {
  if (!file) return fmt::format("{}: expected a .neigh file beside it, found none", path);
  const std::size_t size = mesh.simplices.empty() ? 0 : mesh.simplices.front().size();
  if (file->neighbors.size() != mesh.simplices.size() ||
      (size != 0 && file->neighbors_per_simplex != size)) {
    return fmt::format(
        "{}: expected neighbours of {} simplices with {} vertices each, found {} "
        "lines of {} neighbours",
        path, mesh.simplices.size(), size, file->neighbors.size(), file->neighbors_per_simplex);
  }
  mesh.neighbors = Neighbors{file->neighbors, file->first_index};
  return "";
}

}  // namespace

void add_coordinates_option(CLI::App& command, InputOptions& options) {
  const std::map<std::string, NumberReading> readings = {{"double", NumberReading::kDouble},
                                                         {"decimal", NumberReading::kDecimal}};
  command
      .add_option("--coordinates", options.coordinates,
                  "How decimals are read: 'double' as strtod does, which is what other programs "
                  "saw (default), or 'decimal', exactly as written")
      ->transform(CLI::CheckedTransformer(readings, CLI::ignore_case).description(""))
      ->option_text("double|decimal");
}

void add_duplicates_option(CLI::App& command, InputOptions& options) {
  const std::map<std::string, Duplicates> policies = {{"reject", Duplicates::kReject},
                                                      {"merge", Duplicates::kMerge}};
  command
      .add_option("--duplicates", options.duplicates,
                  "Equal points: 'reject' the input (default) or 'merge' them")
      ->transform(CLI::CheckedTransformer(policies, CLI::ignore_case).description(""))
      ->option_text("reject|merge");
}

tl::expected<LoadedMesh, std::string> load_mesh(const std::string& path,
                                                const InputOptions& options) {
  auto raw = formats::read_mesh({path, options.points, options.coordinates, options.neighbors});
  if (!raw) return tl::unexpected(raw.error().to_string());
  auto mesh = assemble(raw->points_name, std::move(raw->points.points),
                       std::move(raw->simplices.simplices), raw->first_index, options.duplicates);
  if (!mesh) return tl::unexpected(mesh.error());
  if (options.neighbors) {
    const std::string fault = attach_neighbors(*mesh, path, raw->neighbors);
    if (!fault.empty()) return tl::unexpected(fault);
  }
  return LoadedMesh{path, std::move(*mesh)};
}

tl::expected<LoadedMesh, std::string> load_points(const std::string& path,
                                                  const InputOptions& options,
                                                  std::vector<Duplicate>* merged) {
  auto raw = formats::read_points(path, options.coordinates);
  if (!raw) return tl::unexpected(raw.error().to_string());
  if (merged != nullptr) *merged = duplicates(raw->points.points);
  auto mesh = assemble(raw->name, std::move(raw->points.points), {}, raw->points.first_index,
                       options.duplicates);
  if (!mesh) return tl::unexpected(mesh.error());
  return LoadedMesh{path, std::move(*mesh)};
}

}  // namespace circumspect::cli
