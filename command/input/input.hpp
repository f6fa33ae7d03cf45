// Reads files as meshes and point sets; it is the layer between the formats and the checkers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace CLI {
class App;
}

namespace circumspect::cli {

enum class Duplicates { kReject, kMerge };
enum class Axis { kX, kY, kZ };

// What every subcommand that reads points lets its users choose.
struct InputOptions {
  NumberReading coordinates = NumberReading::kDouble;
  Duplicates duplicates = Duplicates::kReject;
  std::optional<std::string> points = {};  // --points FILE
  std::string points_option = "--points";  // as this command calls it
  bool neighbors = false;                  // --neighbors
  bool faces = false;                      // read .face and .edge too, and their like
  std::vector<Vertex> kept_labels = {};    // --keep-label; empty: all
  std::optional<Axis> dropped = {};        // --drop: the coordinate that is left out
  // --dimension: how many numbers of each point are coordinates
  std::optional<std::size_t> dimension = {};
  bool allow_empty = false;      // --allow-empty
  bool weighted = false;         // the claim or the construction is about weights
  bool for_certificate = false;  // a certificate is about the numbers of the files
  bool listed_weights = false;   // without being asked for, what a file calls weights (JSON) counts
};

void add_coordinates_option(CLI::App& command, InputOptions& options);
void add_duplicates_option(CLI::App& command, InputOptions& options);
void add_allow_empty_option(CLI::App& command, InputOptions& options);
void add_keep_label_option(CLI::App& command, InputOptions& options);
void add_drop_option(CLI::App& command, InputOptions& options);
void add_dimension_option(CLI::App& command, InputOptions& options);

// A mesh as it was read, or one line that says what is wrong with the input.
struct LoadedMesh {
  std::string name;
  Mesh mesh;
  std::string points_name = {};         // of the file with its points
  std::vector<std::string> notes = {};  // what was read otherwise than it stands there
  std::map<Simplex, Vertex> face_markers =
      {};                               // as MeshFile has them; none where points were merged
  std::optional<Rational> height = {};  // likewise
  std::vector<Duplicate> merged = {};   // equal points, by places in the file, counted from 0
  bool is_surface = false;              // as MeshFile has it
};

// Of the domain that a mesh is held against: its dimension and, if it is in the plane and its
// points have three coordinates, the third.
struct DomainFrame {
  std::size_t dimension = 0;
  std::optional<Rational> height = {};
};

// Errors besides those of the formats: a mesh without points and simplices, unless that is allowed;
// weights asked for and not there; neighbours asked for and not there; a coordinate to leave out of
// a mesh that is not of space, or has tetrahedra; points with fewer coordinates than asked for.
// Equal points are left to judges and to settle_equal_points. `frame`: of the domain that the mesh
// is held against, if it is. Then what formats/mesh_files.hpp says under "What programs write
// otherwise" is done. `threads`: 0: as many as the machine has.
tl::expected<LoadedMesh, std::string> load_mesh(const std::string& path,
                                                const InputOptions& options, unsigned threads = 0,
                                                const std::optional<DomainFrame>& frame = {});

// What is wrong with points that are equal, where they are not to be merged.
std::string equal_points_fault(const LoadedMesh& loaded, const std::vector<Duplicate>& repeated);

// Which points were merged; nothing if none were.
std::optional<std::string> note_of_merging(const LoadedMesh& loaded);

// Merges equal points (oracle/model/mesh.hpp says how), or returns what is wrong with them if
// they are refused; empty if all is well.
std::string settle_equal_points(LoadedMesh& loaded, Duplicates duplicates);

// Points alone, as a mesh without simplices: in arrays, or as exact numbers. Errors: as above, and
// equal points that are refused.
tl::expected<LoadedMesh, std::string> load_point_rows(const std::string& path,
                                                      const InputOptions& options);
struct LoadedPoints {
  std::string name;
  ExactMesh mesh;
  std::vector<std::string> notes = {};      // what may have been meant otherwise
  std::vector<Duplicate> merged = {};       // as LoadedMesh has them
  std::optional<std::string> merging = {};  // a note on them
};
tl::expected<LoadedPoints, std::string> load_points(const std::string& path,
                                                    const InputOptions& options);

}  // namespace circumspect::cli
