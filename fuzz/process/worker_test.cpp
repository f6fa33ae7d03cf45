// Workers: what they answer case after case, and what becomes of one that does not do as it should.
#include "fuzz/process/worker.hpp"

#include <fstream>
#include <sstream>
#include <string>

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
  // yes answers what is no answer, at once.
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

TEST_CASE("time in which no processor is free is not a program's own") {
  // Thirty-one that compute on one processor, of which the first is done after a sixteenth of a second of its own.
  WorkerTrial trial;
  trial.limits.seconds = 1;
  Request request;
  request.folder = trial.folder.path("work");
  request.command = {
      "/bin/sh", "-c",
      "for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30; "
      "do "
      "(while :; do :; done) & done; i=0; while [ $i -lt 50000 ]; do i=$((i+1)); done"};
  const std::string pinned = "/usr/bin/taskset";
  if (find_program(pinned).empty()) return;
  request.command.insert(request.command.begin(), {pinned, "-c", "0"});
  const Ended ended = trial.supervisor.run(request, trial.limits);
  CAPTURE(ended.seconds);
  CHECK(ended.ending == Ending::kExited);
  CHECK(ended.seconds > trial.limits.seconds);
}

}  // namespace
}  // namespace circumspect::campaign
