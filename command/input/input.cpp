#include "command/input/input.hpp"

#include <algorithm>
#include <map>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command/options/one_of.hpp"
#include "command/options/whole_number.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::cli {
namespace {

// The weights that count.
formats::Weights weights_asked_for(const InputOptions& options) {
  if (options.weighted) return formats::Weights::kDemanded;
  return options.listed_weights ? formats::Weights::kListed : formats::Weights::kNone;
}

template <class Value>
Numbers without_column(const Rows<Value>& points, std::size_t column) {
  Rows<Value> others(points.rows(), points.columns() - 1);
  for (std::size_t i = 0; i < points.rows(); ++i) {
    for (std::size_t to = 0; to < others.columns(); ++to) {
      others.row(i)[to] = points.row(i)[to < column ? to : to + 1];
    }
  }
  return others;
}

template <class Value>
Numbers first_columns(const Rows<Value>& points, std::size_t columns) {
  Rows<Value> others(points.rows(), columns);
  for (std::size_t i = 0; i < points.rows(); ++i) {
    std::copy_n(points.row(i).begin(), columns, others.row(i).begin());
  }
  return others;
}

// Takes only the first coordinates; returns what is wrong with that, or an empty string.
std::string keep_dimension(LoadedMesh& loaded, std::size_t dimension) {
  Mesh& mesh = loaded.mesh;
  const std::size_t found = mesh.dimension();
  if (found < dimension) {
    return fmt::format("{}: expected points with at least {} numbers for --dimension, found {}",
                       loaded.points_name, dimension, found);
  }
  if (found == dimension) return "";
  mesh.coordinates =
      std::visit([dimension](const auto& points) { return first_columns(points, dimension); },
                 mesh.coordinates);
  loaded.notes.push_back(
      fmt::format("{}: the first {} of {} numbers of each point are taken for "
                  "coordinates (--dimension)",
                  loaded.points_name, dimension, found));
  return "";
}

// Projects a mesh of space along an axis; returns what is wrong with that, or an empty string.
std::string drop_coordinate(LoadedMesh& loaded, Axis along) {
  const auto axis = static_cast<std::size_t>(along);
  Mesh& mesh = loaded.mesh;
  if (mesh.dimension() != 3) {
    return fmt::format("{}: expected points with 3 coordinates for --drop, found {}",
                       loaded.points_name, mesh.dimension());
  }
  for (std::size_t i = 0; i < mesh.simplices.size(); ++i) {
    if (mesh.simplices[i].size() <= 3) continue;
    return fmt::format("{}: expected triangles or edges for --drop, found a simplex of {} vertices",
                       loaded.name, mesh.simplices[i].size());
  }
  mesh.coordinates = std::visit([axis](const auto& points) { return without_column(points, axis); },
                                mesh.coordinates);
  std::erase_if(mesh.faces, [](const Simplex& face) { return face.size() > 2; });
  loaded.notes.push_back(
      fmt::format("{}: the coordinate {} was left out (--drop)", loaded.points_name, "xyz"[axis]));
  return "";
}

std::string choose_coordinates(LoadedMesh& loaded, const InputOptions& options) {
  std::string fault = options.dimension ? keep_dimension(loaded, *options.dimension) : "";
  if (fault.empty() && options.dropped) fault = drop_coordinate(loaded, *options.dropped);
  return fault;
}

}  // namespace

void add_coordinates_option(CLI::App& command, InputOptions& options) {
  const std::map<std::string, NumberReading> readings = {{"double", NumberReading::kDouble},
                                                         {"decimal", NumberReading::kDecimal}};
  command
      .add_option(
          "--coordinates", options.coordinates,
          "Read decimals as the doubles that other programs saw ('double', default), or exactly "
          "as written ('decimal')")
      ->transform(one_of(readings))
      ->option_text("double|decimal");
}

void add_duplicates_option(CLI::App& command, InputOptions& options) {
  const std::map<std::string, Duplicates> policies = {{"reject", Duplicates::kReject},
                                                      {"merge", Duplicates::kMerge}};
  command
      .add_option(
          "--duplicates", options.duplicates,
          "If points are equal, 'reject' the input (default) or 'merge' them into the first; if "
          "weights count, into the heaviest")
      ->transform(one_of(policies))
      ->option_text("reject|merge");
}

void add_allow_empty_option(CLI::App& command, InputOptions& options) {
  command.add_flag(
      "--allow-empty", options.allow_empty,
      "Accept a file without points and simplices as a mesh of no points. Without this "
      "option, such an input is at fault (exit code 3)");
}

void add_drop_option(CLI::App& command, InputOptions& options) {
  const std::map<std::string, Axis> axes = {{"x", Axis::kX}, {"y", Axis::kY}, {"z", Axis::kZ}};
  command
      .add_option("--drop", options.dropped,
                  "Leave out this coordinate of points in space, so that a terrain is judged as it "
                  "is seen from above (z)")
      ->transform(one_of(axes))
      ->option_text("x|y|z");
}

void add_dimension_option(CLI::App& command, InputOptions& options) {
  command
      .add_option("--dimension", options.dimension,
                  "Take only the first N numbers of each point for coordinates: 3, where colours "
                  "or normals stand behind them")
      ->check(whole_number(1, formats::kLargestDimension))
      ->option_text("N")
      ->group("Input");
}

void add_keep_label_option(CLI::App& command, InputOptions& options) {
  command
      .add_option(
          "--keep-label", options.kept_labels,
          "Take only the cells of the mesh that have this label: the reference in Medit's .mesh, "
          "the physical group in Gmsh's .msh, the first attribute in .ele. May be given several "
          "times")
      ->option_text("N");
}

tl::expected<LoadedMesh, std::string> load_mesh(const std::string& path,
                                                const InputOptions& options, unsigned threads,
                                                const std::optional<DomainFrame>& frame) {
  const std::string end = formats::extension(path);
  auto file = formats::read_mesh(
      {.mesh = path,
       .points = options.points,
       .points_option = options.points_option,
       .reading = options.coordinates,
       .with_neighbors = options.neighbors,
       .with_faces = options.faces,
       .domain_dimension = frame ? std::optional(frame->dimension) : std::nullopt,
       .domain_height = frame ? frame->height : std::nullopt,
       // circumspect-verified reads these files as they stand.
       .keeps_coordinates = options.dropped.has_value() || options.dimension.has_value() ||
                            (options.for_certificate && (end == ".ele" || end == ".node")),
       .weights = weights_asked_for(options),
       .kept_labels = options.kept_labels},
      threads);
  if (!file) return tl::unexpected(file.error().to_string());
  const Mesh& mesh = file->mesh;
  const bool is_empty = mesh.points() == 0 && mesh.simplices.empty() && mesh.faces.empty();
  if (is_empty && !options.allow_empty) {
    return tl::unexpected(fmt::format(
        "{}: expected a mesh, found neither points nor simplices, as where a program wrote nothing "
        "(check and compare accept that with --allow-empty)",
        path));
  }
  if (options.neighbors && !mesh.neighbors) {
    return tl::unexpected(fmt::format("{}: expected a .neigh file beside it, found none", path));
  }
  LoadedMesh loaded{path,
                    std::move(file->mesh),
                    std::move(file->points_name),
                    std::move(file->notes),
                    std::move(file->face_markers),
                    std::move(file->height)};
  const std::string fault = choose_coordinates(loaded, options);
  if (!fault.empty()) return tl::unexpected(fault);
  loaded.is_surface = file->is_surface && loaded.mesh.dimension() == 3;
  return loaded;
}

std::string equal_points_fault(const LoadedMesh& loaded, const std::vector<Duplicate>& repeated) {
  const Duplicate& first = repeated.front();
  return fmt::format(
      "{}: {}", loaded.points_name,
      report::fault_of_equal_points(loaded.mesh.label(first.kept), loaded.mesh.label(first.again),
                                    repeated.size(), "add --duplicates merge to the command"));
}

std::optional<std::string> note_of_merging(const LoadedMesh& loaded) {
  if (loaded.merged.empty()) return std::nullopt;
  return loaded.points_name + ": " +
         report::note_of_merged_points(loaded.merged, loaded.mesh.first_index);
}

std::string settle_equal_points(LoadedMesh& loaded, Duplicates duplicates) {
  if (duplicates == Duplicates::kMerge) {
    loaded.merged = merge_equal_points(loaded.mesh);
    if (!loaded.merged.empty()) loaded.face_markers.clear();
    return "";
  }
  const std::vector<Duplicate> repeated = equal_points(loaded.mesh);
  return repeated.empty() ? "" : equal_points_fault(loaded, repeated);
}

tl::expected<LoadedMesh, std::string> load_point_rows(const std::string& path,
                                                      const InputOptions& options) {
  auto raw = formats::read_points(path, options.coordinates);
  if (!raw) return tl::unexpected(raw.error().to_string());
  auto weights = formats::weights_of(*raw, weights_asked_for(options));
  if (!weights) return tl::unexpected(weights.error().to_string());
  LoadedMesh loaded{path, {}, raw->name};
  loaded.mesh.coordinates = std::move(raw->points.points).as_numbers(raw->points.dimension);
  if (!weights->empty()) loaded.mesh.weights = numbers_of(*weights);
  loaded.mesh.first_index = raw->points.first_index;
  std::string fault = choose_coordinates(loaded, options);
  if (fault.empty()) fault = settle_equal_points(loaded, options.duplicates);
  if (!fault.empty()) return tl::unexpected(fault);
  const std::string end = formats::extension_inside(path);
  // Scanners write colours and normals there.
  if (loaded.mesh.dimension() > 3 && (end == ".xyz" || end == ".csv" || end == ".txt")) {
    loaded.notes.push_back(
        fmt::format("{}: read as points of dimension {}, one for each column; if only the first "
                    "three columns are coordinates, give --dimension 3",
                    path, loaded.mesh.dimension()));
  }
  return loaded;
}

tl::expected<LoadedPoints, std::string> load_points(const std::string& path,
                                                    const InputOptions& options) {
  const auto loaded = load_point_rows(path, options);
  if (!loaded) return tl::unexpected(loaded.error());
  return LoadedPoints{path, exact(loaded->mesh), loaded->notes, loaded->merged,
                      note_of_merging(*loaded)};
}

}  // namespace circumspect::cli
