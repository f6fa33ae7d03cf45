// Runs one case: writes the input, runs the program, reads and judges the mesh.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include "fuzz/campaign/input.hpp"
#include "fuzz/campaign/outcome.hpp"
#include "fuzz/campaign/subject.hpp"

namespace circumspect::campaign {

// Has a scratch folder, which is removed in the end, however this process ends:
//
//   work/   the program's own, empty but for its input before each run
//   mesh…   what it wrote on stdout, if that is the mesh; what it said otherwise
//
// Each thread has one, all made before there are threads (see Supervisor). The folder is in memory
// (/dev/shm) if there is room and TMPDIR says nothing else.
class Runner {
 public:
  // `turn`: for the gate that limits how many programs run at a time. Throws std::system_error.
  explicit Runner(const Subject& subject, Turn turn = {});
  ~Runner();
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  // Runs a case. A worker that has answered earlier cases gets this one too. For the first case, a
  // process gets the input and its end, as when run by hand, which reveals a worker that then does
  // not end or writes more.
  //
  // Then, if it was right or refused the input: the same on the input under each relation of the
  // subject, and what the program of Subject::against does with it.
  Outcome run(const Input& input);
  // The same in a fresh process.
  Outcome run_anew(const Input& input);
  // Runs a new finding again: the first of three runs that is a finding, too. kFlaky if none is.
  Outcome confirmed(const Input& input, const Outcome& outcome);

  // "other_program: holds", the outcome of the other program on the input; empty if there is none.
  std::string said_of_other(const Input& input);

  // The mesh that the last run wrote; empty if it wrote none.
  std::string mesh_file() const;
  // Everything that the last run left: its folder, and what it printed.
  const std::string& work_folder() const { return work_; }
  std::string said() const;
  // The first line that is not blank: of standard error, or else of standard output if that is not
  // a mesh.
  std::string first_line_said() const;
  // The text with the paths of files in the scratch folder, which differ each time, replaced by
  // names.
  std::string without_places(std::string text) const;

  // May be called from any thread: the current run ends at once, and so does the judging.
  void interrupt() {
    is_interrupted_ = true;
    supervisor_.interrupt();
    if (other_) other_->interrupt();
  }

  Containment containment() const { return supervisor_.containment(); }

 private:
  std::optional<std::string> said_error() const;
  std::optional<std::string> reason_in_time(const Input& input) const;
  Outcome judged_in_time(const Input& input, const std::string& mesh) const;
  Outcome outcome_of(const Ended& ended, const Input& input) const;
  Outcome run(const Input& input, bool anew);
  // Runs without relations, and without the other program.
  Outcome run_once(const Input& input, bool anew);
  Outcome after_relations(const Input& input, Outcome outcome, bool anew);
  Outcome against_other(const Input& input, Outcome outcome, bool anew);
  // The signature with the suffixes for such an input.
  std::string marked(const std::string& signature, const Input& input) const;
  Outcome run_on(const Input& input, const std::string& text, bool anew);
  // Why there is none in the end; otherwise an empty string.
  std::string prepare_work_folder();

  const Subject& subject_;
  std::string scratch_;
  std::string work_;
  std::size_t folders_ = 0;
  bool has_talked_ = false;
  std::atomic<bool> is_interrupted_ = false;
  Supervisor supervisor_;
  std::optional<Subject> other_subject_;
  std::unique_ptr<Runner> other_;
};

}  // namespace circumspect::campaign
