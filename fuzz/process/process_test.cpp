// Programs that misbehave in every way: each ends, is told apart, and leaves nothing behind.
#include "fuzz/process/process.hpp"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include <doctest/doctest.h>
#include <signal.h>

#include "inputs/scratch_folder_test.hpp"

namespace circumspect::campaign {
namespace {

using formats::ScratchFolder;

struct Trial {
  ScratchFolder folder;
  Limits limits;
  Supervisor supervisor;
  Ended ended;

  Trial() {
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
  // Is the process whose number a script has written still there?
  bool runs(const std::string& name) const {
    const std::string number = text("work/" + name);
    REQUIRE(!number.empty());
    return kill(static_cast<pid_t>(std::stol(number)), 0) == 0;
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
  CHECK(trial.run("sleep 1000 & echo $! > child; sleep 1000").ending == Ending::kTimeLimit);
  CHECK(trial.ended.seconds >= 0.2);
  CHECK(trial.ended.seconds < 2);
  CHECK(!trial.runs("child"));
  CHECK(trial.run("trap '' TERM INT; while :; do :; done").ending == Ending::kTimeLimit);
}

TEST_CASE("what a program leaves running is killed, even in a session of its own") {
  Trial trial;
  CHECK(trial.run("sleep 1000 & echo $! > a").ending == Ending::kExited);
  CHECK(!trial.runs("a"));
  CHECK(trial
            .run("setsid sh -c 'echo $$ > b; exec sleep 1000' & "
                 "while [ ! -s b ]; do :; done")
            .ending == Ending::kExited);
  CHECK(trial.ended.code == 0);
  CHECK(!trial.runs("b"));
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
  Trial trial;
  trial.limits.processes = 20;
  CHECK(trial.run("i=0; while [ $i -lt 40 ]; do i=$((i+1)); sleep 1000 & done; wait").ending ==
        Ending::kProcessLimit);
  CHECK(trial.run("true").ending == Ending::kExited);
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

TEST_CASE("a program that kills or stops the process that started it harms only itself") {
  Trial trial;
  const auto start = std::chrono::steady_clock::now();
  CHECK(trial.run("setsid sleep 1000 & echo $! > a; kill -9 $PPID; sleep 1000").ending ==
        Ending::kSupervisorKilled);
  CHECK(!trial.runs("a"));
  CHECK(trial.run("kill -STOP $PPID; sleep 0.1; exit 3").ending == Ending::kExited);
  CHECK(trial.ended.code == 3);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(4));
  // Somebody kills the guardian: programs run all the same.
  kill(trial.supervisor.guardian(), SIGKILL);
  CHECK(trial.run("exit 4").code == 4);
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
  Trial trial;
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

TEST_CASE("programs are found as a shell finds them") {
  CHECK(find_program("sh").front() == '/');
  CHECK(find_program("/bin/sh") == "/bin/sh");
  CHECK(find_program("no-such-program-anywhere").empty());
  CHECK(find_program("/etc/passwd").empty());
  CHECK(find_program("").empty());
}

}  // namespace
}  // namespace circumspect::campaign
