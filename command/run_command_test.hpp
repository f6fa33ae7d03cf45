// Runs the command for tests, as its users do.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <spawn.h>
#include <sys/wait.h>

#include "inputs/scratch_folder_test.hpp"

namespace circumspect::cli {

using formats::ScratchFolder;

struct Run {
  int exit_code = -1;  // -1: it did not end by itself
  std::string out;
  std::string err;
};

inline std::string contents(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

// A text with one blank between two words: lines of --help end where there is room.
inline std::string unbroken(const std::string& text) {
  std::istringstream words(text);
  std::string joined;
  for (std::string word; words >> word;) joined += (joined.empty() ? "" : " ") + word;
  return joined;
}

// Which files a command that is started has for its standard streams.
class Streams {
 public:
  Streams() { posix_spawn_file_actions_init(&actions_); }
  ~Streams() { posix_spawn_file_actions_destroy(&actions_); }
  Streams(const Streams&) = delete;
  Streams& operator=(const Streams&) = delete;

  void read(int stream, const std::string& path) { open(stream, path, O_RDONLY); }
  void write(int stream, const std::string& path) {
    open(stream, path, O_WRONLY | O_CREAT | O_TRUNC);
  }
  // What the test has open as `file`.
  void copy(int stream, int file) { posix_spawn_file_actions_adddup2(&actions_, file, stream); }
  const posix_spawn_file_actions_t* actions() const { return &actions_; }

 private:
  void open(int stream, const std::string& path, int flags) {
    posix_spawn_file_actions_addopen(&actions_, stream, path.c_str(), flags, 0600);
  }

  posix_spawn_file_actions_t actions_;
};

// Starts circumspect with some arguments.
inline pid_t start(std::vector<std::string> arguments, const Streams& streams) {
  arguments.insert(arguments.begin(), CIRCUMSPECT_COMMAND);
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  pid_t process = 0;
  const int failure =
      posix_spawn(&process, argv.front(), streams.actions(), nullptr, argv.data(), environ);
  if (failure != 0) throw std::runtime_error("could not run " CIRCUMSPECT_COMMAND);
  return process;
}

// Waits for it to end. Returns −1 if it did not end by itself.
inline int exit_code_of(pid_t process) {
  int status = 0;
  waitpid(process, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

// Runs circumspect with some arguments and some text on its standard input.
inline Run run(const std::vector<std::string>& arguments, const std::string& in = "") {
  const ScratchFolder folder;
  Streams streams;
  streams.read(0, folder.write("in", in));
  streams.write(1, folder.path("out"));
  streams.write(2, folder.path("err"));
  const int exit_code = exit_code_of(start(arguments, streams));
  return {exit_code, contents(folder.path("out")), contents(folder.path("err"))};
}

// The standard output as one JSON document; throws if it is anything else.
inline nlohmann::json document(const Run& result) { return nlohmann::json::parse(result.out); }

// What the page in a file is made of, which --html wrote: all of it, and what is shown first.
inline nlohmann::json data_of_page(const std::string& path) {
  const std::string page = contents(path);
  const std::size_t data = page.find("id=\"data\">") + 10;
  return nlohmann::json::parse(page.substr(data, page.find("</script>", data) - data));
}
inline nlohmann::json shown(const std::string& path) { return data_of_page(path)["results"][0]; }

inline bool begins_with(const std::string& text, const std::string& beginning) {
  return text.compare(0, beginning.size(), beginning) == 0;
}

inline bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// Is it one line that says whose error it is?
inline bool is_error_line(const std::string& text) {
  return begins_with(text, "circumspect: ") && text.find('\n') + 1 == text.size();
}

}  // namespace circumspect::cli
