#include "command/input/domain_input.hpp"

#include <map>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command/input/breach_text.hpp"
#include "command/options/one_of.hpp"
#include "oracle/formats/domain_files.hpp"

namespace circumspect::cli {
namespace {

// Of breaches that were sought up to one more than `max_breaches`, or all if that is 0.
DomainFault fault_of(std::vector<Breach> breaches, std::size_t max_breaches,
                     formats::DomainFile file) {
  const bool truncated = max_breaches != 0 && breaches.size() > max_breaches;
  if (truncated) breaches.resize(max_breaches);
  std::string message =
      fmt::format("{}: expected a piecewise linear complex, found {}",
                  breach_place(breaches.front(), file), breach_line(breaches.front(), file));
  if (breaches.front().kind == BreachKind::kDuplicateVertex) {
    message += "; --duplicates merge treats them as one";
  }
  if (truncated) {
    message += fmt::format(
        " (and at least {} more; `circumspect inspect --max-errors 0` lists all)", breaches.size());
  } else if (breaches.size() > 1) {
    message += fmt::format(" (and {} more)", breaches.size() - 1);
  }
  return {std::move(message), std::move(breaches), std::move(file), truncated};
}

Domain domain_of(PiecewiseLinearComplex complex, const formats::DomainFile& file) {
  Domain domain{std::move(complex), file.labels, file.first_index, {}};
  for (std::size_t i = 0; i < file.polygon_lines.size(); ++i) {
    domain.polygon_names.push_back(polygon_name(i, file));
  }
  return domain;
}

}  // namespace

void add_domain_kind_option(CLI::App& command, std::optional<DomainKind>& kind) {
  const std::map<std::string, DomainKind> kinds = {{"enclosed", DomainKind::kEnclosed},
                                                   {"hull", DomainKind::kHull}};
  command
      .add_option("--domain-kind", kind,
                  "What the domain fills: 'enclosed', what its polygons (in the plane its "
                  "segments) enclose, or 'hull', its convex hull. The default is 'enclosed' if "
                  "they enclose anything, and 'hull' if there are none. If there are some and they "
                  "enclose nothing, say which you mean: 'enclosed' meshes them alone and fills "
                  "nothing. 'hull' needs points that do not all lie in one plane")
      ->transform(one_of(kinds))
      ->option_text("enclosed|hull");
}

std::string_view word(DomainKind kind) {
  return kind == DomainKind::kEnclosed ? "enclosed" : "hull";
}

tl::expected<LoadedDomain, DomainFault> load_domain(const std::string& path,
                                                    const InputOptions& options,
                                                    std::optional<DomainKind> kind,
                                                    std::size_t max_breaches, Leak leak,
                                                    const DomainWatch& watch) {
  auto read = formats::read_domain(path, options.coordinates);
  if (!read) return tl::unexpected(DomainFault{read.error().to_string()});
  formats::DomainFile file = options.duplicates == Duplicates::kMerge
                                 ? formats::with_duplicates_merged(std::move(*read))
                                 : std::move(*read);
  if (file.input.points.empty()) {
    return tl::unexpected(DomainFault{path + ": expected a domain with points, found none"});
  }
  // One more than is reported tells whether there are more.
  ValidityWatch validity{watch.progress};
  if (watch.on_breach) {
    validity.on_breach = [&](const Breach& breach) { watch.on_breach(breach, file); };
  }
  auto complex = validated(file.input, max_breaches == 0 ? 0 : max_breaches + 1, validity);
  if (!complex) {
    return tl::unexpected(fault_of(std::move(complex.error()), max_breaches, std::move(file)));
  }
  if (watch.on_valid) watch.on_valid(*complex, file);
  Domain domain = domain_of(std::move(*complex), file);
  if (watch.only_validity) return LoadedDomain{path, std::move(domain), std::move(file)};
  auto chosen = choose_kind(domain, kind, leak);
  if (!chosen) return tl::unexpected(DomainFault{path + ": " + chosen.error()});
  for (const std::string& note : chosen->notes) file.notes.push_back(path + ": " + note);
  domain.complex.kind = file.input.kind = chosen->kind;
  return LoadedDomain{path, std::move(domain), std::move(file)};
}

}  // namespace circumspect::cli
