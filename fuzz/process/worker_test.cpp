// Workers: their answers case after case, and the outcome of one that misbehaves.
#include "fuzz/process/worker.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <doctest/doctest.h>

#include "inputs/scratch_folder_test.hpp"

namespace circumspect::campaign {
namespace {

using formats::ScratchFolder;

Answer answer_of(const std::string& text, Talk::Form form = Talk::Form::kSimplices) {
  Answer answer(form, 1000);
  for (const char c : text) answer.add(&c, 1);
  return answer;
}

TEST_CASE("an answer ends where its lines end") {
  CHECK(!answer_of("2\n0 1 2\n").is_complete());
  CHECK(!answer_of("2\n0 1 2\n\n1 2 3").is_complete());
  CHECK(answer_of("2\n0 1 2\n1 2 3").lines() == 1);
  CHECK(answer_of("2\n0 1 2\n1 2 3\n").is_in_step());
  CHECK(answer_of("\n \n0\n \n").is_in_step());
  CHECK(answer_of("error no\n").is_in_step());
  CHECK(!answer_of("error no").is_complete());
  const Answer more = answer_of("1\n0 1 2\nthat was it\n");
  CHECK(more.is_complete());
  CHECK(!more.is_in_step());
}

TEST_CASE("an answer that is an OFF file ends behind its points and faces") {
  CHECK(answer_of("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", Talk::Form::kOff).is_in_step());
  CHECK(answer_of("nOFF 2\n3 1 0\n0 0\n1 0\n0 1\n3 0 1 2\n", Talk::Form::kOff).is_in_step());
  CHECK(answer_of("nOFF\n2\n3 1 0\n0 0\n1 0\n0 1\n", Talk::Form::kOff).expected_lines() == 4);
  CHECK(!answer_of("nOFF\n2\n3 1 0\n0 0\n1 0\n0 1\n", Talk::Form::kOff).is_complete());
  CHECK(answer_of("error no\n", Talk::Form::kOff).is_in_step());
  CHECK(!answer_of("1\n0 1 2\n", Talk::Form::kOff).is_in_step());
}

TEST_CASE("an answer that is a .tet file ends behind its points and tetrahedra") {
  const std::string text = "4 vertices\n1 tets\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n4 0 1 2 3\n";
  CHECK(answer_of(text, Talk::Form::kTet).is_in_step());
  CHECK(!answer_of(text.substr(0, 50), Talk::Form::kTet).is_complete());
  CHECK(answer_of(text.substr(0, 50), Talk::Form::kTet).expected_lines() == 5);
}

TEST_CASE("what can be no answer is not waited for") {
  for (const char* const text : {"Hello\n", "-1\n", "2.5\n", "1e3\n", "100000\n", "1x\n"}) {
    CAPTURE(text);
    CHECK(answer_of(text).is_complete());
    CHECK(!answer_of(text).is_in_step());
  }
}

// A worker that is a shell script; $n is the first word of the case.
struct WorkerTrial {
  ScratchFolder folder;
  Limits limits;
  Supervisor supervisor;
  Talk talk = {Talk::Form::kSimplices, 100};

  explicit WorkerTrial(Containment containment = Containment::kSupervisor)
      : supervisor("", {}, containment) {
    limits.seconds = 5;
    limits.output = 1 << 16;
    std::filesystem::create_directory(folder.path("work"));
  }
  Ended ask(const std::string& script, const std::string& question) {
    Request request;
    request.command = {"/bin/sh", "-c", "while read n rest; do " + script + "; done"};
    request.folder = folder.path("work");
    request.stdin_file = folder.path("in");
    request.stdout_file = folder.path("out");
    request.stderr_file = folder.path("err");
    request.talk = talk;
    folder.write("in", question);
    return supervisor.run(request, limits);
  }
  bool answers(const std::string& script, const std::string& question) {
    const Ended ended = ask(script, question);
    return ended.ending == Ending::kExited && ended.code == 0;
  }
  std::string text(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(folder.path(name)).rdbuf();
    return text.str();
  }
};

TEST_CASE("one process answers case after case, and what it says is kept case by case") {
  std::vector<Containment> ways = {Containment::kSupervisor};
  if (Supervisor().containment() == Containment::kNamespaces) {
    ways.push_back(Containment::kNamespaces);
  }
  for (const Containment containment : ways) {
    WorkerTrial trial(containment);
    trial.talk.cases = 2;
    const std::string script = "echo about $n >&2; echo 1; echo $n $$";
    std::vector<std::string> processes;
    for (const std::string n : {"7", "8", "9"}) {
      REQUIRE(trial.answers(script, n + "\n"));
      CHECK(trial.text("out").rfind("1\n" + n + " ", 0) == 0);
      CHECK(trial.text("err") == "about " + n + "\n");
      processes.push_back(trial.text("out").substr(4));
    }
    CHECK(processes[0] == processes[1]);
    if (containment == Containment::kSupervisor) CHECK(processes[1] != processes[2]);
  }
}

TEST_CASE("a worker that ends or is killed is started anew for the next case") {
  const std::string script =
      "case $n in 1) kill -SEGV $$;; 2) exit 3;; 3) exit 0;; 4) sleep 100;; "
      "5) echo 2; echo 0 1 2; sleep 100;; 6) yes;; 7) cat > /dev/null;; *) echo 0;; esac";
  WorkerTrial trial;
  CHECK(trial.answers(script, "0\n"));
  CHECK(trial.ask(script, "1\n").ending == Ending::kSignalled);
  CHECK(trial.answers(script, "0\n"));
  CHECK(trial.ask(script, "2\n").code == 3);
  CHECK(trial.answers(script, "0\n"));
  CHECK(trial.answers(script, "3\n"));
  CHECK(trial.text("out").empty());
  trial.limits.seconds = 0.2;
  CHECK(trial.ask(script, "4\n").ending == Ending::kTimeLimit);
  CHECK(trial.answers(script, "0\n"));
  const Ended partly = trial.ask(script, "5\n");
  CHECK(partly.ending == Ending::kTimeLimit);
  CHECK(partly.lines == 1);
  CHECK(partly.expected_lines == 2);
  // yes at once writes something that is not an answer.
  CHECK(trial.answers(script, "6\n"));
  CHECK(trial.text("out").rfind("y\ny\n", 0) == 0);
  CHECK(trial.ask(script, "7\n").ending == Ending::kTimeLimit);
  CHECK(trial.answers(script, "0\n"));
}

TEST_CASE("a worker is killed when it writes too much, and nothing is taken for the next answer") {
  WorkerTrial trial;
  const std::string much = "echo 20000; while :; do echo 0 1 2 3 4 5 6 7 8 9; done";
  CHECK(trial.ask(much, "1\n").ending == Ending::kOutputLimit);
  CHECK(trial.text("out").size() <= trial.limits.output);
  const std::string late = "echo 0; sleep 0.1; [ $n = 2 ] && echo and more";
  CHECK(trial.answers(late, "2\n"));
  std::this_thread::sleep_for(std::chrono::milliseconds(400));
  CHECK(trial.ask(late, "3\n").ending == Ending::kOutOfStep);
  CHECK(trial.text("out") == "and more\n");
  CHECK(trial.answers(late, "3\n"));
}

TEST_CASE("a question that is longer than a pipe is read while it is answered") {
  WorkerTrial trial;
  trial.limits.output = 1 << 22;
  std::string question;
  for (int i = 0; i < 30000; ++i) question += "12345678\n";
  const std::string script =
      "echo 60000; i=1; echo $n; while [ $i -lt 30000 ]; do read n; echo $n; echo $n; "
      "i=$((i+1)); done; echo $n";
  REQUIRE(trial.answers(script, question));
  CHECK(trial.text("out").size() == 6 + 2 * question.size());
}

TEST_CASE("a worker is interrupted") {
  WorkerTrial trial;
  std::thread interrupting([&trial] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    trial.supervisor.interrupt();
  });
  CHECK(trial.ask("sleep 100", "1\n").ending == Ending::kInterrupted);
  interrupting.join();
}

// A hang is judged by the time in which a program could run, so that other programs on the
// processors do not cause one.

// How long a program had no processor according to these looks, a tenth of a second apart, on two
// processors.
double stalled(const std::vector<std::map<pid_t, Stalls::Task>>& looks) {
  Stalls stalls;
  std::chrono::milliseconds passed{100};
  for (const auto& tasks : looks) {
    stalls.look(passed, tasks, 2);
    passed += std::chrono::milliseconds(100);
  }
  return stalls.seconds();
}

constexpr std::uint64_t kMs = 1000000;

TEST_CASE(
    "a task that waits for a processor, and another one after it, has no time of its own then") {
  CHECK(stalled({{{1, {0, 0}}}, {{1, {10 * kMs, 90 * kMs}}}}) == doctest::Approx(0.09));
  // One task ends, and the next one waits.
  CHECK(stalled({{{1, {0, 0}}},
                 {{1, {10 * kMs, 90 * kMs}}, {2, {0, 0}}},
                 {{2, {10 * kMs, 90 * kMs}}},
                 {{3, {10 * kMs, 90 * kMs}}}}) == doctest::Approx(0.27));
  // A wait is counted when it has ended.
  CHECK(stalled({{{1, {0, 0}}}, {{1, {0, 0}}}, {{1, {0, 0}}}, {{1, {50 * kMs, 250 * kMs}}}}) ==
        doctest::Approx(0.25));
  // Two run side by side, as long as one of them alone.
  CHECK(stalled({{{1, {0, 0}}, {2, {0, 0}}},
                 {{1, {30 * kMs, 70 * kMs}}, {2, {30 * kMs, 70 * kMs}}}}) == doctest::Approx(0.07));
  // Earlier waits may not have been in this case, and an ID may be another task's.
  CHECK(stalled({{{1, {700 * kMs, 900 * kMs}}}, {{1, {790 * kMs, 900 * kMs}}}}) == 0);
  CHECK(stalled({{{1, {700 * kMs, 900 * kMs}}}, {{1, {20 * kMs, 80 * kMs}}}}) ==
        doctest::Approx(0.08));
}

TEST_CASE("tasks that wait for each other, or sleep, are no excuse") {
  // Eight compute on two processors, which are theirs alone.
  std::map<pid_t, Stalls::Task> before;
  std::map<pid_t, Stalls::Task> after;
  for (pid_t task = 1; task <= 8; ++task) {
    before[task] = {};
    after[task] = {25 * kMs, 75 * kMs};
  }
  CHECK(stalled({before, after}) == 0);
  // They do not excuse later sleep, either.
  CHECK(stalled({before, after, after, after}) == 0);
  CHECK(stalled({{{1, {0, 0}}}, {{1, {0, 0}}}, {{1, {kMs, 0}}}}) == 0);
}

TEST_CASE("time in which no processor is free is not a program's own") {
  const std::string pinned = "/usr/bin/taskset";
  const std::string apart = "/usr/bin/setsid";
  if (find_program(pinned).empty() || find_program(apart).empty()) return;
  const auto on_one_processor = [&pinned](WorkerTrial& trial, const std::string& script) {
    Request request;
    request.folder = trial.folder.path("work");
    request.command = {pinned, "-c", "0", "/bin/sh", "-c", script};
    return trial.supervisor.run(request, trial.limits);
  };
  // Twelve that compute, each in a session of its own: some systems share a processor among
  // sessions.
  WorkerTrial others;
  others.limits.seconds = 100;
  std::thread load([&] {
    on_one_processor(others,
                     "for i in 1 2 3 4 5 6 7 8 9 10 11 12; do setsid sh -c 'while :; do :; done' & "
                     "done; touch begun; wait");
  });
  while (!std::filesystem::exists(others.folder.path("work/begun"))) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  // Three processes one after the other, a fifth of a second together. What each of them waits
  // after the last look at it is not known, a tenth of a second or two on a busy machine: the
  // limit leaves room for it.
  WorkerTrial trial;
  trial.limits.seconds = 1;
  const Ended ended = on_one_processor(
      trial, "for i in 1 2 3; do sh -c 'i=0; while [ $i -lt 50000 ]; do i=$((i+1)); done'; done");
  others.supervisor.interrupt();
  load.join();
  CAPTURE(ended.seconds);
  CHECK(ended.ending == Ending::kExited);
  CHECK(ended.seconds > trial.limits.seconds);
}

}  // namespace
}  // namespace circumspect::campaign
