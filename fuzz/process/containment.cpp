#include "fuzz/process/containment.hpp"

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include <dirent.h>
#include <fcntl.h>
#include <linux/futex.h>
#include <linux/sched.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/utsname.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "fuzz/process/supervised.hpp"

namespace circumspect::campaign {

namespace {

bool wrote(const std::string& path, const std::string& text) {
  const int file = open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) return false;
  const bool done = write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  close(file);
  return done;
}

// Users keep their IDs in the namespace, so that files keep their owners. Only a superuser may map
// more than one ID.
bool mapped_users(pid_t child) {
  const std::string folder = "/proc/" + std::to_string(child);
  const std::string all = "0 0 4294967295";
  if (wrote(folder + "/uid_map", all)) return wrote(folder + "/gid_map", all);
  const std::string user = std::to_string(geteuid());
  const std::string group = std::to_string(getegid());
  return wrote(folder + "/setgroups", "deny") &&
         wrote(folder + "/uid_map", user + " " + user + " 1") &&
         wrote(folder + "/gid_map", group + " " + group + " 1");
}

// A /proc that shows the processes of this namespace; those outside keep theirs.
bool mounted_own_proc() {
  return mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
         mount("proc", "/proc", "proc", MS_NOSUID | MS_NODEV | MS_NOEXEC, nullptr) == 0;
}

pid_t fork_with(std::uint64_t flags) {
  clone_args arguments = {};
  arguments.flags = flags;
  arguments.exit_signal = SIGCHLD;
  return static_cast<pid_t>(syscall(SYS_clone3, &arguments, sizeof(arguments)));
}

// Sends a byte through a socket; false if the other side ended.
bool told(int socket) { return ::send(socket, "", 1, MSG_NOSIGNAL) == 1; }
bool was_told(int socket) {
  char byte = 0;
  ssize_t count = 0;
  while ((count = recv(socket, &byte, 1, 0)) < 0 && errno == EINTR) {
  }
  return count == 1;
}

bool kernel_is_at_least(long major, long minor) {
  utsname system = {};
  if (uname(&system) != 0) return false;
  char* rest = nullptr;
  const long first = std::strtol(system.release, &rest, 10);
  const long second = *rest == '.' ? std::strtol(rest + 1, nullptr, 10) : 0;
  return first > major || (first == major && second >= minor);
}

// The number of tasks of this user's processes, to which a limit applies.
rlim_t tasks_of_user() {
  DIR* const all = opendir("/proc");
  if (all == nullptr) return 0;
  rlim_t count = 0;
  while (const dirent* const entry = readdir(all)) {
    if (entry->d_name[0] < '0' || entry->d_name[0] > '9') continue;
    struct stat status {};
    const std::string folder = std::string("/proc/") + entry->d_name + "/task";
    if (stat(folder.c_str(), &status) != 0 || status.st_uid != geteuid()) continue;
    count += std::max<rlim_t>(status.st_nlink, 3) - 2;  // a folder for each task
  }
  closedir(all);
  return count;
}

// Runtimes start a few threads for each processor, and some more. The margin must be small: Linux
// gives each session an equal share of the processors, and a supervisor among a thousand hostile
// sessions waits minutes for its turn.
rlim_t room_for_threads() {
  return 100 + 4 * std::max<rlim_t>(std::thread::hardware_concurrency(), 1);
}

}  // namespace

const char* name(Containment containment) {
  return containment == Containment::kNamespaces ? "namespaces" : "supervisor";
}

pid_t fork_into_namespaces() {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return -1;
  const pid_t child = fork_with(CLONE_NEWUSER | CLONE_NEWPID | CLONE_NEWNS | CLONE_NEWIPC);
  if (child == 0) {
    close(ends[0]);
    if (!was_told(ends[1]) || !mounted_own_proc() || !told(ends[1])) _exit(1);
    close(ends[1]);
    return 0;
  }
  close(ends[1]);
  const bool done = child > 0 && mapped_users(child) && told(ends[0]) && was_told(ends[0]);
  close(ends[0]);
  if (done || child < 0) return child;
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  return -1;
}

rlim_t most_tasks(Containment containment, std::size_t processes) {
  const rlim_t wanted = std::min<rlim_t>(processes, 1'000'000) + room_for_threads();
  if (containment == Containment::kNamespaces) {
    // In earlier kernels, a limit counted all processes of the user, wherever they are.
    return kernel_is_at_least(5, 14) ? wanted : RLIM_INFINITY;
  }
  // All processes of the user count, and other programs of the campaign may start as many
  // meanwhile.
  static const rlim_t others = tasks_of_user();
  return others + 4 * wanted;
}

void let_kernel_refuse_more_tasks(rlim_t tasks) {
  // Process IDs below 300 are not reused.
  constexpr rlim_t kNotGivenAgain = 300;
  // In earlier kernels, there was one such number for the whole system.
  if (tasks == RLIM_INFINITY || !kernel_is_at_least(6, 14)) return;
  wrote("/proc/sys/kernel/pid_max", std::to_string(tasks + kNotGivenAgain));
}

Known::Known(pid_t process)
    : number_(process), file_(static_cast<int>(syscall(SYS_pidfd_open, process, 0))) {}

Known::Known(Known&& other) noexcept
    : number_(std::exchange(other.number_, -1)), file_(std::exchange(other.file_, -1)) {}

Known& Known::operator=(Known&& other) noexcept {
  std::swap(number_, other.number_);
  std::swap(file_, other.file_);
  return *this;
}

Known::~Known() {
  if (file_ >= 0) close(file_);
}

bool Known::has_ended_within(int milliseconds) const {
  pollfd waited = {file_, POLLIN, 0};
  return file_ < 0 || poll(&waited, 1, milliseconds) > 0;
}

void Known::send(int signal_number) const {
  if (file_ >= 0) syscall(SYS_pidfd_send_signal, file_, signal_number, nullptr, 0);
}

char Known::state() const {
  if (has_ended_within(0)) return '\0';
  const std::string path = "/proc/" + std::to_string(number_) + "/stat";
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return '\0';
  char text[512];
  const ssize_t count = read(file, text, sizeof(text) - 1);
  close(file);
  if (count <= 0) return '\0';
  text[count] = '\0';
  // "123 (name) S": a name may hold anything, but no more than 64 bytes.
  const char* const end = std::strrchr(text, ')');
  return end != nullptr && end[1] == ' ' ? end[2] : '\0';
}

namespace {

bool is_cut(int lifeline) {
  pollfd file = {lifeline, POLLRDHUP, 0};
  return poll(&file, 1, 0) > 0 && (file.revents & (POLLRDHUP | POLLHUP)) != 0;
}

}  // namespace

Gate::Gate(std::size_t places) : count_(places + 1) {
  void* const memory = mmap(nullptr, count_ * sizeof(Cell), PROT_READ | PROT_WRITE,
                            MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::system_error(errno, std::generic_category(), "mmap");
  cells_ = static_cast<Cell*>(memory);
  std::uninitialized_value_construct_n(cells_, count_);
}

Gate::~Gate() { munmap(cells_, count_ * sizeof(Cell)); }

bool Turn::take(int lifeline) const {
  if (gate_ == nullptr) return true;
  Gate::Cell* const cells = gate_->cells_;
  while (true) {
    const int given_back = cells[0];
    for (std::size_t i = 1; i < gate_->count_; ++i) {
      int nobody = 0;
      if (cells[i].compare_exchange_strong(nobody, holder_)) return true;
    }
    if (is_cut(lifeline)) return false;
    // Nothing signals that the lifeline was cut, so it is polled. In between, only a returned place
    // wakes this process, unless one was returned since the places were looked at.
    const timespec tick = {0, 20'000'000};
    syscall(SYS_futex, cells, FUTEX_WAIT, given_back, &tick, nullptr, 0);
  }
}

void Turn::give_back() const {
  if (gate_ == nullptr) return;
  Gate::Cell* const cells = gate_->cells_;
  for (std::size_t i = 1; i < gate_->count_; ++i) {
    int holder = holder_;
    cells[i].compare_exchange_strong(holder, 0);
  }
  // Wakes all, because one of those that wait may have been killed.
  ++cells[0];
  syscall(SYS_futex, cells, FUTEX_WAKE, INT_MAX, nullptr, nullptr, 0);
}

}  // namespace circumspect::campaign
