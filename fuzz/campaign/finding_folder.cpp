#include "fuzz/campaign/finding_folder.hpp"

#include <cctype>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <set>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/utsname.h>
#include <unistd.h>

#include "fuzz/campaign/by_hand_script.hpp"
#include "fuzz/campaign/judge_mesh.hpp"
#include "fuzz/process/folders.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/bytes/unfinished_file.hpp"
#include "oracle/formats/domain_file.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/plane.hpp"
#include "oracle/formats/read_domain.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::campaign {
namespace {

namespace fs = std::filesystem;

// The format in which Circumspect itself reads inputs.
std::string own_extension(const Input& input) {
  return std::holds_alternative<ComplexCase>(input) ? ".poly" : ".node";
}

// Writes the file whole or not at all, and to the disk.
void write_durably(const std::string& path, const std::string& text) {
  const int reason = formats::write_whole_file(path, text);
  if (reason != 0) throw std::system_error(reason, std::generic_category(), path);
}

// Makes a folder in an existing one. A link or a file in its place is not a folder, wherever it
// leads.
void make_folder(const std::string& path) {
  if (mkdir(path.c_str(), 0777) == 0 || (errno == EEXIST && is_folder(path))) return;
  throw std::system_error(errno == EEXIST ? ENOTDIR : errno, std::generic_category(), path);
}

// A folder that the journal does not name was begun when this process, or an earlier one, was
// killed, and holds at most an input. Anything else in it belongs to someone else, and is not
// touched.
void expect_ours(const std::string& folder) {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().stem() == "input") continue;
    throw std::system_error(EEXIST, std::generic_category(),
                            folder +
                                ": expected no folder of this name, for the journal does not "
                                "name it; choose another --output, or move it away");
  }
}

void write_input_as(const std::string& stem, const Subject& subject, const Input& input) {
  std::set<std::string> extensions = {own_extension(input)};
  extensions.insert(formats::extension(subject.input_name));
  for (const std::string& extension : extensions) {
    const auto text = file_text(input, extension, subject.first_index, subject.dimension);
    if (text) write_durably(stem + extension, *text);
  }
}

// Files beyond this many bytes, and beyond this many, are left out of a finding.
constexpr std::uintmax_t kLargestCopy = 1 << 20;
constexpr std::size_t kMostCopies = 100;

// Files that cannot be read completely are left out, too.
void copy_file(const std::string& from, const std::string& to, const Runner& runner) {
  const formats::Result<formats::Source> source = formats::load(from);
  if (source) write_durably(to, runner.without_places(source->text));
}

// The files that the program wrote, without its input.
void copy_output(const std::string& folder, const Subject& subject, const Runner& runner) {
  std::error_code error;
  removed(folder + "/output");
  make_folder(folder + "/output");
  std::vector<std::string> paths;
  fs::directory_iterator entry(runner.work_folder(), error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    if (entry->path().filename() != subject.input_name) paths.push_back(entry->path().string());
    if (paths.size() >= kMostCopies) break;
  }
  if (subject.writes_stdout && !runner.mesh_file().empty()) paths.push_back(runner.mesh_file());
  for (const std::string& path : paths) {
    const bool is_small = fs::is_regular_file(fs::symlink_status(path, error)) &&
                          fs::file_size(path, error) <= kLargestCopy;
    if (is_small) copy_file(path, folder + "/output/" + fs::path(path).filename().string(), runner);
  }
}

// The scripts that the command names, such as an adapter, for who does not have them.
void copy_adapters(const std::string& folder, const Subject& subject) {
  std::error_code error;
  for (const std::string& argument : subject.command) {
    if (!argument.starts_with('/') || !fs::is_regular_file(argument, error)) continue;
    if (fs::file_size(argument, error) > kLargestCopy) continue;
    const formats::Result<formats::Source> source = formats::load(argument);
    if (!source || source->text.find('\0') != std::string::npos) continue;  // a program, no script
    make_folder(folder + "/adapter");
    write_durably(folder + "/adapter/" + fs::path(argument).filename().string(), source->text);
  }
}

std::string count_of(const Input& input) {
  const std::size_t count = point_count(input);
  return report::counted(count, "point");
}

report::Json verdict_document(const Subject& subject, const Origin& origin, const Input& found,
                              const Input& minimal, const Outcome& outcome) {
  report::Json finding = {
      {"signature", outcome.signature}, {"kind", word(outcome.kind)},
      {"text", outcome.text},           {"command", subject.command},
      {"claim", name(subject.claim)},   {"seed", origin.seed},
      {"case", origin.case_number},     {"family", origin.family},
      {"points", point_count(found)},   {"minimal_points", point_count(minimal)}};
  if (outcome.kind == OutcomeKind::kFails) finding["verdict"] = outcome.verdict;
  return {{"circumspect", 1}, {"results", report::Json::array({finding})}};
}

std::string readme(const Subject& subject, const Origin& origin, const Input& found,
                   const Input& minimal, const Outcome& outcome) {
  const std::string own = own_extension(minimal);
  return fmt::format(
      "{}\n{}\n\n"
      "The program:  {}\n"
      "The claim:    {}\n"
      "Found by:     seed {}, case {}, family {}\n\n"
      "input{}     the input with which it was found, {}\n"
      "minimal{}   a small input with the same failure, {}\n"
      "output/        what the program wrote for the small one\n"
      "said.txt       and what it said\n"
      "adapter/       the scripts that its command names, if there are any\n"
      "verdict.json   the verdict, with exact witnesses\n"
      "reproduce.sh   runs the program on the small one and judges what it writes\n"
      "by-hand.py     shows what is wrong by rational arithmetic alone, if that is possible\n"
      "versions.txt   of the program, as far as --about says, and of the machine\n"
      "issue.md       for the authors of the program; picture.svg is its picture, if it has one\n\n"
      "{}{}{}",
      outcome.signature, outcome.text, on_one_line(command_line(subject)), name(subject.claim),
      origin.seed, origin.case_number, origin.family, own, count_of(found), own, count_of(minimal),
      outcome.image ? "image" + own + "     the small one changed, with which it fails\n\n" : "",
      subject.is_untidy ? "arranged.poly  what has to be meshed: cut where segments meet\n\n" : "",
      outcome.explanation);
}

// What whoever tries the finding ought to have, too.
std::string versions(const Subject& subject) {
  utsname system = {};
  uname(&system);
  return fmt::format("program: {}\nabout:   {}\nsystem:  {} {} {}\n",
                     on_one_line(command_line(subject)),
                     subject.about.empty() ? "not said (--about)" : on_one_line(subject.about),
                     system.sysname, system.release, system.machine);
}

// The points as literals in the worker's language, which the name of one of its files tells;
// otherwise one on a line.
std::string snippet(const Subject& subject, const PointsCase& set) {
  std::string opening = "points = [";
  std::string closing = "]";
  bool is_code = false;
  for (const std::string& argument : subject.command) {
    const std::string extension = fs::path(argument).extension().string();
    if (extension == ".js" || extension == ".mjs") opening = "const points = [", closing = "];";
    is_code = is_code || extension == ".js" || extension == ".mjs" || extension == ".py" ||
              extension == ".jl";
  }
  std::string text = is_code ? opening + "\n" : "";
  for (const Point& point : set.points) {
    std::string row = formats::joined(point);
    if (is_code) replace_all(row, " ", ", ");
    text += is_code ? "  [" + row + "],\n" : row + "\n";
  }
  return text + (is_code ? closing + "\n" : "");
}

// The files of the input with which it fails.
std::string stem_of(const Outcome& outcome) { return outcome.image ? "image" : "minimal"; }

// What can be sent to the authors of the program.
std::string issue(const Subject& subject, const Input& minimal, const Outcome& outcome,
                  bool has_picture) {
  const Input& shown = outcome.image ? *outcome.image : minimal;
  const bool comes_and_goes = std::holds_alternative<UpdatesCase>(minimal);
  const std::string own =
      stem_of(outcome) + (comes_and_goes ? std::string(".case") : own_extension(minimal));
  const bool is_domain = std::holds_alternative<ComplexCase>(shown);
  constexpr std::size_t kLongestInput = 20000;
  std::string input = "The domain is in `" + own + "`.\n";
  const std::string domain =
      is_domain ? file_text(shown, own_extension(shown), subject.first_index, subject.dimension)
                      .value_or("")
                : "";
  if (!domain.empty() && domain.size() <= kLongestInput) {
    input = "The domain, which is in `" + own + "`, too: its points, its " +
            (subject.dimension == 2 ? "segments" : "polygons") +
            ", and its hole seeds, with the number of each.\n\n```\n" + domain + "```\n";
  }
  if (const auto* const set = std::get_if<PointsCase>(&shown)) {
    input = "```\n" + snippet(subject, *set) + "```\n";
  } else if (comes_and_goes) {
    input =
        "A line of counts, the points of the beginning, then what happens to them. `delete` names "
        "a "
        "point by its\nplace among those that are there, from 0.\n\n```\n" +
        file_text(minimal, ".case", 0, subject.dimension).value_or("") + "```\n";
  }
  const std::string by_hand =
      subject.talk ? fmt::format("By hand: `{} < {}.case`, whose first line counts the points.\n",
                                 on_one_line(command_line(subject)), stem_of(outcome))
                   : "";
  return fmt::format(
      "# {0}\n\n{1}\n\n"
      "Version: {9}\n\n"
      "Command: `{2}`\n\n"
      "Claim: {3}, judged in exact arithmetic.\n\n"
      "What is promised: {10}\n\n"
      "## Input, {4}\n\n{5}\n"
      "## What is wrong, exactly\n\n```\n{6}```\n\n{11}"
      "## To see it again\n\n"
      "`reproduce.sh` runs the program on `{7}` and judges what it writes; `reproduce.sh "
      "page.html` also shows\n"
      "the witnesses as pictures. {8}",
      outcome.signature, outcome.text, on_one_line(command_line(subject)), name(subject.claim),
      count_of(minimal), input, outcome.explanation, own, by_hand,
      subject.about.empty() ? "to be added (`--about`)" : on_one_line(subject.about),
      subject.promise.empty() ? "to be added (`--promise`)" : on_one_line(subject.promise),
      has_picture ? "![The first witness](picture.svg)\n\n" : "");
}

// "$(printf 'a\012b')": a word that has control characters but shows none. The shell removes line
// ends at the end of the output.
std::string printed_by_shell(const std::string& text) {
  const std::size_t end = text.find_last_not_of('\n') + 1;
  std::string word = "\"$(printf '";
  for (const char c : std::string_view(text).substr(0, end)) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
    word += is_plain
                ? std::string(1, c)
                : fmt::format("\\{:03o}", static_cast<unsigned>(static_cast<unsigned char>(c)));
  }
  return word + "')\"" + (end < text.size() ? "'" + text.substr(end) + "'" : "");
}

// The name of a file in the script's folder, in a form that no program takes for an option.
std::string in_folder(const std::string& name) { return name[0] == '-' ? "./" + name : name; }

std::string check_line(const Subject& subject, const Input& minimal, const std::string& stem) {
  std::string line = "\"$circumspect\" check " + quoted_for_shell(in_folder(subject.mesh_name)) +
                     " --claim " + std::string(name(subject.claim));
  if (subject.is_about_domains()) {
    return line + " --domain \"$here/" + (subject.is_untidy ? "arranged" : stem) +
           ".poly\" --fill " + std::string(name(subject.fill)) +
           (subject.merges_coplanar ? " --merge-coplanar" : "");
  }
  const std::string extension = formats::extension(subject.mesh_name);
  const bool is_diagram = subject.claim == Claim::kVoronoi;
  if (extension == ".ele" || extension == ".qhull-i" || is_diagram)
    line += " --points \"$here/" + stem + ".node\"";
  if (is_diagram && sign(subject.within) > 0) {
    line += " --within " + to_string(subject.within) + (subject.is_within_relative ? "x" : "");
  }
  const std::vector<Point> points = judged_points(minimal)->points;
  const bool repeats = std::set<Point>(points.begin(), points.end()).size() < points.size();
  return line + (repeats ? " --duplicates merge" : "");
}

// Whether a script was given the name of a file.
constexpr const char* kPage = " ${page:+--html \"$page\"}";

}  // namespace

std::string findings_folder(const std::string& output) {
  return fs::path(output + "/.").parent_path().filename() == "findings" ? output
                                                                        : output + "/findings";
}

std::string finding_folder(const std::string& output, const std::string& signature) {
  return findings_folder(output) + "/" + signature;
}

void write_input(const std::string& folder, const Subject& subject, const Input& input) {
  make_folder(fs::path(folder).parent_path().string());
  make_folder(folder);
  expect_ours(folder);
  write_input_as(folder + "/input", subject, input);
  for (const std::string& path : {folder, fs::path(folder).parent_path().string()}) {
    const int directory = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (directory < 0) continue;
    fsync(directory);
    close(directory);
  }
}

void write_minimal(const std::string& folder, const Subject& subject, const Origin& origin,
                   const Input& found, const Input& minimal, const Outcome& outcome,
                   const Runner& runner) {
  write_input_as(folder + "/minimal", subject, minimal);
  if (outcome.image) write_input_as(folder + "/image", subject, *outcome.image);
  if (subject.is_untidy) {
    const auto& whole = std::get<ComplexCase>(outcome.image ? *outcome.image : minimal);
    write_durably(folder + "/arranged.poly",
                  file_text(tidy(subject, whole), ".poly", subject.first_index, subject.dimension)
                      .value_or(""));
  }
  copy_output(folder, subject, runner);
  copy_adapters(folder, subject);
  write_durably(folder + "/said.txt", on_lines(runner.said()));
  const report::Json document = verdict_document(subject, origin, found, minimal, outcome);
  write_durably(folder + "/verdict.json", report::document_text(document));
  write_durably(folder + "/README.txt", readme(subject, origin, found, minimal, outcome));
  const std::string picture = witness_picture(outcome.verdict);
  const std::string by_hand = by_hand_script(outcome.verdict);
  removed(folder + "/by-hand.py");
  removed(folder + "/picture.svg");  // both of the previous minimal input
  if (!by_hand.empty()) write_durably(folder + "/by-hand.py", by_hand);
  write_durably(folder + "/versions.txt", versions(subject));
  if (!picture.empty()) write_durably(folder + "/picture.svg", picture);
  write_durably(folder + "/issue.md", issue(subject, minimal, outcome, !picture.empty()));
  write_durably(folder + "/reproduce.sh", reproduction(subject, minimal, outcome));
  fs::permissions(folder + "/reproduce.sh", fs::perms::owner_exec, fs::perm_options::add);
}

bool holds_files_alone(const std::string& folder) {
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const fs::file_status status = entry->symlink_status(error);
    const std::string path = entry->path().string();
    const bool is_plain =
        fs::is_directory(status) ? holds_files_alone(path) : fs::is_regular_file(status);
    if (error || !is_plain) return false;
  }
  return !error;
}

std::optional<Input> read_minimal(const std::string& folder, const Subject& subject) {
  if (!holds_files_alone(folder)) return std::nullopt;
  if (subject.is_about_domains()) {
    auto domain = formats::read_domain(folder + "/minimal.poly", NumberReading::kDouble);
    if (!domain) return std::nullopt;
    *domain = formats::of_dimension(std::move(*domain), subject.dimension);
    return Input(ComplexCase{"minimal", std::move(domain->input)});
  }
  if (!subject.updates.empty()) {
    std::ostringstream text;
    text << std::ifstream(folder + "/minimal.case", std::ios::binary).rdbuf();
    auto whole = read_updates(text.str());
    if (!whole) return std::nullopt;
    return Input(std::move(*whole));
  }
  auto raw = formats::read_points(folder + "/minimal.node", NumberReading::kDouble);
  if (!raw) return std::nullopt;
  PointsCase set{raw->points.points.points(), {}};
  for (const std::vector<Rational>& attributes : raw->points.attributes) {
    if (!attributes.empty()) set.weights.push_back(attributes.front());
  }
  return Input(std::move(set));
}

std::string quoted_for_shell(const std::string& text) {
  const bool plain = !text.empty() && text.find_first_not_of(
                                          "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                          "0123456789_-+./=:,@%") == std::string::npos;
  if (plain) return text;
  if (on_one_line(text) != text) return printed_by_shell(text);
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string command_line(const Subject& subject) {
  std::string line;
  for (const std::string& argument : subject.command) {
    line += (line.empty() ? "" : " ") + quoted_for_shell(argument);
  }
  return line;
}

std::string reproduction(const Subject& subject, const Input& minimal, const Outcome& outcome) {
  // The paths in the arguments are in the folder that the script makes, so names without a folder
  // suffice.
  Subject own = subject;
  own.command =
      filled_in(subject, {".", in_folder(subject.input_name), in_folder(subject.mesh_name)});
  const std::string extension = formats::extension(subject.input_name);
  const std::string stem = stem_of(outcome);
  std::string limit;
  if (subject.limits.memory != 0) {
    limit = fmt::format("ulimit -v {}; ", subject.limits.memory / 1024);
  }
  std::string run = fmt::format(
      "({}exec timeout -s KILL {} {}{}{})", limit, subject.limits.seconds, command_line(own),
      subject.reads_stdin ? " < " + quoted_for_shell(subject.input_name) : "",
      subject.writes_stdout ? " > " + quoted_for_shell(subject.mesh_name) : "");
  return fmt::format(
      "#!/bin/sh\n"
      "# Shows {} again: runs the program on the small input beside this script in a\n"
      "# folder of its own, and judges what it writes. Exit code 0 would mean that all is well.\n"
      "# The name of a file after it: a page with pictures of the witnesses is written there.\n"
      "here=$(cd \"$(dirname \"$0\")\" && pwd) || exit 2\n"
      "page=${{1:+$(realpath -- \"$1\")}} || exit 2\n"
      "folder=$(mktemp -d) || exit 2\n"
      "trap 'rm -rf \"$folder\"' EXIT\n"
      "cd \"$folder\" || exit 2\n"
      "cp \"$here/{}{}\" {}\n"
      "{}\n"
      "code=$?\n"
      "if [ $code -ne 0 ]; then echo \"the program ended with exit code $code\"; exit $code; fi\n"
      "circumspect=${{CIRCUMSPECT:-circumspect}}\n"
      "if ! command -v \"$circumspect\" > /dev/null; then\n"
      "  echo \"The program has written what follows. To judge it, put circumspect into PATH, or "
      "its\" >&2\n"
      "  echo \"path into CIRCUMSPECT; verdict.json says what was wrong with it.\" >&2\n"
      "  cat {}\n"
      "  exit 2\n"
      "fi\n"
      "{}\n",
      outcome.signature, stem, extension, quoted_for_shell(in_folder(subject.input_name)), run,
      quoted_for_shell(in_folder(subject.mesh_name)),
      check_line(subject, outcome.image ? *outcome.image : minimal, stem) + kPage);
}

}  // namespace circumspect::campaign
