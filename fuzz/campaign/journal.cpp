#include "fuzz/campaign/journal.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <optional>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "oracle/formats/bytes/source.hpp"

namespace circumspect::campaign {
namespace {

constexpr const char* kHeading = "circumspect-campaign 1";

// Tabs and line ends separate the fields, so in values they become blanks.
std::string field(std::string text) {
  for (char& c : text) {
    if (c == '\t' || c == '\n' || c == '\r') c = ' ';
  }
  return text;
}

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::size_t start = 0;
  for (std::size_t tab = line.find('\t'); tab != std::string::npos; tab = line.find('\t', start)) {
    fields.push_back(line.substr(start, tab - start));
    start = tab + 1;
  }
  fields.push_back(line.substr(start));
  return fields;
}

// The first difference, in words; empty if there is none.
std::string difference(const Settings& old, const Settings& now) {
  for (std::size_t i = 0; i < std::max(old.size(), now.size()); ++i) {
    if (i >= old.size()) return "found " + now[i].first + " " + now[i].second + ", new here";
    if (i >= now.size()) return "expected " + old[i].first + " " + old[i].second + ", found none";
    const std::string value = field(now[i].second);
    if (old[i].first != now[i].first) {
      return "expected " + old[i].first + " " + old[i].second + ", found " + now[i].first;
    }
    if (old[i].second != value) {
      return "expected " + old[i].first + " '" + old[i].second + "' as when it began, found '" +
             value + "'";
    }
  }
  return "";
}

// The number of a case, or nothing.
std::optional<std::size_t> number_of(const std::string& text) {
  std::size_t number = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number);
  return read.ec == std::errc() && read.ptr == end ? std::optional(number) : std::nullopt;
}

// A signature is also the name of a folder, so a signature in the journal must not lead out of the
// findings.
bool is_signature(const std::string& text) {
  const auto is_allowed = [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '-' || c == '.';
  };
  return !text.empty() && text.front() != '.' && std::all_of(text.begin(), text.end(), is_allowed);
}

}  // namespace

Journal::~Journal() {
  if (file_ >= 0) close(file_);
}

Journal::Journal(Journal&& other) noexcept
    : path_(std::move(other.path_)),
      file_(std::exchange(other.file_, -1)),
      cases_(std::move(other.cases_)),
      findings_(std::move(other.findings_)),
      settings_(std::move(other.settings_)),
      has_begun_(other.has_begun_) {}

tl::expected<Journal, std::string> Journal::open(const std::string& folder,
                                                 const Settings& settings) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    return tl::unexpected(folder + ": expected a folder, or a place for one: " + error.message());
  }
  const std::string path = folder + "/journal.tsv";
  Journal journal;
  journal.path_ = path;
  journal.file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_NONBLOCK | O_CLOEXEC, 0644);
  struct stat status {};
  const bool is_open = journal.file_ >= 0 && fstat(journal.file_, &status) == 0;
  if (!is_open || !S_ISREG(status.st_mode)) {
    return tl::unexpected(path + ": expected a file that can be written to: " +
                          (is_open ? "it is not a file" : std::strerror(errno)));
  }
  if (flock(journal.file_, LOCK_EX | LOCK_NB) != 0) {
    return tl::unexpected(path + ": another campaign writes to it just now");
  }
  // All of it or nothing: text after the last whole line that was read is cut off below.
  const formats::Result<formats::Source> source = formats::load(path);
  if (!source) return tl::unexpected(source.error().to_string());
  std::size_t complete = 0;
  const std::string fault = journal.parse(source->text, settings, complete);
  if (!fault.empty()) return tl::unexpected(path + ": " + fault);
  if (ftruncate(journal.file_, static_cast<off_t>(complete)) != 0) {
    return tl::unexpected(path + ": " + std::strerror(errno));
  }
  if (complete == 0) {
    std::string beginning(kHeading);
    beginning += '\n';
    for (const auto& [name, value] : settings) {
      beginning += "setting\t" + name + "\t" + field(value) + "\n";
    }
    try {
      journal.write(beginning, true);
    } catch (const std::system_error& failure) {
      return tl::unexpected(std::string(failure.what()));
    }
  }
  return journal;
}

std::string Journal::parse(const std::string& text, const Settings& settings,
                           std::size_t& complete) {
  std::size_t number = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos;
       end = text.find('\n', complete)) {
    const std::string line = text.substr(complete, end - complete);
    complete = end + 1;
    if (++number == 1) {
      if (line == kHeading) continue;
      return "expected '" + std::string(kHeading) + "' on line 1, found something else";
    }
    const std::string fault = parse_line(fields_of(line));
    if (!fault.empty()) return "line " + std::to_string(number) + ": expected " + fault;
  }
  if (number == 0) {
    complete = 0;
    return text.empty() || std::string(kHeading).compare(0, text.size(), text) == 0
               ? ""
               : "expected a journal of a campaign, found something else";
  }
  // The settings are written before any case. If there is no case, this is a new beginning,
  // whatever the settings say: a campaign whose command was wrong leaves them.
  if (cases_.empty() && findings_.empty()) {
    complete = 0;
    has_begun_ = false;
    return "";
  }
  const std::string other = difference(settings_, settings);
  return other.empty() ? ""
                       : "another campaign began here: " + other +
                             "; choose another --output, or the same settings";
}

std::string Journal::parse_line(const std::vector<std::string>& fields) {
  const std::string& kind = fields.front();
  if (kind == "setting" && fields.size() == 3) {
    settings_.emplace_back(fields[1], fields[2]);
  } else if (kind == "finding" && fields.size() == 3) {
    const auto number = number_of(fields[2]);
    if (!number) return "a finding with the number of its case";
    if (!is_signature(fields[1])) return "the signature of a finding, of letters, digits, - and .";
    // It may be there twice, if the line of its case was lost.
    const auto same = [&](const FindingRecord& finding) { return finding.signature == fields[1]; };
    if (std::none_of(findings_.begin(), findings_.end(), same)) {
      findings_.push_back({fields[1], *number});
    }
  } else if (kind == "minimised" && fields.size() == 2) {
    for (FindingRecord& finding : findings_) {
      if (finding.signature == fields[1]) finding.is_minimised = true;
    }
  } else if (kind == "cut-off" && fields.size() == 2) {
    for (FindingRecord& finding : findings_) {
      if (finding.signature == fields[1]) finding.is_cut_off = true;
    }
  } else if ((kind == "began" || kind == "ended") && fields.size() == 1) {
    has_begun_ = kind == "began";
  } else if (kind == "case" && (fields.size() == 5 || fields.size() == 6)) {
    if (number_of(fields[1]) != cases_.size()) return "case " + std::to_string(cases_.size());
    if (!is_signature(fields[4])) return "what became of the case, of letters, digits, - and .";
    CaseRecord record{fields[2], fields[4], fields[3] == "finding"};
    if (fields.size() == 6) {
      record.points = number_of(fields[5]);
      if (!record.points) return "the number of points of a case";
    }
    cases_.push_back(std::move(record));
  } else {
    return "a setting, a finding or a case";
  }
  return "";
}

void Journal::write(const std::string& line, bool to_disk) {
  // The file is append-only and has no other writer, so the line is complete or cut off.
  for (std::size_t at = 0; at < line.size();) {
    const ssize_t written = ::write(file_, line.data() + at, line.size() - at);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) throw std::system_error(errno, std::generic_category(), path_);
    at += static_cast<std::size_t>(written);
  }
  if (to_disk && fsync(file_) != 0) {
    throw std::system_error(errno, std::generic_category(), path_);
  }
}

void Journal::add_finding(const std::string& signature, std::size_t case_number) {
  write("finding\t" + field(signature) + "\t" + std::to_string(case_number) + "\n", true);
}

void Journal::add_minimised(const std::string& signature) {
  write("minimised\t" + field(signature) + "\n", true);
}

void Journal::add_cut_off(const std::string& signature) {
  write("cut-off\t" + field(signature) + "\n", true);
}

void Journal::add_begin() { write("began\n", false); }

void Journal::add_end() { write("ended\n", true); }

void Journal::add_case(std::size_t number, const CaseRecord& record) {
  const std::string kind = record.is_finding ? "finding" : record.what;
  write("case\t" + std::to_string(number) + "\t" + field(record.family) + "\t" + kind + "\t" +
            field(record.what) + (record.points ? "\t" + std::to_string(*record.points) : "") +
            "\n",
        false);
}

}  // namespace circumspect::campaign
