// A program that answers one case after another without a new start for each.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/process/supervised.hpp"

namespace circumspect::campaign {

// What a worker writes, as far as it must be understood to see where an answer ends. docs/workers.md is for those
// who write workers. An answer is one of
//
//   N, then N lines                              kSimplices
//   OFF or nOFF, the counts, then as many lines  kOff
//   P vertices, S tets, then P + S lines         kTet
//   error TEXT
//
// Lines that are blank do not count.
class Answer {
 public:
  // `most`: bytes. An answer that promises more lines than fit in them is none.
  Answer(Talk::Form form, std::uint64_t most) : form_(form), most_(most) {}

  void add(const char* bytes, std::size_t count);

  const std::string& text() const { return text_; }
  // Is it all there, or can it be no answer whatever comes?
  bool is_complete() const { return is_complete_; }
  // Is it complete, and an answer, and is there nothing behind it?
  bool is_in_step() const;
  std::size_t lines() const { return lines_; }
  std::size_t expected_lines() const { return expected_.value_or(0); }

 private:
  void add_line(std::string_view line);
  // How many numbers say how many lines there are, by the first line, from which a keyword is taken; 0: it is none.
  std::size_t numbers_behind(std::string_view& line) const;

  Talk::Form form_;
  std::uint64_t most_;
  std::string text_;
  std::size_t searched_ = 0;  // there is no line end in what is before it that was not seen
  std::size_t end_ = 0;       // of the last whole line
  std::size_t numbers_wanted_ = 0;
  std::vector<std::size_t> numbers_;
  std::optional<std::size_t> expected_;
  std::size_t lines_ = 0;
  bool is_complete_ = false;
  bool is_garbage_ = false;
};

// The worker of a supervisor; there is none before it is asked.
class Worker {
 public:
  explicit Worker(const Surroundings& around) : around_(around) {}
  ~Worker() { end(); }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  // Gives it request.stdin_file and puts its answer into request.stdout_file. It is started anew if it has ended, or has
  // answered so many cases, or was killed: for a limit that it exceeded, or since it and the supervisor no longer agree
  // where an answer begins. Requires: as run_supervised; request.talk.
  Ended ask(const Request& request, const Limits& limits);

  // Kills it, and all that it started. Its exit status.
  int end();

 private:
  // Its files, of which the program has the other ends, but for the last.
  enum File { kIn, kOut, kError, kFiles };

  // 0, or what errno said.
  int start(const Request& request, const Limits& limits);
  // What it has written since its last answer.
  std::string left_over();
  Ended answered(const Request& request, const Limits& limits);
  std::optional<Ending> talk(const std::string& question, Answer& answer, Watch& watch,
                             const Limits& limits);
  // Reads what there is; false at the end of all that it writes.
  bool read_into(Answer& answer);
  // Writes what there is room for, from `sent` on.
  void write_from(const std::string& question, std::size_t& sent);

  Surroundings around_;
  pid_t process_ = -1;
  int files_[kFiles] = {-1, -1, -1};
  std::string folder_;
  std::size_t answers_ = 0;
};

}  // namespace circumspect::campaign
