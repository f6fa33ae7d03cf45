// From files to meshes and point sets: what stands between the formats and the checkers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "oracle/formats/mesh_files.hpp"
#include "oracle/model/mesh.hpp"
#include "reference/kernel/exact/number_text.hpp"

namespace CLI {
class App;
}

namespace circumspect::cli {

enum class Duplicates { kReject, kMerge };

// What every subcommand that reads points lets its users choose.
struct InputOptions {
  NumberReading coordinates = NumberReading::kDouble;
  Duplicates duplicates = Duplicates::kReject;
  std::optional<std::string> points = {};  // --points FILE
  bool neighbors = false;                  // --neighbors
  bool faces = false;                      // read .face and .edge too, and their like
  bool allow_empty = false;                // --allow-empty
  bool weighted = false;                   // the claim or the construction is about weights
  bool listed_weights = false;  // without being asked for, what a file calls weights (JSON) counts
};

void add_coordinates_option(CLI::App& command, InputOptions& options);
void add_duplicates_option(CLI::App& command, InputOptions& options);
void add_allow_empty_option(CLI::App& command, InputOptions& options);

// A mesh that can be judged, or one line that says what is wrong with the input.
struct LoadedMesh {
  std::string name;
  Mesh mesh;
  std::vector<std::string> notes = {};  // what was read otherwise than it stands there
};
// `domain_dimension`: of the domain that the mesh is held against, if it is. Then what
// formats/fit_to_domain.hpp says is done.
tl::expected<LoadedMesh, std::string> load_mesh(const std::string& path,
                                                const InputOptions& options,
                                                std::optional<std::size_t> domain_dimension = {});

// The same for a mesh that has been read.
tl::expected<LoadedMesh, std::string> mesh_of(const std::string& path, formats::RawMesh raw,
                                              const InputOptions& options);

// Errors besides those of the formats: duplicates, unless they are merged (oracle/model/merged_points.hpp says
// how); a mesh without points and simplices, unless that is allowed; weights asked for and not there;
// neighbours asked for and not there.

// The points alone, as a mesh without simplices. If `merged` is given, it receives the duplicates
// that were merged, by places in the file counted from 0.
tl::expected<LoadedMesh, std::string> load_points(const std::string& path,
                                                  const InputOptions& options,
                                                  std::vector<Duplicate>* merged = nullptr);

}  // namespace circumspect::cli
