#include "oracle/formats/read_domain.hpp"

#include <optional>

#include "oracle/formats/bytes/packed.hpp"
#include "oracle/formats/foreign_file.hpp"
#include "oracle/formats/format.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/other_kinds.hpp"
#include "oracle/formats/ply.hpp"

namespace circumspect::formats {

namespace {

// What a mesh or points are, for a message "found …" where a domain was expected.
std::optional<std::string> kind_of_mesh(std::string_view ending) {
  const Format* const format = format_of(ending);
  if (format == nullptr || (!format->has_mesh() && !format->has_points())) return std::nullopt;
  if (!format->has_mesh()) return "points alone (a domain has segments and polygons as well)";
  return "a mesh (the domain is what the program was given that made the mesh)";
}

}  // namespace

bool is_domain_file(const std::string& path) {
  const std::string end = extension_inside(path);
  if (end == ".ply") {  // unless it is a cloud of points
    const Result<Source> source = load_unpacked(path);
    if (!source) return true;
    const Result<PlyFile> file = read_ply_file(*source, NumberReading::kDouble);
    return !file || !file->faces.simplices.empty();
  }
  const Format* const format = format_of(end);
  return end != ".off" && format != nullptr && format->has_domain();
}

Result<DomainFile> read_domain(const std::string& path, NumberReading reading) {
  const Result<Source> source = load_unpacked(path);
  if (!source) return tl::unexpected(source.error());
  const std::string end = extension_inside(path);
  const Format* format = format_of(end, *source);
  const std::optional<std::string> other = other_kind(end);
  const bool has_domain = format != nullptr && format->has_domain();
  if (!has_domain) format = other ? nullptr : told_format(*source, &Format::has_domain);
  if (format != nullptr) return explained(format->read_domain(*source, reading), *source);
  const FormatError error{source->name, 0, "a domain (" + endings_of(&Format::has_domain) + ")",
                          other.value_or(kind_of_mesh(end).value_or("another format"))};
  return tl::unexpected(other ? error : explained(error, *source));
}

}  // namespace circumspect::formats
