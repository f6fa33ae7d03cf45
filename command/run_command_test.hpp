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

// Runs circumspect with some arguments and some text on its standard input.
inline Run run(std::vector<std::string> arguments, const std::string& in = "") {
  const ScratchFolder folder;
  const std::string stdin_file = folder.write("in", in);
  arguments.insert(arguments.begin(), CIRCUMSPECT_COMMAND);
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  const int flags = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&files, 0, stdin_file.c_str(), O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, 1, folder.path("out").c_str(), flags, 0600);
  posix_spawn_file_actions_addopen(&files, 2, folder.path("err").c_str(), flags, 0600);
  pid_t process = 0;
  const int failure =
      posix_spawn(&process, CIRCUMSPECT_COMMAND, &files, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (failure != 0) throw std::runtime_error("could not run " CIRCUMSPECT_COMMAND);
  int status = 0;
  waitpid(process, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(folder.path("out")),
          contents(folder.path("err"))};
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
