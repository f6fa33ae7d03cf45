// Programs under limits, and the folders that they run in.
#include "fuzz/process/process.hpp"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>
#include <utility>

#include <doctest/doctest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/utsname.h>
#include <unistd.h>

#include "fuzz/process/apart.hpp"
#include "fuzz/process/folders.hpp"
#include "inputs/scratch_folder_test.hpp"

namespace circumspect::campaign {

// Programs that misbehave in every way: each ends, has its own outcome, and leaves nothing behind.

namespace {

using formats::ScratchFolder;

// Both kinds of containment, if this system supports them.
std::vector<Containment> ways() {
  std::vector<Containment> ways = {Containment::kSupervisor};
  const Supervisor any;
  if (any.containment() == Containment::kNamespaces) ways.push_back(any.containment());
  return ways;
}

struct Trial {
  ScratchFolder folder;
  Limits limits;
  Supervisor supervisor;
  Ended ended;

  explicit Trial(Containment containment = Containment::kSupervisor)
      : supervisor("", {}, containment) {
    limits.seconds = 5;
    limits.output = 1 << 20;
    std::filesystem::create_directory(folder.path("work"));
  }
  const Ended& run(const std::string& script) {
    Request request;
    request.command = {"/bin/sh", "-c", script};
    request.folder = folder.path("work");
    request.stdout_file = folder.path("out");
    request.stderr_file = folder.path("err");
    ended = supervisor.run(request, limits);
    return ended;
  }
  std::string text(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(folder.path(name)).rdbuf();
    return text.str();
  }
  // How many processes are in the folder of the program: processes that a script starts stay there.
  std::size_t left_behind() const {
    std::size_t count = 0;
    std::error_code gone;
    for (const auto& process : std::filesystem::directory_iterator("/proc")) {
      const auto place = std::filesystem::read_symlink(process.path() / "cwd", gone);
      if (!gone && place.string().rfind(folder.path("work"), 0) == 0) ++count;
    }
    return count;
  }
};

TEST_CASE("a program runs in its folder, with its files, and ends as it likes") {
  Trial trial;
  CHECK(trial.run("pwd; cat; echo wrong >&2; exit 3").ending == Ending::kExited);
  CHECK(trial.ended.code == 3);
  CHECK(trial.text("out") == trial.folder.path("work") + "\n");
  CHECK(trial.text("err") == "wrong\n");
  CHECK(trial.run("kill -SEGV $$").ending == Ending::kSignalled);
  CHECK(trial.ended.code == SIGSEGV);
  CHECK(trial.run("true").ending == Ending::kExited);
  CHECK(trial.ended.code == 0);
}

TEST_CASE("what cannot be started is told apart from what fails") {
  Trial trial;
  Request request;
  request.command = {"/nowhere/program"};
  request.folder = trial.folder.path("work");
  const Ended ended = trial.supervisor.run(request, trial.limits);
  CHECK(ended.ending == Ending::kNotStarted);
  CHECK(ended.code == ENOENT);
  CHECK(trial.run("exit 127").ending == Ending::kExited);
}

TEST_CASE("a program that never ends is killed, with its children") {
  Trial trial;
  trial.limits.seconds = 0.2;
  CHECK(trial.run("sleep 1000 & sleep 1000").ending == Ending::kTimeLimit);
  CHECK(trial.ended.seconds >= 0.2);
  CHECK(trial.ended.seconds < 2);
  CHECK(trial.left_behind() == 0);
  CHECK(trial.run("trap '' TERM INT; while :; do :; done").ending == Ending::kTimeLimit);
}

TEST_CASE("what a program leaves running is killed, even in a session of its own") {
  for (const Containment containment : ways()) {
    CAPTURE(name(containment));
    Trial trial(containment);
    CHECK(trial.run("sleep 1000 & exit 4").ending == Ending::kExited);
    CHECK(trial.ended.code == 4);
    CHECK(trial.left_behind() == 0);
    CHECK(trial.run("setsid sh -c 'touch b; exec sleep 1000' & while [ ! -e b ]; do :; done")
              .ending == Ending::kExited);
    CHECK(trial.ended.code == 0);
    CHECK(trial.left_behind() == 0);
  }
}

TEST_CASE("endless output ends: on stdout, in a file, in many files") {
  Trial trial;
  CHECK(trial.run("yes").ending == Ending::kOutputLimit);
  CHECK(std::filesystem::file_size(trial.folder.path("out")) <= trial.limits.output);
  CHECK(trial.run("exec cat /dev/zero > big").ending == Ending::kOutputLimit);
  CHECK(std::filesystem::file_size(trial.folder.path("work/big")) <= trial.limits.output);
  CHECK(trial.run("i=0; while :; do i=$((i+1)); head -c 300000 /dev/zero > many$i; done").ending ==
        Ending::kOutputLimit);
}

TEST_CASE("too many processes are killed, all of them") {
  for (const Containment containment : ways()) {
    Trial trial(containment);
    trial.limits.processes = 20;
    CHECK(trial.run("i=0; while [ $i -lt 40 ]; do i=$((i+1)); sleep 1000 & done; wait").ending ==
          Ending::kProcessLimit);
    CHECK(trial.left_behind() == 0);
    CHECK(trial.run("true").ending == Ending::kExited);
  }
}

TEST_CASE("folders within folders without end, and empty files without end, are too much") {
  Trial trial;
  const auto start = std::chrono::steady_clock::now();
  CHECK(trial.run("while :; do mkdir d; cd d; done").ending == Ending::kOutputLimit);
  CHECK(trial.run("i=0; while :; do i=$((i+1)); : > empty$i; done").ending == Ending::kOutputLimit);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(5));
}

TEST_CASE("what was written in less time than between two looks counts too") {
  Trial trial;
  CHECK(trial.run("for i in 1 2 3; do head -c 500000 /dev/zero > part$i; done").ending ==
        Ending::kOutputLimit);
}

TEST_CASE("processes that were started in less time than between two looks count too") {
  for (const Containment containment : ways()) {
    Trial trial(containment);
    trial.limits.processes = 20;
    CHECK(trial.run("i=0; while [ $i -lt 30 ]; do i=$((i+1)); sleep 1000 & done; exit 2").ending ==
          Ending::kProcessLimit);
    CHECK(trial.left_behind() == 0);
  }
}

using Clock = std::chrono::steady_clock;

TEST_CASE("no signal but SIGKILL ends the processes above a program") {
  Trial trial;
  CHECK(trial
            .run("above=\"$(ps -o ppid= $PPID) $PPID\"; for number in $(seq 64); do\n"
                 "  [ $number = 9 ] || [ $number = 19 ] || kill -$number $above\n"
                 "done; setsid sleep 1000 & exit 3")
            .code == 3);
  CHECK(trial.left_behind() == 0);
}

TEST_CASE("a program that kills the processes above it harms only itself") {
  Trial trial;
  const auto start = Clock::now();
  CHECK(trial.run("setsid sleep 1000 & kill -9 $PPID; sleep 1000").ending ==
        Ending::kSupervisorKilled);
  CHECK(trial.left_behind() == 0);
  CHECK(trial.run("exit 3").code == 3);
  // Both of them are killed, and the processes that are left become children of this one.
  CHECK(trial
            .run("for i in 1 2 3; do setsid sleep 1000 & done; "
                 "kill -9 $(ps -o ppid= $PPID) $PPID; sleep 1000")
            .ending == Ending::kSupervisorKilled);
  CHECK(trial.left_behind() == 0);
  CHECK(trial.run("exit 4").code == 4);
  // The guardian is killed, and programs still run.
  kill(trial.supervisor.guardian(), SIGKILL);
  CHECK(trial.run("exit 5").code == 5);
  CHECK(Clock::now() - start < std::chrono::seconds(5));
}

TEST_CASE("a program that stops the processes above it, once or all the time, holds nothing up") {
  const auto start = Clock::now();
  {
    Trial trial;
    CHECK(trial.run("kill -STOP $PPID; sleep 0.1; exit 3").code == 3);
    CHECK(trial.run("kill -STOP $(ps -o ppid= $PPID); exit 4").code == 4);
    CHECK(trial.run("kill -STOP $(ps -o ppid= $PPID) $PPID; sleep 0.1; exit 5").code == 5);
    CHECK(trial.run("guardian=$(ps -o ppid= $PPID); while :; do kill -STOP $guardian $PPID; done")
              .ending == Ending::kSupervisorKilled);
    CHECK(trial.left_behind() == 0);
    // The destructor does not wait for one that is stopped, either.
    kill(trial.supervisor.supervisor(), SIGSTOP);
    kill(trial.supervisor.guardian(), SIGSTOP);
  }
  CHECK(Clock::now() - start < std::chrono::seconds(10));
}

TEST_CASE("in a process namespace a program sees nobody whom it could stop, kill or trace") {
  if (ways().size() < 2) return;
  Trial trial(Containment::kNamespaces);
  CHECK(trial.run("kill -9 $PPID; kill -STOP $PPID; [ $PPID = 1 ] && exit 3").code == 3);
  CHECK(trial.run("[ $(ls /proc | grep -c '^[0-9]') -lt 9 ]").code == 0);
  // All other processes that it sees, except the first.
  CHECK(trial.run("sleep 1000 & kill -9 -1; wait; exit 4").code == 4);
  CHECK(trial.run("exit 5").code == 5);
}

// Each process of it has a session of its own. It doubles only seven times: if the supervisor has
// to wait on a loaded machine, an endless one may take over the machine.
constexpr const char* kForkBomb =
    "exec python3 -c 'import os, time\n"
    "for _ in range(7):\n"
    "  if os.fork() == 0: os.setsid()\n"
    "time.sleep(1000)'";

TEST_CASE("a fork bomb in a process namespace ends with one kill") {
  if (ways().size() < 2) return;
  Trial trial(Containment::kNamespaces);
  trial.limits.processes = 40;
  const auto start = Clock::now();
  CHECK(trial.run(kForkBomb).ending == Ending::kProcessLimit);
  CHECK(trial.left_behind() == 0);
  CHECK(Clock::now() - start < std::chrono::seconds(20));
  CHECK(trial.run("true").code == 0);
}

// Linux 5.14 counts the tasks of a user in a namespace by themselves, and 6.14 those of a superuser
// too.
bool kernel_counts_tasks() {
  utsname system = {};
  int major = 0, minor = 0;
  if (uname(&system) != 0 || std::sscanf(system.release, "%d.%d", &major, &minor) != 2)
    return false;
  return std::pair(major, minor) >= std::pair(geteuid() == 0 ? 6 : 5, 14);
}

TEST_CASE("in a process namespace the kernel refuses more tasks, however fast they come") {
  if (ways().size() < 2 || !kernel_counts_tasks()) return;
  Trial trial(Containment::kNamespaces);
  trial.limits.processes = 40;
  trial.limits.seconds = 20;
  // Threads are not processes, so only the kernel ends this.
  CHECK(
      trial
          .run("exec python3 -c 'import os, threading\n"
               "threading.stack_size(65536)\n"
               "until = threading.Event()\n"
               "try:\n"
               "  for _ in range(3000): threading.Thread(target=until.wait, daemon=True).start()\n"
               "except RuntimeError: os._exit(7)\n"
               "os._exit(8)'")
          .code == 7);
  // This one never ends, and each process of it has a session of its own, to which the kernel gives
  // as much time as to the supervisor.
  const auto start = Clock::now();
  CHECK(trial
            .run("exec python3 -c 'import os\n"
                 "while True:\n"
                 "  try:\n"
                 "    if os.fork() == 0: os.setsid()\n"
                 "  except OSError: pass'")
            .ending == Ending::kProcessLimit);
  CHECK(Clock::now() - start < std::chrono::seconds(60));
  CHECK(trial.left_behind() == 0);
}

TEST_CASE("a program has no terminal, and signals mean to it what they mean to others") {
  Trial trial;
  CHECK(trial.run("(: < /dev/tty) || exit 6").code == 6);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    CHECK(trial.run("kill -" + std::to_string(number) + " $$; sleep 2").ending ==
          Ending::kSignalled);
    CHECK(trial.ended.code == number);
  }
}

TEST_CASE("a pipe or a link in the place of what a program says leads nowhere") {
  Trial trial;
  trial.folder.write("precious", "precious");
  CHECK(trial.run("cd ..; rm -f out err; mkfifo out; ln -s precious err").ending ==
        Ending::kExited);
  CHECK(trial.run("echo out; echo err >&2").ending == Ending::kExited);
  CHECK(trial.text("out") == "out\n");
  CHECK(trial.text("err") == "err\n");
  CHECK(trial.text("precious") == "precious");
  CHECK(trial.run("cd ..; rm -f out; ln precious out").ending == Ending::kExited);
  CHECK(trial.run("echo out").ending == Ending::kExited);
  CHECK(trial.text("precious") == "precious");
}

TEST_CASE("memory has a limit") {
  Trial trial;
  trial.limits.memory = std::uint64_t{64} << 20;
  trial.limits.output = std::uint64_t{1} << 30;
  CHECK(trial.run("exec head -c 500000000 /dev/zero | tail -n 1 > /dev/null").ending ==
        Ending::kExited);
  CHECK(trial.text("err").find("memory") != std::string::npos);
}

TEST_CASE("an interrupt ends the run at once") {
  for (const Containment containment : ways()) {
    Trial trial(containment);
    std::thread other([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      trial.supervisor.interrupt();
    });
    const auto start = std::chrono::steady_clock::now();
    CHECK(trial.run("exec sleep 1000").ending == Ending::kInterrupted);
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(2));
    CHECK(trial.run("true").ending == Ending::kInterrupted);
    other.join();
  }
}

TEST_CASE("what is computed apart has an end: by the clock, by its memory, by an interrupt") {
  std::atomic<bool> stop = false;
  const auto text = [&](double seconds, const std::function<std::string()>& compute) {
    return computed_apart(compute, seconds, std::uint64_t{1} << 40, stop);
  };
  const Apart done = text(60, [] { return std::string(100'000, 'x'); });
  CHECK(done.end == Apart::End::kDone);
  CHECK(done.text == std::string(100'000, 'x'));
  const auto for_ever = []() -> std::string {
    while (true) pause();
  };
  CHECK(text(0.1, for_ever).end == Apart::End::kTimeLimit);
  CHECK(text(60, []() -> std::string { throw std::bad_alloc(); }).end == Apart::End::kMemoryLimit);
  CHECK_THROWS_AS(text(60,
                       []() -> std::string {
                         raise(SIGSEGV);
                         return "";
                       }),
                  std::runtime_error);
  stop = true;
  CHECK(text(60, for_ever).end == Apart::End::kInterrupted);
}

TEST_CASE("programs are found as a shell finds them") {
  CHECK(find_program("sh").front() == '/');
  CHECK(find_program("/bin/sh") == "/bin/sh");
  CHECK(find_program("no-such-program-anywhere").empty());
  CHECK(find_program("/etc/passwd").empty());
  CHECK(find_program("").empty());
}

// Folders in the state in which programs under test leave them.

namespace fs = std::filesystem;
constexpr std::uint64_t kAny = std::uint64_t{1} << 40;

// Nested folders, made from within: their path is longer than any system call accepts.
void make_nested(const std::string& folder, int depth) {
  const fs::path back = fs::current_path();
  fs::current_path(folder);
  for (int i = 0; i < depth; ++i) {
    REQUIRE(mkdir("nested-folder", 0700) == 0);
    std::ofstream("moved-0") << "a file";
    REQUIRE(chdir("nested-folder") == 0);
  }
  fs::current_path(back);
}

TEST_CASE("bytes of a folder: on disk, of each entry some, of deep ones enough") {
  const formats::ScratchFolder folder;
  CHECK(bytes_in(folder.path(""), kAny) == 0);
  folder.write("empty", "");
  CHECK(bytes_in(folder.path(""), kAny) == kEntryBytes);
  fs::create_directory(folder.path("a"));
  folder.write("a/large", std::string(100'000, 'x'));
  CHECK(bytes_in(folder.path(""), kAny) >= 100'000 + 2 * kEntryBytes);
  CHECK(bytes_in(folder.path(""), kAny) < 150'000);
  fs::create_directory_symlink("/usr", folder.path("link"));
  CHECK(bytes_in(folder.path(""), kAny) < 150'000);
  fs::resize_file(folder.path("empty"), 1 << 30);  // a sparse file
  CHECK(bytes_in(folder.path(""), kAny) < 150'000);
  make_nested(folder.path("a"), kDeepest + 2);
  CHECK(bytes_in(folder.path(""), kAny) == kAny);
  CHECK(bytes_in("/nowhere", kAny) == 0);
}

TEST_CASE("whatever is in a folder is deleted, and nothing outside of it") {
  const formats::ScratchFolder folder;
  fs::create_directories(folder.path("precious"));
  folder.write("precious/file", "precious");
  chmod(folder.path("precious").c_str(), 0750);
  const std::string work = folder.path("work");
  fs::create_directories(work + "/a/b");
  folder.write("work/file", "x");
  fs::create_directory_symlink(folder.path("precious"), work + "/a/link");
  REQUIRE(mkfifo((work + "/pipe").c_str(), 0600) == 0);
  make_nested(work, 1500);
  chmod((work + "/a").c_str(), 0);
  chmod(work.c_str(), 0);
  CHECK(emptied(work));
  CHECK(fs::is_empty(work));
  CHECK(fs::status(work).permissions() == fs::perms::owner_all);
  CHECK(removed(work));
  CHECK(!fs::exists(work));
  CHECK(removed(work));
  fs::create_directory_symlink(folder.path("precious"), work);
  CHECK(!emptied(work));
  CHECK(removed(work));
  CHECK(fs::exists(folder.path("precious/file")));
  struct stat status {};
  CHECK(stat(folder.path("precious").c_str(), &status) == 0);
  CHECK((status.st_mode & 0777U) == 0750U);
}

}  // namespace

}  // namespace circumspect::campaign
