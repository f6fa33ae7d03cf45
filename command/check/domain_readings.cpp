#include "command/check/domain_readings.hpp"

#include <fmt/format.h>

#include "command/input/breach_text.hpp"
#include "oracle/formats/plane.hpp"
#include "oracle/formats/read_domain.hpp"
#include "oracle/judge/within/rounded_polygons.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::cli {

std::optional<HeldAgainst> DomainReadings::held_against(
    tl::expected<LoadedDomain, DomainFault> domain, Output& output) const {
  if (!domain) {
    output.notes(domain.error().file.notes);
    output.error(ExitCode::kInputFault, "domain", asked_.path, domain.error().message);
    return std::nullopt;
  }
  HeldAgainst against{std::move(*domain)};
  LoadedDomain& loaded = against.loaded;
  if (asked_.said.merges_bent() && loaded.domain.complex.ambient_dimension() == 3) {
    const Rational squared = asked_.within->squared(loaded.domain.complex);
    BentDomain bent = with_nearly_coplanar_joined(loaded, *asked_.said.merged_slope, squared);
    loaded.file.notes.push_back(bent.note);
    if (bent.removed_segments > 0) against.bent = std::move(bent);
  }
  output.notes(loaded.file.notes);
  return against;
}

namespace {

// Each polygon of a file that was cut, by the name that the file gives it.
std::vector<std::string> names_of_cut(const formats::DomainFile& file) {
  std::vector<std::string> names;
  for (std::size_t p = 0; p < file.input.polygons.size(); ++p) {
    names.push_back(polygon_name(p, file));
  }
  return names;
}

// The file with other polygons, each of which is one of the file or of one.
formats::DomainFile with_polygons(formats::DomainFile file, const check::CutPolygons& cut) {
  std::vector<std::size_t> lines;
  for (const std::size_t p : cut.cut_of) lines.push_back(file.polygon_lines[p]);
  file.polygon_lines = std::move(lines);
  file.polygon_markers.clear();
  file.input = cut.input;
  return file;
}

}  // namespace

// Corners that were rounded are in one plane no longer. Their polygons are cut into triangles, and
// put together again where nothing demands that.
std::optional<HeldAgainst> DomainReadings::held_if_rounded(const Output& output) const {
  if (!asked_.within || asked_.said.merged_slope || asked_.said.resolves) return std::nullopt;
  const auto file = formats::read_domain(asked_.path, asked_.input.coordinates);
  if (!file || file->dimension != 3) return std::nullopt;
  const Rational squared = asked_.within->squared(file->input.points);
  const auto cut = check::rounded_polygons_cut(file->input, squared);
  if (!cut || cut->cut == 0) return std::nullopt;
  auto loaded = load_domain(with_polygons(*file, *cut), asked_.path, asked_.input, asked_.said,
                            asked_.max_breaches, Leak::kRefused, {.progress = output.progress()});
  if (!loaded) return std::nullopt;
  loaded->listed = cut->listed;
  constexpr long kSteepest = 5;  // degrees, as nearly_coplanar.hpp has it of the plane of all
  BentDomain bent = with_nearly_coplanar_joined(*loaded, kSteepest * slope_of_degree(), squared);
  if (bent.domain.complex.polygons.size() != file->input.polygons.size()) return std::nullopt;
  bent.domain.polygon_names = names_of_cut(*file);
  loaded->file.notes.push_back(fmt::format(
      "{}: {} taken for flat, whose corners are up to a distance of {} off one plane", asked_.path,
      report::counted(cut->cut, "polygon"), report::square_root_rounded_up(cut->squared_height)));
  return HeldAgainst{std::move(*loaded), std::move(bent)};
}

bool DomainReadings::load(Output& output) {
  output.begin("reading " + asked_.path);
  auto domain = load_domain(asked_.path, asked_.input, asked_.said, asked_.max_breaches,
                            Leak::kRefused, {.progress = output.progress()});
  const bool is_uneven = !domain && !domain.error().breaches.empty() &&
                         domain.error().breaches.front().kind == BreachKind::kPolygonNotPlanar;
  if (is_uneven) as_read_ = held_if_rounded(output);
  if (as_read_) {
    output.notes(as_read_->loaded.file.notes);
  } else {
    as_read_ = held_against(std::move(domain), output);
  }
  return as_read_.has_value();
}

const HeldAgainst* DomainReadings::for_mesh(const LoadedMesh* mesh, Output& output) {
  const LoadedDomain& domain = as_read_->loaded;
  const bool fits = mesh == nullptr || !domain.file.flat || mesh->mesh.points() == 0 ||
                    mesh->mesh.dimension() == domain.domain.complex.ambient_dimension();
  if (fits) return &*as_read_;
  if (!in_space_) {
    output.note(fmt::format("{}: no mesh of the plane in which {} lies: both are judged in space",
                            mesh->name, domain.name));
    in_space_ = held_against(
        load_domain(formats::as_it_stands(domain.file), asked_.path, asked_.input, asked_.said,
                    asked_.max_breaches, Leak::kRefused, {.progress = output.progress()}),
        output);
  }
  return in_space_ ? &*in_space_ : nullptr;
}

}  // namespace circumspect::cli
