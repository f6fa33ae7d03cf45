#include "command/inspect/inspect_domain.hpp"

#include <algorithm>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "command/check/certificate_output.hpp"
#include "command/input/breach_text.hpp"
#include "command/input/domain_input.hpp"
#include "command/inspect/domain_facts.hpp"
#include "command/inspect/refutation_files.hpp"
#include "command/options/whole_number.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::cli {
namespace {

using construct::SegmentFacts;

std::string_view status_word(const SegmentFacts& segment) {
  switch (segment.delaunayhood) {
    case delaunay::Delaunayhood::kStronglyDelaunay:
      return "strongly-delaunay";
    case delaunay::Delaunayhood::kDelaunay:
      return "delaunay";
    case delaunay::Delaunayhood::kNotDelaunay:
      return "not-delaunay";
  }
  return "";
}

std::string segment_line(const Domain& domain, const SegmentFacts& segment) {
  std::string line = fmt::format("segment {}: {}, {}", labels(domain, segment.segment),
                                 status_word(segment), segment.is_present ? "present" : "absent");
  if (segment.encroaching) {
    line += fmt::format(", encroached upon by {}", domain.label(*segment.encroaching));
  }
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
  const std::string proof = facts.cdt == CdtAnswer::kUnknown
                                ? fmt::format(" ({}; --decide goes on)", facts.limit)
                                : " (proved)";
  std::string line =
      fmt::format("constrained Delaunay triangulation: {}{}\n", word(facts.cdt), proof);
  if (facts.cdt == CdtAnswer::kCanonical || facts.cdt == CdtAnswer::kAnother) return line;
  const std::string any = !facts.triangulation   ? "unknown"
                          : *facts.triangulation ? "exists (proved)"
                                                 : "none (proved)";
  return line + "triangulation without Steiner points: " + any + "\n";
}

// "12 vertices 20 segments 10 polygons"
std::string counts_of(const PiecewiseLinearComplex& complex) {
  std::string text =
      fmt::format("{} {}", report::counted(complex.points.size(), "vertex", "vertices"),
                  report::counted(complex.segments.size(), "segment"));
  if (complex.ambient_dimension() == 3) {
    text += " " + report::counted(complex.polygons.size(), "polygon");
  }
  return text;
}

std::string regions_of(const PiecewiseLinearComplex& complex, const DomainFacts& facts) {
  return complex.ambient_dimension() == 2
             ? report::counted(facts.polyhedra, "region")
             : report::counted(facts.polyhedra, "polyhedron", "polyhedra");
}

std::string_view protection_word(const DomainFacts& facts) {
  return facts.is_edge_protected                      ? "edge-protected"
         : facts.is_edge_protected_under_perturbation ? "perturbed-edge-protected"
                                                      : "not-edge-protected";
}

report::Json own(const Domain& domain, const Simplex& simplex) {
  report::Json array = report::Json::array();
  for (const Vertex v : simplex) array.push_back(domain.label(v));
  return array;
}

report::Json segments_json(const Domain& domain, const DomainFacts& facts) {
  report::Json array = report::Json::array();
  for (const SegmentFacts& segment : facts.segments) {
    report::Json entry = {{"segment", own(domain, segment.segment)},
                          {"status", status_word(segment)},
                          {"present", segment.is_present}};
    if (segment.encroaching) entry["encroaching_vertex"] = domain.label(*segment.encroaching);
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

constexpr std::string_view kValidity = "validity", kRegions = "regions",
                           kProtection = "edge-protection", kCdt = "cdt";

// Prints what is found as soon as it is found, and collects it for JSON and for the last line.
class Inspection {
 public:
  Inspection(const std::string& path, const DomainInspection& options,
             const std::vector<std::string>& only, Output& output, picture::Page* page)
      : path_(path), options_(options), only_(only), output_(output), page_(page) {}

  void run(const InputOptions& input) {
    output_.begin("deciding whether " + path_ + " is valid");
    DomainWatch watch{output_.progress()};
    watch.on_breach = [this](const Breach& breach, const formats::DomainFile& file) {
      add_breach(breach, file);
    };
    watch.on_valid = [this](const PiecewiseLinearComplex& complex,
                            const formats::DomainFile& file) { add_validity(complex, file); };
    watch.only_validity = !wants(kRegions) && !wants(kProtection) && !wants(kCdt);
    const auto loaded =
        load_domain(path_, input, options_.said, options_.max_errors, Leak::kTold, watch);
    if (!loaded && breaches_ > 0) {
      end_invalid(loaded.error().file);
    } else if (!loaded) {
      const std::vector<std::string>& notes = loaded.error().file.notes;
      for (std::size_t i = notes_told_; i < notes.size(); ++i) output_.note(notes[i]);
      output_.error(ExitCode::kInputFault, "domain", path_, loaded.error().message);
    } else {
      inspect(*loaded);
    }
  }

 private:
  bool wants(std::string_view fact) const {
    return only_.empty() || std::find(only_.begin(), only_.end(), fact) != only_.end();
  }

  // The breaches are facts asked for; that there are any is the input's fault.
  void add_breach(const Breach& breach, const formats::DomainFile& file) {
    if (breaches_ == 0) {
      output_.exit_with(ExitCode::kInputFault);
      first_ = breach.kind;
      known_ = {{"domain", path_},
                {"valid", false},
                {"notes", file.notes},
                {"breaches", report::Json::array()}};
      output_.notes(file.notes);
    }
    ++breaches_;
    has_equal_vertices_ = has_equal_vertices_ || breach.kind == BreachKind::kDuplicateVertex;
    if (options_.max_errors != 0 && breaches_ > options_.max_errors) return;
    tell(breach_line(breach, file) + "\n");
    if (page_ != nullptr && drawn_.size() < picture::kMostCards) drawn_.push_back(breach);
    if (output_.wants_json() && breaches_ <= kMostInJson) {
      known_["breaches"].push_back(breach_json(breach, file));
    }
  }
  void end_invalid(const formats::DomainFile& file) {
    const bool truncated = options_.max_errors != 0 && breaches_ > options_.max_errors;
    const std::size_t listed = truncated ? options_.max_errors : breaches_;
    if (truncated) tell(fmt::format("… stopped at {}; --max-errors 0 lists all\n", listed));
    known_["truncated"] = truncated || breaches_ > kMostInJson;
    if (has_equal_vertices_) {
      const std::string note = path_ + ": --duplicates merge takes equal vertices for one";
      known_["notes"].push_back(note);
      output_.note(note);
    }
    picture::Facts facts;
    facts.holds = false;
    facts.noun = "Breach";
    facts.cards_of = listed;
    for (const Breach& breach : drawn_) facts.cards.push_back(breach_card(breach, file));
    end(fmt::format("{} not a piecewise linear complex, {}{} {}, first {}", on_one_line(path_),
                    truncated ? "more than " : "", listed,
                    listed == 1 && !truncated ? "breach" : "breaches", identifier(first_)),
        std::move(facts), page_ == nullptr ? Mesh() : skeleton(file));
  }

  void add_validity(const PiecewiseLinearComplex& complex, const formats::DomainFile& file) {
    output_.notes(file.notes);
    notes_told_ = file.notes.size();
    tell(fmt::format("valid: {} {}\n", on_one_line(path_), counts_of(complex)));
    know({{"domain", path_},
          {"valid", true},
          {"dimension", complex.ambient_dimension()},
          {"vertices", complex.points.size()},
          {"segments", complex.segments.size()},
          {"polygons", complex.polygons.size()}});
    output_.begin("finding what " + path_ + " encloses");
  }

  void inspect(const LoadedDomain& loaded) {
    const std::vector<std::string>& notes = loaded.file.notes;
    for (std::size_t i = notes_told_; i < notes.size(); ++i) output_.note(notes[i]);
    summary_ = counts_of(loaded.domain.complex);
    if (wants(kRegions)) add_regions(loaded);
    if (wants(kProtection) || wants(kCdt)) {
      const construct::EdgeProtection protection = protection_of(loaded, output_);
      if (wants(kProtection)) add_protection(loaded, protection);
      if (wants(kCdt)) add_cdt(loaded, protection);
    }
    know({{"notes", notes}});
    if (wants(kCdt) && !options_.refutations.empty()) {
      output_.end_watch();
      std::string error = write_refutations(options_.refutations, loaded.domain, facts_);
      // That there is no triangulation says that there is no CDT.
      if (error.empty() && (facts_.no_triangulation || facts_.no_cdt)) {
        error = write_impossibility(
            options_.refutations, facts_.no_triangulation ? Claim::kPlcTriangulation : Claim::kCdt,
            loaded, output_);
      }
      if (!error.empty()) {
        output_.error(ExitCode::kInputFault, "file", options_.refutations, error);
      }
    }
    picture::Facts facts;
    facts.noun = "Domain";
    if (auto card = domain_card(loaded.file); page_ != nullptr && card) {
      facts.cards.push_back(*std::move(card));
    }
    end(fmt::format("{} {}", on_one_line(path_), summary_), std::move(facts),
        page_ == nullptr ? Mesh() : skeleton(loaded.file));
  }

  void add_regions(const LoadedDomain& loaded) {
    const PiecewiseLinearComplex& complex = loaded.domain.complex;
    find_regions(loaded, facts_, output_);
    std::string lines = fmt::format("{}: {}\n", word(complex.kind), regions_of(complex, facts_));
    if (facts_.holes > 0) lines += fmt::format("holes: {}\n", facts_.holes);
    for (const Adoption& adoption : facts_.adoptions) {
      lines += adoption_line(loaded.domain, adoption);
    }
    tell(lines);
    summary_ += fmt::format(" {} {}", regions_of(complex, facts_), word(complex.kind));
    report::Json ignored = report::Json::array();
    for (const std::size_t seed : facts_.ignored_hole_seeds) {
      ignored.push_back(report::point(complex.hole_seeds[seed]));
    }
    know({{"kind", word(complex.kind)},
          {"polyhedra", facts_.polyhedra},
          {"holes", facts_.holes},
          {"ignored_hole_seeds", ignored},
          {"adoptions", adoptions_json(loaded.domain, facts_)}});
  }

  void add_protection(const LoadedDomain& loaded, const construct::EdgeProtection& protection) {
    find_edge_protection(loaded, protection, facts_, output_);
    std::string lines;
    for (const SegmentFacts& segment : facts_.segments) {
      if (options_.all_segments || !segment.is_strong()) {
        lines += segment_line(loaded.domain, segment);
      }
    }
    tell(lines + fmt::format("segments: {}\n", protection_word(facts_)));
    summary_ += fmt::format(" {}", protection_word(facts_));
    know({{"edge_protected", facts_.is_edge_protected},
          {"edge_protected_under_perturbation", facts_.is_edge_protected_under_perturbation}});
    if (output_.wants_json()) know({{"protection", segments_json(loaded.domain, facts_)}});
  }

  void add_cdt(const LoadedDomain& loaded, const construct::EdgeProtection& protection) {
    SearchLimits limits = options_.limits;
    if (options_.decide) limits.wrapped_vertices = 0;
    find_cdt(loaded, protection, limits, facts_, output_);
    if (facts_.cdt == CdtAnswer::kUnknown && options_.decide) {
      output_.exit_with(ExitCode::kUndecided);
    }
    tell(cdt_line(facts_));
    summary_ += fmt::format(" cdt {}", word(facts_.cdt));
    know({{"cdt", word(facts_.cdt)}, {"cdt_proved", facts_.cdt != CdtAnswer::kUnknown}});
    if (facts_.triangulation)
      know({{"triangulation_without_steiner_points", *facts_.triangulation}});
  }

  void tell(const std::string& text) {
    output_.text(text);
    if (page_ != nullptr) told_ += text;
  }

  // The last line, and the page.
  void end(const std::string& summary, picture::Facts facts, const Mesh& mesh) {
    facts.line = "inspected: " + summary;
    output_.text(facts.line + "\n");
    if (output_.wants_json()) output_.json(known_);
    if (page_ == nullptr) return;
    facts.heading = path_;
    facts.text = told_;
    page_->add_facts(std::move(facts), mesh);
  }

  void know(const report::Json& more) {
    known_.update(more);
    output_.know(known_);
  }

  // Of more breaches JSON tells no more than their number would: they have to fit into memory.
  static constexpr std::size_t kMostInJson = 100'000;

  const std::string& path_;
  const DomainInspection& options_;
  const std::vector<std::string>& only_;
  Output& output_;
  picture::Page* page_;
  std::string told_;           // for the page
  std::vector<Breach> drawn_;  // likewise: the first ones
  std::size_t breaches_ = 0;
  BreachKind first_ = {};
  bool has_equal_vertices_ = false;
  std::size_t notes_told_ = 0;
  DomainFacts facts_;
  std::string summary_;
  report::Json known_ = report::Json::object();
};

}  // namespace

void add_domain_inspection_options(CLI::App& command, DomainInspection& options) {
  command.add_flag("--domain", options.is_asked_for,
                   "Read the input as a domain, whatever its extension, for example an .off file");
  add_domain_options(command, options.said);
  command.add_flag("--all-segments", options.all_segments,
                   "Name every segment of a domain, not only those that are not strongly Delaunay");
  command
      .add_option("--max-errors", options.max_errors,
                  "Report at most N breaches of a domain (default: 20; 0: all)")
      ->check(whole_number())
      ->option_text("N");
  command.add_flag("--decide", options.decide,
                   "Decide whether a domain of any size has a canonical CDT, by gift-wrapping if "
                   "necessary, which may take long. If no answer is found, end with exit code 4");
  add_search_options(command, options.limits);
  command
      .add_option(
          "--refutations", options.refutations,
          "If there is no CDT or no triangulation, write the proofs: for replay PREFIX-cdt.cnf "
          "and .drat, PREFIX-triangulation.cnf and .drat; for circumspect-verified "
          "PREFIX-triangulation.proof or PREFIX-cdt.proof")
      ->option_text("PREFIX");
}

std::vector<std::string> domain_facts() {
  return {std::string(kValidity), std::string(kRegions), std::string(kProtection),
          std::string(kCdt)};
}

void inspect_domain(const std::string& path, const InputOptions& input,
                    const DomainInspection& options, const std::vector<std::string>& only,
                    Output& output, picture::Page* page) {
  if (const std::string fault = domain_options_fault(options.said); !fault.empty()) {
    output.error(ExitCode::kUsage, "domain", path, fault);
    return;
  }
  Inspection(path, options, only, output, page).run(input);
}

}  // namespace circumspect::cli
