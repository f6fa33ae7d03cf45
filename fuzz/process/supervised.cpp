#include "fuzz/process/supervised.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <set>
#include <string>
#include <thread>

#include <dirent.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "fuzz/process/folders.hpp"

namespace circumspect::campaign {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

rlimit both(std::uint64_t value) { return {value, value}; }

// Everything that the new process needs, prepared before it exists: between vfork and exec it may
// only make system calls.
struct Start {
  const char* folder;
  char* const* arguments;
  int files[3];
  rlimit memory;
  rlimit file_size;
  rlimit cpu;
  rlimit tasks;
  bool limits_memory;
  Surroundings around;
  int failure;  // errno, written by the child
};

void become_program(Start* start) {
  setpgid(0, 0);
  set_signals(SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const rlimit no_core = {0, 0};
  bool done = setrlimit(RLIMIT_CORE, &no_core) == 0 && setrlimit(RLIMIT_CPU, &start->cpu) == 0 &&
              setrlimit(RLIMIT_FSIZE, &start->file_size) == 0 && chdir(start->folder) == 0;
  if (start->limits_memory) done = done && setrlimit(RLIMIT_AS, &start->memory) == 0;
  // If the limit is already lower than this, it stays.
  if (start->tasks.rlim_cur != RLIM_INFINITY) setrlimit(RLIMIT_NPROC, &start->tasks);
  for (int i = 0; i < 3; ++i) done = done && dup2(start->files[i], i) == i;
  // Everything is ready, so when its turn comes it only has to exec the program.
  if (done && !start->around.turn.take(start->around.lifeline)) {
    errno = ECANCELED;
    done = false;
  }
  if (done) execve(start->arguments[0], start->arguments, environ);
  start->failure = errno;
  _exit(127);
}

// vfork: the child borrows this process until it runs the program, so that nothing is copied.
[[gnu::noinline]] pid_t start_process(Start* start) {
  const pid_t child = vfork();
  if (child == 0) become_program(start);
  return child;
}

struct OpenFiles {
  int files[3] = {-1, -1, -1};
  explicit OpenFiles(const Request& request) {
    files[0] = open(request.stdin_file.c_str(), O_RDONLY | O_CLOEXEC);
    files[1] = opened_empty(request.stdout_file);
    files[2] = opened_empty(request.stderr_file);
  }
  ~OpenFiles() {
    for (const int file : files) {
      if (file >= 0) close(file);
    }
  }
  OpenFiles(const OpenFiles&) = delete;
  OpenFiles& operator=(const OpenFiles&) = delete;
  bool all_open() const { return std::min({files[0], files[1], files[2]}) >= 0; }
};

// The number is set once, because all runs of a supervisor have the same limits.
rlim_t tasks_for(const Limits& limits, Containment containment) {
  static rlim_t told = RLIM_INFINITY;
  const rlim_t tasks = most_tasks(containment, limits.processes);
  if (containment == Containment::kNamespaces && tasks != told) let_kernel_refuse_more_tasks(tasks);
  told = tasks;
  return tasks;
}

unsigned all_processors() {
  static const unsigned processors = std::max(1U, std::thread::hardware_concurrency());
  return processors;
}

}  // namespace

// signal() keeps two numbers for the threads of libc, at which a process ends by default. The
// kernel makes no difference; it is told in its own structure.
void set_signals(void (*handler)(int)) {
  struct {
    void (*handler)(int);
    unsigned long flags = 0;
    void (*restorer)() = nullptr;
    std::uint64_t mask = 0;
  } const action{handler};
  for (int number = 1; number <= SIGRTMAX; ++number) {
    if (number == SIGCHLD) continue;
    syscall(SYS_rt_sigaction, number, &action, nullptr, sizeof(action.mask));
  }
}

int opened_empty(const std::string& path) {
  const int flags = O_WRONLY | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
  int file = open(path.c_str(), flags, 0600);
  struct stat status {};
  if (file >= 0 && fstat(file, &status) == 0) {
    if (S_ISCHR(status.st_mode)) return file;  // /dev/null
    if (S_ISREG(status.st_mode) && status.st_nlink == 1 &&
        (status.st_size == 0 || ftruncate(file, 0) == 0)) {
      return file;
    }
  }
  if (file >= 0) close(file);
  return removed(path) ? open(path.c_str(), flags | O_EXCL, 0600) : -1;
}

pid_t start_program(const Request& request, const Limits& limits, const Surroundings& around,
                    const int (&files)[3], std::size_t cases) {
  std::vector<char*> arguments;
  for (const std::string& argument : request.command) {
    arguments.push_back(const_cast<char*>(argument.c_str()));
  }
  arguments.push_back(nullptr);
  // Threads share the limit on processor time; it matters only if the supervisor is gone.
  const double seconds = limits.seconds * all_processors() * static_cast<double>(cases);
  const auto cpu = static_cast<std::uint64_t>(std::ceil(std::min(seconds, 1e9))) + 1;
  Start start = {request.folder.c_str(),
                 arguments.data(),
                 {files[0], files[1], files[2]},
                 both(limits.memory),
                 both(limits.output),
                 {cpu, cpu + 1},
                 both(tasks_for(limits, around.containment)),
                 limits.memory != 0,
                 around,
                 0};
  const pid_t process = start_process(&start);
  if (process < 0) return -errno;
  if (start.failure == 0) return process;
  waitpid(process, nullptr, 0);
  return -start.failure;
}

namespace {

// The contents of one of the kernel's files. Nothing here waits for the disk.
std::string text_of(const std::string& path) {
  std::string text;
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return text;  // The process is gone.
  char block[4096];
  for (ssize_t count = 0; (count = read(file, block, sizeof(block))) > 0;) {
    text.append(block, static_cast<std::size_t>(count));
  }
  close(file);
  return text;
}

// The numbers of the entries of a folder of /proc.
std::vector<pid_t> numbers_in(const std::string& folder) {
  std::vector<pid_t> numbers;
  DIR* const entries = opendir(folder.c_str());
  if (entries == nullptr) return numbers;  // It is gone.
  while (const dirent* const entry = readdir(entries)) {
    if (entry->d_name[0] != '.') numbers.push_back(std::atoi(entry->d_name));
  }
  closedir(entries);
  return numbers;
}

// The kernel's counters for each task of some processes; nothing if the kernel does not count.
std::map<pid_t, Stalls::Task> tasks_of(const std::vector<pid_t>& processes) {
  std::map<pid_t, Stalls::Task> counted;
  for (const pid_t process : processes) {
    const std::string tasks = "/proc/" + std::to_string(process) + "/task/";
    for (const pid_t task : numbers_in(tasks)) {
      const std::string text = text_of(tasks + std::to_string(task) + "/schedstat");
      char* end = nullptr;
      counted[task].ran = std::strtoull(text.c_str(), &end, 10);
      counted[task].waited = std::strtoull(end, nullptr, 10);
    }
  }
  return counted;
}

}  // namespace

Watch::Watch(pid_t process, const Request& request, const Limits& limits, int lifeline)
    : request_(request),
      limits_(limits),
      lifeline_(lifeline),
      number_(process),
      process_(static_cast<int>(syscall(SYS_pidfd_open, process, 0))) {}

Watch::~Watch() {
  if (process_ >= 0) close(process_);
}

double Watch::seconds() const { return seconds_since(start_); }

// Tasks that run side by side need as long as the one that ran longest, or as all of them on all
// processors. The kernel adds a wait to its counter when the wait ends, so a wait also explains
// earlier time in which nothing ran, but no later time.
void Stalls::look(std::chrono::nanoseconds passed, const std::map<pid_t, Task>& tasks,
                  unsigned processors) {
  const auto now = static_cast<std::uint64_t>(passed.count());
  std::uint64_t longest = 0;
  std::uint64_t ran = 0;
  std::uint64_t waited = 0;
  for (const auto& [number, task] : tasks) {
    Task since = task;
    // An ID may belong to another task by now, which has counted less.
    const auto known = before_.find(number);
    if (known != before_.end() && known->second.ran <= task.ran &&
        known->second.waited <= task.waited) {
      since = {task.ran - known->second.ran, task.waited - known->second.waited};
    }
    longest = std::max(longest, since.ran);
    ran += since.ran;
    waited += since.waited;
  }
  if (has_looked_) {
    const std::uint64_t length = now - passed_;
    idle_ += length - std::min(length, std::max(longest, ran / processors));
    const std::uint64_t explained = std::min(waited, idle_);
    idle_ -= explained;
    stalled_ += explained;
  }
  before_ = tasks;
  has_looked_ = true;
  passed_ = now;
}

std::optional<Ending> Watch::exceeded() {
  constexpr double kLongest = 20;  // times the limit, whatever the load
  constexpr std::size_t kMostProcesses = 64;
  const Clock::duration now = Clock::now() - start_;
  stalls_.look(now, tasks_of(descendants(kMostProcesses)), all_processors());
  const double passed = std::chrono::duration<double>(now).count();
  if (passed >= limits_.seconds &&
      (passed >= kLongest * limits_.seconds || passed - stalls_.seconds() >= limits_.seconds)) {
    return Ending::kTimeLimit;
  }
  if (bytes_in(request_.folder, limits_.output) >= limits_.output) return Ending::kOutputLimit;
  if (has_too_many_processes()) return Ending::kProcessLimit;
  return std::nullopt;
}

bool Watch::has_too_many_processes() const {
  const std::size_t too_many = limits_.processes + 1;
  return descendants(too_many).size() >= too_many;
}

Ending Watch::wait() {
  while (true) {
    const double left = std::max(limits_.seconds - seconds(), 0.001);
    pollfd files[2] = {{process_, POLLIN, 0}, {lifeline_, POLLRDHUP, 0}};
    const int milliseconds = static_cast<int>(std::ceil(std::min(left, kTick) * 1000));
    poll(files, 2, milliseconds);
    if (files[0].revents != 0 || (process_ < 0 && has_ended())) {
      // They may all have been started since the last look, until the kernel refused more and it
      // ended.
      return has_too_many_processes() ? Ending::kProcessLimit : Ending::kExited;
    }
    if ((files[1].revents & (POLLRDHUP | POLLHUP)) != 0) return Ending::kInterrupted;
    if (const std::optional<Ending> limit = exceeded()) {
      return limit == Ending::kTimeLimit && has_ended() ? Ending::kExited : *limit;
    }
  }
}

bool Watch::has_ended() const {
  siginfo_t about{};
  const auto number = static_cast<id_t>(number_);
  return waitid(P_PID, number, &about, WEXITED | WNOHANG | WNOWAIT) == 0 && about.si_pid != 0;
}

namespace {

bool is_full(const std::string& path, std::uint64_t limit) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 && static_cast<std::uint64_t>(status.st_size) >= limit;
}

}  // namespace

Ended described(Ending ending, int status, const Request& request, const Limits& limits) {
  if (ending != Ending::kExited) return {ending, SIGKILL};
  const bool wrote_too_much = (WIFSIGNALED(status) && WTERMSIG(status) == SIGXFSZ) ||
                              is_full(request.stdout_file, limits.output) ||
                              is_full(request.stderr_file, limits.output) ||
                              bytes_in(request.folder, limits.output) >= limits.output;
  if (wrote_too_much) return {Ending::kOutputLimit, SIGXFSZ};
  if (WIFEXITED(status)) return {Ending::kExited, WEXITSTATUS(status)};
  if (WTERMSIG(status) == SIGXCPU) return {Ending::kTimeLimit, SIGXCPU};
  return {Ending::kSignalled, WTERMSIG(status)};
}

// All are stopped before any is killed: a stopped process starts no others, however fast it forks,
// and keeps its place, which another one would otherwise take. Stopping ends when a look finds no
// new process.
void kill_children(const std::function<std::vector<pid_t>()>& children) {
  std::set<pid_t> stopped;
  for (bool all_stopped = false;;) {
    std::vector<pid_t> found = children();
    if (found.empty()) return;
    bool is_new = false;
    for (std::size_t i = 0; i < found.size(); ++i) {
      kill(found[i], all_stopped ? SIGKILL : SIGSTOP);
      is_new = stopped.insert(found[i]).second || is_new;
      add_children(found[i], found);
    }
    if (all_stopped) std::this_thread::sleep_for(std::chrono::microseconds(200));
    all_stopped = !is_new;
    for (const pid_t process : found) waitpid(process, nullptr, WNOHANG);
  }
}

void kill_descendants(Containment containment) {
  if (containment == Containment::kSupervisor) {
    if (waitpid(-1, nullptr, WNOHANG) < 0 && errno == ECHILD) return;
    kill_children([] {
      std::vector<pid_t> children;
      add_children(getpid(), children);
      return children;
    });
    return;
  }
  // In a process namespace −1 means all others, at once: none of them can start another meanwhile.
  kill(-1, SIGKILL);
  while (waitpid(-1, nullptr, 0) > 0 || errno == EINTR) {
  }
}

// The program itself is not reaped before it is killed, so that its ID cannot be reused.
int killed(pid_t process, Containment containment) {
  kill(-process, SIGKILL);
  kill(process, SIGKILL);
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  kill_descendants(containment);
  return status;
}

Ended run_supervised(const Request& request, const Limits& limits, const Surroundings& around) {
  const OpenFiles files(request);
  const pid_t process =
      files.all_open() ? start_program(request, limits, around, files.files, 1) : -errno;
  if (process < 0) {
    around.turn.give_back();
    return {process == -ECANCELED ? Ending::kInterrupted : Ending::kNotStarted, -process};
  }
  Watch watch(process, request, limits, around.lifeline);
  const Ending ending = watch.wait();
  const double seconds = watch.seconds();
  const int status = killed(process, around.containment);
  around.turn.give_back();
  Ended ended = described(ending, status, request, limits);
  ended.seconds = seconds;
  return ended;
}

void add_children(pid_t process, std::vector<pid_t>& found) {
  const std::string tasks = "/proc/" + std::to_string(process) + "/task/";
  for (const pid_t task : numbers_in(tasks)) {
    const std::string children = text_of(tasks + std::to_string(task) + "/children");
    const char* at = children.c_str();
    for (char* end = nullptr; const long child = std::strtol(at, &end, 10); at = end) {
      found.push_back(static_cast<pid_t>(child));
    }
  }
}

std::vector<pid_t> descendants(std::size_t enough) {
  std::vector<pid_t> found;
  add_children(getpid(), found);
  for (std::size_t i = 0; i < found.size() && found.size() < enough; ++i) {
    add_children(found[i], found);
  }
  return found;
}

}  // namespace circumspect::campaign
