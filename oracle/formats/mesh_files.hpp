// Finds the files of a mesh from the name that a user gives, and reads them: the points of x.1.ele
// are in x.1.node. The extension tells the format or, if there is none, the content does.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/plain_files.hpp"
#include "oracle/formats/point_file.hpp"
#include "oracle/formats/weights.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::formats {

// The end of a file's name from its last '.', in lower case: ".ele"; empty if it has none.
std::string extension(const std::string& path);
// The same of what is packed: ".ele" of x.ele.gz and x.ele.zst; and ".foam" of the folder of a case
// of OpenFOAM. What is read is asked by this.
std::string extension_inside(const std::string& path);

// The file beside another that has this ending instead: x.1.node beside x.1.ele, or x.1.node.gz or
// x.1.node.zst if only that is there.
std::string beside(const std::string& path, std::string_view ending);

// Reads points of any format; "-" is standard input.
Result<RawPoints> read_points(const std::string& path, NumberReading reading);

// A file that has been read already.
struct LoadedFile {
  std::string path;
  Result<Source> source;
};

struct MeshRequest {
  std::string mesh;                        // a file; for .node and .qhull, the simplices beside it
  std::optional<std::string> points = {};  // instead of those beside or inside the mesh
  std::string points_option = "--points";  // what names them, for messages
  NumberReading reading = NumberReading::kDouble;
  bool with_neighbors = false;  // read the .neigh beside an .ele, if there is one
  bool with_faces = false;      // and the .face and the .edge
  // The dimension of the points of the mesh's domain, if there is one: meshes that are written in
  // another form are read as this dimension requires; see below.
  std::optional<std::size_t> domain_dimension = {};
  // For a planar domain with points in space: the coordinate that was left out. A mesh at another
  // height is compared with the domain in space.
  std::optional<Rational> domain_height = {};
  bool keeps_coordinates = false;            // no third coordinate is left out (plane.hpp)
  std::optional<PointFile> own_points = {};  // instead of any file's
  Weights weights = Weights::kNone;
  // Only simplices with one of these labels, if there are any: in Medit's files the reference, in
  // Gmsh's the (first) physical group, in .ele the first attribute. See below.
  std::vector<Vertex> kept_labels = {};
  std::vector<LoadedFile> loaded = {};  // used instead of the files' contents; see load_streams
};

// May the mesh be planar? And does it have the dimension of the domain, or of the space of a flat
// one?
bool may_be_of_plane(const MeshRequest& request);
bool is_of_domain_dimension(const MeshRequest& request, const Mesh& mesh);

// Reads into `loaded` pipes and standard input, which can be read only once, and the files whose
// names do not tell their format or are packed. Fails if mesh and points are both to come from
// standard input.
void load_streams(MeshRequest& request);

// The loaded text of a file; null if it was not loaded.
const Result<Source>* find_loaded(const MeshRequest& request, const std::string& path);

// The usual ending of files of this format: by the ending of the path, if it is known, else by the
// content of the text; empty if the format cannot be known. `text` may be null. A list of simplices
// alone counts as a mesh only `if_points` are known.
std::string_view format_of_points(const std::string& path, const Source* text);
std::string_view format_of_mesh(const std::string& path, const Source* text, bool if_points);

// A mesh, and where it came from.
struct MeshFile {
  // Vertices are counted from 0, by subtracting the index of the first point (exact_mesh.hpp); one
  // that names no point still names none. No simplex has more vertices than the points have
  // coordinates, plus one. Faces are, if they were asked for, those of .face and .edge files, of
  // Medit's and of JSON, without those that have as many vertices as a simplex of full dimension.
  Mesh mesh = {};
  // The markers of the triangles of a .face file, except 0, by their vertices counted from 0,
  // ascending. None if points of another dimension were fitted to a domain.
  std::map<Simplex, Vertex> face_markers = {};
  std::string points_name = {};  // of the files, for messages
  std::string mesh_name = {};
  bool is_surface = false;  // of a format of surfaces alone, and its points are not in a plane
  std::optional<Rational> height = {};  // the third coordinate of all points, which was left out
  std::vector<std::string> notes = {};  // what was read differently from the files, a line each
};

// Reads a mesh and its points: files as programs write them at the speed of memory
// (read_plain_mesh), all others by their own readers, which have the messages. `threads`: 0: as
// many as the machine has; the answer is the same for any number. Errors: a file that is missing or
// malformed; elements of second order, faces that are not triangles and facets that are not
// simplices, none of which can be judged; neighbours of other simplices than these; missing weights
// where they are demanded.
Result<MeshFile> read_mesh(MeshRequest request, unsigned threads = 0);

// The same, but always by the readers that have the messages.
Result<MeshFile> read_mesh_line_by_line(const MeshRequest& request);

// Meshes that programs write in another form than the domain: dangling triangles and edges as if
// they were the simplices. (plane.hpp is about planar points with a third coordinate.)

// A mesh without simplices of full dimension can only mesh what dangles in a domain: if all its
// simplices have the same number of vertices, at least 2 and fewer than one of full dimension, they
// are turned into listed faces, which is noted; otherwise nothing is done. Requires: no neighbours.
void take_for_faces(MeshFile& file);

// Elements of second order are judged by their corners: leaves out the points between these
// (curved_elements.hpp), given by the user's indices; all others keep theirs. Requires: no simplex
// and no face has one.
void leave_out_nodes_between(const std::vector<Vertex>& indices, Mesh& mesh);

// For a mesh of more than the domain, for example of the convex hull with label 0 outside: keeps
// the simplices with one of these labels. Faces and points that belong only to other simplices are
// left out as well; that is noted. Errors: simplices have no labels, or none of them has one of
// these. Requires: as many labels as simplices, or none; no neighbours.
Status keep_labelled(const std::vector<Vertex>& kept, const std::vector<Vertex>& labels,
                     MeshFile& file);

// Large meshes of doubles, read directly into their arrays: .ele or .npy with points in .node or
// .npy. Anything that mesh_files.hpp would read differently, refuse or take from elsewhere gets no
// answer here and is left to it; an answer is always the same mesh.

// As read_mesh. Nothing for numbers that are read literally, for pipes that load_streams has not
// loaded, and for every file that is faulty or not of the plain form.
std::optional<MeshFile> read_plain_mesh(const MeshRequest& request,
                                        const PlainReading& reading = {});

}  // namespace circumspect::formats
