// From a file to a domain that meshes can be held against.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "command/input/enclosure.hpp"
#include "command/input/input.hpp"
#include "oracle/formats/domain_file.hpp"
#include "oracle/model/domain.hpp"
#include "reference/kernel/piecewise_linear/breach.hpp"
#include "reference/kernel/piecewise_linear/validity.hpp"

namespace circumspect::cli {

// A domain, and the file that it came from: lines and notes.
struct LoadedDomain {
  std::string name;
  Domain domain;
  formats::DomainFile file;
};

// What is wrong with an input: one line for people, and the breaches of Definition 4.3, if it could
// be read. `file` has the points and lines that breaches are about.
struct DomainFault {
  std::string message;
  std::vector<Breach> breaches = {};
  formats::DomainFile file = {};
  bool truncated = false;  // are there more breaches?
};

// Who waits for a domain: is told how far its validation has come, of each breach as soon as it is found
// (then only the first kBreachLimit are in the DomainFault), and that it is valid before its kind is chosen.
struct DomainWatch {
  Progress progress = {};
  std::function<void(const Breach&, const formats::DomainFile&)> on_breach = {};
  std::function<void(const PiecewiseLinearComplex&, const formats::DomainFile&)> on_valid = {};
  bool only_validity = false;  // the kind stays as it is, without notes
};

// Adds --domain-kind enclosed|hull. Without it, `choose_kind` decides.
void add_domain_kind_option(CLI::App& command, std::optional<DomainKind>& kind);

// Errors: a malformed file; duplicates, unless they are merged; any other breach, up to
// `max_breaches` of them (0: all); no kind that `choose_kind` can give it. The notes of the file have
// those about the kind too.
tl::expected<LoadedDomain, DomainFault> load_domain(const std::string& path,
                                                    const InputOptions& options,
                                                    std::optional<DomainKind> kind,
                                                    std::size_t max_breaches = kBreachLimit,
                                                    Leak leak = Leak::kRefused,
                                                    const DomainWatch& watch = {});

std::string_view word(DomainKind kind);

}  // namespace circumspect::cli
