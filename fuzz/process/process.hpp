// Runs other people's programs. Whatever they do, they end, and none of their processes is left.
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/process/containment.hpp"

namespace circumspect::campaign {

// What a program may use. It is killed when it uses more.
struct Limits {
  double seconds = 10;                             // without time in which no processor was free
  std::uint64_t memory = std::uint64_t{4} << 30;   // bytes of address space a process; 0: any
  std::uint64_t output = std::uint64_t{64} << 20;  // bytes on disk: each file, and all together
  std::size_t processes = 256;                     // at a time
};

// The protocol with a program that answers one case after another (worker.hpp).
struct Talk {
  // The form of its answers: a number and as many lines; .off files; .tet files.
  enum class Form { kSimplices, kOff, kTet };
  Form form = Form::kSimplices;
  std::size_t cases = 0;  // then another process takes its place
};

struct Request {
  std::vector<std::string> command;  // command[0] is the path of the program
  std::string folder;                // it runs there, and is watched there for how much it writes
  std::string stdin_file = "/dev/null";
  std::string stdout_file = "/dev/null";
  std::string stderr_file = "/dev/null";
  // The program keeps running after it has answered stdin_file on stdout_file, for the next request
  // like this.
  std::optional<Talk> talk = {};
};

enum class Ending {
  kExited,        // code: its exit code
  kSignalled,     // code: the signal that it died of
  kTimeLimit,     // it ran too long, and was killed, as for the next two
  kOutputLimit,   // it wrote too much
  kProcessLimit,  // it started too many processes
  kOutOfStep,     // a worker wrote more than its answer to the previous request; stdout_file: what
  kNotStarted,    // code: errno
  kSupervisorKilled,  // the process that ran it was killed, and the next run has another
  kInterrupted,       // Supervisor::interrupt was called
};

struct Ended {
  Ending ending = Ending::kInterrupted;
  int code = 0;
  double seconds = 0;
  // For the answer of a worker: how many lines followed those that state their number, and how many
  // were expected.
  std::size_t lines = 0;
  std::size_t expected_lines = 0;
};

// A process apart that runs programs one after the other. Where the system allows it, it is the
// first process of a process namespace (containment.hpp), and everything that it starts lives and
// ends there. Elsewhere all processes that a program starts are descendants of this process, even
// if they leave their process group, their session and their parent (it is a "child subreaper"), so
// that it can kill them all when the program ends. Either does the same when this process dies,
// even by SIGKILL. It has one thread, little memory and no terminal, so that starting a program
// from it is cheap. Its own parent, the guardian, only waits for it: if a program kills the process
// that started it, the guardian kills the rest. This process watches both while it waits for them:
// it continues them when they were stopped, and kills them and everything that they started if that
// does not help or if they are traced. Each thread may have one.
//
// This does not prevent a program from writing outside of its folder, or from holding deleted files
// open (each of these is limited, but not their sum). Without namespaces, it does not prevent a
// program from killing arbitrary processes of its user.
class Supervisor {
 public:
  // Forks. `folder`, if any, is removed with its contents at the end of the supervisor, even if
  // this process dies first. `turn`: what it waits for before each program. `wanted`: the
  // containment; by default, the strongest that the system allows. Throws std::system_error, also
  // if the wanted containment is not allowed.
  explicit Supervisor(const std::string& folder = "", Turn turn = {},
                      std::optional<Containment> wanted = {});
  ~Supervisor();
  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;

  // Runs one program to its end, or lets a worker answer. kExited with code 0: it has answered, or
  // ended before it had. Not from two threads at a time. Throws as the constructor.
  Ended run(const Request& request, const Limits& limits);

  // May be called from any thread: kills the running program, so that `run` returns; all later runs
  // return at once.
  void interrupt();

  Containment containment() const { return containment_; }

  // The process that runs the programs, and its parent.
  int supervisor() const { return supervisor_.number(); }
  int guardian() const { return guardian_.number(); }

 private:
  void start();
  void end();
  // Continues both processes if they were stopped. False if they have to be given up, and are
  // killed.
  bool look_after();
  bool wait_for_answer();

  std::string folder_;
  Turn turn_;
  std::optional<Containment> wanted_;
  Containment containment_ = Containment::kSupervisor;
  Known guardian_;
  Known supervisor_;
  int stops_ = 0;     // how often they were found stopped since the last answer
  std::mutex mutex_;  // for the members that interrupt needs
  int socket_ = -1;
  bool is_interrupted_ = false;
};

// The path of a program as a shell finds it in PATH; empty if there is none that may be run. A name
// with a slash is relative to the current folder, and the result is absolute.
std::string find_program(const std::string& name);

}  // namespace circumspect::campaign
