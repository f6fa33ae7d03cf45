#include "oracle/formats/mesh_files.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/bytes/packed.hpp"
#include "oracle/formats/curved_elements.hpp"
#include "oracle/formats/foreign_file.hpp"
#include "oracle/formats/format.hpp"
#include "oracle/formats/npy.hpp"
#include "oracle/formats/other_kinds.hpp"
#include "oracle/formats/plane.hpp"
#include "oracle/formats/poly_mesh.hpp"
#include "oracle/formats/tetgen.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "platform/files.hpp"

namespace circumspect::formats {

namespace {

// The file of the simplices; for a file of points, the one beside it.
std::string file_of_simplices(const std::string& path) {
  const Format* const format = format_of(extension_inside(path));
  if (format == nullptr || format->simplices_beside.empty()) return path;
  return beside(path, format->simplices_beside);
}

// The text of a file; of a folder the name alone.
Result<Source> load_named(const std::string& path) {
  if (extension_inside(path) == ".foam") return Source{path, ""};
  return load_unpacked(path);
}

// The error for a file that cannot have points.
tl::unexpected<FormatError> no_points(const Source& source) {
  Lines lines(source);
  lines.next();
  return lines.fail_at(
      0, "a file of points (" + endings_of(&Format::has_points) + ") or a domain (.poly, .smesh)");
}

Result<RawPoints> points_of(const Result<Source>& source, const std::string& path,
                            NumberReading reading) {
  if (!source) return tl::unexpected(source.error());
  const Format* format = format_of(extension_inside(path), *source);
  const std::string expected = "a file of points (" + endings_of(&Format::has_points) + ")";
  if (const auto other = other_kind(extension_inside(path))) {
    return tl::unexpected(FormatError{source->name, 0, expected, *other});
  }
  if (format == nullptr) format = told_format(*source, &Format::has_points);
  if (format == nullptr) return explained<RawPoints>(no_points(*source), *source);
  if (format->has_points()) return explained(format->read_points(*source, reading), *source);
  return tl::unexpected(FormatError{source->name, 0, expected,
                                    "a " + std::string(format->endings.front()) + " file"});
}

// The loaded text of a file, or the file itself.
Result<Source> source_of(const MeshRequest& request, const std::string& path) {
  const Result<Source>* const loaded = find_loaded(request, path);
  return loaded != nullptr ? *loaded : load_named(path);
}

// Reads a file that goes with another, and says so if it is missing.
Result<RawPoints> read_points_beside(const std::string& mesh, std::string_view points_beside,
                                     const MeshRequest& request) {
  if (points_beside.empty()) {
    return tl::unexpected(FormatError{
        mesh, 0, request.points_option + " FILE, with the points of these simplices", "none"});
  }
  const std::string path = beside(mesh, points_beside);
  if (exists(path)) return points_of(source_of(request, path), path, request.reading);
  return tl::unexpected(
      FormatError{path, 0, "a file with the points of " + mesh,
                  "no file of that name (" + request.points_option + " names another)"});
}

Result<Source> load_mesh(const MeshRequest& request, const std::string& path) {
  if (path == request.mesh || exists(path)) return source_of(request, path);
  return tl::unexpected(
      FormatError{path, 0, "a file with the simplices of " + request.mesh, "no file of that name"});
}

// A list with more vertices than any simplex of this dimension is not a simplex, and not meant as
// one. Fewer vertices, or differing numbers of them, are faults of the mesh, and left to the judge.
Status check_sizes(const SimplexFile& file, std::size_t dimension, const std::string& name) {
  const std::size_t most = dimension + 1;
  if (file.simplices.columns() > 0 && file.simplices.columns() <= most) return {};
  for (std::size_t i = 0; i < file.simplices.size(); ++i) {
    if (file.simplices.size_of(i) <= most) continue;
    return tl::unexpected(FormatError{
        name, file.lines[i],
        "at most " + std::to_string(most) + " vertices of a simplex in dimension " +
            std::to_string(dimension),
        std::to_string(file.simplices.size_of(i)) +
            " (elements of second order and facets that are not simplices are not judged)"});
  }
  return {};
}

Status read_neighbors(const std::string& path, const ListedSimplices& simplices, Mesh& mesh) {
  const std::string neigh = beside(path, ".neigh");
  if (extension_inside(path) != ".ele" || !exists(neigh)) return {};
  const Result<Source> source = load_unpacked(neigh);
  if (!source) return tl::unexpected(source.error());
  Result<NeighborFile> file = read_neigh(*source, simplices);
  if (!file) return tl::unexpected(file.error());
  mesh.neighbors.emplace(Neighbors{std::move(file->neighbors), file->first_index});
  return {};
}

// The triangles and edges beside an .ele file, if there are such files.
Status read_faces(const std::string& name, MeshFile& read) {
  if (extension_inside(name) != ".ele") return {};
  for (const auto& [ending, vertices] : {std::pair{".face", 3}, std::pair{".edge", 2}}) {
    const std::string path = beside(name, ending);
    if (!exists(path)) continue;
    const Result<Source> source = load_unpacked(path);
    if (!source) return tl::unexpected(source.error());
    const Result<SimplexFile> file = read_face(*source, static_cast<std::size_t>(vertices));
    if (!file) return tl::unexpected(file.error());
    std::vector<Simplex>& faces = read.mesh.faces;
    for (Simplex face : file->simplices) faces.push_back(std::move(face));
    add_markers(*file, read.mesh.first_index, read.face_markers);
  }
  return {};
}

void count_from_zero(std::vector<Simplex>& simplices, Vertex first_index) {
  for (Simplex& simplex : simplices) {
    for (Vertex& v : simplex) v = place_of_index(v, first_index);
  }
}

// From here on, the arrays of an archive are ordinary files, which are read at the speed of memory.
Status unpack_archive(MeshRequest& request) {
  const Result<Source>* const loaded = find_loaded(request, request.mesh);
  const bool is_archive = loaded == nullptr ? extension_inside(request.mesh) == ".npz"
                                            : loaded->has_value() && is_npz((*loaded)->text);
  if (!is_archive) return {};
  const Result<Source> archive = loaded == nullptr ? load_unpacked(request.mesh) : *loaded;
  if (!archive) return tl::unexpected(archive.error());
  const auto unpack = [&](std::string_view name) {
    Result<Source> array = array_of_npz(*archive, name);
    // Without the names that numpy.savez gives, it is an archive of other files.
    if (extension_inside(archive->name) != ".npz") array = explained(std::move(array), *archive);
    if (!array) return Result<std::string>(tl::unexpected(array.error()));
    const std::string path = array->name;
    request.loaded.push_back({path, std::move(array)});
    return Result<std::string>(path);
  };
  const Result<std::string> simplices = unpack("simplices");
  if (!simplices) return tl::unexpected(simplices.error());
  request.mesh = *simplices;
  if (request.points || request.own_points) return {};
  const Result<std::string> points = unpack("points");
  if (!points) return tl::unexpected(points.error());
  request.points = *points;
  return {};
}

// The simplices, and the points if they are in the same file; `format` tells which it is.
Result<Contents> read_contents(const MeshRequest& request, const std::string& path,
                               std::string& name, const Format*& format) {
  const Result<Source> source = load_mesh(request, path);
  if (!source) return tl::unexpected(source.error());
  name = source->name;
  format = format_of(extension_inside(path), *source);
  const std::string expected = "a mesh (" + endings_of(&Format::has_mesh) +
                               "; .ele goes with .node, .qhull-i with .qhull, .npy with " +
                               request.points_option + ")";
  if (const auto other = other_kind(extension_inside(path))) {
    return tl::unexpected(FormatError{name, 0, expected, *other});
  }
  const bool has_points = request.points || request.own_points;
  if (format == nullptr) format = told_format(*source, &Format::has_mesh, has_points);
  if (format != nullptr && format->has_mesh()) {
    return explained(format->read_mesh(*source, request.reading), *source);
  }
  const std::string_view first = Beginning(*source).first_token;
  return tl::unexpected(
      explained(FormatError{name, 1, expected, first.empty() ? "nothing" : quote(first)}, *source));
}

Result<RawPoints> points_of_mesh(const MeshRequest& request, const std::string& path,
                                 const Format& format, Contents& contents) {
  if (request.own_points) return RawPoints{*request.own_points};
  if (request.points) {
    return points_of(source_of(request, *request.points), *request.points, request.reading);
  }
  if (contents.points) return std::move(*contents.points);
  return read_points_beside(path, format.points_beside, request);
}

}  // namespace

bool may_be_of_plane(const MeshRequest& request) {
  return !request.keeps_coordinates && request.domain_dimension != 3;
}

bool is_of_domain_dimension(const MeshRequest& request, const Mesh& mesh) {
  return request.domain_dimension == mesh.dimension() ||
         (request.domain_height && mesh.dimension() == 3);
}

std::string extension(const std::string& path) {
  const std::size_t slash = path.find_last_of(platform::kSeparators);
  const std::size_t start = slash == std::string::npos ? 0 : slash + 1;
  const std::size_t dot = path.rfind('.');
  // A dot at the beginning of a name marks a hidden file, and does not begin an extension.
  if (dot == std::string::npos || dot <= start) return "";
  std::string end = path.substr(dot);
  for (char& c : end) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return end;
}

std::string extension_inside(const std::string& path) {
  if (is_folder(path) && poly_mesh_folder(path)) return ".foam";
  return extension(std::string(name_inside(path)));
}

std::string beside(const std::string& path, std::string_view ending) {
  const std::string inside(name_inside(path));
  std::string other = inside.substr(0, inside.size() - extension(inside).size());
  other += ending;
  return packed_or_not(other);
}

const Result<Source>* find_loaded(const MeshRequest& request, const std::string& path) {
  const auto found = std::find_if(request.loaded.begin(), request.loaded.end(),
                                  [&path](const LoadedFile& file) { return file.path == path; });
  return found == request.loaded.end() ? nullptr : &found->source;
}

void load_streams(MeshRequest& request) {
  if (request.mesh == "-" && request.points == "-") return;
  const auto load_stream = [&request](const std::string& path) {
    const bool is_plain = name_inside(path) == path && format_of(extension(path)) != nullptr;
    if (is_plain && (!exists(path) || is_regular(path))) return;
    request.loaded.push_back({path, load_named(path)});
  };
  const std::string mesh = file_of_simplices(request.mesh);
  load_stream(mesh);
  // If the mesh is missing, say so before waiting for its points.
  const bool is_missing = mesh != "-" && !exists(mesh);
  if (is_missing) return;
  const Format* const format = format_of(extension_inside(mesh));
  const bool has_points_beside = format != nullptr && !format->points_beside.empty();
  if (request.points) {
    load_stream(*request.points);
  } else if (has_points_beside) {
    load_stream(beside(mesh, format->points_beside));
  }
}

std::string_view format_of_points(const std::string& path, const Source* text) {
  const Format* format = format_of(extension_inside(path));
  if (format == nullptr && text != nullptr) format = told_format(*text, &Format::has_points);
  return format == nullptr ? "" : format->endings.front();
}

std::string_view format_of_mesh(const std::string& path, const Source* text, bool if_points) {
  const Format* format = format_of(extension_inside(path));
  if (format == nullptr && text != nullptr) {
    format = told_format(*text, &Format::has_mesh, if_points);
  }
  return format == nullptr ? "" : format->endings.front();
}

Result<RawPoints> read_points(const std::string& path, NumberReading reading) {
  return points_of(load_named(path), path, reading);
}

Result<MeshFile> read_mesh_line_by_line(const MeshRequest& request) {
  const std::string path = file_of_simplices(request.mesh);
  MeshFile file;
  const Format* format = nullptr;
  Result<Contents> contents = read_contents(request, path, file.mesh_name, format);
  if (!contents) return tl::unexpected(contents.error());
  Result<RawPoints> points = points_of_mesh(request, path, *format, *contents);
  if (!points) return tl::unexpected(points.error());
  Mesh& mesh = file.mesh;
  if (format->endings.front() == ".ele") {
    if (auto curved = take_corners(contents->simplices, points->points, file.mesh_name)) {
      contents->nodes_between = std::move(curved->nodes);
      contents->notes.push_back(std::move(curved->note));
    }
  }
  Result<std::vector<Rational>> weights = weights_of(*points, request.weights);
  mesh.coordinates = std::move(points->points.points).as_numbers(points->points.dimension);
  mesh.first_index = points->points.first_index;
  file.points_name = points->name;
  file.notes = std::move(contents->notes);
  SimplexFile& simplices = contents->simplices;
  if (may_be_of_plane(request) && !needs_space(simplices, contents->faces)) {
    leave_out_height(file, request.domain_height);
  }
  file.is_surface = format->is_surface && mesh.dimension() == 3;
  if (Status sizes = check_sizes(simplices, mesh.dimension(), file.mesh_name); !sizes) {
    return tl::unexpected(sizes.error());
  }
  const ListedSimplices listed{simplices.simplices.size(), simplices.vertices_per_simplex, path};
  simplices.simplices.replace_each(
      [first = mesh.first_index](Vertex index) { return place_of_index(index, first); });
  mesh.simplices = std::move(simplices.simplices).as_index_lists();
  if (request.with_faces) {
    mesh.faces = std::move(contents->faces);
    if (Status read = read_faces(path, file); !read) return tl::unexpected(read.error());
    count_from_zero(mesh.faces, mesh.first_index);
  }
  leave_out_nodes_between(contents->nodes_between, mesh);
  if (!request.kept_labels.empty()) {
    if (Status kept = keep_labelled(request.kept_labels, simplices.labels.values(), file); !kept) {
      return tl::unexpected(kept.error());
    }
  }
  // Neighbours refer to the simplices as the file has them.
  if (request.with_neighbors) {
    if (Status read = read_neighbors(path, listed, mesh); !read) {
      return tl::unexpected(read.error());
    }
  } else if (is_of_domain_dimension(request, mesh)) {
    take_for_faces(file);
  }
  if (!weights) return tl::unexpected(weights.error());
  if (!weights->empty()) mesh.weights = numbers_of(*weights);
  return file;
}

Result<MeshFile> read_mesh(MeshRequest request, unsigned threads) {
  if (request.mesh == "-" && request.points == "-") {
    return tl::unexpected(FormatError{std::string(kStandardInputName), 0,
                                      "the mesh or its points on standard input", "both"});
  }
  load_streams(request);
  if (Status unpacked = unpack_archive(request); !unpacked) {
    return tl::unexpected(unpacked.error());
  }
  std::optional<MeshFile> plain;
  if (request.kept_labels.empty()) plain = read_plain_mesh(request, {threads});
  Result<MeshFile> file = plain ? std::move(*plain) : read_mesh_line_by_line(request);
  if (!file) return file;
  // A face with that many vertices is a simplex of full dimension that is listed among the faces.
  std::erase_if(file->mesh.faces,
                [d = file->mesh.dimension()](const Simplex& face) { return face.size() > d; });
  return file;
}

}  // namespace circumspect::formats
