#include "command/options/domain_options.hpp"

#include <map>

#include <fmt/format.h>

#include "command/options/one_of.hpp"
#include "command/options/usage_faults.hpp"
#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"

namespace circumspect::cli {
namespace {

const std::string kMerge = "--merge-coplanar";
constexpr std::string_view kUnit = "deg";

// Degrees as slopes: π/180, as a decimal that is taken at its word. For angles this small the
// tangent and the angle are the same up to a quarter of a percent, and this definition is exact.
const Rational kSlopeOfDegree(to_integer(17453292519943295), to_integer(1000000000000000000));
constexpr long kMostDegrees = 5;

bool ends_in_unit(std::string_view text) {
  return text.size() > kUnit.size() && text.substr(text.size() - kUnit.size()) == kUnit;
}

bool is_number(std::string_view text) {
  return read_number(text, NumberReading::kDecimal).has_value();
}

// What a user means as an angle, whether it is one or not: a number, with a unit of angles or
// without.
bool looks_like_an_angle(std::string_view text) {
  if (is_number(text)) return true;
  for (const std::string_view unit : {"deg", "degree", "degrees", "\u00b0", "rad", "radians"}) {
    if (text.ends_with(unit) && is_number(text.substr(0, text.size() - unit.size()))) return true;
  }
  return false;
}

// Empty, or what is wrong with the text.
std::string read_angle(const std::string& text, Rational& slope) {
  if (ends_in_unit(text)) {
    const auto degrees =
        read_number(text.substr(0, text.size() - kUnit.size()), NumberReading::kDecimal);
    if (degrees && sign(*degrees) > 0 && *degrees <= kMostDegrees) {
      slope = *degrees * kSlopeOfDegree;
      return "";
    }
  }
  if (const auto number = read_number(text, NumberReading::kDecimal); number) {
    return fmt::format(
        "expected an angle with its unit, such as {}deg, found {}; a file of that name is ./{}",
        sign(*number) > 0 && *number <= kMostDegrees ? text : "0.1", text, text);
  }
  return fmt::format(
      "expected nothing, for polygons that are in one plane exactly, or an angle of more than 0deg "
      "and at most {}deg, such as 0.1deg, found {}",
      kMostDegrees, text);
}

void add_points(CLI::App& command, const std::string& name, std::vector<Point>& points,
                const std::string& about) {
  const auto read = [name, &points](const CLI::results_t& texts) {
    points.clear();
    for (const std::string& text : texts) {
      Point point;
      bool is_read = true;
      for (const std::string& word : CLI::detail::split(text, ',')) {
        const auto number = read_number(word, NumberReading::kDecimal);
        is_read = is_read && number.has_value();
        if (number) point.push_back(*number);
      }
      if (!is_read || point.size() < 2 || point.size() > 3) {
        throw CLI::ValidationError(
            name, "expected a point, as 1,2.5,1/3 or in the plane 1,2.5, found " + text);
      }
      points.push_back(std::move(point));
    }
    return true;
  };
  command.add_option(name, read, about)
      ->type_size(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->option_text("X,Y,Z");
}

void add_merge_option(CLI::App& command, DomainOptions& options, bool takes_angle) {
  const auto read = [&options](const CLI::results_t& texts) {
    options.merged_slope = Rational(0);
    if (texts.front() == "true") return true;
    const std::string fault = read_angle(texts.front(), *options.merged_slope);
    if (!fault.empty()) throw CLI::ValidationError(kMerge, fault);
    return true;
  };
  const std::string with_angle =
      takes_angle
          ? ". With an ANGLE of at most 5deg, such as 0.1deg, also join polygons whose planes "
            "differ by at most that angle, if their vertices are within the DISTANCE of --within "
            "of one plane"
          : "";
  const auto reader = takes_angle ? CLI::callback_t(read) : [read](const CLI::results_t& texts) {
    if (texts.front() != "true") {
      throw CLI::ValidationError(kMerge, "expected no angle, found " + texts.front() +
                                             ": circumspect check takes one, with --within");
    }
    return read(texts);
  };
  CLI::Option* const merge =
      command
          .add_option(
              kMerge, reader,
              "Join polygons that share a segment and lie in one plane, as tetgen -p does. The "
              "mesh need not have the segments between them, unless the file lists these as "
              "segments" +
                  with_angle)
          ->expected(0)
          ->type_name("ANGLE")  // it is not a flag
          ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  if (takes_angle) merge->option_text("[ANGLE]");
}

}  // namespace

const Rational& slope_of_degree() { return kSlopeOfDegree; }

void add_domain_options(CLI::App& command, DomainOptions& options, bool takes_angle) {
  const std::map<std::string, Fill> fills = {{"enclosed", Fill::kEnclosed},
                                             {"even-odd", Fill::kEvenOdd},
                                             {"winding", Fill::kWinding},
                                             {"hull", Fill::kHull}};
  command
      .add_option(
          "--fill,--domain-kind", options.fill,
          "Say which part of space the domain fills. Its walls are its polygons, in the plane "
          "its segments. 'enclosed': all that the walls enclose. 'even-odd': the part of it that "
          "a path from outside enters through an odd number of walls, so that a sphere in a "
          "sphere is hollow. 'winding': the part that the walls wind around, in the orientation "
          "in which they are listed. 'hull': the convex hull of the points, which must not all "
          "lie in one plane. The default is 'enclosed' if the walls enclose something, and "
          "'hull' if there are no walls. If the walls enclose nothing, check and build need this "
          "option, unless all points lie in one plane. With 'enclosed' they then mesh the walls "
          "and fill nothing")
      ->transform(one_of(fills))
      ->option_text("enclosed|even-odd|winding|hull");
  add_points(command, "--hole", options.holes,
             "A point in a hole: the enclosed region around it is not filled. May be given several "
             "times. The holes in the file remain");
  add_points(command, "--region", options.regions,
             "A point in a region to fill: enclosed regions without such a point are not filled. "
             "May be given several times");
  command.add_flag(
      "--resolve", options.resolves,
      "Take segments that cross, touch, overlap or are repeated, and equal vertices, for "
      "their exact arrangement: where they meet is a vertex. Polygons that cross remain "
      "a fault");
  add_merge_option(command, options, takes_angle);
}

std::string domain_options_fault(const DomainOptions& options) {
  if (options.regions.empty() || !options.fill || *options.fill == Fill::kEnclosed) return "";
  return fmt::format(
      "expected --region alone or beside --fill enclosed, found it beside --fill {}: the regions "
      "say what is filled",
      name(*options.fill));
}

std::string domain_options_fault(const DomainOptions& options, std::optional<Claim> claim,
                                 bool has_domain) {
  const bool about_domain = claim && is_about_a_domain(*claim);
  const std::string_view said = claim ? name(*claim) : "";
  return first_fault(
      {{about_domain && !has_domain,
        fmt::format("expected --domain FILE for the claim {}, found none", said)},
       {claim && !about_domain && has_domain,
        fmt::format("expected no --domain for the claim {}, found one", said)},
       dependence({options.is_given(), "--fill, --hole, --region, --resolve or --merge-coplanar"},
                  {has_domain, "--domain FILE"}),
       domain_options_fault(options)});
}

std::vector<std::string> with_angles_joined(int argc, char** argv) {
  std::vector<std::string> words;
  bool is_ours = true;  // behind -- stands the command line of another program
  for (int i = 1; i < argc; ++i) {
    const std::string_view text = argv[i];
    is_ours = is_ours && text != "--";
    if (is_ours && !words.empty() && words.back() == kMerge && looks_like_an_angle(text)) {
      words.back() += "=" + std::string(text);
    } else {
      words.emplace_back(text);
    }
  }
  return words;
}

}  // namespace circumspect::cli
