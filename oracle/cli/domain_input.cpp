#include "oracle/cli/domain_input.hpp"

#include <map>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "oracle/cli/breach_text.hpp"
#include "oracle/formats/domain_files.hpp"
#include "reference/piecewise_linear/regions.hpp"
#include "reference/piecewise_linear/validity.hpp"

namespace circumspect::cli {
namespace {

// Are there regions beside the unbounded one?
bool encloses_anything(const PiecewiseLinearComplex& complex) {
  PiecewiseLinearComplex enclosed = complex;
  enclosed.kind = DomainKind::kEnclosed;
  return Regions(enclosed).size() > 1;
}

DomainFault fault_of(std::vector<Breach> breaches, formats::DomainFile file) {
  std::string message =
      fmt::format("{}: expected a piecewise linear complex, found {}",
                  breach_place(breaches.front(), file), breach_line(breaches.front(), file));
  if (breaches.front().kind == BreachKind::kDuplicateVertex) {
    message += "; --duplicates merge treats them as one";
  }
  if (breaches.size() > 1) message += fmt::format(" (and {} more)", breaches.size() - 1);
  return {std::move(message), std::move(breaches), std::move(file)};
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
                  "What the domain fills: what its polygons enclose (default, if they enclose "
                  "anything) or its convex hull")
      ->transform(CLI::CheckedTransformer(kinds, CLI::ignore_case).description(""))
      ->option_text("enclosed|hull");
}

std::string_view word(DomainKind kind) {
  return kind == DomainKind::kEnclosed ? "enclosed" : "hull";
}

tl::expected<LoadedDomain, DomainFault> load_domain(const std::string& path,
                                                    const InputOptions& options,
                                                    std::optional<DomainKind> kind) {
  auto read = formats::read_domain(path, options.coordinates);
  if (!read) return tl::unexpected(DomainFault{read.error().to_string()});
  formats::DomainFile file = options.duplicates == Duplicates::kMerge
                                 ? formats::with_duplicates_merged(std::move(*read))
                                 : std::move(*read);
  if (file.input.points.empty()) {
    return tl::unexpected(DomainFault{path + ": expected a domain with points, found none"});
  }
  auto complex = validated(file.input);
  if (!complex) return tl::unexpected(fault_of(std::move(complex.error()), std::move(file)));
  const bool encloses = kind != DomainKind::kHull && encloses_anything(*complex);
  if (kind == DomainKind::kEnclosed && !encloses) {
    return tl::unexpected(
        DomainFault{path + ": expected a domain that encloses something (--domain-kind hull takes "
                           "the convex hull), found one that encloses nothing"});
  }
  complex->kind = kind.value_or(encloses ? DomainKind::kEnclosed : DomainKind::kHull);
  file.input.kind = complex->kind;
  Domain domain = domain_of(std::move(*complex), file);
  return LoadedDomain{path, std::move(domain), std::move(file)};
}

}  // namespace circumspect::cli
