// Finds the files of a mesh from the name that a user gives, and reads them: the points of x.1.ele are in x.1.node.
// The extension tells the format, or, if there is none, the content.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/exact/number.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/plain_files.hpp"
#include "oracle/formats/point_file.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::formats {

// ---- Weights ----
// Points as files hold them, and which of their numbers are weights.

struct RawPoints {
  PointFile points;
  std::vector<Rational> weights = {};  // empty, or one a point
  std::string name = {};               // of the file, for messages
};

// Which weights the points of a file have.
enum class Weights {
  kNone,      // none, whatever there is
  kListed,    // what the file calls so: the key "weights" of JSON
  kDemanded,  // these, or the first attributes of .node, as TetGen's option -w has it; it is an error
              // if there are none
};

// One weight a point, or none at all.
Result<std::vector<Rational>> weights_of(RawPoints& points, Weights which);

// ---- Mesh files ----

// The end of a file's name from its last '.', in lower case: ".ele"; empty if it has none.
std::string extension(const std::string& path);

// Reads points of any format; "-" is standard input.
Result<RawPoints> read_points(const std::string& path, NumberReading reading);

// A file that has been read already.
struct LoadedFile {
  std::string path;
  Result<Source> source;
};

struct MeshRequest {
  std::string mesh;                        // a file; of .node and .qhull, the simplices beside it
  std::optional<std::string> points = {};  // instead of those beside or inside the mesh
  std::string points_option = "--points";  // what names them, for messages
  NumberReading reading = NumberReading::kDouble;
  bool with_neighbors = false;  // read the .neigh beside an .ele, if there is one
  bool with_faces = false;      // and the .face and the .edge
  // Of the points of the domain that the mesh is held against, if it is: what says the same in other
  // words is read as the domain's dimension wants it; see below.
  std::optional<std::size_t> domain_dimension = {};
  // Of a domain in the plane that has points in space: what was left out of them. A mesh of another
  // height is held against the domain in space.
  std::optional<Rational> domain_height = {};
  bool keeps_coordinates = false;            // no third coordinate is left out (plane.hpp)
  std::optional<PointFile> own_points = {};  // instead of any file's
  Weights weights = Weights::kNone;
  // Only simplices with one of these labels, if there are any: in Medit's files the reference, in Gmsh's the
  // (first) physical group, in .ele the first attribute. See below.
  std::vector<Vertex> kept_labels = {};
  std::vector<LoadedFile> loaded = {};  // taken for what the files hold; see load_streams
};

// Does nobody say that the mesh is one of space? And is it of the dimension of the domain, or of
// the space of a flat one?
bool may_be_of_plane(const MeshRequest& request);
bool is_of_domain_dimension(const MeshRequest& request, const Mesh& mesh);

// Reads into `loaded` what can be read but once, pipes and standard input, and the files whose names do
// not say their format. Nothing if mesh and points are both to come from standard input.
void load_streams(MeshRequest& request);

// What has been loaded of a file; null if it has not.
const Result<Source>* find_loaded(const MeshRequest& request, const std::string& path);

// The extension that files of this format have: that of the path, if it is one, else by what the text
// holds; empty if that cannot be known. `text` may be null. A mesh of simplices alone is only taken for
// one `if_points` are known.
std::string_view format_of_points(const std::string& path, const Source* text);
std::string_view format_of_mesh(const std::string& path, const Source* text, bool if_points);

// A mesh, and where it came from.
struct MeshFile {
  // Vertices are counted from 0, by taking the index of the first point from each (exact_mesh.hpp);
  // one that names no point still names none. No simplex has more vertices than the points have
  // coordinates, plus one. Faces are, if they were asked for, those of .face and .edge files, of Medit's
  // and of JSON, without those that have as many vertices as a simplex of full dimension.
  Mesh mesh = {};
  // Of the triangles of a .face file, by their vertices counted from 0, ascending; but not 0. None where points
  // of another dimension were fitted to a domain.
  std::map<Simplex, Vertex> face_markers = {};
  std::string points_name = {};  // of the files, for messages
  std::string mesh_name = {};
  std::optional<Rational> height = {};  // the third coordinate of all points, which was left out
  std::vector<std::string> notes = {};  // what was read otherwise than it stands there, a line each
};

// Reads a mesh and its points: files as programs write them at the speed of memory (read_plain_mesh), all
// others by their own readers, which have the messages. `threads`: 0: as many as the machine has; the
// answer is the same for any number.
// Errors: a file that is missing or malformed; elements of second order, faces that are not
// triangles and facets that are no simplices, none of which can be judged; neighbours of other
// simplices than these; no weights where they are demanded.
Result<MeshFile> read_mesh(MeshRequest request, unsigned threads = 0);

// The same, all by the readers that have the messages.
Result<MeshFile> read_mesh_line_by_line(const MeshRequest& request);

// ---- What programs write otherwise ----
// What programs write otherwise than the domain that their mesh is of: dangling triangles and edges
// as if they were all there is. (Points of the plane with a third coordinate: plane.hpp.)

// A mesh without simplices of full dimension can only be of what dangles in a domain: takes its
// simplices, if all have as many vertices, 2 at least and fewer than one of full dimension, for the
// faces that they are, and notes that; else nothing. Requires: no neighbours.
void take_for_faces(MeshFile& file);

// A mesh of more than the domain, as where a program meshes the convex hull and labels what is outside 0:
// keeps the simplices with one of these labels. Faces of the others alone are left out as well, and points
// of these alone; that is noted. Errors: simplices have no labels, or none of them has one of these.
// Requires: as many labels as simplices, or none; no neighbours.
Status keep_labelled(const std::vector<Vertex>& kept, const std::vector<Vertex>& labels,
                     MeshFile& file);

// ---- Large meshes of doubles ----
// Large meshes of doubles, read where they are to lie: .ele or .npy with points in .node or .npy. What
// mesh_files.hpp would read otherwise, refuse or take from elsewhere has no answer here and is left to
// it; where there is an answer, it is the same mesh.

// As read_mesh. None for numbers that are taken at their word, for pipes that load_streams has not loaded,
// and for every file that is not of the plain form or at fault.
std::optional<MeshFile> read_plain_mesh(const MeshRequest& request,
                                        const PlainReading& reading = {});

}  // namespace circumspect::formats
