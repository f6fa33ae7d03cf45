#include "command/campaign/campaign_page.hpp"

#include <fstream>
#include <sstream>

#include "command/campaign/campaign_report.hpp"
#include "command/check/judge_loaded.hpp"
#include "command/input/domain_input.hpp"
#include "command/output/output.hpp"
#include "fuzz/campaign/finding_folder.hpp"
#include "fuzz/campaign/judge_mesh.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/plane.hpp"
#include "oracle/formats/read_domain.hpp"
#include "oracle/model/printable.hpp"

namespace circumspect::cli {
namespace {

constexpr std::size_t kLongestInput = 20000;

// The small input as it stands in its file, unless it is long.
std::string small_input(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  if (text.str().size() > kLongestInput) return "";
  return on_lines(text.str());
}

// Adds what is judged of a finding: the mesh in `path`, of the points or the domain in
// `input_file`. False if it cannot be read any more.
bool add_judged(const report::Json& finding, const std::string& path, const std::string& input_file,
                const campaign::Subject& subject, picture::Page& page) {
  const std::string extension = formats::extension(path);
  InputOptions input;
  input.duplicates = Duplicates::kMerge;
  input.weighted = subject.claim == Claim::kWeightedDelaunay;
  input.faces = subject.is_about_domains();
  DomainOptions said{.fill = subject.fill};
  if (subject.merges_coplanar) said.merged_slope = 0;
  std::optional<LoadedDomain> domain;
  if (subject.is_about_domains()) {
    auto file = formats::read_domain(input_file, input.coordinates);
    if (!file) return false;
    auto loaded = load_domain(formats::of_dimension(std::move(*file), subject.dimension),
                              input_file, input, said);
    if (!loaded) return false;
    domain = std::move(*loaded);
  } else if (extension == ".ele" || extension == ".qhull-i") {
    input.points = input_file;
  }
  auto mesh = load_mesh(path, input, 1, domain ? std::optional(frame_of(*domain)) : std::nullopt);
  if (!mesh) return false;
  const Domain* about = domain ? &domain->domain : nullptr;
  const auto verdict = judge_loaded(subject.claim, *mesh, input.duplicates, {}, about);
  if (!verdict || verdict->holds()) return false;
  page.add_finding(finding, &*verdict, &mesh->mesh, path, about);
  return true;
}

}  // namespace

picture::Page campaign_page(const campaign::Result& result, const campaign::Plan& plan,
                            const std::string& program) {
  picture::Page page;
  report::Json all = campaign_json(result, plan, program);
  const report::Json findings = std::move(all["findings"]);
  all.erase("findings");
  all["findings_count"] = findings.size();
  page.begin_with_campaign(std::move(all), campaign_verdict(result, program, plan.magnitudes));
  const std::string own = plan.subject.is_about_domains() ? "/minimal.poly" : "/minimal.node";
  for (const report::Json& details : findings) {
    const std::string folder = details["folder"].get<std::string>();
    // The folder is as whoever has it left it.
    const bool is_readable = campaign::holds_files_alone(folder);
    const bool has_rule = is_readable && details.contains("verdict");
    report::Json finding = {{"signature", details["signature"]},
                            {"count", details["count"]},
                            {"text", details.value("text", "not made small yet")},
                            {"minimal", is_readable ? small_input(folder + own) : ""},
                            {"reproduce", on_one_line(folder + "/reproduce.sh")}};
    const bool is_of_image =
        details["signature"].get<std::string>().find("-after-") != std::string::npos;
    const std::string stem = plan.subject.is_untidy ? "/arranged"
                             : is_of_image          ? "/image"
                                                    : "/minimal";
    const std::string judged = folder + stem + formats::extension(own);
    if (has_rule && add_judged(finding, folder + "/output/" + plan.subject.mesh_name, judged,
                               plan.subject, page)) {
      continue;
    }
    page.add_finding(std::move(finding));
  }
  return page;
}

picture::Page minimal_page(report::Json finding, const campaign::Input& input,
                           const campaign::Subject& subject, const campaign::Runner& runner) {
  picture::Page page;
  const std::string extension = subject.is_about_domains() ? ".poly" : ".node";
  // Beside the program's own folder, so that nothing of the program is in its place.
  const std::string file = runner.work_folder() + "-minimal" + extension;
  const auto text_of = [&](const campaign::Input& one) {
    return campaign::file_text(one, extension, subject.first_index, subject.dimension).value_or("");
  };
  const std::string shown = text_of(input);
  const auto* const domain = std::get_if<campaign::ComplexCase>(&input);
  const std::string text = domain == nullptr ? shown : text_of(campaign::tidy(subject, *domain));
  finding["minimal"] = shown.size() > kLongestInput ? "" : on_lines(shown);
  const std::string mesh = runner.mesh_file();
  const bool is_written = write_file(file, [&](std::ostream& out) { out << text; }).empty();
  if (mesh.empty() || !is_written || !add_judged(finding, mesh, file, subject, page)) {
    page.add_finding(std::move(finding));
  }
  return page;
}

}  // namespace circumspect::cli
