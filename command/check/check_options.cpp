#include "command/check/check_options.hpp"

#include <map>

#include <fmt/format.h>

#include "command/check/certificate_output.hpp"
#include "command/check/check_voronoi.hpp"
#include "command/check/judge_in_parts.hpp"
#include "command/check/quality_options.hpp"
#include "command/input/domain_input.hpp"
#include "command/options/one_of.hpp"
#include "command/options/option_rows.hpp"
#include "command/options/threads.hpp"
#include "command/options/usage_faults.hpp"
#include "command/options/whole_number.hpp"
#include "command/output/overwriting.hpp"
#include "oracle/formats/format.hpp"

namespace circumspect::cli {
namespace {

// Whether coordinates of points are left out.
Asked columns_of(const CheckOptions& options) {
  const bool is_dropped = options.input.dropped.has_value();
  return {is_dropped || options.input.dimension, is_dropped ? "--drop" : "--dimension"};
}

// What needs the whole mesh in memory.
std::vector<UsageFault> faults_beside_memory(const CheckOptions& options) {
  const Asked memory{options.memory.has_value(), "--memory"};
  std::vector<UsageFault> faults;
  for (const Asked& asked : std::initializer_list<Asked>{
           {options.domain.has_value(), "--domain"},
           {options.check.by == check::By::kDefinition, "--by definition"},
           {options.check.oriented, "--oriented"},
           {!options.check.quality.empty(), "--require"},
           {options.input.neighbors, "--neighbors"},
           {!options.input.kept_labels.empty(), "--keep-label"},
           {options.input.dropped.has_value(), "--drop"},
           {options.input.dimension.has_value(), "--dimension"},
           {options.input.allow_empty, "--allow-empty"},
           {options.input.duplicates == Duplicates::kMerge, "--duplicates merge"},
           {options.input.coordinates != NumberReading::kDouble, "--coordinates decimal"},
           {options.certificate.has_value(), "--certificate"},
           {!picture_files(options.picture).empty(), "pictures"}}) {
    faults.push_back(contradiction(asked, memory, "this needs the whole mesh in memory"));
  }
  return faults;
}

// What a certificate does not show, or is not about.
std::vector<UsageFault> faults_beside_certificate(const CheckOptions& options) {
  if (!options.certificate) return {};
  const Asked certificate{true, "--certificate"};
  ComplexOptions unproved = options.complex;
  unproved.demands.allow_unused = false;
  const std::string complex_word = of_complexes_alone(unproved);
  std::vector<UsageFault> faults = {certificate_fault(options.claim, options.said)};
  for (const Asked& asked : std::initializer_list<Asked>{
           {!options.check.quality.empty(), "--require"},
           {!complex_word.empty(), complex_word},
           {options.check.hull.all_boundary_points, "--all-boundary-points"},
           {options.check.hull.only_extreme, "--only-extreme"},
           {options.within.has_value(), "--within"}}) {
    faults.push_back(contradiction(asked, certificate, "nothing is proved of it"));
  }
  faults.push_back(contradiction(certificate, {!options.input.kept_labels.empty(), "--keep-label"},
                                 "a certificate is about all cells of a file"));
  faults.push_back(contradiction(certificate, columns_of(options),
                                 "a certificate is about the points of a file"));
  faults.push_back(
      {options.meshes.size() != 1,
       fmt::format("expected one mesh beside --certificate, found {}", options.meshes.size())});
  faults.push_back({options.certificate == "-",
                    "expected a file for --certificate, found -; circumspect certify writes to "
                    "standard output"});
  return faults;
}

// What would be written over a file that is read, or twice to one; empty if nothing.
std::string writing_fault(const CheckOptions& options) {
  std::vector<Written> written = picture_files(options.picture);
  if (options.certificate) written.push_back({"the certificate", *options.certificate});
  for (const std::string& report : {options.output.junit, options.output.sarif}) {
    if (report == "-") return "expected a file for a report, found -";
    if (!report.empty()) written.push_back({"a report", report});
  }
  if (written.empty()) return "";
  std::vector<std::string> read;
  for (const std::string& mesh : options.meshes) {
    const std::vector<std::string> files = files_of_mesh(mesh);
    read.insert(read.end(), files.begin(), files.end());
  }
  if (options.domain) {
    const std::vector<std::string> files = files_of_domain(*options.domain);
    read.insert(read.end(), files.begin(), files.end());
  }
  if (options.input.points) read.push_back(*options.input.points);
  return overwriting_fault(written, read);
}

}  // namespace

std::string usage_fault(CheckOptions& options) {
  const std::string demands = settle_complex_options(options.complex, options.claim, options.check);
  const std::string_view claim = options.claim ? name(*options.claim) : "";
  const Asked list{options.claim && is_about_a_list(*options.claim),
                   fmt::format("the claim {}", claim)};
  const Asked hull{options.claim == Claim::kConvexHull, "--claim convex-hull"};
  const Asked voronoi{options.claim == Claim::kVoronoi, "--claim voronoi"};
  const Asked periodic{options.claim == Claim::kPeriodicDelaunay, "--claim periodic-delaunay"};
  const Asked boxed{voronoi.is_given || periodic.is_given,
                    "--claim voronoi or --claim periodic-delaunay"};
  const Asked lattice{options.lattice.is_given(), "--lattice"};
  const Asked box{options.box.has_value(), "--box"};
  const Asked neighbors{options.input.neighbors, "--neighbors"};
  const Asked memory{options.memory.has_value(), "--memory"};
  const Asked demanded{!options.check.quality.empty(), "--require"};
  const Asked within{options.within.has_value(), "--within"};
  const Asked labels{!options.input.kept_labels.empty(), "--keep-label"};
  const Asked faces{options.complex.demands.faces, "--faces"};
  const Asked domain{options.domain.has_value(), "--domain FILE"};
  const std::string fault = first_fault({
      demands,
      first_fault(faults_beside_certificate(options)),
      contradiction(neighbors, list),
      contradiction(memory, list),
      dependence({options.check.hull.all_boundary_points, "--all-boundary-points"}, hull),
      dependence({options.check.hull.only_extreme, "--only-extreme"}, hull),
      dependence({options.check.structure, "--structure"}, voronoi),
      dependence(box, boxed),
      dependence(lattice, periodic),
      contradiction(lattice, box),
      dependence(periodic, {lattice.is_given || box.is_given, "--lattice or --box"},
                 "say how the mesh repeats"),
      contradiction(periodic,
                    {options.input.duplicates == Duplicates::kMerge, "--duplicates merge"},
                    "offsets belong to the points that are listed"),
      contradiction(periodic, labels, "attributes are offsets"),
      dependence(voronoi, {options.input.points.has_value(), "--points FILE"},
                 "it has the sites, and the output of qvoronoi o Fv the cells"),
      quality_fault(options.check.quality),
      contradiction(demanded, voronoi),
      domain_options_fault(options.said, options.claim, domain.is_given),
      voronoi.is_given ? "" : dependence(within, domain).text,
      dependence({options.said.merges_bent(), "--merge-coplanar with an angle"},
                 {within.is_given, "--within DISTANCE"},
                 "say how far vertices may be from one plane"),
      contradiction(neighbors, labels, "a .neigh file is about all cells"),
      contradiction(faces, labels, "a listed face may belong to a cell that is left out"),
      first_fault(faults_beside_memory(options)),
      picture_fault(options.picture, options.meshes.size()),
  });
  return fault.empty() ? writing_fault(options) : fault;
}

void add_check_options(CLI::App& command, CheckOptions& options) {
  add_options(command, {{"mesh", "", required(options.meshes),
                         fmt::format("Meshes: {}; - for standard input, in any of these formats",
                                     formats::endings_in_help(&formats::Format::has_mesh))}});
  add_claim_option(command, options.claim,
                   "The claim to judge (default: delaunay; with a domain cdt, or steiner-cdt if "
                   "the mesh has more vertices than the domain). Weights are the first attribute "
                   "of a .node file, as for tetgen -w, or the key weights of JSON");
  add_options(
      command,
      {{"--domain", "FILE", into(options.domain),
        fmt::format("The domain that the mesh must fill: {}. The dangling triangles and edges of "
                    "the mesh are read from the .face and the .edge file beside the .ele",
                    formats::endings_in_help(&formats::Format::has_domain))}});
  add_domain_options(command, options.said, true);
  add_within_option(command, options.within);
  const std::map<std::string, check::By> ways = {{"lemma", check::By::kLemma},
                                                 {"definition", check::By::kDefinition}};
  add_options(command, {{"--points", "FILE", into(options.input.points),
                         "The file with the points of the mesh"},
                        {"--by", "lemma|definition", into(options.check.by, one_of(ways)),
                         "Judge by the lemmas (default) or, slowly, by the definitions"},
                        {"--certificate", "FILE", into(options.certificate),
                         "Also write a certificate or a refutation, as circumspect certify does"}});
  add_picture_options(command, options.picture);
  add_complex_options(command, options.complex);
  add_quality_options(command, options.check.quality);
  HullDemands& hull = options.check.hull;
  add_options(command,
              {{"--all-boundary-points", "", flag(hull.all_boundary_points),
                "With the claim convex-hull: demand that every point in the boundary of "
                "the hull is a vertex"},
               {"--only-extreme", "", flag(hull.only_extreme),
                "With the claim convex-hull: demand that every vertex is an extreme point"}});
  add_options(command, {{"--structure", "", flag(options.check.structure),
                         "With the claim voronoi: demand that the listed vertices and ridges are "
                         "those of the diagram, too, up to the distance of --within"}});
  add_box_option(command, options.box);
  add_lattice_option(command, options.lattice);
  add_options(command, {{"--neighbors", "", flag(options.input.neighbors),
                         "Also judge the .neigh file beside each .ele"},
                        {"--max-errors", "N", into(options.check.max_violations, whole_number()),
                         "Report at most N witnesses (default: 20; 0: all)"}});
  add_threads_option(command, options.threads);
  add_memory_option(command, options.memory);
  add_coordinates_option(command, options.input);
  add_duplicates_option(command, options.input);
  add_drop_option(command, options.input);
  add_dimension_option(command, options.input);
  add_keep_label_option(command, options.input);
  add_allow_empty_option(command, options.input);
  add_report_options(command, options.output);
  add_limit_option(command, options.output);
  add_output_options(command, options.output);
}

}  // namespace circumspect::cli
