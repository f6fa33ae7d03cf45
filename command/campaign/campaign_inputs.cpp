#include "command/campaign/campaign_inputs.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "command/generate/generate_list.hpp"
#include "command/input/domain_input.hpp"
#include "inputs/families.hpp"
#include "inputs/in_doubles.hpp"
#include "inputs/triangulated/domain_families.hpp"
#include "oracle/formats/domain_file.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/plane.hpp"
#include "oracle/formats/read_domain.hpp"

namespace circumspect::cli {
namespace {

using campaign::Source;
using generators::ComplexFamily;
using generators::Family;
using Sources = std::vector<Source>;

bool fits(const Family& family, const campaign::Subject& subject) {
  return family.exists_in(subject.dimension) &&
         family.weighted == (subject.claim == Claim::kWeightedDelaunay);
}

bool fits(const ComplexFamily& family, const campaign::Subject& subject) {
  return family.dimension == subject.dimension;
}

generators::Count count_of(const Sizes& sizes, std::size_t dimension, std::uint64_t seed) {
  if (sizes.max_points) return {*sizes.max_points};
  return generators::count_of_a_campaign(dimension, seed);
}

Source source_of(const Family& family, const campaign::Subject& subject, const Sizes& sizes) {
  return {family.name,
          [&family, dimension = subject.dimension, updates = subject.updates,
           sizes](std::uint64_t seed) -> campaign::Input {
            const bool repeats = family.repeats_points;
            generators::PointsCase set = generators::in_doubles(
                generators::drawn(family, dimension, count_of(sizes, dimension, seed), seed),
                repeats);
            if (sizes.integers) set = generators::in_integers(set, *sizes.integers, repeats);
            if (!sizes.extreme) set = generators::brought_within(set, sizes.exponents, repeats);
            if (updates.empty()) return set;
            generators::Dice dice(generators::mixed(seed));
            return generators::with_updates(dice, set, updates);
          }};
}

Source source_of(const ComplexFamily& family, const campaign::Subject&, const Sizes& sizes) {
  const std::size_t max_points = sizes.max_points.value_or(generators::kFewPoints);
  return {family.name,
          [&family, max_points, kinds = sizes.untidiness](std::uint64_t seed) -> campaign::Input {
            auto whole = generators::in_doubles(generators::drawn(family, max_points, seed));
            if (kinds.empty()) return whole;
            generators::Dice dice(generators::mixed(seed));
            return generators::untidied(dice, std::move(whole), kinds);
          }};
}

// All of a list that fit.
template <class AnyFamily>
Sources fitting(const std::vector<AnyFamily>& families, const campaign::Subject& subject,
                const Sizes& sizes) {
  Sources sources;
  for (const AnyFamily& family : families) {
    if (fits(family, subject)) sources.push_back(source_of(family, subject, sizes));
  }
  return sources;
}

// Those of these names; `find` gives a family or null.
template <class Find>
tl::expected<Sources, std::string> named(const std::vector<std::string>& names, const Find& find,
                                         const campaign::Subject& subject, const Sizes& sizes) {
  Sources sources;
  for (const std::string& name : names) {
    const auto* const family = find(name);
    if (family == nullptr) {
      const bool is_known = generators::find_family(name) != nullptr ||
                            properties::find_domain_family(name) != nullptr;
      return tl::unexpected(is_known
                                ? fmt::format("expected families of {} for the claim {}, found {}",
                                              subject.is_about_domains() ? "domains" : "points",
                                              circumspect::name(subject.claim), name)
                                : unknown_family(name));
    }
    if (!fits(*family, subject)) {
      return tl::unexpected(
          fmt::format("expected families of dimension {} for the claim {}, found {}",
                      subject.dimension, circumspect::name(subject.claim), name));
    }
    sources.push_back(source_of(*family, subject, sizes));
  }
  return sources;
}

// The domain of a file, if it is one of Definition 4.3 when its numbers are doubles.
tl::expected<campaign::Input, std::string> domain_input(const campaign::Subject& subject,
                                                        const std::string& path) {
  auto read = formats::read_domain(path, NumberReading::kDouble);
  if (!read) return tl::unexpected(read.error().to_string());
  formats::DomainFile file = formats::of_dimension(std::move(*read), subject.dimension);
  if (subject.is_untidy) {
    generators::ComplexCase whole{path, std::move(file.input)};
    return campaign::Input(generators::in_doubles(std::move(whole)));
  }
  // Polygons are joined for the judge, not for the program.
  auto loaded = load_domain(std::move(file), path, {}, DomainOptions{.fill = subject.fill});
  if (!loaded) return tl::unexpected(loaded.error().message);
  generators::ComplexCase whole{path, loaded->file.input};
  return campaign::Input(generators::in_doubles(std::move(whole)));
}

tl::expected<campaign::Input, std::string> points_input(const campaign::Subject& subject,
                                                        const std::string& path) {
  auto raw = formats::read_points(path, NumberReading::kDouble);
  if (!raw) return tl::unexpected(raw.error().to_string());
  generators::PointsCase set{raw->points.points.points(), {}};
  if (subject.claim == Claim::kWeightedDelaunay) {
    set.weights = std::move(raw->weights);
    if (set.weights.empty()) {
      for (const std::vector<Rational>& attributes : raw->points.attributes) {
        if (!attributes.empty()) set.weights.push_back(attributes.front());
      }
    }
    set.weights.resize(set.points.size());
  }
  return campaign::Input(generators::in_doubles(set, true));
}

tl::expected<campaign::Input, std::string> updates_input(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  auto whole = campaign::read_updates(text.str());
  if (!whole) {
    return tl::unexpected(path +
                          ": expected points and updates as workers read them (docs/workers.md), "
                          "found something else");
  }
  whole->set = generators::in_doubles(whole->set, true);
  return campaign::Input(std::move(*whole));
}

std::size_t dimension_of(const campaign::Input& input) {
  if (const auto* const set = std::get_if<generators::PointsCase>(&input)) {
    return set->points.empty() ? 0 : set->points.front().size();
  }
  if (const auto* const whole = std::get_if<generators::UpdatesCase>(&input)) {
    return whole->set.points.empty() ? 0 : whole->set.points.front().size();
  }
  return std::get<generators::ComplexCase>(input).input.points.front().size();
}

}  // namespace

std::string magnitudes(const Sizes& sizes) {
  if (sizes.extreme) return "extreme exponents";
  const std::string exponents =
      fmt::format("exponents {} to {}", sizes.exponents.least, sizes.exponents.largest);
  return exponents + (sizes.integers ? fmt::format(", integers of {} bits", *sizes.integers) : "");
}

tl::expected<Sources, std::string> campaign_sources(const campaign::Subject& subject,
                                                    const std::vector<std::string>& names,
                                                    const std::vector<std::string>& excluded,
                                                    const Sizes& sizes) {
  const bool everything = names == std::vector<std::string>{"all"};
  const auto chosen = [&]() -> tl::expected<Sources, std::string> {
    if (subject.is_about_domains()) {
      if (everything) return fitting(properties::modified_domain_families(), subject, sizes);
      if (names.empty()) return fitting(properties::domain_families(), subject, sizes);
      return named(names, properties::find_domain_family, subject, sizes);
    }
    if (everything) return fitting(generators::modified_families(), subject, sizes);
    if (names.empty()) return fitting(generators::families(), subject, sizes);
    return named(names, generators::find_family, subject, sizes);
  };
  auto sources = chosen();
  for (const std::string& name : excluded) {
    if (!sources) break;
    const bool is_known =
        generators::find_family(name) != nullptr || properties::find_domain_family(name) != nullptr;
    if (!is_known) return tl::unexpected(unknown_family(name));
    std::erase_if(*sources, [&](const Source& source) {
      return source.family == name || source.family.rfind(name + "+", 0) == 0;
    });
  }
  if (sources && sources->empty()) {
    return tl::unexpected(std::string("expected a family that is not excluded, found none"));
  }
  return sources;
}

tl::expected<campaign::Input, std::string> campaign_input(const campaign::Subject& subject,
                                                          const std::string& path) {
  auto input = subject.is_about_domains() ? domain_input(subject, path)
               : !subject.updates.empty() ? updates_input(path)
                                          : points_input(subject, path);
  if (!input) return input;
  const std::size_t dimension = dimension_of(*input);
  if (dimension != 0 && dimension != subject.dimension) {
    return tl::unexpected(
        fmt::format("{}: expected points of dimension {} (--dimension), found dimension {}", path,
                    subject.dimension, dimension));
  }
  return input;
}

tl::expected<std::vector<campaign::Replayed>, std::string> campaign_corpus(
    const campaign::Subject& subject, const std::string& folder) {
  namespace fs = std::filesystem;
  std::error_code error;
  std::vector<std::string> paths;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string path = entry->path().string();
    const std::string extension = formats::extension(path);
    const bool is_input = subject.is_about_domains() ? extension == ".poly" || extension == ".smesh"
                          : !subject.updates.empty()
                              ? extension == ".case"
                              : extension == ".node" || extension == ".qhull";
    if (is_input && entry->is_regular_file(error)) paths.push_back(path);
  }
  if (error) return tl::unexpected(fmt::format("{}: {}", folder, error.message()));
  std::sort(paths.begin(), paths.end());
  std::vector<campaign::Replayed> replayed;
  for (const std::string& path : paths) {
    auto input = campaign_input(subject, path);
    if (input) replayed.push_back({path, std::move(*input)});
  }
  if (replayed.empty()) {
    return tl::unexpected(fmt::format(
        "{}: expected inputs of dimension {} in its files, found none", folder, subject.dimension));
  }
  return replayed;
}

}  // namespace circumspect::cli
