#include "command/inspect/inspect_mesh.hpp"

#include <algorithm>
#include <thread>

#include <fmt/format.h>

#include "kernel/exact/number_text.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/judge/judge.hpp"
#include "oracle/judge/quality/survey.hpp"
#include "oracle/judge/quality/topology.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::cli {
namespace {

constexpr std::string_view kTopology = "topology", kSize = "size", kQuality = "quality";
constexpr std::size_t kLongestBar = 40;

// "least angle", "largest volume": what an extreme is one of.
std::string quantity(const quality::Extreme& extreme) {
  const std::string_view name = entry(extreme.measure).name;
  const bool has_end = name.starts_with("min-") || name.starts_with("max-");
  return fmt::format("{} {}", extreme.is_largest ? "largest" : "least",
                     has_end ? name.substr(4) : name);
}

// "10deg to 15deg": a row of a histogram.
std::string range_text(const quality::Histogram& histogram, std::size_t bin) {
  if (bin == 0) return "below " + histogram.word(0);
  if (bin == histogram.bounds.size()) return "from " + histogram.word(bin - 1);
  return fmt::format("{} to {}", histogram.word(bin - 1), histogram.word(bin));
}

std::string bars(const quality::Histogram& histogram) {
  std::string text = fmt::format("histogram: {}\n", entry(histogram.measure).name);
  const std::size_t most = *std::max_element(histogram.counts.begin(), histogram.counts.end());
  for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin) {
    const std::size_t count = histogram.counts[bin];
    if (count == 0) continue;
    const std::size_t length = std::max<std::size_t>(1, kLongestBar * count / most);
    text += fmt::format("  {:<18} {:>9} {}\n", range_text(histogram, bin), count,
                        std::string(length, '#'));
  }
  return text;
}

report::Json json_of(const quality::Histogram& histogram) {
  report::Json bounds = report::Json::array();
  for (std::size_t i = 0; i < histogram.bounds.size(); ++i) bounds.push_back(histogram.word(i));
  return {
      {"measure", entry(histogram.measure).name}, {"bounds", bounds}, {"counts", histogram.counts}};
}

// Prints what is found as soon as it is found, and collects it for JSON, the page and the last
// line.
class InspectedMesh {
 public:
  InspectedMesh(const LoadedMesh& loaded, const std::vector<std::string>& only, Output& output,
                picture::Page* page)
      : loaded_(loaded), mesh_(loaded.mesh), only_(only), output_(output), page_(page) {}

  void run() {
    add_counts();
    if (wants(kTopology)) add_topology();
    if (wants(kSize)) add_sizes();
    if (wants(kQuality)) add_quality();
    facts_.heading = loaded_.name;
    facts_.noun = "Extreme";
    facts_.line = fmt::format("inspected: {} {}", on_one_line(loaded_.name), summary_);
    output_.text(facts_.line + "\n");
    if (output_.wants_json()) output_.json(known_);
    if (page_ != nullptr) page_->add_facts(std::move(facts_), mesh_);
  }

 private:
  bool wants(std::string_view fact) const {
    return only_.empty() || std::find(only_.begin(), only_.end(), fact) != only_.end();
  }

  void add_counts() {
    const int dimension = quality::dimension_of_simplices(mesh_);
    summary_ = fmt::format("{} {}", report::counted(mesh_.points(), "point"),
                           report::counted_simplices(mesh_.simplices.size(), dimension));
    tell(fmt::format("mesh: {} in dimension {}\n", summary_, mesh_.dimension()));
    know({{"mesh", loaded_.name},
          {"points", mesh_.points()},
          {"simplices", mesh_.simplices.size()},
          {"dimension", dimension},
          {"ambient_dimension", mesh_.dimension()}});
  }

  // Do the simplices form a complex, and is it a manifold?
  void add_topology() {
    output_.begin("judging whether " + loaded_.name + " is a complex");
    check::Options options;
    options.complex.manifold = quality::dimension_of_simplices(mesh_) <= 3;
    options.complex.allow_unused = true;
    options.max_violations = 1;
    const Verdict verdict = check::judge(Claim::kComplex, mesh_, nullptr, options).value();
    const auto& broken = verdict.tallies();
    const bool is_complex =
        broken.empty() || (broken.size() == 1 && broken.contains(Rule::kNotManifold));
    const std::string_view word = !is_complex      ? "not-complex"
                                  : broken.empty() ? "complex manifold"
                                                   : "complex not-manifold";
    output_.begin("counting the faces of " + loaded_.name);
    const quality::Topology found = quality::topology(mesh_);
    tell_faces(found);
    const ComplexFacts facts = verdict.complex.value_or(ComplexFacts{});
    std::string text = fmt::format("complex: {} {}", word, report::counted(facts.parts, "part"));
    text += fmt::format(" {} in {}", report::counted(found.boundary_facets, "boundary-facet"),
                        report::counted(found.boundary_parts, "part"));
    const bool has_genus = broken.empty() && found.genus.has_value();
    if (has_genus) text += fmt::format(" genus {}", *found.genus);
    tell(text + "\n");
    if (facts.positive + facts.negative > 0) {
      tell(fmt::format("orientations: {} positive {} negative\n", facts.positive, facts.negative));
    }
    summary_ += fmt::format(" {} {}", word, report::counted(facts.parts, "part"));
    know({{"is_complex", is_complex},
          {"is_manifold", broken.empty()},
          {"parts", facts.parts},
          {"faces", found.faces},
          {"euler_characteristic", found.euler_characteristic},
          {"boundary_facets", found.boundary_facets},
          {"boundary_parts", found.boundary_parts},
          {"positive", facts.positive},
          {"negative", facts.negative}});
    if (has_genus) know({{"genus", *found.genus}});
  }

  void tell_faces(const quality::Topology& found) {
    std::string text;
    for (std::size_t k = 0; k < found.faces.size(); ++k) {
      const std::string noun = report::simplices_noun(static_cast<int>(k), found.faces[k]);
      text += fmt::format("{}{} {}", k == 0 ? "faces: " : ", ", found.faces[k], noun);
    }
    if (text.empty()) return;
    tell(fmt::format("{}, euler-characteristic {}\n", text, found.euler_characteristic));
  }

  void add_sizes() {
    const int dimension = quality::dimension_of_simplices(mesh_);
    if (dimension < 1 || dimension > 3) return;
    output_.begin("measuring " + loaded_.name);
    constexpr std::string_view kWords[] = {"", "length", "area", "volume"};
    const auto add = [&](const std::string& name, const quality::Size& size) {
      const std::string exact = size.exact ? to_string(*size.exact) : "";
      const bool is_short = !exact.empty() && exact.size() <= 60 && exact != size.decimal;
      tell(fmt::format(
          "{}: {}{}\n", name, is_short ? exact + " ~ " : "",
          (size.exact && exact == size.decimal) || is_short ? size.decimal : "~ " + size.decimal));
      report::Json json = {{"decimal", size.decimal}};
      if (size.exact) json["exact"] = exact;
      know({{name, json}});
    };
    add(std::string(kWords[dimension]), quality::size_of(mesh_));
    if (dimension == 1) return;
    add(fmt::format("boundary-{}", kWords[dimension - 1]), quality::size_of_boundary(mesh_));
  }

  void add_quality() {
    output_.begin("measuring the simplices of " + loaded_.name);
    const quality::Survey found =
        quality::survey(mesh_, std::max(1U, std::thread::hardware_concurrency()));
    if (found.set_apart > 0) {
      tell(fmt::format("measured: {} set apart, flat or no simplices\n",
                       report::counted_simplices(found.set_apart, found.dimension)));
    }
    report::Json extremes = report::Json::array();
    for (const quality::Extreme& extreme : found.extremes) extremes.push_back(told(extreme));
    report::Json histograms = report::Json::array();
    for (const quality::Histogram& histogram : found.histograms) {
      if (found.measured > 0) tell(bars(histogram));
      histograms.push_back(json_of(histogram));
    }
    facts_.histograms = histograms;
    know({{"set_apart", found.set_apart}, {"extremes", extremes}, {"histograms", histograms}});
  }

  // Tells an extreme, keeps a card of it, and returns it as JSON.
  report::Json told(const quality::Extreme& extreme) {
    const Simplex simplex = mesh_.simplices[extreme.simplex];
    Witness witness = quality::witness_of(extreme.measure, extreme.found, simplex, extreme.simplex);
    const std::string value = measure_text(extreme.measure, extreme.found.value);
    std::string where = "simplex " + report::joined(mesh_.listed(simplex, extreme.simplex));
    if (witness.face) where += " face " + report::labels(mesh_, *witness.face);
    if (!witness.vertices.empty()) where += " vertex " + report::labels(mesh_, witness.vertices);
    const std::string name = quantity(extreme);
    tell(fmt::format("{}: {} {}\n", name, value, where));
    report::Json json = {{"quantity", name}, {"text", value}};
    json["value"] = report::value(extreme.found.value);
    json.update(report::witness(witness, mesh_));
    if (page_ != nullptr) {
      facts_.cards.emplace_back(
          report::Json{{"meaning", fmt::format("{}: {}", name, value)},
                       {"caption", fmt::format("The {} is {}, of {}.", name, value, where)}},
          std::move(witness));
    }
    return json;
  }

  void tell(const std::string& text) {
    output_.text(text);
    if (page_ != nullptr) facts_.text += text;
  }

  void know(const report::Json& more) {
    known_.update(more);
    output_.know(known_);
  }

  const LoadedMesh& loaded_;
  const Mesh& mesh_;
  const std::vector<std::string>& only_;
  Output& output_;
  picture::Page* page_;
  picture::Facts facts_ = {};
  std::string summary_ = {};
  report::Json known_ = report::Json::object();
};

}  // namespace

bool is_mesh_file(const std::string& path) {
  const std::string end = formats::extension_inside(path);
  return end == ".ele" || end == ".tet" || end == ".npz" || end == ".qhull-i" || end == ".foam";
}

std::vector<std::string> mesh_facts() {
  return {std::string(kTopology), std::string(kSize), std::string(kQuality)};
}

void inspect_mesh(const std::string& path, const InputOptions& input,
                  const std::vector<std::string>& only, Output& output, picture::Page* page) {
  output.begin("reading " + path);
  auto loaded = load_mesh(path, input);
  if (!loaded) {
    output.error(ExitCode::kInputFault, "mesh", path, loaded.error());
    return;
  }
  if (loaded->mesh.simplices.empty()) {
    output.error(ExitCode::kInputFault, "mesh", path,
                 path + ": expected a mesh with simplices, found none");
    return;
  }
  if (input.duplicates == Duplicates::kMerge) settle_equal_points(*loaded, input.duplicates);
  output.notes(loaded->notes);
  InspectedMesh(*loaded, only, output, page).run();
}

}  // namespace circumspect::cli
