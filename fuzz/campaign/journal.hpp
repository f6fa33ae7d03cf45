// The record of a campaign on disk, from which it continues after any interruption.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

namespace circumspect::campaign {

using Settings = std::vector<std::pair<std::string, std::string>>;

// One case that is done. `what`: the signature of a finding, or "holds", "refused", "skipped",
// "flaky", "known".
struct CaseRecord {
  std::string family;
  std::string what;
  bool is_finding = false;
  std::optional<std::size_t> points = {};  // that it had; not in older journals
};

// The first case with a signature.
struct FindingRecord {
  std::string signature;
  std::size_t case_number = 0;
  bool is_minimised = false;
  bool is_cut_off = false;  // the time was over: making it small continues from minimal.*
};

// A file to which lines are added, in the order of the cases:
//
//   circumspect-campaign 1
//   setting ⇥ NAME ⇥ VALUE          all at the beginning
//   finding ⇥ SIGNATURE ⇥ CASE      before the line of the case; its folder is complete except for
//   minimised ⇥ SIGNATURE            the smallest input, which comes with this line
//   cut-off ⇥ SIGNATURE              or with this one, if there was no time to make it smaller
//   began                            a call of the command, which writes
//   ended                            at its end, unless it is killed
//   case ⇥ NUMBER ⇥ FAMILY ⇥ holds|refused|skipped|flaky|known|finding ⇥ WHAT ⇥ POINTS
//
// A line that an interruption cut off is dropped, and its case is run again. Lines about findings
// are forced to the disk (fsync); those about cases survive this process, but may be lost when the
// machine fails.
class Journal {
 public:
  // Opens the journal in a folder, or begins one. Errors: the settings are not those that it began
  // with (the message says which), it is not a journal, or it cannot be written.
  static tl::expected<Journal, std::string> open(const std::string& folder,
                                                 const Settings& settings);
  ~Journal();
  Journal(Journal&& other) noexcept;
  Journal& operator=(Journal&&) = delete;

  // Its contents when it was opened.
  const std::vector<CaseRecord>& cases() const { return cases_; }
  const std::vector<FindingRecord>& findings() const { return findings_; }
  // Has a call begun that did not end by itself? It was killed, or the machine stopped.
  bool was_killed() const { return has_begun_; }

  // These throw std::system_error if the disk is full.
  void add_finding(const std::string& signature, std::size_t case_number);
  void add_minimised(const std::string& signature);
  void add_cut_off(const std::string& signature);
  void add_case(std::size_t number, const CaseRecord& record);
  void add_begin();
  void add_end();

 private:
  Journal() = default;
  // The fault of the text, or an empty string; `complete`: the bytes of its whole lines.
  std::string parse(const std::string& text, const Settings& settings, std::size_t& complete);
  std::string parse_line(const std::vector<std::string>& fields);
  void write(const std::string& line, bool to_disk);

  std::string path_;
  int file_ = -1;
  std::vector<CaseRecord> cases_;
  std::vector<FindingRecord> findings_;
  Settings settings_;
  bool has_begun_ = false;
};

}  // namespace circumspect::campaign
