#include "oracle/formats/included_files.hpp"

#include <algorithm>
#include <utility>

#include "oracle/formats/bytes/packed.hpp"
#include "platform/files.hpp"

namespace circumspect::formats {
namespace {

constexpr std::size_t kMostFiles = 1000;
constexpr std::size_t kDeepest = 20;
constexpr std::size_t kLongestPath = 300;

std::string folder_of(const std::string& path) {
  return path.substr(0, path.find_last_of(platform::kSeparators) + 1);
}

// Decks are written on other systems, too.
std::string with_slashes(std::string path) {
  std::replace(path.begin(), path.end(), '\\', '/');
  return path;
}

std::string quoted_path(const std::string& path) {
  return path.size() > kLongestPath ? quote(path) : "\"" + path + "\"";
}

bool are_same_file(const std::string& a, const std::string& b) {
  const auto one = platform::status_of(a);
  const auto other = platform::status_of(b);
  return one && other && one->device == other->device && one->number == other->number;
}

}  // namespace

Deck::Deck(const Source& first, InclusionAt inclusion_at, std::size_t most_repeated)
    : first_(first), most_repeated_(most_repeated) {
  TextLines lines(first);
  bool has_inclusion = false;
  while (!has_inclusion && lines.next()) has_inclusion = inclusion_at(lines).has_value();
  if (!has_inclusion) return;
  all_.name = first.name;
  append(first, inclusion_at);
}

void Deck::append_line(std::string_view line) {
  all_.text += line;
  all_.text += '\n';
  ++lines_;
}

void Deck::append(const Source& source, InclusionAt inclusion_at) {
  const std::size_t file = files_.size();
  files_.push_back(source.name);
  open_.push_back(source.name);
  pieces_.push_back({lines_ + 1, file, 1});
  TextLines lines(source);
  while (lines.next()) {
    const auto inclusion = inclusion_at(lines);
    if (!inclusion) {
      append_line(lines.text());
      continue;
    }
    Result<Source> included = load_included(inclusion->path, lines);
    if (!included) {
      append_line(lines.text());
      failures_.push_back({lines_, std::move(included.error())});
      continue;
    }
    append_line(inclusion->rest);
    for (std::size_t i = 1; i < inclusion->lines; ++i) lines.next();
    append(*included, inclusion_at);
    pieces_.push_back({lines_ + 1, file, lines.line() + 1});
  }
  open_.pop_back();
}

Result<Source> Deck::load_included(const std::string& path, const TextLines& from) const {
  const std::string as_written = quoted_path(path);
  const auto fail = [&](std::string expected, std::string found) {
    return from.fail(std::move(expected), std::move(found));
  };
  const std::string relative = with_slashes(path);
  if (first_.name == kStandardInputName) {
    return fail("no files to include from standard input, which has no folder",
                as_written + " (give the name of the deck)");
  }
  if (path.empty() || path.size() > kLongestPath || !platform::is_relative(relative) ||
      relative.find(':') != std::string::npos) {
    return fail("a file to include by its path from the folder of the deck",
                as_written +
                    " (write such a path: absolute ones and names that stand for folders "
                    "are not followed)");
  }
  std::vector<std::string> found;
  for (const std::string& file : {from.file(), first_.name}) {
    std::string whole = packed_or_not(folder_of(file) + relative);
    if (!is_regular(whole)) continue;
    if (found.empty() || !are_same_file(found.front(), whole)) found.push_back(std::move(whole));
  }
  if (found.empty()) {
    return fail("a file to include, " + folder_of(from.file()) + relative,
                "no file of that name (put it there, or correct the path)");
  }
  if (found.size() > 1) {
    return fail("one file that " + as_written + " may mean",
                quoted_path(found[0]) + " and " + quoted_path(found[1]) +
                    " (rename one: programs differ in which of them they take)");
  }
  if (std::any_of(open_.begin(), open_.end(),
                  [&](const std::string& open) { return are_same_file(open, found.front()); })) {
    return fail("files that do not include themselves", as_written + " again");
  }
  if (open_.size() >= kDeepest || files_.size() >= kMostFiles) {
    return fail("at most " + std::to_string(kMostFiles) + " included files, " +
                    std::to_string(kDeepest) + " in one another",
                "another, " + as_written);
  }
  Result<Source> included = load_unpacked(found.front());
  const auto is_read = [&] {  // perhaps by another name
    return std::any_of(files_.begin(), files_.end(),
                       [&](const std::string& file) { return are_same_file(file, found.front()); });
  };
  if (included && all_.text.size() + included->text.size() > most_repeated_ && is_read()) {
    return fail("a file that is included once, since the deck is so long",
                as_written + " again (" + std::to_string(all_.text.size()) + " bytes are read)");
  }
  return included;
}

FormatError Deck::at_its_place(FormatError error) const {
  if (error.line == 0 || error.file != first_.name || pieces_.empty()) return error;
  const auto failure = std::find_if(failures_.begin(), failures_.end(),
                                    [&](const Failure& one) { return one.line == error.line; });
  if (failure != failures_.end()) return failure->error;
  const auto after =
      std::upper_bound(pieces_.begin(), pieces_.end(), error.line,
                       [](std::size_t line, const Piece& piece) { return line < piece.begin; });
  if (after == pieces_.begin()) return error;
  const Piece& piece = *(after - 1);
  error.file = files_[piece.file];
  error.line = piece.line + (error.line - piece.begin);
  return error;
}

}  // namespace circumspect::formats
