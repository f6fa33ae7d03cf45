#include "oracle/formats/domain_files.hpp"

#include <algorithm>
#include <array>

#include "oracle/formats/gmsh.hpp"
#include "oracle/formats/lines.hpp"
#include "oracle/formats/medit.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/node.hpp"
#include "oracle/formats/obj.hpp"
#include "oracle/formats/off.hpp"
#include "oracle/formats/other_kinds.hpp"
#include "oracle/formats/ply.hpp"
#include "oracle/formats/poly.hpp"
#include "oracle/formats/source.hpp"
#include "oracle/formats/stl.hpp"
#include "oracle/formats/vtk.hpp"
#include "oracle/formats/vtu.hpp"

namespace circumspect::formats {
namespace {

// The points of x.1.poly may be in x.1.node.
PointsElsewhere points_beside(const Source& source, NumberReading reading, std::string& name) {
  return [&source, reading, &name]() -> Result<PointFile> {
    const std::string& poly = source.name;
    name = poly.substr(0, poly.size() - extension(poly).size()) + ".node";
    if (!exists(name)) {
      return tl::unexpected(FormatError{name, 0, "a file with the points of " + poly,
                                        "no file of that name, and no points in " + poly});
    }
    const Result<Source> points = load(name);
    if (!points) return tl::unexpected(points.error());
    return read_node(*points, reading);
  };
}

using Reader = Result<DomainFile> (*)(const Source&, NumberReading, const PointsElsewhere&);

Result<DomainFile> with_points(Reader read, const Source& source, NumberReading reading) {
  std::string points_name;
  Result<DomainFile> file = read(source, reading, points_beside(source, reading, points_name));
  if (file) file->points_name = std::move(points_name);
  return file;
}

Result<DomainFile> domain_of_poly(const Source& source, NumberReading reading) {
  return with_points(read_poly, source, reading);
}

Result<DomainFile> domain_of_smesh(const Source& source, NumberReading reading) {
  return with_points(read_smesh, source, reading);
}

Result<DomainFile> domain_of_off(const Source& source, NumberReading reading) {
  Result<OffFile> off = read_off(source, reading);
  if (!off) return tl::unexpected(off.error());
  DomainFile file;
  file.name = source.name;
  Status status = take_points(file, std::move(off->points), 0);
  if (status) status = add_faces(file, off->faces);
  if (!status) return tl::unexpected(status.error());
  return file;
}

Result<DomainFile> domain_of_medit(const Source& source, NumberReading reading) {
  const Result<ElementFile> medit = read_medit(source, reading);
  if (!medit) return tl::unexpected(medit.error());
  return domain_of(*medit, source.name);
}

// Formats that know points of space alone.
template <Result<ElementFile> (*read)(const Source&, NumberReading)>
Result<DomainFile> domain_of_elements(const Source& source, NumberReading reading) {
  Result<ElementFile> file = read(source, reading);
  if (!file) return tl::unexpected(file.error());
  take_for_plane(*file, source.name);
  return domain_of(*file, source.name);
}

struct DomainFormat {
  std::string_view extension;
  Result<DomainFile> (*read)(const Source&, NumberReading);
};

constexpr std::array kDomainFormats = {
    DomainFormat{".poly", domain_of_poly},
    DomainFormat{".smesh", domain_of_smesh},
    DomainFormat{".off", domain_of_off},
    DomainFormat{".stl", read_stl},
    DomainFormat{".ply", read_ply},
    DomainFormat{".obj", domain_of_elements<read_obj>},
    DomainFormat{".mesh", domain_of_medit},
    DomainFormat{".msh", domain_of_elements<read_gmsh>},
    DomainFormat{".vtk", domain_of_elements<read_vtk>},
    DomainFormat{".vtu", domain_of_elements<read_vtu>},
    DomainFormat{".vtp", domain_of_elements<read_vtu>},
};

const DomainFormat* domain_format_of(std::string_view extension) {
  const auto* const found = std::find_if(
      kDomainFormats.begin(), kDomainFormats.end(),
      [extension](const DomainFormat& format) { return format.extension == extension; });
  return found == kDomainFormats.end() ? nullptr : found;
}

// The format of a file whose name does not say it; null if what it holds does not, either.
const DomainFormat* sniff(const Source& source) {
  if (is_vtk(source.text)) return domain_format_of(".vtk");
  if (is_vtu(source.text)) return domain_format_of(".vtu");
  Lines lines(source);
  if (!lines.next()) return nullptr;
  const std::string_view first = lines.tokens()[0];
  if (is_off_keyword(first)) return domain_format_of(".off");
  if (is_medit_keyword(first)) return domain_format_of(".mesh");
  if (is_gmsh_keyword(first)) return domain_format_of(".msh");
  if (first == "ply") return domain_format_of(".ply");
  if (is_obj_keyword(first)) return domain_format_of(".obj");
  return first == "solid" ? domain_format_of(".stl") : nullptr;
}

}  // namespace

bool is_domain_file(const std::string& path) {
  const std::string end = extension(path);
  if (end == ".ply") {  // unless it is a cloud of points
    const Result<Source> source = load(path);
    if (!source) return true;
    const Result<PlyFile> file = read_ply_file(*source, NumberReading::kDouble);
    return !file || !file->faces.simplices.empty();
  }
  return end != ".off" && domain_format_of(end) != nullptr;
}

Result<DomainFile> read_domain(const std::string& path, NumberReading reading) {
  const Result<Source> source = load(path);
  if (!source) return tl::unexpected(source.error());
  const std::string end = extension(path);
  const DomainFormat* format = domain_format_of(end);
  const std::optional<std::string> other = other_kind(end);
  if (format == nullptr && !other) format = sniff(*source);
  if (format != nullptr) return format->read(*source, reading);
  std::string kinds;
  for (const DomainFormat& one : kDomainFormats) {
    kinds += (kinds.empty() ? "" : ", ") + std::string(one.extension);
  }
  return tl::unexpected(
      FormatError{source->name, 0, "a domain (" + kinds + ")", other.value_or("another format")});
}

}  // namespace circumspect::formats
