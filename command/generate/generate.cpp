// circumspect generate FAMILY: random inputs for programs under test.
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command/generate/generate_list.hpp"
#include "command/options/one_of.hpp"
#include "command/options/option_rows.hpp"
#include "command/options/whole_number.hpp"
#include "command/output/output.hpp"
#include "command/subcommands.hpp"
#include "fuzz/campaign/domain_text.hpp"
#include "inputs/family_faults.hpp"
#include "inputs/in_doubles.hpp"
#include "inputs/triangulated/domain_families.hpp"
#include "oracle/formats/json.hpp"
#include "oracle/formats/tetgen.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/report/text.hpp"
#include "platform/files.hpp"

namespace circumspect::cli {
namespace {

struct GenerateOptions {
  std::string family;
  bool list = false;
  std::uint64_t seed = 0;
  std::size_t count = 1;
  std::size_t points = 12;
  std::optional<std::size_t> dimension = {};
  bool fewer = false;
  std::string coordinates = "double";
  std::string output_file;
  OutputOptions output;

  std::size_t dimension_or_space() const { return dimension.value_or(3); }
};

// One input, and how it is written.
struct Generated {
  std::size_t points = 0;
  std::string extension;
  std::function<void(std::ostream&)> write;       // as a file of that extension
  std::function<void(std::ostream&)> write_json;  // in our JSON; none for domains
};

using Draw = std::function<Generated(std::uint64_t seed)>;

formats::PointFile point_file(const generators::PointsCase& set, std::size_t dimension) {
  formats::PointFile file{dimension, set.points};
  for (const Rational& weight : set.weights) file.attributes.push_back({weight});
  return file;
}

Draw draw_points(const generators::Family& family, const GenerateOptions& options) {
  const std::size_t dimension = options.dimension_or_space();
  return [&options, &family, dimension](std::uint64_t seed) -> Generated {
    const generators::Count count{options.points, !options.fewer};
    generators::PointsCase set = generators::drawn(family, dimension, count, seed);
    if (options.coordinates == "double") set = generators::in_doubles(set, family.repeats_points);
    const std::size_t points = set.points.size();
    const auto write = [set, dimension](std::ostream& out) {
      formats::write_node(out, point_file(set, dimension));
    };
    return {points, ".node", write, [set, dimension](std::ostream& out) {
              formats::write_json(out, {{dimension, set.points}, set.weights});
            }};
  };
}

Draw draw_domains(const generators::ComplexFamily& family, const GenerateOptions& options) {
  return [&options, &family](std::uint64_t seed) -> Generated {
    generators::ComplexCase made = generators::drawn(family, options.points, seed);
    if (options.coordinates == "double") made = generators::in_doubles(made);
    const std::size_t count = made.input.points.size();
    return {count, ".poly",
            [made](std::ostream& out) {
              // At the end: some programs do not read files that begin with a comment.
              out << campaign::poly_text(made.input, 0) << "# " << made.family << "; --fill "
                  << (made.input.kind == DomainKind::kHull ? "hull" : "enclosed") << "\n";
            },
            nullptr};
  };
}

// How to draw what is asked for, or one line that says why nothing can be.
tl::expected<Draw, std::string> draw(const GenerateOptions& options) {
  if (const auto* family = generators::find_family(options.family)) {
    const std::size_t dimension = options.dimension_or_space();
    if (family->exists_in(dimension)) return draw_points(*family, options);
    return tl::unexpected(generators::no_sets_text(
        family->name, generators::dimensions_text(*family), static_cast<std::int64_t>(dimension)));
  }
  const auto* family = properties::find_domain_family(options.family);
  if (family == nullptr) return tl::unexpected(unknown_family(options.family));
  if (options.dimension.value_or(family->dimension) == family->dimension) {
    return draw_domains(*family, options);
  }
  return tl::unexpected(generators::no_sets_text(family->name, std::to_string(family->dimension),
                                                 static_cast<std::int64_t>(*options.dimension)));
}

bool is_json(const std::string& path) { return path.ends_with(".json"); }

// To stdout alone.
ExitCode print(const Draw& draw, const GenerateOptions& options) {
  if (options.count != 1) {
    return usage_error(fmt::format("expected -o FOLDER for {} inputs, found {}", options.count,
                                   options.output_file.empty() ? "none" : "-o -"));
  }
  const Generated input = draw(options.seed);
  const bool json = options.output.format == OutputFormat::kJson;
  if (json && !input.write_json) {
    return usage_error(
        fmt::format("expected points for --format json, found the domain family {}: our JSON has "
                    "no domains; leave --format out for a .poly file",
                    options.family));
  }
  const std::string failure = write_file("-", json ? input.write_json : input.write);
  if (failure.empty()) return ExitCode::kHolds;
  usage_error(failure);
  return ExitCode::kInternalError;
}

// To files: one, or one a seed in a folder.
void write(const Draw& draw, const GenerateOptions& options, Output& output) {
  std::string folder;
  if (options.count > 1 || formats::is_folder(options.output_file)) {
    std::error_code error;
    std::filesystem::create_directories(platform::path_of(options.output_file), error);
    folder = options.output_file;
    if (platform::kSeparators.find(folder.back()) == std::string::npos) folder += '/';
  }
  for (std::size_t i = 0; i < options.count; ++i) {
    const std::uint64_t seed = options.seed + i;
    const Generated input = draw(seed);
    const std::string path =
        folder.empty() ? options.output_file
                       : fmt::format("{}{}-{}{}", folder, options.family, seed, input.extension);
    const bool json = is_json(path) && input.write_json;
    const std::string failure = write_file(path, json ? input.write_json : input.write);
    if (!failure.empty()) {
      output.error(ExitCode::kUsage, "family", options.family, failure);
      return;
    }
    if (output.wants_text()) {
      output.text(fmt::format("generated: {} {} {} seed {}\n", options.family, on_one_line(path),
                              report::counted(input.points, "point"), seed));
    }
    output.json(
        {{"family", options.family}, {"seed", seed}, {"points", input.points}, {"output", path}});
  }
}

ExitCode run(const GenerateOptions& options) {
  Output output(options.output);
  if (options.list) {
    if (output.wants_text()) output.text(families_text());
    if (output.wants_json()) output.json(families_json());
    return output.finish();
  }
  if (options.family.empty()) {
    return usage_error("expected the name of a family or --list, found neither");
  }
  const auto drawing = draw(options);
  if (!drawing) {
    output.error(ExitCode::kUsage, "family", options.family, drawing.error());
    return output.finish();
  }
  if (options.output_file.empty() || options.output_file == "-") return print(*drawing, options);
  write(*drawing, options, output);
  return output.finish();
}

std::vector<OptionRow> rows_of(GenerateOptions& options) {
  return {
      {"family", "", into(options.family), "A family of points or domains; see --list"},
      {"--list", "", flag(options.list), "Print the table of families"},
      {"--seed", "N", into(options.seed, whole_number()),
       "The seed: the same seed gives the same bytes (default: 0)"},
      {"--count", "K", into(options.count, whole_number(1, 1'000'000'000)),
       "Draw K inputs, with the seeds N, N+1, ... (default: 1)"},
      {"--points", "N", into(options.points, whole_number(1, 1'000'000)),
       "Draw N points; equal ones count once; domains have about N (default: 12)"},
      {"--fewer", "", flag(options.fewer),
       "Draw any number of points up to that of --points, as campaigns do"},
      {"--dimension", "D", into(options.dimension, whole_number(1, formats::kLargestDimension)),
       "The dimension of the points (default: 3; domains have their own)"},
      {"--coordinates", "double|exact",
       into(options.coordinates, one_of_words({"double", "exact"})),
       "Write coordinates rounded to doubles ('double', default), or as they are, with fractions "
       "('exact')"},
      {"-o,--output", "OUT", into(options.output_file),
       "The file to write, or a folder if there is more than one input; - is stdout"}};
}

}  // namespace

void add_generate(CLI::App& app, ExitCode& exit_code) {
  const auto options = std::make_shared<GenerateOptions>();
  CLI::App* command = app.add_subcommand(
      "generate", "Draw random inputs that are degenerate, nearly degenerate or extreme");
  command->footer(
      "Example:\n"
      "  circumspect generate --list\n"
      "  circumspect generate sphere+ulp --seed 7 -o points.node\n"
      "  circumspect generate protected-solids --count 100 -o domains\n"
      "\n"
      "Points are written as a .node file, with weights as its attribute, and domains as a "
      ".poly file.\n"
      "Without -o they go to stdout; then --format json writes JSON (points only), as -o "
      "OUT.json does.\n"
      "In a folder the files are FAMILY-SEED.node and FAMILY-SEED.poly.\n"
      "\n"
      "Exit codes: 0 written, 2 usage, an unknown family, a family that does not exist in "
      "that\n"
      "dimension, or an output that cannot be written.");
  add_options(*command, rows_of(*options));
  add_output_options(*command, options->output);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace circumspect::cli
