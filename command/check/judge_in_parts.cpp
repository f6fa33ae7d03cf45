#include "command/check/judge_in_parts.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <malloc.h>

#include "command/input/input.hpp"
#include "oracle/distributed/judge.hpp"
#include "oracle/distributed/slices.hpp"
#include "oracle/distributed/turns.hpp"
#include "oracle/formats/npy.hpp"

namespace circumspect::cli {

namespace {

constexpr std::uint64_t kMega = std::uint64_t{1} << 20;
constexpr std::uint64_t kLeastMemory = 64 * kMega;
constexpr std::uint64_t kProgram = 32 * kMega;  // of it, what the command takes with any mesh
constexpr std::uint64_t kSimplex = 80;  // bytes that a part takes for a simplex, at most at a time

// Bytes, as "2G" says them; nothing for other words.
std::optional<std::uint64_t> bytes_said(const std::string& text) {
  constexpr std::string_view kUnits = "KMGT";
  std::uint64_t bytes = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, bytes);
  if (read.ec != std::errc()) return std::nullopt;
  if (read.ptr == end) return bytes;
  const std::size_t unit = kUnits.find(*read.ptr);
  const unsigned shift = 10 * (static_cast<unsigned>(unit) + 1);
  const bool fits = unit != kUnits.npos && read.ptr + 1 == end && bytes >> (63 - shift) == 0;
  return fits ? std::optional(bytes << shift) : std::nullopt;
}

// How many simplices there are, about. What the file is is said when it is read.
std::uint64_t expected_simplices(const std::string& mesh) {
  const auto file = formats::RandomAccess::open(mesh);
  if (!file) return 0;
  if (formats::extension(mesh) == ".npy") {
    const auto header = formats::read_npy_header(*file, mesh);
    return header && !header->shape.empty() ? std::min(header->shape.front(), file->size()) : 0;
  }
  constexpr std::size_t kShortestRow = 10;
  return file->size() / kShortestRow;
}

std::string folder_for_parts() {
  const char* const said = std::getenv("TMPDIR");
  return said == nullptr || *said == '\0' ? "/var/tmp" : said;
}

}  // namespace

void add_memory_option(CLI::App& command, std::optional<std::uint64_t>& bytes) {
  const auto read = [](std::string& text) -> std::string {
    const auto said = bytes_said(text);
    if (said && *said >= kLeastMemory) {
      text = std::to_string(*said);
      return "";
    }
    return fmt::format("expected a size of at least {}M, such as 500M or 2G, found {}",
                       kLeastMemory / kMega, text);
  };
  command
      .add_option(
          "--memory", bytes,
          "Use about SIZE of memory, such as 500M or 2G: judge the mesh part by part, and keep "
          "the other parts in files in TMPDIR (or /var/tmp). For .npy and .ele, and claims about "
          "points")
      ->transform(CLI::Validator(read, ""))
      ->option_text("SIZE");
}

tl::expected<JudgedInParts, NotJudged> judge_in_parts(Claim claim, const std::string& mesh,
                                                      const std::optional<std::string>& points,
                                                      std::uint64_t memory,
                                                      const check::Options& options) {
  const auto fail = [](ExitCode code, std::string message) {
    return tl::unexpected(NotJudged{code, std::move(message)});
  };
  // Three fourths for simplices, and one for what is on its way.
  const std::uint64_t usable = memory - kProgram;
  const std::uint64_t threads = std::max(1U, options.threads);
  const std::uint64_t at_a_time = usable / 4 * 3 / threads / kSimplex;
  const std::uint64_t parts = expected_simplices(mesh) / at_a_time + 1;
  if (parts > kMostParts) {
    const std::uint64_t needed = memory / kMega * (parts / kMostParts + 1);
    return fail(ExitCode::kUsage,
                fmt::format("expected at least {}M for --memory, so that {} has no more than {} "
                            "parts, found {}M",
                            needed, mesh, kMostParts, memory / kMega));
  }
  // What a part gives back is there for the others, and if it is much, it goes back to the system.
  // Memory that goes back and forth costs more time than anything that is done with it.
  mallopt(M_ARENA_MAX, 1);
  mallopt(M_MMAP_THRESHOLD, static_cast<int>(std::min(usable / 64, 32 * kMega)));
  mallopt(M_TRIM_THRESHOLD, static_cast<int>(std::min(usable / 8, 1024 * kMega)));
  const distributed::Turns turns{.parts = static_cast<std::size_t>(parts),
                                 .at_once = static_cast<std::size_t>(threads),
                                 .room = static_cast<std::size_t>(usable / 4),
                                 .folder = folder_for_parts()};
  check::Options own = options;
  own.threads = static_cast<unsigned>(threads / std::min(threads, parts));
  std::optional<JudgedInParts> judged;
  std::string fault;
  try {
    in_turns(turns, [&](distributed::Ranks& ranks) {
      auto read = read_slices(
          ranks, {.mesh = mesh, .points = points, .weighted = claim == Claim::kWeightedDelaunay});
      if (!read) {
        if (ranks.is_first()) fault = read.error();
        return;
      }
      const Vertex first_index = read->dealt.first_index;
      auto found = distributed::judge(ranks, claim, std::move(read->dealt), own);
      if (!ranks.is_first()) return;
      if (found.equal.count > 0) {
        fault =
            read->points_name + ": " +
            fault_of_equal_points(found.equal, first_index,
                                  "leave out --memory and add --duplicates merge to the command");
        return;
      }
      judged = JudgedInParts{std::move(*found.verdict), std::move(found.named)};
    });
  } catch (const distributed::FileChanged& changed) {
    return fail(ExitCode::kInputFault, changed.what());
  } catch (const distributed::NoRoomOnDisk& full) {
    return fail(ExitCode::kInternalError, full.what());
  }
  if (!fault.empty()) return fail(ExitCode::kInputFault, std::move(fault));
  return std::move(*judged);
}

}  // namespace circumspect::cli
