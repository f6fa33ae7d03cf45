// A program that answers one case after another without being started for each.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/process/supervised.hpp"

namespace circumspect::campaign {

// Parses what a worker writes just enough to see where an answer ends. docs/workers.md is for
// authors of workers. An answer is one of
//
//   N, then N lines                              kSimplices
//   OFF or nOFF, the counts, then as many lines  kOff
//   P vertices, S tets, then P + S lines         kTet
//   error TEXT
//
// Lines that are blank do not count.
class Answer {
 public:
  // `most`: bytes. An answer that announces more lines than fit in them is not an answer.
  Answer(Talk::Form form, std::uint64_t most) : form_(form), most_(most) {}

  void add(const char* bytes, std::size_t count);

  const std::string& text() const { return text_; }
  // Is it complete, or certainly not an answer, whatever follows?
  bool is_complete() const { return is_complete_; }
  // Is it a complete answer, with nothing after it?
  bool is_in_step() const;
  std::size_t lines() const { return lines_; }
  std::size_t expected_lines() const { return expected_.value_or(0); }

 private:
  void add_line(std::string_view line);
  // How many counts of lines the answer has, according to the first line, from which a keyword is
  // removed; 0: it is not an answer.
  std::size_t numbers_behind(std::string_view& line) const;

  Talk::Form form_;
  std::uint64_t most_;
  std::string text_;
  std::size_t searched_ = 0;  // all line ends before it have been seen
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

  // Gives it request.stdin_file and puts its answer into request.stdout_file. It is restarted if it
  // has ended, has answered so many cases, or was killed: for exceeding a limit, or because it and
  // the supervisor no longer agree where an answer begins. Requires: as run_supervised;
  // request.talk.
  Ended ask(const Request& request, const Limits& limits);

  // Kills it and everything that it started. Returns its exit status.
  int end();

 private:
  // Its files; the program has the other ends of all but the last.
  enum File { kIn, kOut, kError, kFiles };

  // 0, or errno.
  int start(const Request& request, const Limits& limits);
  // What it has written since its last answer.
  std::string left_over();
  Ended answered(const Request& request, const Limits& limits);
  std::optional<Ending> talk(const std::string& question, Answer& answer, Watch& watch,
                             const Limits& limits);
  // Reads what is available; false at the end of its output.
  bool read_into(Answer& answer);
  // Writes as much as fits, from `sent` on.
  void write_from(const std::string& question, std::size_t& sent);

  Surroundings around_;
  pid_t process_ = -1;
  int files_[kFiles] = {-1, -1, -1};
  std::string folder_;
  std::size_t answers_ = 0;
};

}  // namespace circumspect::campaign
