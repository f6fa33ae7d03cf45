#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include <doctest/doctest.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "fuzz/process/containment.hpp"
#include "fuzz/process/process.hpp"
#include "inputs/scratch_folder_test.hpp"

namespace circumspect::campaign {
namespace {

using formats::ScratchFolder;

struct Lifeline {
  int ends[2] = {-1, -1};
  Lifeline() { REQUIRE(socketpair(AF_UNIX, SOCK_STREAM, 0, ends) == 0); }
  ~Lifeline() {
    close(ends[0]);
    cut();
  }
  void cut() {
    if (ends[1] >= 0) close(ends[1]);
    ends[1] = -1;
  }
};

// Whether a process that this one forks gets a place, while this one waits for it.
bool another_process_takes(const Turn& turn, int lifeline) {
  const pid_t child = fork();
  if (child == 0) _exit(turn.take(lifeline) ? 0 : 1);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST_CASE("a gate has as many places as it says, for all processes together") {
  Gate gate(2);
  const Turn turns[] = {gate.turn(), gate.turn(), gate.turn()};
  Lifeline line;
  CHECK(turns[0].take(line.ends[0]));
  CHECK(another_process_takes(turns[1], line.ends[0]));
  Lifeline cut;
  cut.cut();
  CHECK(!turns[2].take(cut.ends[0]));
  CHECK(!another_process_takes(turns[2], cut.ends[0]));
  // The process that took it is gone; a process that knows this gives it back.
  turns[1].give_back();
  CHECK(turns[2].take(line.ends[0]));
  CHECK(Turn().take(-1));
}

TEST_CASE("who holds no place gives none back") {
  Gate gate(1);
  const Turn holder = gate.turn();
  const Turn other = gate.turn();
  Lifeline cut;
  cut.cut();
  CHECK(holder.take(cut.ends[0]));
  other.give_back();
  CHECK(!other.take(cut.ends[0]));
}

Request script(const ScratchFolder& folder, const std::string& text) {
  Request request;
  request.command = {"/bin/sh", "-c", text};
  request.folder = folder.path("");
  return request;
}

void wait_for(const std::string& file) {
  while (!std::filesystem::exists(file)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

TEST_CASE("a program begins when the one before it has ended, with all that it started") {
  const ScratchFolder folder;
  Gate gate(1);
  Supervisor first("", gate.turn());
  Supervisor second("", gate.turn());
  std::thread thread([&] {
    first.run(
        script(folder,
               "(while :; do touch alive; sleep 0.01; done) & touch began; sleep 1; touch ended"),
        {});
  });
  wait_for(folder.path("began"));
  // A process left behind by the first run would create the file again.
  const Ended ended =
      second.run(script(folder, "[ -e ended ] && rm alive && sleep 0.2 && [ ! -e alive ]"), {});
  thread.join();
  CHECK(ended.code == 0);
  // The time that it waited does not count as its own.
  CHECK(ended.seconds < 0.9);
}

TEST_CASE("who waits for a place can be interrupted") {
  const ScratchFolder folder;
  Gate gate(1);
  Supervisor first("", gate.turn());
  Supervisor second("", gate.turn());
  Ended ended;
  std::thread runs([&] { first.run(script(folder, "touch began; sleep 100"), {}); });
  wait_for(folder.path("began"));
  std::thread waits([&] { ended = second.run(script(folder, "true"), {}); });
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  second.interrupt();
  waits.join();
  CHECK(ended.ending == Ending::kInterrupted);
  first.interrupt();
  runs.join();
}

TEST_CASE(
    "the place of a supervisor that was killed, or of a program that is none, is free again") {
  const ScratchFolder folder;
  Gate gate(1);
  Supervisor first("", gate.turn(), Containment::kSupervisor);
  Supervisor second("", gate.turn());
  const Ended killed = first.run(script(folder, "kill -9 $PPID; sleep 100"), {});
  CHECK(killed.ending == Ending::kSupervisorKilled);
  CHECK(second.run(script(folder, "exit 3"), {}).code == 3);
  Request none = script(folder, "");
  none.command.front() = "/nowhere/program";
  CHECK(first.run(none, {}).ending == Ending::kNotStarted);
  CHECK(second.run(script(folder, "exit 4"), {}).code == 4);
}

}  // namespace
}  // namespace circumspect::campaign
