#include "command/check/domain_readings.hpp"

#include <fmt/format.h>

#include "oracle/formats/plane.hpp"

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

bool DomainReadings::load(Output& output) {
  output.begin("reading " + asked_.path);
  as_read_ = held_against(load_domain(asked_.path, asked_.input, asked_.said, asked_.max_breaches,
                                      Leak::kRefused, {.progress = output.progress()}),
                          output);
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
