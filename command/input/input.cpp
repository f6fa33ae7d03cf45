#include "command/input/input.hpp"

#include <map>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command/options/one_of.hpp"
#include "oracle/model/merged_points.hpp"

namespace circumspect::cli {
namespace {

std::string duplicates_message(const std::string& name, const std::vector<Duplicate>& repeated,
                               Vertex first_index) {
  return fmt::format(
      "{}: expected distinct points, found points {} and {} equal{}; --duplicates merge treats "
      "them as one",
      name, repeated.front().kept + first_index, repeated.front().again + first_index,
      repeated.size() > 1 ? fmt::format(" and {} more duplicate{}", repeated.size() - 1,
                                        repeated.size() == 2 ? "" : "s")
                          : "");
}

// The weights of the points: what JSON says, or the first attribute, as TetGen's option -w reads it.
tl::expected<std::vector<Rational>, std::string> weights_of(const std::string& name,
                                                            const formats::PointFile& file,
                                                            const std::vector<Rational>& weights) {
  if (!weights.empty() || file.points.empty()) return weights;
  std::vector<Rational> first_attributes;
  for (const std::vector<Rational>& attributes : file.attributes) {
    if (!attributes.empty()) first_attributes.push_back(attributes.front());
  }
  if (first_attributes.size() == file.points.size()) return first_attributes;
  return tl::unexpected(fmt::format(
      "{}: expected a weight for each point (the first attribute of a .node file, the key "
      "\"weights\" of JSON), found none",
      name));
}

struct RawInput {
  std::string points_name;
  formats::PointFile points;
  std::vector<Rational> weights;
  std::vector<Simplex> simplices;
  std::vector<Simplex> faces;
};

// Those of lower dimension than the simplices of a mesh in this space.
std::vector<Simplex> proper_faces(std::vector<Simplex> faces, std::size_t dimension) {
  std::erase_if(faces, [dimension](const Simplex& face) { return face.size() > dimension; });
  return faces;
}

tl::expected<Mesh, std::string> assemble(RawInput raw, const InputOptions& options) {
  std::vector<Rational> weights;
  if (options.weighted) {
    auto found = weights_of(raw.points_name, raw.points, raw.weights);
    if (!found) return tl::unexpected(found.error());
    weights = std::move(*found);
  } else if (options.listed_weights) {
    weights = std::move(raw.weights);
  }
  std::vector<Point>& points = raw.points.points;
  const Vertex first_index = raw.points.first_index;
  const std::vector<Duplicate> repeated = duplicates(points);
  if (!repeated.empty() && options.duplicates == Duplicates::kReject) {
    return tl::unexpected(duplicates_message(raw.points_name, repeated, first_index));
  }
  return mesh_of_merged(std::move(points), std::move(weights), repeated, first_index,
                        std::move(raw.simplices), std::move(raw.faces));
}

// Gives the mesh the neighbours that were read, counted from 0. Returns what is wrong with them, or
// an empty string.
std::string attach_neighbors(Mesh& mesh, const std::string& path,
                             std::optional<formats::NeighborFile> file) {
  if (!file) return fmt::format("{}: expected a .neigh file beside it, found none", path);
  mesh.neighbors = Neighbors{std::move(file->neighbors), file->first_index};
  return "";
}

}  // namespace

void add_coordinates_option(CLI::App& command, InputOptions& options) {
  const std::map<std::string, NumberReading> readings = {{"double", NumberReading::kDouble},
                                                         {"decimal", NumberReading::kDecimal}};
  command
      .add_option("--coordinates", options.coordinates,
                  "How decimals are read: as the doubles that other programs saw ('double', "
                  "default), or exactly as written ('decimal')")
      ->transform(one_of(readings))
      ->option_text("double|decimal");
}

void add_duplicates_option(CLI::App& command, InputOptions& options) {
  const std::map<std::string, Duplicates> policies = {{"reject", Duplicates::kReject},
                                                      {"merge", Duplicates::kMerge}};
  command
      .add_option(
          "--duplicates", options.duplicates,
          "What to do about equal points: 'reject' the input (default), or 'merge' them into "
          "the first, or where weights count into the heaviest")
      ->transform(one_of(policies))
      ->option_text("reject|merge");
}

void add_allow_empty_option(CLI::App& command, InputOptions& options) {
  command.add_flag(
      "--allow-empty", options.allow_empty,
      "Take a file without points and simplices for a mesh of no points; otherwise it is "
      "the input's fault, exit code 3");
}

tl::expected<LoadedMesh, std::string> load_mesh(const std::string& path,
                                                const InputOptions& options,
                                                std::optional<std::size_t> domain_dimension) {
  auto raw = formats::read_mesh({path, options.points, options.coordinates, options.neighbors,
                                 options.faces, domain_dimension});
  if (!raw) return tl::unexpected(raw.error().to_string());
  return mesh_of(path, std::move(*raw), options);
}

tl::expected<LoadedMesh, std::string> mesh_of(const std::string& path, formats::RawMesh raw,
                                              const InputOptions& options) {
  raw.points.first_index = raw.first_index;
  std::vector<Simplex> faces = proper_faces(std::move(raw.faces), raw.points.dimension);
  auto mesh = assemble({raw.points_name, std::move(raw.points), std::move(raw.weights),
                        std::move(raw.simplices.simplices), std::move(faces)},
                       options);
  if (!mesh) return tl::unexpected(mesh.error());
  const bool is_empty = mesh->points.empty() && mesh->simplices.empty() && mesh->faces.empty();
  if (is_empty && !options.allow_empty) {
    return tl::unexpected(fmt::format(
        "{}: expected a mesh, found neither points nor simplices, as where a program wrote nothing "
        "(check and compare accept that with --allow-empty)",
        path));
  }
  if (options.neighbors) {
    const std::string fault = attach_neighbors(*mesh, path, std::move(raw.neighbors));
    if (!fault.empty()) return tl::unexpected(fault);
  }
  return LoadedMesh{path, std::move(*mesh), std::move(raw.notes)};
}

tl::expected<LoadedMesh, std::string> load_points(const std::string& path,
                                                  const InputOptions& options,
                                                  std::vector<Duplicate>* merged) {
  auto raw = formats::read_points(path, options.coordinates);
  if (!raw) return tl::unexpected(raw.error().to_string());
  if (merged != nullptr) *merged = duplicates(raw->points.points);
  auto mesh =
      assemble({raw->name, std::move(raw->points), std::move(raw->weights), {}, {}}, options);
  if (!mesh) return tl::unexpected(mesh.error());
  return LoadedMesh{path, std::move(*mesh)};
}

}  // namespace circumspect::cli
