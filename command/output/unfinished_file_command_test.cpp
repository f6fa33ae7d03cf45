// No file is left half-written, nor under its temporary name: not by a limit on files, not by a full
// disk, not by a signal that ends the command.
#include <csignal>
#include <cstdlib>

#include <doctest/doctest.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include "command/run_command.hpp"

namespace circumspect::cli {
namespace {

// Many more bytes than the limits below, and than a pipe holds.
const std::vector<std::string> kGenerate = {"generate", "uniform", "--points", "4000", "-o"};

// Starts the command without waiting for its end.
pid_t start(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), CIRCUMSPECT_COMMAND);
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  pid_t process = 0;
  if (posix_spawn(&process, CIRCUMSPECT_COMMAND, nullptr, nullptr, argv.data(), environ) != 0) {
    throw std::runtime_error("could not run " CIRCUMSPECT_COMMAND);
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

bool is_there(const std::string& path) {
  struct stat ignored {};
  return lstat(path.c_str(), &ignored) == 0;
}

TEST_CASE("a limit on the size of files: an error, and no file") {
  const ScratchFolder folder;
  const std::string path = folder.path("x.node");
  CHECK(exit_code_under_limit(generate_to(path), folder.path("err")) == 2);
  CHECK(is_error_line(contents(folder.path("err"))));
  CHECK(!is_there(path));
  CHECK(!is_there(path + ".unfinished"));
  // What was there before is still there.
  folder.write("x.node", "as it was");
  CHECK(exit_code_under_limit(generate_to(path), folder.path("err")) == 2);
  CHECK(contents(path) == "as it was");
  CHECK(!is_there(path + ".unfinished"));
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

TEST_CASE("a signal that ends the command takes the unfinished file with it") {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    CAPTURE(number);
    const ScratchFolder folder;
    const std::string path = folder.path("x.node");
    const std::string unfinished = path + ".unfinished";
    // A pipe of that name, which nobody empties, makes the command wait in the middle of writing.
    REQUIRE(mkfifo(unfinished.c_str(), 0600) == 0);
    const int reader = open(unfinished.c_str(), O_RDONLY | O_NONBLOCK);
    REQUIRE(reader >= 0);
    const pid_t process = start(generate_to(path));
    pollfd readable{reader, POLLIN, 0};
    REQUIRE(poll(&readable, 1, 60'000) == 1);
    REQUIRE(kill(process, number) == 0);
    int status = 0;
    REQUIRE(waitpid(process, &status, 0) == process);
    close(reader);
    CHECK(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == number);
    CHECK(!is_there(unfinished));
    CHECK(!is_there(path));
  }
}

}  // namespace
}  // namespace circumspect::cli
