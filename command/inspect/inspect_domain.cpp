#include "command/inspect/inspect_domain.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "command/input/breach_text.hpp"
#include "command/input/labels.hpp"
#include "command/inspect/domain_facts.hpp"
#include "command/inspect/refutation_files.hpp"
#include "command/options/whole_number.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/report/wording.hpp"

namespace circumspect::cli {
namespace {

using constrained::SegmentProtection;

std::string_view status_word(const SegmentProtection& protection) {
  switch (protection.status.delaunayhood) {
    case delaunay::Delaunayhood::kStronglyDelaunay:
      return "strongly-delaunay";
    case delaunay::Delaunayhood::kDelaunay:
      return "delaunay";
    case delaunay::Delaunayhood::kNotDelaunay:
      return "not-delaunay";
  }
  return "";
}

bool is_strong(const SegmentProtection& protection) {
  return protection.status.delaunayhood == delaunay::Delaunayhood::kStronglyDelaunay;
}

std::string segment_line(const Domain& domain, const SegmentProtection& protection) {
  std::string line =
      fmt::format("segment {}: {}, {}", labels(domain, protection.segment), status_word(protection),
                  protection.is_present ? "present" : "absent");
  const auto encroaching = constrained::encroaching_vertex(domain.complex.points, protection);
  if (encroaching) line += fmt::format(", encroached upon by {}", domain.label(*encroaching));
  return line + "\n";
}

std::string adoption_line(const Domain& domain, const Adoption& adoption) {
  std::string line = fmt::format("polygon {}:", domain.polygon_name(adoption.polygon));
  if (!adoption.vertices.empty()) line += " adopts vertices " + labels(domain, adoption.vertices);
  for (const Simplex& segment : adoption.segments) {
    line += " adopts segment " + labels(domain, segment);
  }
  if (!adoption.left_vertices.empty()) {
    line += " leaves out vertices " + labels(domain, adoption.left_vertices);
  }
  for (const Simplex& segment : adoption.left_segments) {
    line += " leaves out segment " + labels(domain, segment);
  }
  return line + "\n";
}

std::string cdt_line(const DomainFacts& facts) {
  const std::string proof = facts.cdt == CdtAnswer::kUnknown ? "" : " (proved)";
  std::string line =
      fmt::format("constrained Delaunay triangulation: {}{}\n", word(facts.cdt), proof);
  if (facts.cdt == CdtAnswer::kCanonical || facts.cdt == CdtAnswer::kAnother) return line;
  const std::string any = !facts.triangulation   ? "unknown"
                          : *facts.triangulation ? "exists (proved)"
                                                 : "none (proved)";
  return line + "triangulation without Steiner points: " + any + "\n";
}

std::string summary(const LoadedDomain& loaded, const DomainFacts& facts) {
  const PiecewiseLinearComplex& complex = loaded.domain.complex;
  const bool in_plane = complex.ambient_dimension() == 2;
  const std::string polygons =
      in_plane ? "" : " " + report::counted(complex.polygons.size(), "polygon");
  return fmt::format("inspected: {} {} {}{} {} {} {} cdt {}\n", on_one_line(loaded.name),
                     report::counted(complex.points.size(), "vertex", "vertices"),
                     report::counted(complex.segments.size(), "segment"), polygons,
                     in_plane ? report::counted(facts.polyhedra, "region")
                              : report::counted(facts.polyhedra, "polyhedron", "polyhedra"),
                     word(complex.kind),
                     facts.is_edge_protected                      ? "edge-protected"
                     : facts.is_edge_protected_under_perturbation ? "perturbed-edge-protected"
                                                                  : "not-edge-protected",
                     word(facts.cdt));
}

std::string text(const LoadedDomain& loaded, const DomainFacts& facts, bool all_segments) {
  const Domain& domain = loaded.domain;
  std::string out;
  for (const std::string& note : loaded.file.notes) out += "note: " + on_one_line(note) + "\n";
  if (facts.holes > 0) out += fmt::format("holes: {}\n", facts.holes);
  for (const Adoption& adoption : facts.adoptions) out += adoption_line(domain, adoption);
  for (const SegmentProtection& protection : facts.segments) {
    if (all_segments || !is_strong(protection)) out += segment_line(domain, protection);
  }
  return out + cdt_line(facts) + summary(loaded, facts);
}

report::Json own(const Domain& domain, const Simplex& simplex) {
  report::Json array = report::Json::array();
  for (const Vertex v : simplex) array.push_back(domain.label(v));
  return array;
}

report::Json segments_json(const Domain& domain, const DomainFacts& facts) {
  report::Json array = report::Json::array();
  for (const SegmentProtection& protection : facts.segments) {
    report::Json entry = {{"segment", own(domain, protection.segment)},
                          {"status", status_word(protection)},
                          {"present", protection.is_present}};
    const auto encroaching = constrained::encroaching_vertex(domain.complex.points, protection);
    if (encroaching) entry["encroaching_vertex"] = domain.label(*encroaching);
    array.push_back(entry);
  }
  return array;
}

report::Json adoptions_json(const Domain& domain, const DomainFacts& facts) {
  report::Json array = report::Json::array();
  const auto segments = [&](const std::vector<Simplex>& some) {
    report::Json list = report::Json::array();
    for (const Simplex& segment : some) list.push_back(own(domain, segment));
    return list;
  };
  for (const Adoption& adoption : facts.adoptions) {
    array.push_back({{"polygon", adoption.polygon + 1},
                     {"vertices", own(domain, adoption.vertices)},
                     {"segments", segments(adoption.segments)},
                     {"left_vertices", own(domain, adoption.left_vertices)},
                     {"left_segments", segments(adoption.left_segments)}});
  }
  return array;
}

report::Json json(const LoadedDomain& loaded, const DomainFacts& facts) {
  const PiecewiseLinearComplex& complex = loaded.domain.complex;
  report::Json ignored = report::Json::array();
  for (const std::size_t seed : facts.ignored_hole_seeds) {
    ignored.push_back(report::point(complex.hole_seeds[seed]));
  }
  report::Json object = {
      {"domain", loaded.name},
      {"valid", true},
      {"kind", word(complex.kind)},
      {"dimension", complex.ambient_dimension()},
      {"vertices", complex.points.size()},
      {"segments", complex.segments.size()},
      {"polygons", complex.polygons.size()},
      {"polyhedra", facts.polyhedra},
      {"holes", facts.holes},
      {"ignored_hole_seeds", ignored},
      {"adoptions", adoptions_json(loaded.domain, facts)},
      {"edge_protected", facts.is_edge_protected},
      {"edge_protected_under_perturbation", facts.is_edge_protected_under_perturbation},
      {"protection", segments_json(loaded.domain, facts)},
      {"cdt", word(facts.cdt)},
      {"cdt_proved", facts.cdt != CdtAnswer::kUnknown},
      {"notes", loaded.file.notes}};
  if (facts.triangulation) object["triangulation_without_steiner_points"] = *facts.triangulation;
  return object;
}

// The breaches are facts asked for; that there are any is the input's fault.
void report_breaches(const std::string& path, const DomainFault& fault, Output& output) {
  output.exit_with(ExitCode::kInputFault);
  std::string lines;
  report::Json breaches = report::Json::array();
  for (const Breach& breach : fault.breaches) {
    lines += breach_line(breach, fault.file) + "\n";
    breaches.push_back(breach_json(breach, fault.file));
  }
  if (fault.truncated) {
    lines += fmt::format("… stopped at {}; --max-errors 0 lists all\n", fault.breaches.size());
  }
  output.text(
      lines +
      fmt::format("inspected: {} no piecewise linear complex, {}{} {} of which the first is {}\n",
                  on_one_line(path), fault.truncated ? "more than " : "", fault.breaches.size(),
                  fault.breaches.size() == 1 && !fault.truncated ? "breach" : "breaches",
                  identifier(fault.breaches.front().kind)));
  if (output.wants_json()) {
    output.json({{"domain", path},
                 {"valid", false},
                 {"breaches", breaches},
                 {"truncated", fault.truncated}});
  }
}

}  // namespace

void add_domain_inspection_options(CLI::App& command, DomainInspection& options) {
  command.add_flag("--domain", options.is_asked_for,
                   "The input is a domain, whatever its name says: an .off file, for example");
  add_domain_options(command, options.said);
  command.add_flag("--all-segments", options.all_segments,
                   "Name every segment of a domain, not only those that are not strongly Delaunay");
  command
      .add_option("--max-errors", options.max_errors,
                  "Report at most N breaches of a domain (default: 20; 0: all)")
      ->check(whole_number())
      ->option_text("N");
  add_search_options(command, options.limits);
  command
      .add_option("--refutations", options.refutations,
                  "Where there is no CDT or no triangulation, write the proofs for replay: "
                  "PREFIX-cdt.cnf and .drat, PREFIX-triangulation.cnf and .drat")
      ->option_text("PREFIX");
}

void inspect_domain(const std::string& path, const InputOptions& input,
                    const DomainInspection& options, Output& output) {
  if (const std::string fault = domain_options_fault(options.said); !fault.empty()) {
    output.error(ExitCode::kUsage, "domain", path, fault);
    return;
  }
  const auto loaded = load_domain(path, input, options.said, options.max_errors, Leak::kTold);
  if (!loaded && !loaded.error().breaches.empty()) {
    report_breaches(path, loaded.error(), output);
    return;
  }
  if (!loaded) {
    output.error(ExitCode::kInputFault, "domain", path, loaded.error().message);
    return;
  }
  const DomainFacts facts = facts_of(*loaded, options.limits);
  if (facts.cdt == CdtAnswer::kUnknown) output.exit_with(ExitCode::kUndecided);
  if (!options.refutations.empty()) {
    const std::string error = write_refutations(options.refutations, loaded->domain, facts);
    if (!error.empty()) output.error(ExitCode::kInputFault, "file", options.refutations, error);
  }
  output.text(text(*loaded, facts, options.all_segments));
  if (output.wants_json()) output.json(json(*loaded, facts));
}

}  // namespace circumspect::cli
