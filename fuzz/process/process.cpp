#include "fuzz/process/process.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <set>
#include <sstream>
#include <system_error>
#include <type_traits>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "fuzz/process/folders.hpp"
#include "fuzz/process/supervised.hpp"
#include "fuzz/process/worker.hpp"

namespace circumspect::campaign {
namespace {

// A message through the socket: a length and as many bytes.

bool write_all(int file, const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t written = send(file, bytes, count, MSG_NOSIGNAL);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes += written;
    count -= static_cast<std::size_t>(written);
  }
  return true;
}

// A process that waits in read() is also woken when the other side receives what was sent to it.
// Then it may queue behind the program that has just started, and stay there while the next request
// waits for it.
void wait_for_bytes(int file) {
  pollfd waited = {file, POLLIN, 0};
  while (poll(&waited, 1, -1) < 0 && errno == EINTR) {
  }
}

bool read_all(int file, char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t got = read(file, bytes, count);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    bytes += got;
    count -= static_cast<std::size_t>(got);
  }
  return true;
}

template <class T>
void put(std::string& message, const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  message.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

void put(std::string& message, const std::string& text) {
  put(message, text.size());
  message += text;
}

// Sent in one piece, so that the receiver is woken once.
bool send_message(int file, const std::string& message) {
  std::string bytes;
  put(bytes, message);
  return write_all(file, bytes.data(), bytes.size());
}

// A message that is decoded in the order in which it was encoded.
class Message {
 public:
  static std::optional<Message> receive(int file) {
    wait_for_bytes(file);
    std::size_t size = 0;
    if (!read_all(file, reinterpret_cast<char*>(&size), sizeof(size))) return std::nullopt;
    Message message;
    message.bytes_.resize(size);
    if (!read_all(file, message.bytes_.data(), size)) return std::nullopt;
    return message;
  }

  template <class T>
  T take() {
    T value;
    std::memcpy(&value, bytes_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    return value;
  }
  std::string text() {
    const auto size = take<std::size_t>();
    at_ += size;
    return bytes_.substr(at_ - size, size);
  }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

std::string message_of(const Request& request, const Limits& limits) {
  std::string message;
  put(message, limits);
  put(message, request.talk);
  put(message, request.command.size());
  for (const std::string& argument : request.command) put(message, argument);
  for (const std::string* const text :
       {&request.folder, &request.stdin_file, &request.stdout_file, &request.stderr_file}) {
    put(message, *text);
  }
  return message;
}

Request request_of(Message& message) {
  Request request;
  request.talk = message.take<std::optional<Talk>>();
  request.command.resize(message.take<std::size_t>());
  for (std::string& argument : request.command) argument = message.text();
  for (std::string* const text :
       {&request.folder, &request.stdin_file, &request.stdout_file, &request.stderr_file}) {
    *text = message.text();
  }
  return request;
}

// The life of the process that runs the programs.
[[noreturn]] void supervise(int socket, const std::string& folder, Turn turn,
                            Containment containment) {
  Worker worker({socket, turn, containment});
  while (std::optional<Message> message = Message::receive(socket)) {
    const auto limits = message->take<Limits>();
    const Request request = request_of(*message);
    std::string answer;
    if (request.talk) {
      put(answer, worker.ask(request, limits));
    } else {
      worker.end();
      put(answer, run_supervised(request, limits, {socket, turn, containment}));
    }
    if (!send_message(socket, answer)) break;
  }
  worker.end();
  if (!folder.empty()) removed(folder);
  _exit(0);
}

// The guardian's report on the process that it has started: it knows the process ID outside of the
// namespace.
struct Hello {
  Containment containment = Containment::kSupervisor;
  pid_t supervisor = -1;
};

// Waits for a child until it ends, and continues it whenever it is stopped. Returns its exit
// status.
int status_of(pid_t child) {
  int status = 0;
  while (true) {
    const pid_t changed = waitpid(child, &status, WUNTRACED);
    if (changed < 0 && errno != EINTR) return 0;
    if (changed == child && !WIFSTOPPED(status)) return status;
    if (changed == child) kill(child, SIGCONT);
  }
}

// The life of the guardian. It and its child keep only one open file of its parent: the guardian's
// own.
[[noreturn]] void guard(int socket, const std::string& folder, Turn turn, pid_t parent,
                        std::optional<Containment> wanted) {
  const int null = open("/dev/null", O_RDWR);
  for (int file = 0; file < 3; ++file) dup2(null, file);
  const int own = 3;
  if (socket != own) dup2(socket, own);
  close_range(own + 1, ~0U, 0);
  fcntl(own, F_SETFD, FD_CLOEXEC);
  // A session of its own has no terminal, so neither Ctrl-C nor a program's input comes from there.
  setsid();
  set_signals(SIG_IGN);
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  Hello hello{Containment::kNamespaces, -1};
  if (wanted != Containment::kSupervisor) hello.supervisor = fork_into_namespaces();
  if (hello.supervisor < 0 && wanted != Containment::kNamespaces) {
    hello = {Containment::kSupervisor, fork()};
  }
  // No process of this user may trace it, nor the child, which does the same.
  prctl(PR_SET_DUMPABLE, 0);
  if (hello.supervisor == 0) {
    prctl(PR_SET_CHILD_SUBREAPER, 1);  // It is not inherited.
    supervise(own, folder, turn, hello.containment);
  }
  std::string said;
  put(said, hello);
  // The parent would wait for ever for a process that it does not know.
  if (!send_message(own, said) && hello.supervisor > 0) kill(hello.supervisor, SIGKILL);
  close(own);
  const bool was_killed = hello.supervisor < 0 || WIFSIGNALED(status_of(hello.supervisor));
  if (hello.containment == Containment::kSupervisor) kill_descendants(Containment::kSupervisor);
  // Otherwise the parent has another one for the same folder.
  if (was_killed && getppid() != parent && !folder.empty()) removed(folder);
  _exit(0);
}

// All guardians and supervisors of this process. Locked while one is started, and while other
// children are killed: those that became children of this process when their guardian was killed.
struct Ours {
  std::mutex mutex;
  std::set<pid_t> processes;
};
Ours& ours() {
  static Ours all;
  return all;
}

// Programs, unlike other children of this process, descend from a guardian, which began a session.
std::vector<pid_t> adopted_programs() {
  std::vector<pid_t> found;
  const pid_t own_session = getsid(0);
  add_children(getpid(), found);
  std::erase_if(found, [own_session](pid_t child) {
    return ours().processes.count(child) != 0 || getsid(child) == own_session;
  });
  return found;
}

constexpr int kTick = 100;      // milliseconds between two looks after a supervisor
constexpr int kMostStops = 20;  // after so many looks that find it stopped, it is given up

}  // namespace

Supervisor::Supervisor(const std::string& folder, Turn turn, std::optional<Containment> wanted)
    : folder_(folder), turn_(turn), wanted_(wanted) {
  try {
    start();
    if (supervisor_.number() > 0) return;
    end();
    throw std::system_error(EPERM, std::generic_category(), "a process namespace");
  } catch (...) {
    if (!folder_.empty()) removed(folder_);
    throw;
  }
}

Supervisor::~Supervisor() {
  end();
  if (!folder_.empty()) removed(folder_);
}

void Supervisor::start() {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    throw std::system_error(errno, std::generic_category(), "socketpair");
  }
  const pid_t parent = getpid();
  const std::lock_guard one_at_a_time(ours().mutex);
  const pid_t guardian = fork();
  if (guardian == 0) guard(ends[1], folder_, turn_, parent, wanted_);
  const int error = errno;
  close(ends[1]);
  {
    const std::lock_guard lock(mutex_);
    socket_ = ends[0];
  }
  if (guardian < 0) throw std::system_error(error, std::generic_category(), "fork");
  guardian_ = Known(guardian);
  ours().processes.insert(guardian);
  std::optional<Message> said = Message::receive(socket_);
  const Hello hello = said ? said->take<Hello>() : Hello{};
  containment_ = hello.containment;
  if (hello.supervisor > 0) {
    supervisor_ = Known(hello.supervisor);
    ours().processes.insert(hello.supervisor);
  }
  // If a program kills both of them, its remaining processes become children of this one, which
  // then kills them.
  if (containment_ == Containment::kSupervisor) prctl(PR_SET_CHILD_SUBREAPER, 1);
  const std::lock_guard lock(mutex_);
  if (is_interrupted_) shutdown(socket_, SHUT_RDWR);
}

bool Supervisor::look_after() {
  bool is_stopped = false;
  bool is_traced = false;
  for (const Known* const process : {&guardian_, &supervisor_}) {
    const char state = process->state();
    is_stopped = is_stopped || state == 'T';
    is_traced = is_traced || state == 't';
    if (state == 'T') process->send(SIGCONT);
  }
  if (is_stopped) ++stops_;
  if (!is_traced && stops_ <= kMostStops) return true;
  guardian_.send(SIGKILL);
  supervisor_.send(SIGKILL);
  return false;
}

bool Supervisor::wait_for_answer() {
  pollfd waited = {socket_, POLLIN, 0};
  while (true) {
    const int ready = poll(&waited, 1, kTick);
    if (ready > 0) return true;
    if (ready == 0 && !look_after()) return false;
  }
}

void Supervisor::end() {
  {
    const std::lock_guard lock(mutex_);
    if (socket_ >= 0) close(socket_);
    socket_ = -1;
  }
  for (Known* const process : {&guardian_, &supervisor_}) {
    while (!process->has_ended_within(kTick)) look_after();
    // The supervisor is a child of this process if the guardian was killed.
    while (process->number() > 0 && waitpid(process->number(), nullptr, 0) < 0 && errno == EINTR) {
    }
    const std::lock_guard one_at_a_time(ours().mutex);
    ours().processes.erase(process->number());
    *process = Known();
  }
  if (containment_ == Containment::kSupervisor) {
    const std::lock_guard one_at_a_time(ours().mutex);
    kill_children(adopted_programs);
  }
  turn_.give_back();  // The supervisor may have been killed before it did.
}

Ended Supervisor::run(const Request& request, const Limits& limits) {
  stops_ = 0;
  if (socket_ >= 0 && send_message(socket_, message_of(request, limits)) && wait_for_answer()) {
    std::optional<Message> answer = Message::receive(socket_);
    if (answer) return answer->take<Ended>();
  }
  {
    const std::lock_guard lock(mutex_);
    if (is_interrupted_) return {};
  }
  end();
  start();
  return {Ending::kSupervisorKilled, SIGKILL};
}

void Supervisor::interrupt() {
  const std::lock_guard lock(mutex_);
  is_interrupted_ = true;
  shutdown(socket_, SHUT_RDWR);
}

std::string find_program(const std::string& name) {
  namespace fs = std::filesystem;
  const auto runs = [](const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(path, error) && access(path.c_str(), X_OK) == 0;
  };
  if (name.find('/') != std::string::npos) return runs(name) ? fs::absolute(name).string() : "";
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "/usr/bin:/bin" : path);
  for (std::string folder; !name.empty() && std::getline(folders, folder, ':');) {
    const fs::path candidate = fs::path(folder.empty() ? "." : folder) / name;
    if (runs(candidate)) return fs::absolute(candidate).string();
  }
  return "";
}

}  // namespace circumspect::campaign
