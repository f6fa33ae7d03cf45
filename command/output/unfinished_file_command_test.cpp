// No file is left half-written, nor under its temporary name: not by a limit on files, not by a
// full disk, not by a signal that ends the command.
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <set>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {
namespace {

// Many more bytes than the limits below, and than a pipe holds.
const std::vector<std::string> kGenerate = {"generate", "uniform", "--points", "4000", "-o"};

// Starts a program without waiting for its end.
pid_t start_program(const std::string& program, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), program);
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  pid_t process = 0;
  if (posix_spawnp(&process, program.c_str(), nullptr, nullptr, argv.data(), environ) != 0) {
    throw std::runtime_error("could not run " + program);
  }
  return process;
}

std::vector<std::string> generate_to(const std::string& path) {
  std::vector<std::string> arguments = kGenerate;
  arguments.push_back(path);
  return arguments;
}

// A command line for a shell, under a limit of a few kilobytes a file.
int exit_code_under_limit(const std::vector<std::string>& arguments, const std::string& err) {
  std::string line = "ulimit -f 8; '" CIRCUMSPECT_COMMAND "'";
  for (const std::string& argument : arguments) line += " '" + argument + "'";
  const int status = std::system((line + " 2> '" + err + "'").c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::set<std::string> files_in(const ScratchFolder& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path(""))) {
    names.insert(entry.path().filename());
  }
  return names;
}

// As a shell runs it; −1 if it did not end by itself.
int exit_code_of(const std::string& arguments) {
  const int status = std::system((CIRCUMSPECT_COMMAND " " + arguments).c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

constexpr const char* kRight = CIRCUMSPECT_CORPUS_DIR "/peers/inputs/flat-faces-3d.node";

TEST_CASE("a limit on the size of files: an error, and no file") {
  const ScratchFolder folder;
  const std::string path = folder.path("x.node");
  CHECK(exit_code_under_limit(generate_to(path), folder.path("err")) == 2);
  CHECK(is_error_line(contents(folder.path("err"))));
  CHECK(has(contents(folder.path("err")), "File too large"));
  CHECK(files_in(folder) == std::set<std::string>{"err"});
  // What was there before is still there.
  folder.write("x.node", "as it was");
  CHECK(exit_code_under_limit(generate_to(path), folder.path("err")) == 2);
  CHECK(contents(path) == "as it was");
  CHECK(files_in(folder) == std::set<std::string>{"err", "x.node"});
}

TEST_CASE("a limit on the size of files: standard output") {
  const ScratchFolder folder;
  const std::string line = "ulimit -f 8; '" CIRCUMSPECT_COMMAND
                           "' generate uniform --points 4000 > '" +
                           folder.path("out") + "' 2> '" + folder.path("err") + "'";
  const int status = std::system(line.c_str());
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) != 0);
  CHECK(is_error_line(contents(folder.path("err"))));
}

TEST_CASE("a signal that ends the command leaves the file that was there, and no other") {
  for (const int number : {SIGINT, SIGTERM, SIGKILL}) {
    for (const int milliseconds : {5, 20, 60, 120}) {
      CAPTURE(number);
      CAPTURE(milliseconds);
      const ScratchFolder folder;
      const std::string path = folder.write("x.node", "as it was");
      const pid_t process = start_program(CIRCUMSPECT_COMMAND,
                                          {"generate", "uniform", "--points", "40000", "-o", path});
      usleep(static_cast<useconds_t>(milliseconds) * 1000);
      kill(process, number);
      REQUIRE(waitpid(process, nullptr, 0) == process);
      CHECK(files_in(folder) == std::set<std::string>{"x.node"});
    }
  }
}

// Without /proc no file can be made that has no name.
TEST_CASE("a signal while compare writes what differs leaves no unfinished file") {
  if (std::system("unshare -rm mount -t tmpfs none /proc 2> /dev/null") != 0) {
    MESSAGE("left out: no namespace of mounts may be made here");
    return;
  }
  const ScratchFolder folder;
  const std::string first = folder.path("a.json"), second = folder.path("b.json");
  const std::string out = folder.path("out.vtu");
  std::string points = "[[0,0]", fan = "[";
  for (int i = 0; i < 20000; ++i) {
    points += fmt::format(",[1,{}]", i);
    if (i > 0) fan += fmt::format("{}[0,{},{}]", i > 1 ? "," : "", i, i + 1);
  }
  folder.write("a.json", "{\"circumspect\":1,\"dimension\":2,\"first_index\":0,\"points\":" +
                             points + "],\"simplices\":" + fan + "]}");
  folder.write("b.json", "{\"circumspect\":1,\"dimension\":2,\"first_index\":0,\"points\":" +
                             points + "],\"simplices\":[]}");
  for (const int number : {SIGINT, SIGTERM}) {
    CAPTURE(number);
    const std::string line = "mount -t tmpfs none /proc; exec '" CIRCUMSPECT_COMMAND "' compare '" +
                             first + "' '" + second + "' --allow-empty -o '" + out +
                             "' > /dev/null";
    const pid_t process = start_program("unshare", {"-rm", "sh", "-c", line});
    bool is_being_written = false;
    for (int status = 0; !is_being_written && waitpid(process, &status, WNOHANG) == 0;
         usleep(200)) {
      for (const std::string& name : files_in(folder)) {
        if (begins_with(name, ".unfinished")) is_being_written = true;
      }
    }
    REQUIRE(is_being_written);
    kill(process, number);
    REQUIRE(waitpid(process, nullptr, 0) == process);
    for (const std::string& name : files_in(folder)) CHECK_FALSE(begins_with(name, ".unfinished"));
  }
}

TEST_CASE("what has the names beside a file is neither followed nor emptied nor waited for") {
  const ScratchFolder folder;
  const std::string precious = folder.write("precious", "precious");
  const std::string path = folder.path("x.node");
  const std::string unfinished = path + ".unfinished";
  REQUIRE(symlink(precious.c_str(), unfinished.c_str()) == 0);
  CHECK(run(generate_to(path)).exit_code == 0);
  CHECK(contents(precious) == "precious");
  REQUIRE(std::filesystem::remove(unfinished));
  REQUIRE(mkfifo(unfinished.c_str(), 0600) == 0);
  CHECK(run(generate_to(path)).exit_code == 0);
  std::filesystem::remove(unfinished);
  folder.write("x.node.unfinished", "mine");
  CHECK(run(generate_to(path)).exit_code == 0);
  CHECK(contents(unfinished) == "mine");
}

TEST_CASE("a place that cannot be written to: the words of the system") {
  const ScratchFolder folder;
  const std::string taken = folder.path("folder.ele");
  REQUIRE(std::filesystem::create_directory(taken));
  CHECK(has(run({"build", "delaunay", kRight, "-o", taken}).err, "Is a directory"));
  CHECK(has(run(generate_to(folder.path("no/x.node"))).err, "No such file or directory"));
  CHECK(has(run(generate_to("/dev/full")).err, "No space left on device"));
  CHECK(run(generate_to("/dev/full")).exit_code == 2);
}

TEST_CASE("whether standard error can be written to changes no exit code") {
  for (const char* const closed : {"2> /dev/full", "2>&-", "2>&- <&-", "2>&- >&-"}) {
    CAPTURE(closed);
    const std::string end = std::string(" > /dev/null ") + closed;
    CHECK(exit_code_of("check /nonexistent.ele" + end) == 3);
    CHECK(exit_code_of("check --nonsense" + end) == 2);
    CHECK(exit_code_of("chek" + end) == 2);
    CHECK(exit_code_of("generate uniform -o /dev/full" + end) == 2);
  }
}

TEST_CASE("unwritable standard output has one answer") {
  const ScratchFolder folder;
  const std::string err = folder.path("err");
  const std::string point = kRight;
  for (const std::string& arguments : std::vector<std::string>{
           "--help", "--version", "check --help", "generate uniform --points 9", "generate --list",
           "build delaunay --format json " + point, "build delaunay " + point + " -o -",
           "inspect " + point,
           "check --points " + point + " " CIRCUMSPECT_CORPUS_DIR "/peers/cgal/flat-faces-3d.ele",
           "check --format json /nonexistent.ele", "inspect --format json /nonexistent.poly"}) {
    for (const char* const closed : {"> /dev/full", ">&-"}) {
      CAPTURE(arguments);
      CAPTURE(closed);
      CHECK(exit_code_of(arguments + " " + closed + " 2> " + err) == 5);
      CHECK(has(contents(err), "circumspect: could not write to standard output: "));
    }
  }
}

TEST_CASE("without threads: the same answer") {
  // Enough rows for several threads, of a user who may have one task. A superuser may have any
  // number.
  const ScratchFolder folder;
  const std::string points = folder.path("x.node");
  const std::string mesh = folder.path("x.ele");
  std::string rows;
  constexpr int kSide = 200;
  for (int i = 0; i < kSide * kSide; ++i) {
    rows += fmt::format("{} {} {}\n", i, i % kSide, i / kSide);
  }
  folder.write("x.node", fmt::format("{} 2 0 0\n", kSide * kSide) + rows);
  rows.clear();
  int triangles = 0;
  for (int i = 0; i < kSide - 1; ++i) {
    for (int j = 0; j < kSide - 1; ++j) {
      const int v = i * kSide + j;
      rows += fmt::format("{} {} {} {}\n", triangles++, v, v + 1, v + kSide);
      rows += fmt::format("{} {} {} {}\n", triangles++, v + 1, v + kSide + 1, v + kSide);
    }
  }
  folder.write("x.ele", fmt::format("{} 3 0\n", triangles) + rows);
  std::filesystem::permissions(folder.path(""), std::filesystem::perms::all);
  const Run many = run({"check", mesh, "--threads", "2"});
  CHECK(many.exit_code == 0);
  const pid_t child = fork();
  if (child == 0) {
    const rlimit one = {1, 1};
    const bool is_ready = (geteuid() != 0 || setresuid(54321, 54321, 54321) == 0) &&
                          setrlimit(RLIMIT_NPROC, &one) == 0 &&
                          dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO) >= 0;
    if (is_ready) execl(CIRCUMSPECT_COMMAND, CIRCUMSPECT_COMMAND, "check", mesh.c_str(), nullptr);
    _exit(77);  // that user may not run it
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  REQUIRE(WIFEXITED(status));
  CHECK((WEXITSTATUS(status) == 0 || WEXITSTATUS(status) == 77));
}

}  // namespace
}  // namespace circumspect::cli
